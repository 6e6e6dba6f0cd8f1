// Random problems as data, and their texts as problem files: in any units, on any axes, in any order.
//
// The test knows the physics as numbers in SI; a Style says how an author might write the same down.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/shapes.h"
#include "problem/answers/solve_statement.h"
#include "problem/entries/statement.h"

namespace poinsot::problem::testing {

using poinsot::testing::Random;
using Vector = Vector3<double>;

// A unit by its name and size in SI.
struct NamedUnit {
  std::string name;
  double size;
};

// The system in which a statement is written.
struct UnitSystem {
  NamedUnit length{"m", 1}, mass{"kg", 1}, force{"N", 1}, angle{"rad", 1};

  NamedUnit velocity() const { return {length.name + "/s", length.size}; }
  NamedUnit acceleration() const { return {length.name + "/s^2", length.size}; }
  NamedUnit rate() const { return {angle.name + "/s", angle.size}; }
  NamedUnit angular_acceleration() const { return {angle.name + "/s^2", angle.size}; }
  NamedUnit moment() const { return {force.name + "*" + length.name, force.size * length.size}; }
  NamedUnit stiffness() const { return {force.name + "/" + length.name, force.size / length.size}; }
  NamedUnit damping() const { return {force.name + "*s/" + length.name, force.size / length.size}; }
  NamedUnit turning_stiffness() const {
    return {force.name + "*" + length.name + "/" + angle.name, force.size * length.size / angle.size};
  }
  NamedUnit turning_damping() const {
    return {force.name + "*" + length.name + "*s/" + angle.name, force.size * length.size / angle.size};
  }
};

inline const std::vector<UnitSystem>& unit_systems() {
  constexpr double degree = std::numbers::pi / 180, pound = 4.4482216152605;
  static const std::vector<UnitSystem> systems{
      {},
      {{"mm", 1e-3}, {"g", 1e-3}, {"kN", 1e3}, {"deg", degree}},
      {{"cm", 1e-2}, {"t", 1e3}, {"mN", 1e-3}, {"rev", 2 * std::numbers::pi}},
      {{"ft", 0.3048}, {"slug", pound / 0.3048}, {"lb", pound}, {"rad", 1}},
      {{"in", 0.0254}, {"lbm", 0.45359237}, {"oz", pound / 16}, {"deg", degree}},
  };
  return systems;
}

// How the same problem is written down.
struct Style {
  UnitSystem units;
  Matrix3<double> R = Matrix3<double>::identity();  // the figure is turned, then shifted
  Vector shift{};
  std::optional<std::uint64_t> order;  // of bodies, joints, loads and springs; as they are when left out

  std::string number(double value, const NamedUnit& unit) const {
    return fmt::format("{:.17g} {}", value / unit.size, unit.name);
  }
  std::string plain(const Vector& a) const { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", a.x, a.y, a.z); }
  std::string vector(const Vector& a, const NamedUnit& unit) const {
    const Vector b = R * a;
    return "[" + number(b.x, unit) + ", " + number(b.y, unit) + ", " + number(b.z, unit) + "]";
  }
  std::string direction(const Vector& a) const { return plain(R * a); }
  std::string place(const Vector& a) const {
    const Vector b = R * a + shift;
    return "[" + number(b.x, units.length) + ", " + number(b.y, units.length) + ", " + number(b.z, units.length) + "]";
  }

  template <class Item>
  std::vector<Item> ordered(std::vector<Item> items) const {
    if (order) {
      std::mt19937_64 engine(*order);
      std::shuffle(items.begin(), items.end(), engine);
    }
    return items;
  }
};

// A uniform shape with its mass, and what it is worth as mass properties.
struct PartData {
  enum class Shape { rod, disk, box, sphere, particle, cylinder, triangle };
  Shape shape = Shape::rod;
  double mass = 1;
  Vector a{}, b{}, c{}, d{};
  double radius = 0, length = 0;

  std::string text(const Style& style) const {
    const std::string amount = ", mass: " + style.number(mass, style.units.mass);
    const auto r = [&] { return style.number(radius, style.units.length); };
    switch (shape) {
      case Shape::rod:
        return "rod: [" + style.place(a) + ", " + style.place(b) + "]" + amount;
      case Shape::disk:
        return "disk: {center: " + style.place(a) + ", normal: " + style.direction(b) + ", radius: " + r() + "}" +
               amount;
      case Shape::box:
        return "box: {center: " + style.place(a) + ", sides: [" + style.vector(b, style.units.length) + ", " +
               style.vector(c, style.units.length) + ", " + style.vector(d, style.units.length) + "]}" + amount;
      case Shape::sphere:
        return "sphere: {center: " + style.place(a) + ", radius: " + r() + "}" + amount;
      case Shape::particle:
        return "particle: " + style.place(a) + amount;
      case Shape::cylinder:
        return "cylinder: {center: " + style.place(a) + ", axis: " + style.direction(b) + ", radius: " + r() +
               ", length: " + style.number(length, style.units.length) + "}" + amount;
      case Shape::triangle:
        return "triangle: [" + style.place(a) + ", " + style.place(b) + ", " + style.place(c) + "]" + amount;
    }
    return "";
  }

  MassProperties<double> properties() const {
    switch (shape) {
      case Shape::rod:
        return of_mass(shapes::rod(a, b), mass);
      case Shape::disk:
        return of_mass(shapes::disk(a, b, radius), mass);
      case Shape::box:
        return of_mass(shapes::box(a, b, c, d), mass);
      case Shape::sphere:
        return of_mass(shapes::sphere(a, radius), mass);
      case Shape::particle:
        return of_mass(shapes::particle(a), mass);
      case Shape::cylinder: {
        const Vector half = 0.5 * length * normalized(b);
        return of_mass(shapes::cylinder(Vector(a - half), Vector(a + half), radius), mass);
      }
      case Shape::triangle:
        return of_mass(shapes::triangle(a, b, c), mass);
    }
    return {};
  }
};

inline PartData random_part(Random& random, const Vector& near) {
  PartData part;
  part.shape = static_cast<PartData::Shape>(random.integer(0, 6));
  part.mass = random.uniform(0.2, 3);
  part.a = near + random.vector(0.7);
  part.radius = random.uniform(0.1, 0.5);
  part.length = random.uniform(0.2, 1);
  switch (part.shape) {
    case PartData::Shape::rod:
      part.b = part.a + random.uniform(0.3, 1) * random.direction();
      break;
    case PartData::Shape::triangle: {
      const Matrix3<double> turn = random.rotation();
      part.b = part.a + turn * Vector{random.uniform(0.3, 1), 0, 0};
      part.c = part.a + turn * Vector{random.uniform(-0.5, 0.5), random.uniform(0.3, 1), 0};
      break;
    }
    case PartData::Shape::box: {
      const Matrix3<double> turn = random.rotation();
      part.b = random.uniform(0.1, 1) * turn.column(0);
      part.c = random.uniform(0.1, 1) * turn.column(1);
      part.d = random.uniform(0.1, 1) * turn.column(2);
      break;
    }
    default:
      part.b = random.uniform(0.5, 2) * random.direction();
  }
  return part;
}

struct BodyData {
  std::string name;
  std::vector<PartData> parts;  // none: massless

  MassProperties<double> properties() const {
    std::vector<MassProperties<double>> list;
    for (const PartData& part : parts) list.push_back(part.properties());
    return list.empty() ? massless<double>() : sum(list);
  }
  std::string text(const Style& style) const {
    if (parts.empty()) return "massless";
    if (parts.size() == 1) return "{" + parts.front().text(style) + "}";
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < parts.size(); ++i) lines.push_back(fmt::format("p{}: {{{}}}", i, parts[i].text(style)));
    std::string all;
    for (const std::string& line : style.ordered(lines)) all += (all.empty() ? "" : ", ") + line;
    return "{parts: {" + all + "}}";
  }
};

// Motion side and force side of one freedom.
struct FreedomData {
  std::string name;
  bool turning = true;
  Vector axis{};
  double position = 0;
  std::optional<double> rate;
  std::optional<double> accel, effort;
  double stiffness = 0, free_position = 0, damping = 0;

  std::string text(const Style& style) const {
    const UnitSystem& u = style.units;
    std::string all;
    const auto add = [&](const std::string& entry) { all += (all.empty() ? "" : ", ") + entry; };
    const NamedUnit place = turning ? u.angle : u.length;
    if (position != 0) add(std::string(turning ? "angle: " : "displacement: ") + style.number(position, place));
    if (rate) add("rate: " + style.number(*rate, turning ? u.rate() : u.velocity()));
    if (accel) add("accel: " + style.number(*accel, turning ? u.angular_acceleration() : u.acceleration()));
    if (effort)
      add(std::string(turning ? "couple: " : "force: ") + style.number(*effort, turning ? u.moment() : u.force));
    if (stiffness != 0)
      add("spring: {stiffness: " + style.number(stiffness, turning ? u.turning_stiffness() : u.stiffness()) + ", " +
          (turning ? "free_angle: " : "free_displacement: ") + style.number(free_position, place) + "}");
    if (damping != 0) add("damping: " + style.number(damping, turning ? u.turning_damping() : u.damping()));
    return all;
  }
};

struct JointData {
  std::string name, kind;  // kind: as in the language, or "free": no joint at all, "angles": a ball with ordered angles
  std::string from = "ground", to;
  Vector at{}, axis{}, second{};
  double pitch = 0;
  std::vector<FreedomData> freedoms;
  Vector w{}, v{};     // of a ball and of a free body, in the ground: angular velocity, and velocity of the point `at`
  bool stated = true;  // whether they are stated

  std::string text(const Style& style) const {
    std::string all;
    if (kind == "weld" || kind == "ball" || kind == "angles")
      all = (kind == "angles" ? "ball" : kind) + ": " + style.place(at);
    else if (kind == "universal")
      all = "universal: [" + style.direction(axis) + ", " + style.direction(second) + "], at: " + style.place(at);
    else
      all = kind + ": " + style.direction(axis) + ", at: " + style.place(at);
    if (kind == "screw")
      all += ", pitch: " + style.number(pitch, {style.units.length.name + "/rad", style.units.length.size});
    if (from != "ground") all += ", from: " + from;
    all += ", to: " + to;
    if (kind == "angles") {
      std::string list;
      for (const FreedomData& f : freedoms)
        list += (list.empty() ? "" : ", ") + f.name + ": " + style.direction(f.axis);
      all += ", angles: [" + list + "]";
    }
    if (freedoms.size() == 1) {
      const std::string own = freedoms.front().text(style);
      if (!own.empty()) all += ", " + own;
    } else if (!freedoms.empty()) {
      std::string list;
      for (FreedomData f : freedoms) {
        if (kind == "angles") f.position = 0;  // a fact: the angle's name stands for it
        const std::string own = f.text(style);
        if (!own.empty()) list += (list.empty() ? "" : ", ") + f.name + ": {" + own + "}";
      }
      if (!list.empty()) all += ", freedoms: {" + list + "}";
    }
    return "{" + all + "}";
  }
};

struct LoadData {
  std::string body;
  bool couple = false;
  bool turns_along = false;  // on the axes of the body, that is
  Vector vector{}, at{};

  std::string text(const Style& style) const {
    const UnitSystem& u = style.units;
    return "{" +
           (couple ? "couple: " + style.vector(vector, u.moment())
                   : "force: " + style.vector(vector, u.force) + ", at: " + style.place(at)) +
           ", body: " + body + (turns_along ? ", axes: " + body : "") + "}";
  }
};

struct SpringData {
  std::string from = "ground", to;
  Vector at{}, end{};
  double stiffness = 1, free_length = 0, damping = 0;

  std::string text(const Style& style) const {
    const UnitSystem& u = style.units;
    return "{" + (from == "ground" ? "" : "from: " + from + ", ") + "at: " + style.place(at) + ", to: " + to +
           ", end: " + style.place(end) + ", stiffness: " + style.number(stiffness, u.stiffness()) +
           ", free_length: " + style.number(free_length, u.length) +
           (damping != 0 ? ", damping: " + style.number(damping, u.damping()) : "") + "}";
  }
};

struct ProblemData {
  Vector gravity{};
  std::map<std::string, Vector> points;
  std::vector<BodyData> bodies;
  std::vector<JointData> joints;
  std::vector<LoadData> loads;
  std::vector<SpringData> springs;
  std::vector<std::string> extra;  // lines of the file that need no style
  std::vector<std::string> asks;

  const BodyData& body(const std::string& name) const {
    return *std::find_if(bodies.begin(), bodies.end(), [&](const BodyData& b) { return b.name == name; });
  }

  std::string text(const Style& style = {}) const {
    const UnitSystem& u = style.units;
    std::string all = "title: a random problem\n";
    all +=
        norm_squared(gravity) == 0 ? "gravity: none\n" : "gravity: " + style.vector(gravity, u.acceleration()) + "\n";
    const auto section = [&](const std::string& name, const std::vector<std::string>& lines) {
      if (lines.empty()) return;
      all += name + ":\n";
      for (const std::string& line : lines) all += "  " + line + "\n";
    };
    std::vector<std::string> lines;
    for (const auto& [name, place] : points) lines.push_back(name + ": " + style.place(place));
    for (const JointData& joint : joints) lines.push_back("at_" + joint.name + ": " + style.place(joint.at));
    section("points", style.ordered(lines));
    lines.clear();
    for (const BodyData& body : bodies) lines.push_back(body.name + ": " + body.text(style));
    section("bodies", style.ordered(lines));
    lines.clear();
    for (const JointData& joint : joints)
      if (joint.kind != "free") lines.push_back(joint.name + ": " + joint.text(style));
    section("joints", style.ordered(lines));
    lines.clear();
    for (std::size_t i = 0; i < loads.size(); ++i) lines.push_back(fmt::format("load{}: ", i) + loads[i].text(style));
    section("loads", style.ordered(lines));
    lines.clear();
    for (std::size_t i = 0; i < springs.size(); ++i)
      lines.push_back(fmt::format("spring{}: ", i) + springs[i].text(style));
    section("springs", style.ordered(lines));
    lines.clear();
    for (const JointData& joint : joints) {
      if (!joint.stated) continue;
      if (joint.kind == "ball" || joint.kind == "free")
        lines.push_back("  angular_velocity(" + joint.to + "): " + style.vector(joint.w, u.rate()));
      if (joint.kind == "free" || joint.kind == "planar")
        lines.push_back("  velocity(at_" + joint.name + " of " + joint.to +
                        (joint.kind == "planar" ? " relative to " + joint.from : "") +
                        "): " + style.vector(joint.v, u.velocity()));
    }
    for (const JointData& joint : joints)
      if (joint.kind == "angles")
        for (const FreedomData& f : joint.freedoms)
          lines.push_back("  " + f.name + ": " + style.number(f.position, u.angle));
    lines = style.ordered(lines);
    if (!lines.empty()) lines.insert(lines.begin(), "now:");
    section("instants", lines);
    for (const std::string& line : extra) all += line + "\n";
    all += "ask:\n";
    for (std::size_t i = 0; i < asks.size(); ++i) all += fmt::format("  a{}: {}\n", i, asks[i]);
    return all;
  }
};

struct RandomOptions {
  int least_bodies = 1, most_bodies = 4;
  bool positions = true;  // bodies stand elsewhere than drawn
  bool planar = true;
  bool loads = true;
  bool unusual = true;  // balls, free bodies, screws, universal joints
};

// A random tree of bodies; every freedom has a rate, and either an acceleration or efforts.
inline ProblemData random_problem(Random& random, const RandomOptions& options = {}) {
  ProblemData problem;
  problem.gravity = random.chance(0.2) ? Vector::zero() : random.vector(10);
  problem.points["P"] = random.vector();
  const int count = random.integer(options.least_bodies, options.most_bodies);
  for (int i = 0; i < count; ++i) {
    const Vector near = random.vector();
    BodyData body;
    body.name = fmt::format("b{}", i);
    for (int n = random.integer(1, 2); n > 0; --n) body.parts.push_back(random_part(random, near));
    // A lone rod or particle has a moment about some axis that vanishes: a sphere beside it gives all three.
    PartData bulk;
    bulk.shape = PartData::Shape::sphere;
    bulk.a = near + random.vector(0.3);
    bulk.radius = random.uniform(0.2, 0.5);
    bulk.mass = random.uniform(0.5, 2);
    body.parts.push_back(bulk);

    JointData joint;
    joint.name = fmt::format("j{}", i);
    joint.to = body.name;
    const int parent = random.integer(-1, i - 1);
    if (parent >= 0) joint.from = fmt::format("b{}", parent);
    joint.at = near + random.vector(0.5);
    joint.axis = random.uniform(0.5, 2) * random.direction();
    static const std::vector<std::string> kinds{"revolute", "revolute", "prismatic", "cylindrical", "universal",
                                                "ball",     "planar",   "screw",     "weld",        "free"};
    do {
      joint.kind = kinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds.size()) - 1))];
    } while ((joint.kind == "planar" && !options.planar) ||
             (!options.unusual && joint.kind != "revolute" && joint.kind != "prismatic" &&
              joint.kind != "cylindrical" && joint.kind != "weld"));
    // The plane of a planar joint must be known to state a velocity in it.
    if (joint.kind == "free" || joint.kind == "planar") joint.from = "ground";
    const auto freedom = [&](const std::string& name, bool turning, const Vector& axis) {
      FreedomData f;
      f.name = name;
      f.turning = turning;
      f.axis = axis;
      if (options.positions && random.chance(0.5)) f.position = random.uniform(-1, 1);
      f.rate = random.uniform(-2, 2);
      if (random.chance(0.4)) {
        f.accel = random.uniform(-3, 3);
      } else {
        if (random.chance(0.5)) f.effort = random.uniform(-4, 4);
        if (random.chance(0.3)) {
          f.stiffness = random.uniform(1, 5);
          f.free_position = random.uniform(-1, 1);
        }
        if (random.chance(0.3)) f.damping = random.uniform(0.1, 2);
      }
      joint.freedoms.push_back(f);
    };
    if (joint.kind == "revolute") freedom("", true, joint.axis);
    if (joint.kind == "prismatic") freedom("", false, joint.axis);
    if (joint.kind == "screw") {
      joint.pitch = random.uniform(-0.4, 0.4);
      freedom("", true, joint.axis);
    }
    if (joint.kind == "cylindrical") {
      freedom("turn", true, joint.axis);
      freedom("slide", false, joint.axis);
    }
    if (joint.kind == "universal") {
      joint.second = random.uniform(0.5, 2) * normalized(cross(joint.axis, random.direction()));
      freedom("first", true, joint.axis);
      freedom("second", true, joint.second);
    }
    if (joint.kind == "planar") {
      // The two directions of sliding are the language's choice: they are left free, and their velocity is a fact.
      freedom("turn", true, joint.axis);
      joint.freedoms.push_back({});
      joint.freedoms.back().name = "slide1";
      joint.freedoms.back().turning = false;
    }
    joint.w = random.vector(2);
    joint.v = random.vector(2);
    if (joint.kind == "planar") joint.v = joint.v - dot(joint.v, normalized(joint.axis)) * normalized(joint.axis);
    problem.bodies.push_back(body);
    problem.joints.push_back(joint);
  }
  if (options.loads) {
    for (int n = random.integer(0, 2); n > 0; --n) {
      LoadData load;
      load.body = fmt::format("b{}", random.integer(0, count - 1));
      load.couple = random.chance(0.5);
      load.vector = random.vector(10);
      load.at = random.vector();
      problem.loads.push_back(load);
    }
    if (random.chance(0.4)) {
      SpringData spring;
      const int to = random.integer(0, count - 1), from = random.integer(-1, count - 1);
      spring.to = fmt::format("b{}", to);
      if (from >= 0 && from != to) spring.from = fmt::format("b{}", from);
      spring.at = random.vector();
      spring.end = spring.at + random.uniform(0.5, 1.5) * random.direction();
      spring.stiffness = random.uniform(1, 20);
      spring.free_length = random.uniform(0.1, 1);
      spring.damping = random.uniform(0, 2);
      problem.springs.push_back(spring);
    }
  }
  return problem;
}

// Questions whose answers turn with the figure: vectors and numbers of it.
inline void ask_everything(ProblemData& problem) {
  for (const BodyData& body : problem.bodies) {
    const std::string& b = body.name;
    for (const std::string& ask :
         {"momentum(" + b + ")", "angular_momentum(" + b + " about P)",
          "angular_momentum(" + b + " about center(" + b + "))", "kinetic_energy(" + b + ")",
          "angular_velocity(" + b + ")", "angular_acceleration(" + b + ")", "velocity(" + b + ")",
          "acceleration(P of " + b + ")", "rate(angular_momentum(" + b + " about P))",
          "rate(kinetic_energy(" + b + "))", "mass(" + b + ")"})
      problem.asks.push_back(ask);
  }
  for (const JointData& joint : problem.joints) {
    if (joint.kind == "free") continue;
    problem.asks.push_back("force(" + joint.name + " on " + joint.to + ")");
    problem.asks.push_back("couple(" + joint.name + " on " + joint.to + " about P)");
  }
  problem.asks.push_back("angular_momentum(system about P)");
  problem.asks.push_back("kinetic_energy(system)");
}

// The only solution; std::logic_error if there are none or several.
inline Solution solved(const std::string& text, const std::vector<std::pair<std::string, std::string>>& sets = {}) {
  SolvedStatement statement = solve_statement(read_statement(text, "test.yaml"), sets);
  if (statement.solutions.size() != 1) throw std::logic_error("expected one solution");
  return std::move(statement.solutions.front());
}

inline double size_of(const Value<double>& value) {
  if (value.is_number()) return std::abs(value.number);
  if (value.is_vector()) return norm(value.vector);
  double largest = 0;
  for (const Value<double>& item : value.items) largest = std::max(largest, size_of(item));
  return largest;
}

// The largest answer of each dimension: what a difference is small against.
inline std::map<std::string, double> sizes_of(const Solution& solution) {
  std::map<std::string, double> sizes;
  for (const SolvedAsk& ask : solution.asks) {
    double& size = sizes[to_string(ask.value.dimension)];
    size = std::max(size, size_of(ask.value));
  }
  return sizes;
}

}  // namespace poinsot::problem::testing
