// Helpers to read a tree of entries. They accept known keys only and report every error at its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// One map of the file, which the table of keys knows as an `object`.
class Members {
 public:
  // Throws StatementError unless the entry is a map each of whose keys belongs to one of `objects` or to `extra`.
  Members(const Entry& entry, const std::string& file, std::vector<std::string_view> objects,
          std::vector<std::string> extra = {});

  const Entry* find(std::string_view key) const;
  Mark mark_of(std::string_view key) const;
  const Entry& require(std::string_view key, std::string_view example) const;
  std::optional<Expression> expression(std::string_view key) const;
  Expression require_expression(std::string_view key, std::string_view example) const;
  std::vector<Expression> list(std::string_view key) const;  // empty when absent
  std::optional<bool> boolean(std::string_view key) const;
  std::string text(std::string_view key, const char* when_absent = "") const;
  const Entry& entry() const { return *entry_; }

 private:
  const Entry* entry_;
  const std::string* file_;
  std::string object_;
};

// Reads a unit; throws StatementError if the entry is none.
Unit read_unit(const Entry& entry, const std::string& file);

// The text of a scalar; throws for any other entry. `what` says in the message what was expected.
const std::string& scalar_text(const Entry& entry, const std::string& file, std::string_view what);

// Throws unless `name` can be used as a name in expressions.
void check_name(const std::string& name, Mark mark, const std::string& file);

// The items of a list as expressions; throws if the entry is no list.
std::vector<Expression> expression_list(const Entry& entry, const std::string& file);

// The members of a map whose keys are names of the author's choice; none if the key is absent.
const std::vector<std::pair<Key, Entry>>& named(const Members& members, std::string_view key, const std::string& file);

}  // namespace poinsot::problem
