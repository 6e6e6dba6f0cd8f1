#include "math/trace_resubstitution.h"

#include <algorithm>
#include <cmath>

#include "poinsot/math/straight_line.h"

namespace poinsot {
namespace {

using symbolic::Residue;
using Op = TracedOperation;
using Index = std::uint32_t;

constexpr std::size_t most_numbers = 160;        // of a trace that is looked at
constexpr std::size_t most_looked_up = 1000000;  // in all

// How often each number is used by what the outputs need.
std::vector<Index> uses_of(const std::vector<Trace::Node>& nodes, const std::vector<Traced>& outputs) {
  std::vector<Index> uses(nodes.size(), 0);
  for (const Traced& output : outputs) ++uses[output.node()];
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (uses[i] == 0 || !is_operation(nodes[i].operation)) continue;
    ++uses[nodes[i].first.node()];
    if (nodes[i].second.node() != 0) ++uses[nodes[i].second.node()];
  }
  return uses;
}

// a b, or a + b.
struct Pair {
  bool product = false;
  Traced a, b;
};

// What a number is made of anew: the pair itself; or with one or two others, or with another pair.
struct Recipe {
  enum class Form { pair, sum, product, product_then_sum, sum_then_product, pairs_sum, pairs_product };
  Form form = Form::pair;
  Pair pair;
  Traced first, second;
  Pair other;
  bool negative = false;  // of the whole

  int cost() const {
    switch (form) {
      case Form::pair:
        return 1;
      case Form::sum:
      case Form::product:
        return 2;
      default:
        return 3;
    }
  }
  std::vector<Index> numbers() const {
    std::vector<Index> all{pair.a.node(), pair.b.node(), first.node(), second.node()};
    if (form == Form::pairs_sum || form == Form::pairs_product) {
      all.push_back(other.a.node());
      all.push_back(other.b.node());
    }
    return all;
  }
};

class Search {
 public:
  Search(const Trace& trace, const std::vector<Traced>& outputs, std::size_t& looked_up)
      : nodes_(trace.nodes()), outputs_(outputs), uses_(uses_of(nodes_, outputs)), looked_up_(looked_up) {
    for (Index i = 1; i < nodes_.size(); ++i)
      if (uses_[i] > 0 && nodes_[i].residue.is_unit()) base_.push_back(i);
    // One takes no part in products.
    std::erase(base_, Index{1});
  }

  bool too_large() const { return base_.size() > most_numbers; }

  // The recipes that save most, for operations that do not stand in each other's way.
  // deep: also those of three operations.
  std::vector<std::pair<Index, Recipe>> find(bool deep) {
    deep_ = deep;
    make_table();
    struct Saving {
      int operations;
      Index of;
      Recipe recipe;
    };
    std::vector<Saving> savings;
    for (const Index x : base_) {
      if (!is_operation(nodes_[x].operation)) continue;
      const int own = cone_of(x);
      if (own < 2) continue;
      mark_users(x);
      int best = 0;
      Recipe chosen;
      look(x, own, [&](const Recipe& recipe) {
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
    for (const Saving& saving : savings) found.emplace_back(saving.of, saving.recipe);
    return found;
  }

 private:
  struct Entry {
    std::uint64_t hash;
    Pair pair;
    bool negative;
  };

  const Residue& residue(Index i) const { return nodes_[i].residue; }

  void make_table() {
    inverse_.assign(nodes_.size(), Residue());
    for (const Index i : base_) inverse_[i] = inverse(residue(i));
    for (std::size_t i = 0; i < base_.size(); ++i)
      for (std::size_t j = i; j < base_.size(); ++j) {
        const Index a = base_[i], b = base_[j];
        const Traced x(a, false), y(b, false);
        add({true, x, y}, residue(a) * residue(b));
        if (i == j) continue;
        add({false, x, y}, residue(a) + residue(b));
        add({false, x, -y}, residue(a) - residue(b));
      }
    std::sort(table_.begin(), table_.end(), [](const Entry& a, const Entry& b) { return a.hash < b.hash; });
    // A first look in a small table: most is not there.
    filter_.assign(filter_size, 0);
    for (const Entry& entry : table_) filter_[entry.hash % filter_size] = 1;
  }
  void add(const Pair& pair, const Residue& r) {
    pairs_.emplace_back(pair, r);
    table_.push_back({r.hash(), pair, false});
    table_.push_back({(-r).hash(), pair, true});
  }

  // All pairs with this residue, or minus it, but for those that use x.
  template <class Visit>
  void pairs_of(const Residue& r, const Visit& visit) {
    ++looked_up_;
    const std::uint64_t hash = r.hash();
    if (!filter_[hash % filter_size]) return;
    const auto first = std::lower_bound(table_.begin(), table_.end(), hash,
                                        [](const Entry& entry, std::uint64_t wanted) { return entry.hash < wanted; });
    for (auto at = first; at != table_.end() && at->hash == hash; ++at)
      if (allowed(at->pair)) visit(at->pair, at->negative);
  }
  bool allowed(const Pair& pair) const { return !users_[pair.a.node()] && !users_[pair.b.node()]; }

  template <class Visit>
  void look(Index x, int own, const Visit& visit) {
    using Form = Recipe::Form;
    const Residue& wanted = residue(x);
    pairs_of(wanted, [&](const Pair& pair, bool negative) { visit({Form::pair, pair, {}, {}, {}, negative}); });
    if (own < 3) return;
    for (const Index a : base_) {
      if (users_[a]) continue;
      pairs_of(wanted * inverse_[a], [&](const Pair& pair, bool negative) {
        visit({Form::product, pair, Traced(a, false), {}, {}, negative});
      });
      for (const bool minus : {false, true}) {
        const Residue rest = minus ? wanted + residue(a) : wanted - residue(a);
        // x = a + pair or a - pair: a pair with the other sign is what is looked for in the recipe.
        pairs_of(rest, [&](const Pair& pair, bool negative) {
          visit({Form::sum, pair, Traced(a, minus), Traced(0, negative), {}, false});
        });
      }
    }
    if (own < 4 || !deep_) return;
    for (const Index a : base_) {
      if (users_[a] || looked_up_ > most_looked_up) continue;
      for (const Index b : base_) {
        if (users_[b]) continue;
        for (const bool minus : {false, true}) {
          const Residue& term = residue(a);
          const Residue rest = (minus ? wanted + term : wanted - term) * inverse_[b];
          pairs_of(rest, [&](const Pair& pair, bool negative) {
            visit({Form::product_then_sum, pair, Traced(a, minus), Traced(b, negative), {}, false});
          });
          const Residue inner = wanted * inverse_[b] + (minus ? term : -term);
          pairs_of(inner, [&](const Pair& pair, bool negative) {
            visit({Form::sum_then_product, pair, Traced(a, minus), Traced(b, negative), {}, false});
          });
        }
      }
    }
    for (const auto& known : pairs_) {
      const auto& other = known.first;
      const auto& r = known.second;
      if (!allowed(other) || looked_up_ > most_looked_up) continue;
      if (other.product) {
        pairs_of(wanted * (inverse_[other.a.node()] * inverse_[other.b.node()]), [&](const Pair& pair, bool negative) {
          visit({Form::pairs_product, pair, {}, {}, other, negative});
        });
        for (const bool minus : {false, true})
          pairs_of(minus ? wanted + r : wanted - r, [&](const Pair& pair, bool negative) {
            visit({Form::pairs_sum, pair, Traced(0, minus), Traced(0, negative), other, false});
          });
      }
    }
  }

  // Roots may have taken another sign in the field than at the sample.
  bool has_value_of(Index x, const Recipe& recipe) const {
    using Form = Recipe::Form;
    const auto of = [&](const Traced& y) { return y.negative() ? -nodes_[y.node()].value : nodes_[y.node()].value; };
    const auto made = [&](const Pair& pair) {
      return pair.product ? of(pair.a) * of(pair.b) : of(pair.a) + of(pair.b);
    };
    const auto sign = [](bool negative) { return negative ? -1.0 : 1.0; };
    const double pair = made(recipe.pair), inner = sign(recipe.second.negative()) * pair, first = of(recipe.first);
    const double factor = nodes_[recipe.second.node()].value;
    double value = sign(recipe.negative) * pair;
    if (recipe.form == Form::product) value *= first;
    if (recipe.form == Form::sum) value = first + inner;
    if (recipe.form == Form::product_then_sum) value = first + factor * inner;
    if (recipe.form == Form::sum_then_product) value = factor * (first + inner);
    if (recipe.form == Form::pairs_product) value *= made(recipe.other);
    if (recipe.form == Form::pairs_sum) value = sign(recipe.first.negative()) * made(recipe.other) + inner;
    const double largest = std::max({std::fabs(value), std::fabs(nodes_[x].value), 1e-9});
    return std::fabs(value - nodes_[x].value) <= 1e-3 * largest;
  }

  // Everything that is computed from x, and x.
  void mark_users(Index x) {
    users_.assign(nodes_.size(), 0);
    users_[x] = 1;
    for (Index i = x + 1; i < nodes_.size(); ++i)
      users_[i] =
          is_operation(nodes_[i].operation) && (users_[nodes_[i].first.node()] || users_[nodes_[i].second.node()]);
  }

  // How many operations are needed for x alone, x included.
  int cone_of(Index x) const {
    std::vector<Index> uses = uses_;
    return 1 + released(x, uses);
  }
  int released(Index x, std::vector<Index>& uses) const {
    int count = 0;
    for (const Index operand : operands(x))
      if (--uses[operand] == 0 && is_operation(nodes_[operand].operation)) count += 1 + released(operand, uses);
    return count;
  }
  int taken(Index x, std::vector<Index>& uses) const {
    if (uses[x]++ > 0 || !is_operation(nodes_[x].operation)) return 0;
    int count = 1;
    for (const Index operand : operands(x)) count += taken(operand, uses);
    return count;
  }
  std::vector<Index> operands(Index x) const {
    std::vector<Index> list{nodes_[x].first.node()};
    if (nodes_[x].second.node() != 0) list.push_back(nodes_[x].second.node());
    return list;
  }
  int saved_by(Index x, const Recipe& recipe) const {
    std::vector<Index> uses = uses_;
    int saved = 1 + released(x, uses) - recipe.cost();
    for (const Index number : recipe.numbers())
      if (number != 0) saved -= taken(number, uses);
    return saved;
  }

  static constexpr std::size_t filter_size = 1U << 18U;

  const std::vector<Trace::Node>& nodes_;
  const std::vector<Traced>& outputs_;
  std::vector<Index> uses_;
  std::size_t& looked_up_;
  bool deep_ = false;
  std::vector<Index> base_;
  std::vector<Residue> inverse_;
  std::vector<std::pair<Pair, Residue>> pairs_;
  std::vector<Entry> table_;
  std::vector<char> filter_, users_;
};

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
    const Traced value = recipe_of_[i] ? made(*recipe_of_[i]) : computed(nodes_[i]);
    mapped_[i] = value;
    known_[i] = 1;
    return value;
  }
  Traced made(const Pair& pair) { return pair.product ? now(pair.a) * now(pair.b) : now(pair.a) + now(pair.b); }
  Traced made(const Recipe& recipe) {
    using Form = Recipe::Form;
    const Traced pair = made(recipe.pair);
    const auto with_sign = [](const Traced& x, bool negative) { return negative ? -x : x; };
    switch (recipe.form) {
      case Form::pair:
        return with_sign(pair, recipe.negative);
      case Form::product:
        return with_sign(now(recipe.first) * pair, recipe.negative);
      case Form::sum:
        return now(recipe.first) + with_sign(pair, recipe.second.negative());
      case Form::product_then_sum:
        return now(recipe.first) + now(recipe.second) * pair;
      case Form::sum_then_product: {
        const Traced factor(recipe.second.node(), false);
        return now(factor) * (now(recipe.first) + with_sign(pair, recipe.second.negative()));
      }
      case Form::pairs_product:
        return with_sign(made(recipe.other) * pair, recipe.negative);
      case Form::pairs_sum:
        return with_sign(made(recipe.other), recipe.first.negative()) + with_sign(pair, recipe.second.negative());
    }
    return {};
  }
  Traced computed(const Trace::Node& node) {
    if (circular_) return Traced();
    if (node.operation == Op::constant) return traced_constant(node.value, node.residue);
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

std::size_t operations_needed(const Trace& trace, const std::vector<Traced>& outputs) {
  const std::vector<Index> uses = uses_of(trace.nodes(), outputs);
  std::size_t count = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) count += uses[i] > 0 && is_operation(trace.nodes()[i].operation);
  return count;
}

std::optional<Resubstituted> resubstituted(const Trace& trace, const std::vector<Traced>& outputs) {
  std::optional<Resubstituted> best;
  std::size_t looked_up = 0, operations = operations_needed(trace, outputs);
  for (bool deep = false; looked_up < most_looked_up;) {
    const Trace& now = best ? best->trace : trace;
    const std::vector<Traced>& results = best ? best->outputs : outputs;
    Search search(now, results, looked_up);
    if (search.too_large()) break;
    const std::vector<std::pair<Index, Recipe>> recipes = search.find(deep);
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
    if (!next && deep) break;
    deep = !next;
    if (next) best = std::move(next);
  }
  return best;
}

}  // namespace poinsot
