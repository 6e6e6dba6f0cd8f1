#include "pictures/drawing/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

namespace poinsot::pictures {
namespace {

constexpr double over_mark = 1000;  // what it costs to stand over a line
constexpr double over_length = 10;  // and for each unit of its length
constexpr double over_label = 5000;
constexpr double reads_on = 14, apart = 9;  // labels on one line, nearer than this, read as one word
constexpr double clear = 1.5;               // around a label, free of lines
constexpr double misread = 12;              // where a label would be read as of something else
constexpr double leader_beyond = 15;
constexpr std::array<double, 14> distances{0, 4, 9, 15, 22, 30, 40, 52, 66, 84, 110, 150, 210, 300};
constexpr double most_for_optional = 40, most_among_many = 12;
constexpr std::size_t many = 40;  // labels, of which those that may lack are drawn only where they stand near
constexpr int directions = 24;
constexpr double cell = 24;

bool is_obstacle(Role role) {
  return role != Role::body && role != Role::paper && role != Role::hidden && role != Role::leader;
}

struct Segment {
  Point2 from, to;
  double half_width = 0;
};

// Segments by the cells of a lattice that they meet.
class Obstacles {
 public:
  explicit Obstacles(const std::vector<Mark>& marks) {
    for (const Mark& mark : marks) {
      if (const auto* stroke = std::get_if<Stroke>(&mark)) {
        if (is_obstacle(stroke->role)) add_line(stroke->points, stroke->closed, stroke->width / 2);
      } else if (const auto* fill = std::get_if<Fill>(&mark)) {
        if (is_obstacle(fill->role))
          for (const auto& loop : fill->loops) add_area(loop);
      }
    }
  }

  // How much of the lines lies within a box; not all of it if it is more than `enough`.
  double within(const Box& box, double enough) const {
    double sum = 0;
    visit(box, [&](const Segment& s) {
      sum += length_within(box.grown(s.half_width), s.from, s.to);
      return sum <= enough;
    });
    return sum;
  }
  int crossings(Point2 from, Point2 to) const {
    Box box;
    box.include(from);
    box.include(to);
    int count = 0;
    visit(box, [&](const Segment& s) {
      const Point2 d = to - from, e = s.to - s.from;
      const double side = cross(d, e);
      if (std::abs(side) < 1e-9) return true;
      const double t = cross(s.from - from, e) / side, u = cross(s.from - from, d) / side;
      if (t > 0.05 && t < 0.99 && u >= 0 && u <= 1) ++count;
      return true;
    });
    return count;
  }

 private:
  void add_line(const std::vector<Point2>& points, bool closed, double half_width) {
    for (std::size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i)
      add({points[i], points[(i + 1) % points.size()], half_width});
  }
  // Small areas, such as heads of arrows: their border, and lines across so that nothing fits inside.
  void add_area(const std::vector<Point2>& loop) {
    add_line(loop, true, 0.5);
    for (std::size_t i = 0; i + 2 < loop.size(); i += 2) add({loop[i], loop[(i + loop.size() / 2) % loop.size()], 0.5});
  }
  static long long key(long long column, long long row) { return column * 100003 + row; }
  static long long place(double d) { return static_cast<long long>(std::floor(d / cell)); }
  void add(const Segment& segment) {
    const auto number = static_cast<std::uint32_t>(segments_.size());
    segments_.push_back(segment);
    visited_.push_back(0);
    const double length = norm(segment.to - segment.from);
    const int pieces = std::clamp(static_cast<int>(length / cell) + 1, 1, 400);
    for (int i = 0; i < pieces; ++i) {
      Box box;
      box.include(segment.from + (static_cast<double>(i) / pieces) * (segment.to - segment.from));
      box.include(segment.from + ((i + 1.0) / pieces) * (segment.to - segment.from));
      box = box.grown(segment.half_width);
      for (long long column = place(box.left); column <= place(box.right); ++column)
        for (long long row = place(box.top); row <= place(box.bottom); ++row) {
          auto& list = cells_[key(column, row)];
          if (list.empty() || list.back() != number) list.push_back(number);
        }
    }
  }
  // Visits each segment in the cells of a box once, as long as the visitor wants more.
  template <class Visit>
  void visit(const Box& box, Visit visit) const {
    ++visits_;
    for (long long column = place(box.left - 3); column <= place(box.right + 3); ++column)
      for (long long row = place(box.top - 3); row <= place(box.bottom + 3); ++row) {
        const auto found = cells_.find(key(column, row));
        if (found == cells_.end()) continue;
        for (const std::uint32_t number : found->second)
          if (std::exchange(visited_[number], visits_) != visits_ && !visit(segments_[number])) return;
      }
  }

  std::vector<Segment> segments_;
  std::unordered_map<long long, std::vector<std::uint32_t>> cells_;
  mutable std::vector<std::uint32_t> visited_;  // for each segment, in which visit last
  mutable std::uint32_t visits_ = 0;
};

struct Placed {
  Point2 at;  // of the label
  double cost = std::numeric_limits<double>::infinity();
  std::optional<std::pair<Point2, Point2>> leader;
};

// The point of the box that is nearest to another.
Point2 nearest(const Box& box, Point2 p) {
  return {std::clamp(p.x, box.left, box.right), std::clamp(p.y, box.top, box.bottom)};
}

class Placement {
 public:
  Placement(std::vector<LabelRequest> requests, const std::vector<Mark>& marks,
            const std::function<bool(Point2)>& over_body)
      : requests_(std::move(requests)), placed_(requests_.size()), obstacles_(marks), over_body_(over_body) {
    std::ranges::stable_sort(requests_, std::greater{}, &LabelRequest::importance);
  }

  std::vector<Mark> run() {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
      bool changes = false;
      for (std::size_t i = 0; i < requests_.size(); ++i) {
        if (requests_[i].anchors.empty()) continue;
        const Placed next = best(i);
        changes = changes || next.cost != placed_[i].cost || norm(next.at - placed_[i].at) != 0;
        placed_[i] = next;
      }
      // The next round would find the same.
      if (!changes) break;
    }
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      if (left_out(i)) continue;
      if (placed_[i].leader)
        marks.emplace_back(Stroke{.points = {placed_[i].leader->first, placed_[i].leader->second},
                                  .width = 0.7,
                                  .ink = requests_[i].leader,
                                  .role = Role::leader});
    }
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      if (left_out(i)) continue;
      Label label = requests_[i].label;
      label.at = placed_[i].at;
      marks.emplace_back(std::move(label));
    }
    return marks;
  }

 private:
  // At which cost a label is left out.
  double most_of(const LabelRequest& request) const {
    if (!request.may_lack) return std::numeric_limits<double>::infinity();
    return requests_.size() > many ? most_among_many : most_for_optional;
  }
  bool left_out(std::size_t i) const {
    return !std::isfinite(placed_[i].cost) || placed_[i].cost >= most_of(requests_[i]);
  }

  Placed best(std::size_t i) {
    note_others(i);
    const LabelRequest& request = requests_[i];
    // Places at which it would be left out need not be looked at.
    Placed best;
    best.cost = most_of(request);
    const Box& box = request.label.box;
    const double diagonal = std::hypot(box.width(), box.height());
    double gap = 0;
    for (const Anchor& anchor : request.anchors) gap = std::max(gap, anchor.gap);
    near_ = 0;
    for (const double distance : distances) {
      // What is farther costs more than what was found.
      if (best.cost < over_mark && 0.25 * distance > best.cost) break;
      const double reach_of_ring = gap + distance + diagonal;
      while (near_ < others_.size() && others_[near_].away <= reach_of_ring) ++near_;
      for (const Anchor& anchor : request.anchors)
        for (int k = 0; k < directions; ++k) {
          const double angle = 2 * std::numbers::pi * k / directions;
          const Point2 toward{std::cos(angle), std::sin(angle)};
          const double reach = std::min(box.width() / 2 / std::max(std::abs(toward.x), 1e-9),
                                        box.height() / 2 / std::max(std::abs(toward.y), 1e-9));
          const Point2 center = anchor.at + (anchor.gap + distance + reach) * toward;
          Placed here{center - box.center(), 0, {}};
          here.cost = cost(i, here, anchor, toward, distance, best.cost);
          if (here.cost < best.cost) best = here;
        }
    }
    return best;
  }

  // The labels that one stands among.
  void note_others(std::size_t i) {
    others_.clear();
    for (std::size_t other = 0; other < requests_.size(); ++other)
      if (other != i && std::isfinite(placed_[other].cost) && !left_out(other))
        others_.push_back({requests_[other].label.box.moved(placed_[other].at), placed_[other].leader});
    // In the order in which labels that go farther and farther from their anchors come to meet them.
    for (Other& other : others_) {
      Box reach = other.box.grown(apart);
      if (other.leader) {
        reach.include(other.leader->first);
        reach.include(other.leader->second);
      }
      for (const Anchor& anchor : requests_[i].anchors)
        other.away = std::min(other.away, norm(nearest(reach, anchor.at) - anchor.at));
    }
    std::ranges::stable_sort(others_, {}, &Other::away);
  }

  double cost(std::size_t i, Placed& here, const Anchor& anchor, Point2 toward, double distance, double least) const {
    const Box box = requests_[i].label.box.moved(here.at);
    double sum = anchor.cost + 0.25 * distance;
    if (norm(anchor.preferred) > 0) sum += 2.5 * (1 - dot(toward, direction(anchor.preferred)));
    if (sum >= least) return sum;
    const bool with_leader = distance > leader_beyond;
    if (with_leader) {
      here.leader = {{anchor.at + 2.0 * direction(nearest(box, anchor.at) - anchor.at), nearest(box, anchor.at)}};
      sum += 3;
    }
    for (std::size_t k = 0; k < near_; ++k) {
      const Box& theirs = others_[k].box;
      const auto& leader = others_[k].leader;
      if (theirs.grown(1.5).overlaps(box))
        sum += over_label;
      else if (Box{theirs.left - apart, theirs.top + 3, theirs.right + apart, theirs.bottom - 3}.overlaps(box))
        sum += reads_on;
      if (with_leader && meets(theirs, here.leader->first, here.leader->second)) sum += over_label;
      if (leader && meets(box, leader->first, leader->second)) sum += over_label;
      if (sum >= least) return sum;
    }
    const double enough = std::max(0.0, (least - sum - over_mark) / over_length);
    const double within = obstacles_.within(box.grown(clear), enough);
    if (within > 0) sum += over_mark + over_length * within;
    if (sum >= least) return sum;
    if (with_leader) sum += 2.5 * obstacles_.crossings(here.leader->first, here.leader->second);
    if (over_body_ && over_body_(box.center())) sum += 2;
    if (requests_[i].misread && requests_[i].misread(box.center())) sum += misread;
    return sum;
  }

  struct Other {
    Box box;
    std::optional<std::pair<Point2, Point2>> leader;
    double away = std::numeric_limits<double>::infinity();  // from the anchors of the label that is placed
  };

  std::vector<LabelRequest> requests_;
  std::vector<Placed> placed_;
  std::vector<Other> others_{};
  std::size_t near_ = 0;  // of these, which a label so far from its anchors can meet
  Obstacles obstacles_;
  const std::function<bool(Point2)>& over_body_;
};

}  // namespace

std::vector<Mark> place_labels(std::vector<LabelRequest> requests, const std::vector<Mark>& marks,
                               const std::function<bool(Point2)>& over_body) {
  return Placement(std::move(requests), marks, over_body).run();
}

}  // namespace poinsot::pictures
