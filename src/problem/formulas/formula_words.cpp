#include "problem/formulas/formula_words.h"

#include "poinsot/engine/math/formula/formula_constant.h"
#include "problem/language/unit_table.h"
#include "problem/language/words.h"

namespace poinsot::problem {

std::string formula_words(const Formula& x) { return text_with_constant(x, standard_gravity_digits); }

std::string values_in_words(const std::vector<Letter>& letters, const LetterValues& values) {
  std::string all;
  for (const Letter& letter : letters)
    all += (all.empty() ? "" : ", ") + letter.name + " = " +
           with_digits(values.at(letter.name) / letter.unit.factor, 3) +
           (letter.unit.text.empty() ? "" : " " + letter.unit.text);
  return all;
}

}  // namespace poinsot::problem
