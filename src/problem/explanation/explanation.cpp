// Turns a solved statement into a worked solution: chooses the instants to explain, their numbers and their formulas.
#include "problem/explanation/explanation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <ranges>
#include <set>

#include "poinsot/engine/work/work.h"
#include "problem/explanation/explanation_claims.h"
#include "problem/explanation/explanation_instant.h"
#include "problem/explanation/explanation_model.h"
#include "problem/explanation/explanation_motion.h"
#include "problem/explanation/explanation_near_steady.h"
#include "problem/explanation/shared_factors.h"
#include "problem/explanation/shown_numbers.h"
#include "problem/formulas/formula_answers.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/machine/data.h"

namespace poinsot::problem {
namespace {

constexpr Work most_instant_work = 1'500'000'000;  // for all formulas of one instant
constexpr std::size_t formula_terms = 3000;

class Explainer {
 public:
  Explainer(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
            const SolvedStatement& solved, std::size_t solution)
      : statement_(statement),
        sets_(sets),
        solved_(solved),
        place_(solution),
        solution_(solved.solutions[solution]),
        numbers_(statement, sets, solved, solution) {}

  Explanation explain() {
    const bool numbers = !statement_.asks.empty() && numbers_.choose();
    ExplanationTex first_tex(statement_.situations.front(), numbers_.open_letters());
    add_models(first_tex);
    if (numbers) questions_ = numbers_.questions();
    explanation_.sections.push_back(principle_section(statement_, questions_));
    std::vector<ExplainedSection> at_limits = numbers ? sections_at_limits() : std::vector<ExplainedSection>{};
    add_limits();
    if (numbers) add_tables();
    if (ExplainedSection claims = claims_section(statement_, solution_, first_tex); !claims.steps.empty())
      explanation_.sections.push_back(std::move(claims));
    if (!numbers) return std::move(explanation_);
    or_left_out([&] { ask_for_stages(); });
    or_left_out([&] { ask_for_starts(); });
    // The motion leads from the instants at its start to those that come later.
    const auto add_instants = [&](bool later) {
      for (const auto& [home, questions] : questions_.instants)
        if ((home.time || home.ending) == later) {
          add_blows(home.situation, home.time);
          or_left_out([&, &at = home, &asked = questions] { add_instant(at, asked); });
        }
    };
    add_instants(false);
    for (const std::size_t index : questions_.motions) or_left_out([&] { add_motion(index); });
    add_instants(true);
    for (const std::size_t index : questions_.motions) add_blows(index, std::nullopt);
    add_neglecting();
    append_at_limits(explanation_.sections, std::move(at_limits), statement_.situations.size() == 1);
    leave_out_said_inertia(explanation_.sections);
    return std::move(explanation_);
  }

  // The lines at the limit of a statement that asks for nothing else; none where there are no numbers at it.
  std::vector<ExplainedSection> explain_limit() {
    if (!numbers_.choose() || numbers_.limits().empty()) return {};
    questions_ = numbers_.questions();
    for (const auto& [home, questions] : questions_.instants) {
      // Where other contacts are in another state at the limit its lines are left out.
      SolvedInstant& instant = numbers_.sample().instant(home);
      if (instant.forces_solved() && std::ranges::any_of(instant.one_sided_faults(), [&](const auto& fault) {
            return !is_sticking(home.situation, instant.machine().mechanism.actions[fault.action].name);
          }))
        return {};
      or_left_out([&, &at = home, &asked = questions] { add_instant(at, asked); });
    }
    return std::move(explanation_.sections);
  }

 private:
  const Situation& situation(std::size_t situation) const { return statement_.situations[situation]; }
  std::string suffix_of(std::size_t situation) const {
    return statement_.situations.size() > 1 ? ", *" + statement_.situations[situation].name + "*" : "";
  }

  // An answer is given even if its explanation needs something that the statement does not tell.
  template <class Add>
  void or_left_out(const Add& add) {
    try {
      add();
    } catch (const StatementError& error) {
      explanation_.sections.push_back(
          {"Left out", {{"The steps end here: " + error.diagnostics().front().message + ".", {}}}});
    }
    std::erase_if(explanation_.sections, [](const ExplainedSection& section) { return section.steps.empty(); });
  }

  // Of a limit beside other questions the lines above are not those at it: these stand by themselves.
  std::vector<ExplainedSection> sections_at_limits() {
    std::vector<ExplainedSection> sections;
    for (std::size_t k = 0; k < statement_.asks.size(); ++k) {
      const Ask& ask = statement_.asks[k];
      if (!ask.extremum || explains_limit(k)) continue;
      const auto again = [&](std::size_t other) {
        const Ask& same = statement_.asks[other];
        return same.extremum && (explains_limit(other) || limits_apart_.contains(other)) &&
               words_of_limit(same) == words_of_limit(ask) &&
               situation_of(statement_, same) == situation_of(statement_, ask);
      };
      if (std::ranges::any_of(std::views::iota(std::size_t{0}, statement_.asks.size()), again)) continue;
      Statement alone = statement_;
      alone.asks = {ask};
      alone.claims.clear();
      if (!let_stick(alone.situations[situation_of(statement_, ask)], ask)) continue;
      SolvedStatement found = solved_;
      found.solutions[place_].asks = {solution_.asks[k]};
      found.solutions[place_].claims.clear();
      for (ExplainedSection& section : Explainer(alone, sets_, found, place_).explain_limit()) {
        section.heading +=
            std::string(", at the ") + (ask.extremum->largest ? "largest *" : "smallest *") + ask.extremum->name + "*";
        const auto known = std::ranges::find(sections, section.heading, &ExplainedSection::heading);
        if (known != sections.end()) section.heading += " of *" + ask.name + "*";
        sections.push_back(std::move(section));
        limits_apart_.insert(k);
      }
    }
    return sections;
  }
  // action: the name of a contact, of a joint, or of a cord with friction.
  bool is_sticking(std::size_t index, const std::string& action) const {
    const auto& contacts = situation(index).contacts;
    const auto found = std::ranges::find_if(contacts, [&](const Contact& contact) {
      return contact.name == action || (contact.on_cord && contact.of == action);
    });
    return found != contacts.end() && found->grip == Grip::sticks;
  }
  // What is said to stick at a limit sticks there, whatever it does with the data as they are stated. Returns false
  // where that is not said of a contact by its name.
  static bool let_stick(Situation& situation, const Ask& ask) {
    for (const Expression& condition : ask.extremum->conditions) {
      const Call* call = condition.as<Call>();
      const bool sticks = call != nullptr && call->function == "sticking" && call->arguments.size() <= 2;
      bool named = false;
      for (Contact& contact : situation.contacts) {
        if (!sticks || !is_about(*call, contact.name)) continue;
        contact.grip = Grip::sticks;
        named = true;
      }
      if (!named &&
          std::ranges::any_of(situation.contacts, [](const Contact& one) { return one.friction.has_value(); }))
        return false;
    }
    return true;
  }
  bool explains_limit(std::size_t ask) const {
    return std::ranges::any_of(numbers_.limits(), [&](const auto& limit) { return limit.second == ask; });
  }
  static std::string words_of_limit(const Ask& ask) {
    std::vector<std::string> conditions;
    for (const Expression& condition : ask.extremum->conditions) conditions.push_back(code(condition));
    return "Values of `" + ask.extremum->name + "` are tried from one end of its range until " + listed(conditions) +
           (conditions.size() > 1 ? " no longer hold" : " no longer holds") +
           "; the place of the change is then closed in.";
  }

  // Where squares are neglected and the forces do not take up what is missing, the equations hold for no numbers.
  void add_neglecting() {
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      const Situation& stated = situation(i);
      const bool explained =
          std::ranges::any_of(questions_.instants, [&](const auto& one) { return one.first.situation == i; });
      if (stated.neglect.empty() || stated.find.empty() || !stated.steady || explained) continue;
      std::vector<std::string> squares, unknown;
      for (const Expression& square : stated.neglect) squares.push_back(code(square));
      for (const Unknown& one : stated.find) unknown.push_back(code(one.name));
      explanation_.sections.push_back(
          {"Unknowns" + suffix_of(i),
           {{"The equations are those of the steady motion without their terms in " + listed(squares) +
                 ": they are linear in " + listed(unknown) + ", and hold up to these terms.",
             {}}}});
    }
  }

  void add_limits() {
    ExplainedSection section{"Limit", {}};
    for (std::size_t k = 0; k < statement_.asks.size(); ++k) {
      const Ask& ask = statement_.asks[k];
      if (!ask.extremum) continue;
      const bool apart = limits_apart_.contains(k), explained = explains_limit(k) || apart;
      std::string text = words_of_limit(ask);
      // The same limit may be asked for in several units.
      if (std::ranges::any_of(section.steps, [&](const ExplainedStep& step) { return step.text.starts_with(text); }))
        continue;
      if (explained)
        text += std::string(apart ? " The last lines below" : " The lines below") + " are those of the " +
                (ask.extremum->largest ? "largest" : "smallest") + " `" + ask.extremum->name + "`.";
      section.steps.push_back({text, {}});
    }
    if (!section.steps.empty()) explanation_.sections.push_back(std::move(section));
  }

  // A table over a datum asks the same for several values of it.
  void add_tables() {
    ExplainedSection section{"Table", {}};
    const Situation& first = statement_.situations.front();
    const std::vector<std::string> data = settable_names(first);
    for (const Ask& ask : statement_.asks) {
      if (!ask.table || std::ranges::find(data, ask.table->over) == data.end()) continue;
      const auto stated = std::ranges::find(first.given, ask.table->over, &NamedExpression::name);
      std::string text = "The table *" + ask.name + "* asks for each of its rows what the lines below lead to";
      text += stated == first.given.end()
                  ? "."
                  : " for `" + ask.table->over + " = " + to_string(stated->value) + "`, the value that is stated.";
      if (std::ranges::any_of(first.contacts, [](const Contact& contact) { return contact.friction.has_value(); }))
        text += " In a row in which a contact slides that sticks here its friction is the coefficient times its push.";
      section.steps.push_back({text, {}});
    }
    if (!section.steps.empty()) explanation_.sections.push_back(std::move(section));
  }

  void add_models(const ExplanationTex& tex) {
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      // The value of what is to be found is no part of what is given.
      std::set<std::string> hidden;
      for (const Unknown& unknown : situation(i).find) hidden.insert(unknown.name);
      if (const auto limit = numbers_.limits().find(i); limit != numbers_.limits().end())
        hidden.insert(statement_.asks[limit->second].extremum->name);
      explanation_.sections.push_back(
          model_section(situation(i), numbers_.settings()[i], hidden, tex, "Model" + suffix_of(i)));
    }
  }

  // An instant to which stages have led in which nothing changes: what they lead to is derived at their starts.
  void ask_for_stages() {
    std::map<Sample::Home, InstantQuestions> asked;
    for (const auto& [home, questions] : questions_.instants) {
      if (home.time || home.ending || home.instant == 0 || situation(home.situation).has_blow()) continue;
      for (std::size_t stage = 0; stage < home.instant; ++stage) {
        if (!is_uniform_stage(numbers_.sample(), home.situation, stage)) break;
        const Sample::Home start{home.situation, stage, std::nullopt};
        SolvedInstant& instant = numbers_.sample().instant(start);
        instant.solve_forces();
        for (const NamedCoordinate& one : instant.machine().coordinates)
          for (const Joint& joint : situation(home.situation).joints)
            if (joint.name == one.joint && !one.name.empty())
              asked[start].accelerated.insert(instant.machine().index.at(joint.to));
        asked[start].accelerations = true;
        uniform_stages_.insert(start);
      }
    }
    for (const auto& [home, questions] : asked) {
      InstantQuestions& all = questions_.instants[home];
      all.accelerated.insert(questions.accelerated.begin(), questions.accelerated.end());
      all.accelerations = true;
    }
  }

  // Of a motion that fixes data to be found by what is stated of it later it is told how it begins.
  void ask_for_starts() {
    for (const std::size_t index : questions_.motions) {
      const Situation& stated = situation(index);
      // A motion that a stated blow begins has its velocities from that.
      if (stated.has_blow()) questions_.instants[{index, 1, std::nullopt}];
      const Sample::Home start{index, 0, std::nullopt};
      const bool later = std::ranges::any_of(
          stated.instants, [&](const Instant& instant) { return is_later(stated, instant) && !instant.facts.empty(); });
      const bool asked = std::ranges::any_of(questions_.instants, [&](const auto& one) {
        return one.first.situation == index && one.second.asks_forces();
      });
      if (stated.find.empty() || !later || asked || stated.has_blow()) continue;
      SolvedInstant& instant = numbers_.sample().instant(start);
      instant.solve_forces();
      InstantQuestions& questions = questions_.instants[start];
      for (const Body& body : stated.bodies) questions.accelerated.insert(instant.machine().index.at(body.name));
      questions.accelerations = true;
    }
  }

  void add_instant(const Sample::Home& home, const InstantQuestions& questions) {
    const Situation& stated = situation(home.situation);
    SolvedInstant& instant = numbers_.sample().instant(home);
    SolvedInstant* before =
        instant.after_blow() ? &numbers_.sample().instant({home.situation, 0, std::nullopt}) : nullptr;
    // In the formulas every datum that is a single number is a letter.
    Situation lettered = stated;
    LetterValues point;
    FormulaValues values = numbers_.formula_values(home.situation, lettered, point);
    std::vector<std::string> open = numbers_.open_letters(home.situation);
    // So is what was found at values of letters.
    for (const SolvedUnknown& unknown : solution_.unknowns)
      if (!open.empty() && unknown.is_of(home.situation) && unknown.formula && !letters_in(*unknown.formula).empty())
        open.push_back(unknown.own_name);
    const std::vector<std::string> masses = letters_of_any_masses(lettered, values, point);
    const FormulaLimitScope limits({formula_terms, most_instant_work});
    const PlainPointScope decisions(point);
    std::unique_ptr<FormulaInstant> formulas;
    if (!home.time && !home.ending && home.instant <= (stated.has_blow() ? 1U : 0U)) {
      try {
        formulas = std::make_unique<FormulaInstant>(lettered, values, instant);
        if (instant.forces_solved()) formulas->solve_forces();
      } catch (const std::exception&) {
        formulas.reset();
      }
    }
    // Numbers at values that nobody stated would say nothing.
    const std::string suffix = suffix_of(home.situation) + instant_words(home);
    if (!formulas && !open.empty() && !home.time && !home.ending) {
      explanation_.sections.push_back({(before ? "Impulse and momentum" : "Component equations") + suffix,
                                       {{"In letters these equations have no closed form; what is told below comes "
                                         "from their solutions at values of "
                                         "the letters.",
                                         {}}}});
      return;
    }
    // Without formulas a mass that may be any is seen in numbers alone.
    if (formulas) open.insert(open.end(), masses.begin(), masses.end());
    ExplanationTex tex(stated, std::move(open));
    if (formulas) tex.set_any_masses(masses.size());
    LetterValues in_shown_units;
    const auto add_in_units = [&](const std::string& letter, const Dimension& dimension) {
      if (const auto known = point.find(letter); known != point.end())
        in_shown_units[letter] = known->second / tex.unit(dimension).factor;
    };
    for (const auto& [name, value] : values) {
      add_in_units(name, value.dimension);
      for (std::size_t k = 0; k < 3 && value.is_vector(); ++k)
        add_in_units(component_letter(lettered, name, k), value.dimension);
    }
    if (stated.habits.customary()) tex.set_letters(in_shown_units);
    const std::vector<Formula> factors = factors_of(values);
    InstantExplainer(stated, instant, before, formulas.get(), point, factors, tex, questions,
                     numbers_.settings()[home.situation], explanation_)
        .explain(suffix, home.time || home.ending);
    explanation_.sections.push_back(vectors_section(statement_, solution_, home, numbers_.sample(), tex, suffix));
    explanation_.sections.push_back(turned_axes_section(statement_, home, numbers_.sample(), tex, suffix));
    if (uniform_stages_.contains(home))
      explanation_.sections.push_back(
          uniform_stage(stated, home.situation, home.instant, numbers_.sample(), tex, suffix_of(home.situation)));
    if (!questions.stability) return;
    NearSteady near{stated, instant, formulas.get(), point, factors, questions.responses};
    if (const auto limit = numbers_.limits().find(home.situation); limit != numbers_.limits().end()) {
      const std::string& name = statement_.asks[limit->second].extremum->name;
      if (const auto datum = values.find(name); datum != values.end())
        near.limit = FoundDatum{name, datum->second.dimension, point.at(name)};
    }
    explanation_.sections.push_back({"Small disturbances" + suffix, near_steady_steps(near, tex)});
  }

  // What the terms of an equation may share: data, and the sines and cosines of those that are angles.
  static std::vector<Formula> factors_of(const FormulaValues& values) {
    std::vector<Formula> letters, angles;
    for (const auto& [name, value] : values) {
      if (!value.is_number() || value.number.letters().empty()) continue;
      (value.dimension == dimensions::angle ? angles : letters).push_back(value.number);
    }
    return possible_factors(letters, angles);
  }

  void add_motion(std::size_t index) {
    Course& motion = numbers_.sample().motion(index);
    if (!(motion.reached() > 0)) motion.follow(motion.pace_time());
    Situation lettered = motion.situation();
    LetterValues point;
    FormulaValues values = numbers_.formula_values(index, lettered, point);
    const std::vector<std::string> masses = letters_of_any_masses(lettered, values, point);
    std::vector<std::string> open = numbers_.open_letters(index);
    if (masses.size() > 1) open.insert(open.end(), masses.begin(), masses.end());
    ExplanationTex tex(situation(index), open);
    const FormulaLimitScope limits({formula_terms, most_instant_work});
    std::unique_ptr<GeneralMotion> general;
    // A time at which nothing is special; stages have loads of their own.
    constexpr double inside = 0.3871;
    const MotionState now = motion.at(inside * motion.reached());
    if (motion.reached() > 0 && situation(index).stages.size() <= 1)
      general = GeneralMotion::of(lettered, values, numbers_.settings()[index], now, point);
    if (general)
      if (const auto letters = general->letters_at(now)) tex.set_letters(general->in_shown_units(*letters, tex));
    bool derived = false;
    for (ExplainedSection& section : motion_sections(statement_, index, numbers_.sample(), general.get(),
                                                     masses.size() == 1 ? masses.front() : std::string(),
                                                     numbers_.settings()[index], tex, suffix_of(index))) {
      for (const ExplainedStep& step : section.steps)
        for (const ExplainedEquation& equation : step.equations) derived = derived || shows_rate(equation.tex);
      explanation_.sections.push_back(std::move(section));
    }
    blows_[index] = later_blow_sections(motion, tex, numbers_.settings()[index], suffix_of(index));
    if (masses.size() == 1) open.push_back(masses.front());
    if (general) add_any_time(index, *general, now, values, std::move(open), derived);
  }

  // Those along a motion that have not been told yet, up to a time if one is given.
  void add_blows(std::size_t index, const std::optional<double>& until) {
    auto& blows = blows_[index];
    while (!blows.empty() && !(until && blows.begin()->first > *until)) {
      std::ranges::move(blows.begin()->second, std::back_inserter(explanation_.sections));
      blows.erase(blows.begin());
    }
  }

  // What is asked for of a whole motion, from the equations of any of its times, in formulas of the coordinates and
  // their rates. derived: whether what is kept has told how it moves.
  void add_any_time(std::size_t index, GeneralMotion& general, const MotionState& now, const FormulaValues& values,
                    std::vector<std::string> open, bool derived) {
    const auto along = questions_.along.find(index);
    if (along == questions_.along.end() || situation(index).has_blow()) return;
    const std::vector<std::string> coordinates = general.named_coordinates();
    const std::optional<LetterValues> letters = general.letters_at(now);
    if (coordinates.empty() || !letters) return;
    InstantQuestions asked = along->second;
    if (!asked.asks_forces()) {
      if (derived) return;
      // How it moves is what the equations of motion say.
      const Machine& machine = general.numbers().machine();
      for (const NamedCoordinate& one : machine.coordinates)
        for (const Joint& joint : situation(index).joints)
          if (joint.name == one.joint) asked.accelerated.insert(machine.index.at(joint.to));
      asked.accelerations = true;
    }
    // Equations of this kind are short or of no use to a reader.
    constexpr Work most_work = most_instant_work / 4;
    const FormulaLimitScope limits({formula_terms, most_work});
    const PlainPointScope decisions(*letters);
    try {
      general.numbers().solve_forces();
      general.formulas().solve_forces();
    } catch (const std::exception&) {
      return;
    }
    for (const std::string& name : coordinates) open.insert(open.end(), {name, GeneralMotion::rate_letter(name)});
    ExplanationTex tex(general.situation(), std::move(open));
    tex.set_letters(general.in_shown_units(*letters, tex));
    Explanation any_time;
    InstantExplainer(general.situation(), general.numbers(), nullptr, &general.formulas(), *letters, factors_of(values),
                     tex, asked, numbers_.settings()[index], any_time)
        .explain(suffix_of(index) + ", at any time", true);
    for (ExplainedSection& section : any_time.sections) {
      // Numbers of this one time are left out; so is what is too long to be read.
      for (ExplainedStep& step : section.steps) {
        const bool equations = !step.equations.empty();
        std::erase_if(step.equations, [](const ExplainedEquation& one) { return !is_equality(one.tex); });
        if (equations && step.equations.empty()) step.text.clear();
      }
      std::erase_if(section.steps,
                    [](const ExplainedStep& step) { return step.text.empty() && step.equations.empty(); });
      if (!section.steps.empty()) explanation_.sections.push_back(std::move(section));
    }
  }

  std::string instant_words(const Sample::Home& home) const {
    if (home.time) return ", at " + with_digits(*home.time, 4) + " s";
    const Situation& stated = situation(home.situation);
    std::size_t same_situation = 0;
    for (const auto& [other, questions] : questions_.instants)
      if (other.situation == home.situation) ++same_situation;
    if (same_situation < 2) return "";
    if (stated.has_blow()) return home.instant == 0 ? ", before the blow" : ", after the blow";
    return ", at the start" + (home.instant > 0 ? " of stage " + std::to_string(home.instant + 1) : std::string());
  }

  const Statement& statement_;
  const std::vector<std::pair<std::string, std::string>>& sets_;
  const SolvedStatement& solved_;
  std::size_t place_ = 0;  // of the solution
  const Solution& solution_;
  ShownNumbers numbers_;
  StatementQuestions questions_;
  std::set<Sample::Home> uniform_stages_;  // by their starts
  std::set<std::size_t> limits_apart_{};   // the asks for limits that have lines of their own
  std::map<std::size_t, std::map<double, std::vector<ExplainedSection>>> blows_{};  // of each situation, by time
  Explanation explanation_;
};

}  // namespace

Explanation explain(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
                    const SolvedStatement& solved, std::size_t solution) {
  return Explainer(statement, sets, solved, solution).explain();
}

}  // namespace poinsot::problem
