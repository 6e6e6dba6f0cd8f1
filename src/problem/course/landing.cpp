// Several contacts with friction that are struck at once without rebound, as where a body lands flat on rough feet, or
// where a blow presses others that touch.
//
// Which of them comes first cannot be told then. What can is where all of them together leave the bodies: the laws of
// friction are taken to hold for the impulses as a whole and the velocities after the blow (Moreau's law of plastic
// impact). With the momenta before the blow for impulses these are the laws of a blow on the same bodies at rest
// (instant/blow_as_loads.h). A block that rocks leaves its corner or stays on it by them, as Housner has it.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/dynamics/momentum.h"
#include "problem/course/course.h"
#include "problem/course/motion_piece.h"
#include "problem/instant/blow_as_loads.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

std::vector<StatedMomentum> momenta_of(const Situation& situation, const Machine& machine, const MotionState& state) {
  solve::MechanismState moving(machine.mechanism);
  moving.set_positions(state.q);
  moving.set_velocities(state.v);
  const Model<double>& tree = machine.mechanism.tree;
  std::vector<StatedMomentum> momenta;
  for (const Body& body : situation.bodies) {
    const int index = machine.index.at(body.name);
    if (index == ground || !(tree.body(index).inertia.mass > 0)) continue;
    const SpatialInertia<double>& I = tree.body(index).inertia;
    const BodyMotion<double>& motion = moving.workspace().motion[static_cast<std::size_t>(index + 1)];
    const Vector3<double> G = motion.p + (1 / I.mass) * (motion.R * I.first_moment);
    const Momentum<double> momentum = body_momentum(tree, moving.workspace(), index, G);
    momenta.push_back({body.name, momentum.linear, momentum.angular});
  }
  return momenta;
}

}  // namespace

void Course::land(std::size_t stage, const std::vector<std::size_t>& meeting, const std::vector<std::size_t>& beside,
                  Piece& piece) {
  StageRun& now = stages_[stage];
  const std::string when = " at " + with_digits(now.time, 6) + " s";
  const Mark& mark = later_contact(meeting.front())->mark;
  const Machine& machine = probe_->machine();
  const std::vector<Action>& actions = machine.mechanism.actions;
  Situation landing = *in_states_[now.states_now];
  std::vector<std::size_t> closed = meeting;
  closed.insert(closed.end(), beside.begin(), beside.end());
  const auto refuse = [&](const std::string& why) {
    stops(stage, mark, "contacts with friction are struck together" + when + ", which is not solved " + why);
  };
  if (!landing.frames.empty() || !machine.accelerations.empty()) refuse("beside what moves as stated");
  if (!landing.cords.empty() || !landing.belts.empty()) refuse("beside cords and belts");
  for (Contact& contact : landing.contacts) {
    if (!contact.touches()) continue;
    const std::size_t action = action_of_contact(contact.name);
    const bool closes = std::ranges::find(closed, action) != closed.end();
    if (closes && !contact.friction) refuse("where contact '" + contact.name + "' has none");
    if (!closes && piece.acting()[action]) refuse("beside smooth contacts that touch");
    if (closes && contact.friction->falls())
      refuse("where there is less friction in sliding than at rest: in a blow there is one coefficient");
    contact.flies = contact.friction && !closes;
    contact.grip = contact.flies ? Grip::parts : Grip::unknown;
    contact.slip.reset();
    contact.from_rest = contact.slip_turns = false;
  }
  landing = momenta_as_loads(landing, momenta_of(landing, machine, {now.time, stage, now.q, now.v, {}, 0}));
  MotionState at_rest{now.time, 0, now.q, std::vector<double>(now.v.size()), {}, 0};
  const SolvedInstant struck(landing, settings_, at_rest, choice_);
  for (const Action& action : struck.machine().mechanism.actions)
    at_rest.acting.push_back(action.kind != ActionKind::contact || std::ranges::any_of(closed, [&](std::size_t one) {
                               return actions[one].name == action.name;
                             }));
  const HeldStates held = states_that_hold(landing, 0, settings_, {at_rest, 0, ""});
  if (held.all.size() != 1)
    refuse(!held.doubts.empty() ? "for certain: " + held.doubts.front()
           : held.all.empty()   ? ": no state of them fulfils the laws of friction for their impulses"
                                : "for certain: several states of them fulfil the laws of friction for their impulses");
  put_in_states(landing, 0, held.all.front());
  SolvedInstant blow(landing, settings_, at_rest, choice_);
  blow.solve_forces();
  const std::vector<double>& found = blow.motion().value;
  const auto n = static_cast<std::ptrdiff_t>(now.v.size());
  const std::vector<double> after(found.begin(), found.begin() + n);
  const double energy = piece.kinetic_energy(now.v);
  constexpr double none = 1e-12;  // of the energy: a direction in which nothing with mass moves
  for (const std::vector<double>& open : blow.motion().open)
    if (piece.kinetic_energy(std::vector<double>(open.begin(), open.begin() + n)) > none * energy)
      refuse("where it leaves the motion after it open");
  const SolvedInstant::Residuals residuals = blow.check();
  blow_misfit_ =
      std::max({blow_misfit_.value_or(0), residuals.particles.newton_euler, residuals.constraints.value_or(0)});
  rough_blow_misfit_ = std::max(rough_blow_misfit_.value_or(0), residuals.friction.value_or(0));
  std::vector<std::string> names;
  struck_.resize(actions.size());
  double speed = natural_speed();
  for (const std::size_t action : meeting) {
    const double before = -piece.gap_rate(action, now.v);
    names.push_back("'" + actions[action].name + "'");
    struck_[action].fastest = std::max(struck_[action].fastest, before);
    speed = std::max(speed, before);
    settled_.erase(actions[action].name);
    changes_.push_back({now.time, "the contact '" + actions[action].name + "' is struck without rebound"});
    blows_.push_back({now.time, action});
  }
  std::string states;
  for (const ContactState& state : held.all.front())
    states += (states.empty() ? ": in it " : ", ") + problem::words_of(state, situation_, settings_);
  happenings_.push_back((names.size() > 1 ? "the contacts " : "the contact ") + listed(names) +
                        (names.size() > 1 ? " are struck together" : " is struck") + " without rebound" + when +
                        ", which takes " + with_digits(energy - piece.kinetic_energy(after), 4) + " J" + states +
                        (names.size() > 1 ? "" : "; it presses others that touch") +
                        "; the laws of friction are taken for the impulses as a whole");
  now.v = after;
  now.flight = 0;
  std::vector<bool>& acting = piece.acting();
  for (const std::size_t action : closed) acting[action] = true;
  put_in_flight(now, acting);
  leave_blow(stage, closed, speed, piece);
}

}  // namespace poinsot::problem
