#include "poinsot/engine/math/formula/formula_decision.h"

#include <algorithm>
#include <utility>

namespace poinsot {
namespace {

thread_local DecisionScope* innermost = nullptr;

}  // namespace

DecisionScope::DecisionScope() : outer_(std::exchange(innermost, this)) {}
DecisionScope::~DecisionScope() { innermost = outer_; }

void note_sign(const Formula& x) {
  if (!innermost || x.is_number()) return;
  std::vector<Formula>& noted = innermost->signs_;
  if (std::find(noted.begin(), noted.end(), x) == noted.end()) noted.push_back(x);
}

bool notes_decisions() { return innermost != nullptr; }

void note_zero_by_digits() {
  if (innermost) innermost->zeros_by_digits_ = true;
}

}  // namespace poinsot
