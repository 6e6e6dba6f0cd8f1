#include "statement/machine.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "poinsot/dynamics/kinematics.h"
#include "poinsot/mass/composition.h"
#include "poinsot/model/builder.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

using Vector = Vector3<double>;

// Two unit vectors across u; along the axes of the figure where they can be.
std::pair<Vector, Vector> across(const Vector& u) {
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(u[i]) < std::abs(u[smallest]) - 1e-12) smallest = i;
  const Vector first = normalized(Vector::unit(smallest) - dot(Vector::unit(smallest), u) * u);
  return {first, cross(u, first)};
}

class MachineBuilder {
 public:
  MachineBuilder(const Problem& problem, DataScope<double>& data, DataScope<TimeJet>& timed, const AnyValue& any,
                 const MachineOptions& options)
      : problem_(problem), data_(data), timed_(timed), any_(any), options_(options) {}

  Machine build() {
    machine_.index["ground"] = ground;
    machine_.drawn_origin[ground] = Vector::zero();
    for (const Body& body : problem_.bodies) masses_.push_back(body_mass(body, data_, any_, options_.lenient));
    set_gravity();
    for (const Frame& frame : problem_.frames) add_frame(frame);
    add_tree();
    machine_.mechanism.tree = builder_.build();
    machine_.mechanism.takes_part.resize(static_cast<std::size_t>(machine_.mechanism.tree.body_count()), false);
    for (const Body& body : problem_.bodies)
      machine_.mechanism.takes_part[static_cast<std::size_t>(machine_.index.at(body.name))] = true;
    for (const Joint& joint : problem_.joints) add_joint_actions(joint);
    for (const Contact& contact : problem_.contacts) add_contact(contact);
    for (const Cord& cord : problem_.cords) add_cord(cord);
    for (const Spring& spring : problem_.springs) add_spring(spring);
    for (const Load& load : problem_.loads) add_load(load);
    for (const Impulse& impulse : problem_.impulses) add_impulse(impulse);
    for (const Impact& impact : problem_.impacts) add_impact(impact);
    for (const Strike& strike : problem_.strikes) add_strike(strike);
    for (std::size_t i = 0; i < problem_.bodies.size(); ++i)
      machine_.masses.emplace_back(machine_.index.at(problem_.bodies[i].name), masses_[i]);
    return std::move(machine_);
  }

 private:
  const std::string& file() const { return problem_.file; }
  int body(const std::string& name) const { return machine_.index.at(name); }
  Direction<double> riding(int body, const Vector& direction) const { return {body, direction}; }

  void set_gravity() {
    Vector gravity = options_.open_gravity;
    if (problem_.gravity) {
      const Name* name = problem_.gravity->as<Name>();
      if (name && !data_.knows(name->name) && name->name != "none")
        fail(file(), problem_.gravity->mark(), "'" + name->name + "' is no direction for gravity",
             "write gravity: -y or gravity: none");
      if (name && name->name == "none" && name->primes == 0) {
        gravity = Vector::zero();
      } else {
        const Value<double> value = data_.value(*problem_.gravity);
        const bool direction = value.bare || same_kind(value.dimension, dimensions::none) ||
                               same_kind(value.dimension, dimensions::length);
        if (value.is_vector() && same_kind(value.dimension, dimensions::acceleration) && !value.bare)
          gravity = value.vector;
        else if (!value.is_vector() || !direction)
          fail(file(), problem_.gravity->mark(),
               "gravity is " + to_string(value.dimension) + "; expected a direction or a vector of acceleration",
               "write gravity: -y, gravity: none, or gravity: [0, -9.8 m/s^2, 0]");
        else
          gravity = data_.gravity_size() * data_.direction(*problem_.gravity);
      }
    }
    builder_.set_gravity(gravity);
  }

  // A value with its time derivatives, if the expression follows the time.
  struct Rate {
    double value = 0;
    std::optional<double> derivative, second_derivative;
  };
  Rate timed_number(const Expression& expression, const Dimension& dimension) {
    if (!depends_on_time(problem_, expression))
      return {data_.number(expression, dimension), std::nullopt, std::nullopt};
    const TimeJet value = timed_.number(expression, dimension);
    return {value.value.value, value.partial[0].value, value.partial[0].partial[0]};
  }

  int add_link(const std::string& name, int parent, const poinsot::Joint<double>& joint, const Vector& origin,
               const MassProperties<double>& mass) {
    int link = 0;
    try {
      link = builder_.add_body(name, parent, joint,
                               SpatialTransform<double>::translation(origin - machine_.drawn_origin.at(parent)),
                               translated(-origin, mass));
    } catch (const std::invalid_argument& error) {
      Mark mark{1, 1};
      for (const Body& body : problem_.bodies)
        if (body.name == name) mark = body.mark;
      fail(file(), mark, error.what());
    }
    machine_.drawn_origin[link] = origin;
    machine_.links.push_back({joint.type, parent, origin, joint.axis, joint.pitch, static_cast<int>(machine_.q.size()),
                              static_cast<int>(machine_.mechanism.coordinate_names.size())});
    for (int k = 0; k < velocity_size(joint.type); ++k) machine_.mechanism.coordinate_names.emplace_back();
    for (int k = 0; k < position_size(joint.type); ++k) {
      const bool unit_quaternion = k == 0 && position_size(joint.type) > 1;
      machine_.q.push_back(unit_quaternion ? 1 : 0);
      machine_.position_given.push_back(false);
    }
    return link;
  }
  std::size_t next_velocity() const { return machine_.mechanism.coordinate_names.size(); }

  void name_free(const std::string& owner, std::size_t first, int count) {
    for (int k = 0; k < count; ++k)
      machine_.mechanism.coordinate_names[first + k] =
          std::string(k < 3 ? "angular velocity of " : "velocity of ") + owner + " along " + problem_.axes[k % 3];
  }

  void state_rate(std::vector<StatedRate>& list, const std::string& words, std::size_t velocity, double value,
                  bool turning, const Mark& mark) {
    list.push_back({words, static_cast<int>(velocity), value, turning, mark});
  }

  void add_frame(const Frame& frame) {
    const Vector origin = frame.origin             ? data_.place(*frame.origin)
                          : frame.rides_on.empty() ? Vector::zero()
                                                   : masses_[index_of_body(frame.rides_on)].properties.center;
    const std::string owner = "frame '" + frame.name + "'";
    const std::size_t first = next_velocity();
    const bool translates = frame.velocity || frame.acceleration;
    Vector w = Vector::zero(), alpha = Vector::zero();
    if (frame.turns) {
      const Vector axis = data_.direction(*frame.turns);
      const Rate rate = timed_number(*frame.rate, dimensions::angular_velocity);
      const double accel = frame.accel ? timed_number(*frame.accel, dimensions::angular_acceleration).value
                                       : rate.derivative.value_or(0);
      w = rate.value * axis;
      alpha = accel * axis;
      if (!translates) {
        machine_.index[frame.name] =
            add_link(frame.name, ground, poinsot::Joint<double>::revolute(axis), origin, massless<double>());
        machine_.mechanism.coordinate_names[first] = "rate of " + owner;
        state_rate(machine_.rates, owner + ": rate", first, rate.value, true, frame.mark);
        state_rate(machine_.accelerations, owner + ": accel", first, accel, true, frame.mark);
        return;
      }
    }
    if (!translates) {
      machine_.index[frame.name] =
          add_link(frame.name, ground, poinsot::Joint<double>::weld(), origin, massless<double>());
      return;
    }
    machine_.index[frame.name] =
        add_link(frame.name, ground, poinsot::Joint<double>::free(), origin, massless<double>());
    name_free(owner, first, 6);
    const Vector v = frame.velocity ? data_.vector(*frame.velocity, dimensions::velocity) : Vector::zero();
    for (std::size_t k = 0; k < 3; ++k) {
      state_rate(machine_.rates, owner + ": rate", first + k, w[k], true, frame.mark);
      state_rate(machine_.accelerations, owner + ": accel", first + k, alpha[k], true, frame.mark);
      state_rate(machine_.rates, owner + ": velocity", first + 3 + k, v[k], false, frame.mark);
    }
    std::optional<Vector> stated;
    if (frame.acceleration) stated = data_.vector(*frame.acceleration, dimensions::acceleration);
    if (!stated && frame.velocity && depends_on_time(problem_, *frame.velocity)) {
      const Vector3<TimeJet> jet = timed_.vector(*frame.velocity, dimensions::velocity);
      stated = Vector{jet.x.partial[0].value, jet.y.partial[0].value, jet.z.partial[0].value};
    }
    if (!stated) return;
    // The coordinates are components on the frame's own axes: their rates are a - w x v.
    const Vector a = *stated - cross(w, v);
    for (std::size_t k = 0; k < 3; ++k)
      state_rate(machine_.accelerations, owner + ": acceleration", first + 3 + k, a[k], false, frame.mark);
  }

  static bool states_motion(const Joint& joint) {
    return std::any_of(joint.freedoms.begin(), joint.freedoms.end(), [](const Freedom& freedom) {
      return freedom.position || freedom.rate || freedom.accel || freedom.effort || freedom.stiffness ||
             freedom.damping;
    });
  }

  // Joints that reach new bodies make the tree, those that state something of their freedoms first; the others close
  // loops. Bodies that nothing reaches are free.
  void add_tree() {
    std::set<std::string> placed{"ground"};
    for (const Frame& frame : problem_.frames) placed.insert(frame.name);
    std::vector<const Joint*> waiting;
    for (const Joint& joint : problem_.joints) waiting.push_back(&joint);
    std::stable_sort(waiting.begin(), waiting.end(),
                     [](const Joint* a, const Joint* b) { return states_motion(*a) > states_motion(*b); });
    while (placed.size() < 1 + problem_.frames.size() + problem_.bodies.size()) {
      bool grown = false;
      for (auto it = waiting.begin(); it != waiting.end(); ++it) {
        const Joint& joint = **it;
        const bool from = placed.contains(joint.from), to = placed.contains(joint.to);
        if (from == to) continue;
        add_joint(joint, !from);
        placed.insert(from ? joint.to : joint.from);
        waiting.erase(it);
        grown = true;
        break;
      }
      if (grown) continue;
      // The one that holds others stands as drawn, whatever the order of the file.
      const auto waits = [&](const Body& body) { return !placed.contains(body.name); };
      const auto held = [&](const Body& body) {
        return std::any_of(waiting.begin(), waiting.end(), [&](const Joint* joint) { return joint->to == body.name; });
      };
      auto free = std::find_if(problem_.bodies.begin(), problem_.bodies.end(),
                               [&](const Body& body) { return waits(body) && !held(body); });
      if (free == problem_.bodies.end()) free = std::find_if(problem_.bodies.begin(), problem_.bodies.end(), waits);
      const std::size_t first = next_velocity();
      const std::size_t i = static_cast<std::size_t>(free - problem_.bodies.begin());
      const Vector origin = free->massless ? Vector::zero() : masses_[i].properties.center;
      machine_.index[free->name] =
          add_link(free->name, ground, poinsot::Joint<double>::free(), origin, masses_[i].properties);
      name_free(free->name, first, 6);
      placed.insert(free->name);
    }
    for (const Joint* joint : waiting) close_loop(*joint);
  }

  struct Axes {
    Vector at;
    std::vector<Vector> freedom;  // direction of each freedom
    std::optional<Vector> main;   // the joint's axis, normal or direction
  };
  Axes axes_of(const Joint& joint) {
    Axes axes;
    // Where the axis lies: `at`, the start of A->B, or the first support.
    const auto at = [&] {
      if (joint.at) return data_.place(*joint.at);
      if (const Arrow* arrow = joint.place.as<Arrow>()) return data_.place(arrow->from);
      if (!joint.supports.empty()) return support_place(joint.supports.front());
      if (joint.kind == JointKind::prismatic) return Vector::zero();
      fail(file(), joint.mark, "joint '" + joint.name + "' has a direction but no place",
           "write at: P, a point of its axis");
    };
    switch (joint.kind) {
      case JointKind::weld:
      case JointKind::ball: {
        if (joint.at) fail(file(), joint.at->mark(), "joint '" + joint.name + "' already has its point", "remove at:");
        axes.at = data_.place(joint.place);
        for (const Freedom& freedom : joint.freedoms) axes.freedom.push_back(data_.direction(*freedom.direction));
        break;
      }
      case JointKind::universal: {
        const List* list = joint.place.as<List>();
        if (!list || list->items.size() != 2)
          fail(file(), joint.place.mark(), "a universal joint has two axes", "write universal: [x, y]");
        axes.at = at();
        for (const Expression& item : list->items) axes.freedom.push_back(data_.direction(item));
        if (norm(cross(axes.freedom[0], axes.freedom[1])) < 1e-9)
          fail(file(), joint.place.mark(), "the axes of the universal joint '" + joint.name + "' are parallel");
        break;
      }
      case JointKind::planar: {
        axes.at = at();
        axes.main = data_.direction(joint.place);
        // Across a coordinate axis, the two others in their positive sense.
        auto [first, second] = across(*axes.main);
        for (std::size_t k = 0; k < 3; ++k)
          if (std::abs(std::abs((*axes.main)[k]) - 1) < 1e-12) {
            first = Vector::unit(k == 0 ? 1 : 0);
            second = Vector::unit(k == 2 ? 1 : 2);
          }
        axes.freedom = {first, second, *axes.main};
        break;
      }
      default:
        axes.at = at();
        axes.main = data_.direction(joint.place);
        axes.freedom.assign(joint.freedoms.size(), *axes.main);
    }
    return axes;
  }

  // Advance per angle, m/rad.
  double pitch_of(const Joint& joint) {
    const Value<double> value = data_.value(*joint.pitch);
    if (!value.is_number() || !same_kind(value.dimension, dimensions::length))
      fail(file(), joint.pitch->mark(), "the pitch of a screw is a length per turn", "write pitch: 2 mm/rev");
    if (value.dimension.angle == 0)
      fail(file(), joint.pitch->mark(), "is this pitch meant for a turn or for a radian?", "write pitch: 2 mm/rev");
    return value.number;
  }

  poinsot::Joint<double> link_joint(const Joint& joint, std::size_t freedom, const Vector& direction) {
    if (joint.kind == JointKind::screw) {
      return poinsot::Joint<double>::screw(direction, pitch_of(joint));
    }
    return joint.freedoms[freedom].turning ? poinsot::Joint<double>::revolute(direction)
                                           : poinsot::Joint<double>::prismatic(direction);
  }

  // Adds the links of the joint. Reversed: the body `to` is placed already and `from` hangs on it.
  void add_joint(const Joint& joint, bool reversed) {
    const Axes axes = axes_of(joint);
    const std::string& child = reversed ? joint.from : joint.to;
    int parent = body(reversed ? joint.to : joint.from);
    const std::size_t child_index = index_of_body(child);
    const MassProperties<double>& mass = masses_[child_index].properties;
    if (joint.kind == JointKind::weld || (joint.kind == JointKind::ball && joint.freedoms.empty())) {
      const std::size_t first = next_velocity();
      const bool ball = joint.kind == JointKind::ball;
      machine_.index[child] = add_link(
          child, parent, ball ? poinsot::Joint<double>::ball() : poinsot::Joint<double>::weld(), axes.at, mass);
      if (ball)
        for (std::size_t k = 0; k < 3; ++k)
          machine_.mechanism.coordinate_names[first + k] =
              "angular velocity of " + child + " at " + joint.name + " along " + problem_.axes[k];
      return;
    }
    const std::size_t n = joint.freedoms.size();
    for (std::size_t step = 0; step < n; ++step) {
      const std::size_t k = reversed ? n - 1 - step : step;
      const Freedom& freedom = joint.freedoms[k];
      const bool last = step + 1 == n;
      const Vector direction = reversed ? -axes.freedom[k] : axes.freedom[k];
      const std::size_t velocity = next_velocity();
      const std::size_t position = machine_.q.size();
      const int link = add_link(last ? child : joint.name + "." + freedom.name, parent, link_joint(joint, k, direction),
                                axes.at, last ? mass : massless<double>());
      link_of_freedom_[{joint.name, k}] = {link, parent};
      name_coordinate(joint, freedom, position, velocity);
      parent = link;
    }
    machine_.index[child] = parent;
  }

  std::size_t index_of_body(const std::string& name) const {
    for (std::size_t i = 0; i < problem_.bodies.size(); ++i)
      if (problem_.bodies[i].name == name) return i;
    return 0;
  }

  void name_coordinate(const Joint& joint, const Freedom& freedom, std::size_t position, std::size_t velocity) {
    NamedCoordinate coordinate;
    coordinate.joint = joint.name;
    coordinate.position = static_cast<int>(position);
    coordinate.velocity = static_cast<int>(velocity);
    coordinate.turning = freedom.turning;
    coordinate.mark = freedom.mark;
    const std::string owner = "joint '" + joint.name + "'" + (freedom.name.empty() ? "" : ", " + freedom.name);
    if (freedom.position) {
      const Name* name = freedom.position->as<Name>();
      const bool named = name && name->primes == 0 && name->name != "pi" && name->name != "any";
      const bool valued = !named || data_.knows(name->name);
      if (named) {
        coordinate.name = name->name;
        coordinate.mark = freedom.position->mark();
        for (const NamedCoordinate& other : machine_.coordinates)
          if (other.name == coordinate.name)
            fail(file(), coordinate.mark, "two coordinates have the name '" + coordinate.name + "'",
                 "rename one of them");
      }
      if (valued) {
        const Rate value = timed_number(*freedom.position, freedom.turning ? dimensions::angle : dimensions::length);
        machine_.q[position] = value.value;
        machine_.position_given[position] = true;
        if (value.derivative) {
          const std::string words = owner + ": position as a function of time";
          state_rate(machine_.rates, words, velocity, *value.derivative, freedom.turning, freedom.position->mark());
          state_rate(machine_.accelerations, words, velocity, *value.second_derivative, freedom.turning,
                     freedom.position->mark());
        }
      }
    }
    machine_.mechanism.coordinate_names[velocity] =
        "the rate of " + (coordinate.name.empty() ? owner : "'" + coordinate.name + "' at " + owner);
    if (freedom.rate) {
      const Rate rate =
          timed_number(*freedom.rate, freedom.turning ? dimensions::angular_velocity : dimensions::velocity);
      state_rate(machine_.rates, owner + ": rate", velocity, rate.value, freedom.turning, freedom.rate->mark());
      if (rate.derivative && !freedom.accel)
        state_rate(machine_.accelerations, owner + ": rate as a function of time", velocity, *rate.derivative,
                   freedom.turning, freedom.rate->mark());
    }
    if (freedom.accel)
      state_rate(
          machine_.accelerations, owner + ": accel", velocity,
          timed_number(*freedom.accel, freedom.turning ? dimensions::angular_acceleration : dimensions::acceleration)
              .value,
          freedom.turning, freedom.accel->mark());
    machine_.coordinates.push_back(std::move(coordinate));
  }

  // A joint whose bodies are both placed: what it does not allow becomes constraints.
  void close_loop(const Joint& joint) {
    if (states_motion(joint))
      fail(file(), joint.mark,
           "joint '" + joint.name + "' closes a loop, and all its bodies are already placed by other joints",
           "state angles, rates and couples at the other joints of the loop");
    machine_.loop_joints.push_back(joint.name);
    loops_.push_back(&joint);
  }

  int add_action(ActionKind kind, const std::string& name, const std::string& joint, int on, int from) {
    machine_.mechanism.actions.push_back({kind, name, joint, on, from});
    return static_cast<int>(machine_.mechanism.actions.size()) - 1;
  }
  Component<double> component(int action, const std::string& axis, bool couple, const Place<double>& at,
                              const Direction<double>& along) {
    Component<double> c;
    c.action = action;
    c.axis = axis;
    c.couple = couple;
    c.at = at;
    c.along = along;
    return c;
  }
  // The name of a direction as drawn, if it has a short one.
  std::string direction_name(const Vector& d) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(std::abs(d[k]) - 1) < 1e-9) return problem_.axes[k];
    char text[80];
    std::snprintf(text, sizeof text, "[%.3g, %.3g, %.3g]", d.x, d.y, d.z);
    return text;
  }

  // What a joint can carry: forces and couples along these directions as drawn.
  struct Carried {
    std::vector<Vector> forces, couples;
    std::optional<double> screw;  // couple per force along the axis
  };
  static Carried carried_by(JointKind kind, const Axes& axes, double pitch) {
    const std::vector<Vector> all{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
    std::vector<Vector> sides;
    if (axes.main) {
      const auto [a, b] = across(*axes.main);
      sides = {a, b};
    }
    switch (kind) {
      case JointKind::weld:
        return {all, all, {}};
      case JointKind::revolute:
        return {all, sides, {}};
      case JointKind::prismatic:
        return {sides, all, {}};
      case JointKind::cylindrical:
        return {sides, sides, {}};
      case JointKind::universal:
        return {all, {normalized(cross(axes.freedom[0], axes.freedom[1]))}, {}};
      case JointKind::ball:
        return {all, {}, {}};
      case JointKind::planar:
        return {{*axes.main}, sides, {}};
      case JointKind::screw:
        return {sides, sides, -pitch};
    }
    return {};
  }

  void add_joint_actions(const Joint& joint) {
    const Axes axes = axes_of(joint);
    const int to = body(joint.to), from = body(joint.from);
    const Place<double> at = machine_.place(to, axes.at);
    JointPlace place{at, std::nullopt, from, to};
    if (axes.main) place.axis = riding(from, *axes.main);
    machine_.joints[joint.name] = place;
    const double pitch = joint.kind == JointKind::screw ? pitch_of(joint) : 0;
    const Carried carried = carried_by(joint.kind, axes, pitch);
    // The couple of a universal joint stands across both axes, which the link between them carries.
    const int couple_body =
        joint.kind == JointKind::universal && link_of_freedom_.contains({joint.name, 0}) ? middle_link(joint) : from;
    if (!joint.supports_stated) {
      const int action = add_action(ActionKind::joint, joint.name, "", to, from);
      for (const Vector& d : carried.forces)
        machine_.mechanism.components.push_back(component(action, direction_name(d), false, at, riding(from, d)));
      for (const Vector& d : carried.couples)
        machine_.mechanism.components.push_back(component(action, direction_name(d), true, at, riding(couple_body, d)));
      if (carried.screw) {
        machine_.mechanism.components.push_back(
            component(action, direction_name(*axes.main), false, at, riding(from, *axes.main)));
        machine_.mechanism.components.back().couple_per_force = *carried.screw;
      }
    } else {
      for (const Support& support : joint.supports) add_support(joint, support, axes, to, from);
    }
    add_drives(joint, axes, at, to, from);
    if (std::find(loops_.begin(), loops_.end(), &joint) == loops_.end()) return;
    for (const Vector& d : carried.forces)
      add_constraint(VelocityConstraintKind::point, "joint '" + joint.name + "' along " + direction_name(d), to, from,
                     at, d);
    for (const Vector& d : carried.couples)
      add_constraint(VelocityConstraintKind::angular, "joint '" + joint.name + "' about " + direction_name(d), to, from,
                     at, d);
    if (joint.kind == JointKind::universal || joint.kind == JointKind::screw || joint.kind == JointKind::planar)
      fail(file(), joint.mark, "joint '" + joint.name + "' closes a loop, which a joint of this kind cannot do here",
           "let it stand first and close the loop with a revolute, ball, weld, prismatic or cylindrical joint");
  }

  int middle_link(const Joint& joint) const {
    const auto& [first, first_parent] = link_of_freedom_.at({joint.name, 0});
    const auto& [second, second_parent] = link_of_freedom_.at({joint.name, 1});
    return second_parent == first ? first : second;
  }

  Vector support_place(const Support& support) {
    return data_.place(support.at ? *support.at : parse_expression(support.name, file(), support.mark));
  }

  void add_support(const Joint& joint, const Support& support, const Axes& axes, int to, int from) {
    const Place<double> at = machine_.place(to, support_place(support));
    const int action = add_action(ActionKind::support, support.name, joint.name, to, from);
    std::vector<std::pair<std::string, Vector>> forces, couples;
    if (support.kind.empty()) {
      for (const Expression& e : support.forces) forces.emplace_back(to_string(e), data_.direction(e));
      for (const Expression& e : support.couples) couples.emplace_back(to_string(e), data_.direction(e));
    } else {
      const bool along_axis = support.kind != "journal" && support.kind != "collar";
      const bool with_couples = support.kind != "journal" && support.kind != "thrust" && support.kind != "ball";
      if (!axes.main && support.kind != "ball")
        fail(file(), support.mark,
             "joint '" + joint.name + "' has no axis: its support '" + support.name + "' cannot be a " + support.kind,
             "list the directions that it carries");
      std::vector<Vector> directions{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
      if (axes.main) {
        const auto [a, b] = across(*axes.main);
        directions = {a, b};
        if (along_axis) directions.push_back(*axes.main);
        if (with_couples)
          for (const Vector& d : {a, b}) couples.emplace_back(direction_name(d), d);
      }
      for (const Vector& d : directions) forces.emplace_back(direction_name(d), d);
    }
    const auto add = [&](const std::vector<std::pair<std::string, Vector>>& list, bool couple) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
          if (norm(cross(list[i].second, list[j].second)) < 1e-9)
            fail(file(), support.mark,
                 "support '" + support.name + "' lists the direction " + list[i].first + " twice");
        machine_.mechanism.components.push_back(
            component(action, list[i].first, couple, at, riding(from, list[i].second)));
      }
    };
    add(forces, false);
    add(couples, true);
  }

  void add_drives(const Joint& joint, const Axes& axes, const Place<double>& at, int to, int from) {
    for (std::size_t k = 0; k < joint.freedoms.size(); ++k) {
      const Freedom& freedom = joint.freedoms[k];
      const auto link = link_of_freedom_.find({joint.name, k});
      if (link == link_of_freedom_.end()) continue;
      const int moved = link->second.first;
      Drive<double> drive;
      drive.coordinate = machine_.mechanism.tree.body(moved).v;
      drive.position = machine_.mechanism.tree.body(moved).q;
      drive.turning = freedom.turning;
      drive.at = at;
      // The axis rides with both bodies of its link; on the sense of `to` relative to `from` in either case.
      drive.along = riding(moved, axes.freedom[k]);
      for (std::size_t other = 0; freedom.turning && other < joint.freedoms.size(); ++other) {
        const auto found = link_of_freedom_.find({joint.name, other});
        if (other != k && joint.freedoms[other].turning && found != link_of_freedom_.end())
          drive.others.push_back(riding(found->second.first, axes.freedom[other]));
      }
      const bool accel_known =
          std::any_of(machine_.accelerations.begin(), machine_.accelerations.end(),
                      [&](const StatedRate& stated) { return stated.velocity == drive.coordinate; });
      drive.held = accel_known && !freedom.effort && !freedom.stiffness && !freedom.damping;
      const Dimension effort = freedom.turning ? dimensions::moment : dimensions::force;
      const Dimension position = freedom.turning ? dimensions::angle : dimensions::length;
      if (freedom.effort) drive.effort = timed_number(*freedom.effort, effort).value;
      if (freedom.stiffness) drive.stiffness = data_.number(*freedom.stiffness, effort / position);
      if (freedom.free_position) drive.free_position = data_.number(*freedom.free_position, position);
      if (freedom.damping) drive.damping = data_.number(*freedom.damping, effort / position * dimensions::time);
      for (const auto& [expression, value] :
           {std::pair{&freedom.stiffness, drive.stiffness}, std::pair{&freedom.damping, drive.damping}})
        if (value < 0)
          fail(file(), (*expression)->mark(), "joint '" + joint.name + "': stiffness and damping are not negative");
      drive.action = add_action(ActionKind::drive, joint.name + (freedom.name.empty() ? "" : "." + freedom.name),
                                joint.name, to, from);
      machine_.mechanism.drives.push_back(drive);
    }
  }

  void add_constraint(VelocityConstraintKind kind, const std::string& words, int on, int from, const Place<double>& at,
                      const Vector& drawn) {
    VelocityConstraint<double> c;
    c.kind = kind;
    c.words = words;
    c.on = on;
    c.from = from;
    c.at = at;
    c.along = riding(from, drawn);
    c.toward = machine_.place(from, at.point + machine_.drawn_origin.at(on));
    machine_.mechanism.constraints.push_back(c);
  }

  void add_contact(const Contact& contact) {
    const int on = body(contact.of), from = body(contact.against);
    const Vector C = data_.place(contact.at), n = data_.direction(contact.normal);
    const Place<double> at = machine_.place(on, C);
    const int action = add_action(ActionKind::contact, contact.name, "", on, from);
    const auto [t1, t2] = across(n);
    // The forces that it carries.
    std::vector<std::pair<std::string, Vector>> directions;
    if (contact.carries) {
      for (const Expression& e : *contact.carries) {
        const Name* name = e.as<Name>();
        if (name && name->name == "push")
          directions.emplace_back("push", n);
        else
          directions.emplace_back(to_string(e), data_.direction(e));
      }
    } else {
      directions.emplace_back(direction_name(n), n);
      if (contact.no_slip) {
        directions.emplace_back(direction_name(t1), t1);
        directions.emplace_back(direction_name(t2), t2);
      }
    }
    for (const auto& [name, d] : directions) {
      machine_.mechanism.components.push_back(component(action, name, false, at, riding(from, d)));
      machine_.mechanism.components.back().one_sided = norm(d - n) < 1e-9;
    }
    // The motion that it forbids.
    const Body& stated = problem_.bodies[index_of_body(contact.of)];
    const RollingSurface surface =
        rolling_surface(stated, data_, C, masses_[index_of_body(contact.of)].properties.center);
    if (surface.shape == ContactShape::missed) {
      char text[120];
      std::snprintf(text, sizeof text, "%.3g m off the surface of '%s'", surface.gap, contact.of.c_str());
      fail(file(), contact.at.mark(), "contact '" + contact.name + "' is " + text, "correct the point under at:");
    }
    // What it touches may be curved as well.
    bool unknown = surface.shape == ContactShape::unknown;
    if (machine_.mechanism.takes_part.size() > static_cast<std::size_t>(std::max(from, 0)) && from != ground &&
        machine_.mechanism.takes_part[static_cast<std::size_t>(from)]) {
      const std::size_t other = index_of_body(contact.against);
      const RollingSurface below = rolling_surface(problem_.bodies[other], data_, C, masses_[other].properties.center);
      // A flat side of a round body shows its axis along the normal.
      unknown = unknown || (below.shape == ContactShape::round && norm(cross(below.axis, n)) > 1e-9) ||
                below.shape == ContactShape::unknown || (below.shape == ContactShape::round && norm(below.axis) == 0);
    }
    const bool round = surface.shape == ContactShape::round;
    const auto forbid = [&](const Vector& d) {
      const std::string words = std::string(contact.no_slip ? "rolling" : "touching") + " at contact '" + contact.name +
                                "' along " + direction_name(d);
      add_constraint(round ? VelocityConstraintKind::rolling : VelocityConstraintKind::point, words, on, from, at, d);
      VelocityConstraint<double>& c = machine_.mechanism.constraints.back();
      c.action = action;
      c.surface_axis = riding(from, n);
      c.shape_unknown = unknown;
      if (!round) return;
      c.center = machine_.place(on, surface.center).point;
      c.axis = surface.axis;
      c.radius = surface.radius;
    };
    forbid(n);
    machine_.mechanism.constraints.back().normal = true;
    if (contact.no_slip) {
      forbid(t1);
      forbid(t2);
    }
  }

  void add_cord(const Cord& cord) {
    const int on = body(cord.to), from = body(cord.from);
    const int action = add_action(ActionKind::cord, cord.name, "", on, from);
    const Vector end = data_.place(*cord.end);
    const Place<double> at = machine_.place(on, end);
    if (cord.direction) {
      const Vector d = data_.direction(*cord.direction);
      machine_.mechanism.components.push_back(component(action, "", false, at, riding(ground, d)));
      machine_.mechanism.components.back().one_sided = true;
      add_constraint(VelocityConstraintKind::point, "cord '" + cord.name + "' taut", on, from, at, d);
      machine_.mechanism.constraints.back().action = action;
      return;
    }
    const Vector start = data_.place(*cord.at);
    if (!(norm(end - start) > 0)) fail(file(), cord.mark, "cord '" + cord.name + "' has length zero");
    Component<double> c = component(action, "", false, at, riding(ground, normalized(start - end)));
    c.toward = machine_.place(from, start);
    c.one_sided = true;
    machine_.mechanism.components.push_back(c);
    add_constraint(VelocityConstraintKind::cord_length, "cord '" + cord.name + "' taut", on, from, at,
                   normalized(start - end));
    machine_.mechanism.constraints.back().toward = machine_.place(from, start);
    machine_.mechanism.constraints.back().length = norm(end - start);
    machine_.mechanism.constraints.back().action = action;
  }

  void add_spring(const Spring& spring) {
    SpringLaw<double> law;
    const int on = body(spring.to), from = body(spring.from);
    law.action = add_action(ActionKind::spring, spring.name, "", on, from);
    const Vector start = data_.place(spring.at), end = data_.place(spring.end);
    law.at = machine_.place(on, end);
    law.toward = machine_.place(from, start);
    const double drawn = norm(end - start);
    if (!(drawn > 0))
      fail(file(), spring.mark, "spring '" + spring.name + "' has length zero as drawn: it has no direction");
    if (spring.stiffness) {
      law.stiffness = data_.number(*spring.stiffness, dimensions::stiffness);
      if (!(law.stiffness > 0))
        fail(file(), spring.stiffness->mark(), "the stiffness of spring '" + spring.name + "' must be positive");
      law.free_length = spring.free_length ? data_.number(*spring.free_length, dimensions::length)
                                           : drawn - data_.number(*spring.tension, dimensions::force) / law.stiffness;
      if (!(law.free_length >= 0)) fail(file(), spring.mark, "spring '" + spring.name + "' has a negative free length");
    }
    if (spring.damping) {
      law.damping = data_.number(*spring.damping, dimensions::stiffness * dimensions::time);
      if (law.damping < 0) fail(file(), spring.damping->mark(), "the damping of '" + spring.name + "' is negative");
    }
    machine_.mechanism.springs.push_back(law);
  }

  void add_load(const Load& load) {
    KnownForce<double> force;
    const int on = body(load.body);
    force.action = add_action(ActionKind::load, load.name, "", on, ground);
    force.couple = load.couple.has_value();
    force.axes = body(load.axes);
    const Expression& size = load.couple ? *load.couple : *load.force;
    const Dimension dimension = load.couple ? dimensions::moment : dimensions::force;
    if (options_.loads &&
        std::find(options_.loads->begin(), options_.loads->end(), load.name) == options_.loads->end()) {
      force.vector = Vector::zero();
    } else if (load.direction) {
      force.vector = data_.number(size, dimension) * data_.direction(*load.direction);
    } else {
      force.vector = data_.vector(size, dimension);
    }
    if (!force.couple) {
      const Body& stated = problem_.bodies[index_of_body(load.body)];
      if (!load.at && stated.massless)
        fail(file(), load.mark, "load '" + load.name + "' needs the point at which it acts: the body is massless",
             "write at: P");
      force.at =
          machine_.place(on, load.at ? data_.place(*load.at) : masses_[index_of_body(load.body)].properties.center);
    }
    machine_.mechanism.forces.push_back(force);
  }

  void add_impulse(const Impulse& impulse) {
    StatedImpulse stated;
    stated.on = body(impulse.body);
    stated.action = add_action(ActionKind::impulse, impulse.name, "", stated.on, ground);
    stated.axes = body(impulse.axes);
    stated.couple = impulse.couple.has_value();
    const Expression& size = impulse.value ? *impulse.value : impulse.force ? *impulse.force : *impulse.couple;
    const double duration = impulse.lasts ? data_.number(*impulse.lasts, dimensions::time) : 1;
    if (duration < 0) fail(file(), impulse.lasts->mark(), "impulse '" + impulse.name + "' lasts a negative time");
    Dimension dimension = stated.couple ? dimensions::moment : dimensions::force;
    if (!impulse.lasts) dimension = dimension * dimensions::time;
    stated.vector = duration * (impulse.direction ? data_.number(size, dimension) * data_.direction(*impulse.direction)
                                                  : data_.vector(size, dimension));
    if (!stated.couple)
      stated.at = impulse_place(impulse.body, impulse.at, "impulse '" + impulse.name + "'", impulse.mark);
    machine_.impulses.push_back(stated);
  }
  Place<double> impulse_place(const std::string& on, const std::optional<Expression>& at, const std::string& owner,
                              const Mark& mark) {
    const std::size_t i = index_of_body(on);
    if (!at && problem_.bodies[i].massless)
      fail(file(), mark, owner + " needs the point at which it acts: the body is massless", "write at: P");
    return machine_.place(body(on), at ? data_.place(*at) : masses_[i].properties.center);
  }

  void add_impact(const Impact& impact) {
    solve::Impact struck;
    struck.name = impact.name;
    struck.on = body(impact.of);
    struck.from = body(impact.against);
    struck.action = add_action(ActionKind::impact, impact.name, "", struck.on, struck.from);
    struck.at = machine_.place(struck.on, data_.place(impact.at));
    struck.push = riding(struck.from, data_.direction(impact.pushes));
    if (impact.restitution) struck.restitution = data_.number(*impact.restitution, dimensions::none);
    if (struck.restitution < 0 || struck.restitution > 1)
      fail(file(), impact.restitution->mark(), "a coefficient of restitution lies between 0 and 1");
    machine_.impacts.push_back(struck);
  }

  void add_strike(const Strike& strike) {
    const std::string owner = "strike '" + strike.name + "'";
    const double mass = strike.amount.mass
                            ? data_.number(*strike.amount.mass, dimensions::mass)
                            : data_.number(*strike.amount.weight, dimensions::force) / data_.gravity_size();
    if (!(mass >= 0)) fail(file(), strike.mark, owner + ": the mass of the particle is negative");
    StatedImpulse stated;
    stated.on = body(strike.hits);
    stated.action = add_action(ActionKind::impulse, strike.name, "", stated.on, ground);
    stated.at = machine_.place(stated.on, data_.place(strike.at));
    stated.vector = mass * data_.vector(strike.velocity, dimensions::velocity);
    stated.relative_to = body(strike.relative_to);
    if (strike.loses) {
      const double loss = data_.number(*strike.loses, dimensions::none);
      if (loss < 0 || loss > 1)
        fail(file(), strike.loses->mark(), owner + ": a particle loses between 0 and 100 % of its speed");
      stated.kept = 1 - loss;
    }
    stated.absorbed = strike.stays && !strike.mass_neglected ? mass : 0;
    stated.particle_mass = mass;
    machine_.impulses.push_back(stated);
  }

  const Problem& problem_;
  DataScope<double>& data_;
  DataScope<TimeJet>& timed_;
  const AnyValue& any_;
  const MachineOptions& options_;
  ModelBuilder<double> builder_;
  Machine machine_;
  std::vector<BodyMass> masses_;
  std::map<std::pair<std::string, std::size_t>, std::pair<int, int>> link_of_freedom_;
  std::vector<const Joint*> loops_;
};

}  // namespace

Place<double> Machine::place(int body, const Vector3<double>& drawn) const {
  return {body, drawn - drawn_origin.at(body)};
}

const NamedCoordinate* Machine::coordinate(const std::string& name) const {
  for (const NamedCoordinate& c : coordinates)
    if (c.name == name) return &c;
  return nullptr;
}

std::vector<std::size_t> Machine::actions_of(const std::string& name, const std::string& joint) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    const bool of_joint =
        (action.kind == ActionKind::support || action.kind == ActionKind::drive) && action.joint == name;
    const bool itself =
        action.kind != ActionKind::drive && action.name == name && (joint.empty() || action.joint == joint);
    if (of_joint || itself) found.push_back(i);
  }
  return found;
}

Machine build_machine(const Problem& problem, DataScope<double>& data, DataScope<TimeJet>& timed, const AnyValue& any,
                      const MachineOptions& options) {
  return MachineBuilder(problem, data, timed, any, options).build();
}

}  // namespace poinsot::statement
