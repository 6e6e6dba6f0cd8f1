// What a statement says of a law of force (engine/dynamics/force_law.h).
//
// Each law is a struct in a file of its own, like stated_spring.h: what the file says of it, how it is read and how a
// worked solution puts it. Situation has a list of each (statement.h). Those who ask which bodies a law joins, what
// part an expression plays in it or whether it follows time visit all laws there.
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// The part that an expression plays in a law.
enum class LawPart {
  place,      // a point of a body
  direction,  // or an axis
  effort,     // the size of a force or couple
  extent,     // a length, not negative
  angle,
  resistance  // a stiffness or a damping, not negative
};

// A body that a law names.
struct LawBody {
  std::string name;
  Mark mark;
  bool may_be_frame = false;  // whether a frame may stand in its place
};

// How an expression is written in a sentence.
using WrittenExpression = std::function<std::string(const Expression&)>;

template <class Law>
concept StatedLaw = requires(const Law& law, const Key& name, const Entry& entry, const std::string& file) {
  // The list in which it stands.
  { Law::list } -> std::convertible_to<std::string>;
  // Whether its expressions may depend on the time.
  { Law::may_follow_time } -> std::convertible_to<bool>;
  { law.name } -> std::convertible_to<std::string>;
  { law.mark } -> std::convertible_to<Mark>;
  // Throws StatementError for keys that are unknown, missing or at odds.
  { Law::read(name, entry, file) } -> std::same_as<Law>;
  { law.bodies() } -> std::same_as<std::vector<LawBody>>;
  // A line of worked solutions, as Markdown.
  { law.words(WrittenExpression{}) } -> std::same_as<std::string>;
  // Visits each expression that may be stated, with its part.
  law.for_each_part([](LawPart, const std::optional<Expression>&) {});
};

}  // namespace poinsot::problem
