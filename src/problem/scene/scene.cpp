#include "problem/scene/scene.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "poinsot/engine/work/work.h"
#include "problem/explanation/explanation_instant.h"
#include "problem/explanation/shown_numbers.h"
#include "problem/formulas/formula_answers.h"
#include "problem/language/diagnostic.h"
#include "problem/scene/scene_answers.h"
#include "problem/scene/scene_balance_diagrams.h"
#include "problem/scene/scene_dimensions.h"
#include "problem/scene/scene_figure.h"
#include "problem/scene/scene_free_motion.h"
#include "problem/scene/scene_model_diagram.h"
#include "problem/scene/scene_motion.h"
#include "problem/scene/scene_open_centers.h"
#include "problem/scene/scene_points.h"
#include "problem/scene/scene_stand_ins.h"
#include "problem/scene/scene_wheels.h"

namespace poinsot::problem {
namespace {

class SceneMaker {
 public:
  SceneMaker(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
             const SolvedStatement& solved, std::size_t solution)
      : statement_(statement),
        solved_(solved),
        solution_(solved.solutions[solution]),
        numbers_(statement, sets, solved, solution, LetterSizes::alike) {}

  // The situation about which is asked first, and then the others, as far as they can be drawn: that of a claim may
  // have letters of which nothing says how large they are.
  std::vector<scene::Scene> made() && {
    const bool chosen = numbers_.choose();
    const std::size_t first = shown_situation(chosen);
    scene::Scene shown = scene_in(first);
    std::vector<scene::Scene> scenes;
    if (!shown.bodies.empty()) scenes.push_back(shown);
    for (std::size_t k = 0; k < statement_.situations.size() && k < most_situations; ++k) {
      if (k == first) continue;
      scene::Scene other = scene_in(k);
      if (!other.bodies.empty()) scenes.push_back(std::move(other));
    }
    if (scenes.empty()) scenes.push_back(std::move(shown));
    return scenes;
  }

 private:
  static constexpr std::size_t most_situations = 8;

  std::size_t shown_situation(bool chosen) {
    if (!chosen || statement_.asks.empty()) return 0;
    try {
      return numbers_.sample().home_of(statement_.asks.front()).situation;
    } catch (const StatementError&) {
      return 0;  // The question is about no one instant.
    }
  }

  // The start of a situation.
  scene::Scene scene_in(std::size_t number) {
    const Situation& situation = statement_.situations[number];
    home_ = {number, situation.has_blow() ? 1U : 0U, std::nullopt};
    scene_ = {};
    scene_.situation = situation.name;
    scene_.axes = situation.axes;
    tell_letters();
    or_left_out("the figure", [&] { draw(home_); });
    tell_what_grows();
    return std::move(scene_);
  }

  void tell_letters() {
    for (const Letter& letter : solved_.open_letters)
      if (const auto drawn = numbers_.drawn().find(letter.name); drawn != numbers_.drawn().end())
        scene_.drawn_letters.push_back({letter.name, letter.unit.text, drawn->second / letter.unit.factor});
  }

  // Where all that is drawn has its size from one length, the value of that shows in nothing; nor does that of a length
  // which nothing is drawn with, as the radius of a bearing at which it rubs.
  void tell_what_grows() {
    constexpr double other = 2, rounding = 1e-9;
    for (const Letter& letter : solved_.open_letters) {
      const auto told = std::ranges::find(scene_.drawn_letters, letter.name, &scene::DrawnLetter::name);
      if (!(letter.unit.dimension == dimensions::length) || told == scene_.drawn_letters.end()) continue;
      AllSettings larger = numbers_.settings();
      for (Settings& one : larger)
        if (const auto value = one.find(letter.name); value != one.end()) value->second.number *= other;
      try {
        const std::vector<Vector3<double>> here = places_with(numbers_.settings()), there = places_with(larger);
        const auto are_times = [&](double factor) {
          return std::ranges::equal(here, there, [&](const Vector3<double>& before, const Vector3<double>& after) {
            return norm(Vector3<double>(after - factor * before)) <= rounding * scene_.length;
          });
        };
        told->only_grows = are_times(other) || are_times(1);
      } catch (const StatementError&) {
        told->only_grows = false;
      }
    }
  }

  // Where the shapes of bodies, points, joints and what runs between them are, on the ground.
  std::vector<Vector3<double>> places_with(const AllSettings& settings) {
    const Situation& situation = statement_.situations[home_.situation];
    Sample sample(statement_, settings, OpenChoice{});
    SolvedInstant& instant = sample.instant(home_);
    solve::MechanismState state(instant.machine().mechanism);
    state.set_positions(instant.state().q);
    state.set_velocities(instant.state().v);
    const ExplanationTex tex(situation, numbers_.open_letters(home_.situation));
    scene::Scene placed;
    SceneFigure figure(situation, settings[home_.situation], instant.machine(), state, tex, placed);
    figure.add_bodies();
    figure.add_points();
    figure.add_symbols();
    figure.add_links();
    add_wheels(figure);
    add_stand_ins(figure);
    std::vector<Vector3<double>> places;
    const auto add = [&](const scene::Place& place) { places.push_back(figure.on_ground(place)); };
    for (std::size_t k = 0; k < placed.bodies.size(); ++k)
      for (const scene::Shape& shape : placed.bodies[k].shapes)
        for (const Vector3<double>& vertex : shape.vertices) add({static_cast<int>(k), vertex});
    for (const scene::Point& point : placed.points) add(point.place);
    for (const scene::Symbol& symbol : placed.symbols) add(symbol.place);
    for (const scene::Link& link : placed.links) {
      add(link.from);
      add(link.to);
    }
    for (const scene::Curve& curve : placed.curves)
      for (const Vector3<double>& point : curve.points) add({curve.body, point});
    return places;
  }

  template <class Add>
  void or_left_out(const std::string& what, const Add& add) {
    try {
      add();
    } catch (const StatementError& error) {
      scene_.notes.push_back(what + " is left out: " + error.diagnostics().front().message);
    }
  }

  void draw(const Sample::Home& home) {
    const Situation& situation = statement_.situations[home.situation];
    Sample sample(statement_, numbers_.settings(), OpenChoice{});
    const ExplanationTex tex(situation, numbers_.open_letters(home.situation));
    SolvedInstant& instant = sample.instant(home);
    SolvedInstant* before = instant.after_blow() ? &sample.instant({home.situation, 0, std::nullopt}) : nullptr;
    const InstantQuestions questions = questions_at(home);
    if (questions.asks_forces() || (situation.steady && !before))
      or_left_out("what the bodies exert", [&] { instant.solve_forces(); });
    solve::MechanismState state(instant.machine().mechanism);
    // What is stated of a blow is stated of the motion before it.
    const MotionState reached = (before ? *before : instant).state();
    state.set_positions(reached.q);
    state.set_velocities(reached.v);
    SceneFigure figure(situation, numbers_.settings()[home.situation], instant.machine(), state, tex, scene_);
    figure.set_natural_size([&](const Dimension& dimension) { return instant.natural_size(dimension); });
    figure.add_bodies();
    figure.add_points();
    figure.add_symbols();
    figure.add_links();
    name_tensions(figure, statement_);
    add_wheels(figure);
    add_wraps(figure);
    add_later_surfaces(figure);
    add_stand_ins(figure);
    figure.stand_hinges_at_bodies();
    figure.add_world();
    figure.add_joint_springs();
    scene_.diagrams.push_back(model_diagram(figure));
    Explanation unread;
    const std::unique_ptr<FormulaInstant> formulas = formulas_of(home, instant);
    const InstantExplainer explainer(situation, instant, before, formulas.get(), numbers_.drawn(), {}, tex, questions,
                                     numbers_.settings()[home.situation], unread);
    or_left_out("the balance of forces", [&] { add_balance_diagrams(figure, explainer); });
    add_answers(figure, sample, home, solution_);
    add_dimensions(figure);
    leave_out_idle_points(figure, statement_);
    const bool turns_freely = add_free_motion(figure, instant.state());
    if (asks_motion(home.situation))
      or_left_out("the motion", [&] { add_motion(figure, sample, home.situation, solution_); });
    else if (turns_freely)
      draw_free_motion(figure, sample, instant.state());
  }

  void draw_free_motion(SceneFigure& figure, Sample& sample, const MotionState& reached) {
    try {
      add_motion(figure, sample, home_.situation, solution_);
    } catch (const StatementError&) {
      // What is not fixed is how the mass center moves.
      add_turning(figure, reached);
    }
  }

  bool asks_motion(std::size_t situation) const {
    if (statement_.record || numbers_.questions().motions.contains(situation)) return true;
    return std::any_of(statement_.asks.begin(), statement_.asks.end(), [&](const Ask& ask) {
      const bool in_time = ask.when || (ask.table && ask.table->over == "time");
      return in_time && numbers_.has_sample() && numbers_.sample().home_of(ask).situation == situation;
    });
  }

  InstantQuestions questions_at(const Sample::Home& home) const {
    const auto found = numbers_.questions().instants.find(home);
    return found == numbers_.questions().instants.end() ? InstantQuestions{} : found->second;
  }

  // The instant in formulas of the letters that have no value, if there are any.
  std::unique_ptr<FormulaInstant> formulas_of(const Sample::Home& home, SolvedInstant& instant) const {
    if (numbers_.open_letters(home.situation).empty()) return nullptr;
    FormulaValues values;
    for (const auto& [name, value] : numbers_.settings()[home.situation])
      if (value.is_number()) values[name] = Value<Formula>::of_number(Formula(value.number), value.dimension);
    for (const Letter& letter : solved_.open_letters) values[letter.name] = formula_of(letter);
    constexpr std::size_t most_terms = 300;
    constexpr Work most_work = 100'000'000;
    const FormulaLimitScope limits({most_terms, most_work});
    const PlainPointScope decisions(numbers_.drawn());
    try {
      auto formulas = std::make_unique<FormulaInstant>(statement_.situations[home.situation], values, instant);
      if (instant.forces_solved()) formulas->solve_forces();
      return formulas;
    } catch (const std::exception&) {
      // Arrows then have numbers alone.
      return nullptr;
    }
  }

  const Statement& statement_;
  const SolvedStatement& solved_;
  const Solution& solution_;
  ShownNumbers numbers_;
  Sample::Home home_;
  scene::Scene scene_;
};

}  // namespace

std::vector<scene::Scene> scenes_of(const Statement& statement,
                                    const std::vector<std::pair<std::string, std::string>>& sets,
                                    const SolvedStatement& solved, std::size_t solution) {
  const std::optional<Statement> placed = with_open_centers_at_joints(statement);
  return SceneMaker(placed ? *placed : statement, sets, solved, solution).made();
}

}  // namespace poinsot::problem
