// In which states the contacts with dry friction of a situation are at given values: all combinations of sticking,
// sliding and parting that hold.
//
// Each combination is solved with the force of each contact as its state says (quantities/rough_contact.h). It holds if
// every contact then does what its state says. What slips can only go on or part. What is at rest begins to slide along
// a direction that is sought: along both senses of a line where the slip stays on it whatever the friction along it,
// and from several starts elsewhere. A contact with less friction while it slides than at rest stays where it can: a
// state in which it begins to slide is left out beside one in which it sticks and no others begin to.
#pragma once

#include <string>
#include <vector>

#include "problem/instant/contact_state_words.h"
#include "problem/instant/instant.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

struct HeldStates {
  std::vector<std::vector<ContactState>> all;  // in the order sticking, sliding, parting of one contact after another
  std::vector<std::string> doubts;             // combinations that could not be judged, and why
  bool directions_sought = false;              // whether slips in space were sought from several starts
};

// number: the place of the situation in its statement. lines_only: whether slips in space are left out. Throws
// StatementError where the statement leaves open how the contacts slip. sticking: contacts of which no other state is
// looked at, unless they slip already.
HeldStates states_that_hold(const Situation& situation, std::size_t number, const Settings& settings, bool lines_only,
                            const std::vector<std::string>& sticking = {});

// A state that a motion has reached.
struct ReachedState {
  MotionState state;
  double none = 0;      // m/s: a slip below is none
  std::string leaving;  // the contact whose friction has come to its limit, so that it sticks no longer; empty if none
};
// The same there. situation: with its contacts in any states.
HeldStates states_that_hold(const Situation& situation, std::size_t number, const Settings& settings,
                            const ReachedState& reached);

// Contacts that slip sliding, those at rest sticking, whether that holds or not. Throws like states_that_hold().
std::vector<ContactState> states_at_start(const Situation& situation, std::size_t number, const Settings& settings);

// Whether none of the contacts that begin to slide, in the states in which they are, could stay with the friction that
// it has at rest.
bool leaves_limits(const Situation& situation, const Settings& settings);

}  // namespace poinsot::problem
