#include "pictures/svg/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "pictures/drawing/label_text.h"
#include "pictures/drawing/markup.h"
#include "pictures/figure/panel.h"
#include "pictures/svg/smooth_path.h"

namespace poinsot::pictures {
namespace {

// Liberation Serif, of which the widths are known, and those that have the same.
constexpr std::string_view fonts = "'Liberation Serif','Times New Roman',Times,'Nimbus Roman',serif";

std::string escaped(std::string_view text) { return escaped_markup(clean(text)); }

std::string number(double value) { return path_number(value); }

// Lines with a curve through their points. Areas stay as they are: their borders lie under lines.
bool may_bend(Role role) {
  return role == Role::outline || role == Role::rod || role == Role::hidden || role == Role::curve;
}

std::string_view dashes(Dash dash) {
  switch (dash) {
    case Dash::none:
      return "";
    case Dash::hidden:
      return "4 3";
    case Dash::inertial:
      return "7 3";
    case Dash::fine:
      return "2 3";
    case Dash::chain:
      return "10 3 2 3";
  }
  return "";
}

std::string opacity(double value) { return value < 1 ? fmt::format(" opacity=\"{}\"", number(value)) : ""; }

// What a browser tells where the mouse rests.
std::string told(const std::string& hint) {
  return hint.empty() ? "" : fmt::format("<title>{}</title>", escaped(hint));
}

std::string written(const Stroke& stroke) {
  const std::string_view dash = dashes(stroke.dash);
  return fmt::format(
      "<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}{}{}{}\n",
      may_bend(stroke.role) ? smooth_path(stroke.points, stroke.closed) : straight_path(stroke.points, stroke.closed),
      color_of(stroke.ink), number(stroke.width), stroke.round ? "" : " stroke-linecap=\"butt\"",
      dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash), opacity(stroke.opacity),
      stroke.hint.empty() ? "/>" : ">" + told(stroke.hint) + "</path>");
}

std::string written(const Fill& fill) {
  std::string path;
  for (const auto& loop : fill.loops) path += straight_path(loop, true);
  return fmt::format("<path d=\"{}\" fill=\"{}\"{}{}/>\n", path, fill.color,
                     fill.bordered ? fmt::format(" stroke=\"{}\" stroke-width=\"0.4\"", fill.color) : "",
                     opacity(fill.opacity));
}

std::string_view style_of(Face face) {
  switch (face) {
    case Face::upright:
      return "";
    case Face::italic:
      return " font-style=\"italic\"";
    case Face::bold:
      return " font-weight=\"bold\"";
    case Face::bold_italic:
      return " font-style=\"italic\" font-weight=\"bold\"";
  }
  return "";
}

std::string written(const Accent& accent, const Label& label) {
  const Point2 from = label.at + accent.from, to = label.at + accent.to, middle = 0.5 * (from + to);
  const std::string color = color_of(label.ink);
  if (accent.kind == Accent::Kind::bar)
    return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"0.9\"/>\n", straight_path({from, to}, false),
                       color);
  std::string dots;
  for (const double x : accent.kind == Accent::Kind::dot ? std::vector{0.0} : std::vector{-2.0, 2.0})
    dots += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"1.1\" fill=\"{}\"/>\n", number(middle.x + x), number(middle.y),
                        color);
  return dots;
}

std::string written(const Label& label) {
  std::string text = fmt::format("<text xml:space=\"preserve\" fill=\"{}\">{}", color_of(label.ink), told(label.hint));
  for (const Run& run : label.runs)
    text += fmt::format("<tspan x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\"{}>{}</tspan>",
                        number(label.at.x + run.offset.x), number(label.at.y + run.offset.y), number(run.size),
                        number(run.width), style_of(run.face), escaped(run.text));
  text += "</text>\n";
  for (const Accent& accent : label.accents) text += written(accent, label);
  return text;
}

}  // namespace

std::string svg_of(const Drawing& drawing) {
  const Box& box = drawing.paper;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0} {1} {2} {3}\" width=\"{2}\" height=\"{3}\" role=\"img\" "
      "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"{4}\">\n",
      number(box.left), number(box.top), number(box.width()), number(box.height()), fonts);
  // They name the drawing without identifiers, which several drawings in one document would share.
  text += fmt::format("<title>{}</title>\n<desc>{}</desc>\n", escaped(drawing.title), escaped(drawing.description));
  text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", number(box.left),
                      number(box.top), number(box.width()), number(box.height()));
  for (const Mark& mark : drawing.marks) text += std::visit([](const auto& own) { return written(own); }, mark);
  return text + "</svg>\n";
}

}  // namespace poinsot::pictures
