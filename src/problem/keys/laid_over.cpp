#include "problem/keys/laid_over.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "problem/keys/joint_kinds.h"
#include "problem/keys/keys.h"

namespace poinsot::problem {
namespace {

using Words = std::vector<std::string_view>;

bool is_one_of(const Words& words, std::string_view key) { return std::ranges::find(words, key) != words.end(); }

// What a map of the file says, in which an overlay may say the same in another way.
class LaidMap {
 public:
  LaidMap(Entry& base, const Entry& overlay) : base_(base), overlay_(overlay) {}

  // Where the overlay has one of these keys, others go unless it has them too.
  void replace(const Words& keys, const Words& others) {
    if (std::ranges::none_of(overlay_.members, [&](const auto& m) { return is_one_of(keys, m.first.text); })) return;
    erase(others);
  }
  // Where the overlay has another of these keys than the base, that of the base goes, with what belongs to it alone.
  void choose(const Words& ways, const Words& companions = {}) {
    const bool changes = std::ranges::any_of(
        overlay_.members, [&](const auto& m) { return is_one_of(ways, m.first.text) && !base_.find(m.first.text); });
    if (!changes || std::ranges::none_of(base_.members, [&](const auto& m) { return is_one_of(ways, m.first.text); }))
      return;
    erase(ways);
    erase(companions);
  }

 private:
  void erase(const Words& keys) {
    std::erase_if(base_.members,
                  [&](const auto& m) { return is_one_of(keys, m.first.text) && !overlay_.find(m.first.text); });
  }

  Entry& base_;
  const Entry& overlay_;
};

// Whether each of the maps in a map, but for holes, has one of the keys.
bool all_have_any(const Entry& maps, const Words& keys) {
  return std::ranges::all_of(maps.members, [&](const auto& map) {
    return map.second.find("hole") || std::ranges::any_of(map.second.members, [&](const auto& member) {
             return is_one_of(keys, member.first.text);
           });
  });
}

void replace_other_ways(Entry& base, const Entry& overlay, std::string_view object) {
  LaidMap map(base, overlay);
  if (object == "body" || object == "part") {
    Words shapes{"parts"};
    for (const LanguageKey& key : language_keys())
      if (key.object == "shape") shapes.push_back(key.key);
    const Words inertias{"radii_of_gyration", "inertia", "inertia_matrix"};
    Words numbers = inertias;
    numbers.push_back("center");
    const Words amounts{"mass", "weight", "density", "specific_weight"};
    map.choose(amounts);
    // Parts that state their own matter leave none to be shared.
    if (const Entry* parts = overlay.find("parts"); parts && !base.find("parts") && all_have_any(*parts, amounts))
      map.replace({"parts"}, amounts);
    map.choose(shapes);
    map.replace(shapes, numbers);
    map.replace(numbers, shapes);
    map.choose(inertias);
  } else if (object == "inertia" || object == "radii_of_gyration") {
    const Words symmetric{"axis", "axial", "transverse"};
    // The names of the axes are the author's.
    const auto others_in = [&](const Entry& entry) {
      Words others;
      for (const auto& [key, value] : entry.members)
        if (key.text != "about" && !is_one_of(symmetric, key.text)) others.push_back(key.text);
      return others;
    };
    map.replace(symmetric, others_in(base));
    map.replace(others_in(overlay), symmetric);
  } else if (object == "joint") {
    Words kinds;
    for (const JointKind& kind : joint_kinds()) kinds.push_back(kind.name);
    map.choose(kinds, {"angle", "displacement", "rate", "accel", "couple", "force", "spring", "damping", "friction",
                       "pitch", "angles", "freedoms", "supports"});
  } else if (object == "contact") {
    map.choose({"at", "corner"});
    map.choose({"no_slip", "friction"}, {"carries"});
  } else if (object == "load") {
    map.choose({"force", "couple"}, {"along", "about", "at"});
  }
}

// Whether the overlay begins another way to state a shape, as by its corners where center: and sides: stood.
bool begins_anew(const Entry& base, const Entry& overlay) {
  const Words ways{"corners", "center", "diagonal", "diameter"};
  return std::ranges::any_of(overlay.members, [&](const auto& member) {
    return is_one_of(ways, member.first.text) && !base.find(member.first.text);
  });
}

// object: what the table of keys knows the maps as; empty if it does not know them.
Entry laid(const Entry& base, const Entry& overlay, std::string_view object) {
  if (base.kind != Entry::Kind::map || overlay.kind != Entry::Kind::map) return overlay;
  if (find_key("shape", object) && begins_anew(base, overlay)) return overlay;
  Entry merged = base;
  replace_other_ways(merged, overlay, object);
  for (const auto& [key, value] : overlay.members) {
    const auto found = std::ranges::find_if(
        merged.members, [&word = key.text](const auto& member) { return member.first.text == word; });
    if (found == merged.members.end()) {
      merged.members.emplace_back(key, value);
      continue;
    }
    const LanguageKey* known = find_key(object, key.text);
    if (!known && (object == "body" || object == "part")) known = find_key("shape", key.text);
    const std::string_view below = !known ? "" : known->object_name.empty() ? known->key : known->object_name;
    Entry& stood = found->second;
    if (!known || known->type != KeyType::named || stood.kind != Entry::Kind::map || value.kind != Entry::Kind::map) {
      stood = laid(stood, value, known && known->type == KeyType::named ? "" : below);
      continue;
    }
    // Of what the author names himself each is a map of that kind.
    for (const auto& [name, one] : value.members) {
      const auto same = std::ranges::find_if(
          stood.members, [&word = name.text](const auto& member) { return member.first.text == word; });
      if (same == stood.members.end())
        stood.members.emplace_back(name, one);
      else
        same->second = laid(same->second, one, below);
    }
  }
  return merged;
}

}  // namespace

Entry laid_over(const Entry& base, const Entry& overlay) { return laid(base, overlay, "problem"); }

}  // namespace poinsot::problem
