// The values of a statement's data: given numbers, letters, points and directions, all as drawn.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/vector3.h"
#include "problem/entries/statement.h"
#include "problem/language/evaluate.h"
#include "problem/language/time_jet.h"

namespace poinsot::problem {

// Values that come from outside the file, by name, in SI.
using Settings = std::map<std::string, Value<double>>;

// Standard gravity, m/s^2.
inline constexpr double standard_gravity = 9.80665;

// The value of `--set NAME=VALUE` or of an `expect` block. Throws StatementError (file "--set NAME") if the value is no
// number, or if its dimension is not that of the letter or datum; unknown names are the caller's to find.
Value<double> read_setting(const Situation& situation, const std::string& name, const std::string& text);

// What stands behind `--set NAME=`; blanks before units may be missing there.
Expression setting_expression(const std::string& name, const std::string& text);

// Names that `--set` can reach: data and letters.
std::vector<std::string> settable_names(const Situation& situation);

// Scalar: double, Dual<1>, or a TimeJetOf one of these.
template <class Scalar>
class DataScope : public Scope<Scalar> {
 public:
  // problem and settings must outlive the scope. Every letter must have a value in settings when it is used.
  DataScope(const Situation& situation, const Settings& settings, Scalar time = Scalar(0));

  // Another time; what does not follow it keeps its value.
  void set_time(Scalar time);
  // Whether anything evaluated since the time was set follows it.
  bool follows_time() const { return follows_time_; }

  // Gives a datum, letter, unknown or choice a value that varies, in place of that in settings; before anything is
  // evaluated.
  void vary(const std::string& name, Value<Scalar> value) { varied_[name] = std::move(value); }
  // Gives what varies in a scope over another scalar the same values here, as constants.
  template <class Other>
  void vary_as(const DataScope<Other>& other) {
    for (const auto& [name, value] : other.varied()) varied_[name] = lifted<Scalar>(value);
  }
  const std::map<std::string, Value<Scalar>>& varied() const { return varied_; }

  Value<Scalar> name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) override;

  // Whether the name is a datum, letter, point, direction, axis or word with a value.
  bool knows(const std::string& name) const;

  Scalar number(const Expression& expression, const Dimension& dimension);
  // A place: a vector of lengths from the ground's origin, m.
  Vector3<Scalar> place(const Expression& expression);
  // A direction: any vector but zero, returned with length one.
  Vector3<Scalar> direction(const Expression& expression);
  Vector3<Scalar> vector(const Expression& expression, const Dimension& dimension);

  // The file's g, else standard gravity.
  Scalar gravity_size();
  const Situation& situation() const { return situation_; }
  const Settings& settings() const { return settings_; }
  Value<Scalar> value(const Expression& expression);

 private:
  // An item of what the problem names by `what`, while it is evaluated.
  struct Pending {
    const char* what;
    const NamedExpression* item;
  };
  Value<Scalar> lookup(const NamedExpression& item, const char* what);
  Value<Scalar> meaning(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator);

  const Situation& situation_;
  const Settings& settings_;
  Scalar time_;
  bool follows_time_ = false;
  std::map<std::string, Value<Scalar>> varied_;
  std::map<const NamedExpression*, Value<Scalar>> found_;  // of items of the problem
  std::map<std::string, Value<Scalar>> meanings_;          // of names but `time` and directions
  std::vector<Pending> pending_;
};

// A number, or one component of a vector, as the variable of differentiation.
Value<Dual<1>> as_variable(const Value<double>& value, std::size_t component = 0);

// Whether the value of an expression follows `time`, through data as well.
bool depends_on_time(const Situation& situation, const Expression& expression);

// The letters on which an expression depends, through data and points as well.
std::set<std::string> letters_of(const Situation& situation, const Expression& expression);

// The names used in an expression; those before an @ only if `into_at`.
void collect_names(const Expression& expression, std::set<std::string>& names, bool into_at = true);

// The functions called in an expression.
void collect_functions(const Expression& expression, std::set<std::string>& functions, bool into_at = true);

extern template class DataScope<double>;
extern template class DataScope<Dual<1>>;
extern template class DataScope<TimeJet>;
extern template class DataScope<TimeJetOf<Dual<1>>>;

}  // namespace poinsot::problem
