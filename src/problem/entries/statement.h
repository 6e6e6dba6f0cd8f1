// A problem file as checked structure: every key is known, every scalar is parsed, nothing has a value yet.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  bool either_sign = false;  // stated as signed; else it is positive, but for angles
};

// A uniform shape: `kind` is its key in the language, `arguments` what stands below it; a shape given by a list of
// points (`rod: [A, B]`) has the single argument "points".
struct Shape {
  std::string kind;
  std::vector<NamedExpression> arguments;
  std::string file;  // of a mesh, with the unit of its coordinates
  Unit mesh_unit;
  Mark mark;
};

// How much matter: at most one is stated.
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

// Inertia in numbers; moments and products carry the signs of Eqs. 18.5 and 18.6.
struct StatedInertia {
  std::optional<Expression> about;                    // the point; the mass center when left out
  std::vector<Expression> axes;                       // three directions; those of the figure when left out
  std::array<std::optional<Expression>, 3> moments;   // I_x I_y I_z
  std::array<std::optional<Expression>, 3> products;  // I_xy I_yz I_zx
  std::optional<Expression> axis, axial, transverse;  // of a body of revolution
  std::optional<Expression> matrix;                   // list of three rows, minus signs included
  bool rest_any = false;
  bool radii = false;  // the moments are radii of gyration
  Mark mark;
};

struct Body {
  std::string name;
  bool massless = false;
  Amount amount;            // of the whole, shared among parts that state none
  std::vector<Part> parts;  // a body of one shape has one part
  std::optional<Expression> center;
  std::optional<StatedInertia> inertia;
  std::vector<Part> added;
  std::vector<Part> absorbed;  // particles that have struck it and stay
  Mark mark;
};

// A point of view that turns and moves as stated.
struct Frame {
  std::string name;
  std::optional<Expression> origin, velocity, acceleration;
  std::string rides_on;  // the body whose mass center carries the origin; "" if none
  Mark rides_on_mark;
  std::optional<Expression> turns, rate, accel;
  Mark mark;
};

enum class JointKind { weld, revolute, prismatic, cylindrical, universal, ball, planar, screw };

// One freedom of a joint: its motion side and its force side.
struct Freedom {
  std::string name;                     // "" for the only freedom of its joint
  bool turning = true;                  // an angle, else a displacement
  std::optional<Expression> direction;  // axis or direction of sliding, where the joint's key does not say it
  std::optional<Expression> position;
  std::optional<Expression> rate, accel;
  std::optional<Expression> effort;  // couple or force
  std::optional<Expression> stiffness, free_position, damping;
  Mark mark;
};

// The components that one support of a joint can carry.
struct Support {
  std::string name;  // also the point, unless `at` says otherwise
  std::string kind;  // journal, thrust, collar, hinge, ball; "" when components are listed
  std::vector<Expression> forces, couples;
  std::optional<Expression> at;
  Mark mark;
};

struct Joint {
  std::string name;
  JointKind kind = JointKind::weld;
  Expression place;  // axis or point, the value of the kind's key
  std::optional<Expression> at;
  std::string from, to;
  Mark from_mark, to_mark;
  std::vector<Freedom> freedoms;
  std::optional<Expression> pitch;
  std::vector<Support> supports;
  bool supports_stated = false;
  Mark mark;
};

struct Contact {
  std::string name, of, against;
  Mark of_mark, against_mark;
  Expression at, normal;
  bool no_slip = false;
  std::optional<std::vector<Expression>> carries;  // directions, or the word "push" for the normal
  Mark mark;
};

// A cord between two bodies, or (`direction`) one so long that only its direction counts.
struct Cord {
  std::string name, from, to;
  Mark from_mark, to_mark;
  std::optional<Expression> at, end, direction;
  Mark mark;
};

struct Spring {
  std::string name, from, to;
  Mark from_mark, to_mark;
  Expression at, end;
  std::optional<Expression> stiffness, free_length, tension, damping;
  Mark mark;
};

struct Load {
  std::string name, body, axes;
  Mark body_mark, axes_mark;
  std::optional<Expression> force, couple, direction, at;
  Mark mark;
};

// A sudden push or twist, of a given impulse or of a force that lasts so short that nothing moves meanwhile.
struct Impulse {
  std::string name, body, axes;
  Mark body_mark, axes_mark;
  std::optional<Expression> value, force, lasts, couple, direction, at;
  Mark mark;
};

// A body strikes another, or an obstruction.
struct Impact {
  std::string name, of, against;
  Mark of_mark, against_mark;
  Expression at, pushes;
  std::optional<Expression> restitution;
  Mark mark;
};

// A particle hits a body and stays in it, or passes through and loses speed.
struct Strike {
  std::string name, hits, relative_to;
  Mark hits_mark, relative_to_mark;
  Amount amount;
  Expression at, velocity;
  bool stays = false;
  bool mass_neglected = false;
  std::optional<Expression> loses;  // part of its relative speed
  Mark mark;
};

// Exactly so many of some things: impulses, or masses added to bodies. What belongs to the others is zero.
struct Choice {
  std::string name;
  std::vector<std::string> of;
  int exactly = 0;
  bool least_total = false;  // the choice with the least sum of amounts, instead of a count
  Mark mark;
};

// What is known at an instant: `quantity == value` each, or that everything rests.
struct Fact {
  Expression quantity;
  Expression value;
  Mark mark;
};
struct Instant {
  std::string name;  // of an instant or stage, or a time such as `2 s`
  bool rest = false;
  std::vector<std::pair<std::string, Mark>> nudged;  // coordinates that are disturbed a little
  std::optional<Expression> found_when;              // at the first time when this holds
  std::vector<Fact> facts;
  Mark mark;
};

// Everything rests relative to a frame but for constant spins of bodies about axes that rest in it.
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
  std::optional<Expression> lasts, until;         // how long, or the event that ends it
  std::optional<std::vector<std::string>> loads;  // all when left out
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
// Columns over time, a coordinate of the motion, or a datum.
struct Table {
  std::vector<NamedExpression> columns;
  std::string over;
  Mark over_mark;
  Expression values;  // a range or a list
  std::map<std::string, Unit> units;
};
// When something happens in the motion: the first time, or all times in a span.
struct WhenAsk {
  bool first = true;
  Expression condition;
  std::optional<Expression> from, to;
};
struct Ask {
  std::string name;
  // One quantity, several for a list; none where one of the next three is asked.
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

// That something holds for all values of the letters, and of the motion as far as the statement leaves it open.
struct Claim {
  std::string name;
  std::vector<Expression> of;      // comparisons and truth values, all of which must hold
  std::vector<Expression> assume;  // comparisons, beside those of the problem
  std::optional<Expression> axes;
  std::string situation;  // "" if there is only one
  std::string text;       // as written
  Mark mark, situation_mark;
};

struct Expected {
  std::string part;
  std::optional<Expression> value, formula;
  bool roots = false;  // value lists one number for each solution
  std::optional<Unit> unit;
  std::optional<std::vector<std::string>> names;
  std::vector<NamedExpression> columns;  // of a table: a list of numbers each
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

// A setting of one machine: what the file says at its top, with the entries of the setting laid over it.
struct Situation {
  std::string name;                       // "" when the file states no situations
  std::vector<std::string> own_unknowns;  // found in this situation by itself; the others are common to all
  std::string file;
  std::string title;
  std::vector<NamedExpression> given;
  std::vector<Letter> letters;
  std::vector<Unknown> find;
  std::vector<Choice> choose;
  std::vector<Expression> neglect;   // squares of unknowns that count as nothing
  std::vector<std::string> without;  // added masses and loads that are left out
  std::vector<Expression> where;     // comparisons that the unknowns must satisfy
  std::vector<Expression> assume;    // comparisons under which claims are made
  std::array<std::string, 3> axes{"x", "y", "z"};
  std::optional<Expression> gravity;  // absent: not stated; the name `none`: no gravity
  std::vector<NamedExpression> points, directions, define;
  std::vector<Frame> frames;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Contact> contacts;
  std::vector<Cord> cords;
  std::vector<Spring> springs;
  std::vector<Load> loads;
  std::vector<Impulse> impulses;
  std::vector<Impact> impacts;
  std::vector<Strike> strikes;
  std::vector<Stage> stages;
  std::vector<Instant> instants;
  std::optional<Steady> steady;
  // Whether something sudden happens: then there is a before and an after.
  bool has_blow() const { return !impulses.empty() || !impacts.empty() || !strikes.empty(); }
  UnitHabits habits;  // the units used, for the answers
};

// What is recorded of the motion: columns over time.
struct Record {
  std::vector<NamedExpression> columns;
  Expression every;
  std::optional<Expression> lasts;
  std::optional<Expression> axes;
  std::map<std::string, Unit> units;
  Mark mark;
};

// What one file says.
struct Statement {
  std::vector<Situation> situations;  // at least one
  std::vector<Ask> asks;              // in the order of the file
  std::vector<Claim> claims;
  std::optional<Record> record;
  std::vector<ExpectedCase> expected;
  bool expects = false;
  std::string file, title;
};

// Reads the text of a problem file. `file` is named in messages and its folder holds the meshes.
// Throws StatementError: malformed, too large or too deep text, unknown or duplicate keys, malformed expressions.
Statement read_statement(std::string_view text, const std::string& file);

}  // namespace poinsot::problem
