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

}  // namespace label_placement_test
}  // namespace poinsot
