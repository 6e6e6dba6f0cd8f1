#include "problem/instant/contact_state_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/solve/linear/decompositions.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_combinations = 20000;  // a few seconds of solving, for statements of the usual size
// A slip below this part of what moves beside it is none: equations of a few dozen terms leave less.
constexpr double none_beside = 1e-9;
// The sine between a slip and its line: more than the rounding of the two beside each other, far less than a force
// across the line would turn it by.
constexpr double on_line = 1e-8;
// Directions that differ by less are one: what Newton's method leaves of a direction that was sought.
constexpr double one_direction = 1e-7;

class StateSearch {
 public:
  // reached: the state of a motion; null for what is stated of the start.
  // sticking: contacts of which no other state is looked at.
  StateSearch(const Situation& situation, std::size_t number, const Settings& settings, bool lines_only,
              const ReachedState* reached = nullptr, const std::vector<std::string>& sticking = {})
      : situation_(situation),
        number_(number),
        settings_(settings),
        lines_only_(lines_only),
        reached_(reached),
        sticking_(sticking) {
    for (const Contact& contact : situation.contacts)
      if (contact.rubs()) contacts_.push_back(&contact);
  }

  HeldStates run() {
    find_slips();
    std::size_t combinations = 1;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      combinations *= grips_of(k).size();
      if (combinations > most_combinations)
        fail(situation_.file, contacts_.front()->friction->mark,
             fmt::format("{} contacts with friction have too many states together to try them all", contacts_.size()),
             "leave out the friction where it does not matter");
    }
    std::vector<std::size_t> choice(contacts_.size(), 0);
    do try_grips(choice);
    while (next(choice));
    // Where a combination leaves all other contacts pressing and cords taut, those that do not are none.
    if (std::ranges::any_of(whole_, [](bool whole) { return whole; })) {
      std::size_t i = 0;
      std::erase_if(held_.all, [&](const auto&) { return !whole_[i++]; });
    }
    const std::vector<States> all = held_.all;
    std::erase_if(held_.all, [&](const States& states) {
      return std::ranges::any_of(all, [&](const States& other) { return rests_instead(other, states); });
    });
    return std::move(held_);
  }

  // What each contact does whose state is that of its slip at the start, if those at rest stay so.
  std::vector<ContactState> at_start() {
    find_slips();
    States states;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      states.push_back(state(k, norm(slips_[k]) > 0 ? Grip::slides : Grip::sticks, slips_[k]));
    return states;
  }

 private:
  using States = std::vector<ContactState>;
  struct Slips {
    std::vector<Vector3<double>> slip;  // of each contact; zero where it is rounding
    bool holds = false;
  };

  // Whether in other states a contact stays at rest, with more friction than while it slides, that begins to slide in
  // these, and none begins to that does not in these.
  bool rests_instead(const States& other, const States& states) const {
    bool rests = false;
    for (std::size_t k = 0; k < states.size(); ++k) {
      if (other[k].from_rest && !states[k].from_rest) return false;
      rests = rests || (states[k].from_rest && other[k].grip == Grip::sticks && contacts_[k]->friction->falls());
    }
    return rests;
  }

  std::vector<Grip> grips_of(std::size_t k) const {
    if (leaves_[k]) return {Grip::parts};
    const bool sticks = !(norm(slips_[k]) > 0) && !(reached_ && reached_->leaving == contacts_[k]->name);
    if (sticks && std::ranges::find(sticking_, contacts_[k]->name) != sticking_.end()) return {Grip::sticks};
    std::vector<Grip> grips{Grip::slides};
    if (sticks) grips.insert(grips.begin(), Grip::sticks);
    if (contacts_[k]->touches()) grips.push_back(Grip::parts);
    // A belt that slips has lost its load: that is said, and not followed.
    return contacts_[k]->of_belt ? std::vector{Grip::sticks} : grips;
  }
  bool next(std::vector<std::size_t>& choice) const {
    for (std::size_t k = choice.size(); k-- > 0;) {
      if (++choice[k] < grips_of(k).size()) return true;
      choice[k] = 0;
    }
    return false;
  }

  SolvedInstant instant_of(const Situation& tried, const OpenChoice& choice) const {
    return reached_ ? SolvedInstant(tried, settings_, reached_->state, choice)
                    : SolvedInstant(tried, settings_, When{}, choice);
  }

  // How the contacts slip at the start. Throws StatementError where that is not determined.
  void find_slips() {
    const auto slips_at = [&](const OpenChoice& choice) {
      const SolvedInstant instant = instant_of(situation_, choice);
      std::vector<Vector3<double>> slips;
      possible_ = instant.possible_slips();
      const double none =
          std::max(none_beside * instant.natural_size(dimensions::velocity), reached_ ? reached_->none : 0);
      for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const RoughMotion<double> now = instant.rough_motion_as_drawn(k, false);
        slips.push_back(norm(now.slip) > none ? now.slip : Vector3<double>{});
        leaves_.resize(contacts_.size());
        leaves_[k] = reached_ && !contacts_[k]->in_joint && now.apart > none;
        normals_.resize(contacts_.size());
        normals_[k] = instant.rough_normal(k);
        axes_.resize(contacts_.size());
        const RoughContactOf<double>& rough = instant.machine().rough_contacts[k];
        if (!contacts_[k]->touches() && !rough.all_ways) axes_[k] = rough.motions[1].along.vector;
        in_space_.resize(contacts_.size());
        in_space_[k] = rough.all_ways && rough.ways.size() != 2;
      }
      return slips;
    };
    OpenChoice varied;
    varied.seed = 21;
    varied.any = varied.velocities = true;
    varied.direction = OpenChoice::every;
    slips_ = slips_at({});
    if (reached_) return;  // A motion is in one state.
    const std::vector<Vector3<double>> others = slips_at(varied);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      if (norm(slips_[k] - others[k]) > none_beside * (norm(slips_[k]) + norm(others[k])))
        fail(situation_.file, contacts_[k]->friction->mark,
             "how " + contacts_[k]->words() + " slips is not known: the statement leaves velocities open",
             "state them, such as instants: {now: rest}");
  }

  ContactState state(std::size_t k, Grip grip, const Vector3<double>& d) const {
    ContactState state{contacts_[k]->name,      number_, grip, {}, grip == Grip::slides && !(norm(slips_[k]) > 0),
                       !contacts_[k]->touches()};
    state.sought = contacts_[k]->all_ways;
    if (grip == Grip::slides)
      state.slip =
          axes_[k] ? joint_direction(*contacts_[k], dot(d, *axes_[k]) < 0) : direction_expression(normalized(d));
    return state;
  }

  void try_grips(const std::vector<std::size_t>& choice) {
    States states;
    std::vector<Grip> grips;
    std::vector<std::size_t> starting;  // those that are at rest and slide
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Grip grip = grips.emplace_back(grips_of(k)[choice[k]]);
      states.push_back(state(k, grip, norm(slips_[k]) > 0 ? slips_[k] : across(k)));
      if (states.back().from_rest) starting.push_back(k);
    }
    if (!possible_.allow(grips)) return;
    try {
      if (starting.empty())
        keep_if_held(states);
      else
        begin_to_slide(states, grips, starting);
    } catch (const ContradictionError&) {
      // What is stated does not go with these states.
    } catch (const StatementError& error) {
      const Diagnostic& why = error.diagnostics().front();
      add_once(held_.doubts,
               words_of_trial(states) + ": " + why.message + (why.hint.empty() ? "" : " (" + why.hint + ")"));
    }
  }

  Vector3<double> across(std::size_t k) const {
    if (axes_[k]) return *axes_[k];
    const Vector3<double>& n = normals_[k];
    if (situation_.plane && in_space_[k]) return Vector3<double>::unit(situation_.plane->normal());
    if (situation_.plane && contacts_[k]->touches())
      return normalized(cross(n, Vector3<double>::unit(situation_.plane->normal())));
    return normalized(cross(n, std::abs(n.x) < 0.9 ? Vector3<double>{1, 0, 0} : Vector3<double>{0, 1, 0}));
  }

  // Solves for a combination. smooth: whether those that begin to slide have no friction.
  Slips solve(const States& states, bool smooth = false) {
    Situation tried = situation_;
    put_in_states(tried, number_, states);
    for (Contact& contact : tried.contacts)
      if (smooth && contact.from_rest) contact.friction->sliding = number_expression(0);
    bool open = false;
    Slips slips = slips_of(tried, {}, open);
    if (!open) return slips;
    // What is open must decide nothing here.
    OpenChoice varied;
    varied.seed = 22;
    varied.any = varied.forces = true;
    varied.direction = OpenChoice::every;
    const bool whole = whole_now_;
    const Slips others = slips_of(tried, varied, open);
    bool holds_alike = slips.holds == others.holds;
    if (!holds_alike) {
      // One share of what contacts carry within their limits is enough, and others next to it may lie outside: of a
      // roller that touches a wall beside it the only one is that the wall carries nothing.
      varied.forces = false;
      holds_alike = slips.holds == slips_of(tried, varied, open).holds;
    }
    whole_now_ = whole;
    bool same = holds_alike;
    constexpr double as_open = 1e-6;  // what is open is varied by the size of the motion
    for (std::size_t k = 0; k < slips.slip.size(); ++k)
      same = same && norm(slips.slip[k] - others.slip[k]) <= as_open * (norm(slips.slip[k]) + norm(others.slip[k]));
    if (!same)
      fail(situation_.file, contacts_.front()->friction->mark,
           "the statement leaves open what decides whether contacts stick or slide");
    return slips;
  }

  Slips slips_of(const Situation& tried, const OpenChoice& choice, bool& open) {
    SolvedInstant instant = instant_of(tried, choice);
    instant.solve_forces();
    open = instant.uses_any() || !instant.motion().open.empty();
    Slips slips;
    slips.holds = true;
    whole_now_ = true;
    for (const auto& fault : instant.one_sided_faults()) {
      const std::string& name = instant.machine().mechanism.actions[fault.action].name;
      // A cord is in no state of its friction where that breaks down; where it would push it is like any cord.
      const bool rough = std::ranges::any_of(contacts_, [&](const Contact* contact) {
        return contact->name == name || (contact->on_cord && contact->of == name && fault.broken != Holding::pulls);
      });
      (rough ? slips.holds : whole_now_) = false;
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const RoughMotion<double> then = instant.rough_motion_as_drawn(k, true);
      // Where nothing moves the terms are rounding themselves.
      const double size = std::max(then.size, instant.natural_size(dimensions::acceleration));
      slips.slip.push_back(norm(then.slip) > none_beside * size ? then.slip : Vector3<double>{});
      // What touches parts only as it is moved apart: how fast it does so before is rounding, and where nothing moves
      // its acceleration is, too.
      const RoughContactOf<double>& rough = instant.machine().rough_contacts[k];
      const bool leaves = reached_ ? leaves_[k]
                                   : instant.rough_motion_as_drawn(k, false).apart >
                                         none_beside * instant.natural_size(dimensions::velocity);
      if (!leaves && rough.grip == Grip::parts && !(then.apart > none_beside * size)) slips.holds = false;
      // Likewise a slip that is taken for none begins only as it is moved.
      if (reached_ && rough.grip == Grip::slides && contacts_[k]->touches() && !(norm(slips_[k]) > 0) &&
          !(dot(slips.slip[k], rough.slip->vector) > 0))
        slips.holds = false;
    }
    return slips;
  }

  bool keep_if_held(const States& states) {
    if (!solve(states).holds) return false;
    if (std::ranges::none_of(held_.all, [&](const States& known) { return same(known, states); })) {
      held_.all.push_back(states);
      whole_.push_back(whole_now_);
    }
    return true;
  }

  bool same(const States& a, const States& b) const {
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[k].grip != b[k].grip) return false;
      if (a[k].grip == Grip::slides && norm(direction_of(a[k]) - direction_of(b[k])) > one_direction) return false;
    }
    return true;
  }
  Vector3<double> direction_of(const ContactState& state) const {
    return DataScope<double>(situation_, settings_, 0).direction(*state.slip);
  }

  // Contacts at rest that slide: first along the lines on which they would begin without friction.
  void begin_to_slide(States states, const std::vector<Grip>& grips, const std::vector<std::size_t>& starting) {
    const std::vector<Vector3<double>> free = solve(states, true).slip;
    std::vector<Vector3<double>> lines;
    for (const std::size_t k : starting) lines.push_back(norm(free[k]) > 0 ? normalized(free[k]) : across(k));
    bool on_lines = true;
    const auto put = [&](std::size_t i, const Vector3<double>& d) {
      states[starting[i]] = state(starting[i], Grip::slides, d);
    };
    const std::size_t senses = std::size_t{1} << starting.size();
    for (std::size_t sense = 0; sense < senses; ++sense) {
      for (std::size_t i = 0; i < starting.size(); ++i) put(i, (sense >> i & 1 ? -1.0 : 1.0) * lines[i]);
      const std::vector<Vector3<double>> slip = solve(states).slip;
      // What slips neither without friction nor by its own is held by the others, as by two that stick.
      const auto held = [&](std::size_t k) { return !(norm(free[k]) > 0) && !(norm(slip[k]) > 0); };
      if (std::ranges::any_of(starting, held)) return;
      for (std::size_t i = 0; i < starting.size(); ++i)
        on_lines = on_lines && norm(cross(slip[starting[i]], lines[i])) <= on_line * norm(slip[starting[i]]);
      keep_if_held(states);
    }
    // In a planar problem what touches slips along the line in which its surface meets the plane.
    const auto on_a_line = [&](std::size_t k) { return axes_[k] || (situation_.plane && contacts_[k]->touches()); };
    if (std::ranges::all_of(starting, on_a_line)) return;
    if (on_lines && (starting.size() > 1 || lines_only_ || !(norm(free[starting.front()]) > 0) ||
                     possible_.along_one_line(starting.front(), grips)))
      return;
    if (lines_only_) {
      held_.directions_sought = held_.directions_sought || !on_lines;
      return;
    }
    held_.directions_sought = held_.directions_sought || (!on_lines && starting.size() > 1);
    if (starting.size() == 1 && in_space_[starting.front()])
      turn_in_space(std::move(states), starting.front(), lines.front());
    else if (starting.size() == 1)
      turn_around(std::move(states), starting.front());
    else
      seek_from_lines(std::move(states), starting, lines);
  }

  // By how much each slip turns away from the direction that was taken, as a sine; and whether it goes backwards.
  std::vector<double> turned(const States& states, const std::vector<std::size_t>& starting) {
    const std::vector<Vector3<double>> slip = solve(states).slip;
    std::vector<double> sines;
    for (const std::size_t k : starting) {
      const Vector3<double> d = direction_of(states[k]);
      const double size = norm(slip[k]);
      forward_ = dot(d, slip[k]) > 0;
      sines.push_back(size > 0 ? dot(cross(d, slip[k]), normals_[k]) / size : 0);
    }
    return sines;
  }
  Vector3<double> at_angle(std::size_t k, double angle) const {
    const Vector3<double> u = across(k);
    return std::cos(angle) * u + std::sin(angle) * cross(normals_[k], u);
  }

  // A single contact: all directions around, and where the sine changes its sign.
  void turn_around(States states, std::size_t k) {
    constexpr int steps = 36, most_refinements = 60;
    constexpr double exactly = 1e-15;  // of an angle and of a sine: their last place
    const auto sine = [&](double angle) {
      states[k] = state(k, Grip::slides, at_angle(k, angle));
      return turned(states, {k}).front();
    };
    // The first is no multiple of a step, so that no direction along an axis is hit by chance.
    const double step = 2 * std::numbers::pi / steps, first = 0.123456789 * step;
    double before = sine(first);
    for (int i = 1; i <= steps; ++i) {
      double low = first + (i - 1) * step, high = low + step, at_low = before, at_high = sine(high);
      before = at_high;
      if ((at_low > 0) == (at_high > 0) || !forward_) continue;
      // Regula falsi, with the half of a value that stays (the Illinois method).
      for (int n = 0; n < most_refinements && high - low > exactly && at_high != 0; ++n) {
        const double between = low + (high - low) * at_low / (at_low - at_high), here = sine(between);
        if (!(between > low && between < high)) break;
        if ((here > 0) == (at_low > 0)) {
          low = between, at_low = here, at_high /= 2;
        } else {
          high = between, at_high = here, at_low /= 2;
        }
        if (std::abs(here) < exactly) break;
      }
      sine(high);
      keep_if_held(states);
    }
  }

  // A ball, which turns about any axis: Newton's method for what slips across a direction, from both senses of a line.
  void turn_in_space(States states, std::size_t k, const Vector3<double>& line) {
    constexpr int most_steps = 40;
    constexpr double close = 1e-13, aside = 1e-6, longest = 0.5;  // as for several contacts
    for (const double sense : {1.0, -1.0}) {
      Vector3<double> d = sense * line;
      const auto off = [&](const Vector3<double>& direction) {
        states[k] = state(k, Grip::slides, direction);
        const Vector3<double> slip = solve(states).slip[k];
        const double size = norm(slip);
        return size > 0 ? (slip - dot(slip, direction) * direction) / size : Vector3<double>{};
      };
      for (int step = 0; step < most_steps; ++step) {
        const Vector3<double> a = normalized(cross(d, Vector3<double>::unit(std::abs(d.x) < 0.9 ? 0 : 1))),
                              b = cross(d, a);
        const Vector3<double> here = off(d);
        if (norm(here) < close) break;
        const Vector3<double> by_a = (off(normalized(d + aside * a)) - here) / aside,
                              by_b = (off(normalized(d + aside * b)) - here) / aside;
        Eigen::MatrixXd J(2, 2);
        J << dot(by_a, a), dot(by_b, a), dot(by_a, b), dot(by_b, b);
        Eigen::VectorXd change(2);
        change << dot(here, a), dot(here, b);
        change = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(J).solve(change).eval();
        if (const double size = change.norm(); size > longest) change *= longest / size;
        d = normalized(d - change[0] * a - change[1] * b);
      }
      off(d);
      keep_if_held(states);
    }
  }

  // Several contacts: Newton's method for their directions, from both senses of each line.
  void seek_from_lines(States states, const std::vector<std::size_t>& starting,
                       const std::vector<Vector3<double>>& lines) {
    // Directions are told by an angle about the normal, of which a ball has none.
    if (std::ranges::any_of(starting, [&](std::size_t k) { return in_space_[k]; })) return;
    const std::size_t count = starting.size();
    const auto take = [&](const std::vector<double>& angles) {
      for (std::size_t i = 0; i < count; ++i)
        states[starting[i]] = state(starting[i], Grip::slides, at_angle(starting[i], angles[i]));
      return turned(states, starting);
    };
    // All with the sense of the slip without friction, and each of them turned round.
    for (std::size_t turned_round = 0; turned_round <= count; ++turned_round) {
      std::vector<double> angles;
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = starting[i];
        const Vector3<double> d = (i == turned_round ? -1.0 : 1.0) * lines[i], u = across(k);
        angles.push_back(std::atan2(dot(d, cross(normals_[k], u)), dot(d, u)));
      }
      constexpr int most_steps = 12;   // by then it has come near or wanders
      constexpr double close = 1e-13;  // of a sine: what is left of it when a step no longer makes it smaller
      constexpr double aside = 1e-6;   // radians, for slopes good to six digits
      constexpr double longest = 0.5;  // radians: farther than that slopes say little
      for (int iteration = 0; iteration < most_steps; ++iteration) {
        const std::vector<double> here = take(angles);
        const auto n = static_cast<Eigen::Index>(count);
        Eigen::VectorXd off(n);
        Eigen::MatrixXd J(n, n);
        for (Eigen::Index i = 0; i < n; ++i) off[i] = here[static_cast<std::size_t>(i)];
        if (off.cwiseAbs().maxCoeff() < close) break;
        for (Eigen::Index j = 0; j < n; ++j) {
          std::vector<double> moved = angles;
          moved[static_cast<std::size_t>(j)] += aside;
          const std::vector<double> there = take(moved);
          for (Eigen::Index i = 0; i < n; ++i)
            J(i, j) = (there[static_cast<std::size_t>(i)] - here[static_cast<std::size_t>(i)]) / aside;
        }
        Eigen::VectorXd change = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(J).solve(off);
        if (const double largest = change.cwiseAbs().maxCoeff(); largest > longest) change *= longest / largest;
        for (std::size_t i = 0; i < count; ++i) angles[i] -= change[static_cast<Eigen::Index>(i)];
      }
      take(angles);
      keep_if_held(states);
    }
  }

  const Situation& situation_;
  const std::size_t number_;
  const Settings& settings_;
  const bool lines_only_;
  const ReachedState* const reached_;
  const std::vector<std::string> sticking_;
  std::vector<const Contact*> contacts_;
  std::vector<Vector3<double>> slips_, normals_;      // as drawn
  std::vector<std::optional<Vector3<double>>> axes_;  // of friction in joints, as drawn
  std::vector<bool> in_space_;                        // of each, whether its slip may have any direction in space
  std::vector<bool> leaves_;                          // of each contact, whether it comes apart already
  PossibleSlips possible_;
  HeldStates held_;
  std::vector<bool> whole_;  // of each combination that holds: whether no smooth contact pulls and no cord pushes
  bool whole_now_ = true;    // the same of the one that was solved last
  bool forward_ = true;      // whether the last contact of those that turned() looked at slips forwards
};

}  // namespace

HeldStates states_that_hold(const Situation& situation, std::size_t number, const Settings& settings, bool lines_only,
                            const std::vector<std::string>& sticking) {
  return StateSearch(situation, number, settings, lines_only, nullptr, sticking).run();
}

HeldStates states_that_hold(const Situation& situation, std::size_t number, const Settings& settings,
                            const ReachedState& reached) {
  const Situation open = with_states_open(situation);
  return StateSearch(open, number, settings, false, &reached).run();
}

std::vector<ContactState> states_at_start(const Situation& situation, std::size_t number, const Settings& settings) {
  return StateSearch(situation, number, settings, true).at_start();
}

bool leaves_limits(const Situation& situation, const Settings& settings) {
  if (std::ranges::none_of(situation.contacts, &Contact::leaves_limit)) return true;
  const HeldStates held = states_that_hold(with_states_open(situation), 0, settings, true);
  return std::ranges::any_of(held.all, [&](const std::vector<ContactState>& states) {
    return std::ranges::all_of(states, [&](const ContactState& state) {
      return std::ranges::find(situation.contacts, state.contact, &Contact::name)->grip == state.grip;
    });
  });
}

}  // namespace poinsot::problem
