// Makes the JSON Schema of the problem file from the table of keys.
#include <nlohmann/json.hpp>

#include "problem/keys/keys.h"

namespace poinsot::problem {
namespace {

using Json = nlohmann::ordered_json;

Json reference(std::string_view object) { return Json{{"$ref", "#/$defs/" + std::string(object)}}; }

Json type_of(const LanguageKey& key) {
  Json expression = {{"type", {"string", "number"}}};
  const Json list = {{"type", "array"}};
  switch (key.type) {
    case KeyType::expression:
      return expression;
    case KeyType::vector:
      return {{"anyOf", {expression, list}}};
    case KeyType::list:
      return {{"anyOf", {list, expression}}};
    case KeyType::name:
    case KeyType::text:
    case KeyType::unit:
      return {{"type", {"string", "number"}}};
    case KeyType::boolean:
      return {{"type", "boolean"}};
    case KeyType::object:
      return reference(key.object_name);
    case KeyType::named:
      return {{"type", "object"},
              {"additionalProperties",
               key.object_name.empty() ? Json(true) : Json{{"anyOf", {reference(key.object_name), expression, list}}}}};
    case KeyType::any:
      // What can be one expression may also be a map of its own.
      return key.object_name.empty() ? Json::object() : Json{{"anyOf", {reference(key.object_name), expression, list}}};
  }
  return Json::object();
}

}  // namespace

std::string problem_schema() {
  Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "poinsot problem file";
  schema["$ref"] = "#/$defs/problem";
  Json definitions = Json::object();
  for (const LanguageKey& key : language_keys()) {
    Json& object = definitions[std::string(key.object)];
    object["type"] = "object";
    Json property = type_of(key);
    if (!key.meaning.empty()) property["description"] = key.meaning;
    object["properties"][std::string(key.key)] = property;
  }
  // Keys of shapes stand directly in bodies and parts. Moments of inertia are named after the axes, and facts after
  // quantities, so their maps take any key.
  for (const char* owner : {"body", "part"})
    for (const auto& [key, property] : definitions["shape"]["properties"].items())
      definitions[owner]["properties"][key] = property;
  definitions.erase("shape");
  // An instant has no keys of its own, and where there is one only it may be said to be at rest.
  definitions["instant"]["type"] = "object";
  Json& facts = definitions["problem"]["properties"]["facts"];
  facts = {{"anyOf", {facts, {{"const", "rest"}}}}};
  for (auto& [name, object] : definitions.items())
    object["additionalProperties"] =
        name == "inertia" || name == "radii_of_gyration" || name == "instant" || name == "expected";
  schema["$defs"] = definitions;
  return schema.dump(2) + "\n";
}

}  // namespace poinsot::problem
