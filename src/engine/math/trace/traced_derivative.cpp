#include "poinsot/engine/math/trace/traced_derivative.h"

#include <algorithm>
#include <cstddef>

#include "engine/math/trace/trace_nodes.h"
#include "poinsot/engine/math/trace/straight_line.h"

namespace poinsot {
namespace {

using Op = TracedOperation;

// The rate of an operation's result, from those of its operands.
Traced rate_of(const Trace::Node& node, const Traced& result, const Traced& first_rate, const Traced& second_rate) {
  const Traced &a = node.first, &b = node.second;
  switch (node.operation) {
    case Op::add:
      return first_rate + second_rate;
    case Op::multiply:
      return first_rate * b + a * second_rate;
    case Op::divide:
      return (first_rate - result * second_rate) / b;
    case Op::square_root:
      return vanishes(first_rate) ? Traced() : first_rate / (Traced(2) * result);
    case Op::sine:
      return cos(a) * first_rate;
    case Op::cosine:
      return -(sin(a) * first_rate);
    case Op::arc_sine:
      return vanishes(first_rate) ? Traced() : first_rate / sqrt(Traced(1) - a * a);
    case Op::arc_cosine:
      return vanishes(first_rate) ? Traced() : -(first_rate / sqrt(Traced(1) - a * a));
    case Op::arc_tangent:
      return first_rate / (Traced(1) + a * a);
    case Op::arc_tangent_2:
      return vanishes(first_rate) && vanishes(second_rate) ? Traced()
                                                           : (b * first_rate - a * second_rate) / (a * a + b * b);
    case Op::absolute:
      return vanishes(first_rate) ? Traced() : result / a * first_rate;
    case Op::constant:
    case Op::input:
      break;
  }
  return {};
}

}  // namespace

std::vector<Traced> traced_derivative(const Trace& trace, const std::vector<Traced>& outputs,
                                      const std::vector<Traced>& input_rates) {
  const std::size_t count = trace.nodes().size();
  std::vector<bool> needed(count, false);
  for (const Traced& output : outputs) needed[output.node()] = true;
  for (std::size_t i = count; i-- > 0;) {
    const Trace::Node& node = trace.nodes()[i];
    if (!needed[i] || !is_operation(node.operation)) continue;
    needed[node.first.node()] = true;
    needed[node.second.node()] = true;
  }
  std::vector<Traced> rates(count);
  const auto rate = [&](const Traced& x) { return x.negative() ? -rates[x.node()] : rates[x.node()]; };
  for (std::size_t i = 0; i < count; ++i) {
    if (!needed[i]) continue;
    // What is recorded here moves the nodes.
    const Trace::Node node = trace.nodes()[i];
    if (node.operation == Op::input && node.input < input_rates.size()) rates[i] = input_rates[node.input];
    if (is_operation(node.operation))
      rates[i] = rate_of(node, Traced(static_cast<std::uint32_t>(i), false), rate(node.first), rate(node.second));
  }
  std::vector<Traced> found;
  for (const Traced& output : outputs) found.push_back(rate(output));
  return found;
}

}  // namespace poinsot
