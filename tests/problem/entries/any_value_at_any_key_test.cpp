// Whatever stands at whatever key: an answer or a StatementError with a place, nothing else.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "problem/answers/solve_statement.h"
#include "problem/keys/keys.h"

namespace poinsot::problem {
namespace any_value_at_any_key_test {

using Json = nlohmann::ordered_json;

// One of everything, so that most keys stand beside what they need. JSON is YAML.
const Json& everything() {
  static const Json problem = Json::parse(R"json({
    "title": "one of everything",
    "given": {"b": "25 deg", "k": "3 N/m"},
    "points": {"O": "[0, 0, 0]", "A": ["0 m", "1 m", "0 m"], "B": ["0 m", "-1 m", "0 m"], "C": ["0.2 m", "0 m", "0 m"]},
    "directions": {"n": "O->A"},
    "gravity": "-y",
    "frames": {"car": {"origin": "O", "turns": "y", "rate": "1 rad/s"}},
    "bodies": {
      "disk": {"disk": {"center": "O", "normal": "y", "radius": "0.2 m"}, "mass": "3 kg"},
      "rotor": {"parts": {"hub": {"sphere": {"center": "A", "radius": "0.1 m"}, "mass": "1 kg"}}},
      "block": {"mass": "1 kg", "center": "C", "inertia": {"x": "1 kg*m^2", "y": "1 kg*m^2", "z": "1 kg*m^2"}}
    },
    "joints": {
      "shaft": {"revolute": "y", "at": "O", "to": "disk", "rate": "2 rad/s", "spring": {"stiffness": "3 N*m/rad"},
                "supports": {"A": {"force": ["x", "z"]}, "B": {"force": ["x", "y", "z"]}}},
      "sleeve": {"cylindrical": "x", "at": "O", "from": "disk", "to": "rotor",
                 "freedoms": {"turn": {"rate": "1 rad/s"}, "slide": {"rate": "1 m/s"}}},
      "guide": {"prismatic": "x", "at": "C", "to": "block", "rate": "1 m/s"}
    },
    "springs": {"coil": {"at": "A", "to": "block", "end": "C", "stiffness": "3 N/m", "free_length": "0.1 m"}},
    "loads": {"push": {"force": ["1 N", "0 N", "0 N"], "at": "C", "body": "block"}},
    "ask": {"a": {"of": "angular_momentum(disk about O)", "unit": "N*m*s"}},
    "expect": {"a": {"value": [0, 1, 0], "unit": "N*m*s", "rtol": 1e-6}}
  })json");
  return problem;
}

const std::vector<Json>& values() {
  static const std::vector<Json> list = [] {
    std::vector<Json> all = {nullptr, true, false, 0, -1, 3, 1e308, -1e-308, Json::array(), Json::object()};
    for (const char* text : {"",          " ",
                             "any",       "none",
                             "rest",      "x",
                             "y",         "-y",
                             "O",         "A",
                             "n",         "disk",
                             "ground",    "system",
                             "time",      "3 m",
                             "-3 m",      "3 kg",
                             "0 kg",      "10 lb",
                             "2 rad/s",   "25 deg",
                             "1e308 m",   "1e308 kg",
                             "1e-308 m",  "nan",
                             "inf",       "1/0",
                             "sqrt(-1)",  "kinetic_energy(disk)",
                             "a",         "b'",
                             "A->O",      "A of disk",
                             "[0, 0, 0]", "[any, any, any]",
                             "O @ now",   "1 .. 2 by 0.5",
                             "journal",   "massless",
                             "push",      "../../etc/passwd",
                             "((((",      "1 < 2",
                             "{",         "@",
                             "x'"})
      all.emplace_back(text);
    all.push_back(Json::array({1, 2, 3}));
    all.push_back(Json::array({"O", "A"}));
    all.push_back(Json::array({"O", "A", "C"}));
    all.push_back(Json::array({"x", "x", "x"}));
    all.push_back(Json::array({"1 m", "1 m", "1 m"}));
    all.push_back(Json::array({"1e308 m", "0 m", "0 m"}));
    all.push_back(Json::array({nullptr}));
    all.push_back(Json::array({Json::array({Json::array({1})})}));
    all.push_back(Json::array({Json::object()}));
    all.push_back(
        Json::array({Json::object({{"phi", "x"}}), Json::object({{"theta", "y"}}), Json::object({{"psi", "z"}})}));
    all.push_back(Json::object({{"x", 1}}));
    all.push_back(Json::object({{"x", nullptr}}));
    all.push_back(Json::object({{"A", "y"}}));
    all.push_back(Json::object({{"name", Json::object()}}));
    all.push_back(Json::object({{"name", "any"}}));
    all.push_back(Json::object({{"of", "x"}}));
    return all;
  }();
  return list;
}

using Path = Json::json_pointer;

// The paths of the maps that are an `object` of the language; a map is made where the file has none.
std::vector<Path> places_of(Json& root, std::string_view object, int depth = 0) {
  if (object == "problem") return {Path()};
  std::vector<Path> places;
  if (depth > 5) return places;
  for (const LanguageKey& key : language_keys()) {
    const bool holds_shapes = object == "shape" && key.object == "problem" && key.key == "bodies";
    if (!holds_shapes && (key.object_name != object || key.object_name == "problem")) continue;
    for (const Path& owner : places_of(root, key.object, depth + 1)) {
      if (!root[owner].is_object()) root[owner] = Json::object();
      Path place = owner / std::string(key.key);
      if (!root[place].is_object()) root[place] = Json::object();
      if (key.type != KeyType::object) {
        place = place / (root[place].empty() ? "one" : root[place].begin().key());
        if (!root[place].is_object()) root[place] = Json::object();
      }
      places.push_back(place);
    }
  }
  return places;
}

// "" if all is well.
std::string fault_of(const std::string& text) {
  try {
    const SolvedStatement solved = solve_statement(read_statement(text, "test.yaml"), {});
    return solved.solutions.empty() && solved.warnings.empty() ? "no solution and no reason" : "";
  } catch (const StatementError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics())
      if (diagnostic.mark.line < 1 || diagnostic.mark.column < 1 || diagnostic.message.empty())
        return std::string("no place: ") + error.what();
    return "";
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
}

TEST(AnyValueAtAnyKey, TheBaseHasAnAnswer) {
  const SolvedStatement solved = solve_statement(read_statement(everything().dump(), "test.yaml"), {});
  ASSERT_EQ(solved.solutions.size(), 1U);
  EXPECT_EQ(solved.solutions[0].asks[0].state, AskState::found) << solved.solutions[0].asks[0].reason;
}

TEST(AnyValueAtAnyKey, IsAnAnswerOrAnError) {
  int tried = 0;
  for (const LanguageKey& key : language_keys()) {
    for (const Json& value : values()) {
      Json problem = everything();
      for (const Path& place : places_of(problem, key.object)) problem[place / std::string(key.key)] = value;
      const std::string text = problem.dump();
      EXPECT_EQ(fault_of(text), "") << key.object << "." << key.key << ": " << value.dump() << "\n" << text;
      // The same without what stands beside it.
      for (const Path& place : places_of(problem, key.object))
        if (!place.empty() && problem.contains(place)) problem[place] = Json::object({{std::string(key.key), value}});
      EXPECT_EQ(fault_of(problem.dump()), "") << key.object << "." << key.key << " alone: " << value.dump();
      ++tried;
    }
  }
  EXPECT_GT(tried, 10000);
}

// Each key left out, each map and list emptied, wherever it stands.
TEST(AnyValueAtAnyKey, EverythingLeftOutOrEmptied) {
  const Json whole = everything().flatten();
  for (const auto& [pointer, value] : whole.items()) {
    for (Json::json_pointer path(pointer); !path.empty(); path = path.parent_pointer()) {
      for (const Json& replacement : {Json(nullptr), Json::object(), Json::array(), Json("")}) {
        Json problem = everything();
        problem[path] = replacement;
        EXPECT_EQ(fault_of(problem.dump()), "") << path.to_string() << " " << replacement.dump();
      }
      Json problem = everything();
      Json& owner = problem[path.parent_pointer()];
      if (owner.is_object())
        owner.erase(path.back());
      else
        owner.erase(static_cast<std::size_t>(std::stoul(path.back())));
      EXPECT_EQ(fault_of(problem.dump()), "") << path.to_string() << " left out";
    }
  }
}

}  // namespace any_value_at_any_key_test
}  // namespace poinsot::problem
