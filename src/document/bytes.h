// Numbers and texts as bytes of a file, with the lowest byte first on any machine.
#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace poinsot::document {

class ByteWriter {
 public:
  void u32(std::uint32_t value) { number(value, 4); }
  void u64(std::uint64_t value) { number(value, 8); }
  void f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }
  void text(std::string_view value) {
    u64(value.size());
    bytes_ += value;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void number(std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) bytes_.push_back(static_cast<char>((value >> (8 * k)) & 0xff));
  }
  std::string bytes_;
};

// Reads what ByteWriter has written. Throws std::out_of_range if the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t u64() { return number(8); }
  double f64() { return std::bit_cast<double>(u64()); }
  std::string_view text() { return take(u64()); }
  bool at_end() const { return bytes_.empty(); }
  // The number of items of at least `size` bytes that follow, from their count.
  std::size_t count(std::size_t size) {
    const std::uint64_t items = u64();
    if (items > bytes_.size() / size) throw std::out_of_range("more items than there are bytes");
    return static_cast<std::size_t>(items);
  }

 private:
  std::uint64_t number(std::size_t size) {
    const std::string_view digits = take(size);
    std::uint64_t value = 0;
    for (std::size_t k = size; k-- > 0;) value = (value << 8) | static_cast<unsigned char>(digits[k]);
    return value;
  }
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) throw std::out_of_range("the bytes end too early");
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(size));
    bytes_.remove_prefix(static_cast<std::size_t>(size));
    return taken;
  }
  std::string_view bytes_;
};

}  // namespace poinsot::document
