// Any text as an expression: what is read is written back to the same tree and evaluates to a value or a
// StatementError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "problem/language/evaluate.h"

using namespace poinsot::problem;

namespace {

// Names are quantities of several kinds by their first letter; calls are unknown.
class FuzzScope : public Scope<double> {
 public:
  Value<double> name(const Name& name, const Mark&, const Evaluator<double>&) override {
    switch (name.name[0]) {
      case 'v':
        return Value<double>::of_vector({1, -2, 0.5}, dimensions::length);
      case 'w':
        return Value<double>::of_number(0.7, dimensions::angular_velocity);
      case 'z':
        return Value<double>::of_number(0, dimensions::none, true);
      case 'l':
        return Value<double>::of_list({Value<double>::any(), Value<double>::of_truth(true)});
      default:
        return Value<double>::of_number(-3, dimensions::force);
    }
  }
  Value<double> call(const Call& call, const Mark& mark, const Evaluator<double>& evaluator) override {
    evaluator.unknown_call(call, mark, {"velocity", "angular_momentum"});
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string file = "fuzz";
  Expression expression;
  try {
    expression = parse_expression(text, file);
  } catch (const StatementError& error) {
    if (error.diagnostics()[0].message.empty() || error.diagnostics()[0].mark.line < 1) std::abort();
    return 0;
  }
  const std::string written = to_string(expression);
  const Expression again = written.size() > TreeLimits::scalar_bytes ? expression : parse_expression(written, file);
  if (!same_tree(expression, again)) std::abort();
  UnitHabits habits;
  habits.note(expression);
  try {
    FuzzScope scope;
    const Value<double> value = evaluate<double>(expression, scope, file);
    if (value.is_number() && !std::isfinite(value.number)) std::abort();
    if (!reasonable(value.dimension)) std::abort();
    const Unit unit = habits.unit_for(value.dimension);
    if (!std::isfinite(unit.factor) || unit.factor <= 0) std::abort();
  } catch (const StatementError&) {
  }
  return 0;
}
