#include "problem/answers/asked_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "poinsot/engine/work/budget.h"
#include "problem/course/course.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/plane/planar_words.h"
#include "problem/quantities/asks_model.h"

namespace poinsot::problem {
namespace {

const char* const asked_words = "what is asked of the motion";

// A quantity as it is asked for: one column for a number, one for each component of a vector.
struct AskedQuantity {
  Expression whole;
  std::vector<std::size_t> components{};  // of a vector: those that are told; empty for a number
};

Expression quantity_expression(const std::string& text) { return parse_expression(text, "'" + text + "'", Mark{}); }

// The times at which what is asked is answered as a question: the ends and three between, each once.
std::vector<double> probed_times(const std::vector<double>& times) {
  std::vector<double> sorted = times;
  std::ranges::sort(sorted);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  constexpr std::size_t most = 5;
  if (sorted.size() <= most) return sorted;
  std::vector<double> probed;
  for (std::size_t k = 0; k < most; ++k) probed.push_back(sorted[k * (sorted.size() - 1) / (most - 1)]);
  return probed;
}

std::vector<std::string> coordinates_of(Course& course) {
  std::vector<std::string> names;
  for (const NamedCoordinate& coordinate : course.instant_at(0).machine().coordinates)
    if (!coordinate.name.empty()) names.push_back(coordinate.name);
  return names;
}

// The names of what acts beside weights and what joints carry.
std::vector<std::string> others_of(const Mechanism<double>& mechanism) {
  std::vector<std::string> others;
  const auto add = [&](int action) {
    const std::string& name = mechanism.actions[static_cast<std::size_t>(action)].name;
    if (std::ranges::find(others, name) == others.end()) others.push_back(name);
  };
  for_each_law(mechanism, [&](const auto& law) { add(law.action); });
  for (const Drive<double>& drive : mechanism.drives)
    if (drive.feeds() || drive.drains() || drive.stores()) add(drive.action);
  return others;
}

}  // namespace

struct AskedMotion::Parts {
  Statement statement;
  SettingTexts sets;
  Settings settings;
  std::unique_ptr<Course> motion;

  const Situation& situation() const { return statement.situations.front(); }
  Course& followed(double time);
  Record record_for(const std::vector<AskedQuantity>& quantities, const std::optional<Expression>& axes) const;
  void fill(AskedValues& found, const std::vector<double>& times, const std::vector<AskedQuantity>& quantities,
            const std::optional<Expression>& axes);
};

// The motion, followed to the time. If a budget ends on the way, it is begun anew the next time.
Course& AskedMotion::Parts::followed(double time) {
  try {
    if (!motion) motion = std::make_unique<Course>(situation(), settings, OpenChoice{});
    const double reached = motion->follow(time);
    // The last instant belongs to the motion, even if rounding puts it behind the end.
    constexpr double rounding = 1e-12;
    if (time > reached * (1 + rounding))
      throw UnansweredRecord(statement.file + ": the motion ends at " + with_digits(reached, 6) +
                             " s, and what is asked is at " + with_digits(time, 6) + " s");
  } catch (const BudgetEnded&) {
    motion.reset();
    throw;
  }
  return *motion;
}

Record AskedMotion::Parts::record_for(const std::vector<AskedQuantity>& quantities,
                                      const std::optional<Expression>& axes) const {
  Record record;
  record.axes = axes;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const std::string text = to_string(quantities[i].whole), name = "quantity" + std::to_string(i + 1);
    if (quantities[i].components.empty()) record.columns.push_back({name, quantities[i].whole, Mark{}});
    for (const std::size_t k : quantities[i].components) {
      const std::string& axis = situation().axes[k];
      record.columns.push_back({name + "." + axis, quantity_expression("(" + text + ")." + axis), Mark{}});
    }
  }
  return record;
}

void AskedMotion::Parts::fill(AskedValues& found, const std::vector<double>& times,
                              const std::vector<AskedQuantity>& quantities, const std::optional<Expression>& axes) {
  Course& course = *motion;
  const std::vector<std::string> coordinates = coordinates_of(course);
  // Coordinates and their rates are in the state itself; everything else takes an instant.
  const auto in_state = [&](const AskedQuantity& one) {
    const Name* name = one.whole.as<Name>();
    return name && name->primes < 2 && std::ranges::find(coordinates, name->name) != coordinates.end();
  };
  std::vector<NumberInTime> numbers(quantities.size());
  bool instants = false;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (in_state(quantities[i]))
      numbers[i] = course.number(quantities[i].whole, axes);
    else
      instants = true;
  }
  for (const double time : times) {
    check_budget();
    SolvedInstant* instant = instants ? &course.instant_at(time) : nullptr;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      AskedSeries& series = found.series[i];
      const auto keep = [&](double number) {
        if (!std::isfinite(number))
          throw UnansweredRecord(statement.file + ": " + to_string(quantities[i].whole) + " has no value at " +
                                 in_seconds(time));
        series.values.push_back(number);
      };
      if (numbers[i]) {
        keep(numbers[i](time));
        continue;
      }
      const Value<double> value = instant->ask(quantities[i].whole, axes, nullptr);
      if (quantities[i].components.empty()) keep(value.number);
      for (const std::size_t k : quantities[i].components) keep(value.vector[k]);
    }
  }
}

AskedMotion::AskedMotion(Statement statement, SettingTexts sets)
    : parts_(std::make_unique<Parts>(Parts{std::move(statement), std::move(sets), {}, nullptr})) {
  Parts& parts = *parts_;
  // Only the motion is asked.
  parts.statement.asks.clear();
  parts.statement.claims.clear();
  if (parts.statement.situations.size() > 1)
    throw UnansweredRecord(parts.statement.file + ": a motion is followed of a file with one situation");
  Record record;
  record.columns.push_back({"time", quantity_expression("time"), Mark{}});
  parts.settings = settled(parts.statement, parts.sets, {record, asked_words});
  parts.statement = in_states_at_start(parts.statement, parts.sets, {record, asked_words});
}

AskedMotion::~AskedMotion() = default;

std::vector<std::string> AskedMotion::coordinate_names() {
  return answered([&] { return coordinates_of(parts_->followed(0)); });
}

TreeAtStart AskedMotion::start() {
  return answered([&] {
    const SolvedInstant& instant = parts_->followed(0).instant_at(0);
    const Machine& machine = instant.machine();
    if (!machine.mechanism.constraints.empty())
      throw UnansweredRecord(parts_->statement.file + ": the bodies are no tree of joints alone, there is " +
                             machine.mechanism.constraints.front().words);
    // Whose coordinates are held is known to the equations of motion.
    const MechanismDynamics dynamics(machine.mechanism);
    const MotionState state = instant.state();
    TreeAtStart start{dynamics.mechanism().tree, {state.q, state.v}, machine.mechanism.coordinate_names, {}, {}};
    for (int body = 0; body < start.tree.body_count(); ++body) start.origins.push_back(machine.drawn_origin.at(body));
    start.others = others_of(machine.mechanism);
    return start;
  });
}

AskedValues AskedMotion::values(const std::vector<double>& times, const std::vector<std::string>& texts,
                                const std::string& axes_text) {
  Parts& parts = *parts_;
  const std::string& file = parts.statement.file;
  AskedValues found;
  if (std::ranges::any_of(times, [](double time) { return !(time >= 0) || std::isinf(time); }))
    fail(file, Mark{}, "the motion begins at 0 s: a time is a number that is not negative");
  const std::optional<Expression> axes =
      axes_text.empty() ? std::nullopt : std::optional(quantity_expression(axes_text));
  return answered([&] {
    const double last = times.empty() ? 0 : *std::ranges::max_element(times);
    Course& course = parts.followed(last);
    // In a plane, as in questions of a file: numbers along the normal, two components in the plane.
    const Situation& situation = parts.situation();
    const auto plane = situation.plane ? std::optional(PlanarWords(situation)) : std::nullopt;
    const std::vector<std::size_t> told =
        plane ? std::vector{component_axes(*situation.plane)[0], component_axes(*situation.plane)[1]}
              : std::vector<std::size_t>{0, 1, 2};
    std::vector<AskedQuantity> quantities;
    for (const std::string& text : texts) {
      const Expression stated = quantity_expression(text);
      const Expression expression = plane ? plane->as_number(stated) : stated;
      const Value<double> value = course.value(0, expression, axes);
      if (!value.is_number() && !value.is_vector())
        fail(file, Mark{}, "'" + text + "' is no number and no vector", "ask for it in the file");
      quantities.push_back({expression, value.is_vector() ? told : std::vector<std::size_t>()});
      AskedSeries series{si_unit(value.dimension, asks_energy(expression)), {}, {}};
      for (const std::size_t k : quantities.back().components) series.component_names.push_back(situation.axes[k]);
      found.series.push_back(std::move(series));
    }
    if (quantities.empty() || times.empty()) return found;
    const Record record = parts.record_for(quantities, axes);
    const SolvedStatement solved =
        solve_columns(parts.statement, parts.sets, {record, asked_words}, probed_times(times));
    found.checks = solved.solutions.front().checks;
    found.notes = solved.solutions.front().notes;
    parts.fill(found, times, quantities, axes);
    return found;
  });
}

}  // namespace poinsot::problem
