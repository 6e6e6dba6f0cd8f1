// A blow at a contact with dry friction (engine/solve/instant/rough_impact.h), in the equations of a blow.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/solve/instant/impulse.h"
#include "poinsot/engine/solve/instant/rough_impact.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// What was found along the blow, and the form that its equations take.
struct RoughBlow {
  enum class Form {
    slides,   // in one direction to the end: the friction is mu times the push, against the slip before
    stops,    // the push does not move the slip, which vanishes along its line
    still,    // nothing slips, nor would it
    numbers,  // the impulses are known by numbers alone
  };
  std::size_t impact = 0;  // its place among those of the machine
  Form form = Form::numbers;
  solve::RoughImpactCourse course;
  std::vector<Vector3<double>> axes;  // of the course: the push and two directions across it, on ground axes
  Vector3<double> friction{};         // its impulse on the body that strikes, on ground axes
  double gained = 0;                  // by the kinetic energy, J
};

// What holds the bodies besides the impact, along a blow.
struct RoughBlowSetting {
  const solve::MechanismState& before;
  const solve::Scales& scales;
  const solve::Blow& blow;          // with one impact, and nothing else that is sudden
  const std::vector<bool>& acting;  // for each action
  // For each action whether it touched or pulled before, so that what does not act must part; all if null.
  const std::vector<bool>* touching = nullptr;
};

// Why a blow cannot be followed; empty if `found` has what was.
struct RoughBlowResult {
  std::optional<RoughBlow> found;
  std::string words, hint;
  bool by_others = false;  // whether the cords and contacts that act are at fault
};
RoughBlowResult follow_rough_blow(const RoughBlowSetting& setting);

// Puts the friction, and what is known of the push, into the equations of the blow.
template <class Scalar>
void put_friction(solve::BlowOf<Scalar>& blow, const solve::MechanismStateOf<Scalar>& before, const RoughBlow& rough);

// "impact 'stop' slips and then sticks; ..."
std::string words_of_blow(const RoughBlow& rough, const solve::Impact& impact);

}  // namespace poinsot::problem
