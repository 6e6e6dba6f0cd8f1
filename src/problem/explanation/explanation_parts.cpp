// Shows the parts of a body in a table: masses, mass centers, moments and products of inertia, and their sums.
#include <algorithm>
#include <memory>

#include "problem/explanation/explanation_instant.h"
#include "problem/explanation/explanation_model.h"
#include "problem/language/expression_walk.h"
#include "problem/machine/masses.h"

namespace poinsot::problem {
namespace {

// The mass properties of a part of the drawing, moved to the present pose of its body.
template <class Scalar>
MassProperties<Scalar> moved(const MassProperties<Scalar>& part, const solve::MechanismStateOf<Scalar>& now, int body) {
  const solve::MechanismStateOf<Scalar> drawn(now.mechanism());
  const auto at = static_cast<std::size_t>(body + 1);
  const auto &here = now.workspace().motion[at], &there = drawn.workspace().motion[at];
  const Matrix3<Scalar> turned = here.R * transpose(there.R);
  return {part.mass, here.p + turned * (part.center - there.p), rotated(turned, part.inertia_center)};
}

// The straight pieces of a bent wire as separate rods, if its mass is distributed by length.
std::vector<Part> legs_of(const Part& wire) {
  const List* points =
      wire.shape.kind == "wire" && !wire.amount.mass && !wire.amount.weight && !wire.shape.arguments.empty()
          ? wire.shape.arguments.front().value.as<List>()
          : nullptr;
  if (!points || points->items.size() < 3) return {wire};
  std::vector<Part> legs;
  for (std::size_t k = 0; k + 1 < points->items.size(); ++k) {
    const Expression &from = points->items[k], &to = points->items[k + 1];
    Part& leg = legs.emplace_back(wire);
    leg.name = from.as<Name>() && to.as<Name>() ? to_string(from) + to_string(to) : "piece " + std::to_string(k + 1);
    leg.shape.kind = "rod";
    const Expression& all = wire.shape.arguments.front().value;
    leg.shape.arguments.front().value = built(List{{from, to}}, all.mark());
  }
  return legs;
}

Body with_legs(Body body) {
  std::vector<Part> parts;
  for (const Part& part : body.parts)
    for (Part& leg : legs_of(part)) parts.push_back(std::move(leg));
  body.parts = std::move(parts);
  return body;
}

std::vector<std::string> names_of_parts(const Body& body) {
  std::vector<std::string> names;
  if (body.parts.empty()) names.push_back(body.name);
  for (const auto* list : {&body.parts, &body.added, &body.absorbed})
    for (const Part& part : *list)
      names.push_back((part.name.empty() ? body.name : part.name) + (part.hole ? " (hole)" : ""));
  return names;
}

// A column of the table: its heading, its dimension, and which number of a part it shows.
struct Quantity {
  std::string tex;
  Dimension dimension;
  int index;  // 0 for the mass, 1 to 3 for the center, 4 to 6 for moments, 7 to 9 for products
};

template <class Scalar>
Scalar quantity_of(const MassProperties<Scalar>& part, const Vector3<Scalar>& point, int index) {
  if (index == 0) return part.mass;
  if (index < 4) return part.center[static_cast<std::size_t>(index - 1)];
  const SymmetricMatrix3<Scalar> I = inertia_about(part, point);
  return index < 7 ? moment_on(I, static_cast<std::size_t>(index - 4))
                   : product_on(I, static_cast<std::size_t>(index - 7));
}

}  // namespace

void InstantExplainer::parts_step(ExplainedSection& section, int body, const ExplainedPoint& point) {
  const auto stated = std::find_if(situation_.bodies.begin(), situation_.bodies.end(),
                                   [&](const Body& one) { return one.name == body_name(body); });
  // For any time of a motion the whole is enough: the parts were told of its start.
  const bool any_time = followed_ && formula_instant_ != nullptr;
  if (stated == situation_.bodies.end() || solved_.uses_any() || any_time) return;
  const Body whole = with_legs(*stated);
  std::vector<std::string> names = names_of_parts(whole);
  if (names.size() < 2) return;
  std::vector<MassProperties<double>> numbers = part_masses(whole, data_);
  std::vector<MassProperties<Formula>> formulas;
  if (formula_instant_ && figures_.formulas && point.position.formula) {
    const std::vector<Body>& bodies = formula_instant_->situation().bodies;
    try {
      formulas = part_masses(with_legs(bodies.at(static_cast<std::size_t>(stated - situation_.bodies.begin()))),
                             formula_instant_->data());
      for (MassProperties<Formula>& part : formulas) part = moved(part, figures_.formulas->now, body);
    } catch (const std::exception&) {
      formulas.clear();
    }
  }
  for (MassProperties<double>& part : numbers) part = moved(part, figures_.numbers.now, body);
  if (numbers.size() != names.size() || (!formulas.empty() && formulas.size() != names.size())) return;
  // What has no mass adds nothing.
  for (std::size_t i = names.size(); i-- > 0;) {
    if (numbers[i].mass != 0) continue;
    const auto place = static_cast<std::ptrdiff_t>(i);
    names.erase(names.begin() + place);
    numbers.erase(numbers.begin() + place);
    if (!formulas.empty()) formulas.erase(formulas.begin() + place);
  }
  if (names.size() < 2) return;
  numbers.push_back(sum(numbers));
  try {
    if (!formulas.empty()) formulas.push_back(sum(formulas));
  } catch (const std::exception&) {
    formulas.clear();
  }

  std::vector<Quantity> columns{{"m", dimensions::mass, 0}};
  for (int k = 0; k < 3; ++k)
    columns.push_back({"\\bar{" + tex_.axis(static_cast<std::size_t>(k)) + "}", dimensions::length, 1 + k});
  // Of a planar problem nothing need be said of moments about axes in its plane, which then are none of the body's.
  const auto& plane = situation_.plane;
  for (int k = 0; k < 3; ++k)
    if (!plane || plane->normal() == static_cast<std::size_t>(k))
      columns.push_back({"I_{" + tex_.axis(static_cast<std::size_t>(k)) + "}", dimensions::moment_of_inertia, 4 + k});
  for (int k = 0; k < 3 && !plane; ++k) {
    const std::string pair = tex_.axis(static_cast<std::size_t>(k)) + tex_.axis(static_cast<std::size_t>((k + 1) % 3));
    columns.push_back({"I_{" + pair + "}", dimensions::moment_of_inertia, 7 + k});
  }
  std::vector<std::vector<Shown>> cells(columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t row = 0; row < numbers.size(); ++row) {
      std::optional<Formula> formula;
      try {
        if (!formulas.empty()) formula = quantity_of(formulas[row], *point.position.formula, columns[c].index);
      } catch (const std::exception&) {
        // The number is shown without formula.
      }
      const double number = quantity_of(numbers[row], point.position.number, columns[c].index);
      cells[c].push_back(clean(confirmed(number, formula), columns[c].dimension));
      if (!tex_.can_show(cells[c].back())) return;
    }
  std::string head = "| part |", rule = "|---|";
  std::vector<std::string> lines;
  lines.reserve(names.size() + 1);
  for (const std::string& name : names) lines.push_back("| " + name + " |");
  lines.emplace_back("| **sum** |");
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (std::all_of(cells[c].begin(), cells[c].end(), [](const Shown& cell) { return cell.number == 0; })) continue;
    const bool known = std::all_of(cells[c].begin(), cells[c].end(),
                                   [&](const Shown& cell) { return tex_.is_known(cell) && !tex_.is_sought(cell); });
    const std::string unit = known ? tex_.unit_alone(columns[c].dimension) : "";
    head += " $" + columns[c].tex + "$" + (unit.empty() ? "" : " in $" + unit + "$") + " |";
    rule += "---|";
    for (std::size_t row = 0; row < lines.size(); ++row) {
      // In the row of the sum the mass center is that of the whole; all other numbers add up.
      const Shown& cell = cells[c][row];
      const std::string text = cell.number == 0 ? "0"
                               : known          ? "$" + tex_.number(cell.number, columns[c].dimension) + "$"
                                                : tex_.inline_value(cell, columns[c].dimension);
      if (text.empty()) return;
      lines[row] += " " + text + " |";
    }
  }
  std::string text = "*" + body_name(body) + "* by its parts; moments " +
                     (plane ? "of inertia about $" : "and products of inertia about $") + point.label +
                     "$, each part's own and that of its mass at its center (Eqs. 18.5, 18.6):\n\n" + head + "\n" +
                     rule;
  for (const std::string& line : lines) text += "\n" + line;
  section.steps.push_back({text, {}});
}

void leave_out_said_inertia(std::vector<ExplainedSection>& sections) {
  const auto same_step = [](const ExplainedStep& a, const ExplainedStep& b) {
    return a.text == b.text &&
           std::ranges::equal(a.equations, b.equations, {}, &ExplainedEquation::tex, &ExplainedEquation::tex);
  };
  for (std::size_t i = 0; i < sections.size(); ++i)
    for (std::size_t k = sections.size(); sections[i].of_inertia && k-- > i + 1;)
      if (sections[k].of_inertia && std::ranges::equal(sections[i].steps, sections[k].steps, same_step))
        sections.erase(sections.begin() + static_cast<std::ptrdiff_t>(k));
}

void append_at_limits(std::vector<ExplainedSection>& sections, std::vector<ExplainedSection> at_limits, bool of_same) {
  if (of_same && std::ranges::any_of(sections, &ExplainedSection::of_sides))
    std::erase_if(at_limits, [](const ExplainedSection& one) { return one.of_sides; });
  sections.insert(sections.end(), at_limits.begin(), at_limits.end());
}

}  // namespace poinsot::problem
