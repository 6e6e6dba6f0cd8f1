// What is wrong in a problem file, and where: the whole message of each mistake; and the reasons of answers that cannot
// be given.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "problem/answers/solve_statement.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace mistakes_test {

using Sets = std::vector<std::pair<std::string, std::string>>;

SolvedStatement solve(const std::string& text, const Sets& sets = {}, const std::string& file = "test.yaml") {
  return solve_statement(read_statement(text, file), sets);
}

struct Mistake {
  const char* name;
  const char* text;
  const char* message;
  Sets sets;
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> list{
      {"WhenBesideLargest",
       R"(title: t
given: {v: 1 m/s}
points: {O: [0, 0, 0]}
bodies: {b: {particle: O, mass: 1 kg}}
gravity: -y
instants: {start: {velocity(b): [0, v, 0]}}
ask: {a: {largest: v, when: velocity(b).y < 5 m/s}}
)",
       "test.yaml:7:23: error: unknown key 'when' in an ask (what is to hold up to there stands under 'while:')",
       {}},
      {"AWordCompared",
       R"(title: t
letters: {I: kg*m^2, J: kg*m^2, p: rad/s}
points: {G: [0, 0, 0]}
bodies: {sat: {mass: 1 kg, center: G, inertia: {axis: z, axial: I, transverse: J}}}
gravity: none
facts: {angular_velocity(sat): [p, 0, p]}
claim: {s: precession_sense(sat) == retrograde}
)",
       "test.yaml:7:12: error: precession_sense() is told in words, and words are not compared (ask for it by itself, "
       "or "
       "compare numbers, as in spin_rate(B) < 0 rad/s)",
       {}},
      {"UnknownKey",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, raduis: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:46: error: unknown key 'raduis' in a disk (did you mean 'radius'?)",
       {}},
      {"AKeyOfOtherBooks",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {disk: {disk: {center: O, normal: y, diameter: 0.2 m}, mass: 3 kg}}
ask: {a: mass(disk)}
)",
       "test.yaml:3:46: error: unknown key 'diameter' in a disk (did you mean 'radius'?)",
       {}},
      {"ACordThatEndsOnTheGround",
       R"(title: t
points: {O: [0, 0, 0], A: [0, -0.5 m, 0]}
bodies: {bob: {particle: A, mass: 1 kg}}
cords: {c: {from: bob, at: A, to: ground, end: O}}
ask: {a: mass(bob)}
)",
       "test.yaml:4:35: error: cord 'c' ends on the ground, where a cord begins (turn it round: from: ground, at: the "
       "point there, over: the other way, to: and end: of the body)",
       {}},
      {"ACordThatRebounds",
       R"(title: t
points: {O: [0, 0, 0], A: [0, -0.5 m, 0]}
bodies: {bob: {particle: A, mass: 1 kg}}
cords: {c: {from: ground, at: O, to: bob, end: A, length: 1 m, restitution: 0.5}}
ask: {a: mass(bob)}
)",
       "test.yaml:4:64: error: cord 'c' that goes taut does not rebound: it has no restitution (state the jerk by "
       "itself, impacts: {jerk: {of: bob, at: A, pushes: A->O, restitution: 0.5}})",
       {}},
      {"AnInstantFoundFromATimeOn",
       R"(title: t
points: {A: [0, 1 m, 0]}
bodies: {bob: {particle: A, mass: 1 kg}}
gravity: -y
instants: {start: rest, late: {first_time: position(bob).y < 0 m, from: 2 s}}
ask: {a: time @ late}
)",
       "test.yaml:5:67: error: an instant that is found by a condition is the first from the start on (ask for another "
       "time by itself, {first_time: turn' == 0, from: 2 s})",
       {}},
      {"TwoParticlesThatMeet",
       R"(title: t
points: {A: [0, 0, 0], B: [1 m, 0, 0]}
bodies: {one: {particle: A, mass: 1 kg}, two: {particle: B, mass: 1 kg}}
contacts: {hit: {of: two, against: one, at: B, surface: A, normal: x, open: true, restitution: 0.5}}
gravity: none
instants: {start: {velocity(one): [1 m/s, 0, 0], velocity(two): [0, 0, 0]}}
ask: {a: velocity(two).x @ 2 s}
)",
       "test.yaml:4:12: error: 'one' is a particle, which has no surface that 'two' could touch (two particles do not "
       "meet: give 'one' a shape, such as a box or a sphere)",
       {}},
      {"SidesByTheirLengths",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {crate: {box: {center: O, sides: [0.8 m, 1 m, 0.6 m]}, mass: 3 kg}}
ask: {a: mass(crate)}
)",
       "test.yaml:3:43: error: a side has a direction, and 0.8 m is a length alone (write it as a vector: [0.8 m, 0, "
       "0] "
       "along x)",
       {}},
      {"AJointOfOtherBooks",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {hinge: y, at: O, to: disk}}
ask: {a: mass(disk)}
)",
       "test.yaml:4:18: error: unknown key 'hinge' in a joint (did you mean 'revolute'?)",
       {}},
      {"ABeltOfOtherBooks",
       R"(title: t
points: {A: [0, 0, 0], B: [1 m, 0, 0]}
bodies: {a: {disk: {center: A, normal: z, radius: 0.2 m}, mass: 3 kg}, b: {disk: {center: B, normal: z, radius: 0.2 m}, mass: 3 kg}}
belts: {belt: {wheels: [a, b]}}
ask: {a: mass(a)}
)",
       "test.yaml:4:16: error: unknown key 'wheels' in a belt (did you mean 'over'?)",
       {}},
      {"TheFrictionOfABelt",
       R"(title: t
points: {A: [0, 0, 0], B: [1 m, 0, 0]}
bodies: {a: {disk: {center: A, normal: z, radius: 0.2 m}, mass: 3 kg}, b: {disk: {center: B, normal: z, radius: 0.2 m}, mass: 3 kg}}
belts: {drive: {over: [a, b], friction: 0.3}}
ask: {a: mass(a)}
)",
       "test.yaml:4:31: error: belt 'drive' has no friction: on each wheel its friction may be another (state it at "
       "the wheel: over: [{wheel: {friction: ...}}])",
       {}},
      {"TheTurnsOfACord",
       R"(title: t
points: {A: [0, 0, 0], B: [1 m, 0, 0], O: [0, 1 m, 0]}
bodies: {a: {particle: A, mass: 3 kg}, b: {particle: B, mass: 3 kg}}
cords: {rope: {from: a, at: A, over: [O], turns: 2, to: b, end: B}}
ask: {a: mass(a)}
)",
       "test.yaml:4:43: error: cord 'rope' has no turns: on each wheel its turns may be another (state it at the "
       "wheel: over: [{wheel: {turns: ...}}])",
       {}},
      {"TheFrictionOfOtherPrograms",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {block: {particle: O, mass: 3 kg}}
contacts: {floor: {of: block, at: O, normal: y, mu: 0.3}}
ask: {a: mass(block)}
)",
       "test.yaml:4:49: error: unknown key 'mu' in a contact (did you mean 'friction'?)",
       {}},
      {"AnUnknownKeyOfAnAsk",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
ask: {a: {of: mass(disk), units: slug}}
)",
       "test.yaml:4:27: error: unknown key 'units' in an ask (did you mean 'unit'?)",
       {}},
      {"AQuantityOfOtherBooks",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
ask: {a: speed(disk)}
)",
       "test.yaml:4:10: error: there is no function 'speed' (write norm(velocity(A of plate)))",
       {}},
      {"UnknownKeyAtTheTop",
       R"(titel: t
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:1:1: error: unknown key 'titel' in a problem (did you mean 'title'?)",
       {}},
      {"APointOfTimes",
       R"(given: {L: 1 s}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
ask: {m: mass(bar)}
)",
       "test.yaml:2:27: error: the coordinates of point 'A' are a time, not lengths (check the units of the data in "
       "them)",
       {}},
      {"APointWithoutUnits",
       R"(given: {L: 800}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], weight: 2 lb}}
ask: {m: mass(bar)}
)",
       "test.yaml:2:27: error: the coordinates of point 'A' have no unit (write lengths with their unit, such as [3 m, "
       "0, 0] or [3 ft, 0, 0]; data in them need one too)",
       {}},
      {"GravityWithoutUnits",
       R"(points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
gravity: [0, -1.62, 0]
ask: {W: weight(bar)}
)",
       "test.yaml:3:10: error: it is not clear whether this is a direction or an acceleration without its unit (write "
       "the acceleration with its unit, as in [0, -1.62 m/s^2, 0], or a direction such as -y)",
       {}},
      {"AUnitInPlaceOfADatum",
       R"(given: {n: 180/min}
ask: {n: n}
)",
       "test.yaml:1:16: error: 'min' is not defined (it is a unit too: one stands behind its number and a blank, as in "
       "3 m/s or 180 rpm)",
       {}},
      {"AUnitInPlaceOfAName",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
joints: {pin: {revolute: z, at: O, to: bar, angle: q}}
instants: {now: {q: 0, q': 180/min}}
ask: {a: angular_velocity(bar)}
)",
       "test.yaml:4:32: error: 'min' is not defined (it is a unit too: one stands behind its number and a blank, as in "
       "3 m/s or 180 rpm)",
       {}},
      {"ADecimalCommaInData",
       R"(given: {m: 2,5 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:1:14: error: a name is expected here, not '5 kg' (names begin with a letter; a decimal is written "
       "with a point: 0.8, "
       "not 0,8)",
       {}},
      {"AColonThatIsMissingInBraces",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:4:22: error: a ':' is missing behind 'mass' (write 'mass: m')",
       {}},
      {"AColonThatIsMissingBehindAHeading",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:3:7: error: a ':' is missing behind 'bodies' (write 'bodies:')",
       {}},
      {"AnAskThatIsNotIndented",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
T: kinetic_energy(bar)
)",
       "test.yaml:9:1: error: unknown key 'T' in a problem (indent it farther if it belongs to 'ask')",
       {}},
      {"APrimeBehindAComponent",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
define: {v: velocity(bar)}
gravity: -y
ask:
  T: v.x'
)",
       "test.yaml:10:8: error: a prime stands behind a component (write the component of the rate, v'.x, of a name v "
       "under define:)",
       {}},
      {"AMixedNumber",
       R"(given: {m: 2 kg, L: 1 1/2 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:1:23: error: two numbers stand side by side (a mixed number is written as a decimal or as one "
       "fraction: 1.5 or 3/2)",
       {}},
      {"AnInstantBehindAWord",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar) at 2 s
)",
       "test.yaml:9:26: error: 'at' cannot stand here (an instant stands behind '@': kinetic_energy(disk) @ 2 s)",
       {}},
      {"AGreekName",
       R"(given: {m: 2 kg, L: 1 m, ω: 2 rad/s}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:1:26: error: 'ω' cannot be a name (names have plain letters: write omega)",
       {}},
      {"AValueForALetter",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
letters: {q: 3 kg}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:7:14: error: '3 kg' is a value, where a unit is expected (write the unit alone; what has a value "
       "stands under given:)",
       {}},
      {"AQuantityForAUnit",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
letters: {q: mass}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:7:14: error: 'mass' is no unit (write kg)",
       {}},
      {"AnAskUnderFind",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
find:
  T: kinetic_energy(bar)
)",
       "test.yaml:9:6: error: 'kinetic_energy(bar)' is no unit (what is asked stands under ask:)",
       {}},
      {"NoUnitAtAll",
       "given: {m: 3 kg}\nask: {e: {of: m, unit: ''}}\n",
       "test.yaml:2:24: error: a unit is missing (write one such as m, kg*m^2/s or 1/s)",
       {}},
      {"ALimitOfNoDatum",
       R"(given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: {largest: mass, while: kinetic_energy(bar) < 3 J}
)",
       "test.yaml:9:16: error: 'mass' is no datum and no letter (one of these is varied: m, L)",
       {}},
      {"MarkdownAroundIt",
       R"(```yaml
given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
gravity: -y
ask:
  T: kinetic_energy(bar)
)",
       "test.yaml:1:1: error: a line of Markdown stands here (leave out the lines that begin with ```)",
       {}},
      {"ADecimalCommaInBraces",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 0,8 kg}}
ask: {m: mass(bar)}
)",
       "test.yaml:2:37: error: a key is expected here, not '8 kg' (a decimal is written with a point: 0.8, not 0,8)",
       {}},
      {"AMissingColonBeforeABrace",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies {bar: {rod: [O, A], mass: 2 kg}}
ask: {m: mass(bar)}
)",
       "test.yaml:2:7: error: a ':' and a blank are missing behind 'bodies' (write 'bodies: {...')",
       {}},
      {"ASpringOnOneBody",
       R"(points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
springs: {s: {from: bar, at: O, to: bar, end: A, stiffness: 3 N/m, free_length: 0.5 m}}
ask: {F: force(s on bar)}
)",
       "test.yaml:3:11: error: spring 's' joins 'bar' to itself (name two bodies, or ground, under from: and to:)",
       {}},
      {"AContactOfABodyWithItself",
       R"(points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
contacts: {c: {of: bar, against: bar, at: A, normal: y}}
ask: {a: acceleration(bar)}
)",
       "test.yaml:3:12: error: contact 'c' is between 'bar' and itself (name two bodies, or ground)",
       {}},
      {"AnImpactOfABodyWithItself",
       R"(points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
impacts: {c: {of: bar, against: bar, at: A, pushes: y}}
ask: {a: velocity(bar)}
)",
       "test.yaml:3:11: error: impact 'c' is between 'bar' and itself (name two bodies, or ground)",
       {}},
      {"ACordOnOneBody",
       R"(points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
cords: {c: {from: bar, at: O, to: bar, end: A}}
ask: {a: acceleration(bar)}
)",
       "test.yaml:3:9: error: cord 'c' is between 'bar' and itself (name two bodies, or ground)",
       {}},
      {"ANumberForAnAngularVelocity",
       R"(given: {w: 5 rad/s}
points: {O: [0, 0, 0]}
bodies: {ball: {sphere: {center: O, radius: 1 m}, mass: 2 kg}}
gravity: none
facts: {angular_velocity(ball): w}
ask: {T: kinetic_energy(ball)}
)",
       "test.yaml:5:33: error: expected an angular velocity in three components, a vector, not a number (give 'w' "
       "three components where it is stated, or write [0, 0, w] for one that has this size)",
       {}},
      {"AContactAgainstAParticle",
       R"(points: {O: [0, 0, 0], C: [0, 0.1 m, 0]}
bodies: {ball: {sphere: {center: C, radius: 0.1 m}, mass: 2 kg}, peg: {particle: O, mass: 1 kg}}
joints: {hold: {weld: O, to: peg}}
contacts: {c: {of: ball, against: peg, at: O, normal: y}}
ask: {v: velocity(ball)}
)",
       "test.yaml:4:12: error: 'peg' is a particle, which has no surface that 'ball' could touch (state the contact "
       "from the particle: of: peg, against: ball, with the normal into it)",
       {}},
      {"AContactBesideARod",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
contacts: {c: {of: bar, at: [0.5 m, -0.1 m, 0], normal: y}}
ask: {v: velocity(bar)}
)",
       "test.yaml:3:29: error: contact 'c' is 0.1 m off the surface of 'bar' (correct the point under at:, or give the "
       "body the shape that touches there)",
       {}},
      {"AContactBesideTheRodBelow",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0], C: [2 m, 0.1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}, ball: {sphere: {center: C, radius: 0.1 m}, mass: 1 kg}}
contacts: {c: {of: ball, against: bar, at: [2 m, 0, 0], normal: y}}
ask: {v: velocity(bar)}
)",
       "test.yaml:3:44: error: contact 'c' is 1 m off the surface of 'bar' (correct the point under at:, or give the "
       "body the shape that touches there)",
       {}},
      {"AMotionDrivenAndPushed",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
joints: {pin: {revolute: z, at: O, to: bar, rate: 0, accel: 2 rad/s^2, couple: 3 N*m}}
ask: {v: angular_velocity(bar)}
)",
       "test.yaml:3:80: error: joint 'pin' has rate:, accel: and couple: one too many: with rate and accel the couple "
       "is what is found (leave out accel: if the couple drives it, or the couple and ask for drive(...), or state "
       "drive(...) under instants: if an unknown is to follow from it)",
       {}},
      {"AQuantityAmongTheData",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
joints: {pin: {revolute: z, at: O, to: bar, rate: angular_velocity(bar).z}}
ask: {v: angular_velocity(bar)}
)",
       "test.yaml:3:51: error: 'angular_velocity(...)' cannot stand here: data are known before anything moves "
       "(quantities of bodies stand under instants:, define: and ask:; an unknown rate under find: and its condition "
       "under instants:)",
       {}},
      {"AWordThatJoinsMisspelt",
       R"(points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
ask: {H: angular_momentum(bar abut O)}
)",
       "test.yaml:3:31: error: 'abut' is no word that joins the arguments of a call (did you mean 'about'?)",
       {}},
      {"AnInertiaThatIsNoMap",
       R"(points: {A: [0, -1 m, 0]}
bodies: {bar: {mass: 2 kg, center: A, inertia: 3 kg*m^2}}
ask: {m: mass(bar)}
)",
       "test.yaml:2:48: error: expected a map of keys for 'inertia' (its keys are x, y, z, xy, yx, yz, zy, zx, xz, "
       "about, "
       "axes, axis, axial, transverse, rest)",
       {}},
      {"ADatumMisspeltAsACoordinate",
       R"(given: {theta: 30 deg}
bodies: {rod: {rod: [[0, 0, 0], [0, -1 m, 0]], mass: 2 kg}}
joints: {pin: {revolute: z, at: [0, 0, 0], to: rod, angle: theata, rate: 0}}
gravity: -y
ask: {a: angular_acceleration(rod).z}
)",
       "test.yaml:3:60: error: 'theata' is no datum, and 'theta', which is one, is used nowhere (did you mean 'theta'? "
       "If 'theata' is to name a coordinate, remove 'theta')",
       {}},
      {"ANormalThatIsNotThatOfTheSphere",
       R"(points: {G: [0, 0.2 m, 0], C: [0, 0, 0]}
bodies: {ball: {sphere: {center: G, radius: 0.2 m}, mass: 1 kg}}
contacts: {floor: {of: ball, at: C, normal: [1, 1, 0], no_slip: true}}
gravity: -y
facts: rest
ask: {a: acceleration(ball)}
)",
       "test.yaml:3:45: error: the normal of contact 'floor' does not stand on the surface of 'ball' at that point "
       "(there it goes along the radius: correct it, or the point under at:)",
       {}},
      {"ANormalThatIsNotThatOfTheCylinder",
       R"(points: {G: [0, 0.2 m, 0], C: [0.12 m, 0.04 m, 0]}
bodies: {roller: {cylinder: {center: G, axis: z, radius: 0.2 m, length: 1 m}, mass: 1 kg}}
contacts: {floor: {of: roller, at: C, normal: y, no_slip: true}}
gravity: -y
facts: rest
ask: {a: acceleration(roller)}
)",
       "test.yaml:3:47: error: the normal of contact 'floor' does not stand on the surface of 'roller' at that point "
       "(there it lies in the plane through the axis: correct it, or the point under at:)",
       {}},
      {"ARateOfTimeBesideAnotherAcceleration",
       R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {rod: {rod: [O, A], mass: 3 kg}}
joints: {pin: {revolute: z, at: O, to: rod, rate: 2 rad/s^2 * time, accel: 3 rad/s^2}}
gravity: none
ask: {a: angular_acceleration(rod)}
)",
       "test.yaml:3:76: error: these cannot all hold together: joint 'pin': rate as a function of time; joint 'pin': "
       "accel (correct or remove one of them)",
       {}},
      {"DuplicateKey",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg, mass: 4 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:74: error: the key 'mass' stands here a second time; the first is in line 3, column 62 (remove one "
       "of the two)",
       {}},
      {"UnknownUsedNowhere",
       R"(title: t with k
find: {w: rad/s, k: N/m}
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {r: {rod: [O, A], mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: r, rate: w}}
gravity: none
instants: {now: {kinetic_energy(r): 3 J}}
ask: {w: w, k: k}
)",
       "test.yaml:2:18: error: the unknown 'k' stands nowhere in the figure and the facts: nothing can fix it "
       "(write it where its value belongs, or remove it)",
       {}},
      {"UnknownThatIsMisspeltWhereItIsUsed",
       R"(title: t
find: {omega: rad/s}
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {r: {rod: [O, A], mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: r, rate: omgea}}
gravity: none
instants: {now: {kinetic_energy(r): 3 J}}
ask: {w: omega}
)",
       "test.yaml:5:49: error: 'omgea' is not defined (did you mean 'omega'?)",
       {}},
      {"UnknownOfASituationUsedNowhere",
       R"(title: t
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {r: {rod: [O, A], mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: r, rate: w}}
gravity: none
situations:
  slow: {given: {w: 1 rad/s}}
  fast: {find: {w: rad/s, v: m/s}, instants: {now: {kinetic_energy(r): 3 J}}}
ask: {K: kinetic_energy(r) @ slow, v: v @ fast}
)",
       "test.yaml:8:27: error: the unknown 'v' stands nowhere in the figure and the facts: nothing can fix it "
       "(write it where its value belongs, or remove it)",
       {}},
      {"WrongDimension",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 s}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:54: error: expected a length, not a time",
       {}},
      {"MissingUnit",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:54: error: expected a length, not the number 0.2 without unit (write its unit after a blank, as in "
       "0.2 m)",
       {}},
      {"MassInPounds",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 10 lb}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:68: error: the mass of body 'disk' is given as a force (write weight: 10 lb or mass: 10 lbm)",
       {}},
      {"MassInOunces",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 10 oz}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:68: error: the mass of body 'disk' is given as a force (write weight: 10 oz or mass: 10 ozm)",
       {}},
      {"WeightInKilograms",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, weight: 10 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:70: error: the weight of body 'disk' is given as a mass (write mass: 10 kg)",
       {}},
      {"NegativeMass",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: -3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:68: error: the mass of body 'disk' is negative (a part that is cut out has hole: true)",
       {}},
      {"NegativeRadius",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: -0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:23: error: disk 'disk': the radius is -0.2 m; it must be more than zero",
       {}},
      {"NegativeLength",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {cylinder: {center: O, axis: y, radius: 0.2 m, length: -1 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:27: error: cylinder 'disk': its length must be more than zero",
       {}},
      {"CrossedPolygon",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {polygon: [O, [1 m, 1 m, 0], [1 m, 0, 0], [0, 1 m, 0]], mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:26: error: polygon 'disk': the side from vertex 1 to 2 meets the side from vertex 3 to 4; list the "
       "vertices in order round the plate",
       {}},
      {"RodWithoutLength",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {rod: [O, O], mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:22: error: rod 'disk': end A and end B coincide at (0, 0, 0); give two different points",
       {}},
      {"InnerRadiusTooLarge",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {tube: {center: O, axis: y, radius: 0.2 m, inner_radius: 0.3 m, length: 1 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:23: error: tube 'disk': the inner radius 0.3 m must be less than the outer radius 0.2 m",
       {}},
      {"TriangleInequality",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {mass: 3 kg, center: O, inertia: {x: 2 kg*m^2, y: 3 kg*m^2, z: 7 kg*m^2}}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:49: error: body 'disk': no rigid body has these moments: I_x + I_y >= I_z is broken: 2 + 3 < 7 kg "
       "m^2 (short by 2 kg m^2)",
       {}},
      {"MomentsThatNoBodyHasInTheUnitsOfTheFile",
       R"(title: t
points: {O: [0, 0, 0]}
bodies: {disk: {weight: 3 lb, center: O, inertia: {x: 2 lb*ft*s^2, y: 3 lb*ft*s^2, z: 7 lb*ft*s^2}}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:51: error: body 'disk': no rigid body has these moments: I_x + I_y >= I_z is broken: 2 + 3 < 7 "
       "lb*ft*s^2 (short by 2 lb*ft*s^2)",
       {}},
      {"ACordOfABody",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {p: {particle: O, mass: 3 kg}}
cords: {c: {of: p, at: A, end: O}}
ask: {a: acceleration(p)}
)",
       "test.yaml:4:13: error: unknown key 'of' in a cord (did you mean 'to'?)",
       {}},
      {"NegativeMoment",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {mass: 3 kg, center: O, inertia: {x: -2 kg*m^2, y: 3 kg*m^2, z: 4 kg*m^2}}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:53: error: a moment of inertia of body 'disk' is negative",
       {}},
      {"MatrixNotSymmetric",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {mass: 3 kg, center: O, inertia_matrix: {rows: [[2 kg*m^2, 1 kg*m^2, 0], [0, 3 kg*m^2, 0], [0, 0, 4 kg*m^2]]}}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:56: error: body 'disk': a tensor of inertia is symmetric, but its entry xy is 1 and yx is 0 kg m^2 "
       "(they differ by 1)",
       {}},
      {"HolesLeaveNothing",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {parts: {p: {sphere: {center: O, radius: 1 m}, mass: 1 kg}, q: {sphere: {center: O, radius: 0.5 m}, mass: 2 kg, hole: true}}}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:10: error: body 'disk': the mass is -1 kg; a body's mass must not be negative (only a hole in a "
       "larger body has a negative mass)",
       {}},
      {"TwoShapes",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {rod: [O, A], sphere: {center: O, radius: 1 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:30: error: body 'disk' has two shapes, 'rod' and 'sphere' (a body of several shapes lists them "
       "under parts:)",
       {}},
      {"NoMass",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {rod: [O, A]}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:10: error: body 'disk' has no mass (write mass:, weight: or density:)",
       {}},
      {"Infinite",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 1e100*1e60 m}, mass: 1e99 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:23: error: disk 'disk': its mass properties are beyond the range of numbers (its lengths are too "
       "large)",
       {}},
      {"NotANumber",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: nan}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:68: error: 'nan' is not defined (define it under given:, letters:, points: or directions:)",
       {}},
      {"DivisionByZero",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 1 kg/0}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:72: error: division by zero",
       {}},
      {"MeshOutside",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {mesh: {file: ../wheel.stl, unit: m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:23: error: mesh '../wheel.stl': it does not lie in the folder of the problem file (copy it there "
       "and name it without a path)",
       {}},
      {"MeshMissing",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {mesh: {file: nothing.stl, unit: m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:23: error: mesh 'nothing.stl': the file does not exist",
       {}},
      {"EmptyBodies",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:42: error: there is no body 'disk' (the problem has none)",
       {}},
      {"EmptyParts",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {parts: {}}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:3:24: error: expected named parts (write parts: {rim: {ring: {...}}, hub: {disk: {...}}})",
       {}},
      {"UndefinedPoint",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: Q, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:35: error: 'Q' is not defined (define it under given:, letters:, points: or directions:)",
       {}},
      {"MisspeltUnitOfAProduct",
       R"(title: t
given: {m: 5 kg*mmm}
bodies: {b: {particle: [0, 0, 0], mass: m}}
ask: {v: velocity(b)}
)",
       "test.yaml:2:17: error: 'mmm' is not defined (if a unit is meant, write 'mm'; if a datum, define it under "
       "given: "
       "or letters:)",
       {}},
      {"MisspeltDatum",
       R"(given: {radius: 0.2 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: raduis}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:54: error: 'raduis' is not defined (did you mean 'radius'?)",
       {}},
      {"UndefinedBody",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: dsk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:42: error: there is no body 'dsk' (did you mean 'disk'?)",
       {}},
      {"UndefinedHolder",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, from: frame, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:44: error: there is no body or frame 'frame' (known: ground, disk)",
       {}},
      {"UndefinedJoint",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: drive(shft)}
)",
       "test.yaml:5:16: error: nothing named 'shft' has a drive (did you mean 'shaft'?)",
       {}},
      {"UndefinedBodyAsked",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: kinetic_energy(dsk)}
)",
       "test.yaml:5:25: error: there is no body 'dsk' (did you mean 'disk'?)",
       {}},
      {"UnknownFunction",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: kinetic_enrgy(disk)}
)",
       "test.yaml:5:10: error: there is no function 'kinetic_enrgy' (did you mean 'kinetic_energy'?)",
       {}},
      {"WrongUnitOfAnswer",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: {of: kinetic_energy(disk), unit: kg}}
)",
       "test.yaml:5:7: error: the answer is a moment or an energy, but kg is a unit of a mass (ask for it in a unit "
       "such as N*m)",
       {}},
      {"WrongDimensionOfRate",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 m/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:54: error: expected an angular velocity, not a velocity",
       {}},
      {"ForceOnAHinge",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s, force: 3 N}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:70: error: joint 'shaft' turns: it has no 'force' (write 'couple')",
       {}},
      {"AxisWithoutPlace",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:10: error: joint 'shaft' has a direction but no place (write at: P, a point of its axis)",
       {}},
      {"ScrewWithoutPitch",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {screw: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:10: error: joint 'shaft' is a screw without a pitch (write pitch: 2 mm/rev)",
       {}},
      {"TwoKinds",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, prismatic: x, at: O, to: disk}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:42: error: joint 'shaft' is both revolute and prismatic (a joint has one kind)",
       {}},
      {"JoinedToItself",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, from: disk, to: disk}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:10: error: joint 'shaft' joins 'disk' to itself",
       {}},
      {"TooManyFacts",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
instants: {now: {angular_velocity(disk): [0, 3 rad/s, 0]}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:18: error: these cannot all hold together: joint 'shaft': rate; 'now': angular_velocity(disk) "
       "(correct or remove one of them)",
       {}},
      {"AccelerationAndLoadContradict",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
gravity: none
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s, accel: 3 rad/s^2, couple: 1 N*m}}
ask: {a: angular_acceleration(disk)}
)",
       "test.yaml:5:89: error: joint 'shaft' has rate:, accel: and couple: one too many: with rate and accel the "
       "couple "
       "is what is found (leave out accel: if the couple drives it, or the couple and ask for drive(...), or state "
       "drive(...) under instants: if an unknown is to follow from it)",
       {}},
      {"SupportsCannotCarry",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
gravity: -x
joints: {shaft: {revolute: y, to: disk, rate: 2 rad/s, supports: {O: [z]}}}
ask: {a: reaction(O)}
)",
       "test.yaml:5:10: error: nothing carries what the motion needs: forces on disk along x (let a support or contact "
       "carry it, or leave a freedom for it)",
       {}},
      {"SupportListsADirectionTwice",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, to: disk, rate: 2 rad/s, supports: {O: [z, -z]}}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:67: error: support 'O' lists the direction -z twice",
       {}},
      {"UnknownKindOfSupport",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, to: disk, rate: 2 rad/s, supports: {O: jurnal}}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:70: error: 'jurnal' is no kind of support (did you mean 'journal'?)",
       {}},
      {"CyclicData",
       R"(given: {r: s, s: r}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: r}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:1:9: error: 'r' is defined by itself: given r -> given s -> given r",
       {}},
      {"CyclicPoints",
       R"(title: t
points: {O: P, P: O}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:2:10: error: 'O' is defined by itself: point O -> point P -> point O",
       {}},
      {"CyclicDefinitions",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
define: {e: f, f: e}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: e + kinetic_energy(disk)}
)",
       "test.yaml:3:19: error: 'e' is defined by itself",
       {}},
      {"AmbiguousName",
       R"(given: {O: 3 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:32: error: 'O' could mean a datum under given: or a point (rename one of them)",
       {}},
      {"AmbiguousAxis",
       R"(given: {x: 3 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: x, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:5:28: error: 'x' could mean a datum under given: or an axis (rename one of them)",
       {}},
      {"LoopDoesNotClose",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies:
  b0: {rod: [O, A], mass: 1 kg}
  b1: {rod: [A, [1 m, 1 m, 0]], mass: 1 kg}
joints:
  j0: {revolute: z, at: O, to: b0, angle: 0.3 rad, rate: 1 rad/s}
  j1: {revolute: z, at: A, from: b0, to: b1}
  j2: {revolute: z, at: [1 m, 1 m, 0], to: b1}
ask: {a: kinetic_energy(b0)}
)",
       "test.yaml:7:3: error: the mechanism does not close in the stated pose: joint 'j2' along x is open by 0.311 "
       "(the values of the coordinates do not fit together, or no position of the others closes the loop)",
       {}},
      {"LoopDoesNotCloseInAttitude",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies:
  b0: {rod: [O, A], mass: 1 kg}
  b1: {rod: [A, [1 m, 1 m, 0]], mass: 1 kg}
joints:
  j0: {revolute: z, at: O, to: b0, angle: 0.3 rad, rate: 1 rad/s}
  j1: {ball: A, from: b0, to: b1}
  j2: {prismatic: x, at: O, to: b1}
ask: {a: kinetic_energy(b0)}
)",
       "test.yaml:7:3: error: the mechanism does not close in the stated pose: joint 'j2' about z is open by 0.172 "
       "(the values of the coordinates do not fit together, or no position of the others closes the loop)",
       {}},
      {"WeldedLoopTurned",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies:
  b0: {rod: [O, A], mass: 1 kg}
joints:
  j0: {revolute: y, at: O, to: b0, angle: 0.3 rad, rate: 1 rad/s}
  j1: {weld: O, to: b0}
ask: {a: kinetic_energy(b0)}
)",
       "test.yaml:6:3: error: the mechanism does not close in the stated pose: joint 'j1' about y is open by 0.3 (the "
       "values of the coordinates do not fit together, or no position of the others closes the loop)",
       {}},
      {"NothingAsked",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
)",
       "test.yaml:1:1: error: the file asks nothing (write ask: {a: angular_momentum(disk about G)})",
       {}},
      {"AsksAFormula",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: 3 kg*4 m}
)",
       "test.yaml:5:7: error: 'a' asks nothing of the model: it is a formula of the data (ask for a quantity, such as "
       "angular_momentum(BODY about POINT))",
       {}},
      {"SetUnknownName",
       R"(title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "--set q: error: the problem has no letter or datum 'q' (it has none at all)",
       {{"q", "3 m"}}},
      {"SetMisspeltName",
       R"(given: {radius: 0.2 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: radius}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "--set raduis: error: the problem has no letter or datum 'raduis' (did you mean 'radius'?)",
       {{"raduis", "3 m"}}},
      {"SetWrongDimension",
       R"(given: {r: 0.2 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: r}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "--set r=3 kg: error: r is a length, but 3 kg is a mass",
       {{"r", "3 kg"}}},
      {"SetMissingUnit",
       R"(given: {r: 0.2 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: r}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "--set r=3: error: r is a length, but 3 is a pure number (write r=3 m)",
       {{"r", "3"}}},
      {"SetNoNumber",
       R"(given: {r: 0.2 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: r}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "--set r=abc: error: 'abc' is not defined (define it under given:, letters:, points: or directions:)",
       {{"r", "abc"}}},
      {"SetNegativeRadius",
       R"(given: {r: 0.2 m}
title: t
points: {O: [0, 0, 0], A: [0, 1 m, 0]}
bodies: {disk: {disk: {center: O, normal: y, radius: r}, mass: 3 kg}}
joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}
ask: {a: angular_momentum(disk about O)}
)",
       "test.yaml:4:23: error: disk 'disk': the radius is -1 m; it must be more than zero",
       {{"r", "-1 m"}}},
  };
  return list;
}

// Right angles and planes typed with few digits pass where the answers stand the check on particles; else they are
// named.
TEST(Shapes, NearlyRightAnglesPassAndWarpedPlatesDoNot) {
  const auto plate = [](const std::string& shape) {
    return "title: t\nbodies: {p: {" + shape +
           ", mass: 3 kg}}\njoints: {s: {revolute: x, at: [0, 0, 0], to: p, rate: 2 rad/s}}\nask: {a: "
           "\"angular_momentum(p about [0, 0, 0])\"}\n";
  };
  const SolvedStatement skew = solve(plate("rectangle: {corners: [[0, 0, 0], [1 m, 0, 0], [1.0000005 m, 1 m, 0]]}"));
  EXPECT_EQ(skew.solutions[0].asks[0].state, AskState::found) << skew.solutions[0].asks[0].reason;
  EXPECT_EQ(failure_of([&] {
              solve(plate("polygon: [[0, 0, 0], [1 m, 0, 0.0000005 m], [1 m, 1 m, 0], [0, 1 m, 0]]"));
            }).substr(0, 58),
            "test.yaml:2:23: error: polygon 'p': vertex 4 at (0, 1, 0) ");
}

class Mistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreNamedWithTheirPlace) {
  const Mistake& mistake = GetParam();
  EXPECT_EQ(failure_of([&] { solve(mistake.text, mistake.sets); }), mistake.message);
}
INSTANTIATE_TEST_SUITE_P(Statement, Mistakes, ::testing::ValuesIn(mistakes()),
                         [](const auto& mistake) { return std::string(mistake.param.name); });

// The first solution's answers by state and reason.
struct Outcome {
  AskState state;
  std::string reason;
};
std::vector<Outcome> outcomes(const std::string& text) {
  const SolvedStatement solved = solve(text);
  std::vector<Outcome> list;
  for (const SolvedAsk& ask : solved.solutions.at(0).asks) list.push_back({ask.state, ask.reason});
  return list;
}

const std::string head = "title: t\npoints: {O: [0, 0, 0], A: [0, 1 m, 0], C: [0, 2 m, 0]}\n";
const std::string disk = "bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: 3 kg}}\n";

TEST(WithoutAnswer, GravityUnsaidWhereItMatters) {
  const auto found = outcomes(head + disk +
                              "joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}\n"
                              "ask: {a: force(shaft on disk), b: kinetic_energy(disk)}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_EQ(found[0].reason, "it depends on gravity, of which nothing is said: write gravity: -y or gravity: none");
  EXPECT_EQ(found[1].state, AskState::found);
}

TEST(WithoutAnswer, TooFewFactsAreNamed) {
  const auto found = outcomes(
      head + disk + "joints: {shaft: {revolute: y, at: O, to: disk}}\nask: {a: kinetic_energy(disk), b: mass(disk)}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_EQ(found[0].reason, "nothing fixes the rate of joint 'shaft': state it under joints: or instants:");
  EXPECT_EQ(found[1].state, AskState::found);
}

// No equation at all: the velocities are open, not zero.
TEST(WithoutAnswer, AFreeBodyOfWhichNothingIsSaid) {
  const auto found = outcomes(
      head + disk + "ask: {a: kinetic_energy(disk), b: angular_velocity(disk), c: momentum(disk), d: mass(disk)}\n");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found[i].state, AskState::undetermined) << i;
  EXPECT_NE(found[2].reason.find("velocity of disk along x"), std::string::npos) << found[2].reason;
  EXPECT_EQ(found[3].state, AskState::found);
}

TEST(WithoutAnswer, AMassGivenAsAny) {
  const auto found = outcomes(head +
                              "bodies: {disk: {disk: {center: O, normal: y, radius: 0.2 m}, mass: any}}\n"
                              "joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}\n"
                              "ask: {a: kinetic_energy(disk), b: angular_velocity(disk)}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_EQ(found[0].reason, "it depends on a value that is given as `any`");
  EXPECT_EQ(found[1].state, AskState::found);
}

// Any value that is taken for an open moment belongs to a possible body, whatever the size of the others.
TEST(WithoutAnswer, TheRateOfANormThatIsZero) {
  const auto found = outcomes(
      "title: t\ngravity: -y\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {bar: {rod: [O, A], mass: 1 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: bar, angle: q, rate: 0}}\ndefine: {s: norm(velocity(A of bar))}\n"
      "ask: {a: \"s'\", b: s}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_TRUE(found[0].reason.starts_with("it has no finite value here: ")) << found[0].reason;
  EXPECT_EQ(found[1].state, AskState::found);
}

TEST(WithoutAnswer, AnInertiaThatIsNotStated) {
  const auto found =
      outcomes(head +
               "bodies: {crank: {mass: 3 kg, center: A}}\n"
               "joints: {shaft: {revolute: z, at: O, to: crank, rate: 2 rad/s, accel: 0}}\n"
               "ask: {a: kinetic_energy(crank), b: momentum(crank), c: moment_of_inertia(crank about z at O)}\n");
  for (const std::size_t i : {0u, 2u}) {
    EXPECT_EQ(found[i].state, AskState::undetermined) << i;
    EXPECT_EQ(found[i].reason,
              "it depends on a value that is given as `any`, or on the inertia of 'crank', which is not stated");
  }
  EXPECT_EQ(found[1].state, AskState::found);
}

TEST(WithoutAnswer, MomentsGivenAsAny) {
  for (const char* unit : {"kg*m^2", "g*mm^2", "t*m^2"}) {
    const std::string u = unit;
    const auto one = [&](const std::string& inertia) {
      return solve(head + "bodies: {disk: {mass: 3 kg, center: O, inertia: {" + inertia +
                   "}}}\njoints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}\n"
                   "ask: {a: component(angular_momentum(disk about O) along x), b: component(angular_momentum(disk "
                   "about O) along y), "
                   "c: moment_of_inertia(disk about z at O)}\n");
    };
    const double size = parse_unit(unit).factor;
    const SolvedStatement z = one("x: 0.001 " + u + ", y: 0.002 " + u + ", z: any");
    EXPECT_EQ(z.solutions[0].asks[1].state, AskState::found);
    EXPECT_NEAR(z.solutions[0].asks[1].value.number, 0.004 * size, 1e-12 * size);
    EXPECT_EQ(z.solutions[0].asks[2].state, AskState::undetermined);
    const SolvedStatement two = one("x: any, y: 2 " + u + ", z: any");
    EXPECT_NEAR(two.solutions[0].asks[1].value.number, 4 * size, 1e-12 * size);
    const SolvedStatement rest = one("xy: 5 " + u + ", rest: any");
    EXPECT_EQ(rest.solutions[0].asks[0].state, AskState::found);
    EXPECT_NEAR(rest.solutions[0].asks[0].value.number, -10 * size, 1e-11 * size);  // H_x = -I_xy w_y
    EXPECT_EQ(rest.solutions[0].asks[1].state, AskState::undetermined);
  }
}

// What is asked has no value at rest: that the motion is open comes first.
TEST(WithoutAnswer, OpenVelocitiesOfWhatHasNoValueAtRest) {
  const auto found = outcomes(
      "title: t\ngravity: none\npoints: {O: [0, 0, 0]}\n"
      "bodies: {ball: {mass: 1 kg, center: O, inertia: {axis: [1, 1, 0], axial: 1 kg*m^2, transverse: 3 kg*m^2}}}\n"
      "instants: {now: {angular_velocity(ball): [any, 0, 0]}}\n"
      "ask: {a: precession_rate(ball), b: mass(ball)}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_EQ(found[0].reason, "nothing fixes angular velocity of ball along x: state it under joints: or instants:");
  EXPECT_EQ(found[1].state, AskState::found);
}
TEST(WithoutAnswer, AnImpactOfWhichTheMotionBeforeIsOpen) {
  const auto found = outcomes(
      "title: t\npoints: {G: [0, 0, 0], C: [0.4 m, 0, 0.7 m]}\n"
      "bodies: {plate: {rectangle: {center: G, sides: [0.8 m * x, 1.4 m * z]}, mass: 3 kg}}\n"
      "impacts: {stop: {of: plate, against: ground, at: C, pushes: +y, restitution: 0}}\n"
      "instants: {before: {angular_velocity(plate): [0, 0, 0]}}\nask: {a: angular_velocity(plate)}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_EQ(found[0].reason,
            "whether impact 'stop' happens is not determined: nothing fixes velocity of plate along y before it: "
            "state it under joints: or instants:");
}
// A cord is not to blame for a fact that no way of its acting allows.
TEST(Contradictions, OfABlowWithACord) {
  const std::string file =
      "title: t\npoints: {A: [0, 1 m, 0], B: [0, -1 m, 0]}\n"
      "bodies: {rod: {rod: [A, B], mass: 3 kg}}\ncords: {wire: {holds: rod, at: A, pulls: +y}}\n"
      "impulses: {blow: {body: rod, at: B, value: [2 N*s, 0, 0]}}\n";
  EXPECT_EQ(failure_of([&] {
              solve(file + "instants: {before: rest, after: {velocity(rod).x: 0}}\nask: {a: velocity(rod)}\n");
            }),
            "test.yaml:6:34: error: these cannot all hold together: impulses on rod along x; 'after': velocity(rod).x "
            "(correct or remove one of them)");
}
TEST(Contradictions, OfAFactWithWhatHoldsTheBody) {
  EXPECT_EQ(failure_of([&] {
              solve(head + disk +
                    "gravity: none\njoints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s, accel: 0}}\n"
                    "instants: {now: {acceleration(disk).y: 3 m/s^2}}\nask: {a: force(shaft on disk)}\n");
            }),
            "test.yaml:6:18: error: this cannot hold: 'now': acceleration(disk).y; how the bodies are held does not "
            "allow it (correct or remove it, or free what holds it)");
}

TEST(WithoutAnswer, ADirectionWhereAnEdgeIsMeant) {
  EXPECT_EQ(
      failure_of([&] {
        solve(
            "title: t\npoints: {O: [0, 0, 0], A: [2 m, 0, 0], B: [0, 1 m, 0]}\n"
            "bodies: {b: {prism: {base: [O, A, B], along: z}, mass: 3 kg}}\nask: {c: center(b)}\n");
      }),
      "test.yaml:3:46: error: expected a length, not a pure number (a direction has no size: write one before it, "
      "as in 2 m * z)");
}

TEST(WithoutAnswer, SupportsThatShareALoad) {
  const auto found = outcomes(head + disk +
                              "gravity: -x\njoints: {shaft: {revolute: y, to: disk, rate: 2 rad/s, supports: {O: ball, "
                              "A: [x, z], C: [x, z]}}}\n"
                              "ask: {a: reaction(A).x, b: force(shaft on disk)}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_NE(found[0].reason.find("force(A) along x, force(O) along x and force(C) along x share the same load"),
            std::string::npos)
      << found[0].reason;
  EXPECT_EQ(found[1].state, AskState::found);
}

TEST(WithoutAnswer, ASlackCord) {
  const auto found =
      outcomes(head + disk +
               "gravity: -y\ncords: {wire: {at: [0, -1 m, 0], to: disk, end: O}}\n"
               "joints: {g: {prismatic: y, to: disk, rate: 0 m/s}}\nask: {a: tension(wire), b: mass(disk)}\n");
  EXPECT_EQ(found[0].state, AskState::refused);
  EXPECT_EQ(found[0].reason, "the cord 'wire' would have to push: it goes slack");
  EXPECT_EQ(found[1].state, AskState::found);
}

// The digit for the letter would be the origin, wherever the point is.
TEST(WithoutAnswer, TheDigitIsNoPoint) {
  const std::string bar =
      "bodies: {bar: {particle: A, mass: 3 kg}}\ngravity: none\nask: {a: moment_of_inertia(bar about z at 0)}\n";
  EXPECT_NE(failure_of([&] {
              outcomes("title: t\npoints: {O: [1 m, 0, 0], A: [2 m, 0, 0]}\n" + bar);
            }).find("0 is a number, and a point is meant here (write O, the letter, for the point of that name"),
            std::string::npos);
  EXPECT_NE(failure_of([&] {
              outcomes("title: t\npoints: {A: [2 m, 0, 0]}\n" + bar);
            }).find("write [0, 0, 0] for the origin"),
            std::string::npos);
}

TEST(WithoutAnswer, AContactThatWouldPull) {
  const auto found =
      outcomes(head +
               "bodies: {ball: {sphere: {center: A, radius: 1 m}, mass: 3 kg}}\ngravity: y\n"
               "contacts: {floor: {of: ball, at: O, normal: y, carries: [push]}}\n"
               "joints: {g: {prismatic: y, to: ball, rate: 0 m/s}}\nask: {a: reaction(floor), b: mass(ball)}\n");
  EXPECT_EQ(found[0].state, AskState::refused);
  EXPECT_EQ(found[0].reason,
            "the contact 'floor' would have to pull: it is lost, if its normal points into 'ball' as it should");
  EXPECT_EQ(found[1].state, AskState::found);
}

TEST(WithoutAnswer, LettersWithoutValue) {
  const SolvedStatement solved = solve("letters: {m: kg, r: m}\n" + head +
                                           "bodies: {disk: {disk: {center: O, normal: y, radius: r}, mass: m}}\n"
                                           "joints: {shaft: {revolute: y, at: O, to: disk, rate: 2 rad/s}}\n"
                                           "ask: {a: mass(disk), b: kinetic_energy(disk), c: angular_velocity(disk)}\n",
                                       {{"r", "0.2 m"}});
  EXPECT_EQ(solved.solutions[0].asks[0].state, AskState::needs_letters);
  EXPECT_EQ(solved.solutions[0].asks[0].letters, std::vector<std::string>{"m"});
  EXPECT_EQ(solved.solutions[0].asks[1].letters, std::vector<std::string>{"m"});
  EXPECT_EQ(solved.solutions[0].asks[2].state, AskState::found);
}

// The power of the weight is the product of gravity and a velocity: neither moves it while the other is zero.
TEST(WithoutAnswer, AProductOfTwoOpenThings) {
  const auto found = outcomes(
      head + disk + "ask: {a: rate(potential_energy(disk)), b: dot(velocity(disk) with angular_velocity(disk))}\n");
  EXPECT_EQ(found[0].state, AskState::undetermined);
  EXPECT_EQ(found[0].reason, "it depends on several things that are left open: gravity and velocities");
  EXPECT_EQ(found[1].state, AskState::undetermined);
}

// Precession and spin about one line: their rates count only together, and so do the answers that are found.
TEST(WithoutAnswer, ASingularConfigurationHasWhatItStillFixes) {
  const auto found = outcomes(head + disk +
                              "gravity: none\njoints: {top: {ball: O, to: disk, angles: [phi: y, theta: x, psi: y], "
                              "freedoms: {phi: {rate: 1 rad/s}, "
                              "theta: {rate: 0 rad/s}, psi: {rate: 1 rad/s}}}}\nask: {a: angular_acceleration(disk), "
                              "b: kinetic_energy(disk), c: \"phi''\"}\n");
  EXPECT_EQ(found[0].state, AskState::found);
  EXPECT_EQ(found[1].state, AskState::found);
  EXPECT_EQ(found[2].state, AskState::undetermined);
}

// Meshes in the folder of the problem file.
class Meshes : public ::testing::Test {
 protected:
  Meshes() : folder_(std::filesystem::temp_directory_path() / ("poinsot_mesh_test_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Meshes() override { std::filesystem::remove_all(folder_); }

  // A tetrahedron with edges of one along the axes; faces as listed.
  SolvedStatement with_faces(const std::string& faces) const {
    std::ofstream(folder_ / "t.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" << faces;
    return solve(text("t.obj"), {}, (folder_ / "test.yaml").string());
  }
  static std::string text(const std::string& file) {
    return "title: t\nbodies: {t: {mesh: {file: " + file +
           ", unit: m}, density: 6 kg/m^3}}\nask: {a: mass(t), b: center(t)}\n";
  }
  std::string failure(const std::string& faces) const {
    const std::string message = failure_of([&] { with_faces(faces); });
    const std::string place = (folder_ / "test.yaml").string() + ":2:20: error: ";
    return message.starts_with(place) ? message.substr(place.size()) : message;
  }

  std::filesystem::path folder_;
};

TEST_F(Meshes, AClosedMeshIsASolid) {
  const SolvedStatement solved = with_faces("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_NEAR(solved.solutions[0].asks[0].value.number, 1, 1e-14);
  EXPECT_NEAR(solved.solutions[0].asks[1].value.vector.x, 0.25, 1e-14);
}
TEST_F(Meshes, AnOpenMesh) {
  const std::string message = failure("f 1 3 2\nf 1 2 4\nf 1 4 3\n");
  EXPECT_NE(message.find("t.obj"), std::string::npos) << message;
  EXPECT_NE(message.find("a body needs a closed surface"), std::string::npos) << message;
}
TEST_F(Meshes, AMeshInsideOut) {
  const std::string message = failure("f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  EXPECT_NE(message.find("t.obj"), std::string::npos) << message;
  EXPECT_NE(message.find("inside out"), std::string::npos) << message;
}
TEST_F(Meshes, JunkForAMesh) {
  const std::string message = failure("f 1 2 99\n");
  EXPECT_EQ(message.find(folder_.string()), std::string::npos) << message;
  EXPECT_NE(message.find("mesh 't.obj'"), std::string::npos) << message;
}
TEST_F(Meshes, ALinkThatLeadsOutOfTheFolder) {
  std::filesystem::create_symlink("/etc/hostname", folder_ / "link.stl");
  EXPECT_NE(failure_of([&] {
              solve(text("link.stl"), {}, (folder_ / "test.yaml").string());
            }).find("does not lie in the folder of the problem file"),
            std::string::npos);
}

// Names behind names, and definitions that double with every line, end in a message and not in minutes.
TEST(Limits, NamesBehindNames) {
  std::string given;
  for (int i = 0; i < 5000; ++i) given += "  r" + std::to_string(i) + ": r" + std::to_string(i + 1) + "\n";
  EXPECT_EQ(failure_of([&] {
              solve("title: t\ngiven:\n" + given +
                    "  r5000: 0.2 m\nbodies: {p: {particle: [0, 0, 0], mass: 1 kg}}\nask: {a: mass(p)}\n");
            }),
            "test.yaml:203:3: error: 'r200' is defined through more than 200 other names (define it more directly)");
}
TEST(Limits, DefinitionsThatDouble) {
  std::string define;
  for (int i = 0; i < 40; ++i)
    define += "  d" + std::to_string(i) + ": d" + std::to_string(i + 1) + " + d" + std::to_string(i + 1) + "\n";
  EXPECT_EQ(failure_of([&] {
              solve("title: t\ndefine:\n" + define +
                    "  d40: mass(p)\nbodies: {p: {particle: [0, 0, 0], mass: 1 kg}}\nask: {a: d0}\n");
            }),
            "test.yaml:30:3: error: 'd27' stands for an expression of more than 20000 operations (define it with fewer "
            "of the other definitions)");
}
TEST(Limits, MoreBodiesThanCanBeSolved) {
  std::string bodies;
  for (int i = 0; i < 101; ++i) bodies += "  b" + std::to_string(i) + ": {particle: [0, 0, 0], mass: 1 kg}\n";
  EXPECT_EQ(failure_of([&] { solve("title: t\nbodies:\n" + bodies + "ask: {a: mass(b0)}\n"); }),
            "test.yaml:103:3: error: there are more than 100 bodies (bodies that never move apart are parts: of one)");
}

}  // namespace mistakes_test
}  // namespace poinsot::problem
