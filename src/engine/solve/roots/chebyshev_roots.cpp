#include "engine/solve/roots/chebyshev_roots.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>

#include "engine/solve/roots/chebyshev_fit.h"
#include "engine/solve/roots/chebyshev_pieces.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_zooms = 8;
constexpr double least_box = 1e-11;  // half width as a part of the whole range, below which a box is not divided
// where values are within this many errors of zero, a new polynomial would gain little
constexpr double noise_limited = 1e5;
constexpr double most_work = 0.5;  // part of the allowed work for this search
constexpr int most_vain_polishes = 5;
constexpr double reach_of_line = 1e6, reach_of_plane = 1e4;

bool touch(const Piece& a, const Piece& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (std::abs(a.middle[k] - b.middle[k]) > 1.1 * (a.half[k] + b.half[k])) return false;
  return true;
}

Piece around(const Piece& a, const Piece& b) {
  Piece box;
  for (std::size_t k = 0; k < 2; ++k) {
    const double lower = std::min(a.middle[k] - a.half[k], b.middle[k] - b.half[k]);
    const double upper = std::max(a.middle[k] + a.half[k], b.middle[k] + b.half[k]);
    box.middle[k] = (lower + upper) / 2;
    box.half[k] = (upper - lower) / 2;
  }
  return box;
}

// Joins boxes that touch to one box around them. None is left much narrower than long, since on such a box a
// polynomial's slopes would be rounding.
std::vector<Piece> clusters(std::vector<Piece> pieces) {
  for (Piece& piece : pieces)
    for (std::size_t k = 0; k < 2; ++k)
      if (piece.half[k] > 0) piece.half[k] = std::max(piece.half[k], 0.05 * piece.half[1 - k]);
  for (bool merged = true; merged;) {
    merged = false;
    std::vector<Piece> result;
    for (const Piece& piece : pieces) {
      const auto near =
          std::find_if(result.begin(), result.end(), [&](const Piece& known) { return touch(known, piece); });
      if (near == result.end()) {
        result.push_back(piece);
      } else {
        *near = around(*near, piece);
        merged = true;
      }
    }
    pieces = std::move(result);
  }
  return pieces;
}

class Search {
 public:
  explicit Search(RootFunction& function)
      : function_(function),
        reach_(function.unknowns() == 1 ? reach_of_line : reach_of_plane),
        compact_(function, reach_),
        fitter_(compact_),
        whole_(compact_.whole()),
        most_evaluations_(function.evaluations() + (function.unknowns() == 1 ? 3000 : 4000)) {}

  ChebyshevRoots run() {
    begin_ = function_.evaluations();
    for (const Piece& piece : first_pieces()) boxes_.push_back({piece, 0, 0});
    while (!boxes_.empty() && !along_curve_) {
      if (function_.evaluations() > most_evaluations_ || function_.limit().part_spent() > most_work || hopeless()) {
        for (const Box& box : boxes_) leave(box.piece, "the equations are too rough for polynomials");
        break;
      }
      const Box box = boxes_.front();
      boxes_.pop_front();
      treat(box);
    }
    result_.reach = reach_;
    if (!along_curve_)
      for (const Pair& t : touching_)
        if (vain_polishes_ < most_vain_polishes) touch_zero(t);
    if (function_.unknowns() == 1 && !along_curve_)
      for (const double side : {1.0, -1.0}) look_beyond(side);
    if (along_curve_) leave(whole_, "a curve of solutions");
    merge_unresolved();
    return std::move(result_);
  }

 private:
  struct Box {
    Piece piece;
    int depth, zooms;
  };

  // The whole ranges; of equations with corners they are cut at zero and in decades about it. A polynomial through
  // places of a wide range that all lie on one side of a corner shows nothing of what is beyond it.
  std::vector<Piece> first_pieces() const {
    std::vector<Piece> pieces{whole_};
    if (!function_.problem().corners) return pieces;
    const bool line = function_.unknowns() == 1;
    for (int k = 0; k < compact_.unknowns(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      std::vector<double> cuts{whole_.middle[i] - whole_.half[i]};
      // Not at round numbers, where corners are likely: one just inside a piece would not be seen.
      for (const double natural : {-2.3e5, -2.3e4, -2.3e3, -230.0, -23.0, -2.3, -0.23, -0.023, 0.0, 0.023, 0.23, 2.3,
                                   23.0, 230.0, 2.3e3, 2.3e4, 2.3e5}) {
        if (!line && natural != 0 && (std::abs(natural) < 0.2 || std::abs(natural) > 30)) continue;
        if (const auto t = compact_place(k, natural)) cuts.push_back(*t);
      }
      cuts.push_back(whole_.middle[i] + whole_.half[i]);
      std::vector<Piece> cut;
      for (const Piece& piece : pieces)
        for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
          Piece part = piece;
          part.middle[i] = (cuts[c] + cuts[c + 1]) / 2;
          part.half[i] = (cuts[c + 1] - cuts[c]) / 2;
          cut.push_back(part);
        }
      pieces = std::move(cut);
    }
    return pieces;
  }
  // Where in the compact range an unknown has this value, in natural sizes; nothing at the ends and beyond.
  std::optional<double> compact_place(int unknown, double value) const {
    const auto i = static_cast<std::size_t>(unknown);
    double lower = whole_.middle[i] - whole_.half[i], upper = whole_.middle[i] + whole_.half[i];
    Pair t = whole_.middle;
    const auto u = [&](double at) {
      t[i] = at;
      return compact_.u(t)[unknown];
    };
    if (!(u(lower) < value && value < u(upper))) return std::nullopt;
    for (int halvings = 0; halvings < 60; ++halvings) {
      const double middle = (lower + upper) / 2;
      (u(middle) < value ? lower : upper) = middle;
    }
    return (lower + upper) / 2;
  }

  double part_of_whole(const Piece& piece) const {
    double part = 1;
    for (std::size_t k = 0; k < 2; ++k)
      if (whole_.half[k] > 0) part *= piece.half[k] / whole_.half[k];
    return part;
  }
  double width(const Piece& piece) const {
    double width = 0;
    for (std::size_t k = 0; k < 2; ++k)
      if (whole_.half[k] > 0) width = std::max(width, piece.half[k] / whole_.half[k]);
    return width;
  }

  // Whether the search has resolved too little of the ranges for what it has spent. With two unknowns each level of
  // division costs hundreds of evaluations.
  bool hopeless() const {
    const std::size_t spent = function_.evaluations() - begin_;
    if (function_.unknowns() == 1) return false;
    return (spent > 500 && resolved_ < 0.02) || (spent > 2000 && resolved_ < 0.5);
  }

  void treat(const Box& box) {
    const Fit fit = fitter_.fit(box.piece, box.depth);
    switch (fit.outcome) {
      case Fit::Outcome::no_root:
      case Fit::Outcome::no_value:
        resolved_ += part_of_whole(box.piece);
        return;
      case Fit::Outcome::divide:
        divide(box, fit.across, fit.cut);
        return;
      case Fit::Outcome::polynomial:
        resolved_ += part_of_whole(box.piece);
        break;
    }
    const PieceZeros found = zeros_of_pieces(fit.series, fit.error, function_.problem().zero * fit.size);
    // A curve of solutions is looked for in wide boxes only: in a narrow one a polynomial may have such a curve
    // within its error.
    if (found.curve && width(box.piece) > 1e-3)
      for (const Pair& s : *found.curve)
        if (follow(place(box.piece, s))) return;
    for (const Pair& s : found.zeros) confirm(box.piece, fit, s);
    for (const Piece& cluster : clusters(found.left)) zoom(box, fit, cluster);
    for (const Pair& s : found.touching) touching_.push_back(place(box.piece, s));
  }

  static Pair place(const Piece& box, const Pair& s) {
    return {box.middle[0] + box.half[0] * s[0], box.middle[1] + box.half[1] * s[1]};
  }

  void divide(const Box& box, int across, double cut) {
    const auto k = static_cast<std::size_t>(across);
    const double lower = box.piece.middle[k] - box.piece.half[k], upper = box.piece.middle[k] + box.piece.half[k];
    if (width(box.piece) < least_box) {
      leave(box.piece, "no polynomial stands for the equations");
      return;
    }
    if (!(cut > lower && cut < upper)) cut = (lower + upper) / 2;
    for (const auto& [from, to] : {std::pair{lower, cut}, std::pair{cut, upper}}) {
      if (!(to - from > 1e-15)) continue;
      Box part{box.piece, box.depth + 1, box.zooms};
      part.piece.middle[k] = (from + to) / 2;
      part.piece.half[k] = (to - from) / 2;
      boxes_.push_back(part);
    }
  }

  // Polishes a simple zero of the polynomial on the equations themselves.
  void confirm(const Piece& box, const Fit& fit, const Pair& s) {
    const Pair t = place(box, s);
    MatrixXd slopes;
    fit.series.with_slopes(s, slopes);
    for (std::size_t k = 0; k < 2; ++k) slopes.col(static_cast<Index>(k)) /= box.half[k] > 0 ? box.half[k] : 1;
    const VectorXd u = compact_.u(t);
    const MatrixXd J = compact_.unweighted(t, fit.basis * slopes);
    auto root = polish_with(function_, u, J);
    if (!root) return;  // without values there is no root
    if (!root->zero) root = polish(function_, root->u);
    if (!root || !root->zero) {
      if (!function_.inside(u)) return;
      Piece spot = box;
      for (std::size_t k = 0; k < 2; ++k) {
        spot.middle[k] = t[k];
        spot.half[k] *= 1e-3;
      }
      leave(spot, "a root of the polynomial is none of the equations");
      return;
    }
    note_idle(box, fit, s, *root);
    result_.roots.add(function_, *root);
  }

  // An unknown on which the equations do not depend anywhere in a wide box is open at a root in that box.
  void note_idle(const Piece& box, const Fit& fit, const Pair& s, const PolishedRoot& root) {
    for (int k = 0; k < compact_.unknowns(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (fit.series.size(k) > 1 || box.half[i] < 1e-3 * whole_.half[i]) continue;
      VectorXd u = root.u;
      bool zero = true;
      for (const double part : {-0.6, 0.3}) {
        Pair other = s;
        other[i] = part;
        u[k] = compact_.u(place(box, other))[k];
        const auto sample = function_.at(u);
        zero = zero && sample && sample->values.norm() <= function_.problem().zero * std::max(root.size, sample->size);
      }
      if (!zero) continue;
      note_open(i);
      result_.alternative = u;
    }
  }

  void note_open(std::size_t unknown) {
    auto& open = result_.open_unknowns;
    if (std::find(open.begin(), open.end(), unknown) == open.end()) open.push_back(unknown);
    std::sort(open.begin(), open.end());
  }

  // Whether a curve of solutions goes through a place. If so, it is reported.
  bool follow(const Pair& t) {
    const auto root = polish(function_, compact_.u(t));
    if (!root || !root->zero || !function_.inside(root->u)) return false;
    const auto family = family_through(function_, *root);
    if (!family) return false;
    result_.roots.add(function_, *root);
    result_.alternative = family->other;
    for (std::size_t k : family->open_unknowns) note_open(k);
    along_curve_ = true;
    return true;
  }

  // Resolves what one polynomial could not by a new polynomial on a smaller box, until the values are rounding.
  void zoom(const Box& box, const Fit& fit, const Piece& cluster) {
    Piece inner;
    bool smaller = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const double lower = std::max(-1.0, cluster.middle[k] - 1.6 * cluster.half[k]);
      const double upper = std::min(1.0, cluster.middle[k] + 1.6 * cluster.half[k]);
      inner.middle[k] = box.piece.middle[k] + box.piece.half[k] * (lower + upper) / 2;
      inner.half[k] = box.piece.half[k] * (upper - lower) / 2;
      smaller = smaller || (box.piece.half[k] > 0 && upper - lower < 1);
    }
    const bool last =
        box.zooms >= most_zooms || fit.largest <= noise_limited * fit.error || width(inner) < 100 * least_box;
    if (!last) {
      if (smaller)
        boxes_.push_back({inner, box.depth, box.zooms + 1});
      else
        divide({inner, box.depth, box.zooms + 1},
               inner.half[0] * whole_.half[1] >= inner.half[1] * whole_.half[0] ? 0 : 1,
               std::numeric_limits<double>::quiet_NaN());
      return;
    }
    if (width(inner) > 1e-3 && follow(inner.middle)) return;
    auto root = polish(function_, compact_.u(inner.middle));
    if (!root || !root->zero) {
      leave(inner, "the misfit is too small to tell whether there is a root");
      return;
    }
    // Several roots that close together cannot be told apart and count as one, with a radius that covers the box.
    VectorXd extent = compact_.u(place(inner, {1, 1})) - compact_.u(place(inner, {-1, -1}));
    root->radius = std::max(root->radius, extent.norm());
    result_.roots.add(function_, *root);
  }

  // A place where the equations touch zero without crossing it: it counts as a root if no root in the neighbourhood
  // accounts for the small values.
  void touch_zero(const Pair& t) {
    const VectorXd u = compact_.u(t);
    for (const PolishedRoot& root : result_.roots.roots())
      if ((root.u - u).norm() <= 3e-3 * root.u.cwiseAbs().cwiseMax(1.0).norm()) return;
    const auto root = polish(function_, u);
    if (root && root->zero)
      result_.roots.add(function_, *root);
    else
      ++vain_polishes_;
  }

  // Beyond the reach of polynomials the values of one unknown are looked at once a decade. Where they turn around,
  // and are more than rounding on both sides, there is a root. Farther out than the last place a double leaves three
  // digits of what is added to a natural size.
  void look_beyond(double side) {
    constexpr double farthest = 1e12, stride = 10;
    const RootRange& range = function_.problem().ranges[0];
    if (std::isfinite(side > 0 ? range.upper : range.lower)) return;
    const double other = side > 0 ? range.lower : range.upper;
    const double from = std::isfinite(other) ? other / range.scale : 0;
    const auto at = [&](double away) { return function_.at(VectorXd::Constant(1, from + side * away)); };
    auto here = at(reach_);
    const auto last = at(farthest);
    if (grows_as_a_power(here, last, farthest / reach_)) return;
    double away = reach_;
    while (away < farthest) {
      auto next = away * stride < farthest ? at(away * stride) : last;
      const double end = std::min(away * stride, farthest);
      if (is_clear(here) && is_clear(next) && here->values.size() == next->values.size()) {
        const VectorXd across = next->values - here->values;
        if (across.dot(here->values) < 0 && across.dot(next->values) > 0)
          if (const auto root = turned_between(from, side * away, side * end, across))
            result_.roots.add(function_, *root);
      }
      here = std::move(next);
      away = end;
    }
  }

  static bool is_clear(const std::optional<RootSample>& place) {
    constexpr double rounding = 1e-12;  // of the terms: what some thousand operations leave
    return place && place->values.norm() > rounding * place->size;
  }
  // Whether one whole power of the distance leads from one place to another, so that no other term shows between them.
  static bool grows_as_a_power(const std::optional<RootSample>& near, const std::optional<RootSample>& far,
                               double ratio) {
    constexpr double off = 1e-4;  // as another term makes it that is a thousandth at the near place
    if (!is_clear(near) || !is_clear(far) || near->values.size() != far->values.size()) return false;
    const double power = std::log(far->values.norm() / near->values.norm()) / std::log(ratio);
    const double alike = near->values.normalized().dot(far->values.normalized());
    return alike > 1 - off && std::abs(power - std::round(power)) < off;
  }

  // The root between two distances from a place, between which the values turn around: halved on the scale of
  // magnitudes, to the last digits. Steps by slopes could lead away where all misfits are small beside the terms.
  std::optional<PolishedRoot> turned_between(double from, double near, double far, const VectorXd& across) {
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
      const double middle = std::copysign(std::sqrt(near * far), near);
      if (middle == near || middle == far) break;
      const auto there = function_.at(VectorXd::Constant(1, from + middle));
      if (!there || there->values.size() != across.size()) return std::nullopt;
      (across.dot(there->values) < 0 ? near : far) = middle;
    }
    auto root = polish(function_, VectorXd::Constant(1, from + near));
    constexpr double same = 1e-3;  // of it: farther away it is another root
    if (!root || !root->zero || !(std::abs(root->u[0] - from - near) <= same * std::abs(near))) return std::nullopt;
    return root;
  }

  void leave(const Piece& piece, std::string reason) { unresolved_.emplace_back(piece, std::move(reason)); }

  // Joins unresolved boxes until a few are left, which suffice to tell the reader where roots may be missing.
  void merge_unresolved() {
    constexpr std::size_t most_parts = 5;
    std::vector<std::pair<Piece, std::string>> parts;
    for (auto& [piece, reason] : unresolved_) {
      const auto near = std::find_if(parts.begin(), parts.end(),
                                     [&, &piece = piece](const auto& part) { return touch(part.first, piece); });
      if (near != parts.end())
        near->first = around(near->first, piece);
      else if (parts.size() < most_parts)
        parts.emplace_back(piece, reason);
      else
        parts.back().first = around(parts.back().first, piece);
      if (result_.places.size() < 20) result_.places.push_back(compact_.u(piece.middle));
    }
    for (const auto& [piece, reason] : parts)
      result_.unresolved.push_back({function_.unscaled(compact_.u(place(piece, {-1, -1}))),
                                    function_.unscaled(compact_.u(place(piece, {1, 1}))), reason});
  }

  RootFunction& function_;
  double reach_;
  CompactFunction compact_;
  ChebyshevFitter fitter_;
  Piece whole_;
  std::size_t most_evaluations_, begin_ = 0;
  std::deque<Box> boxes_;
  std::vector<Pair> touching_;
  int vain_polishes_ = 0;
  double resolved_ = 0;  // part of the whole
  bool along_curve_ = false;
  std::vector<std::pair<Piece, std::string>> unresolved_;
  ChebyshevRoots result_;
};

}  // namespace

ChebyshevRoots chebyshev_roots(RootFunction& function) { return Search(function).run(); }

}  // namespace poinsot::solve
