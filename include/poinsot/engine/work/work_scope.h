// A bound on work that ends what is done under it, as the end of a budget does.
#pragma once

#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {

// Ends after so much work of this thread from now on: the same on every machine.
Budget budget_of_work(Work most);

// No more than so much work is done while it lives: then BudgetEnded is thrown, and budgets around it hold as before.
class WorkScope {
 public:
  explicit WorkScope(Work most) : scope_(budget_of_work(most)) {}

 private:
  BudgetScope scope_;
};

}  // namespace poinsot
