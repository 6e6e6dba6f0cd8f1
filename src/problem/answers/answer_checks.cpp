#include "problem/answers/answer_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "poinsot/engine/solve/stability/spectrum_check.h"
#include "problem/answers/fact_check.h"
#include "problem/answers/motion_checks.h"
#include "problem/claims/claim_letters.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"
#include "problem/unknowns/uncertain_event.h"
#include "problem/witness/attraction_bound.h"
#include "problem/witness/cut_parts.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {
namespace {

constexpr const char* stability_check = "stability";  // its name in the document
// Relative misfit allowed for a fact; where unknowns make it hold, rounding is larger: at a double root they are known
// to half of the digits, and a fact that is steep there to a tenth of these.
constexpr double fact_tolerance = 1e-6;

// Whether forces matter only for the question whether contacts touch and cords are taut. That is answered also where
// they do not hold.
bool tells_whether_it_holds(const std::vector<Expression>& asked) {
  std::set<std::string> functions;
  for (const Expression& expression : asked) collect_functions(expression, functions, true);
  bool holds = false;
  for (const std::string& name : functions) {
    const QuantityFunction* function = find_quantity(name);
    if (!function || function->level != Level::force) continue;
    if (function->kind != QuantityKind::holding) return false;
    holds = true;
  }
  return holds;
}

bool names_unknown(const Situation& situation, const Expression& expression) {
  std::set<std::string> names;
  collect_names(expression, names, true);
  return std::any_of(situation.find.begin(), situation.find.end(),
                     [&](const Unknown& unknown) { return names.contains(unknown.name); });
}

// Whether a question looks at the motion near a steady one.
bool looks_near_steady(const Ask& ask) {
  const auto looks = [](const Expression& expression) { return asks_stability(expression); };
  return std::ranges::any_of(ask.of, looks) || (ask.extremum && std::ranges::any_of(ask.extremum->conditions, looks));
}

// How large the residual of a check may be.
double allowed(std::string_view check) {
  // Gauss's rule leaves 1e-6 beside the pole of Eulerian angles; a wrong term of the equations is far more.
  if (check == "motion_error" || check == "course") return motion_tolerance;
  if (check == "facts") return fact_tolerance;
  if (check == "blow") return blow_tolerance;
  return check == stability_check || check == "response" ? solve::spectrum_tolerance : check_tolerance;
}

// Whether the motion is confirmed as far as one of several questions leads: others may lead to where it is so sensitive
// that nothing is known of it.
bool is_confirmed_alone(const Statement& statement, const Sample& all, const Ask& ask, const Value<double>& told) {
  const auto finds = [](const Situation& situation) { return !situation.find.empty(); };
  if (statement.asks.size() < 2 || ask.extremum || std::ranges::any_of(statement.situations, finds)) return false;
  try {
    Sample alone(statement, all.settings(), all.choice());
    // What is told is that of the motion that leads on to the others.
    constexpr double same_motion = 1e-6, rounding = 1e-9;
    const Value<double> value = asked_value(alone, ask);
    const double natural = ask.when ? 0 : alone.instant_of(ask).natural_size(dimension_of(value));
    if (!same(value, told, same_motion * size_of(told) + rounding * natural)) return false;
    Solution checked;
    check_motions(
        alone, [](const SolvedInstant&) {}, checked);
    return std::ranges::all_of(checked.checks, [](const auto& check) { return check.second <= allowed(check.first); });
  } catch (const StatementError&) {
    return false;
  }
}

// What can be done where a body is so small beside its orbit that rounding of the orbit hides how it turns.
constexpr const char* beside_an_orbit =
    ": where a body is far smaller than its orbit, hold its mass center in the frame that goes round, by a joint as "
    "ball: G, from: the frame, and its turning alone is looked at";
bool goes_round_center(const Statement& statement) {
  return std::ranges::any_of(statement.situations, [](const Situation& situation) {
    return situation.steady.has_value() && situation.central_gravity.has_value();
  });
}

// Whether it is said of an instant, unasked, that its motion is stable.
bool tells_of_stability(const Situation& situation, const Sample::Home& home) {
  return situation.steady && !home.time && home.instant == 0;
}

std::string stability_words(const solve::Linearisation& near) {
  switch (solve::stability(near)) {
    case solve::Stability::unstable:
      return "unstable: a disturbance grows as exp(" + with_digits(solve::growth_rate(near), 4) + " t/s)";
    case solve::Stability::undecided:
      return "neither stable nor unstable by the linearised equations, which do not decide it";
    case solve::Stability::stable:
      break;
  }
  std::string words;
  for (double frequency : solve::frequencies(near)) words += (words.empty() ? "" : ", ") + with_digits(frequency, 4);
  return words.empty() ? "stable" : "stable: disturbed, it swings at " + words + " rad/s";
}

bool asks_function(const Statement& statement, const std::string& name) {
  return std::ranges::any_of(statement.asks, [&](const Ask& ask) {
    std::set<std::string> functions;
    for (const Expression& expression : ask.of) collect_functions(expression, functions, true);
    return functions.contains(name);
  });
}

// What modes() and eigenvalues() leave out.
void note_modes(const Statement& statement, const SolvedInstant& instant, const solve::Linearisation& near,
                Solution& result) {
  const bool asks_modes = asks_function(statement, "modes");
  if (!asks_modes && !asks_function(statement, "eigenvalues")) return;
  // Where rates meet they are not told.
  if (std::ranges::any_of(near.modes, [&](const solve::Mode& mode) { return !(mode.doubt <= 1e-3 * near.pace); }))
    return;
  if (const int count = solve::vanishing_modes(near); count > 0)
    result.notes.push_back(std::to_string(count) + (count == 1 ? " motion" : " motions") +
                           " near it neither grow, die out nor swing, and are not listed among the modes");
  if (!asks_modes || !near.has_shapes) return;
  const bool open = std::ranges::any_of(
      solve::told_modes(near), [&](const solve::ToldMode& told) { return near.modes[told.mode].shape.empty(); });
  if (open)
    result.notes.push_back("shapes are not told: modes have the same rates, and any mixture of these is one, too");
  else if (std::ranges::all_of(instant.machine().coordinates, [](const auto& one) { return one.name.empty(); }))
    result.notes.push_back("shapes are told of coordinates that have names: angle: theta at a joint");
}

// Of a motion that is shaken.
void note_free_swings(const solve::Linearisation& near, Solution& result) {
  const bool stay = std::ranges::any_of(near.modes, [](const solve::Mode& mode) {
    return mode.frequency > mode.doubt && std::abs(mode.growth_rate) <= mode.doubt;
  });
  const std::string note =
      "free swings near it do not die out: the response is the part of the motion at the frequency of what shakes it";
  if (stay && std::ranges::find(result.notes, note) == result.notes.end()) result.notes.push_back(note);
}

// How exactly the pull of a center is known, by the earliest instant of each situation, or without sizes where only a
// motion was looked at.
void note_attractions(const Statement& statement, const Sample& sample, Solution& result) {
  for (std::size_t i = 0; i < statement.situations.size() && !result.refused; ++i) {
    const Situation& situation = statement.situations[i];
    if (!situation.central_gravity) continue;
    const auto here =
        std::ranges::find_if(sample.instants(), [&](const auto& one) { return one.first.situation == i; });
    const std::vector<std::string> lines =
        here == sample.instants().end()
            ? words_of_attraction(situation)
            : words_of_attraction(situation, here->second->machine(), here->second->machine().q);
    result.notes.insert(result.notes.end(), lines.begin(), lines.end());
  }
}

}  // namespace

void refuse_unphysical(const Statement& statement, const AskValues& asked, Sample& sample, Solution& result) {
  const auto refuse = [](SolvedAsk& ask, const std::string& reason) {
    ask.state = AskState::refused;
    ask.reason = reason;
  };
  for (std::size_t k = 0; k < statement.situations.size(); ++k) {
    DataScope<double> data(statement.situations[k], sample.settings()[k]);
    const std::optional<std::string> reason = unsound_hole(statement.situations[k], data);
    for (SolvedAsk& ask : result.asks)
      if (reason && ask.state == AskState::found) refuse(ask, *reason);
  }
  std::size_t extremum = 0;
  for (std::size_t i = 0; i < statement.asks.size(); ++i) {
    const Ask& ask = statement.asks[i];
    SolvedAsk& solved = result.asks[i];
    const Sample* at_extremum = ask.extremum && asked.values[i] && extremum < asked.extremal.size()
                                    ? asked.extremal[extremum++].get()
                                    : nullptr;
    if (solved.state != AskState::found || ask.when) continue;
    if (ask.table) {
      if (const auto row = sample.unphysical_rows().find(ask.name); row != sample.unphysical_rows().end())
        refuse(solved, row->second);
      else if (const auto rows = sample.rows_left_out().find(ask.name); rows != sample.rows_left_out().end())
        for (const std::string& words : rows->second) result.notes.push_back(ask.name + ": " + words);
      continue;
    }
    if (ask.extremum) {
      if (!at_extremum || tells_whether_it_holds(ask.extremum->conditions)) continue;
      for (const auto& [home, instant] : at_extremum->instants())
        if (instant->forces_solved())
          for (const std::string& reason : instant->unphysical()) refuse(solved, "at it, " + reason);
      continue;
    }
    if (tells_whether_it_holds(ask.of)) continue;
    SolvedInstant& instant = sample.instant_of(ask);
    const Situation& situation = sample.situation_at(ask);
    // If stated forces determine unknowns, these are impossible where the forces are.
    const bool forces_stated = states_forces(situation) && situation.neglect.empty() && !situation.has_blow() &&
                               !(situation.contacts.empty() && situation.cords.empty());
    const bool needs_forces = std::any_of(ask.of.begin(), ask.of.end(), [&](const Expression& e) {
      return level_of(situation, e, true) == Level::force || (forces_stated && names_unknown(situation, e));
    });
    if (!needs_forces) continue;
    if (forces_stated) instant.solve_forces();
    if (!instant.forces_solved()) continue;
    for (const std::string& reason : instant.unphysical()) refuse(solved, reason);
  }
}

void check_answers(const Statement& statement, Sample& sample, const std::vector<std::unique_ptr<Sample>>& extremal,
                   Solution& result) {
  // What the notes say of steady motions is checked too.
  for (const auto& [home, instant] : sample.instants())
    if (tells_of_stability(statement.situations[home.situation], home)) try {
        instant->linearisation(statement.situations[home.situation].steady->mark);
      } catch (const StatementError&) {
        // Nothing is said of it then.
      }
  // An unknown that was found from forces is right only if they are: they are found for the check, asked for or not.
  for (const auto& [home, instant] : sample.instants()) {
    const Situation& situation = statement.situations[home.situation];
    if (situation.find.empty() || !situation.neglect.empty() || instant->forces_solved()) continue;
    try {
      instant->solve_forces();
    } catch (const StatementError&) {
      // Forces that nobody asks for may be open, or none may do.
    }
  }
  const auto keep = [&](const char* name, double value) {
    auto [entry, fresh] = result.checks.emplace(name, value);
    if (!fresh) entry->second = std::max(entry->second, value);
  };
  const auto check = [&](const SolvedInstant& instant) {
    const SolvedInstant::Residuals residuals = instant.check();
    const solve::CheckResult& residual = residuals.particles;
    keep("momentum", residual.momentum);
    keep("energy", residual.energy);
    if (instant.forces_solved()) keep("newton_euler", residual.newton_euler);
    if (instant.after_blow()) keep("impulse", residuals.impulse);
    if (residuals.constraints) keep("constraints", *residuals.constraints);
    if (residuals.stability) keep(stability_check, *residuals.stability);
    if (residuals.response) keep("response", *residuals.response);
    if (residuals.blow) keep("blow", *residuals.blow);
    if (residuals.friction) keep("friction", *residuals.friction);
    if (residuals.laws) keep("laws", *residuals.laws);
  };
  std::vector<SolvedInstant*> instants;
  for (const auto& [key, instant] : sample.instants()) instants.push_back(instant.get());
  for (const std::unique_ptr<Sample>& other : extremal)
    for (const auto& [key, instant] : other->instants()) instants.push_back(instant.get());
  for (const SolvedInstant* instant : instants) check(*instant);
  // Facts are told of the model as answers are.
  if (const std::optional<double> facts = largest_fact_misfit(statement, sample)) result.checks["facts"] = *facts;
  SolvedInstant::ToldMisfit told;
  for (const auto& [home, instant] : sample.instants()) {
    const SolvedInstant::ToldMisfit here = instant->misfit_of_told();
    if (here.checked > 0) keep("quantities", here.misfit);
    if (here.misfit > told.misfit) told = here;
  }
  const std::map<std::string, std::string> doubts = check_motions(sample, check, result);
  for (std::size_t i = 0; i < result.asks.size(); ++i)
    if (SolvedAsk& ask = result.asks[i]; ask.state == AskState::found && !sample.motions().empty())
      if (const auto event = uncertain_event_of(sample, statement.asks[i], ask.value)) {
        ask.state = AskState::refused;
        ask.reason = in_words(*event);
      }
  for (const auto& [name, residual] : result.checks) {
    const bool of_motion = name == "motion_error", of_way = of_motion || name == "course" || name == "scan";
    const bool of_stability = name == stability_check;
    if (residual <= allowed(name)) continue;
    // The digits of laws tell how closely a motion is known.
    if (!of_way) result.refused = result.refused || !of_stability;
    for (std::size_t i = 0; i < result.asks.size(); ++i) {
      SolvedAsk& ask = result.asks[i];
      if (ask.state != AskState::found || (of_stability && !looks_near_steady(statement.asks[i])) ||
          (of_way && is_confirmed_alone(statement, sample, statement.asks[i], ask.value)))
        continue;
      result.refused = result.refused || (of_way && !of_motion);
      ask.state = AskState::refused;
      if (of_motion) {
        ask.reason = "the motion is so sensitive that it may be off by " + with_digits(residual, 1) +
                     " of its size: let it last shorter";
        continue;
      }
      if (name == "facts") {
        ask.reason = "what is stated does not hold in what was found";
        continue;
      }
      const std::string size = with_digits(residual, 2);
      if (const auto doubt = doubts.find(name); doubt != doubts.end()) {
        ask.reason = "a second road to the motion does not confirm it: " + doubt->second + " (off by " + size + ")";
        continue;
      }
      ask.reason =
          name == "constraints"
              ? "what joints, contacts and cords hold together comes apart in it, by " + size + " of its size"
          : name == "blow"     ? "small steps along the blow do not confirm it (off by " + size + ")"
          : name == "friction" ? "the laws of friction are not fulfilled in it (off by " + size + ")"
          : name == "laws"
              ? "loads, springs, motors and gravity act otherwise in it than they are stated (off by " + size + ")"
          : name == "quantities"
              ? "the bodies as particles do not confirm " + told.function + "() (off by " + size + ")"
          : of_stability
              ? "the motion of its bodies, each by itself, does not confirm it (rates off by " + size +
                    " of the pace)" + (goes_round_center(statement) ? beside_an_orbit : "")
              : "the independent check with particles does not confirm it (" + name + " off by " + size + ")";
    }
  }
}

// From where potential energies count, and what has none.
void note_zero_of_energy(const SolvedInstant& instant, const Situation& situation, Solution& result) {
  const Mechanism<double>& mechanism = instant.machine().mechanism;
  const bool weights = norm(mechanism.tree.gravity()) > 0;
  const bool springs =
      std::ranges::any_of(situation.springs, [](const Spring& s) { return s.stiffness.has_value(); }) ||
      std::ranges::any_of(situation.joints, [](const Joint& joint) {
        return std::ranges::any_of(joint.freedoms,
                                   [](const Freedom& freedom) { return freedom.stiffness.has_value(); });
      });
  std::string note;
  if (weights) note = "that of weights is zero at the origin of the ground";
  if (situation.central_gravity) note = "that of the attraction is zero infinitely far away";
  if (springs) note += std::string(note.empty() ? "" : ", ") + "that of a spring where it is relaxed";
  if (!situation.loads.empty()) note += std::string(note.empty() ? "" : ", ") + "loads have none";
  if (note.empty()) return;
  note = "potential energy: " + note;
  if (std::ranges::find(result.notes, note) == result.notes.end()) result.notes.push_back(note);
}

// The points about which moments are asked along a motion.
void add_points_asked_about(const Expression& expression, bool along_motion, std::set<std::string>& points) {
  if (const At* at = expression.as<At>()) along_motion = along_motion || at->names.empty() || at->names.back() == "end";
  if (const Call* call = expression.as<Call>()) {
    along_motion = along_motion || call->function == "min" || call->function == "max" || call->function == "period";
    const Expression* about = call->argument("about");
    if (along_motion && about && about->as<Name>() && about->as<Name>()->primes == 0)
      points.insert(about->as<Name>()->name);
  }
  for_each_child(expression, [&](const Expression& child) { add_points_asked_about(child, along_motion, points); });
}

// Whether the file names a point for a place of bodies that move, and for none that rests.
bool goes_with_bodies(const Situation& situation, const std::string& point) {
  const auto names = [&](const Expression& expression) {
    std::set<std::string> all;
    collect_names(expression, all);
    return all.contains(point);
  };
  bool goes = false;
  for (const Joint& joint : situation.joints) {
    if (!names(joint.place) && !(joint.at && names(*joint.at))) continue;
    if (joint.from == "ground") return false;
    goes = true;
  }
  const auto rests = [&](const Body& body) {
    return std::ranges::any_of(situation.joints, [&](const Joint& joint) {
      return joint.from == "ground" && joint.to == body.name && joint.freedoms.empty() && !joint.kind->any_turning;
    });
  };
  return goes || std::ranges::any_of(situation.bodies, [&](const Body& body) {
           if (rests(body)) return false;
           return (body.center && names(*body.center)) || std::ranges::any_of(body.parts, [&](const Part& part) {
                    return std::ranges::any_of(part.shape.arguments,
                                               [&](const NamedExpression& one) { return names(one.value); });
                  });
         });
}

// A point stays where it is drawn, though the bodies that it belongs to go on.
void note_resting_points(const Statement& statement, Solution& result) {
  std::set<std::string> points;
  for (const Ask& ask : statement.asks) {
    for (const Expression& of : ask.of) add_points_asked_about(of, false, points);
    if (ask.when) add_points_asked_about(ask.when->condition, true, points);
    if (ask.table)
      for (const NamedExpression& column : ask.table->columns)
        add_points_asked_about(column.value, ask.table->over == "time", points);
  }
  for (const std::string& point : points)
    if (std::ranges::any_of(statement.situations,
                            [&](const Situation& situation) { return goes_with_bodies(situation, point); }))
      result.notes.push_back("about " + point + ": about the place where it is drawn, which stays while bodies move");
}

// Nothing but its moments of inertia tells what a body that is given by numbers rolls on.
void note_circles_of_contact(const Situation& situation, Solution& result) {
  for (const Contact& contact : situation.contacts) {
    const auto body = std::ranges::find(situation.bodies, contact.of, &Body::name);
    const bool knife_edge = !contact.no_slip_along.empty();
    if (!contact.touches() || contact.corner || knife_edge || body == situation.bodies.end() || !body->parts.empty() ||
        !body->added.empty() || !body->inertia || !body->inertia->axis)
      continue;
    const std::string note = "contact '" + contact.name + "' moves over the circle about the axis of '" + body->name +
                             "' through its mass center";
    if (std::ranges::find(result.notes, note) == result.notes.end()) result.notes.push_back(note);
  }
}

void add_notes(const Statement& statement, const Sample& sample, Solution& result) {
  note_attractions(statement, sample, result);
  note_resting_points(statement, result);
  const bool asks_frequencies = asks_function(statement, "frequencies");
  const bool asks_modes = asks_function(statement, "modes") || asks_function(statement, "eigenvalues");
  const bool asks_response = asks_function(statement, "response");
  const auto misfit = result.checks.find(stability_check);
  const bool unconfirmed = misfit != result.checks.end() && misfit->second > solve::spectrum_tolerance;
  // Where nobody asks for it, what fails to confirm it is no check of the answers.
  if (unconfirmed && std::ranges::none_of(statement.asks, looks_near_steady)) {
    result.checks.erase(misfit);
    result.notes.push_back(
        "whether the steady motion is stable is not told: the motion of its bodies, each by itself, does not confirm "
        "it");
  }
  for (const auto& [home, instant] : sample.instants()) {
    const Situation& situation = statement.situations[home.situation];
    if (instant->rough_blow() && !home.time)
      result.notes.push_back(words_of_blow(*instant->rough_blow(), instant->struck().impacts.front()) +
                             (situation.name.empty() ? "" : " @ " + situation.name));
    if (home.time || home.instant > 0) continue;
    for (const std::string& contact : instant->machine().line_contacts)
      result.notes.push_back("contact '" + contact + "' is along a line, and the bodies are free to turn across it: " +
                             "they are taken to touch at the point under at: alone");
    note_circles_of_contact(situation, result);
    if (asks_function(statement, "potential_energy")) note_zero_of_energy(*instant, situation, result);
    // Nothing is said of what a check refuses.
    if (result.refused || unconfirmed) continue;
    // Of rest that is asked for frequencies only, it is said if the motion does not stay near it.
    if (!situation.steady && !asks_frequencies && !asks_modes && !asks_response) continue;
    try {
      if (!situation.steady) {
        const solve::Linearisation& near = instant->linearisation({1, 1});
        note_modes(statement, *instant, near, result);
        if (asks_response) note_free_swings(near, result);
        if (asks_frequencies && solve::stability(near) == solve::Stability::unstable)
          result.notes.push_back("rest" + (situation.name.empty() ? "" : " @ " + situation.name) + " is " +
                                 stability_words(near));
        continue;
      }
      const solve::Linearisation& near = instant->linearisation(situation.steady->mark);
      result.notes.push_back("the steady motion" + (situation.name.empty() ? "" : " @ " + situation.name) + " is " +
                             stability_words(near));
      note_modes(statement, *instant, near, result);
      if (asks_response) note_free_swings(near, result);
    } catch (const UnsteadyError& error) {
      // A rotor in bearings is asked for what acts where it is drawn; a body that nothing drives leaves this motion.
      result.notes.push_back("the steady motion" + (situation.name.empty() ? "" : " @ " + situation.name) +
                             " is looked at where it is drawn; as it goes on, " + error.reason());
    } catch (const StatementError&) {
      // The statement does not say enough about what holds the motion, and stability is not reported.
    }
  }
  for (const auto& [situation, motion] : sample.motions()) {
    constexpr std::size_t most_told = 12;
    const std::vector<std::string>& happenings = motion->happenings();
    const std::size_t told = std::min(happenings.size(), most_told);
    result.notes.insert(result.notes.end(), happenings.begin(), happenings.begin() + static_cast<std::ptrdiff_t>(told));
    if (told < happenings.size())
      result.notes.push_back("and so on, " + std::to_string(happenings.size() - told) + " times more");
    const std::string& name = statement.situations[situation].name;
    for (const std::string& method : motion->methods())
      result.notes.push_back("the motion" + (name.empty() ? "" : " @ " + name) + ": " + method);
  }
}

}  // namespace poinsot::problem
