#include "problem/keys/planar_vectors.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
      if (object == "problem" && (name.text == "points" || name.text == "directions" || name.text == "given")) {
        for (auto& [point, place] : value.members) complete(place);
      } else if (object == "problem" && name.text == "gravity") {
        if (value.is_map())
          complete_map(value, "gravity");
        else
          complete(value);
      } else if (key && key->type == KeyType::vector) {
        complete(value);
      } else if (object == "problem" && name.text == "expect") {
        complete_expected(value);
      } else if (key && key->type == KeyType::named && !key->object_name.empty()) {
        for (auto& [each, map] : value.members) {
          complete_map(map, key->object_name);
          if (!map.is_map()) complete_within(map);
        }
      } else if (key && key->type == KeyType::object) {
        complete_map(value, key->object_name.empty() ? key->key : key->object_name);
      } else {
        complete_items(value);
        // Corners may be written in quotes.
        if (key && key->type == KeyType::list && (find_key("shape", object) || key == find_key("shape", name.text)))
          for (Entry& corner : value.items)
            if (corner.is_scalar()) complete_text(corner.text, false);
        if (key && (key->type == KeyType::text || key->type == KeyType::name)) continue;
        complete_text(name.text, true);
        complete_within(value);
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
    if (entry.is_scalar()) complete_text(entry.text, false);
    complete_items(entry);
  }
  // What is asked, known or claimed: there a list by itself is one of several things, and within an expression a
  // vector.
  void complete_within(Entry& entry) const {
    if (entry.is_scalar()) complete_text(entry.text, true);
    for (Entry& item : entry.items) complete_within(item);
    for (auto& [name, value] : entry.members) {
      complete_text(name.text, true);
      complete_within(value);
    }
  }
  // Of answers that are known, a list by itself has the components that are shown; where they come from is told in
  // words.
  void complete_expected(Entry& entry) const {
    if (entry.is_scalar()) complete_text(entry.text, true);
    for (Entry& item : entry.items) complete_expected(item);
    for (auto& [name, value] : entry.members)
      if (name.text != "source") complete_expected(value);
  }
  // Lists of two within an expression, as in 'A + [a, b]'; those of max([a, b]) and the like are lists of numbers.
  // within: leaves a list alone that is the whole text.
  void complete_text(std::string& text, bool within) const {
    struct Bracket {
      std::size_t at = 0, comma = 0, commas = 0;
      int parentheses = 0;
      bool holds_list = false;
    };
    std::vector<Bracket> open;
    int parentheses = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '(') ++parentheses;
      if (text[i] == ')') --parentheses;
      if (text[i] == '[') {
        if (!open.empty()) open.back().holds_list = true;
        open.push_back({i, 0, 0, parentheses, false});
      }
      if (open.empty()) continue;
      Bracket& last = open.back();
      if (text[i] == ',' && parentheses == last.parentheses) {
        last.comma = i;
        ++last.commas;
      }
      if (text[i] != ']') continue;
      const std::string_view before = std::string_view(text).substr(0, last.at);
      const bool numbers = before.ends_with("max(") || before.ends_with("min(");
      const bool whole = before.find_first_not_of(' ') == std::string_view::npos &&
                         text.find_first_not_of(' ', i + 1) == std::string::npos;
      if (last.commas == 1 && !last.holds_list && !numbers && !(within && (whole || open.size() > 1))) {
        const std::size_t at = normal_ == 0 ? last.at + 1 : normal_ == 1 ? last.comma + 1 : i;
        const std::string_view zero = normal_ == 2 ? ", 0" : " 0,";
        text.insert(at, zero);
        i += zero.size();
      }
      open.pop_back();
    }
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
