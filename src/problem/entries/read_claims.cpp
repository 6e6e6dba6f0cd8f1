#include "problem/entries/read_claims.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

std::vector<Expression> one_or_more(const Entry& entry, const std::string& file) {
  if (entry.kind == Entry::Kind::list) return expression_list(entry, file);
  return {parse_expression(entry, file)};
}

// Throws unless the expression is a comparison, or a call or name, which may be true or false.
void require_truth(const Expression& expression, const std::string& file) {
  if (expression.as<Comparison>() || expression.as<Call>() || expression.as<Name>()) return;
  fail(file, expression.mark(), "'" + to_string(expression) + "' claims nothing",
       "write a comparison, such as kinetic_energy(disk) == m*v^2/2, or stable(disk)");
}

// Questions whose answers are words.
constexpr std::array<std::string_view, 4> told_in_words{"precession_sense", "polhode", "axis_stability", "stability"};

}  // namespace

void refuse_compared_words(const Expression& expression, const std::string& file) {
  if (const Comparison* comparison = expression.as<Comparison>())
    for (const Expression& operand : comparison->operands) {
      const At* at = operand.as<At>();
      const Call* call = (at ? at->expression : operand).as<Call>();
      if (!call || std::ranges::find(told_in_words, call->function) == told_in_words.end()) continue;
      fail(file, operand.mark(), call->function + "() is told in words, and words are not compared",
           call->function == "stability" ? "claim stable(B)"
                                         : "ask for it by itself, or compare numbers, as in spin_rate(B) < 0 rad/s");
    }
  for_each_child(expression, [&](const Expression& child) { refuse_compared_words(child, file); });
}

Letter read_letter(const Key& name, const Entry& entry, const std::string& file) {
  Letter letter{name.text, {}, name.mark};
  letter.either_sign = entry.kind == Entry::Kind::map;
  const Entry& unit = letter.either_sign ? Members(entry, file, {"letter"}).require("signed", "signed: rad/s") : entry;
  if (!(unit.kind == Entry::Kind::scalar && unit.text == "1")) letter.unit = read_unit(unit, file);
  return letter;
}

std::vector<Expression> read_assumptions(const Members& members, const std::string& file) {
  const Entry* entry = members.find("assume");
  if (!entry) return {};
  std::vector<Expression> assumptions = one_or_more(*entry, file);
  for (const Expression& assumption : assumptions)
    if (!assumption.as<Comparison>())
      fail(file, assumption.mark(), "an assumption is a comparison", "write assume: [I > J, 0 deg < b < 90 deg]");
  return assumptions;
}

Claim read_claim(const Key& name, const Entry& entry, const std::string& file) {
  Claim claim;
  claim.name = name.text;
  claim.mark = name.mark;
  const Entry* of = &entry;
  if (entry.kind == Entry::Kind::map) {
    const Members members(entry, file, {"claim"});
    of = &members.require("claim", "claim: norm(H) == I*w");
    claim.assume = read_assumptions(members, file);
    claim.axes = members.expression("axes");
    if (const Entry* situation = members.find("situation")) {
      claim.situation = scalar_text(*situation, file, "the name of a situation");
      claim.situation_mark = members.mark_of("situation");
    }
  }
  claim.of = one_or_more(*of, file);
  if (claim.of.empty()) fail(file, of->mark, "claim '" + name.text + "' claims nothing");
  for (const Expression& expression : claim.of) {
    require_truth(expression, file);
    refuse_compared_words(expression, file);
    claim.text += (claim.text.empty() ? "" : ", ") + to_string(expression);
  }
  return claim;
}

}  // namespace poinsot::problem
