#include "problem/keys/planar_vectors.h"

#include <string>
#include <string_view>

#include "problem/keys/keys.h"

namespace poinsot::problem {
namespace {

class VectorsOfPlane {
 public:
  explicit VectorsOfPlane(std::size_t normal) : normal_(normal) {}

  // A map of the file, which the table of keys knows as an `object`.
  void complete_map(Entry& entry, std::string_view object) const {
    for (auto& [name, value] : entry.members) {
      const LanguageKey* key = find_key(object, name.text);
      if (!key && (object == "body" || object == "part")) key = find_key("shape", name.text);
      if (object == "problem" && (name.text == "points" || name.text == "directions")) {
        for (auto& [point, place] : value.members) complete(place);
      } else if (key && key->type == KeyType::vector) {
        complete(value);
      } else if (key && key->type == KeyType::named && !key->object_name.empty()) {
        for (auto& [each, map] : value.members) complete_map(map, key->object_name);
      } else if (key && key->type == KeyType::object) {
        complete_map(value, key->object_name.empty() ? key->key : key->object_name);
      } else {
        complete_items(value);
      }
    }
  }

 private:
  void complete(Entry& entry) const {
    if (entry.is_list() && entry.items.size() == 2 && !entry.items[0].is_list() && !entry.items[1].is_list()) {
      Entry zero;
      zero.kind = Entry::Kind::scalar;
      zero.text = "0";
      zero.mark = entry.mark;
      entry.items.insert(entry.items.begin() + static_cast<std::ptrdiff_t>(normal_), std::move(zero));
    }
    complete_items(entry);
  }
  // A list that is an item of a list is a vector: a corner, the side of a box.
  void complete_items(Entry& entry) const {
    for (Entry& item : entry.items)
      if (item.is_list()) complete(item);
  }

  std::size_t normal_;
};

}  // namespace

Entry with_vectors_of_plane(Entry problem, std::size_t normal) {
  VectorsOfPlane(normal).complete_map(problem, "problem");
  return problem;
}

}  // namespace poinsot::problem
