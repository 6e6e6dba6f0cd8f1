#include "pictures/figure/layout.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "pictures/drawing/font_metrics.h"
#include "pictures/drawing/label_text.h"

namespace poinsot::pictures {
namespace {

constexpr double operator_size = 26, operator_gap = 18, caption_size = 12;

// Words in lines of at most the width.
std::vector<std::string> wrapped(const std::string& words, double width, double size) {
  std::vector<std::string> lines{""};
  std::string word;
  for (const char c : clean(words) + " ") {
    if (c != ' ') {
      word += c;
      continue;
    }
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && text_width(longer, Face::upright, size) > width)
      lines.push_back(word);
    else
      lines.back() = longer;
    word.clear();
  }
  return lines;
}

// As few lines as that takes, and these of like length: no word stands alone below a full line.
std::vector<std::string> balanced(const std::string& words, double width, double size) {
  std::vector<std::string> best = wrapped(words, width, size);
  constexpr double step = 0.97;
  if (best.size() < 2) return best;
  double narrow = step * width;
  while (narrow > width / 2) {
    std::vector<std::string> lines = wrapped(words, narrow, size);
    if (lines.size() > best.size()) break;
    best = std::move(lines);
    narrow *= step;
  }
  return best;
}

}  // namespace

std::string unbroken(const std::string& words) {
  std::string result;
  for (const char c : words) c == ' ' ? result += "\u00a0" : result += c;
  return result;
}

void caption(Drawing& drawing, const std::string& words, double least_width) {
  if (words.empty()) return;
  const double width = std::clamp(drawing.paper.width(), least_width, longest_label);
  double y = drawing.paper.bottom + 20;
  const double middle = drawing.paper.center().x;
  for (const std::string& line : balanced(words, width, caption_size)) {
    Label label = words_label(line, caption_size);
    label.at = {middle - label.box.center().x, y};
    drawing.paper.include(label.placed());
    drawing.marks.emplace_back(std::move(label));
    y += 1.3 * caption_size;
  }
}

void append(Drawing& whole, Drawing part) {
  whole.paper.include(part.paper);
  std::ranges::move(part.marks, std::back_inserter(whole.marks));
}

Drawing side_by_side(std::vector<Drawing> parts, const std::vector<std::string>& signs,
                     const std::vector<std::string>& captions) {
  Drawing row;
  double x = 0, bottom = 0;
  for (const Drawing& part : parts) bottom = std::max(bottom, part.paper.bottom);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) {
      Label sign = words_label(signs[i - 1], operator_size);
      x += operator_gap;
      sign.at = {x, 8};
      x += sign.box.width() + operator_gap;
      row.paper.include(sign.placed());
      row.marks.emplace_back(std::move(sign));
    }
    parts[i].paper.bottom = bottom;
    caption(parts[i], captions[i], 120);
    const double left = parts[i].paper.left;
    Drawing part = moved(std::move(parts[i]), {x - left, 0});
    x = part.paper.right;
    append(row, std::move(part));
  }
  return row;
}

}  // namespace poinsot::pictures
