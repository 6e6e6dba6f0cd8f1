#include "problem/language/tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <unordered_map>

#include "problem/language/source_map.h"
#include "problem/language/utf8.h"

namespace poinsot::problem {
namespace {

std::string place_in_words(const Mark& mark) {
  return "line " + std::to_string(mark.line) + ", column " + std::to_string(mark.column);
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

// Receives the parser's events and builds the tree. Limits are checked with each event, so that a text beyond them is
// not read to its end.
class Builder : public YAML::EventHandler {
 public:
  Builder(const SourceMap& source, const std::string& file) : source_(source), file_(file) {}

  bool complete() const { return complete_; }
  Entry take() { return std::move(root_); }

  // The beginning of the innermost list or map that is still open; line 0 if there is none.
  Mark innermost() const { return open_.empty() ? Mark{} : open_.back().entry.mark; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (complete_) {
      fail(place(mark), "a second document begins here, but a problem file is one document",
           "put each problem into a file of its own");
    }
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check_properties(mark, anchor);
    Entry entry;
    const std::string_view rest = source_.text().substr(std::min(offset(mark), source_.text().size()));
    for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
      if (rest.substr(0, word.size()) == word) entry.text = word;
    }
    // An empty value has no place of its own and gets that of its key.
    const bool empty_value = entry.text.empty() && !open_.empty() && open_.back().key;
    entry.mark = empty_value ? open_.back().key->mark : place(mark);
    add(std::move(entry));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_alias(place(mark)); }

  void OnAnchor(const YAML::Mark& mark, const std::string&) override { refuse_anchor(place(mark)); }

  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, const std::string& value) override {
    check_properties(mark, anchor);
    Entry entry;
    entry.kind = Entry::Kind::scalar;
    entry.mark = place(mark);
    if (value.size() > TreeLimits::scalar_bytes) {
      fail(entry.mark,
           "this text has " + std::to_string(value.size()) + " bytes, more than the " +
               std::to_string(TreeLimits::scalar_bytes) + " a text may have",
           "split it into several entries");
    }
    if (const auto binary = first_binary_byte(value)) {
      fail(entry.mark, "an escape in this text stands for a control character or for no character at all",
           "write plain text");
    }
    const char opening = source_.at(offset(mark));
    if ((opening == '"' || opening == '\'') && !source_.quotes_close(offset(mark))) {
      fail(entry.mark, "the quotes that open here are never closed", "add the closing quote");
    }
    entry.quoted = opening == '"' || opening == '\'' || opening == '|' || opening == '>';
    const bool plain_line = source_.text().substr(offset(mark)).substr(0, value.size()) == value;
    if (entry.quoted || !plain_line) entry.runs = source_.runs(value, offset(mark));
    entry.text = value;
    add(std::move(entry));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor, Entry::Kind::list);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, anchor, Entry::Kind::map);
  }
  void OnMapEnd() override { close(); }

  [[noreturn]] void refuse_alias(const Mark& mark) const {
    fail(mark, "a value that begins with '*' repeats an anchor, and anchors are not part of the problem language",
         "write the value out, or give it a name under 'given:' and use the name");
  }
  [[noreturn]] void refuse_anchor(const Mark& mark) const {
    fail(mark, "a value that begins with '&' sets an anchor, and anchors are not part of the problem language",
         "write the value out, or give it a name under 'given:' and use the name");
  }
  [[noreturn]] void fail(const Mark& mark, std::string message, std::string hint = "") const {
    throw StatementError(file_, mark, std::move(message), std::move(hint));
  }

 private:
  // A list or map whose end has not been read yet.
  struct Open {
    Entry entry;
    std::optional<Key> key;                       // of a map, while its value is awaited
    std::unordered_map<std::string, Mark> known;  // the keys of a map that were read before
  };

  static std::size_t offset(const YAML::Mark& mark) { return mark.pos > 0 ? static_cast<std::size_t>(mark.pos) : 0; }
  Mark place(const YAML::Mark& mark) const { return source_.mark(offset(mark)); }

  void check_properties(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) refuse_anchor(place(mark));
    if (source_.at(offset(mark)) == '!') {
      fail(place(mark), "a value that begins with '!' has a tag, and tags are not part of the problem language",
           "leave the tag out, or put the text into quotes");
    }
  }

  void open(const YAML::Mark& mark, YAML::anchor_t anchor, Entry::Kind kind) {
    check_properties(mark, anchor);
    if (open_.size() >= TreeLimits::depth) {
      fail(place(mark), "lists and maps are nested more than " + std::to_string(TreeLimits::depth) + " deep here",
           "state things flat, under names");
    }
    if (!open_.empty() && open_.back().entry.is_map() && !open_.back().key) {
      // The parser takes a bracket that is never closed for the beginning of a key.
      const char bracket = source_.at(offset(mark));
      if ((bracket == '[' || bracket == '{') && !source_.bracket_closes(offset(mark))) {
        fail(place(mark), std::string("this '") + bracket + "' is never closed", "add the closing bracket");
      }
      fail(place(mark), "a key must be plain text, not " + std::string(in_words(kind)),
           "if this was not meant as a key, is a blank or a ',' missing after a ':' or a value before it?");
    }
    Open container;
    container.entry.kind = kind;
    container.entry.mark = place(mark);
    open_.push_back(std::move(container));
  }

  void close() {
    Entry entry = std::move(open_.back().entry);
    open_.pop_back();
    add(std::move(entry));
  }

  void add(Entry entry) {
    if (++count_ > TreeLimits::entries) {
      fail(entry.mark, "the file has more than " + std::to_string(TreeLimits::entries) + " entries", "split it");
    }
    if (open_.empty()) {
      root_ = std::move(entry);
      complete_ = true;
      return;
    }
    Open& parent = open_.back();
    if (parent.entry.is_list()) {
      parent.entry.items.push_back(std::move(entry));
    } else if (parent.key) {
      parent.entry.members.emplace_back(std::move(*parent.key), std::move(entry));
      parent.key.reset();
    } else {
      add_key(parent, std::move(entry));
    }
  }

  void add_key(Open& parent, Entry entry) {
    if (entry.text.empty()) fail(entry.mark, "a key is missing before the ':'");
    if (entry.text == "<<") {
      fail(entry.mark, "the key '<<' merges maps, and merging is not part of the problem language",
           "write the entries out");
    }
    const auto [known, is_new] = parent.known.emplace(entry.text, entry.mark);
    if (!is_new) {
      fail(entry.mark,
           "the key '" + shortened(entry.text) + "' stands here a second time; the first is in " +
               place_in_words(known->second),
           "remove one of the two");
    }
    parent.key = Key{std::move(entry.text), entry.mark};
  }

  const SourceMap& source_;
  const std::string& file_;
  std::vector<Open> open_;
  Entry root_;
  std::size_t count_ = 0;
  bool complete_ = false;
};

// A message of the YAML parser, and how an author of problem files is told the same.
struct Translation {
  std::string_view of;
  std::string_view message;
  std::string_view hint;
};
constexpr std::array translations{
    Translation{
        "illegal map value", "a ':' followed by a blank stands where no key can be",
        "one line has one 'key: value'; several go into braces, {a: 1, b: 2}; a text with ': ' in it goes into quotes"},
    Translation{"illegal map key", "a key cannot stand here", "check the indentation of this line and the one before"},
    Translation{"illegal block entry", "a '-' that begins a list's item cannot stand here",
                "put the list on lines of its own, or write it in brackets, [..., ...]"},
    Translation{"illegal flow end", "this closing bracket has no opening one", "remove it, or add the opening one"},
    Translation{"end of map not found", "expected another 'key: value' here, indented like those before",
                "check the indentation of this line, and that each ':' has a blank after it"},
    Translation{"end of sequence not found", "expected another '- item' here, indented like those before",
                "check the indentation of this line"},
    Translation{
        "end of map flow not found", "this map in braces is not closed properly",
        "add the '}', or the ',' between two entries; a value with brackets and commas of its own goes into quotes, '"
        "max([1, 2])'"},
    Translation{"end of sequence flow not found", "this list in brackets is not closed properly",
                "add the ']', or the ',' between two items"},
    Translation{"illegal EOF in scalar", "the file ends within quotes", "add the closing quote"},
    Translation{"illegal document indicator in scalar", "'---' or '...' stands within quotes", "add the closing quote"},
    Translation{"illegal tab when looking for indentation", "a tab stands where the indentation is looked for",
                "indent with blanks"},
    Translation{"unknown token", "no value can begin with this character", "put the text into quotes"},
    Translation{"unexpected character in block scalar", "after '|' or '>' nothing else may stand on the line",
                "the size of a vector is written norm(v); a text that begins so stands on the lines below"},
};

Diagnostic translated(const YAML::Exception& error, const Builder& builder, const SourceMap& source,
                      const std::string& file) {
  const std::size_t offset = error.mark.pos > 0 ? static_cast<std::size_t>(error.mark.pos) : 0;
  const bool in_flow = error.msg.find("flow not found") != std::string::npos;
  if (const auto slip = in_flow ? std::nullopt : source.slip_of_line(offset))
    return {file, source.mark(slip->offset), slip->message, slip->hint};
  Diagnostic diagnostic{file, source.mark(offset), "this is no YAML: " + error.msg, ""};
  for (const Translation& translation : translations) {
    if (error.msg != translation.of) continue;
    diagnostic.message = translation.message;
    diagnostic.hint = translation.hint;
  }
  if (in_flow && builder.innermost().line > 0) {
    diagnostic.message += "; it begins in " + place_in_words(builder.innermost());
  }
  return diagnostic;
}

void check_size(std::string_view text, const std::string& file) {
  if (text.size() <= TreeLimits::bytes) return;
  throw StatementError(file, {1, 1}, "the file is larger than " + std::to_string(TreeLimits::bytes) + " bytes",
                       "a problem file is a page or two of text");
}

// Checks the depth of brackets before the parser sees the text. Brackets in quotes and comments are counted as well,
// so this is only a bound.
void check_brackets(const SourceMap& source, const std::string& file) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < source.text().size(); ++i) {
    const char c = source.text()[i];
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if ((c == '[' || c == '{') && ++depth > TreeLimits::depth) {
      throw StatementError(file, source.mark(i),
                           "lists and maps are nested more than " + std::to_string(TreeLimits::depth) + " deep here",
                           "close the brackets that are open, or state things flat, under names");
    }
  }
}

}  // namespace

std::string_view in_words(Entry::Kind kind) {
  switch (kind) {
    case Entry::Kind::scalar:
      return "a text";
    case Entry::Kind::list:
      return "a list";
    case Entry::Kind::map:
      return "a map";
    case Entry::Kind::null:
      break;
  }
  return "nothing";
}

Entry::Entry() = default;
Entry::Entry(const Entry&) = default;
Entry::Entry(Entry&&) noexcept = default;
Entry& Entry::operator=(const Entry&) = default;
Entry& Entry::operator=(Entry&&) noexcept = default;
Entry::~Entry() = default;

const Entry* Entry::find(std::string_view key) const {
  for (const auto& [name, value] : members) {
    if (name.text == key) return &value;
  }
  return nullptr;
}

const Key* Entry::find_key(std::string_view key) const {
  for (const auto& [name, value] : members) {
    if (name.text == key) return &name;
  }
  return nullptr;
}

std::vector<std::string> Entry::keys() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : members) names.push_back(name.text);
  return names;
}

Mark Entry::place(std::size_t offset) const {
  Run begin{0, mark};
  for (const Run& run : runs) {
    if (run.start <= offset) begin = run;
  }
  offset = std::min(offset, text.size());
  const std::string_view between = std::string_view(text).substr(begin.start, offset - begin.start);
  return {begin.mark.line, begin.mark.column + character_count(between)};
}

Entry read_tree(std::string_view text, const std::string& file) {
  check_size(text, file);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  const SourceMap source(text);
  if (const auto binary = first_binary_byte(text)) {
    throw StatementError(file, source.mark(*binary), "this is no text: a byte here is no UTF-8 or a control character",
                         "a problem file is a plain text file, saved as UTF-8");
  }
  check_brackets(source, file);

  std::istringstream stream{std::string(text)};
  Builder builder(source, file);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    if (error.msg == YAML::ErrorMsg::UNKNOWN_ANCHOR || error.msg == YAML::ErrorMsg::ALIAS_NOT_FOUND) {
      builder.refuse_alias(source.mark(static_cast<std::size_t>(std::max(error.mark.pos, 0))));
    }
    throw StatementError(translated(error, builder, source, file));
  }
  Entry root = builder.take();
  if (!builder.complete() || root.is_null()) {
    throw StatementError(file, {1, 1}, "the file is empty", "a problem file begins with 'title: ...'");
  }
  return root;
}

}  // namespace poinsot::problem
