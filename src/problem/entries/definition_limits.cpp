#include "problem/entries/definition_limits.h"

#include <algorithm>
#include <map>
#include <set>

#include "problem/keys/reader.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

struct Extent {
  double size = 0;  // number of operations that one evaluation takes
  int depth = 0;    // number of names that stand behind each other
};

class Measure {
 public:
  explicit Measure(const Situation& situation) : situation_(situation) {
    for (const auto* items : {&situation.given, &situation.points, &situation.directions})
      for (const NamedExpression& item : *items) items_.emplace(item.name, &item);
    for (const NamedExpression& item : situation.define) {
      items_.emplace(item.name, &item);
      defined_.insert(item.name);
    }
  }

  Extent of_name(const std::string& name) {
    const auto item = items_.find(name);
    if (item == items_.end()) return {1, 0};
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
    if (!pending_.insert(name).second) return {1, 0};
    const NamedExpression& stated = *item->second;
    if (static_cast<int>(pending_.size()) > DefinitionLimits::depth) too_deep(stated);
    Extent extent = of(stated.value);
    pending_.erase(name);
    ++extent.depth;
    if (extent.depth > DefinitionLimits::depth) too_deep(stated);
    if (extent.size > DefinitionLimits::size)
      fail(situation_.file, stated.mark,
           "'" + name + "' stands for an expression of more than " +
               std::to_string(static_cast<int>(DefinitionLimits::size)) + " operations",
           "define it with fewer of the other definitions");
    // The value of a datum or point is computed once, that of a definition at each place where its name stands.
    if (!defined_.contains(name)) extent.size = 1;
    return known_[name] = extent;
  }

  Extent of(const Expression& expression) {
    if (const Name* name = expression.as<Name>()) return of_name(name->name);
    Extent extent;
    if (expression) extent.size = 1;
    for_each_child(expression, [&](const Expression& part) {
      const Extent one = of(part);
      extent.size += one.size;
      extent.depth = std::max(extent.depth, one.depth);
    });
    return extent;
  }

 private:
  [[noreturn]] void too_deep(const NamedExpression& item) {
    fail(situation_.file, item.mark,
         "'" + item.name + "' is defined through more than " + std::to_string(DefinitionLimits::depth) + " other names",
         "define it more directly");
  }

  const Situation& situation_;
  std::map<std::string, const NamedExpression*> items_;
  std::set<std::string> defined_, pending_;
  std::map<std::string, Extent> known_;
};

}  // namespace

void check_definition_limits(const Situation& situation) {
  Measure measure(situation);
  for (const auto* items : {&situation.given, &situation.points, &situation.directions, &situation.define})
    for (const NamedExpression& item : *items) measure.of_name(item.name);
}

}  // namespace poinsot::problem
