// What is thrown near a motion that is steady at an instant only, as where a body spins that is not alike all round, or
// gravity goes round a frame that turns.
#pragma once

#include <stdexcept>

namespace poinsot::solve {

class ChangingEquations : public std::runtime_error {
 public:
  ChangingEquations()
      : std::runtime_error(
            "the equations near this motion change with time: something that turns is not alike all round its axis, or "
            "is held, pulled or pushed from beside it") {}
};

}  // namespace poinsot::solve
