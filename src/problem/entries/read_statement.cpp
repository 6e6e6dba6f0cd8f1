// Turns the tree of entries into a checked statement.
#include <algorithm>
#include <set>

#include "problem/entries/definition_limits.h"
#include "problem/entries/keys.h"
#include "problem/entries/misspelt_coordinates.h"
#include "problem/entries/read_actions.h"
#include "problem/entries/read_asks.h"
#include "problem/entries/read_bodies.h"
#include "problem/entries/read_claims.h"
#include "problem/entries/read_joints.h"
#include "problem/entries/read_meshes.h"
#include "problem/entries/read_record.h"
#include "problem/entries/reader.h"
#include "problem/entries/statement.h"
#include "problem/entries/unused_unknowns.h"

namespace poinsot::problem {
namespace {

using Named = std::vector<std::pair<Key, Entry>>;

// The members of a map whose keys are names of the author's choice; none if the key is absent.
const Named& named(const Members& members, std::string_view key, const std::string& file) {
  static const Named none;
  const Entry* entry = members.find(key);
  if (!entry || entry->kind == Entry::Kind::null) return none;
  if (entry->kind != Entry::Kind::map)
    fail(file, entry->mark, "expected names under '" + std::string(key) + "'",
         "write " + std::string(key) + ": {NAME: ...}");
  return entry->members;
}

std::vector<NamedExpression> named_expressions(const Members& members, std::string_view key, const std::string& file) {
  std::vector<NamedExpression> items;
  for (const auto& [name, value] : named(members, key, file)) {
    check_name(name.text, name.mark, file);
    items.push_back({name.text, parse_expression(value, file), name.mark});
  }
  return items;
}

Instant read_instant(const Key& name, const Entry& entry, const std::string& file) {
  Instant instant;
  instant.name = name.text;
  instant.mark = name.mark;
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
         "state facts at the start");
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

// Checks that every name of a body or frame in the situation is one, and suggests near names.
void check_holders(const Situation& situation) {
  std::vector<std::string> bodies, holders{"ground"};
  for (const Body& body : situation.bodies) bodies.push_back(body.name);
  holders.insert(holders.end(), bodies.begin(), bodies.end());
  for (const Frame& frame : situation.frames) {
    if (std::find(bodies.begin(), bodies.end(), frame.name) != bodies.end())
      fail(situation.file, frame.mark, "'" + frame.name + "' is both a body and a frame", "rename one of them");
    holders.push_back(frame.name);
  }
  const auto check = [&](const std::string& name, Mark mark, const std::vector<std::string>& known, const char* what) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    const std::string near = nearest(name, known);
    std::string all;
    for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
    fail(situation.file, mark, "there is no " + std::string(what) + " '" + name + "'",
         !near.empty() ? "did you mean '" + near + "'?"
         : all.empty() ? "the problem has none"
                       : "known: " + all);
  };
  for (const Frame& frame : situation.frames)
    if (!frame.rides_on.empty()) check(frame.rides_on, frame.rides_on_mark, bodies, "body");
  if (situation.steady) {
    check(situation.steady->frame, situation.steady->frame_mark, holders, "body or frame");
    for (const Spin& spin : situation.steady->spins) check(spin.body, spin.mark, bodies, "body");
  }
  for (const Joint& joint : situation.joints) {
    check(joint.from, joint.from_mark, holders, "body or frame");
    if (joint.to == "ground")
      fail(situation.file, joint.to_mark, "joint '" + joint.name + "' holds the ground",
           "the ground holds and is not held: write it under from:");
    check(joint.to, joint.to_mark, bodies, "body");
    if (joint.from == joint.to)
      fail(situation.file, joint.mark, "joint '" + joint.name + "' joins '" + joint.to + "' to itself");
  }
  for (const Contact& contact : situation.contacts) {
    check(contact.of, contact.of_mark, bodies, "body");
    check(contact.against, contact.against_mark, holders, "body or frame");
  }
  for (const Cord& cord : situation.cords) {
    check(cord.from, cord.from_mark, holders, "body or frame");
    check(cord.to, cord.to_mark, bodies, "body");
  }
  for (const Spring& spring : situation.springs) {
    check(spring.from, spring.from_mark, holders, "body or frame");
    check(spring.to, spring.to_mark, bodies, "body");
  }
  for (const Impulse& impulse : situation.impulses) {
    check(impulse.body, impulse.body_mark, bodies, "body");
    check(impulse.axes, impulse.axes_mark, holders, "body or frame");
  }
  for (const Impact& impact : situation.impacts) {
    check(impact.of, impact.of_mark, bodies, "body");
    check(impact.against, impact.against_mark, holders, "body or frame");
  }
  for (const Strike& strike : situation.strikes) {
    check(strike.hits, strike.hits_mark, bodies, "body");
    check(strike.relative_to, strike.relative_to_mark, holders, "body or frame");
  }
  for (const Load& load : situation.loads) {
    check(load.body, load.body_mark, bodies, "body");
    check(load.axes, load.axes_mark, holders, "body or frame");
  }
  for (const Stage& stage : situation.stages)
    for (const std::string& load : stage.loads.value_or(std::vector<std::string>{})) {
      std::vector<std::string> loads;
      for (const Load& known : situation.loads) loads.push_back(known.name);
      check(load, stage.mark, loads, "load");
    }
}

// Counts the units that the situation is stated in.
void note_units(const Entry& entry, const std::string& file, UnitHabits& habits) {
  if (entry.is_scalar() && !entry.quoted) {
    try {
      habits.note(parse_expression(entry, file));
    } catch (const StatementError&) {
      // The text is no expression but a title or a file name.
    }
  }
  for (const Entry& item : entry.items) note_units(item, file, habits);
  for (const auto& [key, value] : entry.members)
    if (key.text != "title" && key.text != "source") note_units(value, file, habits);
}

// `choose:` may name impulses, loads and added masses, `without:` added masses only; the latter are taken out here.
void check_choices(Situation& situation) {
  std::vector<std::string> added, all;
  for (const Body& body : situation.bodies)
    for (const Part& part : body.added) added.push_back(part.name);
  all = added;
  for (const Impulse& impulse : situation.impulses) all.push_back(impulse.name);
  for (const Load& load : situation.loads) all.push_back(load.name);
  for (const Choice& choice : situation.choose)
    for (const std::string& name : choice.of)
      if (std::find(all.begin(), all.end(), name) == all.end())
        fail(situation.file, choice.mark, "'" + name + "' is no impulse, load or added mass", did_you_mean(name, all));
  for (const std::string& name : situation.without)
    if (std::find(added.begin(), added.end(), name) == added.end())
      fail(situation.file, Mark{1, 1}, "without: '" + name + "' is no added mass", did_you_mean(name, added));
  for (Body& body : situation.bodies)
    std::erase_if(body.added, [&](const Part& part) {
      return std::find(situation.without.begin(), situation.without.end(), part.name) != situation.without.end();
    });
}

Situation read_one(const Entry& root, const std::string& file) {
  const Members members(root, file, {"problem"});
  Situation situation;
  situation.file = file;
  situation.title = members.text("title");
  if (const Entry* axes = members.find("axes")) {
    if (axes->kind != Entry::Kind::list || axes->items.size() != 3)
      fail(file, axes->mark, "axes are three names", "write axes: [X, Y, Z]");
    for (int i = 0; i < 3; ++i) {
      situation.axes[i] = scalar_text(axes->items[i], file, "the name of an axis");
      check_name(situation.axes[i], axes->items[i].mark, file);
      for (int j = 0; j < i; ++j)
        if (situation.axes[i] == situation.axes[j])
          fail(file, axes->items[i].mark, "two axes have the name '" + situation.axes[i] + "'");
    }
  }
  const ReadContext context{file, situation.axes};
  situation.given = named_expressions(members, "given", file);
  for (const auto& [name, unit] : named(members, "letters", file)) {
    check_name(name.text, name.mark, file);
    situation.letters.push_back(read_letter(name, unit, file));
  }
  for (const auto& [name, unit] : named(members, "find", file)) {
    check_name(name.text, name.mark, file);
    Unknown unknown;
    unknown.name = name.text;
    unknown.mark = name.mark;
    unknown.vector = unit.kind == Entry::Kind::map;
    const Entry& text = unknown.vector ? Members(unit, file, {"unknown"}).require("vector", "vector: N*m") : unit;
    if (!(text.kind == Entry::Kind::scalar && text.text == "1")) unknown.unit = read_unit(text, file);
    situation.find.push_back(std::move(unknown));
  }
  for (const auto& [name, entry] : named(members, "choose", file)) {
    check_name(name.text, name.mark, file);
    const Members choice(entry, file, {"choice"});
    Choice stated;
    stated.name = name.text;
    stated.mark = name.mark;
    const Entry& of = choice.require("of", "of: [A, B, C, D]");
    if (of.kind != Entry::Kind::list) fail(file, of.mark, "expected a list of names", "write of: [A, B, C, D]");
    for (const Entry& item : of.items) stated.of.push_back(scalar_text(item, file, "a name"));
    if (stated.of.size() > 16) fail(file, of.mark, "a choice among more than 16 things is too large");
    if (const Entry* least = choice.find("least")) {
      if (choice.find("exactly"))
        fail(file, choice.mark_of("least"), "a choice states `exactly` or `least`, not both", "remove one of them");
      if (scalar_text(*least, file, "the word total") != "total")
        fail(file, least->mark, "'" + least->text + "' is nothing of which the least can be chosen",
             "write least: total, for the least sum of their amounts");
      stated.least_total = true;
      situation.choose.push_back(std::move(stated));
      continue;
    }
    const std::string& count =
        scalar_text(choice.require("exactly", "exactly: 2, or least: total"), file, "a whole number");
    if (count.empty() || count.size() > 2 || count.find_first_not_of("0123456789") != std::string::npos ||
        stoul(count) > stated.of.size())
      fail(file, choice.mark_of("exactly"),
           "'" + count + "' is no number of things among " + std::to_string(stated.of.size()));
    stated.exactly = std::stoi(count);
    situation.choose.push_back(std::move(stated));
  }
  if (const Entry* without = members.find("without")) {
    if (without->kind != Entry::Kind::list)
      fail(file, without->mark, "expected a list of names", "write without: [A, B]");
    for (const Entry& item : without->items)
      situation.without.push_back(scalar_text(item, file, "the name of an added mass"));
  }
  situation.neglect = members.list("neglect");
  for (const Expression& square : situation.neglect) {
    const Binary* power = square.as<Binary>();
    const Name* name = power && power->operation == '^' ? power->left.as<Name>() : nullptr;
    const Number* two = power ? power->right.as<Number>() : nullptr;
    if (!name || !two || two->value != 2 || two->has_unit)
      fail(file, square.mark(), "only squares of unknowns can be neglected", "write neglect: [phidot^2]");
    if (std::none_of(situation.find.begin(), situation.find.end(),
                     [&](const Unknown& unknown) { return unknown.name == name->name; }))
      fail(file, square.mark(),
           "'" + name->name + "' is no unknown under find:", "only squares of unknowns can be neglected");
  }
  situation.where = members.list("where");
  situation.assume = read_assumptions(members, file);
  situation.gravity = members.expression("gravity");
  situation.points = named_expressions(members, "points", file);
  situation.directions = named_expressions(members, "directions", file);
  situation.define = named_expressions(members, "define", file);
  const auto read_all = [&](std::string_view key, auto& list, auto read) {
    for (const auto& [name, entry] : named(members, key, file)) {
      check_name(name.text, name.mark, file);
      list.push_back(read(name, entry));
    }
  };
  read_all("frames", situation.frames,
           [&](const Key& name, const Entry& entry) { return read_frame(name, entry, file); });
  read_all("bodies", situation.bodies,
           [&](const Key& name, const Entry& entry) { return read_body(name.text, name.mark, entry, context); });
  read_all("joints", situation.joints,
           [&](const Key& name, const Entry& entry) { return read_joint(name.text, name.mark, entry, file); });
  read_all("contacts", situation.contacts,
           [&](const Key& name, const Entry& entry) { return read_contact(name, entry, file); });
  read_all("cords", situation.cords, [&](const Key& name, const Entry& entry) { return read_cord(name, entry, file); });
  read_all("springs", situation.springs,
           [&](const Key& name, const Entry& entry) { return read_spring(name, entry, file); });
  read_all("loads", situation.loads, [&](const Key& name, const Entry& entry) { return read_load(name, entry, file); });
  read_all("impulses", situation.impulses,
           [&](const Key& name, const Entry& entry) { return read_impulse(name, entry, file); });
  read_all("impacts", situation.impacts,
           [&](const Key& name, const Entry& entry) { return read_impact(name, entry, file); });
  read_all("strikes", situation.strikes,
           [&](const Key& name, const Entry& entry) { return read_strike(name, entry, file); });
  read_all("stages", situation.stages,
           [&](const Key& name, const Entry& entry) { return read_stage(name, entry, file); });
  if (const Entry* steady = members.find("steady")) situation.steady = read_steady(*steady, file);
  for (const auto& [name, entry] : named(members, "instants", file))
    situation.instants.push_back(read_instant(name, entry, file));
  if (const Entry* facts = members.find("facts"))
    situation.instants.push_back(read_instant(Key{"facts", facts->mark}, *facts, file));
  // Equations are solved as full matrices, so that a machine of more bodies would take minutes.
  constexpr std::size_t most_bodies = 100;
  if (situation.bodies.size() > most_bodies)
    fail(file, situation.bodies[most_bodies].mark, "there are more than " + std::to_string(most_bodies) + " bodies",
         "bodies that never move apart are parts: of one");
  check_definition_limits(situation);
  check_holders(situation);
  check_choices(situation);
  note_units(root, file, situation.habits);
  for (const Letter& letter : situation.letters) situation.habits.note(letter.unit);
  for (const Unknown& unknown : situation.find) situation.habits.note(unknown.unit);
  return situation;
}

// Lays one entry over another: maps are merged key by key, everything else is replaced.
Entry laid_over(const Entry& base, const Entry& overlay) {
  if (base.kind != Entry::Kind::map || overlay.kind != Entry::Kind::map) return overlay;
  Entry merged = base;
  for (const auto& [key, value] : overlay.members) {
    const auto found = std::find_if(merged.members.begin(), merged.members.end(),
                                    [&name = key.text](const auto& member) { return member.first.text == name; });
    if (found == merged.members.end())
      merged.members.emplace_back(key, value);
    else
      found->second = laid_over(found->second, value);
  }
  return merged;
}

}  // namespace

Statement read_statement(std::string_view text, const std::string& file, const ReadNamedFile& read) {
  const Entry root = read_tree(text, file);
  const Members members(root, file, {"problem"});
  Statement statement;
  statement.file = file;
  statement.title = members.text("title");
  for (const auto& [name, entry] : named(members, "ask", file)) {
    check_name(name.text, name.mark, file);
    statement.asks.push_back(read_ask(name, entry, file));
  }
  for (const auto& [name, entry] : named(members, "claim", file)) {
    check_name(name.text, name.mark, file);
    statement.claims.push_back(read_claim(name, entry, file));
    for (const Ask& ask : statement.asks)
      if (ask.name == name.text)
        fail(file, name.mark, "'" + name.text + "' is the name of a question and of a claim", "rename one of them");
  }
  if (const Entry* record = members.find("record")) statement.record = read_record(*record, file);
  if (const Entry* expect = members.find("expect")) {
    statement.expects = true;
    statement.expected = read_expect(*expect, file);
  }
  Entry shared = root;
  std::erase_if(shared.members, [](const auto& member) {
    const std::string& key = member.first.text;
    return key == "ask" || key == "claim" || key == "record" || key == "expect" || key == "situations";
  });
  const auto add = [&](const std::string& name, const Entry& entry) {
    statement.situations.push_back(read_one(entry, file));
    statement.situations.back().name = name;
  };
  const Entry* situations = members.find("situations");
  if (!situations) {
    add("", shared);
  } else {
    if (situations->kind != Entry::Kind::map || situations->members.empty())
      fail(file, situations->mark, "expected named situations", "write situations: {measured: {...}, balanced: {...}}");
    for (const auto& [name, entry] : situations->members) {
      check_name(name.text, name.mark, file);
      if (entry.kind != Entry::Kind::map) fail(file, entry.mark, "a situation is a map of what differs in it");
      for (const auto& [key, value] : entry.members)
        if (key.text == "ask" || key.text == "claim" || key.text == "record" || key.text == "expect" ||
            key.text == "situations" || key.text == "title")
          fail(file, key.mark, "'" + key.text + "' cannot stand in a situation", "it belongs at the top of the file");
      add(name.text, laid_over(shared, entry));
      if (const Entry* find = entry.find("find"); find && find->kind == Entry::Kind::map)
        for (const auto& [unknown, unit] : find->members)
          statement.situations.back().own_unknowns.push_back(unknown.text);
    }
  }
  check_misspelt_coordinates(root, statement);
  check_unused_unknowns(root, statement);
  read_meshes(statement, read);
  return statement;
}

Statement read_statement(std::string_view text, const std::string& file) {
  return read_statement(text, file, files_beside(file));
}

}  // namespace poinsot::problem
