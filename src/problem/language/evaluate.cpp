#include "problem/language/evaluate.h"

#include <fmt/format.h>

#include "problem/habits/customary_words.h"
#include "problem/language/evaluate_templates.h"

namespace poinsot::problem {

std::string number_text(double x) { return fmt::format("{:.6g}", x); }

Dimension joined_dimension(const Dimension& a, const Dimension& b) {
  constexpr int whole = 12;
  if (a.length == 0 && a.mass == 0 && (a.angle == whole || b.angle == whole)) return a.angle == whole ? a : b;
  return std::abs(a.angle) < std::abs(b.angle) ? a : b;
}

const std::vector<FunctionForm>& mathematical_functions() {
  static const std::vector<FunctionForm> forms{
      {"sqrt", "sqrt(x)"},
      {"abs", "abs(x)"},
      {"sin", "sin(theta)"},
      {"cos", "cos(theta)"},
      {"tan", "tan(theta)"},
      {"asin", "asin(x)"},
      {"acos", "acos(x)"},
      {"atan", "atan(x)"},
      {"exp", "exp(x)"},
      {"ln", "ln(x)"},
      {"atan2", "atan2(y to x)"},
      {"min", "min(x) for the smallest over the motion, min(a with b) or min([a, b, c])"},
      {"max", "max(x) for the largest over the motion, max(a with b) or max([a, b, c])"},
      {"norm", "norm(v)"},
      {"unit", "unit(v)"},
      {"direction", "direction(v)"},
      {"dot", "dot(u with v)"},
      {"cross", "cross(u with v)"},
      {"component", "component(v along u)"},
      {"angle", "angle(u to v)"},
      {"acute_angle", "acute_angle(u to v)"},
  };
  return forms;
}

namespace {

// What is written in place of a call, with what it is of: frequencies(lower) where the example has a plate.
std::string with_own_argument(const std::string& example, const Call& call) {
  const std::size_t open = example.find('(');
  const bool simple = call.arguments.size() == 1 && example.find_first_of("( ", open + 1) == std::string::npos;
  if (!simple) return example;
  return example.substr(0, open + 1) + to_string(call.arguments.front().value) + example.substr(example.find(')'));
}

}  // namespace

UnknownCall describe_unknown_call(const Call& call, const std::vector<std::string>& others) {
  std::vector<std::string> names;
  for (const FunctionForm& known : mathematical_functions()) {
    if (known.name == call.function) return {"'" + call.function + "' is not called like this", "write " + known.form};
    names.push_back(known.name);
  }
  names.insert(names.end(), others.begin(), others.end());
  const std::string custom = customary_call(call.function, names);
  return {"there is no function '" + call.function + "'",
          custom.empty() ? did_you_mean(call.function, names) : "write " + with_own_argument(custom, call)};
}

template class Evaluator<double>;
template class Scope<double>;
template Value<double> evaluate(const Expression&, Scope<double>&, const std::string&);
template class Evaluator<Dual<1>>;
template class Scope<Dual<1>>;
template Value<Dual<1>> evaluate(const Expression&, Scope<Dual<1>>&, const std::string&);

}  // namespace poinsot::problem
