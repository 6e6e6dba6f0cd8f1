#include "statement/claims.h"

#include <map>

#include "statement/claim_letters.h"
#include "statement/claim_solver.h"
#include "statement/reader.h"

namespace poinsot::statement {
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

}  // namespace

std::vector<SolvedClaim> solve_claims(const Statement& statement, const std::vector<Settings>& settings,
                                      const FormulaValues& exact) {
  if (statement.claims.empty()) return {};
  Statement prepared = statement;
  for (Situation& situation : prepared.situations) situation.problem = with_letters_for_any(situation.problem);
  std::map<std::size_t, ClaimGround> grounds;
  std::vector<SolvedClaim> solved;
  for (const Claim& claim : prepared.claims) {
    const std::size_t k = situation_of_claim(prepared, claim);
    ClaimGround& ground = grounds.try_emplace(k, prepared.situations[k].problem, settings[k], exact).first->second;
    solved.push_back(solve_claim(prepared, k, claim, ground));
  }
  return solved;
}

}  // namespace poinsot::statement
