// The manual of the problem language is true and whole: its examples are solved and give the answers that they expect,
// no key and no function is without one, and its messages are those of the program.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "docs/fenced_blocks.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "problem/answers/solve_statement.h"
#include "problem/keys/keys.h"
#include "problem/language/evaluate.h"
#include "problem/language/failure.h"
#include "problem/language/tree.h"
#include "problem/language/unit_table.h"
#include "problem/quantities/quantities.h"

namespace poinsot {
namespace language_page_test {

namespace fs = std::filesystem;
using problem::Entry;
using problem::KeyType;
using problem::LanguageKey;

constexpr const char* language_page = "docs/language.md";

// A folder with the files that the pages hold, for as long as the tests run.
class Folder {
 public:
  Folder() : path_(fs::path(::testing::TempDir()) / ("poinsot-docs-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }

 private:
  fs::path path_;
};

struct Example {
  std::string page;
  FencedBlock block;
};

std::vector<Example> examples() {
  std::vector<Example> all;
  for (const char* page : {language_page, "README.md"})
    for (FencedBlock& block : fenced_blocks(page))
      if (block.kind == "yaml") all.push_back({page, std::move(block)});
  return all;
}

std::string place(const Example& example) { return example.page + ":" + std::to_string(example.block.line); }

TEST(Manual, ExamplesGiveTheAnswersThatTheyExpect) {
  int count = 0;
  for (const Example& example : examples()) {
    EXPECT_TRUE(example.block.text.starts_with("title: ")) << place(example);
    const Folder folder;
    for (const FencedBlock& block : fenced_blocks(example.page))
      if (!block.name.empty() && block.kind != "yaml") folder.write(block.name, block.text);
    const Problem problem = Problem::from_file(folder.write("example.yaml", example.block.text));
    for (const std::string& failure : problem.check()) ADD_FAILURE() << place(example) << ": " << failure;
    ++count;
  }
  EXPECT_GT(count, 30);
}

using KeySet = std::set<std::pair<std::string, std::string>>;

// The keys of the table that stand in an entry which is read as `objects` (a body is also a shape).
void collect_keys(const Entry& entry, const std::vector<std::string>& objects, KeySet& keys) {
  for (const auto& [key, value] : entry.members) {
    for (const std::string& object : objects) {
      const LanguageKey* known = problem::find_key(object, key.text);
      if (!known) continue;
      keys.emplace(object, key.text);
      const auto objects_of = [](const LanguageKey& owner) {
        std::vector<std::string> names{std::string(owner.object_name)};
        if (owner.object_name == "body" || owner.object_name == "part") names.emplace_back("shape");
        return names;
      };
      const bool one_or_map = known->type == KeyType::any && !known->object_name.empty();
      if (known->type == KeyType::object || one_or_map) collect_keys(value, objects_of(*known), keys);
      // What a cord is led over, and a wheel on which it winds: names, or maps of one name.
      const bool wheels = (object == "cord" || object == "belt" || object == "chain") &&
                          (key.text == "over" || key.text == "from" || key.text == "to");
      if (wheels) {
        std::vector<Entry> stops = value.items;
        stops.push_back(value);
        for (const Entry& stop : stops)
          for (const auto& [name, wheel] : stop.members) collect_keys(wheel, {"cord_wheel"}, keys);
      }
      if (known->type != KeyType::named || known->object_name.empty()) continue;
      for (const auto& [name, item] : value.members) {
        collect_keys(item, objects_of(*known), keys);
        // `cases:` of an expect block hold blocks of the same kind.
        if (known->object_name == "expected" && name.text == "cases")
          for (const auto& [case_name, parts] : item.members)
            for (const auto& [part, expected] : parts.members) collect_keys(expected, {"expected"}, keys);
      }
    }
  }
}

TEST(LanguagePage, EveryKeyStandsInAnExample) {
  KeySet used;
  for (const Example& example : examples())
    if (example.page == language_page)
      collect_keys(problem::read_tree(example.block.text, place(example)), {"problem"}, used);
  for (const LanguageKey& key : problem::language_keys())
    EXPECT_TRUE(used.contains({std::string(key.object), std::string(key.key)}))
        << "the key '" << key.key << "' of a " << key.object;
}

TEST(LanguagePage, EveryFunctionStandsInAnExampleAndInTheText) {
  std::string examples_text, prose = text_of_page(language_page);
  for (const Example& example : examples())
    if (example.page == language_page) examples_text += example.block.text;
  for (const FencedBlock& block : fenced_blocks(language_page))
    if (const std::size_t at = prose.find(block.text); at != std::string::npos) prose.erase(at, block.text.size());
  std::vector<std::string> names;
  for (const auto& function : problem::quantity_functions()) names.push_back(function.name);
  for (const auto& function : problem::mathematical_functions()) names.push_back(function.name);
  ASSERT_GT(names.size(), 40U);
  for (const std::string& name : names) {
    const std::regex call("\\b" + name + "\\(");
    EXPECT_TRUE(std::regex_search(examples_text, call)) << name << "() stands in no example";
    EXPECT_TRUE(std::regex_search(prose, std::regex("\\b" + name + "\\b"))) << name << " is not explained";
  }
}

TEST(LanguagePage, EveryUnitIsListed) {
  const std::string page = text_of_page(language_page);
  const std::size_t begin = page.find("* **Units**"), end = page.find("\n* ", begin + 1);
  ASSERT_NE(begin, std::string::npos);
  std::set<std::string> listed;
  const std::string list = page.substr(begin, end - begin);
  const std::regex word("[^\\s`,]+");
  for (std::sregex_iterator it(list.begin(), list.end(), word), none; it != none; ++it) listed.insert(it->str());
  for (const problem::NamedUnit& unit : problem::unit_table())
    EXPECT_TRUE(listed.contains(std::string(unit.name))) << unit.name;
}

TEST(LanguagePage, WordsThatCannotBeNamesAreListed) {
  const std::string page = text_of_page(language_page);
  const std::regex list("words are taken: `([a-z ]+)`");
  std::string flat = page;
  std::ranges::replace(flat, '\n', ' ');
  std::smatch match;
  ASSERT_TRUE(std::regex_search(flat, match, list));
  std::istringstream words(match[1].str());
  int count = 0;
  for (std::string word; words >> word; ++count) {
    const std::string text = "title: t\ngiven: {" + word + ": 1 m}\nask: {a: system}\n";
    EXPECT_EQ(problem::failure_of([&] { problem::read_statement(text, "f"); }),
              "f:2:9: error: '" + word + "' is a word of the language and cannot be a name (choose another name)");
  }
  EXPECT_GT(count, 10);
}

// Wrong files with the messages that the page shows for them.
TEST(LanguagePage, ShowsMessagesOfTheProgram) {
  const std::string bar = "points: {A: [0, 0, 0], B: [1 m, 0, 0]}\nbodies: {bar: {rod: [A, B], mass: 2 kg}}\n";
  const std::vector<std::string> wrong{
      "bodies: {bar: {rod: [[0,0,0], [1 m, 0, 0]], mass: 10 lb}}\nask: {a: mass(bar)}\n",
      bar + "joints: {pin: {revolut: z, to: bar}}\nask: {a: mass(bar)}\n",
      bar + "ask: {a: momentum(bra)}\n",
      "given: {L: 3 ft, F: 5 lb}\nbodies: {bar: {rod: [[0,0,0], [L + F, 0, 0]], mass: 10 kg}}\nask: {a: mass(bar)}\n",
      bar + "joints: {pin: {revolute: z, at: A, to: bar, rate: 3 rad/s, angle: 25}}\nask: {a: momentum(bar)}\n",
      bar +
          "joints: {pin: {revolute: z, at: A, to: bar, rate: 3 rad/s}}\n"
          "instants: {now: {velocity(bar).y: 9 m/s}}\ngravity: none\nask: {a: momentum(bar)}\n",
  };
  std::string shown;
  for (const FencedBlock& block : fenced_blocks(language_page))
    if (block.kind == "text" && block.text.find("error:") != std::string::npos) shown += block.text;
  std::string found;
  for (const std::string& text : wrong)
    found += problem::failure_of(
                 [&] { problem::solve_statement(problem::read_statement("title: t\n" + text, "x.yaml"), {}); }) +
             "\n";
  EXPECT_EQ(shown, found);
}

// Why an answer cannot be given, as the table of the page has it.
TEST(LanguagePage, ShowsReasonsOfTheProgram) {
  const std::string page = text_of_page(language_page);
  const std::string bar =
      "title: t\npoints: {A: [0, 0, 0], B: [1 m, 0, 0]}\n"
      "bodies: {bar: {cylinder: {center: B/2, axis: x, radius: 1 cm, length: 1 m}, mass: 2 kg}}\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"joints: {pin: {revolute: z, at: A, to: bar, rate: 1 rad/s, accel: 0}}\nask: {a: reaction(pin)}\n",
       "it depends on gravity, of which nothing is said"},
      {"joints: {pin: {revolute: z, at: A, to: bar}}\nask: {a: momentum(bar)}\n",
       "nothing fixes the rate of joint 'pin'"},
      {"joints: {pin: {revolute: x, at: A, to: bar, rate: 0, supports: {A: thrust, B: [x, y, z]}}}\ngravity: -y\n"
       "ask: {a: reaction(A).x}\n",
       "force(A) along x and force(B) along x share the same load"},
      {"situations: {one: {bodies: {bar: {mass: any}}}}\nask: {a: mass(bar) @ one}\n",
       "it depends on a value that is given as `any`"},
      {"cords: {c: {holds: bar, at: A, pulls: -y}}\ngravity: -y\ninstants: {now: rest}\nask: {a: tension(c)}\n",
       "the cord 'c' would have to push: it goes slack"},
  };
  const Folder folder;
  for (const auto& [text, reason] : cases) {
    EXPECT_NE(page.find(reason), std::string::npos) << reason;
    const Document document = Problem::from_text(bar + text, "reason.yaml").solve();
    const std::string& found = document.solutions.at(0).answers.at(0).reason;
    EXPECT_NE(found.find(reason), std::string::npos) << text << "gives: " << found;
  }
}

}  // namespace language_page_test
}  // namespace poinsot
