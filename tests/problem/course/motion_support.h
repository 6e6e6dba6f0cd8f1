// Problems that move, their answers, and an integrator of their own for what the answers should be.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/language/failure.h"
#include "problem/plane/planar_statement.h"

namespace poinsot::problem {

inline Statement in_its_plane(Statement statement) {
  restrict_to_plane(statement);
  return statement;
}

// The only solution of a problem, by the names of its asks.
class SolvedText {
 public:
  explicit SolvedText(const std::string& text, const std::vector<std::pair<std::string, std::string>>& sets = {})
      : statement_(in_its_plane(read_statement(text, "test.yaml"))), solved_(solve_statement(statement_, sets)) {
    EXPECT_EQ(solved_.solutions.size(), 1U) << text;
  }

  const SolvedAsk& ask(const std::string& name) const {
    for (std::size_t i = 0; i < statement_.asks.size(); ++i)
      if (statement_.asks[i].name == name) return solved_.solutions.at(0).asks[i];
    throw std::logic_error("no ask " + name);
  }
  const SolvedAsk& found(const std::string& name) const {
    const SolvedAsk& one = ask(name);
    EXPECT_EQ(one.state, AskState::found) << name << ": " << one.reason;
    return one;
  }
  double number(const std::string& name) const { return found(name).value.number; }
  Vector3<double> vector(const std::string& name) const { return found(name).value.vector; }
  const std::vector<double>& column(const std::string& table, std::size_t column) const {
    return found(table).columns.at(column).values;
  }
  // Why an ask has no answer.
  std::string reason(const std::string& name) const {
    EXPECT_NE(ask(name).state, AskState::found) << name;
    return ask(name).reason;
  }
  const std::vector<std::string>& notes() const { return solved_.solutions.at(0).notes; }
  const SolvedStatement& solved() const { return solved_; }

 private:
  Statement statement_;
  SolvedStatement solved_;
};

inline std::string failure_of_text(const std::string& text) {
  return failure_of([&] { solve_statement(read_statement(text, "test.yaml"), {}); });
}

template <std::size_t N>
using Numbers = std::array<double, N>;

// y at `time`, by the classical method of Runge and Kutta in so many steps: an error of the fourth order.
template <std::size_t N, class Slopes>
Numbers<N> integrated(Numbers<N> y, double time, int steps, const Slopes& slopes) {
  const double h = time / steps;
  const auto moved = [&](const Numbers<N>& k, double part) {
    Numbers<N> z = y;
    for (std::size_t i = 0; i < N; ++i) z[i] += part * h * k[i];
    return z;
  };
  for (int step = 0; step < steps; ++step) {
    const auto k1 = slopes(y), k2 = slopes(moved(k1, 0.5)), k3 = slopes(moved(k2, 0.5)), k4 = slopes(moved(k3, 1));
    for (std::size_t i = 0; i < N; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

}  // namespace poinsot::problem
