#include "problem/claims/claim_faults.h"

#include <algorithm>
#include <utility>

#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// The message without its numbers, which differ between points: faults with equal ones are of one kind.
std::string kind_of(const StatementError& error) {
  std::string kind = error.what();
  std::erase_if(kind, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return kind;
}

}  // namespace

std::string words_of_point(const std::vector<Letter>& letters, const Point& point) {
  std::string words;
  for (const Letter& letter : letters) {
    const auto value = point.find(letter.name);
    if (value == point.end()) continue;
    words += (words.empty() ? "" : ", ") + letter.name + " = " + with_digits(value->second / letter.unit.factor, 4) +
             (letter.unit.text.empty() ? "" : " " + letter.unit.text);
  }
  return words;
}

void ClaimFaults::note(const StatementError& error, const Point& point) {
  std::string kind = kind_of(error);
  for (Met& known : met_)
    if (known.kind == kind) {
      ++known.times;
      return;
    }
  met_.push_back({error, std::move(kind), point});
}

const ClaimFaults::Met& ClaimFaults::chief() const {
  return *std::max_element(met_.begin(), met_.end(), [](const Met& a, const Met& b) { return a.times < b.times; });
}

StatementError ClaimFaults::most_frequent(const std::vector<Letter>& letters) const {
  std::vector<Diagnostic> diagnostics = chief().error.diagnostics();
  if (const std::string values = words_of_point(letters, chief().point); !values.empty())
    diagnostics.front().message += ", as at " + values;
  return StatementError(std::move(diagnostics));
}

std::string ClaimFaults::words(const std::vector<Letter>& letters) const {
  return most_frequent(letters).diagnostics().front().message;
}

}  // namespace poinsot::problem
