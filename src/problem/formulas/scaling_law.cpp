#include "problem/formulas/scaling_law.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/law_ratio.h"
#include "problem/formulas/law_shape.h"
#include "problem/formulas/law_sums.h"
#include "problem/formulas/letter_dimensions.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace {

constexpr int most_digits = 12;  // of the numbers in a law
constexpr int least_digits = 6;  // with fewer digits a law cannot be told from a coincidence
// The measured error of a motion may be this much smaller than the actual one.
constexpr double measured_over_actual = 16;
constexpr double noise = 1e-9;             // size below which a component counts as zero beside its vector
constexpr double exponent_to = 1e-4;       // how close a measured exponent must be to a multiple of one half
constexpr std::size_t least_around = 10;   // points for a sum, which has three coefficients at most
constexpr std::size_t least_along = 12;    // points for a quotient of polynomials, which may have eight coefficients
constexpr double ratio_tolerance = 1e-10;  // of numbers that follow such a quotient
constexpr std::size_t least_samples = 6;   // values of an angle at which an answer must exist

std::vector<double> all_numbers(const Value<double>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<double> all;
  for (const Value<double>& item : value.items)
    for (const double number : all_numbers(item)) all.push_back(number);
  return all;
}

void put_in(Value<Formula>& value, const std::vector<Formula>& numbers, std::size_t& next) {
  if (value.is_number()) value.number = numbers[next++];
  for (std::size_t k = 0; value.is_vector() && k < 3; ++k) value.vector[k] = numbers[next++];
  for (Value<Formula>& item : value.items) put_in(item, numbers, next);
}

Value<Formula> shaped_like(const Value<double>& value) {
  if (value.is_number()) return Value<Formula>::of_number({}, value.dimension);
  if (value.is_vector()) return Value<Formula>::of_vector({}, value.dimension);
  std::vector<Value<Formula>> items;
  for (const Value<double>& item : value.items) items.push_back(shaped_like(item));
  return Value<Formula>::of_list(std::move(items));
}

// What is looked at in place of an angle: how far a pendulum swings follows from the cosine.
enum class Seen { itself, cosine, tangent, versine, sine };

double seen(Seen as, double angle) {
  switch (as) {
    case Seen::cosine:
      return std::cos(angle);
    case Seen::tangent:
      return std::tan(angle);
    case Seen::versine:
      return 2 * std::pow(std::sin(angle / 2), 2);
    case Seen::sine:
      return std::sin(angle);
    case Seen::itself:
      break;
  }
  return angle;
}
Formula angle_of(Seen as, const Formula& value) {
  switch (as) {
    case Seen::cosine:
      return acos(value);
    case Seen::tangent:
      return atan(value);
    case Seen::versine:
      return acos(Formula(1) - value);
    case Seen::sine:
      return asin(value);
    case Seen::itself:
      break;
  }
  return value;
}

// Finds the law of one number of an answer.
class OneNumber {
 public:
  OneNumber(ScalingTrials& trials, std::size_t answer, std::size_t place, const Dimension& dimension,
            const std::vector<std::string>& letters, Seen as, ScalingLaw& law)
      : trials_(trials), answer_(answer), place_(place), dimension_(dimension), as_(as), law_(law) {
    for (const Letter& letter : trials.letters()) {
      if (std::ranges::find(letters, letter.name) == letters.end()) continue;
      (letter.unit.dimension == dimensions::angle ? angles_ : sizes_).push_back(letter);
    }
    tolerance_ = std::max(1e-8, 4 * trials.error());
  }

  Formula formula() {
    if (vanishes()) return {};
    for (const Letter& letter : sizes_)
      if (letter.either_sign) throw NoFormula("'" + letter.name + "' may have either sign");
    find_units();
    try {
      return product();
    } catch (const NoFormula&) {
      for (const auto road : {&OneNumber::as_sum, &OneNumber::by_factors}) {
        std::optional<Formula> found;
        static_cast<void>(why_no_formula([&] { found = (this->*road)(); }));
        if (found) return *found;
      }
      throw;
    }
  }

 private:
  // A product of powers of letters and functions of angles.
  Formula product() {
    dimensions_.emplace(sizes_, units_);
    halves_.assign(sizes_.size(), 0);
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      if (!dimensions_->is_pivot(i)) measure(i);
    follow_dimensions();
    for (const Letter& angle : angles_) follow(angle.name);
    return with_numbers();
  }

  // A sum of such products, or its root, as it is around the base.
  std::optional<Formula> as_sum() {
    shape_ = {};
    std::vector<Letter> letters = sizes_;
    letters.insert(letters.end(), angles_.begin(), angles_.end());
    return sum_of(letters, dimension_);
  }
  std::optional<Formula> sum_of(const std::vector<Letter>& letters, const Dimension& dimension) {
    SumSamples samples;
    for (const ScalingTrials::Point& point : trials_.around()) {
      const std::optional<double> number = at(point);
      // Beyond a bound there may be none, as where nothing swings.
      if (!number || *number == 0) continue;
      samples.letters.push_back(point.letters);
      samples.numbers.push_back(*number / shape_.product_at(point.letters));
    }
    if (samples.numbers.size() < least_around) return std::nullopt;
    const std::optional<SumLaw> sum =
        sum_law(letters, dimension, units_, samples, tolerance_, trials_.error() / measured_over_actual);
    if (!sum) return std::nullopt;
    for (const Letter& letter : letters) law_.by_trial.push_back(letter.name);
    law_.digits = law_.digits == 0 ? sum->digits : std::min(law_.digits, sum->digits);
    return sum->formula;
  }

  // The factors that follow a letter alone, times a sum, or a quotient of polynomials, in what the others make.
  std::optional<Formula> by_factors() {
    shape_ = {};
    std::vector<Letter> others;
    Dimension left = dimension_;
    for (const Letter& letter : sizes_) {
      const std::optional<int> halves = measured_exponent(letter.name);
      const std::optional<Dimension> part = halves ? power(letter.unit.dimension, *halves, 2) : std::nullopt;
      if (!part)
        others.push_back(letter);
      else if (*halves != 0)
        shape_.product.push_back({letter.name, Factor::letter, *halves});
      if (part) left = left / *part;
    }
    std::vector<Letter> sizes = others;
    for (const Letter& angle : angles_)
      if (const auto parts = product_of(angle.name, samples_along(angle.name), tolerance_))
        shape_.product.insert(shape_.product.end(), parts->begin(), parts->end());
      else
        others.push_back(angle);
    if (sizes.empty()) return std::nullopt;
    std::optional<Formula> rest;
    if (others.size() < sizes_.size() + angles_.size()) rest = sum_of(others, left);
    if (!rest && others.size() == sizes.size()) rest = as_ratio(sizes, left);
    if (!rest) return std::nullopt;
    for (const LawShape::Part& part : shape_.product) law_.by_trial.push_back(part.letter);
    return *rest * formula_of_product();
  }

  // A quotient of polynomials in the one number without dimension that letters make, its root, or one of the curves of
  // it that drag makes.
  std::optional<Formula> as_ratio(const std::vector<Letter>& letters, const Dimension& dimension) {
    const LetterDimensions dimensions(letters, units_);
    if (letters.size() != dimensions.pivots().size() + 1) return std::nullopt;
    std::size_t i = 0;
    while (dimensions.is_pivot(i)) ++i;
    LawShape group, product;
    const auto add_pivots = [&](LawShape& shape, const std::vector<double>& exponents, double times) {
      for (std::size_t k = 0; k < exponents.size(); ++k) {
        const double halves = 2 * times * exponents[k];
        if (std::abs(halves - std::round(halves)) > exponent_to) return false;
        if (std::lround(halves) != 0)
          shape.product.push_back(
              {letters[dimensions.pivots()[k]].name, Factor::letter, static_cast<int>(std::lround(halves))});
      }
      return true;
    };
    const std::vector<double> of_group = dimensions.exponents(letters[i].unit.dimension);
    // Of a root the square is taken: polynomials in it have the root too.
    const bool roots =
        std::ranges::any_of(of_group, [](double one) { return std::abs(one - std::round(one)) > exponent_to; });
    group.product.push_back({letters[i].name, Factor::letter, roots ? 4 : 2});
    if (!add_pivots(group, of_group, roots ? -2 : -1) || !add_pivots(product, dimensions.exponents(dimension), 1))
      return std::nullopt;
    RatioSamples samples;
    for (const ScalingTrials::Point& point : trials_.along(letters[i].name))
      if (const std::optional<double> number = at(point)) {
        samples.x.push_back(group.product_at(point.letters));
        samples.numbers.push_back(*number / (shape_.product_at(point.letters) * product.product_at(point.letters)));
      }
    if (samples.x.size() < least_along) return std::nullopt;
    const Formula x = formula_of_product(group);
    const double tolerance = std::max(ratio_tolerance, 4 * trials_.error());
    std::optional<RatioLaw> law = ratio_law(x, samples, tolerance);
    if (!law) law = curve_law(x, samples, tolerance);
    if (!law) return std::nullopt;
    for (const Letter& letter : letters) law_.by_trial.push_back(letter.name);
    law_.digits = law_.digits == 0 ? law->digits : std::min(law_.digits, law->digits);
    return law->formula * formula_of_product(product);
  }

  // The number at a point; zero if it is rounding beside the other numbers of its answer.
  std::optional<double> at(const ScalingTrials::Point& point) const {
    const std::optional<Value<double>>& value = point.answers[answer_];
    if (!value) return std::nullopt;
    const std::vector<double> numbers = all_numbers(*value);
    if (place_ >= numbers.size() || !std::isfinite(numbers[place_])) return std::nullopt;
    return seen(as_, std::abs(numbers[place_]) <= noise * size_of(*value) ? 0 : numbers[place_]);
  }
  double at_base() const {
    const std::optional<double> number = at(trials_.base());
    if (!number) throw NoFormula("it is found by numbers, and not found twice");
    return *number;
  }
  bool vanishes() {
    if (at_base() != 0) return false;
    const auto everywhere = [&](const std::vector<ScalingTrials::Point>& points) {
      return std::ranges::all_of(points, [&](const ScalingTrials::Point& point) { return at(point).value_or(1) == 0; });
    };
    if (!everywhere(trials_.drawn()) && !everywhere(trials_.around()))
      throw NoFormula("it vanishes for some values of the letters only");
    return true;
  }

  // Finds the units that nothing in the problem fixes: if they are changed, the number remains the same quantity.
  void find_units() {
    for (const Units units : {Units::length, Units::mass, Units::time, Units::fall}) {
      // If gravity is given by a number, lengths and times can be changed only together.
      if (units == Units::fall && (is_free(Units::length) || is_free(Units::time))) continue;
      const auto& [scale, point] = trials_.scaled(units);
      const std::optional<double> number = at(point);
      if (!number) continue;
      const double expected = at_base() * std::pow(scale, exponent_of(dimension_, units));
      if (std::abs(*number - expected) <= tolerance_ * std::abs(expected)) units_.push_back(units);
    }
  }
  bool is_free(Units units) const { return std::ranges::find(units_, units) != units_.end(); }

  // Finds the exponent of a letter, times two, from points at which it alone has other values; nothing if it has none.
  std::optional<int> measured_exponent(const std::string& name) {
    std::optional<int> found;
    for (const ScalingTrials::Point& point : trials_.moved(name)) {
      const std::optional<double> number = at(point);
      if (!number) continue;
      if (!(*number / at_base() > 0)) return std::nullopt;
      const double slope = std::log(*number / at_base()) / std::log(point.letters.at(name) / base_value(name));
      const int halves = static_cast<int>(std::lround(2 * slope));
      if (std::abs(2 * slope - halves) > exponent_to || found.value_or(halves) != halves) return std::nullopt;
      found = halves;
    }
    if (!found) throw NoFormula("it is found by numbers, and only where '" + name + "' has certain values");
    return found;
  }
  void measure(std::size_t i) {
    const std::optional<int> halves = measured_exponent(sizes_[i].name);
    if (!halves) throw NoFormula(no_power(i));
    halves_[i] = *halves;
    law_.by_trial.push_back(sizes_[i].name);
  }
  double base_value(const std::string& letter) const { return trials_.base().letters.at(letter); }

  std::string no_power(std::size_t i) const {
    const std::vector<double> exponents = dimensions_->exponents(sizes_[i].unit.dimension);
    Formula group = formula_of(sizes_[i]).number;
    for (std::size_t k = 0; k < exponents.size(); ++k)
      group *= power_of(formula_of(sizes_[dimensions_->pivots()[k]]).number,
                        static_cast<int>(std::lround(-2 * exponents[k])));
    return "it depends on " + text(group) + ", and not as a power of it";
  }

  void follow_dimensions() {
    Dimension rest = dimension_;
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      if (const auto part = power(sizes_[i].unit.dimension, halves_[i], 2)) rest = rest / *part;
    const std::vector<double> exponents = dimensions_->exponents(rest);
    for (std::size_t k = 0; k < exponents.size(); ++k) {
      const std::size_t pivot = dimensions_->pivots()[k];
      halves_[pivot] = static_cast<int>(std::lround(2 * exponents[k]));
      if (std::abs(2 * exponents[k] - halves_[pivot]) > exponent_to)
        throw NoFormula("'" + sizes_[pivot].name + "' has an exponent that is neither whole nor a half");
      law_.by_dimension.push_back(sizes_[pivot].name);
    }
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      if (halves_[i] != 0) shape_.product.push_back({sizes_[i].name, Factor::letter, halves_[i]});
  }

  // The numbers at points at which an angle alone has other values.
  AngleSamples samples_along(const std::string& angle) {
    AngleSamples samples;
    const auto add = [&](const ScalingTrials::Point& point) {
      const std::optional<double> number = at(point);
      if (!number) return;
      samples.angles.push_back(point.letters.at(angle));
      samples.numbers.push_back(*number);
    };
    for (const ScalingTrials::Point& point : trials_.moved(angle)) add(point);
    add(trials_.base());
    if (samples.angles.size() < least_samples)
      throw NoFormula("it is found by numbers, and only where '" + angle + "' has certain values");
    return samples;
  }
  // Finds the dependence on an angle.
  void follow(const std::string& angle) {
    const AngleSamples samples = samples_along(angle);
    law_.by_trial.push_back(angle);
    if (const auto parts = product_of(angle, samples, tolerance_)) {
      shape_.product.insert(shape_.product.end(), parts->begin(), parts->end());
    } else if (const auto term = term_of(samples, tolerance_); term && shape_.term == Term::none) {
      shape_.term = *term;
      shape_.angle = angle;
    } else {
      throw NoFormula("it depends on " + angle + ", but as no product of powers, sines and cosines of it");
    }
  }

  // Finds the numbers of the law from all points tried, which must agree on them.
  Formula with_numbers() {
    std::vector<std::pair<double, double>> measured;  // the term and the number over the product
    const auto add = [&](const ScalingTrials::Point& point) {
      if (const std::optional<double> number = at(point))
        measured.emplace_back(shape_.term == Term::none ? 0 : number_of(shape_.term, point.letters.at(shape_.angle)),
                              *number / shape_.product_at(point.letters));
    };
    add(trials_.base());
    if (shape_.term != Term::none)
      for (const ScalingTrials::Point& point : trials_.moved(shape_.angle)) add(point);
    const std::size_t before = measured.size();
    for (const ScalingTrials::Point& point : trials_.drawn()) add(point);
    if (measured.size() < before + trials_.drawn().size())
      throw NoFormula("it has no value at other values of the letters");
    const bool sum = shape_.term != Term::none;
    double first = measured.front().second, slope = 0;
    if (sum) {
      const auto [low, high] = std::minmax_element(measured.begin(), measured.end());
      slope = (high->second - low->second) / (high->first - low->first);
      first = low->second - slope * low->first;
    }
    const double size = std::max(std::abs(first), std::abs(slope));
    double spread = 0;
    for (const auto& [term, number] : measured)
      spread = std::max(spread, std::abs(first + slope * term - number) / size);
    if (!(spread <= tolerance_)) throw NoFormula("its letters do not come together as a product of powers");
    const double error = std::max({spread, trials_.error() / measured_over_actual, 1e-15});
    const int digits = std::min(most_digits, static_cast<int>(std::floor(-std::log10(error))));
    if (digits < least_digits) throw NoFormula("the motion is not known closely enough to tell a law from it");
    law_.digits = law_.digits == 0 ? digits : std::min(law_.digits, digits);
    return written(first, slope, size, digits);
  }
  Formula written(double first, double slope, double size, int digits) const {
    const auto letter = [&](const std::string& name) { return formula_of(trials_.letter(name)).number; };
    // Numbers that all points have in common, as the end of a search, may be off by more than these differ.
    constexpr double off_in_common = 1e-11;
    const double tolerance = std::max(3 * std::pow(10.0, -digits), off_in_common);
    const auto number = [&](double x) {
      constexpr double seen = 1e-6;  // of the larger number: what is less has too few digits to be told
      const std::optional<Formula> known =
          std::abs(x) > seen * size ? known_coefficient(x, tolerance * size / std::abs(x)) : std::nullopt;
      return known ? *known : rounded(x, size, digits);
    };
    Formula result = number(first);
    if (shape_.term != Term::none) result += number(slope) * formula_of(shape_.term, letter(shape_.angle));
    return result * formula_of_product();
  }
  Formula formula_of_product() const { return formula_of_product(shape_); }
  Formula formula_of_product(const LawShape& shape) const {
    Formula result(1);
    for (const LawShape::Part& part : shape.product)
      result *= power_of(formula_of(part.factor, formula_of(trials_.letter(part.letter)).number), part.halves);
    return result;
  }

  ScalingTrials& trials_;
  const std::size_t answer_, place_;
  const Dimension dimension_;
  const Seen as_;
  ScalingLaw& law_;
  std::vector<Letter> sizes_, angles_;  // all letters but angles; the angles
  double tolerance_ = 1e-8;
  std::vector<Units> units_;
  std::optional<LetterDimensions> dimensions_;  // of sizes_
  std::vector<int> halves_;                     // the exponents of sizes_, times two
  LawShape shape_;
};

Formula law_of_number(ScalingTrials& trials, std::size_t answer, std::size_t place, const Dimension& dimension,
                      const std::vector<std::string>& letters, ScalingLaw& law) {
  const ScalingLaw before = law;
  try {
    return OneNumber(trials, answer, place, dimension, letters, Seen::itself, law).formula();
  } catch (const NoFormula&) {
    if (dimension != dimensions::angle) throw;
    for (const Seen as : {Seen::cosine, Seen::tangent, Seen::versine, Seen::sine}) {
      law = before;
      std::optional<Formula> found;
      static_cast<void>(why_no_formula([&] {
        found = angle_of(as, OneNumber(trials, answer, place, dimensions::none, letters, as, law).formula());
      }));
      if (found) return *found;
    }
    law = before;
    throw;
  }
}

}  // namespace

ScalingLaw scaling_law(ScalingTrials& trials, std::size_t answer, const std::vector<std::string>& letters) {
  const std::optional<Value<double>>& value = trials.base().answers.at(answer);
  if (!value) throw NoFormula("it is found by numbers, and not found twice");
  ScalingLaw law;
  const std::size_t count = all_numbers(*value).size();
  std::vector<Formula> numbers;
  for (std::size_t place = 0; place < count; ++place)
    numbers.push_back(law_of_number(trials, answer, place, dimension_of(*value), letters, law));
  law.formula = shaped_like(*value);
  std::size_t next = 0;
  put_in(law.formula, numbers, next);
  for (std::vector<std::string>* names : {&law.by_dimension, &law.by_trial}) {
    std::ranges::sort(*names);
    names->erase(std::unique(names->begin(), names->end()), names->end());
  }
  return law;
}

}  // namespace poinsot::problem
