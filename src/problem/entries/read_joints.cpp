#include "problem/entries/read_joints.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "problem/entries/read_actions.h"
#include "problem/keys/joint_kinds.h"
#include "problem/keys/keys.h"
#include "problem/keys/reader.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// Friction in a joint: a couple or force, one number or {static, kinetic}, or what follows from a coefficient.
Friction read_joint_friction(const Entry& entry, const Mark& mark, const std::string& owner, const JointKind& kind,
                             const std::string& file) {
  const bool screw = kind.advances, guide = !screw && !kind.freedoms.front().turning;
  const std::string form = guide   ? "friction: {coefficient: 0.2}"
                           : screw ? "friction: {coefficient: 0.12, radius: 10 mm}, with the mean radius of its thread"
                                   : "friction: {coefficient: 0.1, radius: 20 mm}, with the radius of its journal";
  if (entry.is_scalar()) {
    if (screw) fail(file, mark, owner + " is a screw, whose friction follows from its thread", "write " + form);
    return read_friction(entry, mark, file);
  }
  const Members members(entry, file, {"joint_friction"});
  const Entry* coefficient = members.find("coefficient");
  if (!coefficient) {
    for (const char* key : {"radius", "thrust_radius", "length", "thread_angle"})
      if (members.find(key))
        fail(file, members.mark_of(key), owner + " states " + key + ": and no coefficient of friction",
             "write " + form + ", or coefficient: {static: 0.3, kinetic: 0.2}");
    if (screw) fail(file, mark, owner + " is a screw, whose friction follows from its thread", "write " + form);
    return {members.require_expression("static", "static: 4 N*m"),
            members.require_expression("kinetic", "kinetic: 3 N*m"), mark};
  }
  for (const char* key : {"static", "kinetic"})
    if (members.find(key))
      fail(file, members.mark_of(key), owner + " states a coefficient and " + key + ": beside it",
           "write coefficient: {static: 0.3, kinetic: 0.2}");
  Friction friction = read_friction(*coefficient, mark, file);
  friction.bearing = Bearing{members.expression("radius"), members.expression("thrust_radius"),
                             members.expression("length"), members.expression("thread_angle")};
  const auto only = [&](const char* key, bool fits, const char* where) {
    if (members.find(key) && !fits)
      fail(file, members.mark_of(key), owner + " is a " + kind.name + " and has no " + key + ": of its friction",
           std::string(key) + ": belongs to " + where);
  };
  only("radius", !guide, "the journal of a revolute joint and the thread of a screw; a guide needs no radius");
  only("thrust_radius", !guide && !screw, "the collar of a revolute joint");
  only("length", !screw, "a revolute or prismatic joint, between the two ends at which it bears");
  only("thread_angle", screw, "a screw");
  if (screw && !friction.bearing->radius)
    fail(file, mark, owner + " states a coefficient of friction and no radius of its thread", "write " + form);
  if (!guide && !friction.bearing->radius && !friction.bearing->thrust_radius)
    fail(file, mark, owner + " states a coefficient of friction and no radius at which it acts",
         "write " + form + ", or thrust_radius: with the mean radius of its collar");
  if (!guide && friction.bearing->length && !friction.bearing->radius)
    fail(file, members.mark_of("length"), owner + " states the length of a journal without its radius",
         "write radius:, or leave out length:");
  return friction;
}

// One of several freedoms rubs with a couple or force of its own.
Friction read_freedom_friction(const Entry& entry, const Mark& mark, const std::string& owner, const JointKind& kind,
                               const Freedom& freedom, const std::string& file) {
  if (kind.any_turning)
    fail(file, mark, owner + " is an angle of a ball, whose friction is against its turning about whatever axis",
         "leave out angles: and state friction: 2 N*m at the ball, or the axes as joints that turn, each with its own");
  const auto row = std::ranges::find(kind.freedoms, freedom.name, &FreedomOfKind::name);
  if (row->axis == FreedomAxis::across || row->axis == FreedomAxis::across_both)
    fail(file, mark,
         owner + " is one of two slides in a plane, whose friction is against the way that both take together",
         "state it at the joint: friction: 5 N, or friction: {coefficient: 0.3}");
  if (!entry.is_scalar() && Members(entry, file, {"joint_friction"}).find("coefficient"))
    fail(file, mark,
         owner + " states a coefficient: what a " + kind.name +
             " joint carries rubs against its whole slip, in all its ways together",
         kind.common_slip == CommonSlip::none
             ? std::string("write ") + (freedom.turning ? "a couple, friction: 2 N*m" : "a force, friction: 5 N")
             : "state it at the joint: friction: " + std::string(kind.common_slip == CommonSlip::along_and_round
                                                                     ? "{coefficient: 0.2, radius: 20 mm}"
                                                                     : "{coefficient: 0.2}"));
  return read_joint_friction(entry, mark, owner, kind, file);
}

// Friction against the slip of a joint in several ways together.
Friction read_common_friction(const Entry& entry, const Mark& mark, const std::string& owner, const Joint& joint,
                              const std::string& file) {
  const CommonSlip slip = joint.kind->common_slip;
  if (slip == CommonSlip::none)
    fail(file, mark,
         owner + " is a " + joint.kind->name +
             (joint.freedoms.empty() ? ", which does not move: it has no friction"
                                     : ": friction is a couple or force in each of its freedoms"),
         joint.freedoms.empty() ? "state it at joints that turn or slide, or as contacts with friction"
                                : "state it under freedoms: {" + std::string(joint.kind->freedoms.back().name) +
                                      ": {friction: " + (joint.kind->freedoms.back().turning ? "2 N*m" : "5 N") + "}}");
  if (slip == CommonSlip::turning && !joint.freedoms.empty())
    fail(file, mark,
         owner + " is a ball with angles in an order, and its friction is against its turning about any axis",
         "leave out angles:, or the friction");
  const bool sleeve = slip == CommonSlip::along_and_round;
  const std::string form = slip == CommonSlip::along_plane ? "friction: {coefficient: 0.2}"
                           : sleeve ? "friction: {coefficient: 0.1, radius: 20 mm}, with the radius of its post"
                                    : "friction: {coefficient: 0.1, radius: 20 mm}, with the radius of its ball";
  const auto refuse_own = [&] {
    if (sleeve)
      fail(file, mark,
           owner + " is a cylindrical joint: a couple and a force of their own are stated in each of its freedoms",
           "state it under freedoms: {slide: {friction: 5 N}}, or write " + form);
  };
  if (entry.is_scalar()) {
    refuse_own();
    return read_friction(entry, mark, file);
  }
  const Members members(entry, file, {"joint_friction"});
  const Entry* coefficient = members.find("coefficient");
  for (const char* key : {"static", "kinetic"})
    if (coefficient && members.find(key))
      fail(file, members.mark_of(key), owner + " states a coefficient and " + key + ": beside it",
           "write coefficient: {static: 0.3, kinetic: 0.2}");
  const auto only = [&](const char* key, bool fits) {
    if (members.find(key) && !(coefficient && fits))
      fail(file, members.mark_of(key),
           owner + (fits ? std::string(" states ") + key + ": and no coefficient of friction"
                         : " is a " + joint.kind->name + " and has no " + key + ": of its friction"),
           "write " + form);
  };
  only("radius", slip != CommonSlip::along_plane);
  only("thrust_radius", false);
  only("length", sleeve);
  only("thread_angle", false);
  if (!coefficient) {
    refuse_own();
    return {members.require_expression("static", "static: 4 N*m"),
            members.require_expression("kinetic", "kinetic: 3 N*m"), mark};
  }
  Friction friction = read_friction(*coefficient, mark, file);
  friction.bearing = Bearing{members.expression("radius"), {}, members.expression("length"), {}};
  if (slip != CommonSlip::along_plane && !friction.bearing->radius)
    fail(file, mark, owner + " states a coefficient of friction and no radius at which it acts", "write " + form);
  return friction;
}

// Reads the keys of one freedom. They stand in the joint itself if it has one freedom, else under `freedoms:`.
void read_freedom(const Members& members, const std::string& owner, const std::string& file, Freedom& freedom,
                  const JointKind& kind) {
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
  if (const Entry* friction = members.find("friction")) {
    const Mark& mark = members.mark_of("friction");
    freedom.friction = freedom.name.empty() ? read_joint_friction(*friction, mark, owner, kind, file)
                                            : read_freedom_friction(*friction, mark, owner, kind, freedom, file);
    if (freedom.rate && freedom.accel)
      fail(file, freedom.friction->mark,
           owner + " has rate:, accel: and friction: what drives it has to overcome the friction besides",
           "leave out the friction and subtract it from drive(...), or state what drives it");
  }
  if (freedom.rate && freedom.accel && freedom.effort)
    fail(file, members.mark_of(effort),
         owner + " has rate:, accel: and " + effort + ": " + "one too many: with rate and accel the " + effort +
             " is what is found",
         std::string("leave out accel: if the ") + effort + " drives it, or the " + effort +
             " and ask for drive(...), or state drive(...) under instants: if an unknown is to follow from it");
  if (const Entry* entry = members.find("spring")) {
    const Members spring(*entry, file, {"joint_spring"});
    freedom.stiffness = spring.require_expression("stiffness", "stiffness: 20 N*m/rad");
    freedom.free_position = spring.expression(freedom.turning ? "free_angle" : "free_displacement");
  }
}

// A bearing with two ends has its middle where the joint says that it is.
void require_middle(const Friction& friction, const Joint& joint, const std::string& owner, const std::string& file) {
  if (friction.bearing && friction.bearing->length && !joint.at && !joint.place.as<Arrow>())
    fail(file, friction.mark, owner + " states the length at which it bears, and not where",
         "write at: with the point in the middle between its ends");
}

bool states_freedom(const Members& members) {
  for (const char* key : {"angle", "displacement", "rate", "accel", "couple", "force", "spring", "damping"})
    if (members.find(key)) return true;
  return false;
}

// The angles of a ball in the order of its author.
void read_angles(const Entry& angles, const std::string& owner, const std::string& file, Joint& joint) {
  if (!joint.kind->any_turning) fail(file, angles.mark, owner + " is no ball: it has no ordered angles");
  if (angles.kind != Entry::Kind::list || angles.items.size() != 3)
    fail(file, angles.mark, owner + ": angles are three, in order", "write angles: [phi: Z, theta: -Y, psi: G->A]");
  for (const Entry& item : angles.items) {
    if (item.kind != Entry::Kind::map || item.members.size() != 1)
      fail(file, item.mark, owner + ": an angle is a name and its axis", "write phi: Z");
    const auto& [name, axis] = item.members[0];
    check_name(name.text, name.mark, file);
    Freedom freedom;
    freedom.name = name.text;
    freedom.mark = item.mark;
    freedom.direction = parse_expression(axis, file);
    // The name of an angle serves as the name of its coordinate.
    Entry word;
    word.kind = Entry::Kind::scalar;
    word.text = name.text;
    word.mark = name.mark;
    freedom.position = parse_expression(word, file);
    joint.freedoms.push_back(std::move(freedom));
  }
}

Support read_support(const std::string& name, Mark mark, const Entry& entry, const std::string& file) {
  Support support;
  support.name = name;
  support.mark = mark;
  const auto read_kind = [&](const Entry& word) {
    const std::string& kind = scalar_text(word, file, "a kind of support");
    for (const SupportKind& row : support_kinds())
      if (row.name == kind) support.kind = &row;
    if (support.kind) return;
    const std::vector<std::string> known = names_of(support_kinds());
    const std::string near = nearest(kind, known);
    fail(file, word.mark, "'" + kind + "' is no kind of support",
         near.empty() ? "one of " + joined(known) + ", or a list of directions" : "did you mean '" + near + "'?");
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
    if (support.kind && !(support.forces.empty() && support.couples.empty()))
      fail(file, entry.mark, "support '" + name + "' has a kind and a list of components", "state one of them");
  }
  if (!support.at) support.at = parse_expression(name, file, mark);
  return support;
}

}  // namespace

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"joint"});
  const std::string owner = "joint '" + name + "'";
  Joint joint;
  joint.name = name;
  joint.mark = mark;
  for (const JointKind& kind : joint_kinds()) {
    if (!members.find(kind.name)) continue;
    if (joint.kind)
      fail(file, members.mark_of(kind.name), owner + " is both " + joint.kind->name + " and " + kind.name,
           "a joint has one kind");
    joint.kind = &kind;
    joint.place = parse_expression(*members.find(kind.name), file);
  }
  if (!joint.kind)
    fail(file, mark, owner + " has no kind", "one of " + joined(names_of(joint_kinds())) + ", with its axis or point");
  joint.at = members.expression("at");
  joint.from = members.text("from", "ground");
  joint.from_mark = members.mark_of("from");
  joint.to = scalar_text(members.require("to", "to: plate"), file, "the name of a body");
  joint.to_mark = members.mark_of("to");
  joint.pitch = members.expression("pitch");
  if (joint.kind->advances && !joint.pitch)
    fail(file, mark, owner + " is a screw without a pitch", "write pitch: 2 mm/rev");
  if (!joint.kind->advances && joint.pitch)
    fail(file, members.mark_of("pitch"), owner + " is no screw and has no pitch");

  for (const FreedomOfKind& row : joint.kind->freedoms) {
    Freedom freedom;
    freedom.name = row.name;
    freedom.turning = row.turning;
    freedom.mark = mark;
    joint.freedoms.push_back(std::move(freedom));
  }
  if (const Entry* angles = members.find("angles")) read_angles(*angles, owner, file, joint);

  if (const Entry* friction = members.find("friction"); friction && joint.freedoms.size() != 1)
    joint.friction = read_common_friction(*friction, members.mark_of("friction"), owner, joint, file);
  if (joint.friction) require_middle(*joint.friction, joint, owner, file);
  if (joint.freedoms.size() == 1) {
    const Freedom& freedom = joint.freedoms.front();
    read_freedom(members, owner, file, joint.freedoms.front(), *joint.kind);
    if (freedom.friction) require_middle(*freedom.friction, joint, owner, file);
  } else if (states_freedom(members)) {
    const std::string names = joined(names_of(joint.freedoms));
    fail(file, mark, owner + " has " + (joint.freedoms.empty() ? "no freedom of its own" : "several freedoms"),
         joint.freedoms.empty() ? "state its motion under instants:" : "state each under freedoms: " + names);
  }
  if (const Entry* freedoms = members.find("freedoms")) {
    if (freedoms->kind != Entry::Kind::map) fail(file, freedoms->mark, "expected a map of freedoms");
    const std::vector<std::string> names = names_of(joint.freedoms);
    for (const auto& [key, value] : freedoms->members) {
      const auto found = std::find(names.begin(), names.end(), key.text);
      if (found == names.end()) {
        const std::string near = nearest(key.text, names);
        const std::string all = joined(names);
        fail(file, key.mark, owner + " has no freedom '" + key.text + "'",
             !near.empty() ? "did you mean '" + near + "'?" : "its freedoms are " + all);
      }
      Freedom& freedom = joint.freedoms[static_cast<std::size_t>(found - names.begin())];
      const auto coordinate = freedom.position;
      read_freedom(Members(value, file, {"freedom"}), owner + ", freedom '" + key.text + "'", file, freedom,
                   *joint.kind);
      if (freedom.friction && joint.friction &&
          !(joint.kind->common_slip == CommonSlip::along_plane && freedom.turning))
        fail(file, freedom.friction->mark,
             owner + " states friction against all its motion, and that of '" + key.text + "' besides",
             "leave out one of them");
      if (joint.friction && freedom.rate && freedom.accel)
        fail(file, value.mark,
             owner + " has friction, and rate: and accel: of '" + key.text +
                 "': what drives it has to overcome the friction besides",
             "leave out the friction, or state what drives it");
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

namespace {

Contact friction_of_joint(const Joint& joint, const std::string& name, const Friction& friction) {
  Contact rubbing;
  rubbing.name = name;
  rubbing.of = joint.to;
  rubbing.against = joint.from;
  rubbing.of_mark = joint.to_mark;
  rubbing.against_mark = joint.from_mark;
  rubbing.normal = joint.place;
  rubbing.friction = friction;
  rubbing.in_joint = true;
  rubbing.mark = joint.mark;
  return rubbing;
}

std::string name_of_friction(const Joint& joint, const Freedom& freedom) {
  return freedom.name.empty() ? joint.name : freedom.name + " of " + joint.name;
}

}  // namespace

std::vector<Contact> frictions_in(const std::vector<Joint>& joints) {
  std::vector<Contact> found;
  for (const Joint& joint : joints) {
    if (joint.friction) {
      found.push_back(friction_of_joint(joint, joint.name, *joint.friction));
      found.back().all_ways = true;
    }
    for (const Freedom& freedom : joint.freedoms) {
      if (!freedom.friction) continue;
      found.push_back(friction_of_joint(joint, name_of_friction(joint, freedom), *freedom.friction));
      if (const List* axes = joint.place.as<List>(); axes && joint.kind->given == JointGiven::two_axes)
        found.back().normal = axes->items[&freedom == &joint.freedoms.front() ? 0 : 1];
    }
  }
  return found;
}

RubbingJoint rubbing_joint(const std::vector<Joint>& joints, const std::string& friction) {
  for (const Joint& joint : joints) {
    if (joint.friction && friction == joint.name) return {joint, std::nullopt};
    for (std::size_t k = 0; k < joint.freedoms.size(); ++k)
      if (joint.freedoms[k].friction && friction == name_of_friction(joint, joint.freedoms[k])) return {joint, k};
  }
  throw std::logic_error("no joint has the friction " + friction);
}

}  // namespace poinsot::problem
