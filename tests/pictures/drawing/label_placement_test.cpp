// Where labels stand beside each other.
#include "pictures/drawing/label_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "pictures/drawing/label_text.h"

namespace poinsot {
namespace label_placement_test {

using namespace pictures;

LabelRequest request(const std::string& name, Point2 at) { return {name_label(name), {{at, {0, -1}, 4, 0}}, 2}; }

std::vector<Box> boxes_of(const std::vector<Mark>& marks) {
  std::vector<Box> boxes;
  for (const Mark& mark : marks)
    if (const auto* label = std::get_if<Label>(&mark)) boxes.push_back(label->placed());
  return boxes;
}

TEST(LabelPlacement, two_names_do_not_read_as_one_word_where_there_is_room) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-12, 12);
  std::size_t near = 0;
  for (int round = 0; round < 200; ++round) {
    const Point2 first{place(random), place(random)}, second{place(random), place(random)};
    const std::vector<Box> boxes =
        boxes_of(place_labels({request("y", first), request("a", second)}, {}, [](Point2) { return false; }));
    ASSERT_EQ(boxes.size(), 2U);
    EXPECT_FALSE(boxes[0].overlaps(boxes[1]));
    const double gap = std::max(boxes[0].left - boxes[1].right, boxes[1].left - boxes[0].right);
    const double shared = std::min(boxes[0].bottom, boxes[1].bottom) - std::max(boxes[0].top, boxes[1].top);
    // On one line they are apart by more than a blank.
    if (!(shared > 4)) continue;
    EXPECT_GE(gap, 8) << first.x << " " << first.y << " " << second.x << " " << second.y;
    ++near;
  }
  EXPECT_GT(near, 20U);
}

TEST(LabelPlacement, of_very_many_names_those_are_written_that_stand_near_what_they_name) {
  const auto names = [](int count) {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < count; ++i) {
      requests.push_back(request("A" + std::to_string(i), {6.0 * i, 0}));
      requests.back().may_lack = true;
    }
    return place_labels(requests, {}, [](Point2) { return false; });
  };
  const auto longest_leader = [](const std::vector<Mark>& marks) {
    double longest = 0;
    for (const Mark& mark : marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->role == Role::leader)
        longest = std::max(longest, norm(stroke->points[1] - stroke->points[0]));
    return longest;
  };
  EXPECT_EQ(boxes_of(names(20)).size(), 20U);
  const std::vector<Mark> many = names(80);
  EXPECT_LT(boxes_of(many).size(), 80U);
  EXPECT_GT(boxes_of(many).size(), 20U);
  EXPECT_LT(longest_leader(many), 45);
}

}  // namespace label_placement_test
}  // namespace poinsot
