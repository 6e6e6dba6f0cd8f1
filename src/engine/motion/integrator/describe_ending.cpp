// How an integration ended, in words.
#include <fmt/format.h>

#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {

std::string describe(const IntegrationResult& result) {
  const std::string at = fmt::format(" at {:.6g} s", result.time);
  switch (result.ending) {
    case Ending::reached_end:
      return "the integration reached its end" + at;
    case Ending::terminal_event:
      return "an event ended the integration" + at;
    case Ending::interrupted:
      return "the integration was interrupted" + at;
    case Ending::step_limit:
      return "the limit of " + std::to_string(result.statistics.steps) + " steps ended the integration" + at +
             ": let it last shorter, or raise the limit or the tolerance";
    case Ending::work_limit:
      return "the limit of computing time ended the integration" + at;
    case Ending::step_too_small:
      return "the steps became too small" + at +
             ": the motion is singular there, or the tolerance is finer than rounding allows";
    case Ending::not_finite:
      return "the equations of motion give no finite accelerations" + at;
    case Ending::stiff:
      return "the equations became stiff" + at +
             ": accuracy asks for far longer steps than an explicit method can take";
    case Ending::no_convergence:
      return "the implicit equations of a step could not be solved" + at + ": a shorter step may do";
    case Ending::singular_pose:
      return "the motion came to a pose" + at +
             " from which it can go on in more than one way, or in none: constraints that bind it elsewhere repeat or "
             "contradict one another there";
    case Ending::no_stiff_solver:
      return "stiff equations need SUNDIALS, and this poinsot was built without it";
  }
  return {};
}

}  // namespace poinsot
