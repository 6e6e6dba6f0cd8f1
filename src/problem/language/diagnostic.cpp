#include "problem/language/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace poinsot::problem {

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.mark.line > 0) {
    text += ':' + std::to_string(diagnostic.mark.line) + ':' + std::to_string(diagnostic.mark.column);
  }
  text += ": error: " + diagnostic.message;
  if (!diagnostic.hint.empty()) text += " (" + diagnostic.hint + ")";
  return text;
}

StatementError::StatementError(Diagnostic diagnostic)
    : StatementError(std::vector<Diagnostic>{std::move(diagnostic)}) {}

StatementError::StatementError(std::vector<Diagnostic> diagnostics) : diagnostics_(std::move(diagnostics)) {
  if (diagnostics_.empty()) throw std::invalid_argument("a StatementError needs at least one diagnostic");
  for (const Diagnostic& diagnostic : diagnostics_) {
    if (!text_.empty()) text_ += '\n';
    text_ += to_string(diagnostic);
  }
}

StatementError::StatementError(std::string file, Mark mark, std::string message, std::string hint)
    : StatementError(Diagnostic{std::move(file), mark, std::move(message), std::move(hint)}) {}

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

double replacement(char a, char b) { return a == b ? 0.0 : lower(a) == lower(b) ? 0.5 : 1.0; }

double largest_slip(std::size_t letters) { return letters < 2 ? 0.5 : letters < 5 ? 1.0 : letters < 8 ? 2.0 : 3.0; }

// Suggestions are not sought for longer words: names are shorter, and the distance takes the product of the lengths
// in steps.
constexpr std::size_t longest_word = 80;

}  // namespace

NotHappeningError::NotHappeningError(std::string file, Mark mark, std::string message, std::string hint, double until)
    : UnansweredError(std::move(file), mark, std::move(message), std::move(hint)), until_(until) {}

void fail(const std::string& file, Mark mark, std::string message, std::string hint) {
  throw StatementError(Diagnostic{file, mark, std::move(message), std::move(hint)});
}

double edit_distance(std::string_view a, std::string_view b) {
  // The last three rows of the table of distances between the beginnings of a and b.
  std::vector<double> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) now[j] = static_cast<double>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, now);
    now[0] = static_cast<double>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + replacement(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
    }
  }
  return now[b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.empty() || word.size() > longest_word) return "";
  std::string best;
  double least = largest_slip(word.size()) + 0.25;
  for (const std::string& candidate : candidates) {
    if (candidate == word || candidate.size() > longest_word) continue;
    const bool same_letters = std::equal(word.begin(), word.end(), candidate.begin(), candidate.end(),
                                         [](char a, char b) { return lower(a) == lower(b); });
    const double distance = same_letters ? 0.5 : edit_distance(word, candidate);
    // Words that differ in as many places as they have letters have nothing in common.
    if (distance < least && distance < static_cast<double>(std::max(word.size(), candidate.size()))) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? "" : "did you mean '" + near + "'?";
}

}  // namespace poinsot::problem
