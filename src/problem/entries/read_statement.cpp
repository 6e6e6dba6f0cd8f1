// Turns the tree of entries into a checked statement.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "problem/entries/definition_limits.h"
#include "problem/entries/name_checks.h"
#include "problem/entries/read_actions.h"
#include "problem/entries/read_asks.h"
#include "problem/entries/read_bodies.h"
#include "problem/entries/read_choices.h"
#include "problem/entries/read_claims.h"
#include "problem/entries/read_instants.h"
#include "problem/entries/read_joints.h"
#include "problem/entries/read_meshes.h"
#include "problem/entries/read_record.h"
#include "problem/entries/statement.h"
#include "problem/entries/viewing_direction.h"
#include "problem/keys/keys.h"
#include "problem/keys/laid_over.h"
#include "problem/keys/planar_vectors.h"
#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

std::vector<NamedExpression> named_expressions(const Members& members, std::string_view key, const std::string& file) {
  std::vector<NamedExpression> items;
  for (const auto& [name, value] : named(members, key, file)) {
    check_name(name.text, name.mark, file);
    items.push_back({name.text, parse_expression(value, file), name.mark});
  }
  return items;
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
    if (key.text != "title" && key.text != "source" && key.text != "view") note_units(value, file, habits);
}

// Reads `plane: [x, y]`.
MotionPlane read_plane(const Entry& entry, const std::array<std::string, 3>& axes, const std::string& file) {
  MotionPlane plane;
  plane.mark = entry.mark;
  const auto refuse = [&](const Mark& mark) {
    fail(file, mark, "a plane is named by two different axes of the figure",
         "write plane: [" + axes[0] + ", " + axes[1] + "]");
  };
  if (!entry.is_list() || entry.items.size() != 2) refuse(entry.mark);
  for (const std::size_t i : {0, 1}) {
    const Entry& item = entry.items[i];
    const auto axis = std::find(axes.begin(), axes.end(), scalar_text(item, file, "the name of an axis"));
    if (axis == axes.end()) refuse(item.mark);
    (i == 0 ? plane.first : plane.second) = static_cast<std::size_t>(axis - axes.begin());
  }
  if (plane.first == plane.second) refuse(entry.items[1].mark);
  return plane;
}

// Reads {toward: O, parameter: 398600 km^3/s^2}.
CentralGravity read_central_gravity(const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"gravity"});
  return {members.require_expression("toward", "toward: O"),
          members.require_expression("parameter", "parameter: 398600 km^3/s^2"), entry.mark};
}

std::array<std::string, 3> read_axes(const Entry& axes, const std::string& file) {
  if (axes.kind != Entry::Kind::list || axes.items.size() != 3)
    fail(file, axes.mark, "axes are three names", "write axes: [X, Y, Z]");
  std::array<std::string, 3> names;
  for (int i = 0; i < 3; ++i) {
    names[i] = scalar_text(axes.items[i], file, "the name of an axis");
    check_name(names[i], axes.items[i].mark, file);
    for (int j = 0; j < i; ++j)
      if (names[i] == names[j]) fail(file, axes.items[i].mark, "two axes have the name '" + names[i] + "'");
  }
  return names;
}

// A unit alone, that of a vector, or that of a number of either sign.
void read_unit_of(Unknown& unknown, const Entry& entry, const std::string& file) {
  const bool map = entry.kind == Entry::Kind::map;
  unknown.either_sign = map && entry.find("signed");
  unknown.vector = map && !unknown.either_sign;
  const Entry& unit = !map ? entry
                           : Members(entry, file, {"unknown"})
                                 .require(unknown.either_sign ? "signed" : "vector", "vector: N*m, or signed: s");
  if (map && entry.find("vector") && unknown.either_sign)
    fail(file, entry.mark, "the components of a vector have either sign", "write {vector: N*m} alone");
  if (!(unit.kind == Entry::Kind::scalar && unit.text == "1")) unknown.unit = read_unit(unit, file);
}

Situation read_one(const Entry& stated, const std::string& file) {
  Situation situation;
  situation.file = file;
  if (const Entry* axes = stated.find("axes")) situation.axes = read_axes(*axes, file);
  if (const Entry* plane = stated.find("plane")) situation.plane = read_plane(*plane, situation.axes, file);
  const Members members(stated, file, {"problem"});
  situation.title = members.text("title");
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
    read_unit_of(unknown, unit, file);
    situation.find.push_back(std::move(unknown));
  }
  for (const auto& [name, entry] : named(members, "choose", file))
    situation.choose.push_back(read_choice(name, entry, file));
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
  if (const Entry* gravity = members.find("gravity"); gravity && gravity->kind == Entry::Kind::map) {
    situation.central_gravity = read_central_gravity(*gravity, file);
    situation.gravity = parse_expression("none", file, gravity->mark);
  } else {
    situation.gravity = members.expression("gravity");
  }
  // The pull of a center feels the moments about axes in the plane of a planar problem too.
  const ReadContext context{file, situation.axes, situation.central_gravity ? std::nullopt : situation.plane};
  if (const Entry* view = members.find("view")) {
    if (!view->is_scalar())
      fail(file, view->mark, "a view is one text, without brackets", "write view: top, view: 40,15 or view: 0,0,1");
    situation.view = view->text;
    if (!viewing_direction(situation.view, {0, 1, 0}))
      fail(file, view->mark, "there is no view '" + situation.view + "'", "expected " + std::string(viewing_words));
  }
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
  for (Contact& friction : frictions_in(situation.joints)) {
    if (std::ranges::find(situation.contacts, friction.name, &Contact::name) != situation.contacts.end())
      fail(file, friction.friction->mark, "a contact has the name of the joint '" + friction.name + "' with friction",
           "rename one of them");
    situation.contacts.push_back(std::move(friction));
  }
  read_all("cords", situation.cords, [&](const Key& name, const Entry& entry) { return read_cord(name, entry, file); });
  for (const bool chain : {false, true})
    read_all(chain ? "chains" : "belts", situation.belts, [&](const Key& name, const Entry& entry) {
      Belt belt = read_belt(name, entry, file, chain);
      for (const Belt& other : situation.belts)
        if (other.name == belt.name)
          fail(file, name.mark, "a belt has the name of " + other.words(), "rename one of them");
      return belt;
    });
  for (Contact& friction : frictions_on(situation)) situation.contacts.push_back(std::move(friction));
  read_all("gears", situation.gears, [&](const Key& name, const Entry& entry) { return read_gear(name, entry, file); });
  for_each_law_list(situation, [&]<StatedLaw Law>(std::vector<Law>& laws) {
    read_all(Law::list, laws, [&](const Key& name, const Entry& entry) { return Law::read(name, entry, file); });
  });
  read_all("impulses", situation.impulses,
           [&](const Key& name, const Entry& entry) { return read_impulse(name, entry, file); });
  read_all("impacts", situation.impacts,
           [&](const Key& name, const Entry& entry) { return read_impact(name, entry, file); });
  read_all("strikes", situation.strikes,
           [&](const Key& name, const Entry& entry) { return read_strike(name, entry, file); });
  read_all("excitations", situation.excitations,
           [&](const Key& name, const Entry& entry) { return read_excitation(name, entry, file); });
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
  check_stated_names(situation);
  check_choices(situation);
  note_units(stated, file, situation.habits);
  for (const Letter& letter : situation.letters) situation.habits.note(letter.unit);
  for (const Unknown& unknown : situation.find) situation.habits.note(unknown.unit);
  return situation;
}

// The tree of a file, in a planar problem with three components wherever two stand for a vector.
Entry read_with_vectors(std::string_view text, const std::string& file) {
  Entry root = read_tree(text, file);
  const Entry* plane = root.find("plane");
  if (!plane) return root;
  const Entry* axes = root.find("axes");
  const std::size_t normal = read_plane(*plane, axes ? read_axes(*axes, file) : Situation{}.axes, file).normal();
  return with_vectors_of_plane(std::move(root), normal);
}

}  // namespace

Statement read_statement(std::string_view text, const std::string& file, const ReadNamedFile& read) {
  const Entry root = read_with_vectors(text, file);
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
            key.text == "situations" || key.text == "title" || key.text == "plane")
          fail(file, key.mark, "'" + key.text + "' cannot stand in a situation", "it belongs at the top of the file");
      add(name.text, laid_over(shared, entry));
      if (const Entry* find = entry.find("find"); find && find->kind == Entry::Kind::map)
        for (const auto& [unknown, unit] : find->members)
          statement.situations.back().own_unknowns.push_back(unknown.text);
    }
  }
  check_misspelt_coordinates(root, statement);
  statement.corners = has_corners(root);
  check_unused_unknowns(root, statement);
  read_meshes(statement, read);
  return statement;
}

Statement read_statement(std::string_view text, const std::string& file) {
  return read_statement(text, file, files_beside(file));
}

}  // namespace poinsot::problem
