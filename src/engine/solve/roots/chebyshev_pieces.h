// The zeros of a polynomial in [-1, 1] or in a square. All of them are found, by division into pieces.
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
  std::vector<Pair> zeros;  // simple zeros, each the only one of its piece; one on a border may be listed twice
  // Pieces that are neither shown to be free of zeros nor to hold a single simple one, as the error of the polynomial
  // does not allow to tell.
  std::vector<Piece> left;
  // The places of the smallest values in pieces free of zeros, where these values may be below `touching`.
  std::vector<Pair> touching;
  // Two zeros on a curve of zeros, if the pieces in `left` lie along one.
  std::optional<std::array<Pair, 2>> curve;
};

// error: a bound for the norm by which the polynomial may be wrong anywhere. A variable in which the series has the
// size 1 plays no part, and zeros have the coordinate zero there.
//
// A piece is free of zeros where a combination of components has a constant coefficient larger than all others
// together. It has at most one where, after multiplication with the inverse of the slopes in its middle, the slopes
// differ from the unit matrix by less than one everywhere; then zeros lie in the image of the piece under Krawczyk's
// operator, to which it is narrowed.
PieceZeros zeros_of_pieces(const ChebyshevSeries& series, double error, double touching);

}  // namespace poinsot::solve
