// Questions about a motion: numbers along it, extremes, periods and the times of events.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "problem/course/corners.h"
#include "problem/course/course.h"
#include "problem/course/motion_features.h"
#include "problem/course/work_counted.h"
#include "problem/instant/open_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/state_scope.h"

namespace poinsot::problem {
namespace {

// How far two numbers along a motion are apart, measured by what rounding leaves of numbers that are equal.
class SidesApart {
 public:
  // natural: the size that is natural for such numbers.
  SidesApart(NumberInTime left, NumberInTime right, double natural)
      : left_(std::move(left)), right_(std::move(right)), natural_(natural) {}

  double natural() const { return natural_; }
  bool at(double time) const { return difference(time) > rounding(time); }
  double as_part(double time) const {
    constexpr double visible = 1e7;  // times rounding: the fifth digit of what is compared
    return difference(time) / std::max(visible * rounding(time), std::numeric_limits<double>::min());
  }
  // Whether they are equal at looks that fall on no steps, and then at several times in each step.
  bool nowhere(double from, double to, const std::function<std::vector<double>()>& steps) const {
    constexpr std::size_t looks = 12;
    constexpr int per_step = 6;
    for (std::size_t k = 0; k < looks; ++k)
      if (at(from + (to - from) * spread_evenly(k))) return false;
    const std::vector<double> ends = steps();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      for (int k = 0; k < per_step; ++k)
        if (at(ends[i] + (ends[i + 1] - ends[i]) * k / per_step)) return false;
    return true;
  }
  // When they come apart that are equal at first, and which becomes the larger: 1 the left one, -1 the right one. ends:
  // of the steps from where they are equal on; begun: where what is smooth begins. There they come apart as a power of
  // the time since, and elsewhere at a corner. Nothing where that is not seen.
  struct Parting {
    double time = 0;
    int larger = 0;
  };
  std::optional<Parting> parting(const std::vector<double>& ends, const std::vector<double>& begun) const {
    constexpr int looks = 6;
    double equal = ends.front();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      for (int k = 1; k <= looks; ++k) {
        const double look = ends[i] + (ends[i + 1] - ends[i]) * k / looks;
        if (!at(look)) {
          equal = look;
          continue;
        }
        double piece = ends.front();
        for (const double start : begun)
          if (start <= look - (look - equal) / 2) piece = std::max(piece, start);
        const double last = ends.back();
        if (const auto parting = grows_from(piece, look, last, 0, 40)) return parting;
        double inside = equal, outside = look;
        while (outside - inside > 1e-15 * outside && inside + (outside - inside) / 2 < outside &&
               inside + (outside - inside) / 2 > inside)
          (at(inside + (outside - inside) / 2) ? outside : inside) = inside + (outside - inside) / 2;
        return grows_from(outside, look, last, 0.95, 1.05);
      }
    return std::nullopt;
  }

 private:
  double difference(double time) const { return std::abs(left_(time) - right_(time)); }
  // Whether the difference grows from here as one power of the time since, as it does at three doublings.
  std::optional<Parting> grows_from(double from, double look, double last, double least, double most) const {
    constexpr double clear = 1e5, alike = 0.05;  // times rounding; of powers
    const auto is_clear = [&](double span) { return difference(from + span) >= clear * rounding(from + span); };
    constexpr double shortest = 1e-8;  // of the time: shorter spans are rounding themselves
    constexpr int most_halvings = 5;   // a small part of a step, in which the interpolant still has the power
    double span = look - from;
    for (int i = 0; i < most_halvings && span / 2 > shortest * std::abs(from) && is_clear(span / 2); ++i) span /= 2;
    while (!is_clear(span) && from + 4 * span < last) span *= 1.25;
    if (!(span > 0) || from + 4 * span > last) return std::nullopt;
    const double one = left_(from + span) - right_(from + span), two = left_(from + 2 * span) - right_(from + 2 * span),
                 four = left_(from + 4 * span) - right_(from + 4 * span);
    if (!(one * two > 0 && two * four > 0)) return std::nullopt;
    // What turns nearer still has come apart to the other side.
    for (double nearer = span / 4; from + nearer > from && at(from + nearer); nearer /= 4)
      if (one * (left_(from + nearer) - right_(from + nearer)) < 0) return std::nullopt;
    const double power = std::log2(two / one), later = std::log2(four / two);
    if (!(power > 0.5 && power > least && power < most && std::abs(later - power) <= alike * power))
      return std::nullopt;
    return Parting{from, one > 0 ? 1 : -1};
  }
  double rounding(double time) const {
    // What a motion conserves drifts by 1e-12 in a thousand steps; of zero there is the rounding of its terms.
    constexpr double of_sides = 1e-11, of_natural = 1e-15;
    return std::max(of_sides * std::max(std::abs(left_(time)), std::abs(right_(time))), of_natural * natural_);
  }

  NumberInTime left_, right_;
  double natural_;
};

// number: of an expression along the motion.
template <class Number>
std::vector<CornerInTime> corners_in_time(const Situation& situation, const std::vector<Expression>& expressions,
                                          const Number& number) {
  std::vector<CornerInTime> turns, zeros;
  for (const Expression& expression : expressions)
    for (const CornerOf& corner : corners_of(situation, expression)) {
      const NumberInTime value = number(corner.number);
      if (corner.turns)
        turns.push_back({[value](double time) { return value(time) * value(time); }, true});
      else
        zeros.push_back({value, false});
    }
  turns.insert(turns.end(), zeros.begin(), zeros.end());
  return turns;
}

}  // namespace

void Course::require_sides_apart(std::size_t stage, const Expression& ending) {
  const std::vector<Expression>& sides = ending.as<Comparison>()->operands;
  const double from = stages_[stage].start, to = stages_[stage].time;
  try {
    const SidesApart apart(number(sides[0], {}), number(sides[1], {}), start_->natural_size(dimension(sides[0], {})));
    if (!apart.nowhere(from, to, [&] { return nodes(from, to); })) return;
  } catch (const StatementError&) {
    return;
  }
  throw UnansweredError(situation_.file, ending.mark(),
                        "both sides of what ends " + words_of(stage) + " stay equal, so that it ends at no single time",
                        "name another event, or say how long it lasts with lasts:");
}

void Course::require_comparable(SolvedInstant& instant, const Expression& comparison,
                                const std::optional<Expression>& axes) {
  try {
    instant.raw(comparison, axes, nullptr);
  } catch (const DomainError&) {
    // That a side has no value just now is no fault of the comparison.
  } catch (const UnansweredError&) {
  }
}

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
  NumberWithRate both{
      number(expression, axes),
      {},
      start_->natural_size(dimension(expression, axes)),
      corners_in_time(situation_, {expression}, [&](const Expression& of) { return number(of, axes); })};
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

std::vector<double> Course::breaks(double from, double to) {
  at(to);
  std::vector<double> breaks{from};
  for (const StageRun& stage : stages_)
    for (const Trajectory& piece : stage.pieces)
      if (!piece.empty() && piece.start_time() > breaks.back() && piece.start_time() < to)
        breaks.push_back(piece.start_time());
  breaks.push_back(to);
  return breaks;
}

Value<double> Course::feature(const Call& call, const std::optional<Expression>& axes, const Mark& mark) {
  const WorkCounted counted(*this);
  const Expression& of = call.arguments.front().value;
  if (call.function == "end_of_bouncing") return Value<double>::of_number(end_of_bouncing(of), dimensions::time);
  const std::string words = call.function + "(" + to_string(of) + ")" + (axes ? " on " + to_string(*axes) : "");
  const Dimension kind = dimension(of, axes);
  const NumberWithRate followed = with_rate(of, axes);
  const MotionFeatures features(*this, followed, to_string(of), situation_.file, mark);
  if (call.function == "period") {
    const double period = features.period();
    values_until_ = std::max(values_until_, features.latest());
    tell({words, number_at_instants(of, axes), 0, {}, [period](const MotionScan& scan) {
            return scan.of_period(period);
          }});
    return Value<double>::of_number(period, dimensions::time);
  }
  const ExtremeFound found = call.function == "min" ? features.smallest() : features.largest();
  if (found.fallen > 0 && !is_of_places(situation_, of))
    throw UnansweredError(situation_.file, mark,
                          "the motion ends in the center that pulls, at " + with_digits(found.fallen, 6) +
                              " s: extremes up to there are told of places alone");
  extremes_until_ = std::max(extremes_until_, features.latest());
  asked_extremes_.push_back({call, axes, mark, found.value});
  tell({words,
        number_at_instants(of, axes),
        0,
        {},
        [found, largest = call.function == "max", natural = followed.natural_size](const MotionScan& scan) {
          return scan.of_extreme(found, largest, natural);
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
  constexpr double rounding_of_times = 1e-12;  // which are sums over the steps
  std::string how = in_words(found);
  if (how.empty())
    if (const std::optional<double> last = end();
        last && found.time > 0 && found.time >= *last * (1 - rounding_of_times))
      how = " is at the end of the motion, at " + with_digits(*last, 4) + " s";
  if (!how.empty()) add_once(happenings_, call.function + "(" + to_string(call.arguments.front().value) + ")" + how);
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
  require_comparable(instant_at(from), condition, axes);
  const MotionFeatures features(
      *this,
      {[left, right](double time) { return left(time) - right(time); },
       {},
       0,
       corners_in_time(situation_, comparison->operands, [&](const Expression& of) { return number(of, axes); })},
      to_string(condition), situation_.file, condition.mark());
  const Relation relation = comparison->relations.front();
  const int sense = relation == Relation::less || relation == Relation::less_equal         ? -1
                    : relation == Relation::greater || relation == Relation::greater_equal ? 1
                                                                                           : 0;
  const SidesApart apart(left, right, start_->natural_size(dimension(comparison->operands[0], axes)));
  // In each step up to when it is first expected, and by some looks in what follows.
  const auto stay_equal = [&](double first, double last, bool in_each_step) {
    try {
      return apart.nowhere(first, last, [&] { return in_each_step ? nodes(first, last) : std::vector<double>(); });
    } catch (const StatementError&) {
      return false;
    }
  };
  double begin = from, until = std::min(to ? *to : from + 4 * pace_time_, end().value_or(INFINITY));
  if (until > begin && stay_equal(begin, until, true)) {
    const bool holds = relation != Relation::less && relation != Relation::greater;
    tell({to_string(condition) + " by equal sides",
          [other = SidesApart(number_at_instants(comparison->operands[0], axes),
                              number_at_instants(comparison->operands[1], axes), apart.natural())](double time) {
            return other.as_part(time);
          },
          begin, until, [](const MotionScan& scan) { return scan.of_zero(); }});
    if (to && sense == 0)
      throw UnansweredError(situation_.file, condition.mark(),
                            "'" + to_string(condition) + "' holds all the time from " + with_digits(from, 4) +
                                " s to " + with_digits(*to, 4) + " s, and so at no single times");
    values_until_ = std::max(values_until_, until);
    if (to) return holds ? std::vector{from} : std::vector<double>{};
    if (holds) return {from};
    // As long as they stay equal neither is larger, whatever rounding says.
    do {
      begin = until;
      if (const bool ends = end() && begin >= *end(); ends || followed_enough(begin))
        throw NotHappeningError(situation_.file, condition.mark(),
                                "'" + to_string(condition) + "' does not happen up to " + with_digits(begin, 4) +
                                    " s: its two sides stay equal",
                                "check the condition, or look farther with lasts:", ends ? INFINITY : begin);
      until = std::min(from + 2 * (until - from), end().value_or(INFINITY));
    } while (stay_equal(begin, until, false));
  }
  // What rests at first and then moves comes to hold as it begins to.
  std::optional<double> parts;
  if ((relation == Relation::less || relation == Relation::greater) && until > from && !apart.at(from)) {
    std::vector<double> begun;
    for (const StageRun& stage : stages_)
      for (const Trajectory& piece : stage.pieces)
        if (!piece.empty()) begun.push_back(piece.start_time());
    if (const auto parting = apart.parting(nodes(from, until), begun); parting && parting->larger == sense)
      parts = parting->time;
  }
  std::vector<double> found = parts && !to ? std::vector{*parts} : features.zeros(begin, to, sense);
  constexpr double same = 1e-6;  // of the span
  if (parts && to && (found.empty() || found.front() - *parts > same * (until - from)))
    found.insert(found.begin(), *parts);
  values_until_ = std::max(values_until_, features.latest());
  tell({to_string(condition),
        [left = number_at_instants(comparison->operands[0], axes),
         right = number_at_instants(comparison->operands[1], axes)](double time) { return left(time) - right(time); },
        from, to ? *to : found.front(),
        [found, sense](const MotionScan& scan) { return scan.of_zeros(found, sense); }});
  // What holds from the start on has no sign that changes there.
  if (sense != 0 && !to && found.front() == from)
    tell({to_string(condition) + " from the start",
          [left = number_at_instants(comparison->operands[0], axes),
           right = number_at_instants(comparison->operands[1], axes), from, sense](double) {
            constexpr double rounding = 1e-9;
            const double a = left(from), b = right(from), size = std::max(std::abs(a), std::abs(b));
            const double off = sense * (b - a);
            return off > rounding * size ? off / size : 0;
          },
          from, from, [](const MotionScan& scan) { return scan.of_zero(); }});
  return found;
}

double Course::time_of(const Expression& quantity, double value, const Mark& mark) {
  const WorkCounted counted(*this);
  const NumberInTime number_at = number(quantity, std::nullopt);
  const MotionFeatures features(
      *this,
      {[number_at, value](double time) { return number_at(time) - value; },
       {},
       0,
       corners_in_time(situation_, {quantity}, [&](const Expression& of) { return number(of, std::nullopt); })},
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
