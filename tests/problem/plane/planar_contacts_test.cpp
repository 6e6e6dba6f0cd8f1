// Contacts of planar problems: what lies flat, what is kicked on its feet, what hangs on a particle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/language/failure.h"
#include "problem/plane/planar_statement.h"

namespace poinsot::problem {
namespace planar_contacts_test {

constexpr double g = 9.80665;

// The only solution, by the names of its asks.
class Planar {
 public:
  explicit Planar(const std::string& text) {
    Statement statement = read_statement("title: t\nplane: [x, y]\n" + text, "test.yaml");
    restrict_to_plane(statement);
    const SolvedStatement solved = solve_statement(statement, {});
    EXPECT_EQ(solved.solutions.size(), 1U) << text;
    for (std::size_t i = 0; i < statement.asks.size(); ++i)
      asks_[statement.asks[i].name] = solved.solutions.at(0).asks[i];
    notes = solved.solutions.at(0).notes;
  }
  double number(const std::string& name) const {
    EXPECT_EQ(asks_.at(name).state, AskState::found) << name << ": " << asks_.at(name).reason;
    return asks_.at(name).value.number;
  }
  std::string reason(const std::string& name) const {
    EXPECT_NE(asks_.at(name).state, AskState::found) << name;
    return asks_.at(name).reason;
  }
  bool notes_have(const std::string& words) const {
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
  }

 private:
  std::map<std::string, SolvedAsk> asks_;
  std::vector<std::string> notes;
};

std::string crate(const std::string& body, const std::string& contacts, const std::string& sudden) {
  return "points: {C: [0, 0], A: [-0.4 m, 0], B: [0.4 m, 0], G: [0, 0.6 m], Q: [0, 0.9 m]}\nbodies: {crate: {" + body +
         ", mass: 40 kg}}\ncontacts: {" + contacts + "}\ngravity: -y\n" + sudden;
}
const std::string flat = "rectangle: {center: G, sides: [[0.8 m, 0], [0, 1.2 m]]}";
const std::string cuts = "'crate' is straight where contact 'floor' is: turning as it does it would cut into a flat";

// One point of its side does not hold a crate from turning; its corners do, and a particle does not turn.
TEST(PlanarContacts, ACrateRestsOnNoSinglePointOfItsSide) {
  const std::string pushed =
      "loads: {push: {force: [50 N, 0], at: Q, body: crate}}\ninstants: {now: rest}\n"
      "ask: {a: acceleration(crate).x, w: angular_acceleration(crate)}\n";
  const std::string kicked =
      "impulses: {kick: {body: crate, at: Q, value: [50 N*s, 0]}}\ninstants: {before: rest}\n"
      "ask: {v: velocity(crate).x}\n";
  const Planar smooth(crate(flat, "floor: {of: crate, at: C, normal: y}", pushed));
  EXPECT_NE(smooth.reason("a").find(cuts), std::string::npos) << smooth.reason("a");
  EXPECT_NE(smooth.reason("w").find(cuts), std::string::npos) << smooth.reason("w");
  for (const std::string& sudden : {pushed, kicked}) {
    const std::string rough =
        failure_of([&] { Planar(crate(flat, "floor: {of: crate, at: C, normal: y, friction: 0.1}", sudden)); });
    EXPECT_NE(rough.find(cuts), std::string::npos) << rough;
  }
  const Planar corners(crate(flat,
                             "left: {of: crate, corner: A, normal: y, friction: 0.1}, "
                             "right: {of: crate, corner: B, normal: y, friction: 0.1}",
                             pushed));
  EXPECT_NEAR(corners.number("a"), 50.0 / 40 - 0.1 * g, 1e-10);
  EXPECT_NEAR(corners.number("w"), 0, 1e-10);
  const Planar particle(crate("particle: C", "floor: {of: crate, at: C, normal: y, friction: 0.1}",
                              "loads: {push: {force: [50 N, 0], body: crate}}\ninstants: {now: rest}\n"
                              "ask: {a: acceleration(crate).x}\n"));
  EXPECT_NEAR(particle.number("a"), 50.0 / 40 - 0.1 * g, 1e-10);
}

// Pushed in the line of its friction it is held by one point alike.
TEST(PlanarContacts, ACrateMayRestOnOnePointThatHoldsIt) {
  const Planar still(crate(flat, "floor: {of: crate, at: C, normal: y}",
                           "loads: {push: {force: [50 N, 0], at: G, body: crate}}\ninstants: {now: rest}\n"
                           "ask: {a: acceleration(crate).x}\n"));
  EXPECT_NEAR(still.number("a"), 50.0 / 40, 1e-10);
}

// Kicked on two feet a box slides on the one about which it is turned, and lifts the other.
TEST(PlanarContacts, ABoxThatIsKickedLiftsAFoot) {
  const Planar solved(
      "points: {A: [-0.4 m, 0], B: [0.4 m, 0], G: [0, 0.5 m], Q: [-0.4 m, 0.25 m]}\n"
      "bodies: {box: {rectangle: {center: G, sides: [[0.8 m, 0], [0, 1 m]]}, mass: 10 kg}}\n"
      "contacts: {a: {of: box, corner: A, normal: y, friction: 0.3}, b: {of: box, corner: B, normal: y, friction: "
      "0.3}}\nimpulses: {kick: {body: box, at: Q, value: [20 N*s, 0]}}\ngravity: -y\ninstants: {before: rest}\n"
      "ask: {w: angular_velocity(box), v: velocity(box).x, later: angular_velocity(box) @ 1 ms}\n");
  // The push N on the foot lets it not go down: m v_y = N, v_y = b w, I w = h J/2 - b N - mu h N.
  const double w = 0.25 * 20 / (10 * (0.64 + 1) / 12 + 10 * 0.4 * (0.4 + 0.3 * 0.5));
  EXPECT_NEAR(solved.number("w"), w, 1e-10);
  EXPECT_NEAR(solved.number("v"), (20 - 0.3 * 10 * 0.4 * w) / 10, 1e-10);
  // About the foot the weight turns it back.
  EXPECT_LT(solved.number("later"), w);
  EXPECT_NEAR(solved.number("later"), w, 0.02);
}

// The directions of what slides along a motion are named, or have two components.
TEST(PlanarContacts, TellTheirDirectionsInThePlane) {
  const auto rod = [](const std::string& slope) {
    return "points: {A: [0, 0], B: '(1 m)*[sin(5 deg), cos(5 deg)]'}\ndirections: {down: [" + slope +
           "]}\nbodies: {rod: {rod: [A, B], mass: 2 kg}}\ncontacts: {floor: {of: rod, at: A, normal: y, friction: "
           "0.3}}\ngravity: down\ninstants: {start: rest}\nask: {t: {first_time: sliding(floor)}}\n";
  };
  const Planar level(rod("0, -1"));
  EXPECT_TRUE(level.notes_have("contact 'floor' begins to slide along -x from"));
  // By theta'' = 3 g/(2 L) sin(theta) to where its friction is 0.3 of the push, by Runge and Kutta.
  EXPECT_NEAR(level.number("t"), 0.5888, 1e-4);
}

// What hangs on a particle turns about an axis across the plane, though the particle has none of its own.
TEST(PlanarContacts, APendulumHangsOnAParticle) {
  const double M = 3, m = 2, q = 0.6;
  const Planar solved(
      fmt::format("given: {{q: {} rad}}\npoints: {{O: [0, 0], P: '(0.8 m)*[sin(q), -cos(q)]'}}\n"
                  "bodies: {{cart: {{particle: O, mass: {} kg}}, bob: {{particle: P, mass: {} kg}}}}\n"
                  "joints: {{pin: {{revolute: z, at: O, from: cart, to: bob}}}}\n"
                  "contacts: {{rail: {{of: cart, at: O, normal: y}}}}\ngravity: -y\ninstants: {{start: rest}}\n"
                  "ask: {{a: acceleration(cart).x, T: norm(force(pin on bob)), v: velocity(cart).x @ 0.02 s}}\n",
                  q, M, m));
  const double s = std::sin(q), a = m * g * s * std::cos(q) / (M + m * s * s);
  EXPECT_NEAR(solved.number("a"), a, 1e-10);
  EXPECT_NEAR(solved.number("T"), M * a / s, 1e-9);
  EXPECT_NEAR(solved.number("v"), a * 0.02, 0.01 * a * 0.02);
}

}  // namespace planar_contacts_test
}  // namespace poinsot::problem
