// The keys of the problem language in one table, from which the reader, the JSON Schema and the tests of the manual
// are made.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::problem {

enum class KeyType {
  expression,  // a number, quantity, place or direction
  vector,      // an expression, or a list of three
  list,        // a list of expressions
  name,        // the name of a body, frame or the like
  text,
  boolean,
  unit,
  object,  // a map with keys of its own, which are those of LanguageKey::object_name
  named,   // a map from names that the author chooses to objects of the kind object_name
  any,
};

struct LanguageKey {
  std::string_view object;  // the map in which the key stands: "problem", "body", "disk", ...
  std::string_view key;
  KeyType type;
  std::string_view object_name;  // for the types `object` and `named`
  std::string_view meaning;
};

std::span<const LanguageKey> language_keys();

// The keys that `object` can have, in the order of the table.
std::vector<std::string> keys_of(std::string_view object);

const LanguageKey* find_key(std::string_view object, std::string_view key);

// The JSON Schema (draft 2020-12) of the problem file, made from the table.
std::string problem_schema();

}  // namespace poinsot::problem
