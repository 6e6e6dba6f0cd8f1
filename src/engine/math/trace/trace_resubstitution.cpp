#include "engine/math/trace/trace_resubstitution.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "engine/math/trace/pair_table.h"
#include "engine/math/trace/trace_recipe.h"
#include "poinsot/engine/math/trace/straight_line.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot {
namespace {

using symbolic::made;
using symbolic::Modular;
using symbolic::ModularPair;
using symbolic::Pair;
using symbolic::PairKey;
using symbolic::PairTable;
using symbolic::Recipe;
using symbolic::Residue;
using Op = TracedOperation;
using Index = std::uint32_t;

constexpr std::size_t most_numbers = 160;        // of a trace that is looked at
constexpr std::size_t most_looked_up = 1000000;  // in all

static_assert(most_numbers <= PairTable::most_places);

// Recipes for the numbers of a trace. Field: where its values at one point are looked for.
template <class Field>
class Search {
 public:
  Search(const Trace& trace, const std::vector<Traced>& outputs, const std::vector<Index>& base, PairTable& table,
         std::size_t& looked_up)
      : nodes_(trace.nodes()), uses_(uses_of(nodes_, outputs)), base_(base), table_(table), looked_up_(looked_up) {
    std::vector<Field> before{Field{Modular(1)}};
    for (const Index i : base_) values_.push_back(value(i));
    // All inverses from one, of the product.
    for (const Field& x : values_) before.push_back(before.back() * x);
    Field rest = inverse(before.back());
    inverses_.resize(base_.size());
    for (std::size_t i = base_.size(); i-- > 0; rest = rest * values_[i]) inverses_[i] = before[i] * rest;
    table_.clear(base_.size() * (3 * base_.size() - 1) / 2);
    for (std::size_t i = 0; i < base_.size(); ++i)
      for (std::size_t j = i; j < base_.size(); ++j) {
        const auto first = static_cast<std::uint8_t>(i), second = static_cast<std::uint8_t>(j);
        add({first, second, true, false}, values_[i] * values_[j]);
        if (i == j) continue;
        add({first, second, false, false}, values_[i] + values_[j]);
        add({first, second, false, true}, values_[i] - values_[j]);
      }
  }

  // For each operation the recipe that saves most, those that save most first.
  // deep: also those of three operations.
  std::vector<std::pair<Index, Recipe>> find(bool deep) {
    struct Saving {
      int operations;
      Index of;
      Recipe recipe;
    };
    std::vector<Saving> savings;
    const ProgressTeller progress("shortening the equations");
    for (std::size_t k = 0; k < base_.size(); ++k) {
      check_budget();
      progress.tell(static_cast<double>(k) / static_cast<double>(base_.size()), k);
      const Index x = base_[k];
      if (!is_operation(nodes_[x].operation)) continue;
      const int own = cone_of(x);
      if (own < 2) continue;
      mark_users(x);
      int best = 0;
      Recipe chosen;
      look(k, own, deep, [&](const Recipe& recipe) {
        if (own - recipe.cost() <= best || !has_value_of(x, recipe)) return;
        const int saved = saved_by(x, recipe);
        if (saved <= best) return;
        best = saved;
        chosen = recipe;
      });
      if (best > 0) savings.push_back({best, x, chosen});
    }
    std::stable_sort(savings.begin(), savings.end(),
                     [](const Saving& a, const Saving& b) { return a.operations > b.operations; });
    std::vector<std::pair<Index, Recipe>> found;
    found.reserve(savings.size());
    for (const Saving& saving : savings) found.emplace_back(saving.of, saving.recipe);
    return found;
  }

 private:
  Field value(Index i) const {
    if constexpr (std::is_same_v<Field, Modular>)
      return nodes_[i].residue.at(0).real;
    else
      return nodes_[i].residue.at(0);
  }
  void add(PairTable::Entry entry, const Field& x) {
    const PairKey key = pair_key(x);
    entry.negative = key.negative;
    if (key.value != 0) table_.add(key.value, entry);
  }

  // All pairs with this value or minus it, but for those that use x; visit gets the sign that the pair is to be given.
  template <class Visit>
  void pairs_of(const Field& wanted, const Visit& visit) {
    ++looked_up_;
    const PairKey key = pair_key(wanted);
    table_.find(key.value, [&](const PairTable::Entry& entry) {
      const Index a = base_[entry.first], b = base_[entry.second];
      if (users_[a] || users_[b]) return;
      visit(Pair{entry.product, Traced(a, false), Traced(b, entry.minus)}, entry.negative != key.negative);
    });
  }

  template <class Visit>
  void look(std::size_t k, int own, bool deep, const Visit& visit) {
    using Form = Recipe::Form;
    const Field wanted = values_[k];
    pairs_of(wanted, [&](const Pair& pair, bool negative) { visit({Form::pair, pair, {}, {}, {}, negative}); });
    if (own < 3) return;
    free_.clear();
    for (std::size_t i = 0; i < base_.size(); ++i)
      if (!users_[base_[i]]) free_.push_back(i);
    quotients_.clear();
    for (const std::size_t i : free_) {
      const Traced a(base_[i], false);
      quotients_.push_back(wanted * inverses_[i]);
      pairs_of(quotients_.back(), [&](const Pair& pair, bool negative) {
        visit({Form::product, pair, a, {}, {}, negative});
      });
      pairs_of(wanted - values_[i], [&](const Pair& pair, bool negative) {
        visit({Form::sum, pair, a, {}, {}, negative});
      });
      pairs_of(wanted + values_[i], [&](const Pair& pair, bool negative) {
        visit({Form::sum, pair, -a, {}, {}, negative});
      });
    }
    if (own < 4 || !deep) return;
    for (const std::size_t i : free_) {
      check_budget();
      if (looked_up_ > most_looked_up) return;
      const Traced a(base_[i], false);
      const Field less = wanted - values_[i], more = wanted + values_[i];
      for (std::size_t j = 0; j < free_.size(); ++j) {
        const Traced b(base_[free_[j]], false);
        const Field& over_b = inverses_[free_[j]];
        const auto then_sum = [&](const Traced& term) {
          return [&visit, &b, term](const Pair& pair, bool negative) {
            visit({Form::product_then_sum, pair, term, b, {}, negative});
          };
        };
        const auto then_product = [&](const Traced& term) {
          return [&visit, &b, term](const Pair& pair, bool negative) {
            visit({Form::sum_then_product, pair, term, b, {}, negative});
          };
        };
        pairs_of(less * over_b, then_sum(a));
        pairs_of(more * over_b, then_sum(-a));
        pairs_of(quotients_[j] - values_[i], then_product(a));
        pairs_of(quotients_[j] + values_[i], then_product(-a));
      }
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
      check_budget();
      for (std::size_t j = i; j < free_.size(); ++j) {
        if (looked_up_ > most_looked_up) return;
        const Pair other{true, Traced(base_[free_[i]], false), Traced(base_[free_[j]], false)};
        const Field product = values_[free_[i]] * values_[free_[j]];
        pairs_of(quotients_[i] * inverses_[free_[j]], [&](const Pair& pair, bool negative) {
          visit({Form::pairs_product, pair, {}, {}, other, negative, false});
        });
        pairs_of(wanted - product, [&](const Pair& pair, bool negative) {
          visit({Form::pairs_sum, pair, {}, {}, other, negative, false});
        });
        pairs_of(wanted + product, [&](const Pair& pair, bool negative) {
          visit({Form::pairs_sum, pair, {}, {}, other, negative, true});
        });
      }
    }
  }

  // At both points of the field; and at the sample.
  bool has_value_of(Index x, const Recipe& recipe) const {
    const auto residue = [&](const Traced& y) {
      const Residue& r = nodes_[y.node()].residue;
      return y.negative() ? -r : r;
    };
    const auto number = [&](const Traced& y) {
      const Rounded size = nodes_[y.node()].rounded();
      return y.negative() ? -size : size;
    };
    if (!(made(recipe, residue) == nodes_[x].residue)) return false;
    return same_at_sample(made(recipe, number), nodes_[x].rounded());
  }

  // Everything that is computed from x, and x.
  void mark_users(Index x) {
    users_.assign(nodes_.size(), 0);
    users_[x] = 1;
    for (Index i = x + 1; i < nodes_.size(); ++i)
      users_[i] =
          is_operation(nodes_[i].operation) && (users_[nodes_[i].first.node()] || users_[nodes_[i].second.node()]);
  }

  // How many operations are needed for x alone, x included. Uses that are taken away meanwhile are given back.
  int cone_of(Index x) {
    const int count = 1 + released(x);
    taken_back(x);
    return count;
  }
  int released(Index x) {
    int count = 0;
    for_operands(x, [&](Index operand) {
      if (--uses_[operand] == 0 && is_operation(nodes_[operand].operation)) count += 1 + released(operand);
    });
    return count;
  }
  void taken_back(Index x) {
    for_operands(x, [&](Index operand) { taken(operand); });
  }
  int taken(Index x) {
    if (uses_[x]++ > 0 || !is_operation(nodes_[x].operation)) return 0;
    int count = 1;
    for_operands(x, [&](Index operand) { count += taken(operand); });
    return count;
  }
  void given_back(Index x) {
    if (--uses_[x] > 0 || !is_operation(nodes_[x].operation)) return;
    for_operands(x, [&](Index operand) { given_back(operand); });
  }
  template <class Visit>
  void for_operands(Index x, const Visit& visit) const {
    visit(nodes_[x].first.node());
    if (nodes_[x].second.node() != 0) visit(nodes_[x].second.node());
  }
  int saved_by(Index x, const Recipe& recipe) {
    int saved = 1 + released(x) - recipe.cost();
    const auto numbers = recipe.numbers();
    for (const Index number : numbers)
      if (number != 0) saved -= taken(number);
    for (const Index number : numbers)
      if (number != 0) given_back(number);
    taken_back(x);
    return saved;
  }

  const std::vector<Trace::Node>& nodes_;
  std::vector<Index> uses_;
  const std::vector<Index>& base_;  // the numbers that recipes are made of
  std::vector<Field> values_, inverses_, quotients_;
  std::vector<std::size_t> free_;
  PairTable& table_;
  std::vector<char> users_;
  std::size_t& looked_up_;
};

// What is needed and has an inverse, but for one, which takes no part in products.
std::vector<Index> base_of(const Trace& trace, const std::vector<Traced>& outputs) {
  const std::vector<Index> uses = uses_of(trace.nodes(), outputs);
  std::vector<Index> base;
  for (Index i = 2; i < uses.size(); ++i)
    if (uses[i] > 0 && trace.nodes()[i].residue.is_unit()) base.push_back(i);
  return base;
}

std::vector<std::pair<Index, Recipe>> found_recipes(const Trace& trace, const std::vector<Traced>& outputs, bool deep,
                                                    PairTable& table, std::size_t& looked_up) {
  const std::vector<Index> base = base_of(trace, outputs);
  if (base.size() > most_numbers) return {};
  const bool real = std::all_of(base.begin(), base.end(),
                                [&](Index i) { return trace.nodes()[i].residue.at(0).imaginary == Modular(); });
  if (real) return Search<Modular>(trace, outputs, base, table, looked_up).find(deep);
  return Search<ModularPair>(trace, outputs, base, table, looked_up).find(deep);
}

// Computes the outputs again in a new trace, some numbers by recipes.
class Rebuilding {
 public:
  Rebuilding(const Trace& old, const std::vector<Traced>& outputs, const std::vector<std::pair<Index, Recipe>>& recipes,
             std::size_t count)
      : nodes_(old.nodes()), mapped_(nodes_.size()), known_(nodes_.size(), 0), recipe_of_(nodes_.size(), nullptr) {
    for (std::size_t k = 0; k < count; ++k) recipe_of_[recipes[k].first] = &recipes[k].second;
    for (Index i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].operation == Op::input) {
        mapped_[i] = trace_.input(nodes_[i].value);
        known_[i] = 1;
      }
    known_[0] = 1;
    const TraceScope scope(trace_);
    for (const Traced& output : outputs) outputs_.push_back(now(output));
  }

  // Whether recipes need each other in a circle.
  bool circular() const { return circular_; }
  Resubstituted take() { return {std::move(trace_), std::move(outputs_)}; }

 private:
  Traced now(const Traced& x) {
    const Traced size = number(x.node());
    return x.negative() ? -size : size;
  }
  Traced number(Index i) {
    if (known_[i] == 1) return mapped_[i];
    if (known_[i] == 2) {
      circular_ = true;
      return Traced();
    }
    known_[i] = 2;
    const auto of = [this](const Traced& x) { return now(x); };
    const Traced value = recipe_of_[i] ? made(*recipe_of_[i], of) : computed(nodes_[i]);
    mapped_[i] = value;
    known_[i] = 1;
    return value;
  }
  Traced computed(const Trace::Node& node) {
    if (circular_) return Traced();
    if (node.operation == Op::constant) return traced_constant(node.value, node.residue, node.rounding);
    if (node.operation == Op::input) return Traced();
    const Traced first = now(node.first), second = now(node.second);
    // In a circle operands are zeros, by which nothing can be divided.
    return circular_ ? Traced() : operated(node.operation, first, second);
  }

  const std::vector<Trace::Node>& nodes_;
  Trace trace_;
  std::vector<Traced> mapped_, outputs_;
  std::vector<char> known_;
  std::vector<const Recipe*> recipe_of_;
  bool circular_ = false;
};

}  // namespace

std::vector<std::uint32_t> uses_of(const std::vector<Trace::Node>& nodes, const std::vector<Traced>& outputs) {
  std::vector<std::uint32_t> uses(nodes.size(), 0);
  for (const Traced& output : outputs) ++uses[output.node()];
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (uses[i] == 0 || !is_operation(nodes[i].operation)) continue;
    ++uses[nodes[i].first.node()];
    if (nodes[i].second.node() != 0) ++uses[nodes[i].second.node()];
  }
  return uses;
}

std::size_t operations_needed(const Trace& trace, const std::vector<Traced>& outputs) {
  const std::vector<Index> uses = uses_of(trace.nodes(), outputs);
  std::size_t count = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) count += uses[i] > 0 && is_operation(trace.nodes()[i].operation);
  return count;
}

std::optional<Resubstituted> resubstituted(const Trace& trace, const std::vector<Traced>& outputs, bool thorough) {
  std::optional<Resubstituted> best;
  PairTable table;
  std::size_t looked_up = 0, operations = operations_needed(trace, outputs);
  for (bool deep = false; looked_up < most_looked_up;) {
    const Trace& now = best ? best->trace : trace;
    const std::vector<Traced>& results = best ? best->outputs : outputs;
    const std::vector<std::pair<Index, Recipe>> recipes = found_recipes(now, results, deep, table, looked_up);
    // As many together as go together; one alone always does.
    std::optional<Resubstituted> next;
    for (std::size_t count = recipes.size(); count > 0 && !next; count /= 2) {
      Rebuilding rebuilding(now, results, recipes, count);
      if (rebuilding.circular()) continue;
      Resubstituted candidate = rebuilding.take();
      const std::size_t needed = operations_needed(candidate.trace, candidate.outputs);
      if (needed >= operations) continue;
      operations = needed;
      next = std::move(candidate);
    }
    const bool shorter = next.has_value();
    if (next) best = std::move(next);
    if (!thorough || (deep && !shorter)) break;
    deep = !shorter;
  }
  return best;
}

}  // namespace poinsot
