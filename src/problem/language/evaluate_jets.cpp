// Evaluates expressions to functions of time with their derivatives, and those with a further derivative by a
// variable.
#include "problem/language/evaluate_templates.h"

namespace poinsot::problem {

template class Evaluator<Dual<1, Dual<1>>>;
template class Scope<Dual<1, Dual<1>>>;
template Value<Dual<1, Dual<1>>> evaluate(const Expression&, Scope<Dual<1, Dual<1>>>&, const std::string&);
template class Evaluator<Dual<1, Dual<1, Dual<1>>>>;
template class Scope<Dual<1, Dual<1, Dual<1>>>>;
template Value<Dual<1, Dual<1, Dual<1>>>> evaluate(const Expression&, Scope<Dual<1, Dual<1, Dual<1>>>>&,
                                                   const std::string&);

}  // namespace poinsot::problem
