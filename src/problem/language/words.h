// Names and numbers put together for sentences, and lists without repetition.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::problem {

// "a, b, c".
inline std::string joined(const std::vector<std::string>& words, std::string_view between = ", ") {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text.append(i == 0 ? std::string_view() : between).append(words[i]);
  return text;
}

// "a, b and c", with `last` between the last two.
inline std::string listed(const std::vector<std::string>& words, std::string_view last = "and") {
  if (words.size() < 2) return joined(words);
  return joined({words.begin(), words.end() - 1}) + " " + std::string(last) + " " + words.back();
}

// The names of things that have one, in their order.
template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

// "no starts", "one start", "12 starts".
inline std::string counted(std::size_t count, const std::string& what) {
  return (count == 0 ? "no" : count == 1 ? "one" : std::to_string(count)) + " " + what + (count == 1 ? "" : "s");
}

// A number to so many significant digits, without zeros at the end: "0.1234", "1.234e+06". The locale of the caller has
// no say in it.
inline std::string with_digits(double value, int digits) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
  return {text, end.ptr};
}

// Adds an item that the list does not hold yet.
template <class Item>
void add_once(std::vector<Item>& list, const Item& item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

}  // namespace poinsot::problem
