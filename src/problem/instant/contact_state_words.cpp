#include "problem/instant/contact_state_words.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "problem/entries/read_joints.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/plane/planar_words.h"

namespace poinsot::problem {
namespace {

template <class Content>
Expression expression_of(Content content) {
  return {std::make_shared<const Node>(Node{std::move(content), {}, 3})};
}

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

Expression number_expression(double value) { return expression_of(Number{value, {}, false, with_digits(value, 17)}); }

Expression direction_expression(const Vector3<double>& d) {
  return expression_of(List{{number_expression(d.x), number_expression(d.y), number_expression(d.z)}});
}

Expression named_direction(const std::string& name, bool opposite) {
  const Expression named = expression_of(Name{name});
  return opposite ? expression_of(Unary{'-', named}) : named;
}

Expression joint_direction(const Contact& friction, bool opposite) {
  return opposite ? expression_of(Unary{'-', friction.normal}) : friction.normal;
}

void put_in_states(Situation& situation, std::size_t number, const std::vector<ContactState>& states) {
  for (const ContactState& state : states)
    for (Contact& contact : situation.contacts)
      if (state.situation == number && contact.name == state.contact) {
        contact.grip = state.grip;
        contact.slip = state.slip;
        contact.from_rest = state.from_rest;
        contact.slip_turns = false;
      }
}

Situation with_states_open(const Situation& situation) {
  Situation open = situation;
  for (Contact& contact : open.contacts) {
    if (contact.flies) continue;
    contact.grip = Grip::unknown;
    contact.slip.reset();
    contact.from_rest = contact.slip_turns = false;
  }
  return open;
}

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

std::string words_of_trial(const std::vector<ContactState>& states) {
  std::string words;
  for (const ContactState& one : states)
    words += (words.empty() ? "where '" : ", '") + one.contact +
             (one.grip == Grip::sticks   ? "' sticks"
              : one.grip == Grip::slides ? "' slides"
                                         : "' parts");
  return words;
}

std::string words_of(const ContactState& state, const Situation& situation, const Settings& settings) {
  const auto stated = std::ranges::find(situation.contacts, state.contact, &Contact::name);
  if (stated != situation.contacts.end() && stated->on_cord) {
    const std::string cord = "'" + stated->of + "' ", wheel = " on '" + stated->against + "'";
    if (state.grip == Grip::sticks) return cord + "does not slip" + wheel;
    return cord + (state.from_rest ? "begins to slip" : "slips") + wheel +
           (state.slip->as<Unary>() ? ", against the way it is led" : ", the way it is led");
  }
  if (!state.has_direction() || !state.slip->as<List>()) return words_of(state);
  // Of a sleeve the direction is one on its surface, unrolled.
  if (stated->all_ways &&
      rubbing_joint(situation.joints, state.contact).joint.kind->common_slip == CommonSlip::along_and_round)
    return "joint '" + state.contact + (state.from_rest ? "' begins to move" : "' moves") +
           " against its friction, along and round at once";
  ContactState named = state;
  if (name_direction(named, situation, settings)) return words_of(named);
  const Vector3<double> d = DataScope<double>(situation, settings, 0).direction(*state.slip);
  if (situation.plane)
    return words_of(state, {d[component_axes(*situation.plane)[0]], d[component_axes(*situation.plane)[1]]});
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
  std::vector<Expression> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (situation.plane && (axis == situation.plane->first || axis == situation.plane->second)) continue;
    const Expression name = expression_of(Name{situation.axes[axis]});
    const Expression line = expression_of(Call{"cross", {{"", contact.normal}, {"with", name}}});
    lines.push_back(line);
    lines.push_back(expression_of(Unary{'-', line}));
  }
  return lines;
}

std::vector<ContactState> possible_states(const Situation& situation, std::size_t i, const Contact& contact,
                                          const Settings& settings) {
  std::vector<ContactState> states{{contact.name, i, Grip::sticks, {}, false, !contact.touches()}};
  if (situation.steady || contact.of_belt) return states;
  if (!contact.touches() && !contact.all_ways) {
    for (const bool opposite : {false, true})
      states.push_back({contact.name, i, Grip::slides, joint_direction(contact, opposite), false, !contact.touches()});
    return states;
  }
  DataScope<double> data(situation, settings, 0);
  const CommonSlip slip =
      contact.all_ways ? rubbing_joint(situation.joints, contact.name).joint.kind->common_slip : CommonSlip::none;
  if (slip == CommonSlip::along_and_round)
    fail(situation.file, contact.friction->mark,
         "unknowns are not found beside " + contact.words() + ", which slips along and round at once",
         "give the unknowns values, or state a friction of its own for each of its freedoms");
  // A ball turns about any axis.
  const std::optional<Vector3<double>> n =
      slip == CommonSlip::turning ? std::optional(Vector3<double>{}) : direction_told(data, contact.normal);
  std::vector<Expression> directions = named_directions(situation);
  const std::size_t named = directions.size();
  std::ranges::copy(lines_across(situation, contact), std::back_inserter(directions));
  std::vector<Vector3<double>> known;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    // Where the normal depends on an unknown, only lines across it that are told by it are sure to lie across it.
    if (n) {
      const std::optional<Vector3<double>> d = direction_told(data, directions[k]);
      constexpr double rounding = 1e-9;  // of directions that data tell: which lie across the normal, and which are one
      if (!d || std::abs(dot(*d, *n)) > rounding ||
          std::ranges::any_of(known, [&](const Vector3<double>& other) { return norm(other - *d) < rounding; }))
        continue;
      known.push_back(*d);
    } else if (k < named) {
      continue;
    }
    states.push_back({contact.name, i, Grip::slides, directions[k], false, contact.in_joint, false, contact.all_ways});
  }
  if (contact.touches()) states.push_back({contact.name, i, Grip::parts, {}, false, false});
  return states;
}

bool are_same(const std::vector<ContactState>& a, const std::vector<ContactState>& b) {
  return std::ranges::equal(a, b, [](const ContactState& x, const ContactState& y) {
    return x.grip == y.grip && x.from_rest == y.from_rest &&
           (x.slip ? to_string(*x.slip) : "") == (y.slip ? to_string(*y.slip) : "");
  });
}

}  // namespace poinsot::problem
