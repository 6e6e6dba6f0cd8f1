#include "problem/scene/scene_answers.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

using scene::Quantity;

// What is drawn of a question: the letter of its vector, and where the vector stands.
struct Drawn {
  Quantity quantity = Quantity::force;
  const char* letter = nullptr;  // TeX; null for forces, which have the name of what exerts them
  enum class Stands { at_point, at_center, at_action } stands = Stands::at_center;
};

const Drawn* drawn_as(const std::string& function, bool rate) {
  using Stands = Drawn::Stands;
  static const std::map<std::string, Drawn> values{
      {"angular_momentum", {Quantity::angular_momentum, "\\mathbf{H}", Stands::at_center}},
      {"momentum", {Quantity::linear_momentum, "\\mathbf{L}", Stands::at_center}},
      {"angular_velocity", {Quantity::angular_velocity, "\\boldsymbol{\\omega}", Stands::at_center}},
      {"angular_acceleration", {Quantity::angular_acceleration, "\\boldsymbol{\\alpha}", Stands::at_center}},
      {"velocity", {Quantity::velocity, "\\mathbf{v}", Stands::at_point}},
      {"acceleration", {Quantity::acceleration, "\\mathbf{a}", Stands::at_point}},
      {"force", {Quantity::force, nullptr, Stands::at_action}},
      {"tangential_force", {Quantity::force, nullptr, Stands::at_action}},
      {"radial_force", {Quantity::force, nullptr, Stands::at_action}},
      {"axial_force", {Quantity::force, nullptr, Stands::at_action}},
      {"reaction", {Quantity::force, nullptr, Stands::at_action}},
      {"couple", {Quantity::couple, "\\mathbf{M}", Stands::at_action}},
      {"reaction_couple", {Quantity::couple, "\\mathbf{M}", Stands::at_action}},
      {"impulse", {Quantity::impulse, nullptr, Stands::at_action}},
      {"impulsive_couple", {Quantity::angular_impulse, "\\mathbf{M}", Stands::at_action}}};
  static const std::map<std::string, Drawn> rates{
      {"angular_momentum", {Quantity::rate_of_angular_momentum, "\\dot{\\mathbf{H}}", Stands::at_center}},
      {"momentum", {Quantity::rate_of_momentum, "\\dot{\\mathbf{L}}", Stands::at_center}}};
  const auto& table = rate ? rates : values;
  const auto found = table.find(function);
  return found == table.end() ? nullptr : &found->second;
}

class AnswerDiagram {
 public:
  AnswerDiagram(SceneFigure& figure, Sample& sample, const Sample::Home& home)
      : figure_(figure), sample_(sample), home_(home) {
    diagram_.kind = scene::DiagramKind::answers;
    diagram_.title = "What is asked";
    for (std::size_t k = 0; k < figure.scene().bodies.size(); ++k) diagram_.bodies.push_back(static_cast<int>(k));
  }

  void add(const Ask& ask, const SolvedAsk& solved) {
    if (ask.of.size() != 1 || ask.is_list || ask.table || ask.when || ask.extremum) return;
    const bool found = solved.state == AskState::found && solved.value.is_vector();
    const bool formula = solved.state == AskState::needs_letters && solved.formula && solved.formula->is_vector();
    if (!found && !formula) return;
    if (!is_home(sample_.home(ask.of.front(), ask.mark))) return;
    const Expression expression = without_instant(ask.of.front());
    const Call* call = expression.as<Call>();
    if (call == nullptr || call->arguments.empty()) return;
    const bool rate = call->function == "rate";
    if (rate) call = without_instant(call->arguments.front().value).as<Call>();
    const Drawn* drawn = call ? drawn_as(call->function, rate) : nullptr;
    if (drawn == nullptr) return;
    // Components on other axes than the ground's are not those of the arrow.
    const Vector3<double> vector =
        found && !ask.axes ? solved.value.vector : sample_.value_at(home_, ask.of.front(), std::nullopt).vector;
    if (figure_.vanishes(vector, dimension_of(drawn->quantity))) return;
    const std::optional<Stand> stand = stand_of(*call, *drawn);
    if (!stand) return;
    scene::Arrow arrow = figure_.arrow(drawn->quantity, ask.name, stand->body, stand->at, vector, stand->symbol);
    arrow.value = norm(vector) / solved.unit.factor;
    arrow.unit = solved.unit.text;
    if (formula && !ask.axes) add_formula(arrow, vector, solved);
    diagram_.arrows.push_back(std::move(arrow));
  }

  void finish() {
    if (!diagram_.arrows.empty()) figure_.scene().diagrams.push_back(std::move(diagram_));
  }

 private:
  struct Stand {
    int body = scene::ground;
    scene::Place at;
    ArrowSymbol symbol;
  };

  bool is_home(const Sample::Home& home) const { return !(home < home_) && !(home_ < home); }

  static Expression without_instant(const Expression& expression) {
    const At* at = expression.as<At>();
    return at ? at->expression : expression;
  }

  // A single component is shown as a signed number, several as a list.
  static void add_formula(scene::Arrow& arrow, const Vector3<double>& vector, const SolvedAsk& solved) {
    std::vector<std::size_t> there;
    for (std::size_t k = 0; k < 3; ++k)
      if (!solved.formula->vector[k].is_zero()) there.push_back(k);
    if (there.size() == 1) {
      arrow.value = vector[there.front()] / solved.unit.factor;
      arrow.formula = text(solved.formula->vector[there.front()], Notation::with_sizes);
      return;
    }
    arrow.formula = "[";
    for (std::size_t k = 0; k < 3; ++k)
      arrow.formula += (k > 0 ? ", " : "") + text(solved.formula->vector[k], Notation::with_sizes);
    arrow.formula += "]";
  }

  std::optional<int> body_of(const Expression& expression) const {
    const Name* name = expression.as<Name>();
    const auto found = name ? figure_.machine().index.find(name->name) : figure_.machine().index.end();
    if (found == figure_.machine().index.end() || found->second == ground) return std::nullopt;
    return found->second;
  }
  scene::Place center_of(int tree_body) const {
    const int body = figure_.scene_body(tree_body);
    return {body, figure_.scene().bodies[static_cast<std::size_t>(body)].center};
  }
  static ArrowSymbol with_index(const Drawn& drawn, const std::string& index) {
    return SceneFigure::indexed_symbol(drawn.letter, index);
  }

  std::optional<Stand> stand_of(const Call& call, const Drawn& drawn) {
    const Expression& what = call.arguments.front().value;
    switch (drawn.stands) {
      case Drawn::Stands::at_center:
        return about_body(call, what, drawn);
      case Drawn::Stands::at_point:
        return at_point(what, drawn);
      case Drawn::Stands::at_action:
        break;
    }
    return at_action(call, what, drawn);
  }

  std::optional<Stand> about_body(const Call& call, const Expression& what, const Drawn& drawn) {
    const std::optional<int> body = body_of(what);
    const Expression* about = call.argument("about");
    Stand stand;
    if (body) {
      stand.body = figure_.scene_body(*body);
      stand.at = center_of(*body);
    }
    std::string index = several() && body ? to_string(what) : "";
    if (about) {
      // Not about a line, which has no point.
      const Value<double> place = sample_.value_at(home_, *about, std::nullopt);
      if (!place.is_vector() || place.dimension != dimensions::length) return std::nullopt;
      stand.at = body ? figure_.riding(*body, place.vector) : scene::Place{scene::ground, place.vector};
      if (const Name* point = about->as<Name>()) index = point->name + (index.empty() ? "" : "," + index);
    } else if (!body) {
      return std::nullopt;
    }
    stand.symbol = with_index(drawn, index);
    return stand;
  }

  std::optional<Stand> at_point(const Expression& what, const Drawn& drawn) const {
    const Of* of = what.as<Of>();
    const std::optional<int> body = body_of(of ? of->body : what);
    if (!body) return std::nullopt;
    Stand stand;
    stand.body = figure_.scene_body(*body);
    stand.at =
        of ? figure_.scene_place(figure_.machine().place(*body, figure_.data().place(of->point))) : center_of(*body);
    stand.symbol = with_index(drawn, of ? to_string(of->point) : several() ? to_string(what) : "");
    return stand;
  }

  std::optional<Stand> at_action(const Call& call, const Expression& what, const Drawn& drawn) {
    const Of* of = what.as<Of>();
    const std::string name = to_string(of ? of->point : what), joint = of ? to_string(of->body) : "";
    const Mechanism<double>& mechanism = figure_.mechanism();
    for (const std::size_t number : figure_.machine().actions_of(name, joint)) {
      const Action& action = mechanism.actions[number];
      for (const Component<double>& component : mechanism.components) {
        if (component.action != static_cast<int>(number)) continue;
        int on = action.on;
        if (const Expression* stated = call.argument("on")) on = body_of(*stated).value_or(on);
        Vector3<double> place = figure_.state().position(component.at);
        if (const Expression* about = call.argument("about")) {
          const Value<double> point = sample_.value_at(home_, *about, std::nullopt);
          if (point.is_vector() && point.dimension == dimensions::length) place = point.vector;
        }
        const ArrowSymbol symbol =
            drawn.letter ? with_index(drawn, name) : SceneFigure::named_symbol("\\mathbf{F}", name);
        return Stand{figure_.scene_body(on), figure_.riding(on, place), symbol};
      }
    }
    return std::nullopt;
  }

  bool several() const { return figure_.situation().bodies.size() > 1; }

  SceneFigure& figure_;
  Sample& sample_;
  const Sample::Home& home_;
  scene::Diagram diagram_;
};

}  // namespace

void add_answers(SceneFigure& figure, Sample& sample, const Sample::Home& home, const Solution& solution) {
  AnswerDiagram diagram(figure, sample, home);
  for (std::size_t k = 0; k < sample.statement().asks.size(); ++k) {
    try {
      diagram.add(sample.statement().asks[k], solution.asks[k]);
    } catch (const StatementError&) {
      // A question that has no one instant has no place in the figure of one.
    }
  }
  diagram.finish();
}

}  // namespace poinsot::problem
