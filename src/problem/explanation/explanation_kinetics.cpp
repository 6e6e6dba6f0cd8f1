// The kinetic side: masses times accelerations, and rates of angular momenta (Eqs. 18.22, 18.23).
#include <algorithm>
#include <cmath>

#include "poinsot/engine/mass/principal_axes.h"
#include "problem/explanation/explanation_instant.h"
#include "problem/explanation/held_point.h"
#include "problem/instant/instant_conditions.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

Expression name_of_body(const std::string& name) { return built(Name{name}, Mark{}); }

}  // namespace

// Shows dH/dt of a body on the axes on which it is simplest: if possible on axes on which H is constant.
void InstantExplainer::rate_step(ExplainedSection& section, int body, const ExplainedPoint& reference, bool fixed) {
  const auto at = static_cast<std::size_t>(body + 1);
  const std::string& label = reference.label;
  const auto momentum = [&](const auto& figures) {
    return momentum_of(figures.now, {body}, position_of<ScalarOf<decltype(figures)>>(reference)).angular;
  };
  const auto rate = [&](const auto& figures) {
    return momentum_rate_of(figures.now, {body}, position_of<ScalarOf<decltype(figures)>>(reference)).angular;
  };
  const ShownVector H = shown_vector(momentum), total = shown_vector(rate);
  const double natural = natural_size(dimensions::moment);
  const std::string own = "\\mathbf{H}_{" + label + "}";
  if (!tex_.can_show(H)) return;
  ExplainedStep step;
  step.text = "Angular momentum of *" + body_name(body) + "* about " +
              (fixed ? "its fixed point $" + label + "$, $I_{" + label + "}\\boldsymbol{\\omega}$ (Eq. 18.13):"
                     : "its mass center, $I_{" + label + "}\\boldsymbol{\\omega}$ (Eq. 18.7):");
  step.equations.push_back(tex_.equation(own, H, dimensions::angular_momentum));
  if (is_rounding(norm(H.number), natural_size(dimensions::angular_momentum))) {
    step.text = "The angular momentum of *" + body_name(body) + "* about $" + label + "$ is zero.";
    step.equations.clear();
  }
  section.steps.push_back(std::move(step));
  // Axes to try are those of the steady frame, of the bodies that carry this one, and its own.
  std::vector<std::pair<int, std::string>> axes;
  if (situation_.steady)
    axes.emplace_back(figures_.numbers.machine->index.at(situation_.steady->frame), situation_.steady->frame);
  for (int i = mechanism().tree.body(body).parent; i != ground; i = mechanism().tree.body(i).parent)
    axes.emplace_back(i, body_name(i));
  axes.emplace_back(body, body_name(body));
  for (const auto& [index, name] : axes) {
    const Vector3<double> W = figures_.numbers.now.workspace().motion[static_cast<std::size_t>(index + 1)].w;
    if (norm(cross(W, H.number) - total.number) > 1e-9 * (norm(total.number) + natural)) continue;
    if (norm(total.number) <= 1e-9 * natural) {
      section.steps.push_back({"It does not change: $\\dot{\\mathbf{H}}_{" + label + "} = \\mathbf{0}$.", {}});
      return;
    }
    const auto frame = static_cast<std::size_t>(index + 1);
    const ShownVector Omega =
        shown_vector([&](const auto& figures) { return figures.now.workspace().motion[frame].w; });
    const ShownVector turned = shown_vector(
        [&](const auto& figures) { return cross(figures.now.workspace().motion[frame].w, momentum(figures)); });
    const std::string omega = index == body ? "\\boldsymbol{\\omega}" : "\\boldsymbol{\\Omega}";
    ExplainedStep turning;
    turning.text = "On axes that turn with *" + name + "*, at " +
                   tex_.inline_equation(omega, Omega, dimensions::angular_velocity) +
                   ", its components do not change: only their turning is left in Eq. 18.22:";
    turning.equations.push_back(
        tex_.equation("\\dot{\\mathbf{H}}_{" + label + "} = " + omega + "\\times" + own, turned, dimensions::moment));
    section.steps.push_back(std::move(turning));
    return;
  }
  // A body of revolution is described on the axes of its carrier, on which its moments of inertia are constant while
  // it spins.
  const int carrier = mechanism().tree.body(body).parent;
  if (carrier != ground && turns_unseen(mechanism().tree, body, solved_.scales().length)) {
    const auto frame = static_cast<std::size_t>(carrier + 1);
    const ShownVector Omega =
        shown_vector([&](const auto& figures) { return figures.now.workspace().motion[frame].w; });
    const ShownVector turned = shown_vector(
        [&](const auto& figures) { return cross(figures.now.workspace().motion[frame].w, momentum(figures)); });
    const ShownVector seen = shown_vector([&](const auto& figures) {
      return rate(figures) - cross(figures.now.workspace().motion[frame].w, momentum(figures));
    });
    ExplainedStep turning;
    turning.text = "On axes that turn with *" + body_name(carrier) + "*, at " +
                   tex_.inline_equation("\\boldsymbol{\\Omega}", Omega, dimensions::angular_velocity) +
                   ", Eq. 18.22 gives";
    const auto add = [&](const std::string& symbol, const ShownVector& value) {
      if (tex_.can_show(value))
        turning.equations.push_back(tex_.equation(symbol, clean(value, dimensions::moment), dimensions::moment));
    };
    add("(\\dot{\\mathbf{H}}_{" + label + "})_{\\mathrm{rel}}", seen);
    add("\\boldsymbol{\\Omega}\\times" + own, turned);
    add("\\dot{\\mathbf{H}}_{" + label + "}", total);
    section.steps.push_back(std::move(turning));
    return;
  }
  ExplainedStep step_rate;
  const ShownVector alpha = shown_vector([&](const auto& figures) { return figures.now.workspace().motion[at].alpha; });
  step_rate.text = "By Eq. 18.22 with $\\boldsymbol{\\Omega} = \\boldsymbol{\\omega}$ and " +
                   tex_.inline_equation("\\boldsymbol{\\alpha}", alpha, dimensions::angular_acceleration) + ":";
  const ShownVector spin = shown_vector([&](const auto& figures) {
    const auto& motion = figures.now.workspace().motion[at];
    return rate(figures) - cross(motion.w, momentum(figures));
  });
  const ShownVector turned =
      shown_vector([&](const auto& figures) { return cross(figures.now.workspace().motion[at].w, momentum(figures)); });
  const bool turns = norm(turned.number) > 1e-9 * natural;
  const std::string of_alpha = "I_{" + label + "}\\boldsymbol{\\alpha}";
  if (turns && tex_.can_show(spin) && norm(spin.number) > 1e-9 * natural)
    step_rate.equations.push_back(tex_.equation(of_alpha, spin, dimensions::moment));
  if (turns && tex_.can_show(turned))
    step_rate.equations.push_back(tex_.equation("\\boldsymbol{\\omega}\\times" + own, turned, dimensions::moment));
  if (tex_.can_show(total))
    step_rate.equations.push_back(tex_.equation(
        "\\dot{\\mathbf{H}}_{" + label + "}" + (turns ? std::string() : " = " + of_alpha), total, dimensions::moment));
  section.steps.push_back(std::move(step_rate));
}

bool InstantExplainer::is_particle(int body) const {
  return mechanism().tree.body(body).inertia.mass > 0 &&
         is_rounding(size_of(mass_of(figures_.numbers.now, body).inertia_center),
                     noise_size(dimensions::moment_of_inertia));
}

// Whether a body neither moves nor begins to.
bool InstantExplainer::stays_at_rest(int body) const {
  const auto& motion = figures_.numbers.now.workspace().motion[static_cast<std::size_t>(body + 1)];
  const Vector3<double> center = mass_of(figures_.numbers.now, body).center;
  const auto rate = momentum_rate_of(figures_.numbers.now, {body}, center);
  return norm(motion.w) == 0 && norm(motion.v) == 0 && norm(rate.linear) <= 1e-9 * natural_size(dimensions::force) &&
         norm(rate.angular) <= 1e-9 * natural_size(dimensions::moment);
}

void InstantExplainer::kinetic_steps(const std::string& heading, const System& system, const ExplainedPoint& point,
                                     bool moments_only, Plane plane) {
  for (const int body : system.plan.bodies) {
    if (!(mechanism().tree.body(body).inertia.mass > 0)) continue;
    const ExplainedPoint G = mass_center(body);
    const bool fixed = (moments_only || point.label != G.label) &&
                       is_held(figures_.numbers.now, body, point.position.number, solved_.scales().length);
    inertia_step(section("Inertia"), body, fixed ? &point : nullptr, plane);
    ExplainedSection& kinetic = section(heading);
    const auto at = static_cast<std::size_t>(body + 1);
    const ShownVector w = clean(shown_vector([&](const auto& figures) { return figures.now.workspace().motion[at].w; }),
                                dimensions::angular_velocity);
    if (norm(w.number) > 0 && tex_.can_show(w) && !sudden()) {
      for (const std::string& index : {std::string(), "_{" + ExplanationTex::upright(body_name(body)) + "}"})
        motion_said_.insert(body_name(body) + "\\boldsymbol{\\omega}" + index);
      kinetic.steps.push_back({"*" + body_name(body) + "* turns at",
                               {tex_.equation("\\boldsymbol{\\omega}", w, dimensions::angular_velocity)}});
    }
    if (sudden()) continue;
    const bool open = std::ranges::any_of(system.plan.open, [&](std::size_t k) { return !leads_across(k, plane); });
    if (!open && stays_at_rest(body)) {
      OpenRates& told = open_rates_[heading + ", at rest"];
      if (told.bodies.empty()) {
        told.step = kinetic.steps.size();
        kinetic.steps.emplace_back();
      }
      told.bodies.push_back("*" + body_name(body) + "*");
      kinetic.steps[told.step].text =
          listed(told.bodies) + (told.bodies.size() > 1 ? " stay at rest: nothing stands on their kinetic sides."
                                                        : " stays at rest: nothing stands on its kinetic side.");
      continue;
    }
    if (open) {
      // To what velocities a motion has led is found nowhere else, and what holds bodies asks for them.
      const ShownVector v = clean(shown_vector([&](const auto& figures) {
                                    const auto& motion = figures.now.workspace().motion[at];
                                    return motion.v + cross(motion.w, mass_of(figures.now, body).center - motion.p);
                                  }),
                                  dimensions::velocity);
      const std::string symbol = "\\mathbf{v}_{" + center_label(body) + "}";
      if (followed_ && !fixed && norm(v.number) > 0 && tex_.can_show(v) &&
          motion_said_.insert(body_name(body) + symbol).second)
        kinetic.steps.push_back({formula_instant_ ? "*" + body_name(body) + "* moves at"
                                                  : "The motion has led *" + body_name(body) + "* to",
                                 {tex_.equation(symbol, v, dimensions::velocity)}});
      const auto& link = mechanism().tree.body(body);
      std::string text = " change is unknown; the right sides below ";
      if (link.parent == ground && link.joint == JointType::revolute && fixed)
        text += "have it as Eq. 18.29 for a fixed axis.";
      else if (fixed)
        text += "have it as Eq. 18.28 for the fixed point $" + point.label + "$.";
      else
        text += "have it as Eqs. 18.1 and 18.23 say.";
      // Bodies of which the same is said are named in one sentence.
      OpenRates& told = open_rates_[heading + text];
      if (told.bodies.empty()) {
        told.step = kinetic.steps.size();
        kinetic.steps.emplace_back();
      }
      told.bodies.push_back("*" + body_name(body) + "*");
      kinetic.steps[told.step].text = "How fast the velocities of " + listed(told.bodies, "and") + text;
      continue;
    }
    const ShownVector ma = shown_vector([&](const auto& figures) {
      return momentum_rate_of(figures.now, {body}, position_of<ScalarOf<decltype(figures)>>(G)).linear;
    });
    const std::string center = center_label(body);
    // About a fixed point the moments alone say all that is asked.
    if (moments_only && fixed) {
      rate_step(kinetic, body, point, true);
      continue;
    }
    if (norm(ma.number) <= 1e-9 * natural_size(dimensions::force))
      kinetic.steps.push_back({"The mass center of *" + body_name(body) + "* has no acceleration.", {}});
    else if (tex_.can_show(ma))
      kinetic.steps.push_back({"The vector $m\\,\\mathbf{a}_{" + center + "}$ of *" + body_name(body) + "*:",
                               {tex_.equation("m\\,\\mathbf{a}_{" + center + "}", ma, dimensions::force)}});
    rate_step(kinetic, body, fixed ? point : G, fixed);
  }
}

// How a body turns on which no couple acts (Eqs. 18.46 to 18.49).
void InstantExplainer::explain_free_motion() {
  std::set<std::string> said;
  for (const Call& asked : questions_.free_motions) {
    const Expression& what = asked.arguments.front().value;
    const auto found = figures_.numbers.machine->index.find(to_string(what));
    if (found == figures_.numbers.machine->index.end() || found->second == ground || has_absorbed(found->second) ||
        !said.insert(found->first).second)
      continue;
    const int body = found->second;
    const Expression* about = nullptr;
    bool cone = false;
    for (const Call& other : questions_.free_motions) {
      if (to_string(other.arguments.front().value) != found->first) continue;
      if (const Expression* stated = other.argument("about")) about = stated;
      cone = cone || other.function == "body_cone" || other.function == "space_cone";
    }
    inertia_step(section("Inertia"), body, nullptr);
    std::vector<ExplainedStep> steps;
    motion_step(steps, body, "", false, false);
    const std::string label = center_label(body);
    const auto momentum = [&](const auto& figures) {
      return momentum_of(figures.now, {body}, mass_of(figures.now, body).center).angular;
    };
    ExplainedStep kept{"$\\mathbf{H}_{" + label + "} = I_{" + label +
                           "}\\boldsymbol{\\omega}$ (Eq. 18.7) keeps its size and its direction:",
                       {}};
    if (const ShownVector vector = shown_vector(momentum); tex_.can_show(vector))
      kept.equations.push_back(tex_.equation("\\mathbf{H}_{" + label + "}", vector, dimensions::angular_momentum));
    else
      kept.text.back() = '.';
    steps.push_back(std::move(kept));
    if (std::optional<ExplainedStep> turning = precession_step(body, found->first, about, cone))
      steps.push_back(std::move(*turning));
    ExplainedSection& here = section("Free motion");
    for (ExplainedStep& step : steps) here.steps.push_back(std::move(step));
  }
}

// Of a body of revolution; nothing of another one.
std::optional<ExplainedStep> InstantExplainer::precession_step(int body, const std::string& name,
                                                               const Expression* about, bool cone) {
  const MassProperties<double> mass = mass_of(figures_.numbers.now, body);
  constexpr double equal_moments = 1e-9;
  const PrincipalAxes<double> principal = principal_axes(mass.inertia_center, equal_moments);
  const Vector3<double> H = momentum_of(figures_.numbers.now, {body}, mass.center).angular;
  if (principal.symmetry != InertiaSymmetry::axisymmetric || !(norm(H) > 0)) return std::nullopt;
  Vector3<double> axis = principal.axes.column(principal.symmetry_axis);
  const Vector3<double> sense = about ? solved_.raw(*about, std::nullopt, nullptr).vector
                                      : figures_.numbers.now.workspace().motion[static_cast<std::size_t>(body + 1)].w;
  if (dot(axis, sense) < 0) axis = -axis;
  ExplainedStep step{
      "With the moments $I$ about its axis of revolution and $I'$ across it, and the angle $\\theta$ of "
      "$\\mathbf{H}_{" +
          center_label(body) + "}$ with the axis, *" + name + "* precesses about $\\mathbf{H}_{" + center_label(body) +
          "}$ and spins about its axis (Eqs. 18.47 to 18.49):",
      {}};
  const auto add = [&](const std::string& symbol, const Shown& value, const Dimension& dimension) {
    if (tex_.can_show(value)) step.equations.push_back(tex_.equation(symbol, value, dimension));
  };
  const auto quantity = [&](const char* function, bool with_sense) {
    const Expression call =
        built(Call{function, with_sense && about ? std::vector<Argument>{{"", name_of_body(name)}, {"about", *about}}
                                                 : std::vector<Argument>{{"", name_of_body(name)}}},
              Mark{});
    std::optional<Formula> formula;
    if (formula_instant_) try {
        formula = formula_instant_->raw(call, std::nullopt, nullptr).number;
      } catch (const std::exception&) {
        // Without formula the number is shown alone.
      }
    return confirmed(solved_.raw(call, std::nullopt, nullptr).number, formula);
  };
  add("I", {principal.moments[principal.symmetry_axis], {}}, dimensions::moment_of_inertia);
  add("I'", {principal.moments[1], {}}, dimensions::moment_of_inertia);
  add("\\theta", {std::atan2(norm(cross(axis, H)), dot(axis, H)), {}}, dimensions::angle);
  const std::string size = "H_{" + center_label(body) + "}";
  add("\\dot{\\phi} = \\frac{" + size + "}{I'}", quantity("precession_rate", false), dimensions::angular_velocity);
  add("\\dot{\\psi} = \\frac{I' - I}{I\\,I'}\\," + size + "\\cos\\theta", quantity("spin_rate", true),
      dimensions::angular_velocity);
  if (cone)
    add("\\gamma = \\arctan\\left(\\frac{I}{I'}\\tan\\theta\\right)", quantity("body_cone", false), dimensions::angle);
  if (step.equations.empty()) return std::nullopt;
  return step;
}

}  // namespace poinsot::problem
