// Facts about later instants and about the motion as a whole.
#include <algorithm>
#include <cmath>

#include "problem/course/course.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

bool has_later_facts(const Situation& situation) {
  return std::any_of(situation.instants.begin(), situation.instants.end(), [&](const Instant& instant) {
    if (is_later(situation, instant)) return instant.rest || !instant.facts.empty();
    return std::any_of(instant.facts.begin(), instant.facts.end(),
                       [&](const Fact& fact) { return level_of(situation, fact.quantity) == Level::motion; });
  });
}

std::vector<FactMisfit> later_misfits(const Situation& situation, const Settings& settings, const OpenChoice& choice,
                                      std::optional<double> tolerance) {
  std::vector<FactMisfit> misfits;
  Course motion(situation, settings, choice);
  if (tolerance) motion.set_tolerance(*tolerance);
  // Trial values may lead to a motion that takes long to follow. A rough look is worth less.
  if (choice.trial) motion.set_work_limit(tolerance ? 100'000'000 : 1'000'000'000);
  for (const Instant& instant : situation.instants) {
    const bool later = is_later(situation, instant);
    if (later && instant.found_when) continue;
    std::vector<const Fact*> facts;
    for (const Fact& fact : instant.facts)
      if (later || level_of(situation, fact.quantity) == Level::motion) facts.push_back(&fact);
    if (later && instant.rest)
      fail(situation.file, instant.mark, "rest at a later instant is not sought",
           "state the velocities that vanish there");
    if (facts.empty()) continue;
    const std::vector<FactMisfit> more = motion.fact_misfits(later ? motion.time_of_instant(instant) : 0, facts);
    misfits.insert(misfits.end(), more.begin(), more.end());
  }
  return misfits;
}

double Course::time_of_instant(const Instant& instant) {
  for (std::size_t k = 0; k < situation_.stages.size(); ++k) {
    const std::string& name = situation_.stages[k].name;
    if (instant.name == name || instant.name == name + ".start") return stage_start(k);
    if (instant.name == name + ".end") {
      if (const auto end = stage_end(k)) return *end;
      fail(situation_.file, instant.mark, "stage '" + name + "' has no end", "write lasts: or until:");
    }
  }
  if (instant.found_when) return times(*instant.found_when, std::nullopt, 0, std::nullopt).front();
  if (!instant.when)
    fail(situation_.file, instant.mark, "'" + instant.name + "' is no time", "write a time such as 2 s");
  return start_->data_number(instant.when, dimensions::time);
}

// A tolerance for each step leaves some hundred times as much after some periods, in natural sizes. Small numbers
// follow larger ones more closely than that, and return as the usual motion does; of a rough one less is expected.
double Course::repeats_to(double range) const {
  constexpr double usual = 1e-7, growth = 100;
  if (tolerance_ <= usual_tolerance) return usual;
  // Beyond a hundredth of the range nothing would be a repetition.
  return std::min(1e-2, std::max(10 * usual, growth * tolerance_ / std::max(range, 1e-300)));
}

std::vector<FactMisfit> Course::fact_misfits(double time, const std::vector<const Fact*>& facts) {
  std::vector<Expression> sides;
  for (const Fact* fact : facts) sides.insert(sides.end(), {fact->quantity, fact->value});
  const MotionFeatureValues features = features_in(sides, std::nullopt);
  move_probe(at(time));
  std::vector<FactMisfit> misfits = probe_->fact_misfits(facts, features);
  if (!start_->scales().has_length) measure_by_what_is_stated(misfits, ways_of(facts, features, time, misfits));
  return misfits;
}

// How far the numbers of facts have gone until then, as far as a look halfway tells; zeros where they had no value.
std::vector<double> Course::ways_of(const std::vector<const Fact*>& facts, const MotionFeatureValues& features,
                                    double time, const std::vector<FactMisfit>& misfits) {
  std::vector<double> ways(misfits.size(), 0.0);
  try {
    move_probe(at(0));
    const std::vector<FactMisfit> begun = probe_->fact_misfits(facts, features);
    move_probe(at(time / 2));
    const std::vector<FactMisfit> halfway = probe_->fact_misfits(facts, features);
    for (std::size_t i = 0; i < ways.size(); ++i)
      ways[i] = std::abs(halfway[i].found - begun[i].found) + std::abs(misfits[i].found - halfway[i].found);
  } catch (const StatementError&) {
    // A direction of what stands still has none.
  }
  return ways;
}

// Particles in one place have no length. The way on which what pushes them changes their motion, by which it is
// followed, grows beyond all bounds with unknowns that let them fly on, and a place that they miss would be near. So a
// number is measured by what is stated of it, and zero by the largest that is stated beside it or by the metre.
void Course::measure_by_what_is_stated(std::vector<FactMisfit>& misfits, const std::vector<double>& ways) const {
  // Of the way that a number went: a smaller one is met to rounding alone.
  constexpr double least = 1e-5;
  solve::Scales scales = start_->scales();
  scales.length = 1;
  for (std::size_t i = 0; i < misfits.size(); ++i) {
    FactMisfit& misfit = misfits[i];
    double unit = std::abs(misfit.stated);
    for (const FactMisfit& other : misfits)
      if (misfit.stated == 0 && other.dimension == misfit.dimension) unit = std::max(unit, std::abs(other.stated));
    if (unit == 0) unit = natural_unit(scales, misfit.dimension);
    unit = std::max(unit, least * ways[i]);
    misfit.value = (misfit.found - misfit.stated) / unit;
    misfit.size = std::max(1.0, std::abs(misfit.found) / unit);
  }
}

}  // namespace poinsot::problem
