// What the problem language means by a word, out of the tables of the language and of the manual.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <utility>

#include "poinsot/problem.h"
#include "problem/habits/customary_words.h"
#include "problem/keys/keys.h"
#include "problem/language/evaluate.h"
#include "problem/language/unit_table.h"
#include "problem/language/units.h"
#include "problem/quantities/describe.h"
#include "problem/quantities/quantity_functions.h"

namespace poinsot::document {

extern const std::string_view language_manual;

namespace {

using problem::FunctionForm;
using problem::LanguageKey;
using problem::NamedUnit;

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Where a key may stand.
std::string place_of(std::string_view object) {
  if (object == "problem") return "at the top of the file, or of a situation";
  if (object == "shape") return "a shape, of a body or a part";
  return fmt::format("of a{} {}", std::string_view("aeiou").find(object.front()) == std::string_view::npos ? "" : "n",
                     object);
}

// The keys below a key, in two columns.
std::string keys_below(std::string_view object) {
  std::string text;
  std::size_t width = 0;
  const std::vector<std::string> keys = problem::keys_of(object);
  for (const std::string& key : keys) width = std::max(width, key.size());
  for (const std::string& key : keys)
    text += fmt::format("    {:<{}}  {}\n", key, width, problem::find_key(object, key)->meaning);
  return text;
}

std::string help_on_keys(std::string_view word) {
  std::string text;
  for (const LanguageKey& row : problem::language_keys()) {
    if (row.key != word) continue;
    text += fmt::format("{}: {}\n    {}\n", row.key, place_of(row.object), row.meaning);
    if (row.object_name.empty() || row.object_name == "problem") continue;
    text += row.type == problem::KeyType::named ? "  each of them has\n" : "  it has\n";
    text += keys_below(row.object_name);
  }
  return text;
}

// Of links the words: "[blow](#sudden-motion)" is "blow".
std::string without_links(std::string text) {
  for (std::size_t open = text.find('['); open != std::string::npos; open = text.find('[', open + 1)) {
    const std::size_t middle = text.find("](#", open);
    const std::size_t close = middle == std::string::npos ? middle : text.find(')', middle);
    // Lists have brackets too: those of a link hold no other.
    if (close == std::string::npos || text.find('[', open + 1) < middle) continue;
    text.erase(middle, close + 1 - middle);
    text.erase(open, 1);
  }
  return text;
}

// The rows of the manual's tables that begin with a call of the function.
std::string table_rows_on(std::string_view function) {
  std::string text;
  const std::string call = fmt::format("`{}(", function);
  std::size_t from = 0;
  while (from < language_manual.size()) {
    const std::size_t end = std::min(language_manual.find('\n', from), language_manual.size());
    const std::string_view line = language_manual.substr(from, end - from);
    from = end + 1;
    const std::size_t divide = line.find(" | ");
    if (!line.starts_with("| ") || divide == std::string_view::npos || !line.ends_with(" |")) continue;
    if (line.substr(divide + 3).starts_with("|")) continue;
    if (line.substr(0, divide).find(call) == std::string_view::npos) continue;
    std::string row =
        fmt::format("{}: {}", line.substr(2, divide - 2), line.substr(divide + 3, line.size() - divide - 5));
    std::erase(row, '`');
    text += "    " + without_links(std::move(row)) + "\n";
  }
  return text;
}

std::string help_on_function(std::string_view word, const std::vector<FunctionForm>& functions, std::string_view kind) {
  for (const FunctionForm& function : functions) {
    if (function.name != word) continue;
    const std::string_view noun = problem::noun_of(word);
    return fmt::format("{}: {}{}{}\n    {}\n{}", word, kind, noun.empty() ? "" : ", the ", noun, function.form,
                       table_rows_on(word));
  }
  return "";
}

std::string help_on_unit(std::string_view word) {
  if (const NamedUnit* unit = problem::find_unit(word))
    return fmt::format("{}: a unit, {:.10g} {}, for {}\n", word, unit->factor, problem::format_unit(unit->dimension),
                       problem::to_string(unit->dimension));
  if (const problem::WrongUnit* wrong = problem::find_wrong_unit(word))
    return fmt::format("{}: no unit of the language{}{}; write {}\n", word, wrong->message.empty() ? "" : ": ",
                       wrong->message, wrong->repair);
  return "";
}

// Whether a text uses the word as a key, a call or a unit.
bool uses(std::string_view text, std::string_view word) {
  for (std::size_t i = text.find(word); i != std::string_view::npos; i = text.find(word, i + 1)) {
    const std::size_t end = i + word.size();
    const bool begins = i == 0 || !is_word_character(text[i - 1]);
    const bool ends = end >= text.size() || text[end] == ':' || text[end] == '(';
    if (begins && ends) return true;
  }
  return false;
}

// The shortest whole problem file of the manual that uses the word, without the answers that it expects.
std::optional<std::string> example_of(std::string_view word) {
  constexpr std::string_view begin_mark = "```yaml\n", end_mark = "```\n";
  std::optional<std::string> shortest;
  std::size_t from = language_manual.find(begin_mark);
  while (from != std::string_view::npos) {
    from += begin_mark.size();
    const std::size_t end = language_manual.find(end_mark, from);
    std::string_view block = language_manual.substr(from, end - from);
    if (word != "expect") block = block.substr(0, block.find("\nexpect:") + 1);
    if (uses(block, word) && (!shortest || block.size() < shortest->size())) shortest = std::string(block);
    from = language_manual.find(begin_mark, end);
  }
  return shortest;
}

std::string indented(const std::string& text) {
  std::string lines;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines += "    " + text.substr(from, end - from) + "\n";
    from = end + 1;
  }
  return lines;
}

// Whether a text has the word or its plural.
bool speaks_of(std::string_view text, std::string_view word) {
  for (std::size_t i = text.find(word); i != std::string_view::npos; i = text.find(word, i + 1)) {
    std::size_t end = i + word.size();
    if (end < text.size() && text[end] == 's') ++end;
    if ((i == 0 || !is_word_character(text[i - 1])) && (end >= text.size() || !is_word_character(text[end])))
      return true;
  }
  return false;
}

// The keys and quantities of whose meaning it is a part.
std::string help_on_mentions(std::string_view word) {
  constexpr std::size_t shortest = 3;  // of shorter ones there are too many
  if (word.size() < shortest) return "";
  std::vector<std::pair<std::string, std::string>> rows;
  for (const LanguageKey& row : problem::language_keys())
    if (speaks_of(row.meaning, word))
      rows.emplace_back(row.key, fmt::format("{}: {}", place_of(row.object), row.meaning));
  for (const FunctionForm& function : problem::quantity_functions())
    if (const std::string_view noun = problem::noun_of(function.name);
        speaks_of(noun, word) || speaks_of(table_rows_on(function.name), word))
      rows.emplace_back(function.name, noun.empty() ? "a quantity" : fmt::format("a quantity, the {}", noun));
  if (rows.empty()) return "";
  std::size_t width = 0;
  for (const auto& [key, meaning] : rows) width = std::max(width, key.size());
  std::string text = fmt::format("{}: no word of the language, which speaks of it at\n", word);
  for (const auto& [key, meaning] : rows) text += fmt::format("    {:<{}}  {}\n", key, width, meaning);
  return text;
}

}  // namespace
}  // namespace poinsot::document

namespace poinsot {

std::string language_help(std::string_view word) {
  using namespace document;
  std::string text = help_on_keys(word);
  text += help_on_function(word, problem::quantity_functions(), "a quantity");
  text += help_on_function(word, problem::mathematical_functions(), "a function");
  if (!text.empty())
    if (const auto example = example_of(word)) text += "\n  an example:\n" + indented(*example);
  text += help_on_unit(word);
  if (!text.empty()) return text;
  // What books and other programs call so may have another word here.
  const std::vector<std::string> words = language_words();
  const std::string key = problem::customary_key(word, words), call = problem::customary_call(word, words),
                    function = call.substr(0, call.find('('));
  if (key.empty() && call.empty()) return help_on_mentions(word);
  text = fmt::format("{}: no word of the language; here it is {}{}{}\n", word, key,
                     key.empty() || call.empty() ? "" : " or ", call);
  for (const std::string& one : {key, function == key ? std::string() : function})
    if (!one.empty() && one != word) text += "\n" + language_help(one);
  return text;
}

std::vector<std::string> language_words() {
  std::set<std::string> words;
  for (const auto& row : problem::language_keys()) words.emplace(row.key);
  for (const auto& function : problem::quantity_functions()) words.insert(function.name);
  for (const auto& function : problem::mathematical_functions()) words.insert(function.name);
  for (const auto& unit : problem::unit_table()) words.emplace(unit.name);
  return {words.begin(), words.end()};
}

}  // namespace poinsot
