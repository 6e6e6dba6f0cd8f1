// What holds the bodies of a figure: joints, supports, contacts, cords, springs.
#include <algorithm>

#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/scene/scene_figure.h"
#include "problem/scene/scene_words.h"

namespace poinsot::problem {
namespace {

using scene::SymbolKind;

// The symbols by the names that the language gives to kinds; the ball of a joint is another one than that of a support.
SymbolKind joint_symbol(const JointKind& kind) { return kind_of_word<SymbolKind>(kind.name).value(); }
SymbolKind support_symbol(const SupportKind* kind) {
  if (kind == nullptr) return SymbolKind::listed_support;
  return kind->name == "ball" ? SymbolKind::ball_support : kind_of_word<SymbolKind>(kind->name).value();
}

}  // namespace

void SceneFigure::add_symbols() {
  for (const Joint& joint : situation_.joints) {
    const JointPlace& place = machine_.joints.at(joint.name);
    scene::Symbol symbol;
    symbol.kind = joint_symbol(*joint.kind);
    symbol.name = joint.name;
    symbol.from = scene_body(place.from);
    symbol.to = scene_body(place.to);
    symbol.place = scene_place(place.at);
    // As drawn, the axes of all bodies are those of the ground.
    if (joint.kind->given == JointGiven::two_axes) {
      const List* axes = joint.place.as<List>();
      symbol.axis = data_.direction(axes->items[0]);
      symbol.second_axis = data_.direction(axes->items[1]);
    } else if (place.axis) {
      symbol.axis = place.axis->vector;
    }
    if (!joint.supports_stated) {
      scene_.symbols.push_back(symbol);
      continue;
    }
    for (const Support& support : joint.supports) {
      symbol.kind = support_symbol(support.kind);
      symbol.name = support.name;
      symbol.place = scene_place(machine_.place(place.to, data_.place(*support.at)));
      scene_.symbols.push_back(symbol);
    }
  }
  for (const Contact& contact : situation_.contacts) {
    scene::Symbol symbol;
    symbol.kind = contact.no_slip ? SymbolKind::rolling_contact : SymbolKind::contact;
    symbol.name = contact.name;
    const int of = machine_.index.at(contact.of), against = machine_.index.at(contact.against);
    symbol.from = scene_body(against);
    symbol.to = scene_body(of);
    symbol.place = scene_place(machine_.place(of, data_.place(contact.at)));
    const Vector3<double> normal = state_.on_ground_axes(against, data_.direction(contact.normal));
    symbol.axis = transpose_times(pose_of(of, state_).R, normal);
    scene_.symbols.push_back(symbol);
  }
}

void SceneFigure::add_links() {
  for (const Cord& cord : situation_.cords) {
    scene::Link link;
    link.kind = scene::LinkKind::cord;
    link.name = cord.name;
    const Place<double> end = machine_.place(machine_.index.at(cord.to), data_.place(*cord.end));
    link.from = scene_place(end);
    if (cord.direction) {
      link.far = true;
      link.to = {scene::ground, state_.position(end) + data_.direction(*cord.direction)};
    } else {
      link.to = scene_place(machine_.place(machine_.index.at(cord.from), data_.place(*cord.at)));
    }
    scene_.links.push_back(link);
  }
  for (const Spring& spring : situation_.springs) {
    scene::Link link;
    link.name = spring.name;
    const int to = machine_.index.at(spring.to), from = machine_.index.at(spring.from);
    if (spring.about) {
      link.kind = scene::LinkKind::torsion;
      // It has no place of its own: it is drawn where the two bodies are held together.
      scene::Place place = scene_place({to, Vector3<double>::zero()});
      for (const auto& [name, joint] : machine_.joints)
        if ((joint.to == to && joint.from == from) || (joint.to == from && joint.from == to))
          place = scene_place(joint.at);
      link.from = link.to = place;
    } else {
      link.kind = spring.stiffness ? scene::LinkKind::spring : scene::LinkKind::damper;
      link.from = scene_place(machine_.place(from, data_.place(*spring.at)));
      link.to = scene_place(machine_.place(to, data_.place(*spring.end)));
    }
    scene_.links.push_back(link);
  }
}

}  // namespace poinsot::problem
