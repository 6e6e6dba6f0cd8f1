// Points at which the formulas of a claim are tried: letters drawn such that the assumptions hold, and points at
// which both sides of a comparison are equal.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "problem/claims/claim_instant.h"
#include "problem/claims/claim_verdict.h"
#include "problem/entries/drawn_letters.h"

namespace poinsot::problem {

// Whether a letter stands for a positive number.
bool is_positive(const Letter& letter);

class ClaimTrials {
 public:
  // letters: all that may occur in the formulas; sizes: at which they are drawn. The other arguments must outlive the
  // object.
  ClaimTrials(const ClaimInstant& formulas, const WorkedAssumptions& worked, const std::vector<Letter>& letters,
              const DrawnSizes& sizes)
      : formulas_(formulas), worked_(worked), letters_(letters), sizes_(sizes) {}

  // What is linear in a letter: start + slope*letter.
  struct Line {
    Formula start, slope;
  };

  // A point at which the assumptions hold, drawn for one of the cases.
  struct Drawn {
    Point point;
    const WorkedCase* of = nullptr;
    Point free;         // the letters of the case that were drawn
    bool edge = false;  // whether it was chosen such that both sides are equal
  };
  std::optional<Drawn> draw(int attempt);
  // Points at which the sides of an inequality are equal, and points on either side of these. One letter is moved and
  // the others are kept. Where an assumption allows equality, its sides are made equal too.
  std::vector<Drawn> at_edges(const Drawn& from, int attempt);

  // The letters of a case that are free, and the point with these values; nothing where an assumption fails.
  std::vector<Letter> free_letters(const WorkedCase& one) const;
  std::optional<Drawn> at(const WorkedCase& one, Point free) { return completed(one, std::move(free)); }
  // How far the claim is from failing at a point; nothing where a side has no value.
  std::optional<double> margin(const Drawn& drawn);
  // The letters of a case that have a part in that.
  std::set<std::string> read_by_margin(const WorkedCase& one) const;

  // Whether the claim holds at a point.
  Verdict verdict(const Drawn& drawn);

 private:
  // Where the sides of inequalities are equal: the factors of their differences in each case.
  struct Edge {
    const WorkedCase* of;
    Formula factor;
    std::map<std::string, std::optional<Line>> lines;  // along each letter that was asked for

    // Nothing where it is not linear in the letter.
    const std::optional<Line>& line_along(const std::string& letter);
  };
  std::vector<Edge>& edges();
  std::vector<Point> where_bodies_end(const Drawn& from, const Edge& edge, const std::string& letter) const;
  std::optional<Drawn> completed(const WorkedCase& one, Point free, bool edge = false);
  std::optional<double> exactly(const FormulaComparison& comparison, const Drawn& drawn, double size);
  Verdict compared(const FormulaComparison& comparison, const Drawn& drawn, const Dimension& dimension);

  const ClaimInstant& formulas_;
  const WorkedAssumptions& worked_;
  const std::vector<Letter>& letters_;
  DrawnSizes sizes_;
  std::optional<std::vector<Edge>> edges_;
  std::map<const WorkedCase*, std::vector<bool>> identities_;  // of each case: which terms have identical sides
  // Of each comparison in each case: nothing where the formula takes too many terms.
  std::map<std::pair<const WorkedCase*, const FormulaComparison*>, std::optional<Formula>> differences_;
  int exact_equalities_ = 0;  // how often equal sides were compared exactly
};

}  // namespace poinsot::problem
