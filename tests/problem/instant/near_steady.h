// Tops and what a problem file says of the motion near a steady one, for the tests of stability.
#pragma once

#include "problem/entries/random_problems.h"

namespace poinsot::problem::testing {

// The answers to `s: stable(B), g: growth_rate(B), f: frequencies(B)`, `P` where that is to be found, and `N`.
struct Near {
  bool stable = false;
  double growth = 0, unknown = 0, push = 0;
  std::vector<double> frequencies;

  bool swings_at(double frequency) const {
    return std::any_of(frequencies.begin(), frequencies.end(),
                       [&](double f) { return std::abs(f - frequency) <= 1e-5 * frequency; });
  }
  std::string list() const {
    std::string all = " among";
    for (double f : frequencies) all += fmt::format(" {:.9g}", f);
    return all + "\n";
  }
};

// One for each solution.
inline std::vector<Near> solved_near(const std::string& text) {
  std::vector<Near> list;
  const Statement statement = read_statement(text, "test.yaml");
  for (const Solution& solution : solve_statement(statement, {}).solutions) {
    Near near;
    for (std::size_t i = 0; i < statement.asks.size(); ++i) {
      const SolvedAsk& ask = solution.asks[i];
      const std::string& name = statement.asks[i].name;
      if (ask.state != AskState::found) throw std::logic_error(name + ": " + ask.reason + "\n" + text);
      if (name == "s") near.stable = ask.value.truth;
      if (name == "g") near.growth = ask.value.number;
      if (name == "N") near.push = ask.value.number;
      if (name == "P") near.unknown = ask.value.number;
      if (name == "f")
        for (const Value<double>& item : ask.value.items) near.frequencies.push_back(item.number);
    }
    list.push_back(near);
  }
  return list;
}

// A body of revolution with a fixed point on its axis; moments about that point.
struct Top {
  double m, l, I, J;  // mass, distance of the mass center, moment about the axis and across it

  explicit Top(Random& random) {
    m = random.uniform(0.2, 3);
    l = random.uniform(0.05, 0.5);
    I = m * l * l * random.uniform(0.05, 2);
    J = m * l * l + I * random.uniform(0.51, 3);
  }

  // Points and body, with the axis along a unit vector.
  std::string text(const Vector& axis) const {
    return fmt::format(
        "points: {{O: [0, 0, 0], G: [{:.17g} m, {:.17g} m, {:.17g} m]}}\n"
        "bodies: {{top: {{mass: {:.17g} kg, center: G, inertia: {{about: O, axis: O->G, axial: {:.17g} kg*m^2, "
        "transverse: {:.17g} kg*m^2}}}}}}\njoints: {{tip: {{ball: O, to: top}}}}\n",
        l * axis.x, l * axis.y, l * axis.z, m, I, J);
  }

  // In steady precession at an angle from the upward vertical z, with a given spin; the precession is to be found.
  std::string precessing(double theta, double spin, double g) const {
    return fmt::format("title: a top\ngravity: [0, 0, -{:.17g} m/s^2]\nfind: {{P: rad/s}}\n", g) +
           text({std::sin(theta), 0, std::cos(theta)}) +
           fmt::format(
               "frames: {{figure: {{turns: z, rate: P}}}}\n"
               "steady: {{frame: figure, spins: {{top: {{about: O->G, rate: {:.17g} rad/s}}}}}}\n"
               "ask: {{P: P, s: stable(top), g: growth_rate(top), f: frequencies(top)}}\n",
               spin);
  }

  // (I - J) cos(theta) P^2 + I S P = m g l, ascending.
  std::vector<double> precessions(double theta, double spin, double g) const {
    const double a = (I - J) * std::cos(theta), b = I * spin, c = -m * g * l, square = b * b - 4 * a * c;
    if (square < 0) return {};
    // Without cancellation.
    const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
    std::vector<double> rates{q / a, c / q};
    std::sort(rates.begin(), rates.end());
    return rates;
  }
};

}  // namespace poinsot::problem::testing
