#include "problem/explanation/explanation_motion.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/solve/instant/mechanism_state.h"
#include "problem/explanation/explanation_unknowns.h"
#include "problem/explanation/kept_values.h"
#include "problem/explanation/turning_points.h"
#include "problem/language/words.h"

namespace poinsot::problem {

namespace {

// What is kept of a mass that may be any, for a unit of it.
void divide_by_mass(KeptValue& kept, const std::string& mass) {
  if (kept.dimension == dimensions::angular_velocity) return;
  kept.symbol = (has_parts(kept.symbol) ? "(" + kept.symbol + ")" : kept.symbol) + "/" + ExplanationTex::symbol(mass);
  kept.dimension = kept.dimension / dimensions::mass;
  if (kept.formula) kept.formula = substituted(*kept.formula, {{mass, Formula(1)}});
  if (kept.at_start) kept.at_start = substituted(*kept.at_start, {{mass, Formula(1)}});
}

}  // namespace

std::vector<ExplainedSection> motion_sections(const Statement& statement, std::size_t situation_index, Sample& sample,
                                              const GeneralMotion* general, const std::string& any_mass,
                                              const Settings& settings, const ExplanationTex& tex,
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
  for (std::string happening : motion.happenings()) {
    // Its times and energies are those of letters that were drawn.
    if (tex.numbers_open()) break;
    happening.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(happening.front())));
    section.steps.push_back({with_emphasis(happening) + ".", {}});
  }
  const double reached = motion.reached();
  if (reached > 0 && situation.stages.size() <= 1) {
    std::vector<KeptValue> values = kept_values(situation, situation_index, sample, reached, general);
    if (!any_mass.empty())
      for (KeptValue& one : values) divide_by_mass(one, any_mass);
    ExplainedStep kept{"", {}}, at_start{"", {}};
    std::vector<std::string> words;
    for (const KeptValue& one : values) {
      words.push_back(one.words);
      const Shown shown{one.value, one.formula};
      if (tex.can_show(shown)) kept.equations.push_back(tex.kept(one.symbol, shown, one.dimension));
      // A number that is known stands in the line of what keeps it.
      const Shown stated{one.value, one.at_start};
      const bool same = one.at_start && one.formula && (*one.at_start - *one.formula).is_zero();
      if (one.at_start && !same && !tex.is_known(shown))
        at_start.equations.push_back(tex.kept(one.symbol, stated, one.dimension));
    }
    std::erase_if(kept.equations, [](const ExplainedEquation& equation) { return equation.sides.empty(); });
    if (!words.empty()) {
      kept.text = "Along the motion " + listed(words) + (words.size() > 1 ? " keep their values" : " keeps its value") +
                  (kept.equations.empty() ? "." : " of the start:");
      section.steps.push_back(std::move(kept));
    }
    std::erase_if(at_start.equations, [](const ExplainedEquation& equation) { return equation.sides.empty(); });
    if (!at_start.equations.empty()) {
      at_start.text = at_start.equations.size() > 1 ? "At the start they are:" : "At the start it is:";
      section.steps.push_back(std::move(at_start));
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
    ExplainedStep found{"What is stated of it later, " + listed(conditions) + ", fixes " + listed(unknown) +
                            ": the motion is followed for one value after the other until it holds.",
                        {}};
    for (const Unknown& item : situation.find)
      if (const auto value = settings.find(item.name);
          value != settings.end() && value->second.is_number() && !tex.numbers_open())
        found.equations.push_back(
            tex.equation(ExplanationTex::symbol(item.name), known_number(value->second.number), item.unit.dimension));
    if (!found.equations.empty()) found.text.back() = ':';
    section.steps.push_back(std::move(found));
  }
  if (section.steps.empty()) return {};
  return {section};
}

bool is_uniform_stage(Sample& sample, std::size_t situation, std::size_t stage) {
  Course& motion = sample.motion(situation);
  const std::optional<double> end = motion.stage_end(stage);
  if (!end) return false;
  const double begin = motion.stage_start(stage);
  const MotionState first = motion.at(begin), last = motion.end_of(stage);
  constexpr double rounding = 1e-9;  // of the rates
  bool changes = false;
  for (std::size_t k = 0; k < first.v.size(); ++k) {
    const double change = last.v[k] - first.v[k], size = std::abs(last.v[k]) + std::abs(first.v[k]);
    for (const double part : {0.17, 0.38, 0.5, 0.83})
      if (std::abs(motion.at(begin + part * (*end - begin)).v[k] - first.v[k] - part * change) > rounding * size)
        return false;
    if (std::abs(change) <= rounding * size) continue;
    changes = true;
    const std::vector<NamedCoordinate>& named = motion.instant_at(begin).machine().coordinates;
    // Rates of bodies that are free are components on axes that turn.
    if (std::ranges::none_of(named, [&](const NamedCoordinate& one) {
          return !one.name.empty() && one.velocity == static_cast<int>(k);
        }))
      return false;
  }
  return changes;
}

ExplainedSection uniform_stage(const Situation& situation, std::size_t situation_index, std::size_t stage,
                               Sample& sample, const ExplanationTex& tex, const std::string& suffix) {
  Course& motion = sample.motion(situation_index);
  const double begin = motion.stage_start(stage), end = *motion.stage_end(stage);
  const MotionState first = motion.at(begin), last = motion.end_of(stage);
  ExplainedStep step{"", {}};
  std::vector<std::string> kept;
  constexpr double rounding = 1e-9;
  for (const NamedCoordinate& one : motion.instant_at(begin).machine().coordinates) {
    const auto k = static_cast<std::size_t>(one.velocity);
    if (one.name.empty() || std::abs(last.v[k] - first.v[k]) <= rounding * std::abs(last.v[k] + first.v[k])) continue;
    const std::string symbol = ExplanationTex::symbol(one.name), rate = "\\dot{" + symbol + "}",
                      gained = "\\ddot{" + symbol + "}\\,\\Delta t";
    const Dimension dimension = one.turning ? dimensions::angular_velocity : dimensions::velocity;
    const std::string before = first.v[k] == 0 ? "" : rate + "_{0} + ";
    kept.push_back("$\\ddot{" + symbol + "}$");
    if (const Shown value{last.v[k], {}}; tex.can_show(value))
      step.equations.push_back(tex.equation(rate + " = " + before + gained, value, dimension));
  }
  const Shown lasts{end - begin, {}};
  step.text = "Nothing in these equations changes during *" + situation.stages[stage].name + "*: " + listed(kept) +
              (kept.size() > 1 ? " keep their values" : " keeps its value") +
              (tex.can_show(lasts) ? " for " + tex.inline_value(lasts, dimensions::time) : "") + ", and at its end";
  if (step.equations.empty()) step.text += " the rates have grown with the time that it lasts.";
  return {"Stage *" + situation.stages[stage].name + "*" + suffix, {std::move(step)}};
}

namespace {

// How a vector is called in an equation.
std::string vector_tex(const Expression& expression, const ExplanationTex& tex) {
  if (const Name* name = expression.as<Name>()) {
    for (std::size_t k = 0; k < 3; ++k)
      if (name->name == tex.axis(k)) return tex.unit_vector(k);
    return ExplanationTex::vector_symbol(name->name);
  }
  if (const Arrow* arrow = expression.as<Arrow>()) {
    const Name *from = arrow->from.as<Name>(), *to = arrow->to.as<Name>();
    if (from && to) return "\\overrightarrow{" + from->name + to->name + "}";
  }
  if (const Call* call = expression.as<Call>()) {
    const Expression* about = call->argument("about");
    const Name* point = about ? about->as<Name>() : nullptr;
    if (call->function == "angular_momentum")
      return "\\mathbf{H}" + (point ? "_{" + ExplanationTex::symbol(point->name) + "}" : std::string());
    if (call->function == "angular_velocity") return "\\boldsymbol{\\omega}";
    if (call->function == "velocity") return "\\mathbf{v}";
    if (call->function == "acceleration") return "\\mathbf{a}";
    if (call->function == "angular_acceleration") return "\\boldsymbol{\\alpha}";
    if (call->function == "force" || call->function == "reaction") return "\\mathbf{F}";
  }
  return "";
}

bool is_unit(const Expression& expression, const ExplanationTex& tex) {
  const Name* name = expression.as<Name>();
  return name && (name->name == tex.axis(0) || name->name == tex.axis(1) || name->name == tex.axis(2));
}

std::string size_tex(const std::string& vector) { return "\\left|" + vector + "\\right|"; }

// The angle by its cosine.
void add_asked_angle(ExplainedStep& step, const std::string& symbol, const Call& call, const Vector3<double>& u,
                     const Vector3<double>& w, const ExplanationTex& tex) {
  const Expression *first = call.argument(""), *second = call.argument("to");
  std::string left = vector_tex(*first, tex), right = vector_tex(*second, tex);
  if (left.empty()) left = "\\mathbf{u}";
  if (right.empty() || right == left) right = "\\mathbf{w}";
  const bool acute = call.function == "acute_angle";
  const double cosine = dot(u, w) / (norm(u) * norm(w)), shown = acute ? std::abs(cosine) : cosine;
  const std::string product = left + "\\cdot" + right, sizes = (is_unit(*first, tex) ? "" : size_tex(left)) +
                                                               (is_unit(*second, tex) ? "" : size_tex(right));
  step.equations.push_back(tex.equation("\\cos " + symbol + " = \\frac{" + (acute ? size_tex(product) : product) +
                                            "}{" + (sizes.empty() ? "1" : sizes) + "}",
                                        known_number(shown), dimensions::none));
  step.equations.push_back(
      tex.equation(symbol, known_number(std::acos(std::clamp(shown, -1.0, 1.0))), dimensions::angle));
}

// The size by the components.
void add_asked_size(ExplainedStep& step, const std::string& symbol, const Expression& of, const Vector3<double>& vector,
                    const Dimension& dimension, const ExplanationTex& tex) {
  constexpr double noticeable = 1e-9;  // of the vector
  std::string squares;
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(vector[k]) <= noticeable * norm(vector)) continue;
    const std::string number = tex.number(std::abs(vector[k]), dimension);
    squares += (count++ > 0 ? " + " : "") + (has_parts(number) ? "\\left(" + number + "\\right)" : number) + "^{2}";
  }
  // The size of a single component is that component.
  if (count < 2) return;
  const std::string name = vector_tex(of, tex);
  step.equations.push_back(tex.equation(symbol + " = " + (name.empty() ? "" : size_tex(name) + " = ") + "\\sqrt{" +
                                            squares + "}" + tex.unit_tex(dimension),
                                        known_number(norm(vector)), dimension));
}

// The component by those of vector and direction; nothing along an axis, where it is one of the vector's.
void add_asked_component(ExplainedStep& step, const std::string& symbol, const Expression& of,
                         const Vector3<double>& vector, const Dimension& dimension, const Vector3<double>& along,
                         const ExplanationTex& tex) {
  constexpr double noticeable = 1e-9;
  const Vector3<double> e = along / norm(along);
  std::string sum;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(std::abs(e[k]) - 1) <= noticeable) return;
    if (std::abs(vector[k] * e[k]) <= noticeable * norm(vector)) continue;
    const bool minus = (vector[k] < 0) != (e[k] < 0);
    sum += (sum.empty() ? (minus ? "-" : "")
            : minus     ? " - "
                        : " + ") +
           tex.number(std::abs(vector[k]), dimension) + "\\cdot " + tex.number(std::abs(e[k]), dimensions::none);
  }
  if (sum.empty()) return;
  // What is relative to a body stands nowhere else.
  const Call* call = of.as<Call>();
  const bool relative = call && call->argument("relative to");
  const std::string name = vector_tex(of, tex) + (relative ? "_{\\mathrm{rel}}" : "");
  if (const ShownVector shown{vector, {}}; relative && tex.can_show(shown))
    step.equations.push_back(tex.equation(name, shown, dimension));
  if (const ShownVector direction{e, {}}; tex.can_show(direction))
    step.equations.push_back(tex.equation("\\mathbf{e}", direction, dimensions::none));
  step.equations.push_back(
      tex.equation(symbol + " = " + (name.empty() ? "\\mathbf{u}" : name) + "\\cdot\\mathbf{e} = " + sum,
                   known_number(dot(vector, e)), dimension));
}

}  // namespace

ExplainedSection vectors_section(const Statement& statement, const Solution& solution, const Sample::Home& home,
                                 Sample& sample, const ExplanationTex& tex, const std::string& suffix) {
  ExplainedSection section{"Angles and sizes" + suffix, {}};
  ExplainedStep step{"What is asked for follows from these vectors:", {}};
  for (std::size_t k = 0; k < statement.asks.size(); ++k) {
    const Ask& ask = statement.asks[k];
    if (ask.of.size() != 1 || ask.is_list || ask.table || ask.when || ask.extremum) continue;
    const bool as_formula = solution.asks[k].state == AskState::needs_letters && solution.asks[k].formula.has_value();
    if (solution.asks[k].state != AskState::found && !as_formula) continue;
    const At* at = ask.of.front().as<At>();
    const Call* call = (at ? at->expression : ask.of.front()).as<Call>();
    if (call == nullptr || (call->function != "angle" && call->function != "acute_angle" && call->function != "norm" &&
                            call->function != "component"))
      continue;
    const Sample::Home own = sample.home_of(ask);
    if (own < home || home < own) continue;
    const auto vector = [&](const Expression* one) -> std::optional<Value<double>> {
      if (one == nullptr) return std::nullopt;
      const Value<double> value = sample.value_at(home, *one, std::nullopt);
      if (value.kind != Value<double>::Kind::vector || norm(value.vector) == 0) return std::nullopt;
      return value;
    };
    const std::optional<Value<double>> first = vector(call->argument(""));
    if (!first) continue;
    const std::string symbol = ExplanationTex::symbol(ask.name);
    if (as_formula) {
      const std::string name = call->function == "norm" ? vector_tex(*call->argument(""), tex) : "";
      const auto formula = solution.asks[k].formula->is_number()
                               ? ExplanationTex::formula(solution.asks[k].formula->number)
                               : std::nullopt;
      if (!name.empty() && formula)
        step.equations.push_back({"", symbol + " = " + size_tex(name) + " = " + *formula, {}, 0});
    } else if (call->function == "component") {
      if (const std::optional<Value<double>> along = vector(call->argument("along")); along && !tex.numbers_open())
        add_asked_component(step, symbol, *call->argument(""), first->vector, first->dimension, along->vector, tex);
    } else if (call->function == "norm") {
      if (!tex.numbers_open()) add_asked_size(step, symbol, *call->argument(""), first->vector, first->dimension, tex);
    } else if (const std::optional<Value<double>> second = vector(call->argument("to"))) {
      add_asked_angle(step, symbol, *call, first->vector, second->vector, tex);
    }
  }
  if (!step.equations.empty()) section.steps.push_back(std::move(step));
  return section;
}

ExplainedSection turned_axes_section(const Statement& statement, const Sample::Home& home, Sample& sample,
                                     const ExplanationTex& tex, const std::string& suffix) {
  ExplainedSection section;
  SolvedInstant& instant = sample.instant(home);
  const Machine& machine = instant.machine();
  solve::MechanismState state(machine.mechanism);
  state.set_positions(instant.state().q);
  for (const Ask& ask : statement.asks) {
    const Name* name = ask.axes ? ask.axes->as<Name>() : nullptr;
    if (name == nullptr || ask.of.size() != 1 || ask.table || ask.when || ask.extremum) continue;
    const auto body = machine.index.find(name->name);
    if (body == machine.index.end() || body->second == ground) continue;
    const Sample::Home own = sample.home_of(ask);
    if (own < home || home < own) continue;
    const Matrix3<double> R = body_pose(machine.mechanism.tree, state.workspace(), body->second).R;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k)
      off = std::max(off, norm(Vector3<double>(R.column(k) - Vector3<double>::unit(k))));
    constexpr double noticeable = 1e-9;
    if (off < noticeable) continue;
    const At* at = ask.of.front().as<At>();
    const Expression& of = at ? at->expression : ask.of.front();
    const Value<double> value = sample.value_at(home, of, ask.axes);
    if (value.kind != Value<double>::Kind::vector) continue;
    // What is asked for is these components of the vector that was found.
    const Value<double> found = sample.value_at(home, of, std::nullopt);
    if (norm(Vector3<double>(R * value.vector - found.vector)) > noticeable * norm(found.vector)) continue;
    const std::string heading = "On the axes of *" + name->name + "*" + suffix;
    if (section.steps.empty()) {
      section.heading = heading;
      ExplainedStep axes{"These have turned with *" + name->name + "*. On the axes of the ground they are", {}};
      for (std::size_t k = 0; k < 3; ++k)
        if (const ShownVector axis{R.column(k), {}}; tex.can_show(axis))
          axes.equations.push_back(tex.equation(tex.unit_vector(k) + "'", axis, dimensions::none));
      if (axes.equations.empty()) return section;
      section.steps.push_back(std::move(axes));
      section.steps.push_back({"The components that are asked for are the products with these:", {}});
    } else if (section.heading != heading) {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double component = value.vector[k];
      if (std::abs(component) <= noticeable * norm(value.vector)) continue;
      if (const Shown one{component, {}}; tex.can_show(one))
        section.steps.back().equations.push_back(tex.equation(
            ExplanationTex::vector_symbol(ask.name) + "\\cdot" + tex.unit_vector(k) + "'", one, value.dimension));
    }
  }
  return section;
}

}  // namespace poinsot::problem
