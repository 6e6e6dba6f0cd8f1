#include "problem/explanation/explanation_motion.h"

#include <algorithm>

#include "problem/explanation/kept_values.h"
#include "problem/explanation/turning_points.h"
#include "problem/language/words.h"

namespace poinsot::problem {

std::vector<ExplainedSection> motion_sections(const Statement& statement, std::size_t situation_index, Sample& sample,
                                              const GeneralMotion* general, const ExplanationTex& tex,
                                              const std::string& suffix) {
  const Situation& situation = statement.situations[situation_index];
  Course& motion = sample.motion(situation_index);
  ExplainedSection section{"Motion through time" + suffix, {}};
  for (const Stage& stage : situation.stages) {
    std::string text = "Stage *" + stage.name + "*";
    if (stage.lasts) text += " lasts `" + to_string(*stage.lasts) + "`";
    if (stage.until) text += " ends when `" + to_string(*stage.until) + "`";
    section.steps.push_back({text + ".", {}});
  }
  for (const std::string& method : motion.methods())
    section.steps.push_back({"How it is followed: " + method + ".", {}});
  for (const std::string& happening : motion.happenings()) section.steps.push_back({happening + ".", {}});
  const double reached = motion.reached();
  if (reached > 0 && situation.stages.size() <= 1) {
    const std::vector<KeptValue> values = kept_values(situation, situation_index, sample, reached, general);
    ExplainedStep kept{"", {}};
    std::vector<std::string> words;
    for (const KeptValue& one : values) {
      words.push_back(one.words);
      const Shown shown{one.value, one.formula};
      if (tex.can_show(shown)) kept.equations.push_back(tex.kept(one.symbol, shown, one.dimension));
    }
    std::erase_if(kept.equations, [](const ExplainedEquation& equation) { return equation.sides.empty(); });
    if (!words.empty()) {
      kept.text = "Along the motion " + listed(words) + (words.size() > 1 ? " keep their values" : " keeps its value") +
                  (kept.equations.empty() ? "." : " of the start:");
      section.steps.push_back(std::move(kept));
    }
    if (general)
      for (ExplainedStep& step : turning_points(statement, situation_index, sample, values, *general, tex))
        section.steps.push_back(std::move(step));
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
