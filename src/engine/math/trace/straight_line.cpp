#include "poinsot/engine/math/trace/straight_line.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/math/trace/trace_nodes.h"
#include "engine/math/trace/trace_resubstitution.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot {
namespace {

using Op = TracedOperation;

constexpr int most_rounds = 4;  // of bringing together

// A product: factors of the new trace, in order.
struct Term {
  bool negative = false;
  Traced coefficient;  // a constant
  std::vector<Traced> factors;
};

// Computes what is needed of a trace again, in a new one, with sums factored.
class FactoredTrace {
 public:
  FactoredTrace(const Trace& old, const std::vector<Traced>& outputs)
      : nodes_(old.nodes()), uses_(uses_of(nodes_, outputs)), mapped_(nodes_.size()) {
    for (const Trace::Node& node : nodes_)
      if (node.operation == Op::input) inputs_.push_back(trace_.input(node.value));
    const TraceScope scope(trace_);
    // Operations that are used once within sums and products are not computed by themselves.
    inner_.assign(nodes_.size(), 0);
    for (std::size_t i = nodes_.size(); i-- > 1;) {
      if (uses_[i] == 0) continue;
      const Trace::Node& node = nodes_[i];
      const auto within = [&](const Traced& x, bool allowed) {
        if (allowed && uses_[x.node()] == 1) inner_[x.node()] = 1;
      };
      if (node.operation == Op::add) {
        for (const Traced& x : {node.first, node.second}) within(x, is_sum_or_product(x));
      } else if (node.operation == Op::multiply) {
        for (const Traced& x : {node.first, node.second}) within(x, nodes_[x.node()].operation == Op::multiply);
      }
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (uses_[i] > 0 && !inner_[i]) mapped_[i] = computed(static_cast<std::uint32_t>(i));
    for (const Traced& output : outputs) outputs_.push_back(now(output));
  }

  Trace take_trace() { return std::move(trace_); }
  const std::vector<Traced>& outputs() const { return outputs_; }

 private:
  bool is_sum_or_product(const Traced& x) const {
    const Op op = nodes_[x.node()].operation;
    return op == Op::add || op == Op::multiply;
  }
  Traced now(const Traced& x) const { return x.negative() ? -mapped_[x.node()] : mapped_[x.node()]; }

  void collect_factors(const Traced& x, Term& term) {
    if (inner_[x.node()] && nodes_[x.node()].operation == Op::multiply) {
      term.negative = term.negative != x.negative();
      collect_factors(nodes_[x.node()].first, term);
      collect_factors(nodes_[x.node()].second, term);
      return;
    }
    const Traced factor = now(x);
    term.negative = term.negative != factor.negative();
    const Traced size = factor.negative() ? -factor : factor;
    if (is_constant(size))
      term.coefficient = term.coefficient * size;
    else
      term.factors.push_back(size);
  }
  void collect_terms(const Traced& x, bool negative, std::vector<Term>& terms) {
    const bool sign = negative != x.negative();
    if (inner_[x.node()] && nodes_[x.node()].operation == Op::add) {
      collect_terms(nodes_[x.node()].first, sign, terms);
      collect_terms(nodes_[x.node()].second, sign, terms);
      return;
    }
    Term term{sign, Traced(1), {}};
    collect_factors(Traced(x.node(), false), term);
    terms.push_back(std::move(term));
  }

  static Traced product(const Term& term) {
    Traced value = term.coefficient;
    for (const Traced& factor : term.factors) value *= factor;
    return term.negative ? -value : value;
  }
  // A factor of as many terms as possible is taken out, as long as one stands in two.
  static Traced sum(std::vector<Term> terms) {
    Traced total;
    while (terms.size() > 1) {
      check_budget();
      std::vector<std::pair<std::uint32_t, std::size_t>> counts;
      for (const Term& term : terms) {
        std::vector<std::uint32_t> own;
        for (const Traced& factor : term.factors) own.push_back(factor.node());
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        for (const std::uint32_t factor : own) {
          const auto known =
              std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == factor; });
          if (known == counts.end())
            counts.emplace_back(factor, 1);
          else
            ++known->second;
        }
      }
      const auto most = std::max_element(counts.begin(), counts.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      if (most == counts.end() || most->second < 2) break;
      std::vector<Term> with, without;
      for (Term& term : terms) {
        const auto at = std::find_if(term.factors.begin(), term.factors.end(),
                                     [&](const Traced& factor) { return factor.node() == most->first; });
        if (at == term.factors.end()) {
          without.push_back(std::move(term));
        } else {
          term.factors.erase(at);
          with.push_back(std::move(term));
        }
      }
      Term together{false, Traced(1), {Traced(most->first, false)}};
      const Traced rest = sum(std::move(with));
      together.negative = rest.negative();
      const Traced size = rest.negative() ? -rest : rest;
      if (is_constant(size))
        together.coefficient = size;
      else
        together.factors.push_back(size);
      terms = std::move(without);
      if (!vanishes(size)) terms.push_back(std::move(together));
    }
    // Equal coefficients are taken out of neighbours.
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const Traced coefficient = terms[i].coefficient;
      Traced group = product({terms[i].negative, Traced(1), terms[i].factors});
      if (!(coefficient == Traced(1)))
        for (std::size_t j = i + 1; j < terms.size();) {
          if (!(terms[j].coefficient == coefficient)) {
            ++j;
            continue;
          }
          group += product({terms[j].negative, Traced(1), terms[j].factors});
          terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(j));
        }
      total += coefficient * group;
    }
    return total;
  }

  Traced computed(std::uint32_t i) {
    const Trace::Node& node = nodes_[i];
    switch (node.operation) {
      case Op::constant:
        return traced_constant(node.value, node.residue, node.rounding);
      case Op::input:
        return inputs_[node.input];
      case Op::add: {
        std::vector<Term> terms;
        collect_terms(node.first, false, terms);
        collect_terms(node.second, false, terms);
        return sum(std::move(terms));
      }
      case Op::multiply: {
        Term term{false, Traced(1), {}};
        collect_factors(node.first, term);
        collect_factors(node.second, term);
        return product(term);
      }
      default: {
        const Traced first = now(node.first);
        return operated(node.operation, first, now(node.second));
      }
    }
  }

  const std::vector<Trace::Node>& nodes_;
  std::vector<std::uint32_t> uses_;
  std::vector<char> inner_;
  std::vector<Traced> mapped_;
  Trace trace_;
  std::vector<Traced> inputs_, outputs_;
};

}  // namespace

bool is_operation(TracedOperation operation) { return operation != Op::constant && operation != Op::input; }

StraightLine::StraightLine(const Trace& trace, const std::vector<Traced>& outputs, Shortening shortening)
    : inputs_(trace.input_count()) {
  Trace shorter;
  const Trace* best = &trace;
  std::vector<Traced> results = outputs;
  std::size_t operations = operations_needed(trace, outputs);
  const auto take = [&](Trace candidate, const std::vector<Traced>& found) {
    const std::size_t count = operations_needed(candidate, found);
    if (count >= operations) return false;
    operations = count;
    results = found;
    shorter = std::move(candidate);
    best = &shorter;
    return true;
  };
  const auto bring_together = [&] {
    for (int round = 0; round < most_rounds; ++round) {
      FactoredTrace next(*best, results);
      Trace candidate = next.take_trace();
      if (!take(std::move(candidate), next.outputs())) break;
    }
  };
  bring_together();
  if (auto other = resubstituted(*best, results, shortening == Shortening::thorough)) {
    take(std::move(other->trace), other->outputs);
    bring_together();
  }

  const std::vector<Trace::Node>& nodes = best->nodes();
  const std::vector<std::uint32_t> uses = uses_of(nodes, results);
  std::vector<std::uint32_t> place(nodes.size(), 0);
  steps_.push_back({});
  const auto operand = [&](const Traced& x) { return Operand{place[x.node()], x.negative()}; };
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Trace::Node& node = nodes[i];
    if (uses[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(steps_.size());
    Step step;
    step.operation = node.operation;
    step.first = operand(node.first);
    step.second = operand(node.second);
    if (node.operation == Op::constant) {
      step.value = node.value;
      const SmallFraction fraction = small_fraction(node.residue, node.value);
      step.numerator = fraction.numerator;
      step.denominator = fraction.denominator;
    }
    step.input = node.input;
    steps_.push_back(step);
  }
  for (const Traced& result : results) outputs_.push_back(operand(result));
}

std::size_t StraightLine::operations() const {
  return static_cast<std::size_t>(
      std::count_if(steps_.begin(), steps_.end(), [](const Step& step) { return is_operation(step.operation); }));
}

void StraightLine::evaluate(std::span<const double> input, std::span<double> output) const {
  if (input.size() != inputs_ || output.size() != outputs_.size()) {
    throw std::invalid_argument("StraightLine::evaluate: got " + std::to_string(input.size()) + " numbers for " +
                                std::to_string(inputs_) + " inputs and room for " + std::to_string(output.size()) +
                                " of " + std::to_string(outputs_.size()) + " results");
  }
  std::vector<double> values(steps_.size());
  const auto of = [&values](const Operand& x) { return x.negative ? -values[x.step] : values[x.step]; };
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const double a = of(step.first), b = of(step.second);
    switch (step.operation) {
      case Op::constant:
        values[i] = step.value;
        break;
      case Op::input:
        values[i] = input[step.input];
        break;
      case Op::add:
        values[i] = a + b;
        break;
      case Op::multiply:
        values[i] = a * b;
        break;
      case Op::divide:
        values[i] = a / b;
        break;
      case Op::square_root:
        values[i] = std::sqrt(a);
        break;
      case Op::sine:
        values[i] = std::sin(a);
        break;
      case Op::cosine:
        values[i] = std::cos(a);
        break;
      case Op::arc_sine:
        values[i] = std::asin(a);
        break;
      case Op::arc_cosine:
        values[i] = std::acos(a);
        break;
      case Op::arc_tangent:
        values[i] = std::atan(a);
        break;
      case Op::arc_tangent_2:
        values[i] = std::atan2(a, b);
        break;
      case Op::absolute:
        values[i] = std::fabs(a);
        break;
    }
  }
  for (std::size_t i = 0; i < outputs_.size(); ++i) output[i] = of(outputs_[i]);
}

}  // namespace poinsot
