// The same problem in another world: every literal with a unit in the text of a problem file, times powers of the
// scales of length, mass and time that its dimension asks for.
#pragma once

#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>
#include <string>

#include "problem/language/units.h"

namespace poinsot::problem::testing {

struct WorldScale {
  double length = 1, mass = 1, time = 1;

  double of(const Dimension& d) const {
    return std::pow(length, d.length / 12.0) * std::pow(mass, d.mass / 12.0) * std::pow(time, d.time / 12.0);
  }
};

inline std::string in_digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// A line of the file without its comment.
inline std::string scaled_line(const std::string& line, const WorldScale& scale) {
  static const std::regex literal(
      R"((^|[^\w.])(\d+\.?\d*(?:[eE][+-]?\d+)?)(/\d+(?:\.\d+)?)? ([A-Za-z%1][\w%^/*]*(?:\(-?\d+/\d+\)[\w%^/*]*)*))");
  std::string all;
  auto from = line.cbegin();
  for (std::sregex_iterator at(line.begin(), line.end(), literal), end; at != end; ++at) {
    const std::smatch& match = *at;
    all.append(from, line.cbegin() + match.position());
    from = line.cbegin() + match.position() + match.length();
    double factor = 1;
    try {
      factor = scale.of(parse_unit(match[4].str()).dimension);
    } catch (const UnitError&) {
      // A number and a word: `0 along x`.
    }
    all += factor == 1
               ? match.str()
               : match[1].str() + in_digits(std::stod(match[2].str()) * factor) + match[3].str() + " " + match[4].str();
  }
  return all.append(from, line.cend());
}

// The text with all its data scaled; g, which is data as well, is stated if it was not.
inline std::string scaled_text(const std::string& text, const WorldScale& scale) {
  std::istringstream lines(text);
  std::string all, line;
  while (std::getline(lines, line)) {
    const std::size_t comment = line.find(" #");
    all += (line.starts_with("title:") ? line : scaled_line(line.substr(0, comment), scale)) + "\n";
  }
  static const std::regex own_g(R"((^|[{,\s])g: )");
  if (std::regex_search(all, own_g)) return all;
  const std::string g = "g: " + in_digits(9.80665 * scale.of(dimensions::acceleration)) + " m/s^2";
  static const std::regex on_a_line(R"(\ngiven: *\{)"), as_a_list(R"(\ngiven: *\n)");
  if (std::regex_search(all, on_a_line)) return std::regex_replace(all, on_a_line, "\ngiven: {" + g + ", ");
  if (std::regex_search(all, as_a_list)) return std::regex_replace(all, as_a_list, "\ngiven:\n  " + g + "\n");
  return all + "given: {" + g + "}\n";
}

}  // namespace poinsot::problem::testing
