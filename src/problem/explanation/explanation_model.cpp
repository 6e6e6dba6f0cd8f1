#include "problem/explanation/explanation_model.h"

#include <algorithm>

#include "problem/keys/joint_kinds.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem {
namespace {

std::string shape_words(const Shape& shape) { return std::string(shape_row<double>(shape.kind).words); }

// An expression, followed by its value if this says more.
class Data {
 public:
  Data(const Situation& situation, const Settings& settings, const std::set<std::string>& hidden,
       const ExplanationTex& tex)
      : situation_(situation), settings_(settings), hidden_(hidden), tex_(tex) {}

  std::string number(const Expression& expression, const Dimension& dimension) const {
    if (const Name* name = expression.as<Name>(); name && name->name == "any") return "any value";
    if (expression.as<Number>() || depends_on_time(situation_, expression)) return code(expression);
    std::set<std::string> names;
    collect_names(expression, names);
    if (std::ranges::any_of(names, [&](const std::string& name) { return hidden_.contains(name); }))
      return code(expression);
    try {
      if (tex_.letters_open() && !letters_of(situation_, expression).empty()) return code(expression);
      DataScope<double> data(situation_, settings_);
      const double value = data.number(expression, dimension);
      if (const Name* name = expression.as<Name>()) said_.insert(name->name);
      return code(expression) + " $= " + tex_.with_unit(value, dimension) + "$";
    } catch (const StatementError&) {
      return code(expression);
    }
  }
  std::string amount(const Amount& amount) const {
    if (const Name* name = amount.mass ? amount.mass->as<Name>() : nullptr; name && name->name == "any")
      return "any mass";
    if (const Number* zero = amount.mass ? amount.mass->as<Number>() : nullptr; zero && zero->value == 0)
      return "no mass";
    if (amount.mass) return "mass " + number(*amount.mass, dimensions::mass);
    if (amount.weight) return "weight " + number(*amount.weight, dimensions::force);
    if (amount.density) return "density " + code(*amount.density);
    if (amount.specific_weight) return "specific weight " + code(*amount.specific_weight);
    return "";
  }
  // The data of which no value was told, as equations.
  std::vector<std::string> others() const {
    std::vector<std::string> equations;
    DataScope<double> data(situation_, settings_);
    for (const NamedExpression& item : situation_.given) {
      std::set<std::string> names{item.name};
      collect_names(item.value, names);
      const bool open = std::ranges::any_of(names, [&](const std::string& name) { return hidden_.contains(name); }) ||
                        (tex_.letters_open() && !letters_of(situation_, item.value).empty());
      if (said_.contains(item.name) || open || depends_on_time(situation_, item.value)) continue;
      try {
        const Value<double> value = data.value(built(Name{item.name}, Mark{}));
        if (value.is_number())
          equations.push_back("$" + ExplanationTex::symbol(item.name) + " = " +
                              tex_.with_unit(value.number, value.dimension) + "$");
        else if (value.kind == Value<double>::Kind::vector)
          equations.push_back(tex_.inline_equation(ExplanationTex::vector_symbol(item.name),
                                                   {value.vector, Vector3<Formula>::zero()}, value.dimension));
      } catch (const StatementError&) {
        // What has no value of its own is no datum for a reader.
      }
    }
    return equations;
  }

 private:
  const Situation& situation_;
  const Settings& settings_;
  const std::set<std::string>& hidden_;
  const ExplanationTex& tex_;
  mutable std::set<std::string> said_{};  // data whose values were told
};

std::string body_line(const Body& body, const Data& data) {
  std::string line = "*" + body.name + "*";
  if (body.massless) return line + " has no mass";
  const std::string amount = data.amount(body.amount);
  const auto part_words = [&](const Part& part) {
    const std::string own = data.amount(part.amount);
    return std::string(part.hole ? "less a hole, " : "") + "a " + shape_words(part.shape) +
           (part.name.empty() || part.name == body.name ? "" : " *" + part.name + "*") +
           (own.empty() ? "" : " of " + own);
  };
  if (body.parts.size() == 1) {
    line += " is a " + shape_words(body.parts.front().shape);
    const std::string own = amount.empty() ? data.amount(body.parts.front().amount) : amount;
    if (!own.empty()) line += " of " + own;
  } else if (body.parts.size() > 1) {
    std::vector<std::string> parts;
    for (const Part& part : body.parts) parts.push_back(part_words(part));
    line += " consists of " + listed(parts) + (amount.empty() ? "" : "; in all " + amount);
  } else {
    line += " is given by " + std::string(body.inertia ? "its mass, mass center and moments of inertia" : "numbers") +
            (amount.empty() ? "" : ", " + amount);
  }
  if (!body.added.empty()) {
    std::vector<std::string> parts;
    for (const Part& part : body.added) parts.push_back(part_words(part));
    line += "; added to it: " + listed(parts);
  }
  return line;
}

std::string joint_line(const Joint& joint, const Data& data) {
  const std::string on = joint.from == "ground" ? "the ground" : "*" + joint.from + "*";
  const std::string through = joint.at ? " through " + code(*joint.at) : "";
  std::string line =
      "*" + joint.name + "* " + joint.kind->words({"*" + joint.to + "*", on, code(joint.place), through});
  for (const Freedom& freedom : joint.freedoms) {
    const std::string of = freedom.name.empty() ? "" : " (" + freedom.name + ")";
    if (freedom.position)
      line +=
          "; its " + std::string(freedom.turning ? "angle" : "displacement") + of + " is " + code(*freedom.position);
    if (freedom.rate)
      line += "; rate" + of + " " +
              data.number(*freedom.rate, freedom.turning ? dimensions::angular_velocity : dimensions::velocity);
    if (freedom.accel) {
      const Number* zero = freedom.accel->as<Number>();
      line += zero && zero->value == 0
                  ? ", constant"
                  : "; acceleration" + of + " " +
                        data.number(*freedom.accel,
                                    freedom.turning ? dimensions::angular_acceleration : dimensions::acceleration);
    }
    if (freedom.effort)
      line += "; driven" + of + " by " +
              data.number(*freedom.effort, freedom.turning ? dimensions::moment : dimensions::force);
    if (freedom.stiffness) line += "; spring constant" + of + " " + code(*freedom.stiffness);
    if (freedom.damping) line += "; damping" + of + " " + code(*freedom.damping);
  }
  std::vector<std::string> supports;
  for (const Support& support : joint.supports) {
    std::vector<std::string> carried;
    std::vector<std::string> couples;
    for (const Expression& force : support.forces) carried.push_back(code(force));
    for (const Expression& couple : support.couples) couples.push_back(code(couple));
    std::string what = support.kind ? support.kind->name : "";
    if (!carried.empty()) what += (what.empty() ? "" : ", ") + std::string("forces along ") + listed(carried);
    if (!couples.empty()) what += (what.empty() ? "" : ", ") + std::string("couples about ") + listed(couples);
    supports.push_back("*" + support.name + "* (" + (what.empty() ? "no forces" : what) + ")");
  }
  if (!supports.empty()) line += "; supports " + listed(supports);
  return line;
}

// What is said of the slipping of a contact.
std::string slipping_words(const Contact& contact, const Data& data) {
  if (!contact.no_slip_along.empty()) {
    std::vector<std::string> edges;
    for (const Expression& edge : contact.no_slip_along) edges.push_back(code(edge));
    return ", without slipping along " + listed(edges) + ", which turns with *" + contact.of + "*";
  }
  if (!contact.friction) return contact.no_slip ? ", without slipping" : ", without friction";
  const std::string resting = data.number(contact.friction->resting, dimensions::none),
                    sliding = data.number(contact.friction->sliding, dimensions::none);
  std::string words = ", with dry friction: the coefficient is " + resting;
  if (resting != sliding) words += " at rest and " + sliding + " while it slides";
  if (contact.flies) return words;
  switch (contact.grip) {
    case Grip::sticks:
      return words + "; it sticks";
    case Grip::slides:
      return words + "; it slides along " + code(*contact.slip) + ", and the friction is against that";
    case Grip::parts:
      return words + "; it parts, and nothing acts there";
    case Grip::unknown:
      break;
  }
  return words;
}

std::string friction_words(const Contact& contact) {
  const std::optional<Bearing>& bearing = contact.friction->bearing;
  std::string words = "the joint *" + contact.name + "* has dry friction" +
                      (bearing ? ": the coefficient is " : " of ") + code(contact.friction->resting);
  if (contact.friction->falls()) words += " at rest and " + code(contact.friction->sliding) + " while it moves";
  if (bearing) {
    const auto at = [&](const char* what, const std::optional<Expression>& size) {
      return size ? what + code(*size) : std::string();
    };
    words += at(", at the radius ", bearing->radius) + at(", of its collar at ", bearing->thrust_radius) +
             at(", between ends at a distance of ", bearing->length) +
             at(", with an angle between the flanks of ", bearing->thread_angle) +
             "; its friction is $\\mu$ times the forces that press in it, by their radius where it turns, found "
             "together with "
             "them";
  }
  if (contact.grip == Grip::sticks) words += "; it is held";
  if (contact.grip == Grip::slides) words += "; it moves, and the friction is against that";
  return words;
}

std::string slipping_cord_words(const Contact& contact, const Data& data) {
  std::string words = std::string(contact.of_belt ? "the belt *" : "the cord *") + contact.of +
                      "* has dry friction of " + data.number(contact.friction->resting, dimensions::none);
  if (contact.friction->falls())
    words += " at rest and " + data.number(contact.friction->sliding, dimensions::none) + " while it slips";
  words += " on *" + contact.against + "*";
  if (contact.grip == Grip::sticks) words += "; it does not slip";
  if (contact.grip == Grip::slides) words += "; it slips, and its tension changes by $e^{\\mu\\beta}$ round it";
  return words;
}

std::string teeth_words(const Gear& gear) {
  const auto stated = [&](const std::optional<Expression>& one, const std::string& name) {
    return one ? ", " + name + " " + code(*one) : "";
  };
  const std::string hand = gear.hand == Hand::right  ? ", right-handed on *" + gear.of + "*"
                           : gear.hand == Hand::left ? ", left-handed on *" + gear.of + "*"
                           : gear.hand == Hand::both ? ", in two rows of either hand"
                                                     : "";
  const std::string law = gear.has_pressure_angle()
                              ? "; they touch with flanks that lean by the pressure angle, so that they push the "
                                "wheels apart by its tangent times the force across the teeth, whichever way that acts"
                              : "";
  return "the teeth of *" + gear.of + "* and *" + gear.against + "* meet at " + code(gear.at) +
         stated(gear.pressure_angle, "pressure angle") + stated(gear.normal_pressure_angle, "normal pressure angle") +
         stated(gear.helix_angle, "helix angle") + stated(gear.lead, "lead") + hand +
         stated(gear.friction, "friction") + law;
}

std::string shaking_words(const Excitation& excitation, const Data& data) {
  const std::string at = excitation.at ? " at " + code(*excitation.at) : "";
  const std::string frequency =
      excitation.frequency ? ", with the frequency " + data.number(*excitation.frequency, dimensions::angular_velocity)
                           : "";
  if (!excitation.coordinate.empty())
    return code(excitation.coordinate) + " is shaken by " + code(*excitation.by) + " to and fro, *" + excitation.name +
           "*" + frequency;
  if (excitation.unbalance)
    return "*" + excitation.body + "* has the unbalance *" + excitation.name + "*, " + code(*excitation.unbalance) +
           (excitation.direction ? " along " + code(*excitation.direction) : "") + at;
  const Expression& size = excitation.couple ? *excitation.couple : *excitation.force;
  return std::string(excitation.couple ? "the couple *" : "the force *") + excitation.name + "* shakes *" +
         excitation.body + "*" + at + ": " + code(size) +
         (excitation.direction ? (excitation.couple ? " about " : " along ") + code(*excitation.direction) : "") +
         (excitation.turns ? ", which turns about " + code(*excitation.turns) : "") + frequency;
}

void add_actions(const Situation& situation, const Data& data, std::vector<std::string>& lines) {
  for (const Contact& contact : situation.contacts)
    lines.push_back(
        contact.on_cord ? slipping_cord_words(contact, data)
        : contact.in_joint
            ? friction_words(contact)
            : "*" + contact.of + (contact.open ? "* may later touch *" : "* touches *") + contact.against +
                  (contact.corner ? "* with its corner " : "* at ") + code(contact.at) + ", normal " +
                  code(contact.normal) + (contact.surface ? ", the surface through " + code(*contact.surface) : "") +
                  (contact.inside.empty() ? "" : ", inside *" + contact.inside + "*") + slipping_words(contact, data) +
                  (contact.restitution ? ", restitution " + data.number(*contact.restitution, dimensions::none) : ""));
  for (const Cord& cord : situation.cords) {
    std::string over;
    for (const CordWheel& wheel : cord.over) {
      over += (over.empty() ? ", led over *" : ", *") + wheel.name + "*";
      if (wheel.radius) over += " of radius " + code(*wheel.radius);
      if (wheel.turns) over += ", round which it goes " + data.number(*wheel.turns, dimensions::none) + " times";
    }
    lines.push_back("the cord *" + cord.name + "* " + (cord.on_to ? "winds on *" : "holds *") + cord.to + "*" +
                    (cord.end ? " at " + code(*cord.end) : "") +
                    (cord.direction ? " along " + code(*cord.direction) : "") + over +
                    (cord.length ? ", " + data.number(*cord.length, dimensions::length) + " long" : ""));
  }
  for (const Belt& belt : situation.belts) {
    std::string over;
    for (const CordWheel& wheel : belt.over) over += (over.empty() ? "*" : ", *") + wheel.name + "*";
    lines.push_back(
        std::string(belt.chain ? "the chain *" : "the belt *") + belt.name + "* goes round " + over +
        (belt.crossed ? ", crossed" : "") +
        (belt.tension ? ", with the initial tension " + data.number(*belt.tension, dimensions::force) : ""));
  }
  for (const Gear& gear : situation.gears) lines.push_back(teeth_words(gear));
  const WrittenExpression written = [](const Expression& expression) { return code(expression); };
  for_each_stated_law(situation, [&](const auto& law) { lines.push_back(law.words(written)); });
  for (const Impulse& impulse : situation.impulses) {
    const Expression& size = impulse.value ? *impulse.value : impulse.force ? *impulse.force : *impulse.couple;
    lines.push_back("*" + impulse.body + "* gets the impulse *" + impulse.name + "*, " + code(size) +
                    (impulse.direction ? " along " + code(*impulse.direction) : "") +
                    (impulse.lasts ? " for " + code(*impulse.lasts) : "") +
                    (impulse.at ? ", at " + code(*impulse.at) : ""));
  }
  for (const Impact& impact : situation.impacts)
    lines.push_back("*" + impact.of + "* strikes *" + impact.against + "* at " + code(impact.at) + ", pushed along " +
                    code(impact.pushes) +
                    (impact.restitution ? ", restitution " + data.number(*impact.restitution, dimensions::none) : "") +
                    (impact.friction ? ", friction " + data.number(*impact.friction, dimensions::none) : ""));
  for (const Strike& strike : situation.strikes)
    lines.push_back("the particle *" + strike.name + "* of " + data.amount(strike.amount) + " hits *" + strike.hits +
                    "* at " + code(strike.at) + " with the velocity " + code(strike.velocity) +
                    (strike.stays ? " and stays" : ""));
  if (const auto& center = situation.central_gravity) {
    lines.push_back("gravity pulls towards " + code(center->toward) + ", with the parameter " +
                    data.number(center->parameter, dimensions::gravitational_parameter) +
                    ": particles and spheres as if their mass were at their centers, other shapes by their moments of "
                    "inertia as well, to the second order of their size over their distance");
  } else if (situation.gravity) {
    const Name* none = situation.gravity->as<Name>();
    lines.push_back(none && none->name == "none" ? "weights are left out"
                                                 : "gravity acts along " + code(*situation.gravity));
  }
  for (const Excitation& excitation : situation.excitations) lines.push_back(shaking_words(excitation, data));
  for (const Frame& frame : situation.frames)
    lines.push_back("the frame *" + frame.name + "*" +
                    (frame.turns ? " turns about " + code(*frame.turns) + " at " +
                                       data.number(*frame.rate, dimensions::angular_velocity)
                                 : " does not turn") +
                    (frame.velocity ? ", its origin moves with " + code(*frame.velocity) : ""));
  if (situation.steady) {
    std::vector<std::string> spins;
    for (const Spin& spin : situation.steady->spins)
      spins.push_back("*" + spin.body + "* spins about " + code(spin.about) + " at " +
                      data.number(spin.rate, dimensions::angular_velocity));
    lines.push_back("the motion is steady: everything rests in *" + situation.steady->frame + "*" +
                    (spins.empty() ? "" : ", but " + listed(spins)));
  }
}

}  // namespace

ExplainedSection model_section(const Situation& situation, const Settings& settings,
                               const std::set<std::string>& hidden, const ExplanationTex& tex,
                               const std::string& heading) {
  const Data data(situation, settings, hidden, tex);
  std::vector<std::string> lines;
  for (const Body& body : situation.bodies) lines.push_back(body_line(body, data));
  for (const Joint& joint : situation.joints) lines.push_back(joint_line(joint, data));
  add_actions(situation, data, lines);
  for (const Instant& instant : situation.instants) {
    std::vector<std::string> facts;
    if (instant.rest) facts.emplace_back("everything rests");
    for (const Fact& fact : instant.facts)
      facts.push_back(code(to_string(fact.quantity) + " = " + to_string(fact.value)));
    for (const auto& [name, mark] : instant.nudged) facts.push_back(code(name) + " is disturbed a little");
    // What holds at the only instant stands under `facts:`.
    const std::string when = instant.name == "facts" ? "" : " at *" + instant.name + "*";
    if (!facts.empty()) lines.push_back("known" + when + ": " + listed(facts));
  }
  std::vector<std::string> unknown;
  for (const Unknown& item : situation.find) unknown.push_back(code(item.name));
  if (!unknown.empty()) lines.push_back("to be found: " + listed(unknown));
  std::vector<std::string> conditions;
  for (const Expression& condition : situation.where) conditions.push_back(code(condition));
  if (!conditions.empty()) lines.push_back("where " + listed(conditions));
  ExplainedSection section{heading, {}};
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += std::string(i == 0 ? "" : "\n") + "* " + lines[i] + (i + 1 == lines.size() ? "." : ";");
  section.steps.push_back({text, {}});
  if (const std::vector<std::string> others = data.others(); !others.empty())
    section.steps.push_back({"Data: " + listed(others) + ".", {}});
  return section;
}

ExplainedSection principle_section(const Statement& statement, const StatementQuestions& questions) {
  ExplainedSection section{"Principle", {}};
  const auto add = [&](const std::string& text) {
    if (std::none_of(section.steps.begin(), section.steps.end(),
                     [&](const ExplainedStep& step) { return step.text == text; }))
      section.steps.push_back({text, {}});
  };
  for (const auto& [home, asked] : questions.instants) {
    const Situation& situation = statement.situations[home.situation];
    const bool after = situation.has_blow() && home.instant == 1 && !home.time;
    if (after)
      add("A blow lasts no time: positions stay, and forces of ordinary size bring nothing. For the bodies together, "
          "momenta before plus the impulses from outside equal momenta after, as vectors and as moments (Eq. 17.4).");
    if (situation.steady && !after && (asked.asks_forces() || !situation.find.empty())) {
      const bool spins = !situation.steady->spins.empty();
      add(std::string("The motion is steady: in axes that turn with the frame nothing changes") +
          (spins ? " but constant spins" : "") +
          ", so the rates of the momenta are what the turning of the axes brings " +
          (spins ? "(Eqs. 18.22, 18.44)" : "(Eq. 18.22)") +
          ". The external forces are equivalent to these rates (Eqs. 18.1, 18.2).");
    }
    if (!situation.steady && asked.asks_forces() && !after)
      add("At every moment the external forces on a body are equivalent to $m\\,\\mathbf{a}_G$ at $G$ with the couple "
          "$\\dot{\\mathbf{H}}_G$ (Eqs. 18.1, 18.2): the two sides are written down and compared component by "
          "component.");
    const bool momenta = std::any_of(asked.momenta.begin(), asked.momenta.end(),
                                     [](const MomentumQuestion& q) { return q.angular || q.linear; });
    const bool energies =
        std::any_of(asked.momenta.begin(), asked.momenta.end(), [](const MomentumQuestion& q) { return q.energy; });
    if (momenta)
      add("Momentum needs no forces: it follows from masses and velocities now. About $G$ the angular momentum is "
          "$\\mathbf{H}_G = I_G\\,\\boldsymbol{\\omega}$ (Eq. 18.7), about another point $m\\mathbf{v}_G$ adds its "
          "moment (Eq. 18.11).");
    if (energies)
      add("The kinetic energy follows from masses and velocities now: that of $m$ moving with $G$ and that of turning "
          "about $G$ (Eq. 18.17).");
    if (asked.stability)
      add("Near a steady motion the equations of motion are linear in small deviations from it. Those that swing keep "
          "near "
          "it, those that grow leave it.");
    if (!asked.free_motions.empty())
      add("Without a couple about the mass center the angular momentum about it keeps its size and its direction "
          "(Eq. 18.46): how a body turns on follows from how it turns now.");
    if (section.steps.empty() && !asked.moving.empty() && !home.time && !home.ending)
      add(situation.stages.empty()
              ? "The velocities follow from how the bodies are held."
              : "In each stage the forces from outside give the accelerations (Eqs. 18.1, 18.2), and these the "
                "velocities at its end.");
    if (section.steps.empty() && !asked.masses.empty())
      add("Mass, mass center and inertia are sums over the parts, moved by parallel axes (Eqs. 18.5, 18.6).");
  }
  if (!questions.motions.empty())
    add("The motion is followed through time from its start: the equations of motion (Eqs. 18.1, 18.2) give the "
        "accelerations in every position, and what keeps its value all the while is a check.");
  if (!statement.claims.empty())
    add("A claim is to hold for all values of its letters: both sides are written as formulas and compared.");
  if (section.steps.empty()) add("The answers follow from the data and the conditions stated.");
  return section;
}

}  // namespace poinsot::problem
