// Formulas at random, and numbers of fifty digits to hold them against.
#pragma once

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <map>
#include <random>
#include <string>

#include "engine/math/formula/formula_reader.h"

namespace poinsot::testing {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

inline Digits50 read_digits(const std::string& text, const LetterValues& values) {
  return FormulaReader<Digits50>(
             text,
             [&values](const std::string& name) {
               return name == "pi" ? Digits50(boost::math::constants::pi<Digits50>()) : Digits50(values.at(name));
             },
             [](const std::string& digits) { return Digits50(digits); })
      .read();
}

// Letters: m, r, L positive, x, a, b of any sign, a and b angles.
inline const std::vector<std::string> letters_of_any_sign{"a", "b", "x"};

class RandomFormula {
 public:
  explicit RandomFormula(std::uint64_t seed) : engine_(seed) {}

  int choice(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

  // Positive: made so that it is positive wherever m, r and L are.
  std::string positive(int depth) {
    static const std::vector<std::string> leaves{"m", "r", "L", "2", "3/2", "pi", "7", "6"};
    if (depth <= 0) return leaves[static_cast<std::size_t>(choice(static_cast<int>(leaves.size())))];
    switch (choice(6)) {
      case 0:
        return "(" + positive(depth - 1) + " + " + positive(depth - 1) + ")";
      case 1:
        return positive(depth - 1) + "*" + positive(depth - 1);
      case 2:
        return "(" + positive(depth - 1) + ")/(" + positive(depth - 1) + ")";
      case 3:
        return "sqrt(" + positive(depth - 1) + ")";
      case 4:
        return "(" + any(depth - 1) + ")^2";
      default:
        return positive(depth - 1);
    }
  }
  std::string angle() {
    static const std::vector<std::string> angles{"a",       "b",        "2*a", "a/2",     "a + b",
                                                 "a - 2*b", "a + pi/3", "b/3", "pi/4 - b"};
    return angles[static_cast<std::size_t>(choice(static_cast<int>(angles.size())))];
  }
  std::string any(int depth) {
    if (depth <= 0) return choice(2) == 0 ? "x" : positive(0);
    switch (choice(7)) {
      case 0:
        return "(" + any(depth - 1) + " + " + any(depth - 1) + ")";
      case 1:
        return "(" + any(depth - 1) + " - " + any(depth - 1) + ")";
      case 2:
        return any(depth - 1) + "*" + any(depth - 1);
      case 3:
        return "(" + any(depth - 1) + ")/(1 + " + positive(depth - 1) + ")";
      case 4:
        return "sin(" + angle() + ")";
      case 5:
        return "cos(" + angle() + ")";
      default:
        return positive(depth - 1);
    }
  }
  LetterValues values() {
    LetterValues values;
    for (const char* name : {"m", "r", "L"}) values[name] = 0.25 + choice(1 << 20) * 0x1p-19;
    for (const char* name : {"a", "b", "x"}) values[name] = -2 + choice(1 << 20) * 0x1p-18;
    return values;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace poinsot::testing
