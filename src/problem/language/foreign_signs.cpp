#include "problem/language/foreign_signs.h"

#include <array>

#include "problem/language/utf8.h"

namespace poinsot::problem {
namespace {

struct Sign {
  std::string_view sign;
  std::string_view name;  // if this is empty, the sign itself is quoted
  std::string_view hint;
};

constexpr std::string_view greek_letter = "a Greek letter";

constexpr std::array signs{
    Sign{"**", "", "write a power as x^2"},
    Sign{"=>", "", "write >= or ->"},
    Sign{"=<", "", "write <="},
    Sign{"!=", "", "there is no 'unequal'; say what it is with <, <=, >, >= or =="},
    Sign{"=", "", "write == for a condition"},
    Sign{"...", "", "a range is written with two points, 0 s .. 2 s by 0.1 s"},
    Sign{"\"", "", "an expression has no quotes; inches are written in, a second derivative with two primes, turn''"},
    Sign{"'", "", "a prime stands right after a name, turn'; to derive anything else give it a name under 'define:'"},
    Sign{"{", "", "use parentheses"},
    Sign{"|", "", "the size of a vector is written norm(v), that of a number abs(x)"},
    Sign{"}", "", "use parentheses"},
    Sign{"%", "", "percent stands after a number and a blank, 5 %"},
    Sign{"\xe2\x88\x92", "a typographic minus", "write -"},
    Sign{"\xe2\x80\x90", "a typographic hyphen", "write -"},
    Sign{"\xe2\x80\x91", "a typographic hyphen", "write -"},
    Sign{"\xe2\x80\x93", "a dash", "write -"},
    Sign{"\xe2\x80\x94", "a dash", "write -"},
    Sign{"\xc2\xb7", "a raised dot", "write * to multiply, dot(a with b) for vectors"},
    Sign{"\xe2\x8b\x85", "a raised dot", "write * to multiply, dot(a with b) for vectors"},
    Sign{"\xe2\x88\x99", "a raised dot", "write * to multiply, dot(a with b) for vectors"},
    Sign{"\xc3\x97", "a multiplication cross", "write * to multiply, cross(a with b) for vectors"},
    Sign{"\xc3\xb7", "a division sign", "write /"},
    Sign{"\xc2\xb0", "a degree sign", "write deg after a number and a blank, 25 deg"},
    Sign{"\xc2\xb2", "a raised digit", "write a power as x^2"},
    Sign{"\xc2\xb3", "a raised digit", "write a power as x^3"},
    Sign{"\xc2\xbd", "a fraction in one sign", "write 1/2"},
    Sign{"\xc2\xbc", "a fraction in one sign", "write 1/4"},
    Sign{"\xc2\xbe", "a fraction in one sign", "write 3/4"},
    Sign{"\xe2\x88\x9a", "a root sign", "write sqrt(...)"},
    Sign{"\xe2\x89\xa4", "a typographic comparison", "write <="},
    Sign{"\xe2\x89\xa5", "a typographic comparison", "write >="},
    Sign{"\xe2\x89\xa0", "a typographic comparison", "there is no 'unequal'; say what it is with <, <=, >, >= or =="},
    Sign{"\xe2\x86\x92", "a typographic arrow", "write A->B"},
    Sign{"\xe2\x80\x98", "a typographic quote", "a prime is written '"},
    Sign{"\xe2\x80\x99", "a typographic quote", "a prime is written '"},
    Sign{"\xe2\x80\xb2", "a typographic prime", "write '"},
    Sign{"\xe2\x80\xb3", "a typographic prime", "write ''"},
    Sign{"\xc2\xa0", "a non-breaking blank", "write an ordinary blank"},
    Sign{"\xe2\x80\x89", "a thin blank", "write an ordinary blank"},
    Sign{"\xe2\x80\xaf", "a narrow blank", "write an ordinary blank"},
    Sign{"\xc2\xb5", greek_letter, "names have plain letters: write mu; the micrometre is um"},
};

// The letters from U+03B1 alpha to U+03C9 omega, in their order.
constexpr std::array greek{"alpha", "beta",   "gamma",   "delta", "epsilon", "zeta",    "eta",  "theta", "iota",
                           "kappa", "lambda", "mu",      "nu",    "xi",      "omicron", "pi",   "rho",   "sigma",
                           "sigma", "tau",    "upsilon", "phi",   "chi",     "psi",     "omega"};

}  // namespace

ForeignSign foreign_sign_of_expression(std::string_view text) {
  for (const Sign& sign : signs) {
    if (text.substr(0, sign.sign.size()) != sign.sign) continue;
    const std::string name = sign.name.empty() ? "'" + std::string(sign.sign) + "'" : std::string(sign.name);
    return {name + " is no sign of the language", std::string(sign.hint), sign.name == greek_letter};
  }
  const std::optional<Character> character = character_at(text, 0);
  if (!character) return {};
  const char32_t small =
      character->code >= 0x391 && character->code <= 0x3a9 ? character->code + 0x20 : character->code;
  if (small >= 0x3b1 && small <= 0x3c9) {
    std::string name = greek[small - 0x3b1];
    if (small != character->code) name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return {std::string(greek_letter) + " is no sign of the language", "names have plain letters: write " + name, true};
  }
  return {};
}

}  // namespace poinsot::problem
