#include "problem/machine/data.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "problem/entries/drawn_letters.h"
#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/expression_walk.h"
#include "problem/language/misread.h"
#include "problem/language/scalar_value.h"
#include "problem/language/unit_table.h"
#include "problem/language/units.h"

namespace poinsot::problem {
namespace {

const NamedExpression* find_named(const std::vector<NamedExpression>& items, const std::string& name) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

const Letter* find_letter(const Situation& situation, const std::string& name) {
  const auto found = std::find_if(situation.letters.begin(), situation.letters.end(),
                                  [&](const Letter& letter) { return letter.name == name; });
  return found == situation.letters.end() ? nullptr : &*found;
}

const Unknown* find_unknown(const Situation& situation, const std::string& name) {
  const auto found = std::find_if(situation.find.begin(), situation.find.end(),
                                  [&](const Unknown& unknown) { return unknown.name == name; });
  return found == situation.find.end() ? nullptr : &*found;
}

const Choice* find_choice(const Situation& situation, const std::string& name) {
  const auto found = std::find_if(situation.choose.begin(), situation.choose.end(),
                                  [&](const Choice& choice) { return choice.name == name; });
  return found == situation.choose.end() ? nullptr : &*found;
}

Expression name_expression(const std::string& name, const Mark& mark) { return built(Name{name}, mark); }

// The names in an expression, and those behind its data, points, directions and definitions.
std::set<std::string> names_behind(const Situation& situation, const Expression& expression) {
  std::set<std::string> all, fresh;
  collect_names(expression, fresh);
  while (!fresh.empty()) {
    std::set<std::string> next;
    for (const std::string& name : fresh) {
      if (!all.insert(name).second) continue;
      for (const auto* items : {&situation.given, &situation.points, &situation.directions, &situation.define})
        if (const NamedExpression* item = find_named(*items, name)) collect_names(item->value, next);
    }
    fresh = std::move(next);
  }
  return all;
}

}  // namespace

bool depends_on_time(const Situation& situation, const Expression& expression) {
  return names_behind(situation, expression).contains("time");
}

std::set<std::string> letters_of(const Situation& situation, const Expression& expression) {
  std::set<std::string> letters;
  for (const std::string& name : names_behind(situation, expression))
    if (find_letter(situation, name)) letters.insert(name);
  return letters;
}

std::vector<std::string> settable_names(const Situation& situation) {
  std::vector<std::string> names;
  for (const Letter& letter : situation.letters) names.push_back(letter.name);
  for (const NamedExpression& item : situation.given) names.push_back(item.name);
  for (const Unknown& unknown : situation.find) names.push_back(unknown.name);
  return names;
}

Expression setting_expression(const std::string& name, const std::string& text) {
  // On a command line blanks are inconvenient, so that 3kg is accepted.
  std::string spaced = text;
  double number = 0;
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto read = std::from_chars(begin, text.data() + text.size(), number);
  const auto used = static_cast<std::size_t>(read.ptr - text.data());
  if (read.ptr != begin && used < text.size() && std::isalpha(static_cast<unsigned char>(text[used])))
    spaced.insert(used, " ");
  return parse_expression(spaced, "--set " + name + "=" + text, Mark{});
}

Value<double> read_setting(const Situation& situation, const std::string& name, const std::string& text) {
  const std::string file = "--set " + name + "=" + text;
  if (text.find('=') != std::string::npos)
    fail(file, {}, "a second value stands in this one", "write --set before each: --set 'm=3 kg' --set 'L=2 m'");
  for (std::size_t k = 1; k + 1 < text.size() && text.find('[') == std::string::npos; ++k)
    if (text[k] == ',' && std::isdigit(static_cast<unsigned char>(text[k - 1])) &&
        std::isdigit(static_cast<unsigned char>(text[k + 1])))
      fail(file, {}, "a comma stands in a number", "a decimal is written with a point: 0.8, not 0,8");
  const Expression expression = setting_expression(name, text);
  Situation nothing;
  nothing.file = file;
  const Settings none;
  DataScope<double> scope(nothing, none);
  Value<double> value = evaluate(expression, static_cast<Scope<double>&>(scope), file);
  if (!value.is_number() && !value.is_vector()) fail(file, {}, "'" + text + "' is not a number with its unit");
  std::optional<Dimension> wanted;
  if (const Letter* letter = find_letter(situation, name)) {
    wanted = letter->unit.dimension;
  } else if (const Unknown* unknown = find_unknown(situation, name)) {
    wanted = unknown->unit.dimension;
  } else if (const NamedExpression* item = find_named(situation.given, name)) {
    const Settings unit_letters = [&] {
      Settings settings;
      for (const Letter& other : situation.letters)
        settings[other.name] = Value<double>::of_number(other.unit.factor, other.unit.dimension);
      return settings;
    }();
    DataScope<double> data(situation, unit_letters);
    try {
      wanted = data.value(item->value).dimension;
    } catch (const DomainError&) {
      // The datum in the file has no value, and a value from outside may have any dimension.
    }
  }
  const bool zero = value.bare && (value.is_number() ? value.number == 0 : norm(value.vector) == 0);
  if (wanted && !same_kind(*wanted, value.dimension) && !zero)
    fail(file, {}, name + " is " + to_string(*wanted) + ", but " + text + " is " + to_string(value.dimension),
         value.bare ? "write " + name + "=" + text + " " + UnitHabits().unit_for(*wanted).text : "");
  if (wanted && *wanted == dimensions::angle && value.bare && !zero)
    fail(file, {}, name + " is an angle and " + text + " has no unit", "write " + text + " deg or " + text + " rad");
  if (wanted && zero) value.dimension = *wanted;
  return value;
}

namespace {

// Values for all that a situation leaves open, no two alike, so that no difference of them vanishes.
Settings some_values(const Situation& situation) {
  Settings settings;
  double size = 1;
  const auto next = [&](const Unit& unit) { return unit.factor * (size += 0.137); };
  for (const Letter& letter : situation.letters)
    settings[letter.name] = Value<double>::of_number(next(letter.unit), letter.unit.dimension);
  for (const Unknown& unknown : situation.find) {
    const double x = next(unknown.unit), y = next(unknown.unit), z = next(unknown.unit);
    settings[unknown.name] = value_of_unknown(unknown, {x, y, z}, situation.plane);
  }
  for (const Choice& choice : situation.choose) {
    std::vector<Value<double>> names;
    for (const std::string& name : choice.of) names.push_back(Value<double>::of_text(name));
    settings[choice.name] = Value<double>::of_list(std::move(names));
  }
  return settings;
}

}  // namespace

void check_every_datum(const Statement& statement) {
  // By place in the file: what is wrong in all situations so far; nothing once it makes sense in one.
  std::map<std::pair<int, int>, std::optional<StatementError>> faults;
  for (const Situation& situation : statement.situations) {
    const Settings settings = some_values(situation);
    DataScope<double> data(situation, settings);
    for (const auto* items : {&situation.given, &situation.points, &situation.directions})
      for (const NamedExpression& item : *items) {
        const std::pair place{item.mark.line, item.mark.column};
        try {
          data.value(item.value);
          faults[place].reset();
        } catch (const DomainError&) {
          faults[place].reset();
        } catch (const StatementError& error) {
          faults.try_emplace(place, error);
        }
      }
  }
  for (const auto& [place, fault] : faults)
    if (fault) throw StatementError(*fault);
}

Value<Dual<1>> as_variable(const Value<double>& value, std::size_t component) {
  Value<Dual<1>> varied = lifted<Dual<1>>(value);
  (value.is_vector() ? varied.vector[component] : varied.number).partial[0] = 1;
  return varied;
}

template <class Scalar>
DataScope<Scalar>::DataScope(const Situation& situation, const Settings& settings, Scalar time)
    : situation_(situation), settings_(settings), time_(std::move(time)) {}

template <class Scalar>
void DataScope<Scalar>::set_time(Scalar time) {
  if (follows_time_) {
    found_.clear();
    meanings_.clear();
  }
  follows_time_ = false;
  time_ = std::move(time);
}

template <class Scalar>
bool DataScope<Scalar>::knows(const std::string& name) const {
  return meanings_.contains(name) || find_unknown(situation_, name) || find_choice(situation_, name) ||
         name == "time" || name == "g" || settings_.contains(name) || find_named(situation_.given, name) ||
         find_letter(situation_, name) || find_named(situation_.points, name) ||
         find_named(situation_.directions, name) ||
         std::find(situation_.axes.begin(), situation_.axes.end(), name) != situation_.axes.end();
}

template <class Scalar>
Value<Scalar> DataScope<Scalar>::lookup(const NamedExpression& item, const char* what) {
  if (const auto found = found_.find(&item); found != found_.end()) return found->second;
  if (std::any_of(pending_.begin(), pending_.end(), [&](const Pending& pending) { return pending.item == &item; })) {
    std::string chain;
    for (const Pending& pending : pending_) chain += std::string(pending.what) + " " + pending.item->name + " -> ";
    fail(situation_.file, item.mark, "'" + item.name + "' is defined by itself: " + chain + what + " " + item.name);
  }
  pending_.push_back({what, &item});
  const struct Removed {
    std::vector<Pending>& list;
    ~Removed() { list.pop_back(); }
  } removed{pending_};
  Value<Scalar> value = evaluate(item.value, static_cast<Scope<Scalar>&>(*this), situation_.file);
  return found_.emplace(&item, std::move(value)).first->second;
}

template <class Scalar>
Value<Scalar> DataScope<Scalar>::name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  if (name.primes > 0)
    evaluator.fail(mark,
                   "'" + name.name + std::string(name.primes, '\'') + "' is a rate and cannot stand among the data",
                   "use it in instants:, define: or ask:");
  if (const auto known = meanings_.find(name.name); known != meanings_.end()) return known->second;
  Value<Scalar> value = meaning(name, mark, evaluator);
  if (name.name == "time")
    follows_time_ = true;
  else if (!find_named(situation_.directions, name.name))  // the root of its length may rest on a decision, noted anew
    meanings_.emplace(name.name, value);
  return value;
}

template <class Scalar>
Value<Scalar> DataScope<Scalar>::meaning(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  // A name may have only one meaning.
  std::array<const char*, 7> meanings{};
  std::size_t count = 0;
  const NamedExpression* datum = find_named(situation_.given, name.name);
  const Letter* letter = find_letter(situation_, name.name);
  const NamedExpression* point = find_named(situation_.points, name.name);
  const NamedExpression* direction = find_named(situation_.directions, name.name);
  const auto axis = std::find(situation_.axes.begin(), situation_.axes.end(), name.name);
  const Unknown* unknown = find_unknown(situation_, name.name);
  if (unknown) meanings[count++] = "an unknown";
  if (datum) meanings[count++] = "a datum under given:";
  if (letter) meanings[count++] = "a letter";
  if (point) meanings[count++] = "a point";
  if (direction) meanings[count++] = "a direction";
  if (axis != situation_.axes.end()) meanings[count++] = "an axis";
  if (name.name == "time") meanings[count++] = "the time";
  if (count > 1)
    evaluator.fail(mark, "'" + name.name + "' could mean " + meanings[0] + " or " + meanings[1], "rename one of them");
  const Choice* choice = find_choice(situation_, name.name);
  if (datum || letter || unknown || choice) {
    if (const auto varied = varied_.find(name.name); varied != varied_.end()) return varied->second;
    if (const auto set = settings_.find(name.name); set != settings_.end()) return lifted<Scalar>(set->second);
  }
  if (datum) return lookup(*datum, "given");
  if (letter) evaluator.fail(mark, "the letter '" + name.name + "' has no value");
  if (choice) evaluator.fail(mark, "'" + name.name + "' has not been chosen yet");
  if (unknown) evaluator.fail(mark, "the unknown '" + name.name + "' has no value yet");
  if (point) {
    Value<Scalar> value = lookup(*point, "point");
    if (value.is_vector() && !value.bare && !same_kind(value.dimension, dimensions::length))
      evaluator.fail(point->value.mark(),
                     "the coordinates of point '" + name.name + "' are " + to_string(value.dimension) + ", not lengths",
                     "check the units of the data in them");
    if (!value.is_vector() || !(same_kind(value.dimension, dimensions::length) || value.bare))
      evaluator.fail(point->value.mark(), "point '" + name.name + "' is no place",
                     situation_.plane ? "write two lengths: [x, y]"
                     : value.is_list() && value.items.size() == 2
                         ? "write three lengths: [x, y, z], or plane: [x, y] at the top if all moves in a plane"
                         : "write three lengths: [x, y, z]");
    if (value.bare && plain(norm_squared(value.vector)) != 0)
      evaluator.fail(point->value.mark(), "the coordinates of point '" + name.name + "' have no unit",
                     "write lengths with their unit, such as [3 m, 0, 0] or [3 ft, 0, 0]; data in them need one too");
    value.dimension = dimensions::length;
    return value;
  }
  if (direction) {
    Value<Scalar> value = lookup(*direction, "direction");
    if (!value.is_vector() || plain(norm_squared(value.vector)) == 0)
      evaluator.fail(direction->value.mark(), "direction '" + name.name + "' is no direction",
                     "write a vector that is not zero, such as A->B or [1, 2, 0]");
    return Value<Scalar>::of_vector(normalized(value.vector), dimensions::none);
  }
  if (axis != situation_.axes.end())
    return Value<Scalar>::of_vector(Vector3<Scalar>::unit(static_cast<std::size_t>(axis - situation_.axes.begin())),
                                    dimensions::none);
  if (name.name == "time") return Value<Scalar>::of_number(time_, dimensions::time);
  if (name.name == "g")
    return Value<Scalar>::of_number(decimal_value<Scalar>(standard_gravity, standard_gravity_digits),
                                    dimensions::acceleration);
  std::vector<std::string> known = settable_names(situation_);
  for (const auto* items : {&situation_.points, &situation_.directions})
    for (const NamedExpression& item : *items) known.push_back(item.name);
  known.insert(known.end(), situation_.axes.begin(), situation_.axes.end());
  const std::string hint = undefined_name_hint(name.name, known);
  evaluator.fail(mark, "'" + name.name + "' is not defined",
                 hint.empty() ? "define it under given:, letters:, points: or directions:" : hint);
}

template <class Scalar>
Value<Scalar> DataScope<Scalar>::call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  // A name that is near to a function's is a misspelt one; any other is a quantity, or was taken for one.
  if (describe_unknown_call(call, {}).hint.empty())
    evaluator.fail(mark, "'" + call.function + "(...)' cannot stand here: data are known before anything moves",
                   "quantities of bodies stand under instants:, define: and ask:; an unknown rate under find: and its "
                   "condition under instants:");
  evaluator.unknown_call(call, mark);
}

template <class Scalar>
Value<Scalar> DataScope<Scalar>::value(const Expression& expression) {
  return evaluate(expression, static_cast<Scope<Scalar>&>(*this), situation_.file);
}

template <class Scalar>
Scalar DataScope<Scalar>::number(const Expression& expression, const Dimension& dimension) {
  return Evaluator<Scalar>(*this, situation_.file).number(expression, dimension);
}

template <class Scalar>
Vector3<Scalar> DataScope<Scalar>::vector(const Expression& expression, const Dimension& dimension) {
  return Evaluator<Scalar>(*this, situation_.file).vector(expression, dimension);
}

template <class Scalar>
Vector3<Scalar> DataScope<Scalar>::place(const Expression& expression) {
  return vector(expression, dimensions::length);
}

template <class Scalar>
Vector3<Scalar> DataScope<Scalar>::direction(const Expression& expression) {
  const Unary* sign = expression.as<Unary>();
  const Name* place = (sign ? sign->operand : expression).template as<Name>();
  if (place && place->primes == 0 && find_named(situation_.points, place->name))
    fail(situation_.file, expression.mark(), "'" + place->name + "' is a place, not a direction",
         "write the direction to it, such as O->" + place->name);
  const Value<Scalar> value = this->value(expression);
  if (!value.is_vector())
    fail(situation_.file, expression.mark(), "expected a direction",
         "write an axis such as -y, A->B, or a list of three numbers");
  if (!(plain(norm_squared(value.vector)) > 0))
    fail(situation_.file, expression.mark(), "this direction has length zero",
         "its two points coincide, or all its components vanish");
  return normalized(value.vector);
}

template <class Scalar>
Scalar DataScope<Scalar>::gravity_size() {
  if (const NamedExpression* item = find_named(situation_.given, "g")) {
    Scalar g = number(name_expression("g", item->mark), dimensions::acceleration);
    if (!(plain(g) > 0))
      fail(situation_.file, item->mark, "g must be positive", "write gravity: none where nothing is pulled");
    constexpr double same_size = 1e-9;  // components of a tilted gravity may be stated to nine digits
    const List* vector = situation_.gravity ? situation_.gravity->as<List>() : nullptr;
    if (vector && vector->items.size() == 3) {
      const Value<Scalar> gravity = value(*situation_.gravity);
      if (gravity.is_vector() && !gravity.bare && same_kind(gravity.dimension, dimensions::acceleration) &&
          std::abs(plain(norm(gravity.vector)) - plain(g)) > same_size * plain(g))
        fail(situation_.file, situation_.gravity->mark(), "gravity and the g under given: differ in size",
             "state one of them, or gravity: -y");
    }
    return g;
  }
  if (const Letter* letter = find_letter(situation_, "g"))
    return number(name_expression("g", letter->mark), dimensions::acceleration);
  // If the file states the size of gravity, this is g.
  if (situation_.gravity) {
    const Name* word = situation_.gravity->as<Name>();
    if (!(word && word->name == "none")) {
      const Value<Scalar> gravity = value(*situation_.gravity);
      if (gravity.is_vector() && !gravity.bare && same_kind(gravity.dimension, dimensions::acceleration))
        return norm(gravity.vector);
    }
  }
  return decimal_value<Scalar>(standard_gravity, standard_gravity_digits);
}

template class DataScope<double>;
template class DataScope<Dual<1>>;
template class DataScope<TimeJet>;
template class DataScope<TimeJetOf<Dual<1>>>;
template class DataScope<Formula>;
template class DataScope<Dual<1, Formula>>;
template class DataScope<TimeJetOf<Formula>>;

}  // namespace poinsot::problem
