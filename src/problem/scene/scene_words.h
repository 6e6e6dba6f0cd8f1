// The words of a scene's kinds, in the order of their enumerations (poinsot/scene.h): those of the answer document and
// of its schema. Joints, supports and shapes have the names of the language.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "poinsot/scene.h"

namespace poinsot::problem {

inline std::span<const std::string_view> words_of(scene::Extent) {
  static constexpr std::array<std::string_view, 4> words{"point", "line", "surface", "volume"};
  return words;
}

inline std::span<const std::string_view> words_of(scene::SymbolKind) {
  static constexpr std::array<std::string_view, 19> words{
      "weld",   "revolute",     "prismatic",      "cylindrical", "universal",      "ball",  "planar",
      "screw",  "slot",         "journal",        "thrust",      "collar",         "hinge", "fork",
      "clevis", "ball_support", "listed_support", "contact",     "rolling_contact"};
  static_assert(words.size() == static_cast<std::size_t>(scene::SymbolKind::rolling_contact) + 1,
                "a word for each kind, in their order");
  return words;
}

inline std::span<const std::string_view> words_of(scene::LinkKind) {
  static constexpr std::array<std::string_view, 4> words{"cord", "spring", "damper", "torsion"};
  return words;
}

inline std::span<const std::string_view> words_of(scene::Quantity) {
  static constexpr std::array<std::string_view, 16> words{"force",
                                                          "weight",
                                                          "couple",
                                                          "impulse",
                                                          "angular_impulse",
                                                          "velocity",
                                                          "angular_velocity",
                                                          "acceleration",
                                                          "angular_acceleration",
                                                          "linear_momentum",
                                                          "angular_momentum",
                                                          "rate_of_momentum",
                                                          "rate_of_angular_momentum",
                                                          "displacement",
                                                          "angular_displacement",
                                                          "unbalance"};
  return words;
}

inline std::span<const std::string_view> words_of(scene::DiagramKind) {
  static constexpr std::array<std::string_view, 7> words{"model",    "free_body",     "kinetic", "momenta_before",
                                                         "impulses", "momenta_after", "answers"};
  return words;
}

inline std::span<const std::string_view> words_of(scene::CurveKind) {
  static constexpr std::array<std::string_view, 8> words{"path",         "polhode", "herpolhode", "axis_path",
                                                         "pitch_circle", "post",    "surface",    "attractor"};
  return words;
}

template <class Kind>
std::string_view word(Kind kind) {
  return words_of(kind)[static_cast<std::size_t>(kind)];
}

// The kind that has this word; nothing if there is none.
template <class Kind>
std::optional<Kind> kind_of_word(std::string_view word) {
  const std::span<const std::string_view> words = words_of(Kind{});
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) return std::nullopt;
  return static_cast<Kind>(found - words.begin());
}

}  // namespace poinsot::problem
