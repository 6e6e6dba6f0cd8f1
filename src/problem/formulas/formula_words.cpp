#include "problem/formulas/formula_words.h"

#include <cctype>

#include "poinsot/engine/math/formula/formula_constant.h"
#include "problem/language/unit_table.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// (p)*(sqrt((p)^2)/(p)), as a factor with its sign is written, becomes sqrt((p)^2).
std::string with_sizes(std::string text) {
  const std::string begin = "*(sqrt((";
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t open = at + begin.size() - 1;
    std::size_t close = open;
    for (int depth = 0; close < text.size(); ++close) {
      depth += text[close] == '(' ? 1 : text[close] == ')' ? -1 : 0;
      if (depth == 0) break;
    }
    if (close == text.size()) return text;
    const std::string factor = text.substr(open, close + 1 - open), rest = "^2)/" + factor + ")";
    if (text.compare(close + 1, rest.size(), rest) != 0 || at < factor.size() ||
        text.compare(at - factor.size(), factor.size(), factor) != 0)
      continue;
    // What stands in brackets may be the argument of a function.
    if (at > factor.size() && std::isalnum(static_cast<unsigned char>(text[at - factor.size() - 1]))) continue;
    text.replace(at - factor.size(), close + 1 + rest.size() - (at - factor.size()), "sqrt(" + factor + "^2)");
    at = 0;
  }
  return text;
}

}  // namespace

std::string formula_words(const Formula& x) { return with_sizes(text_with_constant(x, standard_gravity_digits)); }

std::string values_in_words(const std::vector<Letter>& letters, const LetterValues& values) {
  std::string all;
  for (const Letter& letter : letters)
    all += (all.empty() ? "" : ", ") + letter.name + " = " +
           with_digits(values.at(letter.name) / letter.unit.factor, 3) +
           (letter.unit.text.empty() ? "" : " " + letter.unit.text);
  return all;
}

}  // namespace poinsot::problem
