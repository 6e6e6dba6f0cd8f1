#include "problem/keys/reader.h"

#include <algorithm>
#include <cctype>

#include "problem/habits/customary_words.h"
#include "problem/keys/keys.h"
#include "problem/language/foreign_signs.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

std::string with_article(const std::string& object) {
  return (std::string_view("aeiou").find(object.front()) == std::string_view::npos ? "a " : "an ") + object;
}

}  // namespace

Members::Members(const Entry& entry, const std::string& file, std::vector<std::string_view> objects,
                 std::vector<std::string> extra)
    : entry_(&entry), file_(&file), object_(objects.front()) {
  std::vector<std::string> known = std::move(extra);
  for (std::string_view object : objects)
    for (std::string& key : keys_of(object)) known.push_back(std::move(key));
  if (entry.kind != Entry::Kind::map)
    fail(file, entry.mark, "expected a map of keys for '" + object_ + "'", "its keys are " + joined(known));
  for (const auto& member : entry.members) {
    const auto& [key, value] = member;
    if (std::find(known.begin(), known.end(), key.text) != known.end()) continue;
    const std::string custom = customary_key(key.text, known);
    const std::string near = custom.empty() ? nearest(key.text, known) : custom;
    // A number is no key: in braces the comma of 0,8 begins another entry.
    if (!key.text.empty() && key.text.front() >= '0' && key.text.front() <= '9')
      fail(file, key.mark, "a key is expected here, not '" + key.text + "'",
           "a decimal is written with a point: 0.8, not 0,8");
    if (const std::size_t blank = key.text.find(' '); blank != std::string::npos && value.is_null())
      if (const std::string word = key.text.substr(0, blank);
          std::find(known.begin(), known.end(), word) != known.end() || !customary_key(word, known).empty())
        fail(file, key.mark, "a ':' is missing behind '" + word + "'",
             "write '" + word + ": " + key.text.substr(blank + 1) + "'");
    // What stands beneath a key that has nothing yet, in the same column.
    if (&member != &entry.members.front() && custom.empty())
      if (const auto& [above, none] = *std::prev(&member); none.is_null() && above.mark.line < key.mark.line)
        fail(file, key.mark, "unknown key '" + key.text + "' in " + with_article(object_),
             "indent it farther if it belongs to '" + above.text + "'");
    fail(file, key.mark, "unknown key '" + key.text + "' in " + with_article(object_),
         near.empty() ? "known keys: " + joined(known) : "did you mean '" + near + "'?");
  }
}

const Entry* Members::find(std::string_view key) const { return entry_->find(key); }

Mark Members::mark_of(std::string_view key) const {
  const Entry* found = find(key);
  return found ? found->mark : entry_->mark;
}

const Entry& Members::require(std::string_view key, std::string_view example) const {
  if (const Entry* found = find(key)) return *found;
  fail(*file_, entry_->mark, with_article(object_) + " needs the key '" + std::string(key) + "'",
       "write " + std::string(example));
}

std::optional<Expression> Members::expression(std::string_view key) const {
  const Entry* found = find(key);
  if (!found) return std::nullopt;
  return parse_expression(*found, *file_);
}

Expression Members::require_expression(std::string_view key, std::string_view example) const {
  return parse_expression(require(key, example), *file_);
}

std::vector<Expression> Members::list(std::string_view key) const {
  const Entry* found = find(key);
  return found ? expression_list(*found, *file_) : std::vector<Expression>{};
}

std::optional<bool> Members::boolean(std::string_view key) const {
  const Entry* found = find(key);
  if (!found) return std::nullopt;
  const std::string& word = scalar_text(*found, *file_, "true or false");
  if (word == "true") return true;
  if (word == "false") return false;
  fail(*file_, found->mark, "'" + word + "' is neither true nor false");
}

std::string Members::text(std::string_view key, const char* when_absent) const {
  const Entry* found = find(key);
  return found ? scalar_text(*found, *file_, "a text") : when_absent;
}

const std::string& scalar_text(const Entry& entry, const std::string& file, std::string_view what) {
  if (entry.kind != Entry::Kind::scalar) fail(file, entry.mark, "expected " + std::string(what));
  return entry.text;
}

void check_name(const std::string& name, Mark mark, const std::string& file) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
  bool good = !name.empty() && letter(name.front());
  for (char c : name) good = good && (letter(c) || std::isdigit(static_cast<unsigned char>(c)));
  if (!name.empty() && std::isdigit(static_cast<unsigned char>(name.front())))
    fail(file, mark, "a name is expected here, not '" + name + "'",
         "names begin with a letter; a decimal is written with a point: 0.8, not 0,8");
  for (std::size_t k = 0; !good && k < name.size(); ++k)
    if (const ForeignSign foreign = foreign_sign_of_expression(std::string_view(name).substr(k)); foreign.is_letter)
      fail(file, mark, "'" + name + "' cannot be a name", foreign.hint);
  if (!good)
    fail(file, mark, "'" + name + "' cannot be a name", "names are letters, digits and _, and begin with a letter");
  for (const char* word : {"any", "pi", "time", "ground", "system", "rest", "none", "about", "along", "to", "with",
                           "from", "of", "on", "at", "by", "relative"})
    if (name == word)
      fail(file, mark, "'" + name + "' is a word of the language and cannot be a name", "choose another name");
}

std::vector<Expression> expression_list(const Entry& entry, const std::string& file) {
  if (entry.kind != Entry::Kind::list)
    fail(file, entry.mark, "expected a list in brackets [..., ...]",
         entry.kind == Entry::Kind::scalar && entry.text.size() < 60 ? "write [" + entry.text + "]" : "");
  std::vector<Expression> items;
  for (const Entry& item : entry.items) items.push_back(parse_expression(item, file));
  return items;
}

Unit read_unit(const Entry& entry, const std::string& file) {
  const std::string& text = scalar_text(entry, file, "a unit, such as kg, m or rad/s");
  try {
    return parse_unit(text);
  } catch (const std::invalid_argument& error) {
    // What people write where only a unit belongs; the first character of no text is a blank.
    const unsigned char first = text.empty() ? ' ' : static_cast<unsigned char>(text.front());
    if (std::isdigit(first) && text.find(' ') != std::string::npos)
      fail(file, entry.mark, "'" + text + "' is a value, where a unit is expected",
           "write the unit alone; what has a value stands under given:");
    if (text.find('(') != std::string::npos && std::isalpha(first) && text.find_first_of("^*/") == std::string::npos)
      fail(file, entry.mark, "'" + text + "' is no unit", "what is asked stands under ask:");
    if (text.starts_with("signed "))
      fail(file, entry.mark, "'" + text + "' is no unit", "write {signed: " + text.substr(7) + "}");
    if (const std::string unit = customary_unit_of(text); !unit.empty())
      fail(file, entry.mark, "'" + text + "' is no unit", "write " + unit);
    fail(file, entry.mark, error.what());
  }
}

const std::vector<std::pair<Key, Entry>>& named(const Members& members, std::string_view key, const std::string& file) {
  static const std::vector<std::pair<Key, Entry>> none;
  const Entry* entry = members.find(key);
  if (!entry || entry->kind == Entry::Kind::null) return none;
  if (entry->kind != Entry::Kind::map)
    fail(file, entry->mark, "expected names under '" + std::string(key) + "'",
         "write " + std::string(key) + ": {NAME: ...}");
  return entry->members;
}

}  // namespace poinsot::problem
