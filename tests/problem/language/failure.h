// The message of a StatementError that a piece of code must throw.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// what() of the error, "no error" if none comes.
template <class Code>
std::string failure_of(const Code& code) {
  try {
    code();
  } catch (const StatementError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace poinsot::problem
