// The scene: what a solution looks like, in numbers and without any drawing. Renderings of it, as a line drawing, a
// page or a file for other programs, contain no mechanics.
//
// All numbers are in SI units. Places are on the axes of a body as drawn (`body`), whose pose brings them to the
// ground; with body -1 they are on ground axes already. Vectors of arrows are on ground axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot::scene {

constexpr int ground = -1;

struct Place {
  int body = ground;  // its number in Scene::bodies
  Vector3<double> at;
};

// The position of a body: a point at x on its axes is at R x + p on those of the ground.
struct Pose {
  Matrix3<double> R = Matrix3<double>::identity();
  Vector3<double> p{};
};

enum class Extent { point, line, surface, volume };

// One shape of a body, on the axes of the body as drawn. Places are indices into `vertices`.
struct Shape {
  std::string kind;  // the key in the language: "cylinder"
  std::string part;  // the name of the part; "" for a body of one shape
  Extent extent = Extent::volume;
  bool hole = false;   // matter that is left out
  bool added = false;  // a mass that was added to the body
  // Of a body of which the statement gives the moments of inertia and no shape: a solid that has them.
  bool stand_in = false;
  std::vector<Vector3<double>> vertices{};
  // Outward by the right-hand rule for volumes; for surfaces either way.
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  // The unit normal of the true surface at each corner of each triangle, so that round things look round.
  std::vector<std::array<Vector3<double>, 3>> normals{};
  // The edges that a draughtsman draws from any side: rims, corners, borders of surfaces. For extent `line` the line
  // itself. A closed edge ends with its first vertex.
  std::vector<std::vector<std::uint32_t>> edges{};
};

struct Body {
  std::string name;
  bool frame = false;     // a frame of reference that moves: it has axes and no shape
  bool massless = false;  // it has no matter, so that its shapes only show where it is
  double mass = 0;        // kg
  Vector3<double> center{};
  std::vector<Shape> shapes{};
  Pose pose{};  // at the shown instant
};

// A named point of the figure, or one that a line of the file defines.
struct Point {
  std::string name;
  Place place;
};

enum class SymbolKind {
  weld,
  revolute,
  prismatic,
  cylindrical,
  universal,
  ball,
  planar,
  screw,
  slot,
  journal,  // supports of a joint
  thrust,
  collar,
  hinge,
  fork,
  clevis,
  ball_support,
  listed_support,  // one that carries listed components
  contact,         // `axis` is the normal, out of the body that is touched
  rolling_contact,
};

// A joint, a support or a contact: a drawing shows it by a symbol.
struct Symbol {
  SymbolKind kind = SymbolKind::revolute;
  std::string name;
  int from = ground, to = ground;  // the body that holds, or is touched, and the body held
  Place place;                     // on `to`
  // The axis, or the direction of sliding, on the axes of `to`; zero if it has none.
  Vector3<double> axis{}, second_axis{};
};

enum class LinkKind { cord, spring, damper, torsion };

// What runs between two places.
struct Link {
  LinkKind kind = LinkKind::cord;
  std::string name;
  Place from, to;
  std::string symbol{};  // TeX, of a straight part whose tension is asked for: "T_1"
  bool far = false;      // a cord that is so long that only its direction counts: `to` is a place on the way
  bool slack = false;
};

// Where a cord or belt lies on a wheel or post, between two of its straight parts: from where the one ends, the `from`
// of the link `comes`, right-handed about the axis to where the other begins, the `to` of the link `leaves`.
struct Wrap {
  std::string name;  // of the cord
  std::size_t comes = 0, leaves = 0;
  Place center;
  Vector3<double> axis{};  // on the axes of the body of `center`
};

enum class Quantity {
  force,
  weight,
  couple,
  impulse,
  angular_impulse,
  velocity,
  angular_velocity,
  acceleration,
  angular_acceleration,
  linear_momentum,           // m v
  angular_momentum,          // H
  rate_of_momentum,          // m a
  rate_of_angular_momentum,  // dH/dt
  displacement,              // how far a support is shaken
  angular_displacement,
  unbalance,  // m e, from the axis
};

// A vector of a diagram, never zero.
struct Arrow {
  Quantity quantity = Quantity::force;
  std::string name;  // of what it belongs to, as the statement calls it: a support, load, spring; or the answer
  int body = ground;
  Place at;  // its point of application; of couples and turning the point where a drawing may put it
  Vector3<double> vector{};
  std::string symbol;  // TeX, as in the worked solution: "\mathbf{C}", "m_1\bar{\mathbf{a}}"
  std::string text;    // the same as plain text with _ before an index: "C", "m_1 a"
  double value = 0;    // the size, or the signed component where the symbol stands for one, in `unit`
  std::string unit;
  // Of `value` in SI units, if letters have no value; else "". Of a vector of several components a list: "[0, a, b]".
  std::string formula{};
  bool known = false;   // whether the statement gives it, as a load is given
  bool swings = false;  // whether it is an amplitude: it acts to and fro
  // Whether the equations leave its size open: `vector` is then a unit vector in the sense that counts as positive,
  // and there is no value.
  bool open = false;
};

enum class DiagramKind {
  model,           // the statement's figure: loads, given velocities, given impulses
  free_body,       // what acts on the bodies that the worked solution cuts free
  kinetic,         // m a at the mass centers and the rates of H: equal to free_body
  momenta_before,  // momenta before + impulses = momenta after
  impulses,
  momenta_after,
  answers,  // the vectors that are asked for
};

// Arrows on some of the bodies. Diagrams with the same group are one equation, in the order of the list.
struct Diagram {
  DiagramKind kind = DiagramKind::model;
  std::string title;  // a sentence without its full stop
  int group = 0;
  std::vector<int> bodies{};  // those that are drawn
  std::vector<Arrow> arrows{};
};

// A length or an angle that a datum names; from and to at one place: a number of what is touched there, as friction.
struct Dimension {
  std::string name;    // the datum: "L", "beta"
  std::string text;    // with its value: "L = 600 mm"
  bool angle = false;  // then it is between the directions from `corner` to the two places
  Place from, to;
  Place corner{};
  // Of a radius, on the axes of the body of `from`: a drawing may show it in any direction across this. Else zero.
  Vector3<double> axis{};
};

// A curve in space, as points: the path of a point, a polhode, a herpolhode, the pitch circle of a gear, the circle of
// a post that the ground holds; the center that pulls, as one point. A surface that is touched later is a segment: a
// place on it and one beside that, along its normal.
enum class CurveKind { path, polhode, herpolhode, axis_path, pitch_circle, post, surface, attractor };
struct Curve {
  CurveKind kind = CurveKind::path;
  std::string name;
  int body = ground;  // on whose axes the points are
  bool closed = false;
  std::vector<Vector3<double>> points{};
};

// A cone on which an axis moves: the angular velocity in the body or in space (Eq. 18.49 and below).
struct Cone {
  std::string name;   // "body cone"
  int body = ground;  // on whose axes it stands
  Vector3<double> apex{}, axis{};
  double half_angle = 0;            // rad
  Vector3<double> touching_line{};  // the direction in which the two cones touch, at the shown instant
};

struct Event {
  double time = 0;
  std::string words;
};

// A quantity over the times of the motion.
struct Plot {
  std::string name;  // of the question, or a coordinate
  std::string words;
  std::string unit;
  std::vector<std::string> labels;            // of the lines, one for a number, three for a vector
  std::vector<std::vector<double>> values{};  // for each line, in `unit`
};

// A vector that changes during a motion.
struct MovingArrow {
  Quantity quantity = Quantity::velocity;
  std::string name;  // of its body, or of the question
  Place at;
  std::string symbol, text, unit;          // as those of an Arrow
  double factor = 1;                       // SI of one of the unit
  std::vector<Vector3<double>> vectors{};  // for each time, on ground axes, in SI
};

// The ends of a link that do not ride on its bodies: those of a cord's straight part between wheels.
struct MovingLink {
  std::size_t link = 0;                       // its place in Scene::links
  std::vector<Vector3<double>> from{}, to{};  // for each time, on ground axes
};

struct Motion {
  std::vector<double> times{};             // s, ascending
  std::vector<std::vector<Pose>> poses{};  // for each time, of each body
  std::vector<Plot> plots{};
  std::vector<MovingArrow> arrows{};
  std::vector<MovingLink> links{};
  std::vector<Event> events{};
  bool complete = true;  // false if it was followed no further, by a budget or a limit; `stopped` says why
  std::string stopped{};
};

// A letter without value, and the value with which the scene is drawn.
struct DrawnLetter {
  std::string name, unit;
  double value = 0;         // in `unit`
  bool only_grows = false;  // whether another value of it makes the figure larger or smaller at most, and no other
};

struct Scene {
  std::string situation{};  // "" if the file states only one
  std::array<std::string, 3> axes{"x", "y", "z"};
  Vector3<double> up{0, 0, 1};  // against gravity; else what a reader expects to be drawn upward
  // The direction from which it should be looked at, if the statement gives one.
  std::optional<Vector3<double>> viewer{};
  bool gravity = false;
  double length = 1;  // m, the size of what is drawn
  std::vector<Body> bodies{};
  std::vector<Point> points{};
  std::vector<Symbol> symbols{};
  std::vector<Link> links{};
  std::vector<Wrap> wraps{};
  std::vector<Diagram> diagrams{};  // the first is that of the model
  std::vector<Dimension> dimensions{};
  std::vector<Curve> curves{};
  std::vector<Cone> cones{};
  std::optional<Motion> motion{};
  std::vector<DrawnLetter> drawn_letters{};
  std::vector<std::string> notes{};  // what the scene leaves out, and why
};

}  // namespace poinsot::scene
