// Loads that depend on the motion: an expression of quantities becomes steps on parts of the motion
// (engine/dynamics/motion_expression.h).

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_templates.h"
#include "problem/language/expression_walk.h"
#include "problem/language/misread.h"
#include "problem/language/words.h"
#include "problem/machine/machine_draft.h"
#include "problem/machine/recorded.h"

namespace poinsot::problem {
namespace {

const NamedExpression* found_in(const std::vector<NamedExpression>& items, const std::string& name) {
  const auto found = std::ranges::find(items, name, &NamedExpression::name);
  return found == items.end() ? nullptr : &*found;
}

bool is_mathematical(const std::string& function) {
  return std::ranges::any_of(mathematical_functions(), [&](const FunctionForm& form) { return form.name == function; });
}

// What follows from the loads, so that no load can follow from it.
constexpr std::array<std::string_view, 12> follows_from_loads{
    "tangential_force",     "radial_force", "axial_force", "acceleration",
    "angular_acceleration", "force",        "couple",      "reaction",
    "reaction_couple",      "drive",        "tension",     "load"};
const std::vector<std::string> parts_of_motion{"position", "velocity", "angular_velocity", "center", "distance",
                                               "axis",     "mass"};

// The scope of an expression of a load. Vectors are on the axes of the load.
template <class Scalar>
class MotionScope : public Scope<Recorded<Scalar>> {
 public:
  using Number = Recorded<Scalar>;
  using Vector = Vector3<Number>;
  using Result = Value<Number>;

  MotionScope(MachineDraft<Scalar>& draft, std::string owner)
      : draft_(draft), situation_(draft.situation), owner_(std::move(owner)) {}

  std::vector<MotionPart<Scalar>>& parts() { return parts_; }

  Result name(const Name& name, const Mark& mark, const Evaluator<Number>& evaluator) override {
    const NamedCoordinate* coordinate = draft_.machine.coordinate(name.name);
    const NamedExpression* defined = found_in(situation_.define, name.name);
    if (coordinate && name.primes == 0 && draft_.data.knows(name.name))
      evaluator.fail(mark,
                     "'" + name.name + "' is a datum and the name of a coordinate: does " + owner_ +
                         " follow the datum or the coordinate?",
                     "give the coordinate another name, and the datum as its value under instants:");
    if (coordinate) {
      if (name.primes > 1)
        refuse(name.name + std::string(static_cast<std::size_t>(name.primes), '\''), mark, evaluator);
      MotionPart<Scalar> part;
      part.kind = name.primes == 0 ? MotionPartKind::coordinate : MotionPartKind::rate;
      part.coordinate = name.primes == 0 ? coordinate->position : coordinate->velocity;
      const Dimension dimension = coordinate->turning ? dimensions::angle : dimensions::length;
      return Result::of_number(entering(part).x, name.primes == 0 ? dimension : dimension / dimensions::time);
    }
    if (defined) {
      if (name.primes > 0)
        evaluator.fail(mark, owner_ + " cannot depend on the rate of '" + name.name + "'",
                       "write the rate in velocities, or as the rate of a coordinate");
      if (!pending_.insert(name.name).second) evaluator.fail(mark, "'" + name.name + "' is defined by itself");
      Result value = evaluator(defined->value);
      pending_.erase(name.name);
      return value;
    }
    return stated(draft_.data.name(name, mark, Evaluator<Scalar>(draft_.data, situation_.file)));
  }

  Result of(const Of& of, const Mark&, const Evaluator<Number>& evaluator) override {
    return position_of(ridden(Expression{std::make_shared<const Node>(Node{of, of.point.mark()})}, evaluator));
  }

  Result member(const Member& member, const Mark& mark, const Evaluator<Number>& evaluator) override {
    const auto axis = std::ranges::find(situation_.axes, member.name);
    const Result object = evaluator(member.object);
    if (!object.is_vector() || axis == situation_.axes.end())
      evaluator.fail(mark, kind_in_words(object) + " has no component '" + member.name + "'",
                     "a vector has ." + situation_.axes[0] + " ." + situation_.axes[1] + " ." + situation_.axes[2]);
    return Result::of_number(object.vector[static_cast<std::size_t>(axis - situation_.axes.begin())], object.dimension,
                             object.bare);
  }

  Result call(const Call& call, const Mark& mark, const Evaluator<Number>& evaluator) override {
    const std::string& f = call.function;
    if (std::ranges::find(follows_from_loads, f) != follows_from_loads.end()) refuse(f + "(...)", mark, evaluator);
    if (std::ranges::find(parts_of_motion, f) == parts_of_motion.end()) {
      if (!describe_unknown_call(call, parts_of_motion).hint.empty())
        evaluator.unknown_call(call, mark, parts_of_motion);
      evaluator.fail(mark, owner_ + " cannot depend on " + f + "(...)",
                     "it may depend on position, velocity, angular_velocity, center, distance, axis and mass, on "
                     "coordinates and on their rates");
    }
    const std::string pattern = call.pattern();
    const bool seen = f == "velocity" || f == "angular_velocity";
    if (call.arguments.empty() || pattern != (f == "distance"            ? "to"
                                              : seen && !pattern.empty() ? "relative to"
                                                                         : std::string()))
      evaluator.fail(
          mark, f + " is not written like this",
          f == "distance" ? "write distance(P to Q)" : "write " + f + "(body), with an A of body if a point is meant");
    const Expression& what = call.arguments.front().value;
    if (f == "distance") {
      const Vector apart =
          evaluator.vector(*call.argument("to"), dimensions::length) - evaluator.vector(what, dimensions::length);
      return Result::of_number(norm(apart), dimensions::length);
    }
    if (f == "axis") return axis_of(what, evaluator);
    if (f == "mass") return Result::of_number(mass_of(what, evaluator), dimensions::mass);
    if (f == "center") return position_of(center_of(what, evaluator));
    if (f == "position") {
      if (what.template as<Name>() && !draft_.machine.index.contains(what.template as<Name>()->name))
        return evaluator(what);
      return position_of(ridden(what, evaluator));
    }
    MotionPart<Scalar> part;
    if (const Expression* from = call.argument("relative to")) part.seen_from = body_of(*from, evaluator);
    if (f == "velocity") {
      part.kind = MotionPartKind::velocity;
      part.at = ridden(what, evaluator);
      return Result::of_vector(entering(part), dimensions::velocity);
    }
    part.kind = MotionPartKind::angular_velocity;
    part.at.body = body_of(what, evaluator);
    return Result::of_vector(entering(part), dimensions::angular_velocity);
  }

  Vector entering(const MotionPart<Scalar>& part) {
    parts_.push_back(part);
    const int index = static_cast<int>(parts_.size()) - 1;
    const auto component = [&](int k) { return Number(MotionOperation::part, {}, index, k); };
    return {component(0), component(1), component(2)};
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const Mark& mark, const Evaluator<Number>& evaluator) const {
    evaluator.fail(mark, owner_ + " cannot depend on " + what + ": accelerations and forces follow from the loads",
                   "let it depend on places, velocities, coordinates and their rates");
  }
  static Result stated(const Value<Scalar>& value) {
    Result result;
    result.kind = static_cast<typename Result::Kind>(value.kind);
    result.dimension = value.dimension;
    result.bare = value.bare;
    result.number = Number(value.number);
    result.vector = {Number(value.vector.x), Number(value.vector.y), Number(value.vector.z)};
    for (const Value<Scalar>& item : value.items) result.items.push_back(stated(item));
    result.truth = value.truth;
    result.text = value.text;
    return result;
  }

  int body_of(const Expression& expression, const Evaluator<Number>& evaluator) const {
    const Name* name = expression.as<Name>();
    const auto found = name ? draft_.machine.index.find(name->name) : draft_.machine.index.end();
    if (found != draft_.machine.index.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [body, index] : draft_.machine.index) known.push_back(body);
    const std::string hint = name ? did_you_mean(name->name, known) : "";
    evaluator.fail(expression.mark(), "there is no body '" + to_string(expression) + "'",
                   hint.empty() ? "known: " + joined(known) : hint);
  }
  const BodyMassOf<Scalar>& mass_properties(const Expression& expression, const Evaluator<Number>& evaluator) const {
    body_of(expression, evaluator);  // which refuses what is no body
    const std::string name = to_string(expression);
    if (std::ranges::none_of(situation_.bodies, [&](const Body& one) { return one.name == name; }))
      evaluator.fail(expression.mark(), "'" + name + "' has no mass center", "say which point is meant: A of " + name);
    const BodyMassOf<Scalar>& mass = draft_.masses[draft_.body_number(name)];
    if (!(plain(mass.properties.mass) > 0))
      evaluator.fail(expression.mark(), "'" + name + "' is massless: it has no mass center",
                     "say which point is meant, such as A of " + name);
    if (std::ranges::any_of(situation_.strikes, [](const Strike& strike) { return strike.stays; }))
      evaluator.fail(expression.mark(),
                     owner_ + " depends on a mass center or mass, which particles that stay would change",
                     "say which point of the body is meant, such as A of " + name);
    return mass;
  }
  Scalar mass_of(const Expression& expression, const Evaluator<Number>& evaluator) const {
    return mass_properties(expression, evaluator).properties.mass;
  }
  Place<Scalar> center_of(const Expression& expression, const Evaluator<Number>& evaluator) const {
    return draft_.machine.place(body_of(expression, evaluator),
                                mass_properties(expression, evaluator).properties.center);
  }
  // A point that rides with a body: A of plate, center(disk), or the body for its mass center.
  Place<Scalar> ridden(const Expression& expression, const Evaluator<Number>& evaluator) {
    if (const Of* of = expression.as<Of>())
      return draft_.machine.place(body_of(of->body, evaluator), draft_.data.place(of->point));
    if (const Call* call = expression.as<Call>();
        call && call->function == "center" && call->pattern().empty() && call->arguments.size() == 1)
      return center_of(call->arguments.front().value, evaluator);
    return center_of(expression, evaluator);
  }
  Result position_of(const Place<Scalar>& place) {
    MotionPart<Scalar> part;
    part.at = place;
    return Result::of_vector(entering(part), dimensions::length);
  }
  Result axis_of(const Expression& joint, const Evaluator<Number>& evaluator) {
    const auto found = draft_.machine.joints.find(to_string(joint));
    if (found == draft_.machine.joints.end() || !found->second.axis)
      evaluator.fail(joint.mark(), "there is no joint '" + to_string(joint) + "' with an axis of its own");
    MotionPart<Scalar> part;
    part.kind = MotionPartKind::direction;
    part.at = {found->second.axis->body, found->second.axis->vector};
    return Result::of_vector(entering(part), dimensions::none);
  }

  MachineDraft<Scalar>& draft_;
  const Situation& situation_;
  std::string owner_;
  std::vector<MotionPart<Scalar>> parts_;
  std::set<std::string> pending_;
};

// Writes the operations of recorded numbers as steps, each once.
template <class Scalar>
class StepWriter {
 public:
  explicit StepWriter(MotionExpression<Scalar>& into) : into_(into) {}

  int step_of(const Recorded<Scalar>& x) {
    if (x.is_constant()) {
      into_.constants.push_back(x.constant());
      return add({MotionOperation::constant, static_cast<int>(into_.constants.size()) - 1});
    }
    if (const auto known = written_.find(x.node()); known != written_.end()) return known->second;
    const auto& node = *x.node();
    MotionStep step{node.operation, node.part, node.component};
    std::array<int*, 3> operands{&step.first, &step.second, &step.third};
    for (std::size_t i = 0; i < node.operands.size(); ++i) *operands[i] = step_of(node.operands[i]);
    return written_[x.node()] = add(step);
  }

 private:
  int add(const MotionStep& step) {
    into_.steps.push_back(step);
    return static_cast<int>(into_.steps.size()) - 1;
  }

  MotionExpression<Scalar>& into_;
  std::map<const typename Recorded<Scalar>::Node*, int> written_;
};

template <class Scalar>
MotionExpression<Scalar> written(MotionScope<Scalar>& scope, const Vector3<Recorded<Scalar>>& vector, int axes) {
  MotionExpression<Scalar> expression;
  expression.axes = axes;
  StepWriter<Scalar> writer(expression);
  for (std::size_t k = 0; k < 3; ++k) expression.results[k] = writer.step_of(vector[k]);
  expression.parts = std::move(scope.parts());
  return expression;
}

void require_no_time(const Situation& situation, const MotionLoadWords& words) {
  for (const Expression* expression : {&words.size, words.direction ? &*words.direction : nullptr})
    if (expression && depends_on_time(situation, *expression))
      fail(situation.file, expression->mark(), words.owner + " depends on the time and on the motion at once",
           "state two loads, one of the time and one of the motion");
}

}  // namespace

template <class Scalar>
bool depends_on_motion(const MachineDraft<Scalar>& draft, const Expression& expression) {
  if (!expression) return false;
  if (expression.as<Of>()) return true;
  if (const Call* call = expression.as<Call>(); call && !is_mathematical(call->function)) return true;
  if (const Name* name = expression.as<Name>()) {
    if (name->primes > 0) return true;
    if (draft.data.knows(name->name)) return false;
    return draft.machine.coordinate(name->name) || found_in(draft.situation.define, name->name);
  }
  return any_child(expression, [&](const Expression& child) { return depends_on_motion(draft, child); });
}

template <class Scalar>
MotionExpression<Scalar> motion_load(MachineDraft<Scalar>& draft, const MotionLoadWords& words, int axes) {
  require_no_time(draft.situation, words);
  MotionScope<Scalar> scope(draft, words.owner);
  const Evaluator<Recorded<Scalar>> evaluator(scope, draft.situation.file);
  if (!words.direction) return written(scope, evaluator.vector(words.size, words.dimension), axes);
  const Value<Recorded<Scalar>> direction = evaluator(*words.direction);
  if (!direction.is_vector() || is_zero(direction))
    evaluator.fail(words.direction->mark(), "expected a direction",
                   "write an axis such as -y, A->B, or a vector such as velocity(body)");
  const Recorded<Scalar> size = evaluator.number(words.size, words.dimension);
  return written(scope, Vector3<Recorded<Scalar>>(size * normalized(direction.vector)), axes);
}

template <class Scalar>
MotionExpression<Scalar> motion_effort(MachineDraft<Scalar>& draft, const MotionLoadWords& words,
                                       const Direction<Scalar>& along) {
  require_no_time(draft.situation, words);
  MotionScope<Scalar> scope(draft, words.owner);
  const Recorded<Scalar> size =
      Evaluator<Recorded<Scalar>>(scope, draft.situation.file).number(words.size, words.dimension);
  MotionPart<Scalar> part;
  part.kind = MotionPartKind::direction;
  part.at = {along.body, along.vector};
  return written(scope, Vector3<Recorded<Scalar>>(size * scope.entering(part)), ground);
}

template bool depends_on_motion(const MachineDraft<double>&, const Expression&);
template bool depends_on_motion(const MachineDraft<Dual<1>>&, const Expression&);
template bool depends_on_motion(const MachineDraft<Formula>&, const Expression&);
template MotionExpression<double> motion_load(MachineDraft<double>&, const MotionLoadWords&, int);
template MotionExpression<Dual<1>> motion_load(MachineDraft<Dual<1>>&, const MotionLoadWords&, int);
template MotionExpression<Formula> motion_load(MachineDraft<Formula>&, const MotionLoadWords&, int);
template MotionExpression<double> motion_effort(MachineDraft<double>&, const MotionLoadWords&,
                                                const Direction<double>&);
template MotionExpression<Dual<1>> motion_effort(MachineDraft<Dual<1>>&, const MotionLoadWords&,
                                                 const Direction<Dual<1>>&);
template MotionExpression<Formula> motion_effort(MachineDraft<Formula>&, const MotionLoadWords&,
                                                 const Direction<Formula>&);

}  // namespace poinsot::problem
