#include "problem/formulas/formula_words.h"

#include "poinsot/engine/math/formula/formula_constant.h"
#include "problem/language/unit_table.h"

namespace poinsot::problem {

std::string formula_words(const Formula& x) { return text_with_constant(x, standard_gravity_digits); }

}  // namespace poinsot::problem
