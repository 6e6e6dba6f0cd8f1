#include "problem/entries/read_instants.h"

#include <cctype>

#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

// A time such as 2 s begins with a digit, which no name does.
bool starts_with_digit(const std::string& text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

}  // namespace

Instant read_instant(const Key& name, const Entry& entry, const std::string& file) {
  Instant instant;
  instant.name = name.text;
  instant.mark = name.mark;
  if (is_name(name.text) || starts_with_digit(name.text)) instant.when = parse_expression(name.text, file, name.mark);
  if (entry.kind == Entry::Kind::scalar && entry.text == "rest") {
    instant.rest = true;
    return instant;
  }
  if (entry.kind != Entry::Kind::map)
    fail(file, entry.mark, "an instant is `rest` or a map of facts",
         "write now: {angular_velocity(disk): [w1, any, any]}");
  for (const auto& [key, value] : entry.members) {
    if (key.text == "first_time") {
      instant.found_when = parse_expression(value, file);
      continue;
    }
    if (key.text == "from" || key.text == "to")
      fail(file, key.mark, "an instant that is found by a condition is the first from the start on",
           "ask for another time by itself, {first_time: turn' == 0, from: 2 s}");
    if (key.text == "nudged") {
      if (value.kind == Entry::Kind::list)
        for (const Entry& item : value.items)
          instant.nudged.emplace_back(scalar_text(item, file, "the name of a coordinate"), item.mark);
      else
        instant.nudged.emplace_back(scalar_text(value, file, "the name of a coordinate"), value.mark);
      continue;
    }
    if (key.text == "rest") {
      instant.rest = true;
      continue;
    }
    Entry quantity;
    quantity.kind = Entry::Kind::scalar;
    quantity.text = key.text;
    quantity.mark = key.mark;
    instant.facts.push_back({parse_expression(quantity, file), parse_expression(value, file), key.mark});
  }
  if (instant.found_when && (instant.rest || !instant.facts.empty() || !instant.nudged.empty()))
    fail(file, name.mark, "the instant '" + name.text + "' is found by its condition: nothing else is stated of it",
         "state facts at the start, or look for its time in place of the condition: find: {t: s}, and under instants: "
         "t: "
         "{...} with all that holds then");
  return instant;
}

Steady read_steady(const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"steady"});
  Steady steady;
  steady.mark = entry.mark;
  steady.frame = scalar_text(members.require("frame", "frame: figure"), file, "the name of a frame or body");
  steady.frame_mark = members.mark_of("frame");
  for (const auto& [name, value] : named(members, "spins", file)) {
    const Members spin(value, file, {"spin"});
    steady.spins.push_back({name.text, spin.require_expression("about", "about: A->B"),
                            spin.require_expression("rate", "rate: psidot"), name.mark});
  }
  return steady;
}

Stage read_stage(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"stage"});
  Stage stage;
  stage.name = name.text;
  stage.mark = name.mark;
  stage.lasts = members.expression("lasts");
  stage.until = members.expression("until");
  if (stage.lasts && stage.until)
    fail(file, members.mark_of("until"), "stage '" + name.text + "' ends after a time or by an event, not both",
         "remove lasts: or until:");
  if (const Entry* loads = members.find("loads")) {
    if (loads->kind != Entry::Kind::list) fail(file, loads->mark, "expected a list of loads", "write loads: [drive]");
    stage.loads.emplace();
    for (const Entry& item : loads->items) stage.loads->push_back(scalar_text(item, file, "the name of a load"));
  }
  return stage;
}

}  // namespace poinsot::problem
