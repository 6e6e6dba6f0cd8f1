// Questions about a motion: numbers along it, extremes, periods and the times of events.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "problem/course/course.h"
#include "problem/course/motion_features.h"
#include "problem/course/work_counted.h"
#include "problem/instant/open_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/state_scope.h"

namespace poinsot::problem {

SolvedInstant& Course::instant_at(double time) {
  move_probe(at(time));
  return *probe_;
}

Value<double> Course::value(double time, const Expression& expression, const std::optional<Expression>& axes) {
  values_until_ = std::max(values_until_, time);
  move_probe(at(time));
  Value<double> value = probe_->ask(expression, axes, nullptr);
  note_open_forces();
  return value;
}

void Course::note_open_forces() {
  if (!probe_->forces_solved()) return;
  for (std::size_t d = open_forces_.size(); d < probe_->motion().open.size(); ++d)
    open_forces_.push_back(open_force(*probe_, d));
}

NumberInTime Course::number(const Expression& expression, const std::optional<Expression>& axes) {
  if (const std::optional<StateEntry> entry = state_entry(expression))
    return [this, entry](double time) { return state_number(time, *entry); };
  if (is_of_state(situation_, start_->machine(), expression))
    return [this, expression, data = std::make_shared<DataScope<double>>(situation_, settings_)](double time) {
      data->set_time(time);
      StateScope scope(start_->machine(), *data, state_at(time));
      return evaluate(expression, static_cast<Scope<double>&>(scope), situation_.file).number;
    };
  return [this, expression, axes](double time) {
    move_probe(at(time));
    const double value = probe_->number(expression, axes);
    note_open_forces();
    return value;
  };
}

NumberWithRate Course::with_rate(const Expression& expression, const std::optional<Expression>& axes) {
  NumberWithRate both{number(expression, axes), {}, start_->natural_size(dimension(expression, axes))};
  const Name* name = expression.as<Name>();
  const NamedCoordinate* coordinate = name && name->primes == 0 ? start_->machine().coordinate(name->name) : nullptr;
  if (coordinate)
    both.rate = [this, entry = StateEntry{true, static_cast<std::size_t>(coordinate->velocity)}](double time) {
      return state_number(time, entry);
    };
  return both;
}

// The place of a coordinate or its rate in the state; nothing for other expressions.
std::optional<Course::StateEntry> Course::state_entry(const Expression& expression) const {
  const Name* name = expression.as<Name>();
  const NamedCoordinate* coordinate = name && name->primes < 2 ? start_->machine().coordinate(name->name) : nullptr;
  if (!coordinate) return std::nullopt;
  const bool rate = name->primes == 1;
  return StateEntry{rate, static_cast<std::size_t>(rate ? coordinate->velocity : coordinate->position)};
}

double Course::state_number(double time, const StateEntry& entry) {
  const State<double>& state = state_at(time);
  return entry.rate ? state.v[entry.place] : state.q[entry.place];
}

const State<double>& Course::state_at(double time) {
  if (const Trajectory* piece = piece_at(time)) {
    state_.q.resize(static_cast<std::size_t>(piece->position_size()));
    state_.v.resize(static_cast<std::size_t>(piece->velocity_size()));
    piece->state(time, state_.q, state_.v);
  } else {
    MotionState state = at(time);
    state_.q = std::move(state.q);
    state_.v = std::move(state.v);
  }
  return state_;
}

Dimension Course::dimension(const Expression& expression, const std::optional<Expression>& axes) {
  move_probe(at(0));
  const Value<double> value = probe_->ask(expression, axes, nullptr);
  if (!value.is_number())
    fail(situation_.file, expression.mark(),
         "'" + to_string(expression) + "' is no number that could be compared in time",
         "ask for a component or norm(...)");
  return value.dimension;
}

std::vector<double> Course::nodes(double from, double to) {
  at(to);
  std::vector<double> nodes{from};
  for (const StageRun& stage : stages_)
    for (const Trajectory& piece : stage.pieces)
      for (std::size_t i = 0; i < piece.step_count(); ++i) {
        const StepView step = piece.step(i);
        if (step.end <= from || step.start >= to) continue;
        // The steps of a closed form may be long: whole multiples of the natural time, but for rounding.
        constexpr double rounding = 1e-9;
        const double span = step.end - step.start, natural = step.flow ? step.flow->natural_time() : INFINITY;
        const double parts = std::max(1.0, std::ceil(span / natural * (1 - rounding)));
        const double first = std::max(0.0, std::floor((from - step.start) / span * parts));
        for (std::size_t part = 0; first + static_cast<double>(part) < parts; ++part) {
          const double time = step.start + span * ((first + static_cast<double>(part)) / parts);
          if (time >= to || nodes.size() > most_nodes) break;
          if (time > nodes.back()) nodes.push_back(time);
        }
      }
  if (to > nodes.back()) nodes.push_back(to);
  return nodes;
}

Value<double> Course::feature(const Call& call, const std::optional<Expression>& axes, const Mark& mark) {
  const WorkCounted counted(*this);
  const Expression& of = call.arguments.front().value;
  if (call.function == "end_of_bouncing") return Value<double>::of_number(end_of_bouncing(of), dimensions::time);
  const std::string words = call.function + "(" + to_string(of) + ")" + (axes ? " on " + to_string(*axes) : "");
  const Dimension kind = dimension(of, axes);
  const MotionFeatures features(*this, with_rate(of, axes), to_string(of), situation_.file, mark);
  if (call.function == "period") {
    const double period = features.period();
    values_until_ = std::max(values_until_, features.latest());
    tell({words, number_at_instants(of, axes), 0, {}, [period](const MotionScan& scan) {
            return scan.of_period(period);
          }});
    return Value<double>::of_number(period, dimensions::time);
  }
  const ExtremeFound found = call.function == "min" ? features.smallest() : features.largest();
  extremes_until_ = std::max(extremes_until_, features.latest());
  asked_extremes_.push_back({call, axes, mark, found.value});
  tell({words, number_at_instants(of, axes), 0, {}, [found, largest = call.function == "max"](const MotionScan& scan) {
          return scan.of_extreme(found, largest);
        }});
  tell_how(found, call);
  return Value<double>::of_number(found.value, kind);
}

MotionFeatureValues Course::features_in(const std::vector<Expression>& expressions,
                                        const std::optional<Expression>& axes) {
  MotionFeatureValues values;
  for (const Expression& expression : expressions)
    for (const auto& [call, mark] : motion_features_in(situation_, expression))
      if (!values.contains(call)) values.emplace(call, feature(*call, axes, mark));
  return values;
}

void Course::tell_how(const ExtremeFound& found, const Call& call) {
  const std::string words = call.function + "(" + to_string(call.arguments.front().value) + ")";
  constexpr double rounding_of_times = 1e-12;  // which are sums over the steps
  std::string note;
  if (found.settled > 0) {
    note = words + " was told from " + with_digits(found.settled, 4) + " s of a motion that does not repeat";
  } else if (const std::optional<double> last = end();
             last && found.time > 0 && found.time >= *last * (1 - rounding_of_times)) {
    note = words + " is at the end of the motion, at " + with_digits(*last, 4) + " s";
  }
  if (!note.empty() && std::ranges::find(happenings_, note) == happenings_.end()) happenings_.push_back(note);
}

std::vector<double> Course::times(const Expression& condition, const std::optional<Expression>& axes, double from,
                                  std::optional<double> to) {
  const WorkCounted counted(*this);
  if (const Call* call = condition.as<Call>(); call && smooth_hold(*call)) {
    std::vector<double> found = times_of_hold(*call, from, to);
    tell_of_hold(condition, found, from, to);
    return found;
  }
  if (const Call* call = condition.as<Call>(); call && call->arguments.size() == 1) {
    std::vector<double> found = times_of_state(*call, from, to);
    tell({to_string(condition),
          [this, condition](double time) {
            move_probe(at(time));
            return probe_->raw(condition, std::nullopt, nullptr).truth ? 1.0 : -1.0;
          },
          from, to ? *to : found.front(), [found](const MotionScan& scan) { return scan.of_zeros(found, 1); }});
    return found;
  }
  const Comparison* comparison = condition.as<Comparison>();
  if (!comparison || comparison->operands.size() != 2)
    fail(situation_.file, condition.mark(), "when something happens is told by one comparison",
         "write first_time: reaction(A).z == 0");
  // theta == min(theta) asks for the times at which theta touches its extreme.
  for (std::size_t side = 0; side < 2; ++side) {
    const Call* call = comparison->operands[side].as<Call>();
    const Expression& other = comparison->operands[1 - side];
    if (!call || (call->function != "min" && call->function != "max") || call->arguments.size() != 1) continue;
    if (!same_tree(call->arguments[0].value, other)) continue;
    const MotionFeatures features(*this, with_rate(other, axes), to_string(other), situation_.file, condition.mark());
    const bool largest = call->function == "max";
    std::vector<double> found = features.times_of_extreme(largest, from, to);
    values_until_ = std::max(values_until_, features.latest());
    for (const double time : found)
      tell({to_string(condition) + " at " + with_digits(time, 6) + " s",
            number_at_instants(other, axes),
            0,
            {},
            [extreme = ExtremeFound{number(other, axes)(time), time}, largest](const MotionScan& scan) {
              return scan.of_extreme(extreme, largest);
            }});
    return found;
  }
  const NumberInTime left = number(comparison->operands[0], axes), right = number(comparison->operands[1], axes);
  if (!same_kind(dimension(comparison->operands[0], axes), dimension(comparison->operands[1], axes)) &&
      left(from) != 0 && right(from) != 0)
    fail(situation_.file, condition.mark(), "the two sides of this comparison are of different kinds");
  const MotionFeatures features(*this, {[left, right](double time) { return left(time) - right(time); }, {}},
                                to_string(condition), situation_.file, condition.mark());
  const Relation relation = comparison->relations.front();
  const int sense = relation == Relation::less || relation == Relation::less_equal         ? -1
                    : relation == Relation::greater || relation == Relation::greater_equal ? 1
                                                                                           : 0;
  std::vector<double> found = features.zeros(from, to, sense);
  values_until_ = std::max(values_until_, features.latest());
  tell({to_string(condition),
        [left = number_at_instants(comparison->operands[0], axes),
         right = number_at_instants(comparison->operands[1], axes)](double time) { return left(time) - right(time); },
        from, to ? *to : found.front(),
        [found, sense](const MotionScan& scan) { return scan.of_zeros(found, sense); }});
  return found;
}

double Course::time_of(const Expression& quantity, double value, const Mark& mark) {
  const WorkCounted counted(*this);
  const NumberInTime number_at = number(quantity, std::nullopt);
  const MotionFeatures features(*this, {[number_at, value](double time) { return number_at(time) - value; }, {}},
                                to_string(quantity), situation_.file, mark);
  try {
    const double time = features.zeros(0, std::nullopt, 0).front();
    values_until_ = std::max(values_until_, time);
    tell({to_string(quantity) + " at " + with_digits(time, 6) + " s",
          [at_instants = number_at_instants(quantity, std::nullopt), value](double then) {
            return at_instants(then) - value;
          },
          0, time, [time](const MotionScan& scan) { return scan.of_zeros({time}, 0); }});
    return time;
  } catch (const UnansweredError&) {
    double least = number_at(0), most = least;
    for (const double time : nodes(0, reached())) {
      least = std::min(least, number_at(time));
      most = std::max(most, number_at(time));
    }
    // A motion that could not be followed is reported elsewhere.
    if (least > value || most < value) {
      const bool turning = same_kind(dimension(quantity, std::nullopt), dimensions::angle);
      const double unit = turning ? std::numbers::pi / 180 : 1;
      const std::string name = turning ? " deg" : " m";
      throw UnansweredError(situation_.file, mark,
                            "'" + to_string(quantity) + "' does not come to " + with_digits(value / unit, 6) + name +
                                " up to " + with_digits(reached(), 4) + " s: it runs from " +
                                with_digits(least / unit, 6) + " to " + with_digits(most / unit, 6) + name,
                            "let the table run over what is reached");
    }
    throw;
  }
}

}  // namespace poinsot::problem
