// The diagram of the statement's figure: what it says of loads, motions and blows.
#include "problem/scene/scene_model_diagram.h"

#include <algorithm>
#include <set>
#include <string>

#include "poinsot/engine/work/work.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

using scene::Quantity;

class ModelDiagram {
 public:
  explicit ModelDiagram(SceneFigure& figure) : figure_(figure) {
    diagram_.kind = scene::DiagramKind::model;
    diagram_.title = "Figure";
    for (std::size_t k = 0; k < figure.scene().bodies.size(); ++k) diagram_.bodies.push_back(static_cast<int>(k));
  }

  scene::Diagram made() && {
    add_loads();
    add_excitations();
    add_joint_rates();
    add_frames();
    add_spins();
    add_facts();
    add_blows();
    return std::move(diagram_);
  }

 private:
  const Situation& situation() const { return figure_.situation(); }
  const solve::MechanismState& state() const { return figure_.state(); }

  // A datum that is a vector or the size of one is shown by its own name.
  ArrowSymbol symbol_of(const std::optional<Expression>& value, const ArrowSymbol& otherwise) const {
    const Name* datum = value ? value->as<Name>() : nullptr;
    return datum && datum->primes == 0 ? SceneFigure::vector_symbol(datum->name) : otherwise;
  }
  static ArrowSymbol turning(const std::string& index) {
    return SceneFigure::indexed_symbol("\\boldsymbol{\\omega}", index);
  }
  static ArrowSymbol turning_rate(const std::string& index) {
    return SceneFigure::indexed_symbol("\\boldsymbol{\\alpha}", index);
  }
  static ArrowSymbol velocity(const std::string& index) { return SceneFigure::indexed_symbol("\\mathbf{v}", index); }
  static ArrowSymbol acceleration(const std::string& index) {
    return SceneFigure::indexed_symbol("\\mathbf{a}", index);
  }
  static ArrowSymbol force(const std::string& name) { return SceneFigure::named_symbol("\\mathbf{F}", name); }
  static ArrowSymbol couple(const std::string& name) { return SceneFigure::named_symbol("\\mathbf{M}", name); }
  void add(Quantity quantity, const std::string& name, const scene::Place& at, const Vector3<double>& vector,
           const ArrowSymbol& symbol) {
    if (figure_.vanishes(vector, dimension_of(quantity))) return;
    scene::Arrow arrow = figure_.arrow(quantity, name, at.body, at, vector, symbol);
    arrow.known = true;
    diagram_.arrows.push_back(std::move(arrow));
  }
  scene::Place center_of(int tree_body) const {
    const int body = figure_.scene_body(tree_body);
    if (body == scene::ground) return {};
    return {body, figure_.scene().bodies[static_cast<std::size_t>(body)].center};
  }

  void add_loads() {
    const std::vector<KnownForce<double>>& forces = figure_.mechanism().forces;
    for (std::size_t k = 0; k < forces.size() && k < situation().loads.size(); ++k) {
      const Load& load = situation().loads[k];
      const KnownForce<double>& force = forces[k];
      const int on = figure_.mechanism().actions[static_cast<std::size_t>(force.action)].on;
      const Vector3<double> vector =
          state().on_ground_axes(force.axes, force.now(figure_.mechanism().tree, state().workspace()));
      const Quantity quantity = force.couple ? Quantity::couple : Quantity::force;
      const scene::Place at = force.couple ? center_of(on) : figure_.scene_place(force.at);
      const ArrowSymbol symbol =
          force.couple ? symbol_of(load.couple, couple(load.name)) : symbol_of(load.force, this->force(load.name));
      add(quantity, load.name, at, vector, symbol);
      if (norm(vector) == 0 && !force.by_motion) add_growing(load, force, at, symbol);
    }
    for (const Joint& joint : situation().joints)
      for (std::size_t k = 0; k < joint.freedoms.size(); ++k)
        if (joint.freedoms[k].effort) add_effort(joint, joint.freedoms[k]);
  }

  // A load that is zero at first and grows with time: the sense that it has then.
  void add_growing(const Load& load, const KnownForce<double>& force, const scene::Place& at,
                   const ArrowSymbol& symbol) {
    const Expression& size = load.couple ? *load.couple : *load.force;
    if (!depends_on_time(situation(), size)) return;
    const Quantity quantity = load.couple ? Quantity::couple : Quantity::force;
    const Dimension dimension = dimension_of(quantity);
    DataScope<double>& data = figure_.data();
    constexpr double soon = 1e-3;  // s
    data.set_time(soon);
    const Vector3<double> then =
        load.direction ? data.number(size, dimension) * data.direction(*load.direction) : data.vector(size, dimension);
    data.set_time(0);
    if (!(norm(then) > 0)) return;
    scene::Arrow arrow =
        figure_.arrow(quantity, load.name, at.body, at, normalized(state().on_ground_axes(force.axes, then)), symbol);
    arrow.known = true;
    arrow.open = true;
    diagram_.arrows.push_back(std::move(arrow));
  }

  // What shakes a steady motion, by its amplitude.
  void add_excitations() {
    for (const Excitation& excitation : situation().excitations) try {
        const std::size_t before = diagram_.arrows.size();
        excitation.coordinate.empty() ? add_shaking(excitation) : add_shaken_coordinate(excitation);
        if (diagram_.arrows.size() == before) continue;
        scene::Arrow& arrow = diagram_.arrows.back();
        arrow.swings = arrow.quantity != Quantity::unbalance;
        // The same may be stated to turn ahead and back.
        if (std::any_of(diagram_.arrows.begin(), diagram_.arrows.end() - 1, [&](const scene::Arrow& other) {
              return other.symbol == arrow.symbol && other.quantity == arrow.quantity && other.body == arrow.body &&
                     norm(Vector3<double>(other.vector - arrow.vector)) == 0;
            }))
          diagram_.arrows.pop_back();
      } catch (const StatementError&) {
        // What has no value yet is not drawn.
      }
  }
  void add_shaking(const Excitation& excitation) {
    const int body = figure_.machine().index.at(excitation.body);
    const bool turning = excitation.couple.has_value();
    const Expression& size = turning            ? *excitation.couple
                             : excitation.force ? *excitation.force
                                                : *excitation.unbalance;
    const Quantity quantity = turning ? Quantity::couple : excitation.force ? Quantity::force : Quantity::unbalance;
    DataScope<double>& data = figure_.data();
    const Vector3<double> vector =
        excitation.direction ? data.number(size, dimension_of(quantity)) * data.direction(*excitation.direction)
                             : data.vector(size, dimension_of(quantity));
    const int axes = excitation.unbalance ? body : figure_.machine().index.at(excitation.axes);
    const scene::Place at = excitation.at
                                ? figure_.scene_place(figure_.machine().place(body, data.place(*excitation.at)))
                                : center_of(body);
    add(quantity, excitation.name, at, state().on_ground_axes(axes, vector),
        excitation.unbalance ? ArrowSymbol{ExplanationTex::upright(excitation.name), excitation.name}
        : turning            ? symbol_of(size, couple(excitation.name))
                             : symbol_of(size, force(excitation.name)));
  }
  void add_shaken_coordinate(const Excitation& excitation) {
    const NamedCoordinate* coordinate = figure_.machine().coordinate(excitation.coordinate);
    if (coordinate == nullptr) return;
    for (const Drive<double>& drive : figure_.mechanism().drives) {
      if (drive.coordinate != coordinate->velocity) continue;
      const Quantity quantity = drive.turning ? Quantity::angular_displacement : Quantity::displacement;
      const double size = figure_.data().number(*excitation.by, dimension_of(quantity));
      return add(quantity, excitation.name, figure_.scene_place(drive.at), size * state().direction(drive.along),
                 symbol_of(excitation.by, SceneFigure::indexed_symbol("\\mathbf{d}", excitation.name)));
    }
  }

  void add_effort(const Joint& joint, const Freedom& freedom) {
    const std::string name = joint.name + (freedom.name.empty() ? "" : "." + freedom.name);
    for (const Drive<double>& drive : figure_.mechanism().drives) {
      const Action& action = figure_.mechanism().actions[static_cast<std::size_t>(drive.action)];
      if (action.kind != ActionKind::drive || action.name != name) continue;
      Vector3<double> effort = drive.effort * state().direction(drive.along);
      for (const KnownForce<double>& force : figure_.mechanism().forces)
        if (force.action == drive.action) effort += force.now(figure_.mechanism().tree, state().workspace());
      add(drive.turning ? Quantity::couple : Quantity::force, joint.name, figure_.scene_place(drive.at), effort,
          symbol_of(freedom.effort, drive.turning ? couple(joint.name) : this->force(joint.name)));
    }
  }

  // Rates and accelerations that joints state. Each is about or along the axis of a drive.
  void add_joint_rates() {
    for (const Joint& joint : situation().joints)
      for (const Freedom& freedom : joint.freedoms) {
        const bool is_led = freedom.position && depends_on_time(situation(), *freedom.position);
        if (!freedom.rate && !freedom.accel && !is_led) continue;
        const std::string name = joint.name + (freedom.name.empty() ? "" : "." + freedom.name);
        for (const Drive<double>& drive : figure_.mechanism().drives) {
          const Action& action = figure_.mechanism().actions[static_cast<std::size_t>(drive.action)];
          if (action.kind == ActionKind::drive && action.name == name) add_rates(joint, freedom, drive);
        }
      }
  }
  void add_rates(const Joint& joint, const Freedom& freedom, const Drive<double>& drive) {
    const Vector3<double> along = state().direction(drive.along);
    const scene::Place at = figure_.scene_place(drive.at);
    // A position that is a function of time says how fast it moves.
    const bool states_rate = freedom.rate || !freedom.accel;
    for (const StatedRate& rate : figure_.machine().rates)
      if (states_rate && rate.velocity == drive.coordinate)
        add(drive.turning ? Quantity::angular_velocity : Quantity::velocity, joint.name, at, rate.value * along,
            symbol_of(freedom.rate, drive.turning ? turning(joint.name) : velocity(joint.name)));
    for (const StatedRate& rate : figure_.machine().accelerations)
      if (freedom.accel && rate.velocity == drive.coordinate)
        add(drive.turning ? Quantity::angular_acceleration : Quantity::acceleration, joint.name, at, rate.value * along,
            symbol_of(freedom.accel, drive.turning ? turning_rate(joint.name) : acceleration(joint.name)));
  }

  void add_frames() {
    for (const Frame& frame : situation().frames) {
      const int body = figure_.machine().index.at(frame.name);
      const auto& motion = state().workspace().motion[static_cast<std::size_t>(body + 1)];
      if (frame.rate)
        add(Quantity::angular_velocity, frame.name, center_of(body), motion.w,
            symbol_of(frame.rate, SceneFigure::indexed_symbol("\\boldsymbol{\\Omega}", frame.name)));
      if (frame.velocity)
        add(Quantity::velocity, frame.name, center_of(body), motion.v, symbol_of(frame.velocity, velocity(frame.name)));
      if (frame.accel && frame.turns)
        add(Quantity::angular_acceleration, frame.name, center_of(body),
            figure_.data().number(*frame.accel, dimensions::angular_acceleration) *
                figure_.data().direction(*frame.turns),
            symbol_of(frame.accel, turning_rate(frame.name)));
      if (frame.acceleration)
        add(Quantity::acceleration, frame.name, center_of(body),
            figure_.data().vector(*frame.acceleration, dimensions::acceleration),
            symbol_of(frame.acceleration, acceleration(frame.name)));
    }
  }

  // Of bodies in a steady motion, beside the turning of their frame.
  void add_spins() {
    if (!situation().steady) return;
    for (const Spin& spin : situation().steady->spins) try {
        const double rate = figure_.data().number(spin.rate, dimensions::angular_velocity);
        const Vector3<double> vector = rate * axis_of(spin);
        const ArrowSymbol symbol = symbol_of(spin.rate, turning("spin"));
        if (!is_drawn(symbol, vector))
          add(Quantity::angular_velocity, spin.body, center_of(figure_.machine().index.at(spin.body)), vector, symbol);
      } catch (const StatementError&) {
        // What has no value yet is not drawn.
      }
  }

  // Where it spins, about the axis of a joint that may have turned.
  Vector3<double> axis_of(const Spin& spin) {
    const Call* call = spin.about.as<Call>();
    if (call && call->function == "axis" && call->arguments.size() == 1) {
      const auto joint = figure_.machine().joints.find(to_string(call->arguments.front().value));
      if (joint != figure_.machine().joints.end() && joint->second.axis)
        return figure_.state().direction(*joint->second.axis);
    }
    return figure_.data().direction(spin.about);
  }

  // A joint or a frame may have stated the same.
  bool is_drawn(const ArrowSymbol& symbol, const Vector3<double>& vector) const {
    return std::any_of(diagram_.arrows.begin(), diagram_.arrows.end(), [&](const scene::Arrow& arrow) {
      return arrow.symbol == symbol.tex && figure_.vanishes(arrow.vector - vector, dimensions::angular_velocity);
    });
  }

  // Velocities that are stated of the start.
  void add_facts() {
    for (const Instant* instant : instants_at_start(situation()))
      for (const Fact& fact : instant->facts) {
        if (const Name* rate = fact.quantity.as<Name>(); rate && rate->primes == 1) add_coordinate_rate(*rate, fact);
        // A component may be stated alone, velocity(cart).x: the others are known as well.
        const Member* component = fact.quantity.as<Member>();
        const Call* call = (component ? component->object : fact.quantity).as<Call>();
        if (call == nullptr || call->arguments.empty()) continue;
        const bool turning = call->function == "angular_velocity";
        if (!turning && call->function != "velocity") continue;
        const Expression& of = call->arguments.front().value;
        const Of* point = of.as<Of>();
        const Name* body = point ? point->body.as<Name>() : of.as<Name>();
        if (body == nullptr || !figure_.machine().index.contains(body->name)) continue;
        try {
          add_velocity(turning, body->name, point, fact);
        } catch (const StatementError&) {
          // A velocity that is relative to what has no value yet is not drawn.
        }
      }
  }
  // The rate of a coordinate is a turning about the axis of its freedom or a sliding along it.
  void add_coordinate_rate(const Name& name, const Fact& fact) {
    const NamedCoordinate* coordinate = figure_.machine().coordinate(name.name);
    if (coordinate == nullptr) return;
    for (const Drive<double>& drive : figure_.mechanism().drives) {
      if (drive.coordinate != coordinate->velocity) continue;
      const double rate = state().state().v[static_cast<std::size_t>(coordinate->velocity)];
      const ArrowSymbol dotted{ExplanationTex::vector_symbol(name.name + "dot"), name.name + "'"};
      return add(drive.turning ? Quantity::angular_velocity : Quantity::velocity, coordinate->joint,
                 figure_.scene_place(drive.at), rate * state().direction(drive.along), symbol_of(fact.value, dotted));
    }
  }
  void add_velocity(bool turning, const std::string& body, const Of* point, const Fact& fact) {
    const int tree_body = figure_.machine().index.at(body);
    if (tree_body == ground) return;
    const auto& motion = state().workspace().motion[static_cast<std::size_t>(tree_body + 1)];
    scene::Place at = center_of(tree_body);
    if (point) at = figure_.scene_place(figure_.machine().place(tree_body, figure_.data().place(point->point)));
    const Vector3<double> place = figure_.on_ground(at);
    const std::string index = point ? to_string(point->point) : body;
    const Vector3<double> vector = turning ? motion.w : Vector3<double>(motion.v + cross(motion.w, place - motion.p));
    const ArrowSymbol own = turning ? this->turning(index) : velocity(index);
    const bool whole = fact.quantity.as<Member>() == nullptr;
    const Quantity quantity = turning ? Quantity::angular_velocity : Quantity::velocity;
    // Of several components the first tells the vector.
    if (!whole && std::any_of(diagram_.arrows.begin(), diagram_.arrows.end(), [&](const scene::Arrow& arrow) {
          return arrow.quantity == quantity && arrow.symbol == own.tex;
        }))
      return;
    add(quantity, body, at, vector, whole ? symbol_of(fact.value, own) : own);
  }

  void add_blows() {
    for (const StatedImpulse& impulse : figure_.machine().impulses) {
      const Action& action = figure_.mechanism().actions[static_cast<std::size_t>(impulse.action)];
      if (impulse.relative_to) {
        add(Quantity::linear_momentum, action.name, figure_.scene_place(impulse.at),
            state().on_ground_axes(*impulse.relative_to, impulse.vector), particle_symbol(action.name));
        continue;
      }
      const auto stated = std::find_if(situation().impulses.begin(), situation().impulses.end(),
                                       [&](const Impulse& one) { return one.name == action.name; });
      if (stated != situation().impulses.end() && is_to_be_found(stated->lasts)) {
        add_force_of(*stated, impulse);
        continue;
      }
      const std::optional<Expression> size = stated == situation().impulses.end() ? std::nullopt : stated->value;
      add(impulse.couple ? Quantity::angular_impulse : Quantity::impulse, action.name,
          impulse.couple ? center_of(impulse.on) : figure_.scene_place(impulse.at),
          state().on_ground_axes(impulse.axes, impulse.vector),
          symbol_of(size, SceneFigure::impulse_symbol(impulse.couple ? "\\mathbf{M}" : "\\mathbf{F}", action.name)));
    }
  }
  bool is_to_be_found(const std::optional<Expression>& value) const {
    if (!value) return false;
    std::set<std::string> names;
    collect_names(*value, names);
    return std::any_of(situation().find.begin(), situation().find.end(),
                       [&](const Unknown& unknown) { return names.contains(unknown.name); });
  }
  // How long a force acts is not told where it is to be found: of some of several it may be no time.
  void add_force_of(const Impulse& stated, const StatedImpulse& impulse) {
    const Expression& size = impulse.couple ? *stated.couple : *stated.force;
    const Dimension dimension = impulse.couple ? dimensions::moment : dimensions::force;
    DataScope<double>& data = figure_.data();
    const Vector3<double> vector = stated.direction ? data.number(size, dimension) * data.direction(*stated.direction)
                                                    : data.vector(size, dimension);
    add(impulse.couple ? Quantity::couple : Quantity::force, stated.name,
        impulse.couple ? center_of(impulse.on) : figure_.scene_place(impulse.at),
        state().on_ground_axes(impulse.axes, vector),
        symbol_of(size,
                  impulse.couple ? couple(stated.name) : SceneFigure::indexed_symbol("\\mathbf{F}", stated.name)));
  }
  static ArrowSymbol particle_symbol(const std::string& name) {
    return {"m\\mathbf{v}_{" + ExplanationTex::upright(name) + "}", "m v_" + name};
  }

  SceneFigure& figure_;
  scene::Diagram diagram_;
};

}  // namespace

scene::Diagram model_diagram(SceneFigure& figure) { return ModelDiagram(figure).made(); }

}  // namespace poinsot::problem
