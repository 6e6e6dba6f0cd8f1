#include "problem/explanation/shown_numbers.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <random>

#include "problem/answers/read_settings.h"
#include "problem/entries/drawn_letters.h"
#include "problem/explanation/explanation_instant.h"
#include "problem/formulas/formula_answers.h"
#include "problem/language/expression_walk.h"
#include "problem/machine/data.h"

namespace poinsot::problem {
namespace {

constexpr int most_draws = 40;  // of open letters, until the statement makes sense
// The first of them are near the units; those after are the draws at which the statement was solved, one of which made
// sense.
constexpr int near_units = 8;

// Which of the lengths in letters is the how manieth largest. At first those with capitals are larger, as people write
// R and r, and those before others; then by chance.
std::vector<std::string> lengths_by_size(const std::vector<Letter>& letters, int attempt, std::mt19937_64& random) {
  std::vector<std::string> names;
  for (const Letter& letter : letters)
    if (letter.unit.dimension == dimensions::length && !letter.either_sign) names.push_back(letter.name);
  if (attempt == 0)
    std::ranges::stable_partition(
        names, [](const std::string& name) { return std::isupper(static_cast<unsigned char>(name.front())) != 0; });
  else
    std::ranges::shuffle(names, random);
  return names;
}

// The first values are nearly the units, and lengths are seen to differ; later ones are those that rigid bodies are
// likely to have.
std::map<std::string, double> alike_values(const std::vector<Letter>& letters, int attempt, std::mt19937_64& random) {
  constexpr int alike_draws = 8;
  if (attempt >= alike_draws) return draw_point(letters, 2 * (attempt - alike_draws) + 1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr double longest = 1.2, next = 0.75;  // of the unit; of the one before
  std::map<std::string, double> values;
  for (const Letter& letter : letters) {
    // A product of inertia, or an offset, is small beside moments and lengths.
    values[letter.name] = letter.unit.dimension == dimensions::angle
                              ? between(0.4, 0.8)
                              : letter.unit.factor * (letter.either_sign ? between(0.1, 0.3) : between(0.8, 1.25));
  }
  double size = longest;
  for (const std::string& name : lengths_by_size(letters, attempt, random)) {
    values[name] = size * std::ranges::find(letters, name, &Letter::name)->unit.factor;
    size *= next;
  }
  return values;
}

// The values at which the file itself says what its formulas should give: their author knows which proportions are
// usual. Empty where it gives no values for some letter.
std::map<std::string, double> values_of_author(const Statement& statement, const std::vector<Letter>& letters) {
  for (const ExpectedCase& one : statement.expected) try {
      const Settings settings = read_settings(statement, one.sets);
      std::map<std::string, double> values;
      for (const Letter& letter : letters)
        if (const auto set = settings.find(letter.name); set != settings.end() && set->second.is_number())
          values[letter.name] = set->second.number;
      if (values.size() == letters.size()) return values;
    } catch (const StatementError&) {
      // Values that are refused draw nothing.
    }
  return {};
}

// Whether a datum appears in formulas as a number, since it makes terms vanish (0, 90 deg) or is a count (2).
bool stays_number(double value, const Dimension& dimension) {
  if (value == 0) return true;
  if (dimension == dimensions::none) return value == std::round(value);
  const double steps = value / (std::numbers::pi / 2);
  constexpr double rounding = 1e-9;  // of a right angle that was stated in radians with nine digits
  return dimension == dimensions::angle && std::abs(steps - std::round(steps)) < rounding;
}

bool has_number(const SolvedAsk& ask) { return ask.state == AskState::found && ask.value.is_number(); }
// In letters, the same for all values of these.
bool has_one_formula(const SolvedAsk& ask) {
  return ask.state == AskState::needs_letters && ask.formula.has_value() && ask.formula->is_number() &&
         ask.regimes.size() <= 1;
}

bool letters_are_plain(const std::string& name) {
  return std::ranges::all_of(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

}  // namespace

ShownNumbers::ShownNumbers(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
                           const SolvedStatement& solved, std::size_t solution, LetterSizes sizes)
    : statement_(statement), solved_(solved), solution_(solved.solutions[solution]), sizes_(sizes) {
  settings_.assign(statement.situations.size(), read_settings(statement, sets));
  stated_ = settings_;
}

bool ShownNumbers::choose() {
  find_limits();
  if (choose_numbers()) return true;
  if (limits_.empty()) return false;
  limits_.clear();
  return choose_numbers();
}

// Finds the situations about which it is only asked how far something holds. They are explained at that limit.
void ShownNumbers::find_limits() {
  limits_.clear();
  for (std::size_t k = 0; k < statement_.asks.size(); ++k) {
    const Ask& ask = statement_.asks[k];
    const SolvedAsk& found = solution_.asks[k];
    if (!ask.extremum || !(has_number(found) || has_one_formula(found))) continue;
    const std::size_t situation = situation_of(statement_, ask);
    const std::string& name = statement_.situations[situation].name;
    const bool alone = std::none_of(statement_.asks.begin(), statement_.asks.end(), [&](const Ask& other) {
      if (&other == &ask) return false;
      if (other.extremum) return false;
      return name.empty() || names_situation(other, name);
    });
    // Of several limits it is the first.
    if (alone) limits_.emplace(situation, k);
  }
}

std::vector<std::string> ShownNumbers::open_letters(std::optional<std::size_t> situation) const {
  std::vector<std::string> names;
  for (const Letter& letter : solved_.open_letters) {
    // At its limit a letter has a value, unless others stand behind it.
    const auto limit = situation ? limits_.find(*situation) : limits_.end();
    if (limit != limits_.end() && statement_.asks[limit->second].extremum->name == letter.name &&
        has_number(solution_.asks[limit->second]))
      continue;
    names.push_back(letter.name);
  }
  return names;
}

// Gives what is moved to a limit its value there. Returns false where a letter would not be positive, as all are: the
// limit is found for other values of the letters.
bool ShownNumbers::set_limits() {
  for (const auto& [at, ask] : limits_) {
    const SolvedAsk& limit = solution_.asks[ask];
    const std::string& name = statement_.asks[ask].extremum->name;
    const Value<double> value =
        has_number(limit) ? limit.value
                          : Value<double>::of_number(value_at(limit.formula->number, drawn_), limit.formula->dimension);
    const auto letter = std::ranges::find(situation(at).letters, name, &Letter::name);
    if (letter != situation(at).letters.end() && !letter->either_sign && letter->unit.dimension != dimensions::angle &&
        !(value.number > 0))
      return false;
    settings_[at][name] = value;
  }
  return true;
}

// Chooses the numbers of the solution: settings, the unknowns found, and values of open letters until everything can be
// solved.
bool ShownNumbers::choose_numbers() {
  const std::map<std::string, double> of_author = sizes_ == LetterSizes::alike && !solved_.open_letters.empty()
                                                      ? values_of_author(statement_, solved_.open_letters)
                                                      : std::map<std::string, double>{};
  for (int attempt = of_author.empty() ? 0 : -1; attempt < (solved_.open_letters.empty() ? 1 : most_draws); ++attempt) {
    settings_ = stated_;
    drawn_ = attempt < 0 ? of_author : drawn_values(attempt);
    for (const Letter& letter : solved_.open_letters)
      for (Settings& one : settings_)
        one[letter.name] = Value<double>::of_number(drawn_.at(letter.name), letter.unit.dimension);
    try {
      if (!set_unknowns(drawn_)) return false;
      if (!set_limits()) continue;
      sample_ = std::make_unique<Sample>(statement_, settings_, OpenChoice{});
      questions_ = questions_of(statement_, *sample_, solution_, limits_);
      for (auto one = questions_.instants.begin(); one != questions_.instants.end();) {
        const auto& [home, questions] = *one;
        try {
          SolvedInstant& instant = sample_->instant(home);
          if (wants_forces(home, questions)) instant.solve_forces();
          ++one;
        } catch (const StatementError&) {
          // Where squares are neglected the equations hold up to these.
          if (situation(home.situation).neglect.empty()) throw;
          one = questions_.instants.erase(one);
        }
      }
      // Where nothing is asked, what is stated has at least a beginning.
      if (statement_.asks.empty()) sample_->instant(sample_->start_of(0));
      return true;
    } catch (const StatementError&) {
      if (solved_.open_letters.empty()) return false;
    }
  }
  return false;
}

std::map<std::string, double> ShownNumbers::drawn_values(int attempt) const {
  const int solved_draw = attempt - near_units;
  const auto draw = static_cast<std::uint64_t>(solved_draw < 0 ? attempt : solved_draw);
  std::mt19937_64 random((solved_draw < 0 ? 7000 : seed_of_draws) + draw);
  if (sizes_ == LetterSizes::alike) return alike_values(solved_.open_letters, attempt, random);
  std::map<std::string, double> values;
  for (const Letter& letter : solved_.open_letters)
    values[letter.name] = drawn_letter(letter, random, std::max(solved_draw, 0));
  return values;
}

bool ShownNumbers::set_unknowns(const std::map<std::string, double>& letters) {
  for (const SolvedUnknown& unknown : solution_.unknowns) {
    Value<double> value = unknown.value;
    if (unknown.formula) {
      if (!unknown.formula->is_number()) return false;
      value = Value<double>::of_number(value_at(unknown.formula->number, letters), unknown.unit.dimension);
    }
    for (std::size_t i = 0; i < settings_.size(); ++i)
      if (unknown.is_of(i)) settings_[i][unknown.own_name] = value;
  }
  // If an unknown has no answer there are no numbers.
  for (std::size_t i = 0; i < settings_.size(); ++i)
    for (const Unknown& unknown : situation(i).find)
      if (!settings_[i].contains(unknown.name)) return false;
  return true;
}

bool ShownNumbers::wants_forces(const Sample::Home& home, const InstantQuestions& questions) const {
  const Situation& stated = situation(home.situation);
  const bool after = stated.has_blow() && home.instant == 1 && !home.time;
  return !after && (questions.asks_forces() || stated.steady);
}

FormulaValues ShownNumbers::formula_values(std::size_t situation, Situation& lettered, LetterValues& point) const {
  FormulaValues values;
  const Settings& settings = settings_[situation];
  const auto add = [&](const std::string& name, double value, const Dimension& dimension, bool real) {
    if (stays_number(value, dimension)) return;
    point[name] = value;
    values[name] = Value<Formula>::of_number(
        Formula::letter(name, real || value < 0 ? poinsot::Sign::real : poinsot::Sign::positive), dimension);
  };
  const bool has_g = std::any_of(lettered.given.begin(), lettered.given.end(),
                                 [](const NamedExpression& item) { return item.name == "g"; }) ||
                     std::any_of(lettered.letters.begin(), lettered.letters.end(),
                                 [](const Letter& letter) { return letter.name == "g"; }) ||
                     settings.contains("g");
  if (!has_g && lettered.gravity)
    lettered.given.push_back(
        {"g", built(Number{standard_gravity, si_unit(dimensions::acceleration), true, "9.80665 m/s^2"}, Mark{}), {}});
  for (const NamedExpression& item : lettered.given) {
    if (settings.contains(item.name)) continue;
    const Unary* minus = item.value.as<Unary>();
    const Number* number = minus ? minus->operand.as<Number>() : item.value.as<Number>();
    if (!number) continue;
    add(item.name, (minus && minus->sign == '-' ? -1 : 1) * number->value * number->unit.factor, number->unit.dimension,
        number->unit.dimension == dimensions::angle);
  }
  for (const auto& [name, value] : settings) {
    if (const auto sought = std::ranges::find(lettered.find, name, &Unknown::name);
        value.is_vector() && sought != lettered.find.end()) {
      Vector3<Formula> letters{Formula(0), Formula(0), Formula(0)};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string component = component_letter(lettered, name, k);
        if (value.vector[k] == 0) continue;
        point[component] = value.vector[k];
        letters[k] = Formula::letter(component, poinsot::Sign::real);
      }
      values[name] = Value<Formula>::of_vector(letters, value.dimension);
    }
    if (!value.is_number()) continue;
    const auto letter = std::find_if(lettered.letters.begin(), lettered.letters.end(),
                                     [&, wanted = name](const Letter& l) { return l.name == wanted; });
    const bool open = std::any_of(solved_.open_letters.begin(), solved_.open_letters.end(),
                                  [&, wanted = name](const Letter& l) { return l.name == wanted; });
    if (open || letter != lettered.letters.end()) {
      values[name] = formula_of(*letter);
      point[name] = value.number;
    } else {
      add(name, value.number, value.dimension, value.dimension == dimensions::angle);
    }
    // A datum that is set to a special value stays a number.
    if (!values.contains(name)) values[name] = Value<Formula>::of_number(Formula(value.number), value.dimension);
  }
  return values;
}

std::vector<std::string> letters_of_any_masses(Situation& lettered, FormulaValues& values, LetterValues& point) {
  std::vector<std::string> letters;
  const auto is_any = [](const Body& body) {
    const Name* name = body.amount.mass ? body.amount.mass->as<Name>() : nullptr;
    return name && name->name == "any" && body.added.empty();
  };
  const auto several = std::ranges::count_if(lettered.bodies, is_any) > 1;
  for (Body& body : lettered.bodies) {
    if (!is_any(body)) continue;
    const std::string letter = several || values.contains("m") ? "m_" + body.name : "m";
    if (values.contains(letter) || !letters_are_plain(letter)) continue;
    body.amount.mass = built(Name{letter}, body.amount.mass->mark());
    lettered.given.push_back({letter, built(Number{1, si_unit(dimensions::mass), true, "1 kg"}, Mark{}), {}});
    values[letter] = Value<Formula>::of_number(Formula::letter(letter, poinsot::Sign::positive), dimensions::mass);
    point[letter] = 1;
    letters.push_back(letter);
  }
  return letters;
}

}  // namespace poinsot::problem
