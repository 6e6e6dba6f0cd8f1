// Loads and given motions that follow the time: where in time they change, so that an integration cannot step over it.
//
// Where they are not smooth is found from how they are written: abs, min, max and their like change where what they
// compare meets, and those zeros are sought between the ones of their own parts. Everything else is looked at many
// times, and more closely where it bends.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

class Driving {
 public:
  // A time in which what drives is smooth.
  struct Span {
    double begin = 0, end = 0;  // s
    double largest_step = 0;    // s, of an integration that sees what happens; 0: any
  };

  // problem and settings must outlive it. loads: those that act, all when left out. start: s; lasts: if that is known;
  // pace_time: in which the motion changes, s. looks: at each function in a part of the motion.
  Driving(const Situation& situation, const Settings& settings, const std::optional<std::vector<std::string>>& loads,
          double start, std::optional<double> lasts, double pace_time, std::size_t looks);

  // The span that begins at a time or goes on there. Where spans end depends on nothing that was asked before.
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

  // Corners may be where the two are equal, or where one is zero, if there is no other.
  struct Corner {
    Expression one, other;
  };

  const Situation& situation_;
  DataScope<double> data_;
  std::vector<Expression> driving_;
  std::vector<Corner> corners_;  // of the parts of an expression before its own
  double start_, part_;          // s: parts of the motion are looked at as they come
  std::size_t looks_, looked_ = 0;
  std::map<long, std::vector<Span>> known_;
};

}  // namespace poinsot::problem
