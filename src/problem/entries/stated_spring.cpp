#include "problem/entries/stated_spring.h"

#include "problem/keys/reader.h"

namespace poinsot::problem {

Spring Spring::read(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"spring"});
  Spring spring;
  spring.name = name.text;
  spring.mark = name.mark;
  spring.from = members.text("from", "ground");
  spring.to = scalar_text(members.require("to", "to: yoke"), file, "the name of a body");
  spring.from_mark = members.mark_of("from");
  spring.to_mark = members.mark_of("to");
  spring.about = members.expression("about");
  for (const char* key : {"at", "end", "free_length", "tension"})
    if (spring.about && members.find(key))
      fail(file, members.mark_of(key), "a torsional spring has no '" + std::string(key) + "'",
           "it has from, to, about, stiffness, free_angle and damping");
  if (!spring.about && members.find("free_angle"))
    fail(file, members.mark_of("free_angle"), "a spring between two points has no 'free_angle'",
         "write free_length:, or about: with the axis of a torsional spring");
  if (!spring.about) {
    spring.at = members.require_expression("at", "at: C");
    spring.end = members.require_expression("end", "end: A");
  }
  spring.stiffness = members.expression("stiffness");
  spring.free_length = members.expression("free_length");
  spring.free_angle = members.expression("free_angle");
  spring.tension = members.expression("tension");
  spring.damping = members.expression("damping");
  if (!spring.stiffness && !spring.damping)
    fail(file, name.mark, "spring '" + name.text + "' has neither stiffness nor damping");
  if (spring.free_angle && !spring.stiffness)
    fail(file, members.mark_of("free_angle"), "spring '" + name.text + "' has a free angle but no stiffness");
  if (!spring.about && spring.stiffness && spring.free_length.has_value() == spring.tension.has_value())
    fail(file, name.mark, "spring '" + name.text + "' needs its free_length or its tension as drawn, one of them");
  return spring;
}

std::string Spring::words(const WrittenExpression& written) const {
  if (about)
    return "the torsional spring *" + name + "* between *" + from + "* and *" + to + "* acts about " + written(*about);
  return "the spring *" + name + "* joins " + written(*at) + " and " + written(*end);
}

}  // namespace poinsot::problem
