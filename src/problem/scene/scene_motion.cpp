#include "problem/scene/scene_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "poinsot/engine/dynamics/cord_span.h"
#include "poinsot/engine/work/work.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/asks_model.h"
#include "problem/scene/scene_wheels.h"

namespace poinsot::problem {
namespace {

// Of all bodies together: a page with more takes long to load.
constexpr std::size_t most_poses = 6000;
constexpr std::size_t usual_times = 241, least_times = 25, most_times = 1501;
constexpr std::size_t most_plots = 12;
constexpr double turns_shown = 2;                      // of what moves on without an end that is asked about
constexpr double most_turning = std::numbers::pi / 3;  // of a body between two times, so that one can go between them
constexpr double by_chords = 6;                        // times as near to each other where a chord stands for an arc
constexpr Work most_work = 4'000'000'000;

class SceneMotion {
 public:
  SceneMotion(SceneFigure& figure, Sample& sample, std::size_t situation, const Solution& solution)
      : figure_(figure),
        sample_(sample),
        situation_(situation),
        solution_(solution),
        course_(sample.motion(situation)) {
    course_.set_work_limit(most_work);
  }

  void add() {
    find_asked_times();
    follow();
    if (!(until_ > 0)) {
      figure_.scene().notes.push_back("the motion is left out: " + motion_.stopped);
      return;
    }
    choose_times();
    add_poses();
    add_plots();
    add_events();
    add_paths();
    figure_.scene().motion = std::move(motion_);
  }

 private:
  bool asks_here(const Ask& ask) {
    try {
      return sample_.home_of(ask).situation == situation_;
    } catch (const StatementError&) {
      return false;
    }
  }

  // The times about which is asked, and those that are answers.
  void find_asked_times() {
    const Statement& statement = sample_.statement();
    for (std::size_t k = 0; k < statement.asks.size(); ++k) {
      const Ask& ask = statement.asks[k];
      const SolvedAsk& solved = solution_.asks[k];
      if (!asks_here(ask)) continue;
      if (ask.table) {
        if (ask.table->over != "time") continue;
        tables_.push_back(&ask);
        for (const double time : times_of(ask.table->values)) asked_.insert(time);
      } else if (ask.when) {
        for (const double time : times_in(solved.value)) {
          asked_.insert(time);
          motion_.events.push_back({time, ask.name + ": " + to_string(ask.when->condition)});
        }
      } else if (!ask.extremum) {
        try {
          const Sample::Home home = sample_.home(ask.of.front(), ask.mark);
          if (home.time) asked_.insert(*home.time);
          if (home.time || home.ending) asks_.push_back(&ask);
        } catch (const StatementError&) {
          // A question without an instant of its own is none about the motion.
        }
      }
    }
  }
  std::vector<double> times_of(const Expression& values) {
    const Range* range = values.as<Range>();
    if (!range) return times_in(figure_.data().value(values));
    const auto time = [&](const Expression& expression) { return figure_.data().number(expression, dimensions::time); };
    const double from = time(range->from), to = time(range->to), step = time(range->step);
    std::vector<double> times{to};
    for (std::size_t k = 0; k < most_times && from + static_cast<double>(k) * step < to; ++k)
      times.push_back(from + static_cast<double>(k) * step);
    return times;
  }
  static std::vector<double> times_in(const Value<double>& value) {
    if (value.is_number()) return {value.number};
    std::vector<double> times;
    for (const Value<double>& item : value.items)
      if (item.is_number()) times.push_back(item.number);
    return times;
  }

  void follow() {
    std::optional<double> until;
    try {
      const std::vector<Stage>& stages = course_.situation().stages;
      if (!stages.empty() && stages.back().lasts) until = course_.end();
    } catch (const StatementError& error) {
      stop(error);
    }
    if (!until && !asked_.empty()) until = *asked_.rbegin();
    if (!until || !(*until > 0)) until = turns_shown * 2 * std::numbers::pi * course_.turning_time(course_.pace_time());
    until_ = *until;
    // Where it comes to an end of its own, as much is shown as it can be followed by halves.
    constexpr int halvings = 6;
    for (int k = 0; k < halvings; ++k) {
      try {
        until_ = std::min(until_, course_.follow(until_));
        return;
      } catch (const StatementError& error) {
        if (motion_.complete) stop(error);
        until_ /= 2;
      }
    }
    until_ = 0;
  }
  void stop(const StatementError& error) {
    motion_.complete = false;
    motion_.stopped = error.diagnostics().front().message;
  }

  double largest_rate(double time) {
    const MotionState at = course_.at(time);
    solve::MechanismState state(figure_.mechanism());
    state.set_positions(at.q);
    state.set_velocities(at.v);
    double largest = 0;
    // What goes round a center that pulls turns about it, and between two times it is drawn along a chord.
    if (const std::optional<CentralGravity>& central = figure_.situation().central_gravity) {
      const Vector3<double> center = figure_.data().place(central->toward);
      for (std::size_t k = 0; k < figure_.situation().bodies.size(); ++k) {
        const int tree_body = figure_.tree_body(static_cast<int>(k));
        const auto& motion = state.workspace().motion[static_cast<std::size_t>(tree_body + 1)];
        const scene::Pose pose = figure_.pose_of(tree_body, state);
        const Vector3<double> place = pose.R * figure_.scene().bodies[k].center + pose.p, arm = place - center;
        const Vector3<double> velocity = motion.v + cross(motion.w, place - motion.p);
        if (norm(arm) > 0)
          largest = std::max(largest, by_chords * norm(Vector3<double>(cross(arm, velocity))) / norm_squared(arm));
      }
    }
    for (std::size_t k = 0; k < figure_.scene().bodies.size(); ++k)
      largest = std::max(
          largest,
          norm(state.workspace().motion[static_cast<std::size_t>(figure_.tree_body(static_cast<int>(k)) + 1)].w));
    return largest;
  }

  void choose_times() {
    const std::size_t bodies = std::max<std::size_t>(1, figure_.scene().bodies.size());
    const std::size_t most = std::clamp(most_poses / bodies, least_times, most_times);
    double rate = 0;
    constexpr int looks = 20;
    for (int k = 0; k <= looks; ++k) rate = std::max(rate, largest_rate(until_ * k / looks));
    const double needed = until_ * rate / most_turning + 1;
    std::size_t count = std::min(usual_times, most);
    if (needed > static_cast<double>(count))
      count = std::min(most, static_cast<std::size_t>(std::min(needed, 1e6)) + 1);
    if (needed > static_cast<double>(most)) {
      const double shown = static_cast<double>(most - 1) * most_turning / rate;
      motion_.complete = false;
      motion_.stopped = "shown are the first " + with_digits(shown, 3) + " s of " + with_digits(until_, 3) +
                        " s, since the bodies turn too often for more";
      until_ = shown;
    }
    std::set<double> times;
    for (std::size_t k = 0; k < count; ++k)
      times.insert(until_ * static_cast<double>(k) / static_cast<double>(count - 1));
    std::size_t added = 0;
    for (const double time : asked_)
      if (time >= 0 && time <= until_ && added++ < most) times.insert(time);
    motion_.times.assign(times.begin(), times.end());
  }

  void add_poses() {
    begin_velocities();
    begin_links();
    solve::MechanismState state(figure_.mechanism());
    for (const double time : motion_.times) {
      const MotionState at = course_.at(time);
      state.set_positions(at.q);
      state.set_velocities(at.v);
      add_velocities(state);
      add_links(state);
      std::vector<scene::Pose> poses;
      for (std::size_t k = 0; k < figure_.scene().bodies.size(); ++k)
        poses.push_back(figure_.pose_of(figure_.tree_body(static_cast<int>(k)), state));
      motion_.poses.push_back(std::move(poses));
      positions_.push_back(at.q);
    }
  }

  // The straight parts of cords over wheels stand among the links in their order (SceneFigure::add_links).
  void begin_links() {
    const Mechanism<double>& mechanism = figure_.mechanism();
    const std::vector<scene::Link>& links = figure_.scene().links;
    std::set<std::string> begun;
    for (std::size_t link = 0; link < links.size(); ++link) {
      if (links[link].kind != scene::LinkKind::cord || !begun.insert(links[link].name).second) continue;
      std::size_t next = link;
      for (const Component<double>* part : straight_parts(mechanism, links[link].name)) {
        motion_.links.push_back({next, {}, {}});
        spans_.push_back(*part->span);
        // Either end of its part may be that where a link begins.
        const SpanLine<double> drawn = line_of(mechanism.tree, figure_.state().workspace(), *part->span);
        const Vector3<double> begin = figure_.on_ground(links[next++].from);
        from_start_.push_back(norm(Vector3<double>(begin - drawn.start)) < norm(Vector3<double>(begin - drawn.end)));
      }
    }
  }
  void add_links(const solve::MechanismState& state) {
    for (std::size_t k = 0; k < spans_.size(); ++k) {
      const SpanLine<double> line = line_of(figure_.mechanism().tree, state.workspace(), spans_[k]);
      motion_.links[k].from.push_back(from_start_[k] ? line.start : line.end);
      motion_.links[k].to.push_back(from_start_[k] ? line.end : line.start);
    }
  }

  // Of each body with mass the velocity of its center and its angular velocity.
  void begin_velocities() {
    const bool several = figure_.situation().bodies.size() > 1;
    for (std::size_t k = 0; k < figure_.scene().bodies.size(); ++k) {
      const scene::Body& body = figure_.scene().bodies[k];
      if (body.massless || body.frame) continue;
      const scene::Place at{static_cast<int>(k), body.center};
      const std::string index = several ? body.name : "";
      for (const auto& [quantity, letter] : {std::pair{scene::Quantity::velocity, "\\mathbf{v}"},
                                             std::pair{scene::Quantity::angular_velocity, "\\boldsymbol{\\omega}"}}) {
        const ArrowSymbol symbol = SceneFigure::indexed_symbol(letter, index);
        const Unit& unit = figure_.tex().unit(dimension_of(quantity));
        motion_.arrows.push_back({quantity, body.name, at, symbol.tex, symbol.text, unit.text, unit.factor, {}});
      }
    }
  }
  void add_velocities(const solve::MechanismState& state) {
    for (scene::MovingArrow& arrow : motion_.arrows) {
      const int tree_body = figure_.tree_body(arrow.at.body);
      const auto& motion = state.workspace().motion[static_cast<std::size_t>(tree_body + 1)];
      const scene::Pose pose = figure_.pose_of(tree_body, state);
      const Vector3<double> place = pose.R * arrow.at.at + pose.p;
      arrow.vectors.push_back(arrow.quantity == scene::Quantity::angular_velocity
                                  ? motion.w
                                  : Vector3<double>(motion.v + cross(motion.w, place - motion.p)));
    }
  }

  void add_plots() {
    for (const Ask* ask : tables_)
      for (const NamedExpression& column : ask->table->columns)
        if (!column.value.as<Name>() || column.value.as<Name>()->name != "time")
          add_plot(ask->name + "." + column.name, to_string(column.value), column.value, ask->axes);
    for (const Ask* ask : asks_)
      if (const At* at = ask->of.front().as<At>(); at && ask->of.size() == 1)
        add_plot(ask->name, to_string(at->expression), at->expression, ask->axes);
    for (const NamedCoordinate& coordinate : figure_.machine().coordinates) {
      // What is asked has its line already.
      if (coordinate.name.empty() || plotted_.contains(coordinate.name) || motion_.plots.size() >= most_plots) continue;
      const Unit& unit = figure_.tex().unit(coordinate.turning ? dimensions::angle : dimensions::length);
      scene::Plot plot{coordinate.name, "coordinate " + coordinate.name, unit.text, {coordinate.name}, {{}}};
      for (const std::vector<double>& q : positions_)
        plot.values[0].push_back(q[static_cast<std::size_t>(coordinate.position)] / unit.factor);
      motion_.plots.push_back(std::move(plot));
    }
  }
  void add_plot(const std::string& name, const std::string& words, const Expression& expression,
                const std::optional<Expression>& axes) {
    // What is asked at several times is one line over time.
    const bool is_new = plotted_.insert(words + (axes ? " on " + to_string(*axes) : "")).second;
    if (motion_.plots.size() >= most_plots || !is_new) return;
    scene::Plot plot;
    plot.name = name;
    plot.words = words;
    try {
      for (const double time : motion_.times) {
        const Value<double> value = course_.value(time, expression, axes);
        if (!value.is_number() && !value.is_vector()) return;
        const Unit unit = asks_energy(expression) ? figure_.situation().habits.unit_for(value.dimension, true)
                                                  : figure_.tex().unit(value.dimension);
        plot.unit = unit.text;
        plot.values.resize(value.is_number() ? 1 : 3);
        if (value.is_number()) {
          plot.values[0].push_back(value.number / unit.factor);
        } else {
          for (std::size_t k = 0; k < 3; ++k) plot.values[k].push_back(value.vector[k] / unit.factor);
        }
      }
    } catch (const StatementError& error) {
      figure_.scene().notes.push_back("the plot of " + words + " is left out: " + error.diagnostics().front().message);
      return;
    }
    plot.labels = plot.values.size() == 1
                      ? std::vector<std::string>{name}
                      : std::vector<std::string>(figure_.situation().axes.begin(), figure_.situation().axes.end());
    motion_.plots.push_back(std::move(plot));
  }

  void add_events() {
    const std::vector<Stage>& stages = course_.situation().stages;
    for (std::size_t k = 1; k < stages.size(); ++k) {
      try {
        if (const double start = course_.stage_start(k); start <= until_)
          motion_.events.push_back({start, stages[k].name + " begins"});
      } catch (const StatementError&) {
        break;  // The motion does not come so far.
      }
    }
    constexpr std::size_t most_changes = 12;
    for (const Course::Change& change : course_.changes())
      if (motion_.events.size() < most_changes) motion_.events.push_back({change.time, change.words});
    std::erase_if(motion_.events, [&](const scene::Event& event) { return event.time > until_; });
    std::ranges::sort(motion_.events, {}, &scene::Event::time);
  }

  // The paths of the mass centers that move. About a point held by the ground they lie on a sphere, and show how the
  // axis through that point moves.
  void add_paths() {
    for (std::size_t k = 0; k < figure_.scene().bodies.size(); ++k) {
      const scene::Body& body = figure_.scene().bodies[k];
      if (body.massless || body.frame) continue;
      scene::Curve curve;
      curve.name = body.name;
      for (const std::vector<scene::Pose>& poses : motion_.poses)
        curve.points.push_back(poses[k].R * body.center + poses[k].p);
      double moved = 0;
      for (const Vector3<double>& point : curve.points)
        moved = std::max(moved, norm(Vector3<double>(point - curve.points.front())));
      constexpr double noticeable = 1e-3;  // of the figure
      if (moved < noticeable * figure_.scene().length) continue;
      for (const scene::Symbol& symbol : figure_.scene().symbols)
        if (symbol.to == static_cast<int>(k) && symbol.from == scene::ground &&
            (symbol.kind == scene::SymbolKind::ball || symbol.kind == scene::SymbolKind::ball_support ||
             symbol.kind == scene::SymbolKind::universal))
          curve.kind = scene::CurveKind::axis_path;
      figure_.scene().curves.push_back(std::move(curve));
    }
  }

  SceneFigure& figure_;
  Sample& sample_;
  std::size_t situation_;
  const Solution& solution_;
  Course& course_;
  std::set<double> asked_;
  std::set<std::string> plotted_;
  std::vector<const Ask*> tables_, asks_;
  double until_ = 0;
  std::vector<std::vector<double>> positions_;
  std::vector<CordSpan<double>> spans_;  // of the links of the motion
  std::vector<bool> from_start_;         // whether the links begin where these start
  scene::Motion motion_;
};

}  // namespace

void add_motion(SceneFigure& figure, Sample& sample, std::size_t situation, const Solution& solution) {
  SceneMotion(figure, sample, situation, solution).add();
}

}  // namespace poinsot::problem
