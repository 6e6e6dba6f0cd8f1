// What a Trace holds, for the sources of the room.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/math/formula/residue.h"
#include "poinsot/engine/math/algebra/rounded.h"
#include "poinsot/engine/math/trace/traced.h"

namespace poinsot {

struct Trace::Node {
  TracedOperation operation = TracedOperation::constant;
  Traced first, second;         // operands
  double value = 0;             // of a constant; else at the sample
  std::uint32_t input = 0;      // which variable
  symbolic::Residue residue{};  // at random points
  double rounding = 0;          // how far the value may be off

  Rounded rounded() const { return {value, rounding}; }
};

struct Trace::State {
  std::vector<Node> nodes;
  std::unordered_map<std::uint64_t, std::uint32_t> known;       // by the hash of a residue up to sign
  std::unordered_map<std::uint64_t, std::uint32_t> directions;  // the first of all constant multiples
  std::uint32_t inputs = 0;
  std::vector<Traced> assumed_positive;
};

// An operation on its operands, recorded; `second` counts for operations on two. Not for constants and inputs.
Traced operated(TracedOperation operation, const Traced& first, const Traced& second);

// How often each number is used by what the outputs need.
std::vector<std::uint32_t> uses_of(const std::vector<Trace::Node>& nodes, const std::vector<Traced>& outputs);

// Whether two values at the sample are those of one number: apart by no more than their rounding. Equal residues alone
// do not tell, since a root may have taken another sign in the field; and a part of the values would not tell either,
// where the root is small beside the rest.
inline bool same_at_sample(const Rounded& a, const Rounded& b) { return (a - b).may_vanish(); }

// A constant of a value with its residue, in the trace that is being recorded. rounding: how far the value is off
// beyond its last digit.
Traced traced_constant(double value, const symbolic::Residue& residue, double rounding = 0);
// The residue of a positive finite number: of the fraction of small numbers whose nearest double it is, if there is
// one.
symbolic::Residue residue_of(double x);
// The residue of a whole number or decimal without sign, digit by digit: "12", "0.25".
symbolic::Residue residue_of_digits(const std::string& digits);

// A fraction of small numbers that the residue stands for, if its value is this one to a tolerance; else denominator 0.
struct SmallFraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 0;
};
SmallFraction small_fraction(const symbolic::Residue& residue, double value, double tolerance = 1e-15);

}  // namespace poinsot
