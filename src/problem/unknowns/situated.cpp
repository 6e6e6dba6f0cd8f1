#include "problem/unknowns/situated.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {
namespace {

// Removes `@ situation` from an expression and records the situations named there.
class SituationsTakenOff {
 public:
  explicit SituationsTakenOff(const Statement& statement) : statement_(statement) {}

  Expression operator()(const Expression& expression) {
    if (const At* at = expression.as<At>())
      if (const std::optional<std::size_t> situation = named(at->instant)) {
        if (found_ && *found_ != *situation)
          fail(statement_.file, at->instant_mark,
               "'@ " + at->instant + "' is another situation than '@ " + statement_.situations[*found_].name +
                   "': times are asked of the motion of one",
               "ask for each by itself");
        found_ = situation;
        return (*this)(at->expression);
      }
    return transformed(expression, [this](const Expression& part) { return (*this)(part); });
  }
  const std::optional<std::size_t>& found() const { return found_; }

 private:
  std::optional<std::size_t> named(const std::string& name) const {
    for (std::size_t i = 0; i < statement_.situations.size(); ++i)
      if (statement_.situations[i].name == name) return i;
    return std::nullopt;
  }

  const Statement& statement_;
  std::optional<std::size_t> found_;
};

}  // namespace

Situated situated(const Statement& statement, const Expression& expression) {
  if (statement.situations.size() == 1) return {0, expression};
  SituationsTakenOff taken_off(statement);
  Situated result{0, taken_off(expression)};
  if (taken_off.found() && !asks_model(statement.situations.front(), expression, false)) {
    result.situation = *taken_off.found();
    return result;
  }
  std::string names;
  for (const Situation& situation : statement.situations) names += (names.empty() ? "" : ", ") + situation.name;
  const std::string& one = statement.situations[taken_off.found().value_or(0)].name;
  fail(statement.file, beginning(expression), "in which situation is '" + to_string(expression) + "' asked?",
       "write @ " + one + " behind each quantity, as in theta @ " + one + " (the situations are " + names + ")");
}

}  // namespace poinsot::problem
