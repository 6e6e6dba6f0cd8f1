#include "problem/entries/stated_load.h"

#include <utility>

#include "problem/keys/reader.h"

namespace poinsot::problem {

Load Load::read(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"load"});
  Load load;
  load.name = name.text;
  load.mark = name.mark;
  load.force = members.expression("force");
  load.couple = members.expression("couple");
  if (load.force.has_value() == load.couple.has_value())
    fail(file, name.mark, "load '" + name.text + "' needs a force or a couple, one of them");
  for (const auto& [key, owner] : {std::pair{"along", "couple"}, std::pair{"about", "force"}})
    if (members.find(key) && members.find(owner))
      fail(file, members.mark_of(key), std::string("a ") + owner + " has no '" + key + "'",
           load.force ? "a force acts along a direction" : "a couple acts about an axis");
  load.direction = load.force ? members.expression("along") : members.expression("about");
  load.at = members.expression("at");
  if (load.couple && load.at) fail(file, members.mark_of("at"), "a couple has no point", "remove at:");
  load.body = scalar_text(members.require("body", "body: shaft"), file, "the name of a body");
  load.body_mark = members.mark_of("body");
  load.axes = members.text("axes", "ground");
  load.axes_mark = members.mark_of("axes");
  return load;
}

std::string Load::words(const WrittenExpression& written) const {
  return "on *" + body + "* acts the " +
         (couple ? "couple *" + name + "*, " + written(*couple) : "force *" + name + "*, " + written(*force)) +
         (direction ? " along " + written(*direction) : "") + (at ? ", at " + written(*at) : "");
}

}  // namespace poinsot::problem
