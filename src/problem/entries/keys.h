// The keys of the problem language: one table from which the reader, the JSON Schema and the manual's tests are made.
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
  object,  // a map with its own keys, see LanguageKey::object_name
  named,   // a map from names of the author's choice to `object_name`
  any,
};

struct LanguageKey {
  std::string_view object;  // where it stands: "problem", "body", "disk", ...
  std::string_view key;
  KeyType type;
  std::string_view object_name;  // for object and named
  std::string_view meaning;
};

std::span<const LanguageKey> language_keys();

// The keys that `object` knows, in the order of the table.
std::vector<std::string> keys_of(std::string_view object);

const LanguageKey* find_key(std::string_view object, std::string_view key);

// The JSON Schema (draft 2020-12) of the problem file, made from the table.
std::string problem_schema();

}  // namespace poinsot::problem
