// Any bytes as a problem file: a tree or a StatementError with a place, nothing else.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "problem/language/expression.h"
#include "problem/language/tree.h"

using namespace poinsot::problem;

namespace {

void visit(const Entry& entry, int depth) {
  if (depth > static_cast<int>(TreeLimits::depth) || entry.text.size() > TreeLimits::scalar_bytes) std::abort();
  if (entry.mark.line < 1 || entry.mark.column < 1) std::abort();
  for (std::size_t i = 0; i <= entry.text.size(); ++i) {
    const Mark place = entry.place(i);
    if (place.line < entry.mark.line || place.column < 1) std::abort();
  }
  for (const Entry& item : entry.items) visit(item, depth + 1);
  for (const auto& [key, value] : entry.members) {
    if (key.text.empty() || entry.find(key.text) != &value) std::abort();
    visit(value, depth + 1);
  }
  try {
    parse_expression(entry, "fuzz");
  } catch (const StatementError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    visit(read_tree({reinterpret_cast<const char*>(data), size}, "fuzz"), 0);
  } catch (const StatementError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      if (diagnostic.mark.line < 1 || diagnostic.mark.column < 1 || diagnostic.message.empty()) std::abort();
    }
  }
  return 0;
}
