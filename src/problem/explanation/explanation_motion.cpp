#include "problem/explanation/explanation_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "poinsot/engine/dynamics/action_forces.h"
#include "problem/explanation/explanation_figures.h"
#include "problem/instant/instant_conditions.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr double constant_tolerance = 1e-6;  // relative change along the motion up to which a number is constant
// Places at which it is looked at, as parts of the time followed.
constexpr std::array<double, 4> looks{0, 0.23, 0.61, 1};

// A number that may be constant along the motion.
struct Candidate {
  std::string words, symbol;
  Dimension dimension;
  std::function<double(const solve::MechanismState&)> value;
};

solve::MechanismState state_of(SolvedInstant& instant) {
  solve::MechanismState placed(instant.machine().mechanism);
  const MotionState state = instant.state();
  placed.set_positions(state.q);
  placed.set_velocities(state.v);
  return placed;
}

std::set<int> all_bodies(const solve::MechanismState& placed) {
  std::set<int> bodies;
  for (int i = 0; i < placed.mechanism().tree.body_count(); ++i) bodies.insert(i);
  return bodies;
}

// The energy, the angular momenta about axes and points fixed in the ground, and the spins of bodies of revolution.
std::vector<Candidate> candidates(const Situation& situation, const Machine& machine, double length) {
  std::vector<Candidate> all;
  all.push_back(
      {"kinetic and potential energy together", "T + V", dimensions::energy, [](const solve::MechanismState& placed) {
         const auto& mechanism = placed.mechanism();
         return kinetic_energy(mechanism.tree, placed.workspace()) +
                potential_energy(mechanism.tree, placed.workspace()) +
                stored_energy(mechanism, placed.workspace(), placed.state());
       }});
  const auto add_momentum = [&](const std::string& point, const Vector3<double>& P, const Vector3<double>& axis,
                                const std::string& index) {
    all.push_back({"the angular momentum about " + point + " on the axis $" + index + "$", "H_{" + index + "}",
                   dimensions::angular_momentum, [P, axis](const solve::MechanismState& placed) {
                     return dot(axis, momentum_of(placed, all_bodies(placed), P).angular);
                   }});
  };
  for (const Joint& joint : situation.joints) {
    const auto place = machine.joints.find(joint.name);
    if (joint.from != "ground" || place == machine.joints.end()) continue;
    solve::MechanismState drawn(machine.mechanism);
    const Vector3<double> P = drawn.position(place->second.at);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<double> axis = Vector3<double>::unit(k);
      const bool own = place->second.axis && norm(cross(drawn.direction(*place->second.axis), axis)) < 1e-9;
      // A joint that holds a point takes no angular momentum about an axis on which it turns freely.
      if (joint.kind->any_turning || (own && !joint.kind->slides()))
        add_momentum("*" + joint.name + "*", P, axis, situation.axes[k]);
    }
  }
  for (int i = 0; i < machine.mechanism.tree.body_count(); ++i) {
    const auto& body = machine.mechanism.tree.body(i);
    if (!(body.inertia.mass > 0) || !turns_unseen(machine.mechanism.tree, i, length) ||
        body.joint != JointType::revolute)
      continue;
    all.push_back({"the angular velocity of *" + machine.mechanism.tree.name(i) + "* on its own axis",
                   "\\omega_{\\mathrm{axis}}", dimensions::angular_velocity, [i](const solve::MechanismState& placed) {
                     const auto& motion = placed.workspace().motion[static_cast<std::size_t>(i + 1)];
                     return dot(motion.R.column(2), motion.w);
                   }});
  }
  return all;
}

}  // namespace

std::vector<ExplainedSection> motion_sections(const Statement& statement, std::size_t situation_index, Sample& sample,
                                              const ExplanationTex& tex, const std::string& suffix) {
  const Situation& situation = statement.situations[situation_index];
  Course& motion = sample.motion(situation_index);
  ExplainedSection section{"Motion through time" + suffix, {}};
  for (const Stage& stage : situation.stages) {
    std::string text = "Stage *" + stage.name + "*";
    if (stage.lasts) text += " lasts `" + to_string(*stage.lasts) + "`";
    if (stage.until) text += " ends when `" + to_string(*stage.until) + "`";
    section.steps.push_back({text + ".", {}});
  }
  if (!(motion.reached() > 0)) motion.follow(motion.pace_time());
  for (const std::string& method : motion.methods())
    section.steps.push_back({"How it is followed: " + method + ".", {}});
  for (const std::string& happening : motion.happenings()) section.steps.push_back({happening + ".", {}});
  const double reached = motion.reached();
  if (reached > 0 && situation.stages.size() <= 1) {
    SolvedInstant& start = sample.instant_at(situation_index, 0);
    ExplainedStep kept{"Along the motion these keep their value:", {}};
    std::vector<std::string> words;
    for (const Candidate& candidate : candidates(situation, start.machine(), start.scales().length)) {
      double least = 0, most = 0;
      for (std::size_t k = 0; k < looks.size(); ++k) {
        const double value = candidate.value(state_of(sample.instant_at(situation_index, looks[k] * reached)));
        least = k == 0 ? value : std::min(least, value);
        most = k == 0 ? value : std::max(most, value);
      }
      const double size = std::max({std::abs(least), std::abs(most), start.natural_size(candidate.dimension)});
      if (!(most - least <= constant_tolerance * size)) continue;
      words.push_back(candidate.words);
      const double value = is_rounding(least, 1e4 * size) ? 0 : least;
      if (!tex.letters_open())
        kept.equations.push_back(tex.equation(candidate.symbol, Shown{value, std::nullopt}, candidate.dimension,
                                              candidate.dimension == dimensions::energy));
    }
    if (!words.empty()) {
      kept.text = "Along the motion " + listed(words) + (words.size() > 1 ? " keep their values" : " keeps its value") +
                  (tex.letters_open() ? "." : " of the start:");
      section.steps.push_back(std::move(kept));
    }
  }
  std::vector<std::string> looked_for;
  for (const Ask& ask : statement.asks) {
    const bool over_time =
        ask.when || ask.table ||
        std::any_of(ask.of.begin(), ask.of.end(), [](const Expression& one) { return asks_motion_feature(one); });
    if (over_time && !ask.text.empty()) looked_for.push_back("`" + ask.text + "`");
  }
  if (!looked_for.empty()) section.steps.push_back({"Along it are looked for " + listed(looked_for) + ".", {}});
  std::vector<std::string> conditions;
  for (const Instant& instant : situation.instants) {
    if (situation.find.empty()) break;
    for (const Fact& fact : instant.facts)
      if (is_later(situation, instant) || asks_motion_feature(fact.quantity))
        conditions.push_back("`" + to_string(fact.quantity) + " = " + to_string(fact.value) + "`");
  }
  if (!conditions.empty()) {
    std::vector<std::string> unknown;
    for (const Unknown& item : situation.find) unknown.push_back("`" + item.name + "`");
    section.steps.push_back({"What is stated of it later, " + listed(conditions) + ", fixes " + listed(unknown) +
                                 ": the motion is followed for one value after the other until it holds.",
                             {}});
  }
  if (section.steps.empty()) return {};
  return {section};
}

}  // namespace poinsot::problem
