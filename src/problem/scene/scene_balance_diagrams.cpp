#include "problem/scene/scene_balance_diagrams.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/language/words.h"
#include "problem/scene/scene_wheels.h"

namespace poinsot::problem {
namespace {

using scene::DiagramKind;
using scene::Quantity;
using Wrench = SpatialForce<double>;

class BalanceDiagrams {
 public:
  BalanceDiagrams(SceneFigure& figure, const InstantExplainer& explainer, const InstantExplainer::System& system,
                  int group)
      : figure_(figure),
        explainer_(explainer),
        system_(system),
        group_(group),
        placed_(system.plan.sudden ? *explainer.figures().before : explainer.figures().now) {}

  void add() {
    for (std::size_t i = 0; i < system_.unknown.size(); ++i)
      if (!system_.unknown[i].determined) open_.push_back(ExplanationTex::plain(system_.unknown[i].tex));
    // Where found values leave nothing above their rounding, what is small beside other sizes is what is to be seen.
    std::vector<scene::Diagram> equation = diagrams();
    if (is_empty(equation)) {
      small_counts_ = true;
      equation = diagrams();
    }
    if (!is_empty(equation)) std::ranges::move(equation, std::back_inserter(figure_.scene().diagrams));
    if (!open_.empty())
      figure_.scene().notes.push_back("drawn without a size is what the equations leave open: " + listed(open_));
  }

 private:
  std::vector<scene::Diagram> diagrams() const {
    const std::string of = names();
    if (sudden())
      return {momenta(DiagramKind::momenta_before, "Momenta before the blow" + of),
              acting(DiagramKind::impulses, "Impulses from outside" + of),
              momenta(DiagramKind::momenta_after, "Momenta after the blow" + of)};
    return {acting(DiagramKind::free_body, "Free-body diagram" + of), kinetic("Kinetic diagram" + of)};
  }
  static bool is_empty(const std::vector<scene::Diagram>& equation) {
    return std::ranges::all_of(equation, [](const scene::Diagram& one) { return one.arrows.empty(); });
  }
  bool vanishes(const Vector3<double>& vector, const Dimension& dimension) const {
    return small_counts_ ? figure_.vanishes(vector, dimension) : explainer_.vanishes(vector, dimension);
  }

  const Mechanism<double>& mechanism() const { return figure_.mechanism(); }
  const InstantFigures<double>& numbers() const { return explainer_.figures(); }
  bool sudden() const { return system_.plan.sudden; }

  std::string names() const {
    std::vector<std::string> found;
    for (const Body& body : figure_.situation().bodies)
      if (system_.plan.bodies.contains(figure_.machine().index.at(body.name))) found.push_back(body.name);
    return found.size() == figure_.situation().bodies.size() ? "" : " of " + listed(found);
  }

  scene::Diagram diagram(DiagramKind kind, const std::string& title) const {
    scene::Diagram diagram{kind, title, group_, {}, {}};
    for (const int body : system_.plan.bodies)
      if (const int drawn = figure_.scene_body(body); drawn != scene::ground) diagram.bodies.push_back(drawn);
    return diagram;
  }

  std::vector<int> massive() const {
    std::vector<int> found;
    for (const int body : system_.plan.bodies)
      if (mechanism().tree.body(body).inertia.mass > 0) found.push_back(body);
    return found;
  }

  // The force and the couple of a wrench about the ground's origin, at a place, as far as they are not zero.
  // number: the component for which the symbol stands, if it is none of a vector.
  struct Number {
    double value = 0;  // SI
    std::string formula;
  };
  void add_wrench(scene::Diagram& diagram, const Wrench& wrench, const std::string& name, const scene::Place& at,
                  const ArrowSymbol& symbol, const std::optional<Number>& number, bool known) const {
    const Vector3<double> couple = about(wrench, figure_.on_ground(at)).moment;
    for (const auto& [quantity, vector] : {std::pair{force_kind(), wrench.force}, std::pair{couple_kind(), couple}}) {
      if (vanishes(vector, dimension_of(quantity))) continue;
      scene::Arrow arrow = figure_.arrow(quantity, name, at.body, at, vector, symbol);
      arrow.known = known;
      // The couple that goes with the force of a screw has its own size.
      const bool of_symbol = quantity == force_kind() || norm(wrench.force) == 0;
      if (number && of_symbol) {
        arrow.value = number->value / figure_.tex().unit(dimension_of(quantity)).factor;
        arrow.formula = number->formula;
      }
      diagram.arrows.push_back(std::move(arrow));
    }
  }

  Quantity force_kind() const { return sudden() ? Quantity::impulse : Quantity::force; }
  Quantity couple_kind() const { return sudden() ? Quantity::angular_impulse : Quantity::couple; }

  // The same of what the equations leave open: the way in which it acts where it counts as positive.
  void add_open(scene::Diagram& diagram, const Wrench& wrench, const std::string& name, const scene::Place& at,
                const ArrowSymbol& symbol) const {
    const Vector3<double> couple = about(wrench, figure_.on_ground(at)).moment;
    constexpr double rounding = 1e-9;
    for (const auto& [quantity, vector, least] :
         {std::tuple{force_kind(), wrench.force, 0.0},
          std::tuple{couple_kind(), couple, rounding * figure_.scene().length * norm(wrench.force)}}) {
      if (!(norm(vector) > least)) continue;
      scene::Arrow arrow = figure_.arrow(quantity, name, at.body, at, normalized(vector), symbol);
      arrow.open = true;
      diagram.arrows.push_back(std::move(arrow));
    }
  }

  scene::Diagram acting(DiagramKind kind, const std::string& title) const {
    scene::Diagram diagram = this->diagram(kind, title);
    for (std::size_t i = 0; i < system_.plan.unknown.size(); ++i) add_unknown(diagram, i);
    for (const KnownAction& known : system_.plan.known) add_known(diagram, known);
    if (!sudden()) add_weights(diagram);
    return diagram;
  }

  // The bodies' side of an action: the place moves with the body that is cut free.
  scene::Place place_on(const Action& action, double sign, const Vector3<double>& on_ground) const {
    return figure_.riding(sign > 0 ? action.on : action.from, on_ground);
  }

  void add_unknown(scene::Diagram& diagram, std::size_t i) const {
    const UnknownForce& force = system_.plan.unknown[i];
    const InstantExplainer::Symbol& symbol = system_.unknown[i];
    // A side of a cord that follows another one has an unknown of its own behind that.
    const int follows = force.kind == UnknownForce::Kind::component && mechanism().components[force.index].span
                            ? mechanism().components[force.index].follows
                            : -1;
    const std::size_t column = force.column + (follows < 0 ? 0 : force.index - static_cast<std::size_t>(follows));
    const double size = force.sign * (sudden() ? numbers().impulses : numbers().unknowns)[column];
    Wrench one{};
    int action = 0;
    Vector3<double> at;
    switch (force.kind) {
      case UnknownForce::Kind::component:
        one = placed_.component_wrench(mechanism().components[force.index]);
        action = mechanism().components[force.index].action;
        at = placed_.position(mechanism().components[force.index].at);
        break;
      case UnknownForce::Kind::effort:
        one = placed_.drive_wrench(mechanism().drives[force.index]);
        action = mechanism().drives[force.index].action;
        at = placed_.position(mechanism().drives[force.index].at);
        break;
      case UnknownForce::Kind::impact:
        one = impact_wrench(placed_, numbers().blow.impacts[force.index]);
        action = numbers().blow.impacts[force.index].action;
        at = placed_.position(numbers().blow.impacts[force.index].at);
        break;
    }
    const Action& what = mechanism().actions[static_cast<std::size_t>(action)];
    // A cord pulls its other end where that is.
    if (force.sign < 0 && force.kind == UnknownForce::Kind::component && mechanism().components[force.index].toward)
      at = placed_.position(*mechanism().components[force.index].toward);
    if (force.kind == UnknownForce::Kind::component && add_sliding(diagram, i, at)) return;
    if (!symbol.determined)
      return add_open(diagram, {force.sign * one.moment, force.sign * one.force}, what.name,
                      place_on(what, force.sign, at), {symbol.tex, ExplanationTex::plain(symbol.tex)});
    if (force.kind == UnknownForce::Kind::component && !sudden() && add_side(diagram, force, one, at)) return;
    const std::string formula = symbol.shown.formula ? text(*symbol.shown.formula, Notation::with_sizes) : "";
    add_wrench(diagram, {size * one.moment, size * one.force}, what.name, place_on(what, force.sign, at),
               {symbol.tex, ExplanationTex::plain(symbol.tex)}, Number{symbol.value, formula}, false);
    if (sudden() || what.kind != ActionKind::mesh || force.kind != UnknownForce::Kind::component) return;
    // Its teeth push the wheels apart beside.
    const Wrench both = wrench_with_parting(placed_, force.index);
    const Wrench apart{size * (both.moment - one.moment), size * (both.force - one.force)};
    if (norm(apart.force) > 0)
      add_wrench(diagram, apart, "parting at " + what.name, place_on(what, force.sign, at),
                 SceneFigure::indexed_symbol("R", what.name), std::nullopt, false);
  }

  // The tension of a side that follows that of others by a law of its own, as behind a wheel on which the cord slips
  // and of the last side of a belt: one arrow of what all its parts come to, with a name of its own.
  bool add_side(scene::Diagram& diagram, const UnknownForce& force, const Wrench& one,
                const Vector3<double>& at) const {
    const Component<double>& component = mechanism().components[force.index];
    if (!component.span || component.follows < 0) return false;
    const std::size_t first = force.column - static_cast<std::size_t>(component.follows);
    std::vector<std::size_t> parts;
    for (std::size_t k = 0; k < mechanism().components.size(); ++k)
      if (mechanism().components[k].span && mechanism().components[k].action == component.action) parts.push_back(k);
    if (parts.size() == 1 && component.followed_part() == 1 && component.offset == 0) return false;
    if (parts.front() != force.index) return true;
    double size = 0;
    for (const std::size_t k : parts) size += numbers().unknowns[first + k];
    const Action& what = mechanism().actions[static_cast<std::size_t>(component.action)];
    std::string symbol;
    std::size_t side = 0;
    const std::vector<const Component<double>*> sides = straight_parts(mechanism(), what.name);
    for (const scene::Link& link : figure_.scene().links) {
      if (link.kind != scene::LinkKind::cord || link.name != what.name || side >= sides.size()) continue;
      if (sides[side++]->action != component.action) continue;
      symbol = link.symbol.empty() ? "T_{" + std::to_string(side) + "}" : link.symbol;
      break;
    }
    const double signed_size = force.sign * size;
    add_wrench(diagram, {signed_size * one.moment, signed_size * one.force}, what.name, place_on(what, force.sign, at),
               {symbol, ExplanationTex::plain(symbol)}, Number{size, ""}, false);
    return true;
  }

  // A contact that slides pushes along its normal and rubs against the slip: two arrows for its one unknown.
  bool add_sliding(scene::Diagram& diagram, std::size_t i, const Vector3<double>& at) const {
    const UnknownForce& force = system_.plan.unknown[i];
    const InstantExplainer::Symbol& symbol = system_.unknown[i];
    const int action = mechanism().components[force.index].action;
    const std::vector<RoughContactOf<double>>& rough = figure_.machine().rough_contacts;
    const auto contact = std::ranges::find(rough, action, &RoughContactOf<double>::action);
    if (contact == rough.end() || contact->grip != Grip::slides || contact->on_cord()) return false;
    const bool open = !symbol.determined;
    const double size =
        open ? force.sign : force.sign * (sudden() ? numbers().impulses : numbers().unknowns)[force.column];
    const Vector3<double> push = size * direction_now(placed_, *contact, contact->normal),
                          friction = (-contact->sliding * size) * direction_now(placed_, *contact, *contact->slip);
    const Action& what = mechanism().actions[static_cast<std::size_t>(action)];
    const std::string formula = symbol.shown.formula ? text(*symbol.shown.formula, Notation::with_sizes) : "";
    const scene::Place place = place_on(what, force.sign, at);
    const ArrowSymbol normal{symbol.tex, ExplanationTex::plain(symbol.tex)};
    const ArrowSymbol along =
        sudden() ? SceneFigure::impulse_symbol("F", what.name) : SceneFigure::indexed_symbol("F", what.name);
    if (open) {
      add_open(diagram, {cross(at, push), push}, what.name, place, normal);
      add_open(diagram, {cross(at, friction), friction}, "friction at " + what.name, place, along);
    } else {
      add_wrench(diagram, {cross(at, push), push}, what.name, place, normal, Number{symbol.value, formula}, false);
      add_wrench(diagram, {cross(at, friction), friction}, "friction at " + what.name, place, along, std::nullopt,
                 false);
    }
    return true;
  }

  void add_known(scene::Diagram& diagram, const KnownAction& known) const {
    const Action& action = mechanism().actions[known.action];
    const auto symbol_of = [&](const Wrench& wrench) {
      const std::string letter = norm(wrench.force) > 0 ? "\\mathbf{F}" : "\\mathbf{M}";
      return sudden() ? SceneFigure::impulse_symbol(letter, action.name)
                      : SceneFigure::named_symbol(letter, action.name);
    };
    const auto add = [&](const Wrench& wrench, const Vector3<double>& at, const ArrowSymbol& shown) {
      add_wrench(diagram, {known.sign * wrench.moment, known.sign * wrench.force}, action.name,
                 place_on(action, known.sign, at), shown, std::nullopt, action.kind != ActionKind::spring);
    };
    const int number = static_cast<int>(known.action);
    if (sudden()) {
      for (const auto& impulse : numbers().blow.impulses)
        if (impulse.action == number) add(impulse.wrench, placed_.position(impulse.at), symbol_of(impulse.wrench));
      return;
    }
    const Model<double>& tree = mechanism().tree;
    for_each_law(mechanism(), [&](const auto& law) {
      if (law.action != number) return;
      const PlacedForce<double> force = law.exerted(tree, placed_.workspace());
      Vector3<double> at = force.point;
      if constexpr (requires { law.parts; }) at = placed_.position(law.at);
      if constexpr (requires { law.toward; })
        if (known.sign < 0) at = placed_.position(law.toward);
      if (norm(force.force) == 0) at = center_of(known.sign > 0 ? action.on : action.from);
      add(wrench_of(force), at, symbol_of(wrench_of(force)));
    });
    for (const Drive<double>& drive : mechanism().drives) {
      if (drive.action != number) continue;
      const double effort = drive.known_effort(placed_.state());
      const Wrench one = placed_.drive_wrench(drive);
      add({effort * one.moment, effort * one.force}, placed_.position(drive.at),
          SceneFigure::indexed_symbol(drive.turning ? "\\mathbf{M}" : "\\mathbf{F}", action.name));
    }
  }

  Vector3<double> center_of(int body) const {
    if (body == ground) return Vector3<double>::zero();
    if (mechanism().tree.body(body).inertia.mass > 0)
      return body_mass_center(mechanism().tree, placed_.workspace(), body);
    return figure_.on_ground(figure_.scene_place({body, Vector3<double>::zero()}));
  }

  // A letter of a body, with the body as its index where there are several.
  ArrowSymbol of_body(const std::string& tex, const std::string& text, int body, const std::string& rest = "",
                      const std::string& rest_text = "") const {
    if (!explainer_.several_bodies()) return {tex + rest, text + rest_text};
    const std::string& name = mechanism().tree.name(body);
    return {tex + "_{" + ExplanationTex::upright(name) + "}" + rest, text + "_" + name + rest_text};
  }

  void add_weights(scene::Diagram& diagram) const {
    for (const int body : massive()) {
      const Vector3<double> weight = mechanism().tree.body(body).inertia.mass * mechanism().tree.gravity();
      if (norm(weight) == 0) continue;
      const scene::Place at = figure_.riding(body, center_of(body));
      scene::Arrow arrow = figure_.arrow(Quantity::weight, mechanism().tree.name(body), at.body, at, weight,
                                         of_body("m", "m", body, "\\mathbf{g}", " g"));
      arrow.known = true;
      diagram.arrows.push_back(std::move(arrow));
    }
  }

  void add_momentum(scene::Diagram& diagram, Quantity quantity, int body, const Vector3<double>& vector,
                    const ArrowSymbol& symbol) const {
    if (vanishes(vector, dimension_of(quantity))) return;
    const scene::Place at = figure_.riding(body, center_of(body));
    diagram.arrows.push_back(figure_.arrow(quantity, mechanism().tree.name(body), at.body, at, vector, symbol));
  }

  // The symbol of the angular momentum about the mass center, or of its rate.
  ArrowSymbol about_center(const std::string& letter, const std::string& text, int body) const {
    const std::string& name = mechanism().tree.name(body);
    return {letter + "_{" + explainer_.center_label(body) + "}",
            text + "_G" + (explainer_.several_bodies() ? "," + name : "")};
  }

  scene::Diagram kinetic(const std::string& title) const {
    scene::Diagram diagram = this->diagram(DiagramKind::kinetic, title);
    for (const int body : massive()) {
      const Momentum<double> rate = momentum_rate_of(numbers().now, {body}, center_of(body));
      add_momentum(diagram, Quantity::rate_of_momentum, body, rate.linear,
                   of_body("m", "m", body, "\\bar{\\mathbf{a}}", " a"));
      add_momentum(diagram, Quantity::rate_of_angular_momentum, body, rate.angular,
                   about_center("\\dot{\\mathbf{H}}", "H'", body));
    }
    return diagram;
  }

  scene::Diagram momenta(DiagramKind kind, const std::string& title) const {
    scene::Diagram diagram = this->diagram(kind, title);
    const bool after = kind == DiagramKind::momenta_after;
    const solve::MechanismState& state = after ? numbers().now : placed_;
    const std::string prime = after ? "'" : "";
    for (const int body : massive()) {
      const Momentum<double> momentum = momentum_of(state, {body}, center_of(body));
      add_momentum(diagram, Quantity::linear_momentum, body, momentum.linear,
                   of_body("m", "m", body, "\\bar{\\mathbf{v}}" + prime, " v" + prime));
      add_momentum(diagram, Quantity::angular_momentum, body, momentum.angular,
                   about_center("\\mathbf{H}" + prime, "H" + prime, body));
    }
    // Particles that stay move with the body that they have struck.
    for (const auto& impulse : numbers().blow.impulses) {
      if (!after || !system_.plan.bodies.contains(impulse.on) || !(impulse.absorbed > 0)) continue;
      const Vector3<double> vector = impulse.absorbed * state.velocity(impulse.at);
      const std::string& name = mechanism().actions[static_cast<std::size_t>(impulse.action)].name;
      if (vanishes(vector, dimensions::momentum)) continue;
      const scene::Place at = figure_.scene_place(impulse.at);
      diagram.arrows.push_back(
          figure_.arrow(Quantity::linear_momentum, name, at.body, at, vector,
                        {"m\\mathbf{v}'_{" + ExplanationTex::upright(name) + "}", "m v'_" + name}));
    }
    return diagram;
  }

  SceneFigure& figure_;
  const InstantExplainer& explainer_;
  const InstantExplainer::System& system_;
  int group_;
  const solve::MechanismState& placed_;
  std::vector<std::string> open_;
  bool small_counts_ = false;
};

}  // namespace

void add_balance_diagrams(SceneFigure& figure, const InstantExplainer& explainer) {
  int group = 0;
  for (const InstantExplainer::System& system : explainer.systems())
    BalanceDiagrams(figure, explainer, system, ++group).add();
}

}  // namespace poinsot::problem
