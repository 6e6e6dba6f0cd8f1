// Explains masses, motion and momenta at an instant.
#include "problem/explanation/explanation_instant.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problem/instant/instant_conditions.h"
#include "problem/language/scalar_value.h"

namespace poinsot::problem {
namespace {

// Relative difference allowed between a formula and its number. Numbers that rest on unknowns are found to 1e-9; a
// formula that is not that of the number is off in its first digits.
constexpr double formula_tolerance = 1e-8;
constexpr std::size_t longest_within_text = 130;  // characters of TeX

}  // namespace

InstantExplainer::InstantExplainer(const Situation& situation, SolvedInstant& solved, SolvedInstant* before,
                                   FormulaInstant* formulas, const LetterValues& letters, std::vector<Formula> factors,
                                   const ExplanationTex& tex, const InstantQuestions& questions,
                                   const Settings& settings, Explanation& explanation)
    : situation_(situation),
      solved_(solved),
      formula_instant_(formulas),
      letters_(letters),
      tex_(tex),
      questions_(questions),
      explanation_(explanation),
      figures_{figures_of(solved, before), {}},
      data_(situation, settings),
      factors_(std::move(factors)) {
  if (formulas) figures_.formulas.emplace(figures_of(*formulas, figures_.numbers.forces));
  part_of_length_ = part_of_length();
}

Shown InstantExplainer::confirmed(double number, const std::optional<Formula>& formula) const {
  if (!formula) return {number, std::nullopt};
  try {
    if (has_value(*formula, letters_, number, formula_tolerance)) return {formula->is_zero() ? 0 : number, formula};
  } catch (const std::exception&) {
    // If the formula cannot be evaluated, only the number is shown.
  }
  return {number, std::nullopt};
}

ShownVector InstantExplainer::confirmed(const Vector3<double>& number,
                                        const std::optional<Vector3<Formula>>& formula) const {
  if (!formula) return {number, std::nullopt};
  // A component that is nothing in letters has in numbers what products of the others leave: some 1e-16 of them each.
  constexpr double left_by_products = 1e-13;
  for (std::size_t k = 0; k < 3; ++k) {
    if ((*formula)[k].is_zero() && std::abs(number[k]) <= left_by_products * norm(number)) continue;
    if (!confirmed(number[k], (*formula)[k]).formula) return {number, std::nullopt};
  }
  Vector3<double> clean = number;
  for (std::size_t k = 0; k < 3; ++k)
    if ((*formula)[k].is_zero()) clean[k] = 0;
  return {clean, formula};
}

// Numbers far below this are rounding. If there are unknowns it is larger, as they are found with less accuracy.
double InstantExplainer::noise_size(const Dimension& dimension) const {
  return natural_size(dimension) * (situation_.find.empty() ? 1 : 1e3);
}

// Sets the value to zero if it is rounding.
Shown InstantExplainer::clean(Shown value, const Dimension& dimension) const {
  if (is_rounding(value.number, noise_size(dimension))) value.number = 0;
  return value;
}
ShownVector InstantExplainer::clean(ShownVector value, const Dimension& dimension) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (is_rounding(value.number[k], noise_size(dimension))) value.number[k] = 0;
  return value;
}

ExplainedSection& InstantExplainer::section(const std::string& heading) {
  const std::string full = heading + suffix_;
  for (ExplainedSection& known : explanation_.sections)
    if (known.heading == full) return known;
  return explanation_.sections.emplace_back(
      ExplainedSection{full, {}, heading == "Inertia", heading == "Kinetic side" || heading == "Free-body side"});
}

std::string InstantExplainer::body_name(int body) const { return mechanism().tree.name(body); }

std::vector<int> InstantExplainer::bodies_with_mass() const {
  std::vector<int> bodies;
  for (const auto& [index, mass] : figures_.numbers.machine->masses)
    if (mechanism().tree.body(index).inertia.mass > 0) bodies.push_back(index);
  return bodies;
}

std::string InstantExplainer::center_label(int body) const {
  return several_bodies() ? "G_{" + ExplanationTex::upright(body_name(body)) + "}" : "G";
}

std::optional<std::string> InstantExplainer::named_point(const Vector3<double>& position) const {
  for (const NamedExpression& point : situation_.points) {
    try {
      DataScope<double> data(situation_, data_.settings());
      const Vector3<double> place = data.place(point.value);
      if (norm(place - position) <= 1e-9 * (solved_.scales().length + norm(position))) return point.name;
    } catch (const StatementError&) {
      // A point without a place cannot be the point sought.
    }
  }
  return std::nullopt;
}

ExplainedPoint InstantExplainer::mass_center(int body) {
  return {center_label(body), shown_vector([&](const auto& figures) { return mass_of(figures.now, body).center; })};
}

ExplainedPoint InstantExplainer::point_of(const Expression& expression) {
  if (const Call* call = expression.as<Call>(); call && call->function == "center")
    for (const auto& [name, index] : figures_.numbers.machine->index)
      if (index != ground && to_string(call->arguments.front().value) == name) return mass_center(index);
  const Vector3<double> number = solved_.raw(expression, std::nullopt, nullptr).vector;
  std::optional<Vector3<Formula>> formula;
  if (formula_instant_) {
    try {
      formula = formula_instant_->raw(expression, std::nullopt, nullptr).vector;
    } catch (const std::exception&) {
      // Without formula the number is shown alone.
    }
  }
  const Name* name = expression.as<Name>();
  std::string label = name ? ExplanationTex::symbol(name->name) : free_point_name();
  if (!name)
    if (const auto known = named_point(number)) label = ExplanationTex::symbol(*known);
  return {label, confirmed(number, formula)};
}

bool InstantExplainer::rests(int body, const Vector3<double>& point) const {
  const auto& motion = figures_.numbers.now.workspace().motion[static_cast<std::size_t>(body + 1)];
  const Vector3<double> v = motion.v + cross(motion.w, point - motion.p);
  if (!is_rounding(norm(v), norm(motion.w) * solved_.scales().length)) return false;
  if (!figures_.numbers.before) return true;
  const auto& earlier = figures_.numbers.before->workspace().motion[static_cast<std::size_t>(body + 1)];
  return is_rounding(norm(Vector3<double>(earlier.v + cross(earlier.w, point - earlier.p))),
                     (norm(earlier.w) + norm(motion.w)) * solved_.scales().length);
}

namespace {

// Whether moments or products of inertia are stated as `any`.
bool leaves_inertia_open(const Situation& situation, const std::string& body) {
  const auto stated = std::ranges::find(situation.bodies, body, &Body::name);
  if (stated == situation.bodies.end() || !stated->inertia) return false;
  const StatedInertia& inertia = *stated->inertia;
  const auto open = [](const std::optional<Expression>& one) { return one && is_any(*one); };
  return inertia.rest_any || std::ranges::any_of(inertia.moments, open) ||
         std::ranges::any_of(inertia.products, open) || open(inertia.axial) || open(inertia.transverse);
}

}  // namespace

// Shows moments and products of inertia about the mass center or a fixed point, once for each.
void InstantExplainer::inertia_step(ExplainedSection& section, int body, const ExplainedPoint* fixed, Plane plane) {
  // In the plane the moment about one axis is told, else all of them.
  constexpr int about_fixed = 10000, in_plane = 100000;
  const int key = fixed ? body + about_fixed : body;
  if (inertia_said_.contains(key) || !inertia_said_.insert(plane ? key + in_plane : key).second) return;
  if (fixed) pivots_.insert_or_assign(body, *fixed);
  const auto tensor = [&, fixed](const auto& figures) {
    const auto mass = mass_of(figures.now, body);
    return fixed ? inertia_about(mass, position_of<ScalarOf<decltype(figures)>>(*fixed)) : mass.inertia_center;
  };
  ExplainedStep step;
  const ExplainedPoint G = mass_center(body);
  const Shown mass = shown([&](const auto& figures) { return figures.mechanism().tree.body(body).inertia.mass; });
  step.text = "*" + body_name(body) + "*: ";
  bool says_mass = false;
  if (mass_said_.insert(body).second) {
    if (tex_.can_show(mass)) step.text += "mass " + tex_.inline_both(mass, dimensions::mass);
    if (!is_rounding(norm(G.position.number), solved_.scales().length) && tex_.can_show(G.position)) {
      const ExplainedEquation place = tex_.equation("\\mathbf{r}_{" + G.label + "}", G.position, dimensions::length);
      step.text += tex_.can_show(mass) ? ", mass center at" : "mass center at";
      // What is long takes a line of its own.
      if (place.tex.size() > longest_within_text) {
        section.steps.push_back({std::exchange(step.text, ""), {place}});
      } else {
        step.text += " $" + place.tex + "$";
      }
    }
    if (tex_.can_show(mass) && !step.text.empty()) step.text += ".";
    says_mass = tex_.can_show(mass);
  }
  const bool open = leaves_inertia_open(situation_, body_name(body));
  if (solved_.uses_any() && !any_said_ && (tex_.is_known(mass) || open)) {
    any_said_ = true;
    section.steps.push_back({"What is given as `any` changes no answer; the lines below take one value for it.", {}});
  }
  const SymmetricMatrix3<double> numbers = tensor(figures_.numbers);
  if (size_of(numbers) == 0) {
    // A particle has nothing but its mass.
    if (says_mass && !step.text.empty()) section.steps.push_back(std::move(step));
    return;
  }
  if (!step.text.empty() && says_mass) step.text += " ";
  if (open) {
    // The numbers taken for what is open are none of its.
    step.text += "Of its moments and products of inertia only those that are stated are known.";
    section.steps.push_back(std::move(step));
    return;
  }
  const std::string axes = "$" + tex_.axis(0) + ", " + tex_.axis(1) + ", " + tex_.axis(2) + "$";
  const std::string about = "$" + (fixed ? fixed->label : G.label) + "$";
  // Where the mass center is on the axis nothing is moved.
  Vector3<double> moved = fixed ? Vector3<double>(G.position.number - fixed->position.number) : Vector3<double>::zero();
  if (plane) moved[*plane] = 0;
  const std::string parallel = is_rounding(norm(moved), solved_.scales().length) ? "" : ", parallel axes";
  if (plane)
    step.text +=
        "Moment of inertia about the " + tex_.axis(*plane) + " axis through " + about + " (Eq. 18.5" + parallel + "):";
  else
    step.text += "Moments and products of inertia about " + about + " on axes parallel to " + axes +
                 " (Eqs. 18.5, 18.6" + parallel + "):";
  bool any_product = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_rounding(moment_on(numbers, k), size_of(numbers)) || (plane && k != *plane)) continue;
    const Shown value = shown([&](const auto& figures) { return moment_on(tensor(figures), k); });
    if (tex_.can_show(value))
      step.equations.push_back(tex_.equation("I_{" + tex_.axis(k) + "}", value, dimensions::moment_of_inertia));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_rounding(product_on(numbers, k), size_of(numbers)) || plane) continue;
    any_product = true;
    const Shown value = shown([&](const auto& figures) { return product_on(tensor(figures), k); });
    const std::string index = tex_.axis(k) + tex_.axis((k + 1) % 3);
    if (tex_.can_show(value))
      step.equations.push_back(tex_.equation("I_{" + index + "}", value, dimensions::moment_of_inertia));
  }
  if (step.equations.empty()) step.text.back() = '.';
  parts_step(section, body, fixed ? *fixed : G);
  section.steps.push_back(std::move(step));
  if (!any_product && !plane)
    section.steps.push_back({"The products of inertia vanish: these axes are principal axes.", {}});
}

void InstantExplainer::explain_masses() {
  if (questions_.masses.empty()) return;
  ExplainedSection& here = section("Inertia");
  for (const int body : questions_.masses)
    if (mechanism().tree.body(body).inertia.mass > 0) inertia_step(here, body, nullptr);
}

// Shows the present motion of a body, as far as it was not shown before.
void InstantExplainer::motion_step(std::vector<ExplainedStep>& steps, int body, const std::string& index,
                                   bool with_velocity, bool with_accelerations) {
  const auto at = static_cast<std::size_t>(body + 1);
  const bool massive = mechanism().tree.body(body).inertia.mass > 0;
  ExplainedStep step{"The motion of *" + body_name(body) + "*" + (sudden() ? " just after the blow" : "") + ":", {}};
  const auto add = [&](const std::string& symbol, const auto& get, const Dimension& dimension) {
    const ShownVector value = clean(shown_vector(get), dimension);
    const bool idle = with_accelerations && norm(value.number) == 0;
    if (tex_.can_show(value) && !idle && motion_said_.insert(body_name(body) + symbol).second)
      step.equations.push_back(tex_.equation(symbol, value, dimension));
  };
  // Of a particle nothing turns.
  const bool turns = !is_particle(body) && turns_as_told(body);
  if (turns)
    add(
        "\\boldsymbol{\\omega}" + index, [&](const auto& figures) { return figures.now.workspace().motion[at].w; },
        dimensions::angular_velocity);
  if (massive && with_velocity)
    add(
        "\\mathbf{v}_{" + center_label(body) + "}",
        [&](const auto& figures) {
          const auto& motion = figures.now.workspace().motion[at];
          return motion.v + cross(motion.w, mass_of(figures.now, body).center - motion.p);
        },
        dimensions::velocity);
  if (with_accelerations) {
    if (turns)
      add(
          "\\boldsymbol{\\alpha}" + index,
          [&](const auto& figures) { return figures.now.workspace().motion[at].alpha; },
          dimensions::angular_acceleration);
    if (massive)
      add(
          "\\mathbf{a}_{" + center_label(body) + "}",
          [&](const auto& figures) {
            const auto rate = momentum_rate_of(figures.now, {body}, mass_of(figures.now, body).center);
            return rate.linear / figures.mechanism().tree.body(body).inertia.mass;
          },
          dimensions::acceleration);
  }
  if (!step.equations.empty()) steps.push_back(std::move(step));
}

void InstantExplainer::explain_kinematics() {
  std::vector<ExplainedStep> steps;
  for (const int body : questions_.moving) {
    const bool several = several_bodies() || questions_.moving.size() > 1;
    motion_step(steps, body, several ? "_{" + ExplanationTex::upright(body_name(body)) + "}" : "",
                questions_.going.contains(body), questions_.accelerated.contains(body) && figures_.numbers.forces);
  }
  if (steps.empty()) return;
  ExplainedSection& here = section("Motion");
  for (ExplainedStep& step : steps) here.steps.push_back(std::move(step));
}

bool InstantExplainer::has_absorbed(int body) const {
  return sudden() && std::ranges::any_of(figures_.numbers.blow.impulses, [&](const auto& impulse) {
           return impulse.on == body && impulse.absorbed > 0;
         });
}

// What particles that have stuck in a body add to what was said of it alone.
ExplainedStep InstantExplainer::absorbed_step(const MomentumQuestion& question, int body,
                                              const std::optional<ExplainedPoint>& about, const std::string& index) {
  const ExplainedPoint G = mass_center(body);
  const bool central = about && norm(about->position.number - G.position.number) <= 1e-9 * solved_.scales().length;
  if (central || (question.angular && !about))
    return {
        "Particles that have stuck in it belong to it from the blow on: its mass center and what is about it are "
        "those of both together, which are not written down here.",
        {}};
  ExplainedStep step{"Particles that have stuck in it belong to it from the blow on. With what they add:", {}};
  if (question.energy) {
    const Shown all = shown([&](const auto& figures) {
      auto sum = body_kinetic_energy(figures.mechanism().tree, figures.now.workspace(), body);
      for (const auto& impulse : figures.blow.impulses) {
        if (impulse.on != body) continue;
        const auto velocity = figures.now.velocity(impulse.at);
        sum += impulse.absorbed * dot(velocity, velocity) / 2;
      }
      return sum;
    });
    if (tex_.can_show(all))
      step.equations.push_back(
          tex_.equation("T" + index + " + \\tfrac12\\textstyle\\sum m v^2", all, dimensions::energy));
  }
  const auto momentum = [&](const auto& figures) {
    using Scalar = ScalarOf<decltype(figures)>;
    const Vector3<Scalar> point = about ? position_of<Scalar>(*about) : Vector3<Scalar>::zero();
    return as_wrench(momentum_of(figures.now, {body}, point)) +
           absorbed_momentum(figures, figures.now, std::set<int>{body}, point);
  };
  const auto add = [&](const std::string& symbol, const ShownVector& vector, const Dimension& dimension) {
    if (tex_.can_show(vector)) step.equations.push_back(tex_.equation(symbol, vector, dimension));
  };
  if (question.linear)
    add("\\mathbf{L}" + index + " + \\textstyle\\sum m\\mathbf{v}",
        shown_vector([&](const auto& figures) { return momentum(figures).force; }), dimensions::momentum);
  if (question.angular)
    add("\\mathbf{H}_{" + about->label + "}" + index + " + \\textstyle\\sum \\mathbf{r}\\times m\\mathbf{v}",
        shown_vector([&](const auto& figures) { return momentum(figures).moment; }), dimensions::angular_momentum);
  return step;
}

void InstantExplainer::explain_momenta() {
  for (const MomentumQuestion& question : questions_.momenta) explain_momentum(question);
}

void InstantExplainer::explain_momentum(const MomentumQuestion& question) {
  std::vector<int> bodies;
  for (const int body : bodies_with_mass())
    if (question.body == whole_system || question.body == body) bodies.push_back(body);
  if (bodies.empty()) return;
  section("Inertia");
  std::optional<ExplainedPoint> about;
  if (question.about) about = point_of(*question.about);
  std::string point_label = about ? about->label : "";
  std::vector<ExplainedStep> steps;
  std::vector<std::string> terms;
  for (const int body : bodies) {
    const auto at = static_cast<std::size_t>(body + 1);
    const ExplainedPoint G = mass_center(body);
    const bool about_center =
        !about || norm(about->position.number - G.position.number) <= 1e-9 * solved_.scales().length;
    if (about && about_center && bodies.size() == 1) point_label = G.label;
    const bool fixed = about && !about_center && rests(body, about->position.number) && !sudden();
    const std::string index = bodies.size() > 1 ? "_{" + ExplanationTex::upright(body_name(body)) + "}" : "";
    const std::optional<ExplainedPoint> pivot =
        question.energy && !question.about && !question.angular ? told_pivot(body) : std::nullopt;
    const bool told_how = place_changes_as_told(body);
    const Plane plane = situation_.plane   ? Plane(situation_.plane->normal())
                        : question.angular ? Plane()
                                           : turning_axis(body);
    if (question.angular || (question.energy && !pivot))
      inertia_step(section("Inertia"), body, fixed ? &*about : nullptr, plane);
    const ShownVector w = shown_vector([&](const auto& figures) { return figures.now.workspace().motion[at].w; });
    const auto velocity = [&](const auto& figures) {
      const auto& motion = figures.now.workspace().motion[at];
      return motion.v + cross(motion.w, mass_of(figures.now, body).center - motion.p);
    };
    const bool with_velocity =
        (!fixed || question.linear) && !(about_center && question.angular && !question.linear && !question.energy);
    motion_step(steps, body, index, with_velocity && told_how && !pivot, false);
    if (question.linear && told_how) {
      const ShownVector L =
          shown_vector([&](const auto& figures) { return momentum_of(figures.now, {body}, velocity(figures)).linear; });
      ExplainedStep step{"Its linear momentum is $\\mathbf{L} = m\\,\\mathbf{v}_{" + G.label + "}$:", {}};
      if (tex_.can_show(L)) step.equations.push_back(tex_.equation("\\mathbf{L}" + index, L, dimensions::momentum));
      steps.push_back(std::move(step));
    }
    if (question.angular) {
      const std::string own = fixed ? about->label : G.label;
      ExplainedStep step;
      step.text = fixed ? "The point $" + own + "$ of the body is at rest, so $\\mathbf{H}_{" + own + "} = I_{" + own +
                              "}\\,\\boldsymbol{\\omega}$ (Eqs. 18.12, 18.13):"
                        : "About the mass center" +
                              (about && about->label != G.label && about_center ? ", which is at $" + about->label + "$"
                                                                                : std::string()) +
                              ", by Eq. 18.7:";
      const auto tensor = [&](const auto& figures) {
        const auto mass = mass_of(figures.now, body);
        return fixed ? inertia_about(mass, position_of<ScalarOf<decltype(figures)>>(*about)) : mass.inertia_center;
      };
      const SymmetricMatrix3<double> I = tensor(figures_.numbers);
      const Vector3<double> H = I * w.number;
      for (std::size_t i = 0; i < 3; ++i) {
        std::string sum;
        for (std::size_t j = 0; j < 3; ++j) {
          if (is_rounding(w.number[j], norm(w.number))) continue;
          if (i == j && !is_rounding(moment_on(I, i), size_of(I)))
            sum += (sum.empty() ? "" : " + ") + ("I_{" + tex_.axis(i) + "}\\omega_{" + tex_.axis(i) + "}");
          if (i != j && !is_rounding(product_on(I, pair_of(i, j)), size_of(I))) {
            const std::size_t k = pair_of(i, j);
            sum += (sum.empty() ? "-" : " - ") +
                   ("I_{" + tex_.axis(k) + tex_.axis((k + 1) % 3) + "}\\omega_{" + tex_.axis(j) + "}");
          }
        }
        if (sum.empty() || is_rounding(H[i], norm(H))) continue;
        const Shown value =
            shown([&](const auto& figures) { return (tensor(figures) * figures.now.workspace().motion[at].w)[i]; });
        if (!tex_.can_show(value)) continue;
        step.equations.push_back(
            tex_.equation("H_{" + tex_.axis(i) + "} = " + sum, value, dimensions::angular_momentum));
      }
      if (step.equations.empty()) step.text += " $\\mathbf{H} = \\mathbf{0}$.";
      steps.push_back(std::move(step));
      if (about && !fixed && !about_center) {
        const ShownVector shifted = shown_vector([&](const auto& figures) {
          return momentum_of(figures.now, {body}, position_of<ScalarOf<decltype(figures)>>(*about)).angular;
        });
        ExplainedStep moved{"About $" + about->label + "$, $\\mathbf{H}_{" + about->label + "} = \\mathbf{r}_{" +
                                G.label + "/" + about->label + "} \\times m\\mathbf{v}_{" + G.label +
                                "} + \\mathbf{H}_{" + G.label + "}$ (Eq. 18.11):",
                            {}};
        if (tex_.can_show(shifted))
          moved.equations.push_back(
              tex_.equation("\\mathbf{H}_{" + about->label + "}" + index, shifted, dimensions::angular_momentum));
        steps.push_back(std::move(moved));
      }
    }
    const bool central = about.has_value() && about_center;
    if (question.energy && (central || told_how))
      steps.push_back(energy_step(body, index, central, pivot ? &*pivot : nullptr));
    if (has_absorbed(body)) steps.push_back(absorbed_step(question, body, about, index));
  }
  ExplainedSection& here = section(question.energy && !question.angular ? "Kinetic energy" : "Momentum");
  for (ExplainedStep& step : steps) here.steps.push_back(std::move(step));
  if (bodies.size() > 1 && question.angular && about) {
    const std::set<int> all(bodies.begin(), bodies.end());
    const ShownVector sum = shown_vector([&](const auto& figures) {
      return momentum_of(figures.now, all, position_of<ScalarOf<decltype(figures)>>(*about)).angular;
    });
    ExplainedStep step{"Of all bodies together:", {}};
    if (tex_.can_show(sum))
      step.equations.push_back(tex_.equation("\\mathbf{H}_{" + about->label + "}", sum, dimensions::angular_momentum));
    here.steps.push_back(std::move(step));
  }
}

void InstantExplainer::explain(const std::string& suffix, bool followed) {
  followed_ = followed;
  suffix_ = suffix;
  if (needs_balance() || (!followed && states_momenta())) {
    std::vector<std::string> sought;
    for (const FoundDatum& datum : found_data()) sought.push_back(datum.name);
    tex_.hide_until_found(std::move(sought));
  }
  if (needs_balance())
    explain_balance();
  else
    velocity_conditions();
  explain_masses();
  explain_momenta();
  if (!needs_balance() && !followed && states_momenta()) explain_found();
  explain_kinematics();
  explain_points();
  explain_free_motion();
  std::erase_if(explanation_.sections, [](const ExplainedSection& one) { return one.steps.empty(); });
}

}  // namespace poinsot::problem
