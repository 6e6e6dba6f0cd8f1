// What is gathered from an expression's tree.
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

// Hands every node to `note`, those above first; what stands before an @ only if `into_at`.
template <class Note>
void note_nodes(const Expression& expression, bool into_at, const Note& note) {
  if (!expression) return;
  note(expression);
  if (!into_at && expression.as<At>()) return;
  for_each_child(expression, [&](const Expression& child) { note_nodes(child, into_at, note); });
}

}  // namespace

const At* first_at(const Expression& expression) {
  if (const At* at = expression.as<At>()) return at;
  const At* found = nullptr;
  for_each_child(expression, [&](const Expression& child) {
    if (!found) found = first_at(child);
  });
  return found;
}

void collect_instants(const Expression& expression, std::set<std::string>& names) {
  if (const At* at = expression.as<At>()) names.insert(at->names.begin(), at->names.end());
  for_each_child(expression, [&](const Expression& child) { collect_instants(child, names); });
}

void collect_names(const Expression& expression, std::set<std::string>& names, bool into_at) {
  note_nodes(expression, into_at, [&](const Expression& node) {
    if (const Name* name = node.as<Name>()) names.insert(name->name);
  });
}

void collect_functions(const Expression& expression, std::set<std::string>& functions, bool into_at) {
  note_nodes(expression, into_at, [&](const Expression& node) {
    if (const Call* call = node.as<Call>()) functions.insert(call->function);
  });
}

}  // namespace poinsot::problem
