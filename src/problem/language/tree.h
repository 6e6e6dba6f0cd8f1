// The problem file as a tree of entries with marks: texts, lists and maps. Nothing is interpreted yet.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// The key of a map's member.
struct Key {
  std::string text;
  Mark mark;
};

struct Entry {
  enum class Kind { null, scalar, list, map };

  // From the offset `start` of the value on, the text stands in the file from `mark` on.
  struct Run {
    std::size_t start = 0;
    Mark mark;
  };

  // These are defined where Entry is complete, since a pair with an incomplete type must not be instantiated.
  Entry();
  Entry(const Entry&);
  Entry(Entry&&) noexcept;
  Entry& operator=(const Entry&);
  Entry& operator=(Entry&&) noexcept;
  ~Entry();

  Kind kind = Kind::null;
  std::string text;     // of a scalar
  bool quoted = false;  // of a scalar: whether it stands in quotes or as a block
  std::vector<Entry> items;
  std::vector<std::pair<Key, Entry>> members;  // in file order; keys are unique
  Mark mark;
  std::vector<Run> runs;  // of a scalar in quotes or over several lines, the places of its pieces

  bool is_null() const { return kind == Kind::null; }
  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }

  // The value or the key of a member; nullptr if there is none or the entry is no map.
  const Entry* find(std::string_view key) const;
  const Key* find_key(std::string_view key) const;
  std::vector<std::string> keys() const;

  // Where the byte at `offset` of a scalar's text stands in the file.
  Mark place(std::size_t offset) const;
};

// "nothing", "a text", "a list" or "a map".
std::string_view in_words(Entry::Kind kind);

struct TreeLimits {
  static constexpr std::size_t bytes = std::size_t{1} << 20;
  static constexpr std::size_t depth = 64;
  static constexpr std::size_t entries = 100'000;
  static constexpr std::size_t scalar_bytes = 10'000;
};

// Reads the tree of a YAML text; `file` is named in messages only. Throws StatementError for malformed YAML,
// duplicate keys, keys that are not plain text, what is not part of the language (anchors, aliases, merge keys, tags,
// several documents), an empty text, text that is not UTF-8 or holds control characters, and anything beyond
// TreeLimits.
Entry read_tree(std::string_view text, const std::string& file);

// The bytes of a file, or of standard input for "-". Reads no more than TreeLimits::bytes + 1 bytes. Throws
// StatementError if the file is missing, a directory, unreadable or too large.
std::string read_file(const std::string& path);

}  // namespace poinsot::problem
