#include "problem/quantities/asks_model.h"

#include <gtest/gtest.h>

#include <string>

#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {
namespace asks_model_test {

constexpr const char* pendulum = R"(
given: {L: 0.7 m, m: 2 kg}
gravity: -z
points: {O: [0, 0, 0], E: [0, 0, -L]}
define: {twice: 2*height, height: center(bob).z, size: 3*L, peak: 2*max(theta), circle: circle + 1}
bodies: {bob: {particle: E, mass: m}}
joints: {pin: {revolute: y, at: O, to: bob, angle: theta}}
instants: {start: {theta: 10 deg, theta': 0}}
ask: {T: period(theta)}
)";

const Situation& situation() {
  static const Statement statement = read_statement(pendulum, "pendulum.yaml");
  return statement.situations.front();
}

Expression read(const std::string& text) { return parse_expression(text, "f"); }

TEST(AsksModel, TellsWhatRestsOnTheModelAlsoBehindDefinitions) {
  for (const std::string text : {"theta", "theta''", "2*energy(bob)", "E of bob", "twice", "mass(bob)/m", "[1, theta]"})
    EXPECT_TRUE(asks_model(situation(), read(text))) << text;
  for (const std::string text : {"L", "2 m", "size^2", "norm(O->E)", "sin(L/m)"})
    EXPECT_FALSE(asks_model(situation(), read(text))) << text;
  EXPECT_TRUE(asks_model(situation(), read("theta @ start")));
  EXPECT_FALSE(asks_model(situation(), read("L + (theta @ start)"), false));
}

std::string features_in(const std::string& text) {
  std::string words;
  const Expression expression = read(text);
  for (const auto& [call, mark] : motion_features_in(situation(), expression))
    words += call->function + " " + to_string(call->arguments.front().value) + ";";
  return words;
}

TEST(MotionFeaturesIn, AreFoundOutsideOfOtherInstantsAndBehindDefinitions) {
  EXPECT_EQ(features_in("theta"), "");
  EXPECT_EQ(features_in("max(theta)/period(theta)"), "max theta;period theta;");
  EXPECT_EQ(features_in("[peak, 1, min(abs(theta))]"), "max theta;min abs(theta);");
  // The least of several numbers, what another instant is asked, and what stands within another extreme.
  EXPECT_EQ(features_in("min([theta, L]) + max(theta with L)"), "");
  EXPECT_EQ(features_in("max(theta) @ start"), "");
  EXPECT_EQ(features_in("max(theta - min(theta))"), "max theta - min(theta);");
}

}  // namespace asks_model_test
}  // namespace poinsot::problem
