#include "problem/formulas/scaling_trials.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t draws = 3;
constexpr std::size_t points_around = 16, most_tried_around = 3 * points_around;
constexpr int points_along = 14;
constexpr int most_attempts = 12;
constexpr const char* nowhere_else = "no other values of the letters were found at which the statement makes sense";

}  // namespace

double exponent_of(const Dimension& dimension, Units units) {
  switch (units) {
    case Units::length:
      return dimension.length / 12.0;
    case Units::mass:
      return dimension.mass / 12.0;
    case Units::time:
      return dimension.time / 12.0;
    case Units::fall:
      break;
  }
  return (2 * dimension.length + dimension.time) / 24.0;
}

const std::vector<ScalingTrials::Point>& ScalingTrials::Known::get(const std::function<std::vector<Point>()>& find) {
  if (refused_) throw NoFormula(*refused_);
  if (points_) return *points_;
  try {
    points_ = find();
  } catch (const NoFormula& reason) {
    refused_ = reason.what();
    throw;
  }
  return *points_;
}

ScalingTrials::ScalingTrials(std::vector<Letter> letters, LetterValues base, bool near, double error, Solve solve)
    : letters_(std::move(letters)),
      base_letters_(std::move(base)),
      near_(near),
      error_(error),
      solve_(std::move(solve)) {}

const Letter& ScalingTrials::letter(const std::string& name) const {
  return *std::ranges::find(letters_, name, &Letter::name);
}

std::optional<ScalingTrials::Point> ScalingTrials::tried(const LetterValues& letters) const {
  try {
    return Point{letters, solve_(letters)};
  } catch (const StatementError&) {
    return std::nullopt;
  }
}

const ScalingTrials::Point& ScalingTrials::base() {
  if (!base_) base_ = tried(base_letters_);
  if (!base_) throw NoFormula("it is found by numbers, and not found twice");
  return *base_;
}

const std::pair<double, ScalingTrials::Point>& ScalingTrials::scaled(Units units) {
  if (const auto known = scaled_.find(units); known != scaled_.end()) return known->second;
  for (const double scale : {1.37, 0.81, 1.13}) {
    LetterValues letters = base_letters_;
    for (const Letter& letter : letters_)
      letters[letter.name] *= std::pow(scale, exponent_of(letter.unit.dimension, units));
    if (std::optional<Point> point = tried(letters)) return scaled_[units] = {scale, std::move(*point)};
  }
  throw NoFormula(nowhere_else);
}

std::vector<double> ScalingTrials::values_to_try(const Letter& letter) const {
  const double base = base_letters_.at(letter.name);
  if (letter.unit.dimension != dimensions::angle)
    return near_ ? std::vector{0.87 * base, 1.19 * base} : std::vector{0.61 * base, 1.73 * base};
  std::vector<double> values{0.21, 0.37, 0.52, 0.68, 0.84, 0.99, 1.17};
  if (near_)
    for (double& value : values) value = base * (0.8 + 0.45 * (value - 0.21));
  return values;
}

const std::vector<ScalingTrials::Point>& ScalingTrials::moved(const std::string& name) {
  return moved_[name].get([&] {
    std::vector<Point> points;
    for (const double value : values_to_try(letter(name))) {
      LetterValues letters = base_letters_;
      letters[name] = value;
      if (std::optional<Point> point = tried(letters)) points.push_back(std::move(*point));
    }
    // So far away there may be no such body.
    if (points.empty() && !near_ && letter(name).unit.dimension != dimensions::angle)
      for (const double part : {0.87, 1.19}) {
        LetterValues letters = base_letters_;
        letters[name] *= part;
        if (std::optional<Point> point = tried(letters)) points.push_back(std::move(*point));
      }
    return points;
  });
}

const std::vector<ScalingTrials::Point>& ScalingTrials::along(const std::string& name) {
  return along_[name].get([&] {
    std::vector<Point> points;
    const double widest = near_ ? 1.25 : 3;
    for (int n = 0; n < points_along; ++n) {
      LetterValues letters = base_letters_;
      letters[name] *= std::pow(widest, 2.0 * n / (points_along - 1) - 1);
      if (std::optional<Point> point = tried(letters)) points.push_back(std::move(*point));
    }
    return points;
  });
}

const std::vector<ScalingTrials::Point>& ScalingTrials::turned(const std::string& angle) {
  return turned_[angle].get([&] {
    std::vector<Point> points;
    if (near_) return points;
    for (const std::vector<double>& away : {std::vector{1.45, 1.75, 2.3, 2.9}, {-0.6, -2.0}}) {
      bool given_up = false;
      for (const double value : away) {
        Point point{base_letters_, {}};
        point.letters[angle] = value;
        try {
          if (!given_up) point.answers = solve_(point.letters);
          // What lacks one answer may have the others.
          bool some = point.answers.empty();
          for (std::size_t i = 0; i < point.answers.size(); ++i) some = some || (base().answers[i] && point.answers[i]);
          given_up = given_up || !some;
        } catch (const StatementError&) {
          continue;
        } catch (const NoFormula&) {
          given_up = true;
        }
        points.push_back(std::move(point));
      }
    }
    return points;
  });
}

const std::vector<ScalingTrials::Point>& ScalingTrials::drawn() {
  return drawn_.get([&] {
    std::vector<Point> points;
    std::mt19937_64 random(7000);
    for (int attempt = 0; attempt < 2 * most_attempts && points.size() < draws; ++attempt) {
      // Where nothing was found all over the sizes of the units, it is sought near the first values.
      const bool near = near_ || attempt >= most_attempts;
      LetterValues letters = base_letters_;
      for (const Letter& letter : letters_) {
        double& value = letters[letter.name];
        const double part = std::uniform_real_distribution<double>(0, 1)(random);
        if (near)
          value *= 0.85 + 0.35 * part;
        else
          value = letter.unit.dimension == dimensions::angle ? 0.2 + part : letter.unit.factor * (0.5 + 1.5 * part);
      }
      if (std::optional<Point> point = tried(letters)) points.push_back(std::move(*point));
    }
    if (points.size() < draws) throw NoFormula(nowhere_else);
    return points;
  });
}

const std::vector<ScalingTrials::Point>& ScalingTrials::around() {
  return around_.get([&] {
    std::vector<Point> points;
    std::mt19937_64 random(7100);
    for (std::size_t n = 0; n < most_tried_around && points.size() < points_around; ++n) {
      LetterValues letters = base_letters_;
      for (const Letter& letter : letters_)
        letters[letter.name] *= 1 + std::uniform_real_distribution<double>(-1, 1)(random) / 7;
      if (std::optional<Point> point = tried(letters)) points.push_back(std::move(*point));
    }
    if (points.size() < points_around) throw NoFormula(nowhere_else);
    return points;
  });
}

}  // namespace poinsot::problem
