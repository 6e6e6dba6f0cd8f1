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
      if (!told.bodies.empty()) {
        // What is said of several bodies stands behind the velocities of the last of them.
        kinetic.steps.erase(kinetic.steps.begin() + static_cast<std::ptrdiff_t>(told.step));
        for (auto& [words, other] : open_rates_)
          if (words.starts_with(heading) && other.step > told.step) --other.step;
      }
      told.step = kinetic.steps.size();
      kinetic.steps.emplace_back();
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

// Whether what is stated determines how the mass center moves: that of a free body may be left open.
bool InstantExplainer::place_changes_as_told(int body) const {
  const solve::LinearSolution& velocities = sudden() ? solved_.blow() : solved_.velocities();
  const auto& link = mechanism().tree.body(body);
  if (link.joint != JointType::free || velocities.value.empty()) return true;
  for (std::size_t k = 3; k < 6; ++k)
    if (!velocities.determined(static_cast<std::size_t>(link.v) + k)) return false;
  return true;
}

// Whether anything stated tells how a body turns. Of a rod the turning about itself is left open, and does not matter.
bool InstantExplainer::turns_as_told(int body) const {
  const solve::LinearSolution& velocities = sudden() ? solved_.blow() : solved_.velocities();
  const auto& link = mechanism().tree.body(body);
  if (link.joint != JointType::free || velocities.value.empty()) return true;
  for (std::size_t k = 0; k < 3; ++k)
    if (velocities.determined(static_cast<std::size_t>(link.v) + k)) return true;
  return false;
}

// The only axis of the ground about which a body turns.
std::optional<std::size_t> InstantExplainer::turning_axis(int body) const {
  const Vector3<double>& w = figures_.numbers.now.workspace().motion[static_cast<std::size_t>(body + 1)].w;
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_rounding(w[k], norm(w))) continue;
    if (axis) return std::nullopt;
    axis = k;
  }
  return axis;
}

// A fixed point of a body that turns, about which its moments of inertia are told already.
std::optional<ExplainedPoint> InstantExplainer::told_pivot(int body) const {
  const auto known = pivots_.find(body);
  const Vector3<double>& w = figures_.numbers.now.workspace().motion[static_cast<std::size_t>(body + 1)].w;
  if (known == pivots_.end() || vanishes(w, dimensions::angular_velocity) || has_absorbed(body) ||
      !rests(body, known->second.position.number))
    return std::nullopt;
  return known->second;
}

// The kinetic energy by those of its terms that there are. central: that of turning about the mass center alone.
ExplainedStep InstantExplainer::energy_step(int body, const std::string& index, bool central,
                                            const ExplainedPoint* pivot) {
  const auto at = static_cast<std::size_t>(body + 1);
  const std::string center = center_label(body), about = pivot ? pivot->label : center;
  const Shown energy = shown([&](const auto& figures) {
    const auto& omega = figures.now.workspace().motion[at].w;
    using Scalar = ScalarOf<decltype(figures)>;
    return central ? Scalar(dot(omega, mass_of(figures.now, body).inertia_center * omega) / 2)
                   : body_kinetic_energy(figures.mechanism().tree, figures.now.workspace(), body);
  });
  const auto& motion = figures_.numbers.now.workspace().motion[at];
  const Vector3<double> v = motion.v + cross(motion.w, mass_of(figures_.numbers.now, body).center - motion.p);
  const bool turns = !is_particle(body) && !vanishes(motion.w, dimensions::angular_velocity),
             moves = !vanishes(v, dimensions::velocity);
  const std::optional<std::size_t> axis = turning_axis(body);
  const std::string moving = "\\tfrac12 m v_{" + center + "}^2",
                    turning = axis
                                  ? "\\tfrac12 I_{" + tex_.axis(*axis) + "}\\,\\omega^2"
                                  : "\\tfrac12\\,\\boldsymbol{\\omega}\\cdot I_{" + about + "}\\,\\boldsymbol{\\omega}";
  ExplainedStep step;
  if (central)
    step.text = "Relative to the mass center $T' = " + turning + "$ (Eq. 18.17):";
  else if (pivot)
    step.text = "The point $" + about + "$ of *" + body_name(body) +
                "* is at rest: its kinetic energy is $T = " + turning + "$ (Eqs. 18.18 to 18.20):";
  else if (!turns)
    step.text =
        "Its kinetic energy is $T = " + moving + "$" + (is_particle(body) ? ":" : ", as it does not turn (Eq. 18.17):");
  else
    step.text = "Its kinetic energy is $T = " + (moves ? moving + " + " : std::string()) + turning + "$" +
                (moves ? "" : ", as its mass center is at rest") + " (Eq. 18.17):";
  if (tex_.can_show(energy))
    step.equations.push_back(tex_.equation((central ? "T'" : "T") + index, energy, dimensions::energy, true));
  return step;
}

// Points that are asked for, by the motion of the mass center and the turning about it.
void InstantExplainer::explain_points() {
  std::vector<ExplainedStep> steps;
  for (const PointQuestion& question : questions_.points) {
    const bool place = question.kind == PointQuestion::Kind::place;
    const Of* of = question.call.arguments.front().value.as<Of>();
    const Name* point = of ? of->point.as<Name>() : nullptr;
    // Of a point without a name, and of a body that has no mass center, the answer says all.
    if ((of && !point) || (!of && mass_said_.contains(question.body)) ||
        !(mechanism().tree.body(question.body).inertia.mass > 0) ||
        (question.kind == PointQuestion::Kind::acceleration && !figures_.numbers.forces) ||
        (!place && !place_changes_as_told(question.body)))
      continue;
    const Expression asked = built(question.call, question.call.arguments.front().value.mark());
    Value<double> number;
    try {
      number = solved_.raw(asked, std::nullopt, nullptr);
    } catch (const StatementError&) {
      continue;  // what is not determined has its reason beside the answer
    }
    if (!number.is_vector()) continue;
    const ShownVector vector = clean(confirmed(number.vector, asked_formula(asked)), number.dimension);
    const std::string label = point ? ExplanationTex::symbol(point->name) : center_label(question.body);
    if (!tex_.can_show(vector)) continue;
    if (place)
      steps.push_back({"The motion has led " + (point ? "$" + label + "$ of *" : std::string("*")) +
                           body_name(question.body) + "* to",
                       {tex_.equation("\\mathbf{r}_{" + label + "}", vector, dimensions::length)}});
    else if (label != center_label(question.body))
      steps.push_back(motion_of_point(question, label, vector));
  }
  if (steps.empty()) return;
  ExplainedSection& here = section("Motion");
  for (ExplainedStep& step : steps) here.steps.push_back(std::move(step));
}

std::optional<Vector3<Formula>> InstantExplainer::asked_formula(const Expression& asked) {
  if (!formula_instant_) return std::nullopt;
  try {
    const Value<Formula> value = formula_instant_->raw(asked, std::nullopt, nullptr);
    return value.is_vector() ? std::optional(value.vector) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;  // the number is shown alone
  }
}

ExplainedStep InstantExplainer::motion_of_point(const PointQuestion& question, const std::string& label,
                                                const ShownVector& vector) {
  const int body = question.body;
  const auto at = static_cast<std::size_t>(body + 1);
  const std::string center = center_label(body), index = several_bodies() || questions_.moving.size() > 1
                                                             ? "_{" + ExplanationTex::upright(body_name(body)) + "}"
                                                             : std::string();
  ExplainedStep step{"The point $" + label + "$ of *" + body_name(body) + "*:", {}};
  const auto& motion = figures_.numbers.now.workspace().motion[at];
  const Expression place =
      built(Call{"position", {question.call.arguments.front()}}, question.call.arguments.front().value.mark());
  const Vector3<double> here = solved_.raw(place, std::nullopt, nullptr).vector;
  const std::optional<Vector3<Formula>> formula = asked_formula(place);
  const ExplainedPoint G = mass_center(body);
  std::optional<Vector3<Formula>> arm_formula;
  if (formula && G.position.formula) arm_formula = *formula - *G.position.formula;
  const ShownVector arm = clean(confirmed(Vector3<double>(here - G.position.number), arm_formula), dimensions::length);
  const std::string r = "\\mathbf{r}_{" + label + "/" + center + "}", omega = "\\boldsymbol{\\omega}" + index;
  const bool velocity = question.kind == PointQuestion::Kind::velocity;
  const std::string letter = velocity ? "\\mathbf{v}" : "\\mathbf{a}";
  const bool turns = !vanishes(motion.w, dimensions::angular_velocity);
  std::string sum = letter + "_{" + center + "}";
  if (!velocity && !vanishes(motion.alpha, dimensions::angular_acceleration))
    sum += " + \\boldsymbol{\\alpha}" + index + "\\times" + r;
  if (turns)
    sum += velocity ? " + " + omega + "\\times" + r
                    : " + " + omega + "\\times\\left(" + omega + "\\times" + r + "\\right)";
  if (sum.find(r) != std::string::npos && tex_.can_show(arm))
    step.equations.push_back(tex_.equation(r, arm, dimensions::length));
  step.equations.push_back(tex_.equation(letter + "_{" + label + "} = " + sum, vector,
                                         velocity ? dimensions::velocity : dimensions::acceleration));
  return step;
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
