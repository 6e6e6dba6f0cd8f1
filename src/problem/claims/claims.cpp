#include "problem/claims/claims.h"

#include <algorithm>
#include <map>

#include "poinsot/engine/work/budget.h"
#include "problem/claims/claim_letters.h"
#include "problem/claims/claim_solver.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

std::size_t situation_of_claim(const Statement& statement, const Claim& claim) {
  if (claim.situation.empty()) {
    if (statement.situations.size() == 1) return 0;
    fail(statement.file, claim.mark, "in which situation does claim '" + claim.name + "' hold?",
         "write {claim: ..., situation: " + statement.situations.front().name + "}");
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < statement.situations.size(); ++i) {
    if (statement.situations[i].name == claim.situation) return i;
    names.push_back(statement.situations[i].name);
  }
  fail(statement.file, claim.situation_mark, "there is no situation '" + claim.situation + "'",
       did_you_mean(claim.situation, names));
}

// The first unknown that has neither a number nor a formula.
const std::string* without_value(const Situation& situation, const Settings& settings, const FormulaValues& formulas) {
  for (const Unknown& unknown : situation.find)
    if (!settings.contains(unknown.name) && !formulas.contains(unknown.name)) return &unknown.name;
  return nullptr;
}

// Whether the weight of the situation uses the number of standard gravity, and g is not otherwise taken.
bool has_standard_gravity(const Situation& situation, const Settings& settings) {
  const auto is_g = [](const auto& item) { return item.name == "g"; };
  return situation.gravity && situation.find.empty() && !settings.contains("g") &&
         std::none_of(situation.given.begin(), situation.given.end(), is_g) &&
         std::none_of(situation.letters.begin(), situation.letters.end(), is_g);
}

// Decides the claim with a letter in place of standard gravity. A proof for any g holds for the number too, and
// formulas are easier to follow with the letter; so the result is used if the verdict is the same.
void decide_with_letter_for_gravity(const Statement& prepared, std::size_t k, const Claim& claim,
                                    const Settings& settings, const FormulaValues& exact, bool tell,
                                    SolvedClaim& solved) {
  if (!has_standard_gravity(prepared.situations[k], settings)) return;
  Statement lettered = prepared;
  lettered.situations[k].letters.push_back({"g", si_unit(dimensions::acceleration), {}});
  const FormulaValues no_unknowns;
  try {
    ClaimGround ground(lettered.situations[k], settings, exact, no_unknowns);
    SolvedClaim told = solve_claim(lettered, k, claim, ground, tell);
    if (told.proved && told.holds && solved.holds) solved.proved = true;
    if (told.state != solved.state || told.holds != solved.holds || told.proved != solved.proved) return;
    solved.comparisons = std::move(told.comparisons);
    solved.assumed = std::move(told.assumed);
    solved.stability = std::move(told.stability);
  } catch (const StatementError&) {
    // The size of gravity is stated in some other way, and the letter cannot stand for it.
  }
}

// A derivative by a letter is that of a formula, and of a letter with a value there is none; what a claim assumes may
// not hold at the values that letters have. What holds for all values of the letters holds at these.
void decide_for_all_letters(const Statement& prepared, std::size_t k, const Claim& claim, const Settings& settings,
                            const FormulaValues& exact, bool tell, SolvedClaim& solved) {
  const Situation& situation = prepared.situations[k];
  Settings open = settings;
  FormulaValues open_exact = exact;
  for (const Letter& letter : situation.letters) {
    open.erase(letter.name);
    open_exact.erase(letter.name);
  }
  if (open.size() == settings.size() || !situation.find.empty()) return;
  const FormulaValues no_unknowns;
  ClaimGround ground(situation, open, open_exact, no_unknowns);
  SolvedClaim told = solve_claim(prepared, k, claim, ground, tell);
  if (told.state == AskState::found && told.holds)
    solved = std::move(told);
  else if (told.state == AskState::found && takes_derivatives(situation, claim))
    solved.reason =
        "it does not hold for all letters, and by letters that have values there is no derivative: leave them open";
}

}  // namespace

std::vector<SolvedClaim> solve_claims(const Statement& statement, const std::vector<Settings>& settings,
                                      const FormulaValues& exact, const std::vector<FormulaValues>& unknowns,
                                      bool tell) {
  if (statement.claims.empty()) return {};
  Statement prepared = statement;
  for (Situation& situation : prepared.situations) situation = with_letters_for_any(situation);
  std::map<std::size_t, ClaimGround> grounds;
  std::vector<SolvedClaim> solved;
  const ProgressTeller progress("deciding the claims");
  for (const Claim& claim : prepared.claims) {
    progress.tell(static_cast<double>(solved.size()) / static_cast<double>(prepared.claims.size()), solved.size());
    const std::size_t k = situation_of_claim(prepared, claim);
    const Situation& situation = prepared.situations[k];
    if (const std::optional<BudgetEnd> end = how_budget_ended()) {
      solved.emplace_back();
      solved.back().state = AskState::undetermined;
      solved.back().reason = words_of(*end);
      solved.back().ended = *end;
      continue;
    }
    if (const std::string* unknown = without_value(situation, settings[k], unknowns[k])) {
      solved.emplace_back();
      solved.back().state = AskState::undetermined;
      solved.back().reason = "it depends on the unknown '" + *unknown +
                             "', of which no formula was found: give values to the letters by --set";
      continue;
    }
    SolvedClaim found;
    try {
      check_budget();
      ClaimGround& ground = grounds.try_emplace(k, situation, settings[k], exact, unknowns[k]).first->second;
      found = solve_claim(prepared, k, claim, ground, tell);
      if (found.state != AskState::found && (takes_derivatives(situation, claim) || !claim.assume.empty()))
        decide_for_all_letters(prepared, k, claim, settings[k], exact, tell, found);
      if (found.state == AskState::found && (tell || (found.holds && !found.proved)))
        decide_with_letter_for_gravity(prepared, k, claim, settings[k], exact, tell, found);
    } catch (const BudgetEnded& ended) {
      found = {};
      found.state = AskState::undetermined;
      found.reason = words_of(ended.end);
      found.ended = ended.end;
    }
    solved.push_back(std::move(found));
  }
  return solved;
}

}  // namespace poinsot::problem
