// Finds where loads and given motions that depend on the time change, so that an integration does not step over it.
//
// Corners are found from the expressions: abs, min, max and the like have corners where the values that they compare
// are equal. These times are sought between the corners of their parts. Everything else is sampled many times, and
// more densely where it bends.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// The loads and given motions that follow the time. loads: the names of those that act, or all if left out.
std::vector<Expression> driving_expressions(const Situation& situation,
                                            const std::optional<std::vector<std::string>>& loads);

class Driving {
 public:
  // An interval of time in which all loads and given motions are smooth.
  struct Span {
    double begin = 0, end = 0;  // s
    double largest_step = 0;    // s, for an integration that notices every change; 0: any
  };

  // Situation and settings must outlive the object. loads: those that act, or all if left out. start: s. lasts: if
  // the duration is known. pace_time: in which the motion changes noticeably, s. looks: samples of each function in a
  // part of the motion.
  Driving(const Situation& situation, const Settings& settings, const std::optional<std::vector<std::string>>& loads,
          double start, std::optional<double> lasts, double pace_time, std::size_t looks);

  // The span that begins at or contains a time. The ends of spans do not depend on earlier calls.
  Span span_from(double time);

 private:
  struct Look {
    double time;
    std::vector<double> value;
  };
  void collect(const Expression& expression);
  void collect_corners(const Expression& expression, std::vector<std::string>& names);
  std::vector<double> values(double time);
  double switch_value(const Expression& expression, const Expression& other, double time);
  std::vector<double> corners(double from, double to);
  std::vector<Span> spans(double from, double to);
  static bool is_polynomial(const std::vector<Look>& looks, const std::vector<double>& least,
                            const std::vector<double>& most);
  void refine(const Look& before, const Look& after, std::vector<double>& least, std::vector<double>& most,
              std::vector<Look>& found, int depth);

  // There may be a corner where the two expressions are equal, or where the one is zero if there is no other.
  struct Corner {
    Expression one, other;
  };

  const Situation& situation_;
  DataScope<double> data_;
  std::vector<Expression> driving_;
  std::vector<Corner> corners_;  // those of the parts of an expression come before its own
  double start_, part_;          // s; parts of the motion are sampled when they are reached
  std::size_t looks_, looked_ = 0;
  std::map<long, std::vector<Span>> known_;
};

}  // namespace poinsot::problem
