// The zeros of a polynomial in [-1, 1] or in a square: all of them, by dividing it into pieces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/solve/roots/chebyshev_series.h"

namespace poinsot::solve {

// A part of the square: |s_k - middle_k| <= half_k.
struct Piece {
  Pair middle{0, 0}, half{1, 1};
};

struct PieceZeros {
  std::vector<Pair> zeros;  // simple ones, each the only one of a piece; those on borders may be listed twice
  // What is left: neither free of zeros nor with a single simple one, as far as the error lets see.
  std::vector<Piece> left;
  // Where pieces free of zeros have their smallest values, if these may be smaller than `touching`.
  std::vector<Pair> touching;
  // Two zeros of a curve of zeros, along which everything is left.
  std::optional<std::array<Pair, 2>> curve;
};

// error: by which the polynomial may be wrong anywhere (norm of all components). A variable in which the series has the
// size 1 plays no part: zeros then have zero there.
//
// A piece is free of zeros where a combination of components has a constant coefficient larger than all others
// together. It has at most one where, after multiplication with the inverse of the slopes in its middle, the slopes
// differ from the unit matrix by less than one everywhere; then zeros lie in the image of the piece under Krawczyk's
// operator, to which it is narrowed.
PieceZeros zeros_of_pieces(const ChebyshevSeries& series, double error, double touching);

}  // namespace poinsot::solve
