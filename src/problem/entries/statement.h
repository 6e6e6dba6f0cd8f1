// What a problem file says, as a checked structure: every key is known and every scalar is parsed, but nothing has a
// value yet.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/instant/rough_impact.h"
#include "problem/entries/named_files.h"
#include "problem/entries/stated_contact.h"
#include "problem/entries/stated_load.h"
#include "problem/entries/stated_spring.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"
#include "problem/language/tree.h"
#include "problem/language/units.h"

namespace poinsot::problem {

// A datum that is to be found.
struct Unknown {
  std::string name;
  Unit unit;
  bool vector = false;
  bool either_sign = false;  // whether it was stated as signed: nature lets it be negative, too
  Mark mark;
};

// A name and what it stands for, in the order of the file.
struct NamedExpression {
  std::string name;
  Expression value;
  Mark mark;
};

struct Letter {
  std::string name;
  Unit unit;
  Mark mark;
  bool either_sign = false;  // whether it was stated as signed; otherwise it is positive, unless it is an angle
};

struct MeshSolid;  // in read_meshes.h

// A uniform shape. Its kind is the key in the language, its arguments are what stands below that key; a shape given
// by a list of points (`rod: [A, B]`) has the single argument "points".
struct Shape {
  std::string kind;
  std::vector<NamedExpression> arguments;
  std::string file;  // the file of a mesh; mesh_unit is the unit of its coordinates
  Unit mesh_unit;
  std::shared_ptr<const MeshSolid> mesh;  // what that file holds
  Mark mark;
};

// The amount of matter. At most one of these is stated.
struct Amount {
  std::optional<Expression> mass;
  std::optional<Expression> weight;
  std::optional<Expression> density;          // mass per length, area or volume, as the shape asks
  std::optional<Expression> specific_weight;  // weight per length, area or volume
};

struct Part {
  std::string name;
  Shape shape;
  Amount amount;
  bool hole = false;
  Mark mark;
};

// Inertia given by numbers. Moments and products have the signs of Eqs. 18.5 and 18.6.
struct StatedInertia {
  std::optional<Expression> about;                    // the point; the mass center when left out
  std::vector<Expression> axes;                       // three directions; those of the figure when left out
  std::array<std::optional<Expression>, 3> moments;   // I_x I_y I_z
  std::array<std::optional<Expression>, 3> products;  // I_xy I_yz I_zx
  std::optional<Expression> axis, axial, transverse;  // of a body of revolution
  std::optional<Expression> matrix;                   // a list of three rows with the minus signs of Eq. 18.8
  bool rest_any = false;
  bool radii = false;  // the moments are radii of gyration
  bool flat = false;   // of a planar problem, where moments about axes in the plane may be left out
  Mark mark;
};

struct Body {
  std::string name;
  bool massless = false;
  Amount amount;            // of the whole body; parts that state no amount of their own share what is left
  std::vector<Part> parts;  // a body of one shape has one part
  std::optional<Expression> center;
  std::optional<StatedInertia> inertia;
  std::vector<Part> added;
  std::vector<Part> absorbed;  // particles that have struck the body and stuck
  Mark mark;
};

// A frame of reference that turns and moves as stated.
struct Frame {
  std::string name;
  std::optional<Expression> origin, velocity, acceleration;
  std::string rides_on;  // the body whose mass center the origin moves with; "" if none
  Mark rides_on_mark;
  std::optional<Expression> turns, rate, accel;
  Mark mark;
};

struct JointKind;  // the rows of joint_kinds.h
struct SupportKind;

// One freedom of a joint: how it moves, and the effort in it.
struct Freedom {
  std::string name;                     // "" for the only freedom of its joint
  bool turning = true;                  // whether it is an angle; else it is a displacement
  std::optional<Expression> direction;  // the axis or the direction of sliding, if the joint's key does not give it
  std::optional<Expression> position;
  std::optional<Expression> rate, accel;
  std::optional<Expression> effort;  // couple or force
  std::optional<Expression> stiffness, free_position, damping;
  std::optional<Friction> friction;  // its largest couple or force at rest, and that while it moves
  Mark mark;
};

// One support of a joint, and the components of force and couple that it can carry.
struct Support {
  std::string name;
  const SupportKind* kind = nullptr;  // null when components are listed
  std::vector<Expression> forces, couples;
  std::optional<Expression> at;  // always given: where the file leaves it out, the name names the point
  Mark mark;
};

struct Joint {
  std::string name;
  const JointKind* kind = nullptr;
  Expression place;  // axis or point, the value of the kind's key
  std::optional<Expression> at;
  std::string from, to;
  Mark from_mark, to_mark;
  std::vector<Freedom> freedoms;
  std::optional<Friction> friction{};  // against its slip in several ways together; else it stands at a freedom
  std::optional<Expression> pitch;
  std::vector<Support> supports;
  bool supports_stated = false;
  Mark mark;
};

// What a cord is led over: a wheel of a body, or a point of a body or of the figure.
struct CordWheel {
  std::string name;  // of the body or point
  Expression named;  // the same as an expression
  std::optional<Expression> at, radius, side;
  bool smooth = false;                 // whether the cord slides over it
  std::optional<Friction> friction{};  // the coefficients, where it slips against friction
  std::optional<Expression> turns{};   // how often it goes round, as drawn
  Mark mark;
};

// A cord between two bodies. If `direction` is given it is so long that its direction does not change.
struct Cord {
  std::string name, from, to;
  Mark from_mark, to_mark;
  std::optional<Expression> at, end, direction;
  std::vector<CordWheel> over;               // in the order of the cord
  std::optional<CordWheel> off_from, on_to;  // where it winds on a wheel of `from` or `to`, instead of at and end
  std::optional<Expression> length;          // where it may be longer than drawn, and is slack at the start
  Mark mark;

  bool is_led() const { return !over.empty() || off_from || on_to; }
};

// A closed belt or chain round wheels, in its order.
struct Belt {
  std::string name;
  bool chain = false;
  std::vector<CordWheel> over;
  std::optional<Expression> tension;  // the initial one of a belt
  bool crossed = false;
  Mark mark;

  std::string words() const { return (chain ? "chain '" : "belt '") + name + "'"; }
};

// On which side teeth rise along their wheel, as threads do; both: two rows of teeth, whose thrusts cancel.
enum class Hand { none, right, left, both };

// Two gears whose teeth meet. The angle of the helix, its lead and its hand are those of `of`.
struct Gear {
  std::string name, of, against;
  Mark of_mark, against_mark;
  Expression at;
  std::optional<Expression> pressure_angle, normal_pressure_angle, helix_angle, lead, friction;
  Hand hand = Hand::none;
  Mark hand_mark, mark;

  bool has_pressure_angle() const { return pressure_angle || normal_pressure_angle; }
  bool has_helix() const { return helix_angle || lead; }
};

// A sudden push or twist, given as an impulse or as a force that lasts so short a time that nothing moves meanwhile.
struct Impulse {
  std::string name, body, axes;
  Mark body_mark, axes_mark;
  std::optional<Expression> value, force, lasts, couple, direction, at;
  Mark mark;
};

// A body that strikes another one or an obstruction.
struct Impact {
  std::string name, of, against;
  Mark of_mark, against_mark;
  Expression at, pushes;
  std::optional<Expression> restitution, friction;
  solve::RestitutionLaw hypothesis = solve::RestitutionLaw::energetic;
  Mark mark;
};

// A particle that hits a body and stays in it, or passes through it and loses speed.
struct Strike {
  std::string name, hits, relative_to;
  Mark hits_mark, relative_to_mark;
  Amount amount;
  Expression at, velocity;
  bool stays = false;
  bool mass_neglected = false;
  std::optional<Expression> loses;  // the part of its relative speed that it loses
  Mark mark;
};

// What shakes a steady motion a little, at one frequency: it acts in response() alone.
struct Excitation {
  std::string name, body, axes, coordinate;
  Mark body_mark, axes_mark, coordinate_mark;
  // One of these, or a coordinate that is driven and swings `by` so much.
  std::optional<Expression> force, couple, unbalance, by;
  std::optional<Expression> direction, at, turns, frequency;
  Mark mark;
};

// A stated number of some things are to be used: impulses, or masses added to bodies. The others are zero.
struct Choice {
  std::string name;
  std::vector<std::string> of;
  int exactly = 0;
  bool least_total = false;  // instead of a count: the choice with the least sum of amounts is taken
  Mark mark;
};

// What is known at an instant: the value of a quantity, or that everything rests.
struct Fact {
  Expression quantity;
  Expression value;
  Mark mark;
};
struct Instant {
  std::string name;  // the name of an instant or stage, or a time such as `2 s`
  Expression when;   // the same as an expression: a time, or a single name, which may be that of a time; else empty
  bool rest = false;
  std::vector<std::pair<std::string, Mark>> nudged;  // coordinates that are disturbed slightly
  std::optional<Expression> found_when;              // the instant is the first at which this holds
  std::vector<Fact> facts;
  Mark mark;
};

// A body of a steady motion that spins at a constant rate about an axis at rest in the frame.
struct Spin {
  std::string body;
  Expression about, rate;
  Mark mark;
};
struct Steady {
  std::string frame;
  Mark frame_mark, mark;
  std::vector<Spin> spins;
};

struct Stage {
  std::string name;
  std::optional<Expression> lasts, until;         // how long it lasts, or the event that ends it
  std::optional<std::vector<std::string>> loads;  // the loads that act; all of them if this is left out
  Mark mark;
};

// The largest or smallest value of a datum for which conditions hold.
struct Extremum {
  bool largest = true;
  std::string name;
  Mark name_mark;
  std::vector<Expression> conditions;
  std::string situation;  // "" if there is only one
  Mark situation_mark;
};
// Columns of quantities over time, over a coordinate of the motion, or over a datum.
struct Table {
  std::vector<NamedExpression> columns;
  std::string over;
  Expression over_value;  // what it runs over as an expression
  Mark over_mark;
  Expression values;  // a range or a list
  std::map<std::string, Unit> units;
};
// Asks when a condition holds in the motion: the first time, or all times in a span.
struct WhenAsk {
  bool first = true;
  Expression condition;
  std::optional<Expression> from, to;
};
struct Ask {
  std::string name;
  // One quantity, or several for a list; none if one of the next three is asked.
  std::vector<Expression> of;
  std::optional<Extremum> extremum;
  std::optional<Table> table;
  std::optional<WhenAsk> when;
  bool is_list = false;
  std::string text;  // as written
  std::optional<Unit> unit;
  std::optional<Expression> axes;
  Mark mark;
};

// A statement to be proved for all values of the letters, and of the motion as far as the file leaves it open.
struct Claim {
  std::string name;
  std::vector<Expression> of;      // comparisons and truth values that must all hold
  std::vector<Expression> assume;  // comparisons that hold in addition to those of the situation
  std::optional<Expression> axes;
  std::string situation;  // "" if there is only one
  std::string text;       // as written
  Mark mark, situation_mark;
};

struct Expected {
  std::string part;
  std::optional<Expression> value, formula;
  bool roots = false;  // whether `value` lists one number for each solution
  std::optional<Unit> unit;
  std::optional<std::vector<std::string>> names;
  std::vector<NamedExpression> columns;  // of a table: a list of numbers for each
  std::optional<bool> holds;
  double relative_tolerance = 1e-6;
  double absolute_tolerance = 0;  // in the unit of the value
  Mark mark;
};
struct ExpectedCase {
  std::string name;
  std::vector<std::pair<std::string, std::string>> sets;
  std::vector<Expected> parts;
  Mark mark;
};

// The plane of a planar problem: two axes of the figure, from the first of which to the second angles are counted.
struct MotionPlane {
  std::size_t first = 0, second = 1;
  Mark mark;
  std::size_t normal() const { return 3 - first - second; }
  // Of the sense in which angles are counted about the normal axis of the figure.
  int sign() const { return second == (first + 1) % 3 ? 1 : -1; }
};

// Gravity towards a center.
struct CentralGravity {
  Expression toward, parameter;
  Mark mark;
};
// The name of its pull on each body, in force(gravity on moon).
inline constexpr const char* name_of_gravity = "gravity";

// One setting of the machine: what the file says at its top, with the entries of this setting laid over it.
struct Situation {
  std::string name;  // "" when the file states no situations
  // found in this situation alone; the other unknowns are common to all situations
  std::vector<std::string> own_unknowns;
  std::string file;
  std::string title;
  std::vector<NamedExpression> given;
  std::vector<Letter> letters;
  std::vector<Unknown> find;
  std::vector<Choice> choose;
  std::vector<Expression> neglect;   // squares of unknowns that are neglected
  std::vector<std::string> without;  // added masses and loads that this situation leaves out
  std::vector<Expression> where;     // comparisons that the unknowns must satisfy
  std::vector<Expression> assume;    // comparisons under which claims are made
  std::array<std::string, 3> axes{"x", "y", "z"};
  std::optional<Expression> gravity;              // absent: not stated; the name `none`: no gravity
  std::optional<CentralGravity> central_gravity;  // `gravity` is then `none`
  std::optional<MotionPlane> plane;
  std::string view;  // from where a figure is looked at, as viewing_direction() has it; "" if open
  std::vector<NamedExpression> points, directions, define;
  std::vector<Frame> frames;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Contact> contacts;
  std::vector<Cord> cords;
  std::vector<Belt> belts;  // and chains
  std::vector<Gear> gears;
  std::vector<Spring> springs;
  std::vector<Load> loads;
  std::vector<Impulse> impulses;
  std::vector<Impact> impacts;
  std::vector<Strike> strikes;
  std::vector<Excitation> excitations;
  std::vector<Stage> stages;
  std::vector<Instant> instants;
  std::optional<Steady> steady;
  // Whether there is a blow, so that velocities before and after it differ.
  bool has_friction() const { return std::ranges::any_of(contacts, &Contact::rubs); }
  // Whether it is one at a rough contact.
  bool has_rough_blow() const {
    return std::ranges::any_of(impacts, [](const Impact& impact) { return impact.friction.has_value(); });
  }
  // The first freedom whose couple or force is to be found from what is stated elsewhere; null if there is none.
  const Freedom* sought_effort() const {
    for (const Joint& joint : joints)
      for (const Freedom& freedom : joint.freedoms)
        if (freedom.effort && is_any(*freedom.effort)) return &freedom;
    return nullptr;
  }
  bool has_blow() const { return !impulses.empty() || !impacts.empty() || !strikes.empty(); }
  UnitHabits habits;  // the units used, from which those of the answers are chosen
};

// Visits the lists of laws of force: the one place that names them all.
template <class SituationOrConst, class Visit>
void for_each_law_list(SituationOrConst& situation, const Visit& visit) {
  visit(situation.springs);
  visit(situation.loads);
}

// Visits every law of force.
template <class Visit>
void for_each_stated_law(const Situation& situation, const Visit& visit) {
  for_each_law_list(situation, [&]<StatedLaw Law>(const std::vector<Law>& laws) {
    for (const Law& law : laws) visit(law);
  });
}

// What is to be recorded of the motion: columns over time.
struct Record {
  std::vector<NamedExpression> columns;
  Expression every;
  std::optional<Expression> lasts;
  std::optional<Expression> axes;
  std::map<std::string, Unit> units;
  Mark mark;
};

// All that one file says.
struct Statement {
  std::vector<Situation> situations;  // at least one
  std::vector<Ask> asks;              // in the order of the file
  std::vector<Claim> claims;
  std::optional<Record> record;
  std::vector<ExpectedCase> expected;
  bool expects = false;
  bool corners = false;  // whether what is stated calls functions with corners: abs, norm, max, min, acute_angle
  std::string file, title;
};

// Reads the text of a problem file, which messages call `file`, and by `read` the meshes that it names, each file once.
// Throws StatementError for malformed, too large or too deep text, unknown or duplicate keys, malformed expressions,
// and meshes that cannot be had or hold no solid.
Statement read_statement(std::string_view text, const std::string& file, const ReadNamedFile& read);
// Reads the meshes as files_beside(file).
Statement read_statement(std::string_view text, const std::string& file);

}  // namespace poinsot::problem
