// Where the sums, differences and products of any two numbers are looked up by their values in a finite field.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/math/formula/residue.h"

namespace poinsot::symbolic {

// The key of a value: the same for x and -x; 0 only for zero.
struct PairKey {
  std::uint64_t value = 0;
  bool negative = false;  // whether it is that of -x, as it were
};
constexpr PairKey pair_key(Modular x) {
  const std::uint64_t size = x.number();
  return size > Modular::prime / 2 ? PairKey{Modular::prime - size, true} : PairKey{size, false};
}
constexpr PairKey pair_key(const ModularPair& x) {
  if (x == ModularPair{}) return {};
  const bool negative = pair_key(x.real == Modular() ? x.imaginary : x.real).negative;
  const ModularPair y = negative ? -x : x;
  return {mixed(mixed(y.real.number()) + y.imaginary.number()) | 1U, negative};
}

// Pairs by their values up to sign, at one point of the field: open addressing, and bits that tell of most values that
// they are not there. Of a key some bits are compared: what is found is still to be checked.
class PairTable {
 public:
  // Of the numbers with these places in a list.
  struct Entry {
    std::uint8_t first = 0, second = 0;
    bool product : 1 = false, minus : 1 = false;  // a b, a - b, or else a + b
    bool negative : 1 = false;                    // whether the key is that of minus the pair
  };
  static constexpr std::size_t most_places = 256;

  // Of so many pairs at most; none yet.
  void clear(std::size_t most) {
    mask_ = std::bit_ceil(most + most / 2 + 1) - 1;
    slots_.assign(mask_ + 1, {});
    bit_mask_ = 16 * (mask_ + 1) - 1;
    bits_.assign((bit_mask_ + 1) / 64 + 1, 0);
  }
  void add(std::uint64_t key, const Entry& entry) {
    std::size_t at = key & mask_;
    while (slots_[at].tag != 0) at = (at + 1) & mask_;
    slots_[at] = {tag(key), entry};
    const std::uint64_t bit = key & bit_mask_;
    bits_[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
  template <class Visit>
  void find(std::uint64_t key, const Visit& visit) const {
    const std::uint64_t bit = key & bit_mask_;
    if (!(bits_[bit / 64] >> (bit % 64) & 1U)) return;
    for (std::size_t at = key & mask_; slots_[at].tag != 0; at = (at + 1) & mask_)
      if (slots_[at].tag == tag(key)) visit(slots_[at].entry);
  }

 private:
  struct Slot {
    std::uint32_t tag = 0;  // 0: free
    Entry entry{};
  };
  static std::uint32_t tag(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 28U) | 1U; }

  std::uint64_t mask_ = 0, bit_mask_ = 0;
  std::vector<Slot> slots_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace poinsot::symbolic
