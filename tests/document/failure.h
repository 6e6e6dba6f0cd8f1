// The message of a StatementError that a call from outside must throw.
#pragma once

#include <string>

#include "poinsot/problem.h"

namespace poinsot::document {

// what() of the error, "no error" if none comes.
template <class Call>
std::string failure_of(const Call& call) {
  try {
    call();
  } catch (const StatementError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace poinsot::document
