// Evaluates expressions to functions of time, to formulas, and to formulas with derivatives by a velocity or by the
// time.
#include "problem/language/evaluate_templates.h"
#include "problem/language/scalar_value.h"

namespace poinsot::problem {

template class Evaluator<Dual<1, Dual<1>>>;
template class Scope<Dual<1, Dual<1>>>;
template Value<Dual<1, Dual<1>>> evaluate(const Expression&, Scope<Dual<1, Dual<1>>>&, const std::string&);
template class Evaluator<Dual<1, Dual<1, Dual<1>>>>;
template class Scope<Dual<1, Dual<1, Dual<1>>>>;
template Value<Dual<1, Dual<1, Dual<1>>>> evaluate(const Expression&, Scope<Dual<1, Dual<1, Dual<1>>>>&,
                                                   const std::string&);

template class Evaluator<Formula>;
template class Scope<Formula>;
template Value<Formula> evaluate(const Expression&, Scope<Formula>&, const std::string&);
template class Evaluator<Dual<1, Formula>>;
template class Scope<Dual<1, Formula>>;
template Value<Dual<1, Formula>> evaluate(const Expression&, Scope<Dual<1, Formula>>&, const std::string&);
template class Evaluator<TimeJetOf<Formula>>;
template class Scope<TimeJetOf<Formula>>;
template Value<TimeJetOf<Formula>> evaluate(const Expression&, Scope<TimeJetOf<Formula>>&, const std::string&);

}  // namespace poinsot::problem
