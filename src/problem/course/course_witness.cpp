// Second roads to a motion and to what was told of it.
#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/motion/integrator/event_search.h"
#include "poinsot/engine/solve/instant/constraint_check.h"
#include "problem/course/corners.h"
#include "problem/course/course.h"
#include "problem/course/motion_piece.h"
#include "problem/course/motion_witness.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// Part of the work of a motion and its questions that each of the two roads may be: with the motion that is followed
// less closely all of them are no more than what they stand beside.
constexpr double part_of_work = 0.25;

// The times up to one at which loads and given motions may have corners, as their expressions tell, in ascending order.
std::vector<double> driven_corners(const Situation& situation, const Settings& settings, double last) {
  std::vector<CornerOf> corners;
  for (const Expression& expression : driving_expressions(situation, std::nullopt))
    for (CornerOf& corner : corners_of(situation, expression)) corners.push_back(std::move(corner));
  constexpr std::size_t looks = 200, most = 1000;
  std::vector<double> times, found;
  for (std::size_t k = 0; k <= looks; ++k) times.push_back(last * static_cast<double>(k) / looks);
  DataScope<double> data(situation, settings);
  std::ranges::stable_sort(corners, std::greater(), &CornerOf::turns);
  for (const CornerOf& corner : corners) {
    const auto value = [&](double time) {
      data.set_time(time);
      const double number = data.value(corner.number).number;
      return corner.turns ? number * number : number;
    };
    try {
      for (const double time : corners_between(value, corner.turns, times)) found.push_back(time);
    } catch (const StatementError&) {
      // What depends on the motion as well has no corner that the time tells.
      continue;
    }
    if (found.size() > most) break;
    times.insert(times.end(), found.begin(), found.end());
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

// Times between which nothing sudden happens, spread over all steps of the motion: each as long as the step in which it
// begins, so that it reaches over its end.
std::vector<Course::SmoothPart> Course::windows(std::size_t count) const {
  struct Span {
    const Trajectory* piece;
    double before;  // the steps of earlier pieces
    bool turns;     // whether the direction of a slip turns in it
  };
  std::vector<Span> spans;
  double steps = 0;
  for (const StageRun& stage : stages_)
    for (std::size_t i = 0; i < stage.pieces.size(); ++i) {
      const Trajectory& piece = stage.pieces[i];
      if (piece.empty() || !(piece.end_time() > piece.start_time())) continue;
      spans.push_back(
          {&piece, steps, std::ranges::any_of(in_states_[stage.states[i]]->contacts, &Contact::slip_turns)});
      steps += static_cast<double>(piece.step_count());
    }
  std::vector<SmoothPart> found;
  for (std::size_t k = 0; k < count && !spans.empty(); ++k) {
    // Each part of the steps has one place of its own, and those within it are spread evenly.
    const double place = steps * (static_cast<double>(k) + spread_evenly(k)) / static_cast<double>(count);
    const auto after = std::ranges::upper_bound(spans, place, {}, &Span::before);
    const Span& span = *std::prev(after);
    const double in_piece = place - span.before;
    const auto index = std::min(static_cast<std::size_t>(in_piece), span.piece->step_count() - 1);
    const StepView step = span.piece->step(index);
    // The steps of a closed form may be as long as the motion.
    const double natural = step.flow ? std::min(step.flow->natural_time(), pace_time_) : INFINITY;
    const double length = std::min({step.end - step.start, natural, span.piece->end_time() - span.piece->start_time()});
    // Where a slip that turns comes to rest the steps shrink with it, and what changes in them is lost beside the
    // tolerance of the motion.
    constexpr double too_short = 1e-4;
    if (span.turns && length < too_short * (span.piece->end_time() - span.piece->start_time())) continue;
    const double from = std::min(step.start + (in_piece - std::floor(in_piece)) * (step.end - step.start),
                                 span.piece->end_time() - length);
    if (!(length > 0)) continue;
    if (!has_later_contacts_) {
      found.push_back({from, from + length, length});
      continue;
    }
    // At a blow two pieces meet with different velocities: the ends of a part are inside its own. Flights so short that
    // times have only a few digits left are passed over.
    constexpr double inside = 1e-3, short_flight = 1e-4;
    if (length > short_flight * pace_time_)
      found.push_back({from + inside * length, from + (1 - inside) * length, (1 - 2 * inside) * length});
  }
  return found;
}

NaturalSizes Course::natural_sizes() const {
  const Model<double>& tree = start_->machine().mechanism.tree;
  const double length = start_->scales().length;
  NaturalSizes sizes;
  for (const auto& body : tree.bodies())
    for (int k = 0; k < position_size(body.joint); ++k)
      sizes.of_q.push_back(body.joint == JointType::prismatic || (body.joint == JointType::free && k >= 4) ? length
                                                                                                           : 1);
  for (int k = 0; k < tree.velocity_size(); ++k) sizes.of_v.push_back(solve::coordinate_turns(tree, k) ? 1 : length);
  sizes.pace = 1 / pace_time_;
  return sizes;
}

// By the equations of the instant, which are not those that were followed.
std::optional<WitnessedState> Course::witnessed(double time) {
  const MotionState there = at(time);
  try {
    move_probe(there);
    probe_->solve_forces();
  } catch (const StatementError&) {
    // At the pole of Eulerian angles accelerations are no rates of the coordinates, and where a load is switched its
    // expression may have no value.
    return std::nullopt;
  }
  const MotionState now = probe_->state();
  const std::size_t n = now.v.size();
  WitnessedState state{now.q, now.v, std::vector<double>(now.q.size()), {}, std::vector<bool>(n, true)};
  // What is held at rest, as by wheels that lock one another, has the rounding of its forces and no motion that could
  // be compared: of the natural pace a few last places, and what is left of their limits where contacts with friction
  // hold.
  const double rounding = situation_.has_friction() ? 1e-12 : 1e-15;
  const auto hold_at_rest = [&](std::vector<double>& rates, double pace) {
    const std::vector<double> sizes = natural_sizes().of_v;
    for (std::size_t k = 0; k < n; ++k)
      if (std::abs(rates[k]) < rounding * sizes[k] * pace) rates[k] = 0;
  };
  hold_at_rest(state.v, 1 / pace_time_);
  position_rate<double>(probe_->machine().mechanism.tree, state.q, state.v, state.q_rate);
  const std::vector<double>& solved = probe_->motion().value;
  state.v_rate.assign(solved.begin(), solved.begin() + static_cast<std::ptrdiff_t>(n));
  hold_at_rest(state.v_rate, 1 / (pace_time_ * pace_time_));
  for (const std::vector<std::size_t>& share : probe_->motion().share)
    for (const std::size_t k : share)
      if (k < n) state.rate_known[k] = false;
  return state;
}

// Of the instant that the probe stands at: whether a cord pushes, a contact pulls, or what has parted overlaps.
MotionDoubt Course::contact_doubt(double time) {
  const std::string when = " at " + with_digits(time, 6) + " s";
  if (const std::vector<std::string> faults = probe_->unphysical(off_line * natural_speed()); !faults.empty())
    return {1, faults.front() + when};
  const MotionState now = at(time);
  if (now.acting.empty()) return {};
  if (has_later_contacts_ && !whole_machine_) whole_machine_ = probe_->machine_at(time, std::nullopt);
  const Machine& machine = whole_machine_ ? *whole_machine_ : start_->machine();
  const double overlap = solve::largest_overlap(machine.links, machine.mechanism.constraints,
                                                start_->natural_size(dimensions::length), now.acting, now.q);
  return {overlap, "what has parted overlaps or is stretched" + when};
}

std::optional<MotionDoubt> Course::course_misfit(const std::function<void(const SolvedInstant&)>& look) {
  constexpr std::size_t least = 4, most = 24;  // windows: these whatever they take, and these if the work allows
  // A window that is too long for the rule, or so long that a stiff motion answers the rounding of its places, is
  // taken in shorter parts: of a wrong rate these are wrong by the same part.
  constexpr int most_cuts = 3;
  // Of the change in a window: the rule of five points leaves less where the window suits it, and a wrong rate far
  // more.
  constexpr double good = 1e-9;
  const NaturalSizes sizes = natural_sizes();
  const WorkLimit limit(static_cast<Work>(part_of_work * static_cast<double>(work_)));
  std::optional<MotionDoubt> worst;
  const auto keep = [&](const MotionDoubt& doubt) {
    if (!worst || doubt.value > worst->value) worst = doubt;
  };
  const auto misfit_in = [&](const SmoothPart& part) {
    std::optional<double> misfit;
    double length = part.step;
    for (int cut = 0; cut <= most_cuts && !(misfit && *misfit <= good); ++cut, length /= 4) {
      const std::optional<double> shorter =
          window_misfit([&](double time) { return witnessed(time); }, part.from, part.from + length, sizes);
      if (!shorter) break;
      misfit = std::min(misfit.value_or(INFINITY), *shorter);
    }
    if (misfit)
      keep({*misfit, "between " + with_digits(part.from, 6) + " s and " + with_digits(part.to, 6) +
                         " s it changes otherwise than the equations of single instants tell"});
    return misfit;
  };
  // Where the work ends before them all, those that were looked at are spread over the motion.
  const std::vector<SmoothPart> parts = windows(most);
  // Of what lies between two corners of loads and given motions, which may be shorter than any step.
  constexpr std::size_t most_driven = 12;  // the shortest ones
  const std::vector<SmoothPart> driven = timed_ ? [&] {
    std::vector<SmoothPart> found;
    const std::vector<double> times = driven_corners(situation_, settings_, reached());
    constexpr double inside = 1e-3, least_part = 1e-9;  // of a part, and of the motion
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      // Where something else is sudden within it, what lies on one side.
      const Trajectory* piece = piece_at(0.5 * (times[k] + times[k + 1]));
      if (!piece) continue;
      const double begin = std::max(times[k], piece->start_time()), end = std::min(times[k + 1], piece->end_time());
      const double length = std::min(end - begin, pace_time_);
      if (length > least_part * reached())
        found.push_back({begin + inside * length, begin + (1 - inside) * length, (1 - 2 * inside) * length});
    }
    std::ranges::stable_sort(found, {}, &SmoothPart::step);
    if (found.size() > most_driven) found.resize(most_driven);
    return found;
  }() : std::vector<SmoothPart>();
  // Where a motion comes to the end of what is known of it, as where an end of a cord comes to its wheel, its steps
  // shrink: the check of an instant, which takes its differences at the pace of the whole, reaches beyond that place
  // from there.
  const auto shrinks = [&](const SmoothPart& part) {
    constexpr double too_short = 1e-2;  // of the longest step before
    const Trajectory* piece = piece_at(part.from);
    for (std::size_t i = 0; piece && i < piece->step_count() && piece->step(i).start < part.from; ++i)
      if (part.step < too_short * (piece->step(i).end - piece->step(i).start)) return true;
    return false;
  };
  std::size_t held = 0;
  for (const std::size_t k : spread_order(parts.size())) {
    const SmoothPart& part = parts[k];
    if (held >= least && limit.spent()) break;
    if (!misfit_in(part)) continue;
    ++held;
    const double middle = part.from + 0.5 * (part.to - part.from);
    if (!witnessed(middle)) continue;
    keep(contact_doubt(middle));
    if (!shrinks(part)) look(*probe_);
  }
  // Where velocities jump, something that did not act before touches or is stretched, by the geometry of the bodies.
  const auto catch_doubt = [&] {
    constexpr double jumps = 1e-6;          // of the natural speed: a blow below it moves nothing that is seen
    constexpr std::size_t most_blows = 40;  // blows that are looked at, the first ones
    MotionDoubt farthest;
    std::size_t looked = 0;
    const double length = start_->natural_size(dimensions::length);
    for (const StageRun& stage : stages_)
      for (std::size_t i = 0; i + 1 < stage.pieces.size() && looked < most_blows; ++i) {
        const Trajectory& before = stage.pieces[i];
        const auto after = std::find_if(stage.pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1, stage.pieces.end(),
                                        [](const Trajectory& piece) { return !piece.empty(); });
        if (before.empty() || after == stage.pieces.end() || stage.acting[i].empty()) continue;
        const double time = after->start_time();
        const State<double> here = before.state(before.end_time()), then = after->state(time);
        double jump = 0;
        for (std::size_t k = 0; k < here.v.size(); ++k)
          jump = std::max(jump, std::abs(then.v[k] - here.v[k]) * pace_time_ / sizes.of_v[k]);
        if (!(jump > jumps) || !(length > 0)) continue;
        ++looked;
        if (has_later_contacts_ && !whole_machine_) {
          move_probe(at(time));
          whole_machine_ = probe_->machine_at(time, std::nullopt);
        }
        const Machine& machine = whole_machine_ ? *whole_machine_ : start_->machine();
        double nearest = INFINITY;
        for (const VelocityConstraint<double>& c : machine.mechanism.constraints)
          if (c.action >= 0 && (c.normal || is_cord_length(c)) && !stage.acting[i][static_cast<std::size_t>(c.action)])
            nearest = std::min(
                nearest,
                std::abs(solve::gap_of(machine.links, machine.mechanism.constraints, c.action, here.q)) / length);
        if (std::isfinite(nearest) && nearest > farthest.value)
          farthest = {nearest,
                      "nothing touches or is stretched at " + with_digits(time, 6) + " s, where velocities jump"};
      }
    return farthest;
  };
  for (const SmoothPart& part : driven) misfit_in(part);
  keep(catch_doubt());
  for (const StageRun& stage : stages_) {
    std::vector<HeldStretch> stretches;
    for (std::size_t i = 0; i < stage.pieces.size(); ++i) {
      const Trajectory& piece = stage.pieces[i];
      HeldStretch& stretch = stretches.emplace_back(HeldStretch{stage.acting[i]});
      if (piece.empty()) continue;
      const StepView last = piece.step(piece.step_count() - 1);
      stretch.last_step = last.end - last.start;
      stretch.end = last.end;
    }
    const auto doubt = doubt_before_giving_way(
        stretches, [&](double time) { return witnessed(time) ? std::optional(contact_doubt(time)) : std::nullopt; });
    if (doubt) keep(*doubt);
  }
  // How long stages last is told by the file.
  double begins = 0;
  for (std::size_t k = 0; k < situation_.stages.size() && stages_[k].done && stages_[k].end; ++k) {
    const double ends = *stages_[k].end;
    if (const std::optional<Expression>& stated = situation_.stages[k].lasts) {
      const double lasts = start_->data_number(*stated, dimensions::time);
      const double off = std::abs(ends - begins - lasts), size = std::max(std::abs(lasts), std::abs(ends));
      if (size > 0) keep({off / size, words_of(k) + " does not last as long as is stated"});
    }
    begins = ends;
  }
  return worst;
}

// A question that is asked twice is held once.
void Course::tell(Told told) {
  if (std::ranges::find(told_, told.words, &Told::words) == told_.end()) told_.push_back(std::move(told));
}

NumberInTime Course::number_at_instants(const Expression& expression, const std::optional<Expression>& axes) {
  return [this, expression, axes](double time) {
    move_probe(at(time));
    return probe_->number(expression, axes);
  };
}

std::optional<MotionDoubt> Course::scan_misfit() {
  // Looks: those on which the cost of one is measured, and these if the work allows.
  constexpr std::size_t least = 24, most = 400;
  std::optional<MotionDoubt> worst;
  const double last = reached();
  const Work share = static_cast<Work>(part_of_work * static_cast<double>(work_)) / std::max<Work>(1, told_.size());
  for (const Told& told : told_) {
    const double to = std::min(told.to.value_or(last), last);
    const Work before = work_done();
    const MotionScan rough(told.number, told.from, to, least);
    const Work cost = std::max<Work>(1, (work_done() - before) / least);
    const std::size_t looks = std::min<std::size_t>(share / cost, most);
    const ScanMisfit found =
        looks > 2 * least ? told.against(MotionScan(told.number, told.from, to, looks)) : told.against(rough);
    if (!worst || found.value > worst->value)
      worst = {found.value, "'" + told.words + "' is contradicted at " + with_digits(found.time, 6) + " s"};
  }
  return worst;
}

}  // namespace poinsot::problem
