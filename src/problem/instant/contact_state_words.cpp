#include "problem/instant/contact_state_words.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "problem/instant/contact_state_search.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr double same_line = 1e-12;  // as unit vectors

// Tells the slip of a state by the first of these expressions that is the same direction; false if none is.
bool take_same(ContactState& state, const std::vector<Expression>& directions, DataScope<double>& data) {
  const Vector3<double> d = data.direction(*state.slip);
  for (const Expression& direction : directions) {
    const std::optional<Vector3<double>> told = direction_told(data, direction);
    if (!told || norm(*told - d) > same_line) continue;
    state.slip = direction;
    return true;
  }
  return false;
}

}  // namespace

std::string words_of(const ContactState& state, const std::vector<double>& along) {
  const bool in_joint = state.in_joint;
  const std::string contact = std::string(in_joint ? "joint" : "contact") + " '" + state.contact + "'";
  if (state.grip == Grip::sticks) return contact + (in_joint ? " is held by its friction" : " sticks");
  if (state.grip == Grip::parts) return contact + " parts";
  std::string words = to_string(*state.slip);
  constexpr int digits = 6;
  constexpr double none = 1e-12;  // of the length of a direction: rounding
  if (!along.empty()) {
    words.clear();
    for (const double part : along)
      words += (words.empty() ? "[" : ", ") + with_digits(std::abs(part) > none ? part : 0, digits);
    words += "]";
  }
  if (in_joint)
    return contact + (state.from_rest ? " begins to move" : " moves") + " against its friction, along " + words;
  return contact + (state.from_rest ? " begins to slide along " : " slides along ") + words;
}

std::string words_of(const ContactState& state, const Situation& situation, const Settings& settings) {
  const auto stated = std::ranges::find(situation.contacts, state.contact, &Contact::name);
  if (stated != situation.contacts.end() && stated->on_cord) {
    const std::string cord = "'" + stated->of + "' ", wheel = " on '" + stated->against + "'";
    if (state.grip == Grip::sticks) return cord + "does not slip" + wheel;
    return cord + (state.from_rest ? "begins to slip" : "slips") + wheel +
           (state.slip->as<Unary>() ? ", against the way it is led" : ", the way it is led");
  }
  if (!state.slip || !state.slip->as<List>() || state.in_joint) return words_of(state);
  ContactState named = state;
  if (name_direction(named, situation, settings)) return words_of(named);
  const Vector3<double> d = DataScope<double>(situation, settings, 0).direction(*state.slip);
  if (situation.plane) return words_of(state, {d[situation.plane->first], d[situation.plane->second]});
  return words_of(state, {d.x, d.y, d.z});
}

std::vector<Expression> named_directions(const Situation& situation) {
  std::vector<std::string> names(situation.axes.begin(), situation.axes.end());
  for (const NamedExpression& direction : situation.directions) names.push_back(direction.name);
  std::vector<Expression> directions;
  for (const std::string& name : names)
    for (const bool opposite : {false, true}) directions.push_back(named_direction(name, opposite));
  return directions;
}

std::optional<Vector3<double>> direction_told(DataScope<double>& data, const Expression& expression) {
  try {
    return data.direction(expression);
  } catch (const StatementError&) {
    return std::nullopt;
  }
}

bool name_direction(ContactState& state, const Situation& situation, const Settings& settings) {
  DataScope<double> data(situation, settings, 0);
  return take_same(state, named_directions(situation), data);
}

bool name_line(ContactState& state, const Situation& situation, const Settings& settings) {
  if (name_direction(state, situation, settings)) return true;
  const auto contact = std::ranges::find(situation.contacts, state.contact, &Contact::name);
  if (contact == situation.contacts.end()) return false;
  DataScope<double> data(situation, settings, 0);
  return take_same(state, lines_across(situation, *contact), data);
}

std::vector<Expression> lines_across(const Situation& situation, const Contact& contact) {
  const auto made = [](auto content) -> Expression {
    return {std::make_shared<const Node>(Node{std::move(content), {}, 3})};
  };
  std::vector<Expression> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (situation.plane && (axis == situation.plane->first || axis == situation.plane->second)) continue;
    const Expression name = made(Name{situation.axes[axis]});
    const Expression line = made(Call{"cross", {{"", contact.normal}, {"with", name}}});
    lines.push_back(line);
    lines.push_back(made(Unary{'-', line}));
  }
  return lines;
}

bool are_same(const std::vector<ContactState>& a, const std::vector<ContactState>& b) {
  return std::ranges::equal(a, b, [](const ContactState& x, const ContactState& y) {
    return x.grip == y.grip && x.from_rest == y.from_rest &&
           (x.slip ? to_string(*x.slip) : "") == (y.slip ? to_string(*y.slip) : "");
  });
}

}  // namespace poinsot::problem
