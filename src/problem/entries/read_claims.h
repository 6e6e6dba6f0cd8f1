// Reads `letters:`, `assume:` and `claim:`.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/keys/reader.h"

namespace poinsot::problem {

// Reads `m: kg`, or `x: {signed: m}` for a letter that may be negative.
Letter read_letter(const Key& name, const Entry& entry, const std::string& file);

// Reads the comparisons under `assume:`.
std::vector<Expression> read_assumptions(const Members& members, const std::string& file);

// Throws StatementError where answers that are words, as of precession_sense(), are compared: in what is claimed or
// asked.
void refuse_compared_words(const Expression& expression, const std::string& file);

// Reads `a: X == Y`, a list of such, or {claim: ..., assume: [...], axes: B, situation: S}.
Claim read_claim(const Key& name, const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
