// Values of formulas at random points of a finite field, by which equal formulas are found.
//
// Two rational functions that take the same value at a random point of a field with q elements are the same but for a
// probability of degree / q (Schwartz, J. ACM 27, 1980). Here every value is taken at two points of the field of
// a + b i modulo p = 2^61 - 1 (no square root of -1 there, so that it has p^2 elements, and a root of every element of
// the smaller field). The two points take opposite signs of a square root: x and the root of x^2 stay apart.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace poinsot::symbolic {

class Modular {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

  constexpr Modular() = default;
  // 2^61 is 1.
  constexpr explicit Modular(std::uint64_t number) : number_((number & prime) + (number >> 61)) {
    if (number_ >= prime) number_ -= prime;
  }
  constexpr std::uint64_t number() const { return number_; }

  friend constexpr bool operator==(const Modular&, const Modular&) = default;
  friend constexpr Modular operator+(Modular a, Modular b) { return Modular(a.number_ + b.number_); }
  friend constexpr Modular operator-(Modular a) { return Modular(prime - a.number_); }
  friend constexpr Modular operator-(Modular a, Modular b) { return Modular(a.number_ + (prime - b.number_)); }
  friend constexpr Modular operator*(Modular a, Modular b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = Wide{a.number_} * b.number_;
    return Modular(static_cast<std::uint64_t>(product & prime) + static_cast<std::uint64_t>(product >> 61));
  }

 private:
  std::uint64_t number_ = 0;
};

constexpr Modular power(Modular base, std::uint64_t exponent) {
  Modular result(1);
  for (; exponent > 0; exponent >>= 1, base = base * base)
    if (exponent & 1) result = result * base;
  return result;
}
// Of a number that is not zero (Fermat).
constexpr Modular inverse(Modular a) { return power(a, Modular::prime - 2); }
constexpr std::optional<Modular> square_root(Modular a) {
  const Modular root = power(a, (Modular::prime + 1) / 4);
  return root * root == a ? std::optional(root) : std::nullopt;
}

// real + imaginary i.
struct ModularPair {
  Modular real{}, imaginary{};
  friend constexpr bool operator==(const ModularPair&, const ModularPair&) = default;
  friend constexpr ModularPair operator+(const ModularPair& a, const ModularPair& b) {
    return {a.real + b.real, a.imaginary + b.imaginary};
  }
  friend constexpr ModularPair operator-(const ModularPair& a) { return {-a.real, -a.imaginary}; }
  friend constexpr ModularPair operator-(const ModularPair& a, const ModularPair& b) { return a + -b; }
  friend constexpr ModularPair operator*(const ModularPair& a, const ModularPair& b) {
    return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
  }
};
// Of a number that is not zero.
constexpr ModularPair inverse(const ModularPair& a) {
  const Modular size = inverse(a.real * a.real + a.imaginary * a.imaginary);
  return {a.real * size, -(a.imaginary * size)};
}

constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

// The value at both points.
class Residue {
 public:
  constexpr Residue() = default;
  static constexpr Residue of_integer(std::uint64_t number) {
    Residue r;
    for (ModularPair& at : r.at_) at.real = Modular(number);
    return r;
  }
  // Of what is no rational function of anything else, told apart by the seed.
  static constexpr Residue random(std::uint64_t seed) {
    Residue r;
    for (std::size_t k = 0; k < 2; ++k) r.at_[k].real = Modular(mixed(mixed(seed) + k));
    return r;
  }

  constexpr std::uint64_t hash() const {
    std::uint64_t h = 0;
    for (const ModularPair& at : at_) h = mixed(mixed(h + at.real.number()) + at.imaginary.number());
    return h;
  }
  // One for r and -r.
  constexpr std::uint64_t hash_up_to_sign() const {
    for (const ModularPair& at : at_)
      for (const Modular& part : {at.real, at.imaginary})
        if (!(part == Modular())) return part.number() > Modular::prime / 2 ? (-*this).hash() : hash();
    return hash();
  }
  constexpr bool is_zero() const { return *this == Residue(); }
  // Whether it has an inverse.
  constexpr bool is_unit() const { return !(at_[0] == ModularPair{}) && !(at_[1] == ModularPair{}); }
  constexpr const ModularPair& at(std::size_t point) const { return at_[point]; }

  friend constexpr bool operator==(const Residue&, const Residue&) = default;
  friend constexpr Residue operator+(const Residue& a, const Residue& b) {
    Residue c;
    for (std::size_t k = 0; k < 2; ++k) c.at_[k] = a.at_[k] + b.at_[k];
    return c;
  }
  friend constexpr Residue operator-(const Residue& a) {
    Residue c;
    for (std::size_t k = 0; k < 2; ++k) c.at_[k] = -a.at_[k];
    return c;
  }
  friend constexpr Residue operator-(const Residue& a, const Residue& b) { return a + -b; }
  friend constexpr Residue operator*(const Residue& a, const Residue& b) {
    Residue c;
    for (std::size_t k = 0; k < 2; ++k) c.at_[k] = a.at_[k] * b.at_[k];
    return c;
  }
  // Of a unit.
  friend constexpr Residue inverse(const Residue& a) {
    Residue c;
    for (std::size_t k = 0; k < 2; ++k) c.at_[k] = inverse(a.at_[k]);
    return c;
  }
  // A square root with opposite signs at the two points, if a stays in the smaller field.
  friend constexpr std::optional<Residue> square_root(const Residue& a) {
    Residue c;
    for (std::size_t k = 0; k < 2; ++k) {
      const ModularPair& x = a.at_[k];
      if (!(x.imaginary == Modular())) return std::nullopt;
      if (const auto root = square_root(x.real))
        c.at_[k].real = k == 0 ? *root : -*root;
      else
        c.at_[k].imaginary = k == 0 ? *square_root(-x.real) : -*square_root(-x.real);
    }
    return c;
  }
  // The same for all constant multiples of a unit, those of numbers that take one value at both points.
  friend constexpr std::uint64_t direction_hash(const Residue& a) {
    const ModularPair ratio = a.at_[0] * inverse(a.at_[1]);
    return mixed(mixed(ratio.real.number()) + ratio.imaginary.number());
  }
  // With minus at the second point.
  friend constexpr Residue other_sign(Residue a) {
    a.at_[1] = {-a.at_[1].real, -a.at_[1].imaginary};
    return a;
  }

 private:
  std::array<ModularPair, 2> at_{};
};

}  // namespace poinsot::symbolic
