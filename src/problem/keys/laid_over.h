// What a situation says, laid over what stands at the top of the file.
#pragma once

#include "problem/language/tree.h"

namespace poinsot::problem {

// Both are maps of the object "problem". Maps are merged key by key, everything else is replaced; and what can be said
// in several ways, such as the shape of a body, replaces what was said in another way.
Entry laid_over(const Entry& base, const Entry& overlay);

}  // namespace poinsot::problem
