#include "problem/entries/read_joints.h"

#include <algorithm>
#include <utility>

#include "problem/entries/keys.h"
#include "problem/entries/reader.h"

namespace poinsot::problem {
namespace {

constexpr std::pair<const char*, JointKind> kinds[] = {
    {"weld", JointKind::weld},           {"revolute", JointKind::revolute},
    {"prismatic", JointKind::prismatic}, {"cylindrical", JointKind::cylindrical},
    {"universal", JointKind::universal}, {"ball", JointKind::ball},
    {"planar", JointKind::planar},       {"screw", JointKind::screw},
};

// Reads the keys of one freedom. They stand in the joint itself if it has one freedom, else under `freedoms:`.
void read_freedom(const Members& members, const std::string& owner, const std::string& file, Freedom& freedom) {
  const char* position = freedom.turning ? "angle" : "displacement";
  const char* effort = freedom.turning ? "couple" : "force";
  for (const auto& [wrong, right] : {std::pair{freedom.turning ? "displacement" : "angle", position},
                                     std::pair{freedom.turning ? "force" : "couple", effort}})
    if (members.find(wrong))
      fail(file, members.mark_of(wrong),
           owner + (freedom.turning ? " turns" : " slides") + ": it has no '" + wrong + "'",
           std::string("write '") + right + "'");
  freedom.position = members.expression(position);
  freedom.rate = members.expression("rate");
  freedom.accel = members.expression("accel");
  freedom.effort = members.expression(effort);
  freedom.damping = members.expression("damping");
  if (const Entry* entry = members.find("spring")) {
    const Members spring(*entry, file, {"joint_spring"});
    freedom.stiffness = spring.require_expression("stiffness", "stiffness: 20 N*m/rad");
    freedom.free_position = spring.expression(freedom.turning ? "free_angle" : "free_displacement");
  }
}

bool states_freedom(const Members& members) {
  for (const char* key : {"angle", "displacement", "rate", "accel", "couple", "force", "spring", "damping"})
    if (members.find(key)) return true;
  return false;
}

Support read_support(const std::string& name, Mark mark, const Entry& entry, const std::string& file) {
  Support support;
  support.name = name;
  support.mark = mark;
  const auto read_kind = [&](const Entry& word) {
    const std::string& kind = scalar_text(word, file, "a kind of support");
    const std::vector<std::string> known = {"journal", "thrust", "collar", "hinge", "fork", "clevis", "ball"};
    if (std::find(known.begin(), known.end(), kind) == known.end()) {
      const std::string near = nearest(kind, known);
      fail(file, word.mark, "'" + kind + "' is no kind of support",
           near.empty() ? "one of journal, thrust, collar, hinge, fork, clevis, ball, or a list of directions"
                        : "did you mean '" + near + "'?");
    }
    support.kind = kind;
  };
  if (entry.kind == Entry::Kind::list) {
    support.forces = expression_list(entry, file);
  } else if (entry.kind == Entry::Kind::scalar) {
    read_kind(entry);
  } else {
    const Members members(entry, file, {"support"});
    support.forces = members.list("force");
    support.couples = members.list("couple");
    support.at = members.expression("at");
    if (const Entry* kind = members.find("kind")) read_kind(*kind);
    if (!support.kind.empty() && !(support.forces.empty() && support.couples.empty()))
      fail(file, entry.mark, "support '" + name + "' has a kind and a list of components", "state one of them");
  }
  return support;
}

}  // namespace

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"joint"});
  const std::string owner = "joint '" + name + "'";
  Joint joint;
  joint.name = name;
  joint.mark = mark;
  std::string kind_key;
  for (const auto& [key, kind] : kinds) {
    if (!members.find(key)) continue;
    if (!kind_key.empty())
      fail(file, members.mark_of(key), owner + " is both " + kind_key + " and " + key, "a joint has one kind");
    kind_key = key;
    joint.kind = kind;
    joint.place = parse_expression(*members.find(key), file);
  }
  if (kind_key.empty())
    fail(file, mark, owner + " has no kind",
         "one of weld, revolute, prismatic, cylindrical, universal, ball, planar, screw, with its axis or point");
  joint.at = members.expression("at");
  joint.from = members.find("from") ? members.text("from") : "ground";
  joint.from_mark = members.mark_of("from");
  joint.to = scalar_text(members.require("to", "to: plate"), file, "the name of a body");
  joint.to_mark = members.mark_of("to");
  joint.pitch = members.expression("pitch");
  if (joint.kind == JointKind::screw && !joint.pitch)
    fail(file, mark, owner + " is a screw without a pitch", "write pitch: 2 mm/rev");
  if (joint.kind != JointKind::screw && joint.pitch)
    fail(file, members.mark_of("pitch"), owner + " is no screw and has no pitch");

  // Adds a freedom that the kind of joint has.
  const auto add = [&](const char* freedom_name, bool turning) {
    Freedom freedom;
    freedom.name = freedom_name;
    freedom.turning = turning;
    freedom.mark = mark;
    joint.freedoms.push_back(std::move(freedom));
  };
  switch (joint.kind) {
    case JointKind::weld:
      break;
    case JointKind::revolute:
    case JointKind::screw:
      add("", true);
      break;
    case JointKind::prismatic:
      add("", false);
      break;
    case JointKind::cylindrical:
      add("turn", true);
      add("slide", false);
      break;
    case JointKind::universal:
      add("first", true);
      add("second", true);
      break;
    case JointKind::planar:
      add("slide1", false);
      add("slide2", false);
      add("turn", true);
      break;
    case JointKind::ball:
      if (const Entry* angles = members.find("angles")) {
        if (angles->kind != Entry::Kind::list || angles->items.size() != 3)
          fail(file, angles->mark, owner + ": angles are three, in order",
               "write angles: [phi: Z, theta: -Y, psi: G->A]");
        for (const Entry& item : angles->items) {
          if (item.kind != Entry::Kind::map || item.members.size() != 1)
            fail(file, item.mark, owner + ": an angle is a name and its axis", "write phi: Z");
          check_name(item.members[0].first.text, item.members[0].first.mark, file);
          add(item.members[0].first.text.c_str(), true);
          joint.freedoms.back().direction = parse_expression(item.members[0].second, file);
          joint.freedoms.back().mark = item.mark;
          // The name of an angle serves as the name of its coordinate.
          Entry word;
          word.kind = Entry::Kind::scalar;
          word.text = item.members[0].first.text;
          word.mark = item.members[0].first.mark;
          joint.freedoms.back().position = parse_expression(word, file);
        }
      }
      break;
  }
  if (members.find("angles") && joint.kind != JointKind::ball)
    fail(file, members.mark_of("angles"), owner + " is no ball: it has no ordered angles");

  if (joint.freedoms.size() == 1) {
    read_freedom(members, owner, file, joint.freedoms.front());
  } else if (states_freedom(members)) {
    std::string names;
    for (const Freedom& freedom : joint.freedoms) names += (names.empty() ? "" : ", ") + freedom.name;
    fail(file, mark, owner + " has " + (joint.freedoms.empty() ? "no freedom of its own" : "several freedoms"),
         joint.freedoms.empty() ? "state its motion under instants:" : "state each under freedoms: " + names);
  }
  if (const Entry* freedoms = members.find("freedoms")) {
    if (freedoms->kind != Entry::Kind::map) fail(file, freedoms->mark, "expected a map of freedoms");
    std::vector<std::string> names;
    for (const Freedom& freedom : joint.freedoms) names.push_back(freedom.name);
    for (const auto& [key, value] : freedoms->members) {
      const auto found = std::find(names.begin(), names.end(), key.text);
      if (found == names.end()) {
        const std::string near = nearest(key.text, names);
        std::string all;
        for (const std::string& word : names) all += (all.empty() ? "" : ", ") + word;
        fail(file, key.mark, owner + " has no freedom '" + key.text + "'",
             !near.empty() ? "did you mean '" + near + "'?" : "its freedoms are " + all);
      }
      Freedom& freedom = joint.freedoms[static_cast<std::size_t>(found - names.begin())];
      const auto coordinate = freedom.position;
      read_freedom(Members(value, file, {"freedom"}), owner + ", freedom '" + key.text + "'", file, freedom);
      if (coordinate) {
        if (freedom.position)
          fail(file, value.mark, owner + ": the angle '" + key.text + "' already has a name", "remove angle:");
        freedom.position = coordinate;
      }
    }
  }
  if (const Entry* supports = members.find("supports")) {
    joint.supports_stated = true;
    if (supports->kind != Entry::Kind::map || supports->members.empty())
      fail(file, supports->mark, owner + ": supports are named places", "write supports: {A: [y, z], B: [y, z]}");
    for (const auto& [key, value] : supports->members) {
      check_name(key.text, key.mark, file);
      joint.supports.push_back(read_support(key.text, key.mark, value, file));
    }
  }
  return joint;
}

}  // namespace poinsot::problem
