// The tree of an expression: how entries become expressions, and what can be asked of one.
#include "problem/language/expression.h"

#include <algorithm>
#include <utility>

#include "problem/language/expression_walk.h"
#include "problem/language/parser.h"

namespace poinsot::problem {
namespace {

Expression parse_entry(const Entry& entry, const std::string& file, bool list_item) {
  if (entry.is_null()) {
    throw StatementError(file, entry.mark, "a value is missing here", "write a number, a name or a formula");
  }
  if (entry.is_map()) {
    throw StatementError(file, entry.mark, "expected an expression, not a map",
                         "a ': ' in an expression makes a map of it; so do braces");
  }
  if (entry.is_scalar()) {
    if (entry.text.size() > TreeLimits::scalar_bytes) {
      throw StatementError(file, entry.mark,
                           "this expression is longer than " + std::to_string(TreeLimits::scalar_bytes) + " bytes",
                           "name parts of it and use the names");
    }
    return parse_scalar(entry, file, list_item);
  }
  List list;
  for (const Entry& item : entry.items) list.items.push_back(parse_entry(item, file, true));
  if (height_below(list) >= ExpressionLimits::height)
    throw StatementError(file, entry.mark, "this list is nested too deep");
  return built(std::move(list), entry.mark);
}

}  // namespace

Mark Expression::mark() const { return node ? node->mark : Mark{}; }

Mark beginning(const Expression& expression) {
  if (const auto* binary = expression.as<Binary>()) return beginning(binary->left);
  if (const auto* comparison = expression.as<Comparison>()) return beginning(comparison->operands.front());
  if (const auto* range = expression.as<Range>()) return beginning(range->from);
  if (const auto* member = expression.as<Member>()) return beginning(member->object);
  if (const auto* arrow = expression.as<Arrow>()) return beginning(arrow->from);
  if (const auto* of = expression.as<Of>()) return beginning(of->point);
  if (const auto* at = expression.as<At>()) return beginning(at->expression);
  return expression.mark();
}

bool is_any(const Expression& expression) {
  const Name* name = expression.as<Name>();
  return name && name->name == "any" && name->primes == 0;
}

const Expression* Call::argument(std::string_view preposition) const {
  for (const Argument& argument : arguments) {
    if (argument.preposition == preposition) return &argument.value;
  }
  return nullptr;
}

std::string Call::pattern() const {
  std::string pattern;
  for (std::size_t i = 1; i < arguments.size(); ++i) pattern += (i == 1 ? "" : " ") + arguments[i].preposition;
  return pattern;
}

std::string_view symbol(Relation relation) {
  switch (relation) {
    case Relation::less:
      return "<";
    case Relation::less_equal:
      return "<=";
    case Relation::greater:
      return ">";
    case Relation::greater_equal:
      return ">=";
    case Relation::equal:
      break;
  }
  return "==";
}

Expression parse_expression(const Entry& entry, const std::string& file) { return parse_entry(entry, file, false); }

Expression parse_expression(std::string_view text, const std::string& file, Mark mark) {
  Entry entry;
  entry.kind = Entry::Kind::scalar;
  entry.text = text;
  entry.mark = mark;
  return parse_entry(entry, file, false);
}

const std::vector<std::string>& prepositions() {
  static const std::vector<std::string> words{"about", "along", "to", "with", "from",
                                              "of",    "on",    "at", "by",   "relative to"};
  return words;
}

bool is_preposition(std::string_view word) {
  return std::find(prepositions().begin(), prepositions().end(), word) != prepositions().end();
}

bool is_name(std::string_view word) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (word.empty() || !letter(word.front()) || is_preposition(word) || word == "relative") return false;
  return std::all_of(word.begin(), word.end(), [&](char c) { return letter(c) || digit(c); });
}

}  // namespace poinsot::problem
