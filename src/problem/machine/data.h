// The values of a situation's data: given numbers, letters, points and directions, all as drawn.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/vector3.h"
#include "problem/entries/statement.h"
#include "problem/language/evaluate.h"
#include "problem/language/scalar_value.h"

namespace poinsot::problem {

// Values from outside the file by name, in SI units.
using Settings = std::map<std::string, Value<double>>;

// Standard gravity, m/s^2.
inline constexpr double standard_gravity = 9.80665;

// Reads the value of `--set NAME=VALUE` or of an `expect` block. Throws StatementError (for the file "--set NAME") if
// it is no number or has not the dimension of the letter or datum. The caller checks that the name exists.
Value<double> read_setting(const Situation& situation, const std::string& name, const std::string& text);

// The expression after `--set NAME=`, in which blanks before units may be missing.
Expression setting_expression(const std::string& name, const std::string& text);

// The names that `--set` accepts: data and letters.
std::vector<std::string> settable_names(const Situation& situation);

// The scalar is double, Dual<1>, Formula, or a TimeJetOf one of these.
template <class Scalar>
class DataScope : public Scope<Scalar> {
 public:
  // Situation and settings must outlive the scope. A letter must have a value in the settings when it is used.
  DataScope(const Situation& situation, const Settings& settings, Scalar time = Scalar(0));

  // Moves to another time. Values that do not depend on the time are kept.
  void set_time(Scalar time);
  // Whether any value used since the time was set depends on the time.
  bool follows_time() const { return follows_time_; }

  // Gives a datum, letter, unknown or choice a varying value that replaces the one in the settings. This must be done
  // before anything is evaluated.
  void vary(const std::string& name, Value<Scalar> value) { varied_[name] = std::move(value); }
  // Takes over the varying values of a scope with another scalar, as constants.
  template <class Other>
  void vary_as(const DataScope<Other>& other) {
    for (const auto& [name, value] : other.varied()) varied_[name] = lifted<Scalar>(value);
  }
  const std::map<std::string, Value<Scalar>>& varied() const { return varied_; }

  Value<Scalar> name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) override;

  // Whether the name has a value: as a datum, letter, point, direction, axis or word.
  bool knows(const std::string& name) const;

  Scalar number(const Expression& expression, const Dimension& dimension);
  // A place: a vector of lengths from the origin of the ground, m.
  Vector3<Scalar> place(const Expression& expression);
  // A direction: any vector but zero is accepted, and returned with length one.
  Vector3<Scalar> direction(const Expression& expression);
  Vector3<Scalar> vector(const Expression& expression, const Dimension& dimension);

  // The g of the file, or else standard gravity.
  Scalar gravity_size();
  const Situation& situation() const { return situation_; }
  const Settings& settings() const { return settings_; }
  Value<Scalar> value(const Expression& expression);

 private:
  // An item that is being evaluated, for messages about names that lead back to themselves. `what` says what it is.
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
  std::map<const NamedExpression*, Value<Scalar>> found_;  // of the items of the situation
  std::map<std::string, Value<Scalar>> meanings_;          // of names other than `time` and directions
  std::vector<Pending> pending_;
};

// Evaluates every datum, point and direction of a statement, whether something uses it or not: letters and unknowns at
// some values, data with values. Throws StatementError for one that makes sense in no situation, as a unit or a name
// that is misspelt; that there is no value for the data at hand is told where it is used.
void check_every_datum(const Statement& statement);

// A number, or one component of a vector, as the variable of differentiation.
Value<Dual<1>> as_variable(const Value<double>& value, std::size_t component = 0);

// Whether the value of an expression depends on `time`, possibly through data.
bool depends_on_time(const Situation& situation, const Expression& expression);

// The letters on which an expression depends, possibly through data and points.
std::set<std::string> letters_of(const Situation& situation, const Expression& expression);

extern template class DataScope<double>;
extern template class DataScope<Dual<1>>;
extern template class DataScope<TimeJet>;
extern template class DataScope<TimeJetOf<Dual<1>>>;

}  // namespace poinsot::problem
