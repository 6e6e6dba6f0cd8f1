// Sums of numbers and symbols as they stand in displayed equations, read back.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::testing {

struct TexSum {
  double value = 0;
  double size = 0;  // of the largest term
};

// "-2.5\,A_{x} + 3\cdot 10^{-5} - B_{z}" with values for the symbols; a unit \ \mathrm{N} may stand behind. Nothing for
// anything else, such as a formula in letters.
class TexSumReader {
 public:
  TexSumReader(std::string text, std::vector<std::pair<std::string, double>> symbols)
      : text_(std::move(text)), symbols_(std::move(symbols)) {
    if (const std::size_t unit = text_.find("\\ \\mathrm{"); unit != std::string::npos) text_.resize(unit);
    // The longest first, so that one that begins like another is not taken for it.
    std::sort(symbols_.begin(), symbols_.end(),
              [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  }

  std::optional<TexSum> read() {
    TexSum sum;
    for (bool first = true; first || at_ < text_.size(); first = false) {
      skip_blanks();
      double sign = 1;
      if (text_[at_] == '-' || text_[at_] == '+') {
        sign = text_[at_++] == '-' ? -1 : 1;
      } else if (!first) {
        return std::nullopt;
      }
      skip_blanks();
      const std::optional<double> term = read_term();
      if (!term) return std::nullopt;
      sum.value += sign * *term;
      sum.size = std::max(sum.size, std::abs(*term));
      skip_blanks();
    }
    return sum;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(const std::string& piece) {
    if (text_.compare(at_, piece.size(), piece) != 0) return false;
    at_ += piece.size();
    return true;
  }

  std::optional<double> read_term() {
    const bool has_digits = at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
    double factor = 1;
    if (has_digits) {
      std::size_t length = 0;
      factor = std::stod(text_.substr(at_), &length);
      at_ += length;
      if (take("\\cdot 10^{")) {
        factor *= std::pow(10.0, std::stoi(text_.substr(at_), &length));
        at_ += length + 1;
      }
      if (!take("\\,")) return factor;
    }
    for (const auto& [symbol, value] : symbols_)
      if (take(symbol)) return factor * value;
    return std::nullopt;
  }

  std::string text_;
  std::vector<std::pair<std::string, double>> symbols_;
  std::size_t at_ = 0;
};

}  // namespace poinsot::testing
