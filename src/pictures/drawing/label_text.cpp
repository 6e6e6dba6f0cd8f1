#include "pictures/drawing/label_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

#include "pictures/drawing/font_metrics.h"
#include "poinsot/rendering.h"

namespace poinsot::pictures {
namespace {

constexpr std::size_t longest_tex = 1000;  // beyond this no symbol goes, but a hostile name may
constexpr int deepest = 20;
constexpr double index_size = 0.72, index_drop = 0.22, power_rise = 0.38;

using Word = std::pair<std::string_view, std::string_view>;
constexpr std::array<Word, 47> letters_of_tex{{
    {"alpha", "α"}, {"beta", "β"},    {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"varepsilon", "ε"},
    {"zeta", "ζ"},  {"eta", "η"},     {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"},   {"lambda", "λ"},
    {"mu", "μ"},    {"nu", "ν"},      {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},     {"sigma", "σ"},
    {"tau", "τ"},   {"upsilon", "υ"}, {"phi", "φ"},   {"varphi", "φ"}, {"chi", "χ"},     {"psi", "ψ"},
    {"omega", "ω"}, {"Gamma", "Γ"},   {"Delta", "Δ"}, {"Theta", "Θ"},  {"Lambda", "Λ"},  {"Xi", "Ξ"},
    {"Pi", "Π"},    {"Sigma", "Σ"},   {"Phi", "Φ"},   {"Psi", "Ψ"},    {"Omega", "Ω"},   {"cdot", "·"},
    {"times", "×"}, {"circ", "°"},    {"prime", "′"}, {"sum", "Σ"},    {"_", "_"},       {"&", "&"},
    {"%", "%"},     {"#", "#"},       {"$", "$"},     {"{", "{"},      {"}", "}"},
}};

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

std::size_t length_of_letter(std::string_view text, std::size_t at) {
  std::size_t length = 1;
  while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xc0U) == 0x80U) ++length;
  return length;
}

// Sets runs side by side on a base line.
class Setter {
 public:
  explicit Setter(double size) : size_(size) {}

  void put(std::string_view text, Face face) {
    // A prime beside the end of a bar would look like the head of an arrow.
    if (text == "′" || text == "'")
      for (const Accent& accent : label_.accents)
        if (std::abs(accent.to.x - x_) < 0.1 * size_) x_ += 0.14 * size_;
    Run run{std::string(text), face, size_, {x_, y_}, text_width(text, face, size_)};
    x_ += run.width;
    auto& runs = label_.runs;
    if (!runs.empty() && runs.back().face == face && runs.back().size == size_ && runs.back().offset.y == y_ &&
        x_ - run.width - (runs.back().offset.x + runs.back().width) < 1e-9) {
      runs.back().text += run.text;
      runs.back().width += run.width;
    } else {
      runs.push_back(std::move(run));
    }
    label_.box.include(Point2{x_, y_ + descent * size_ * (lowered_ ? 0.6 : 1)});
    label_.box.include(Point2{0, y_ - ascent * size_});
  }
  void gap(double part) { x_ += part * size_; }
  // Small letters, lower or higher, until restore().
  void lower() { shift(index_drop); }
  void raise() { shift(-power_rise); }
  void restore() {
    const Line& before = lines_.back();
    size_ = before.size;
    y_ = before.y;
    lowered_ = before.lowered;
    lines_.pop_back();
  }
  double x() const { return x_; }
  double size() const { return size_; }
  void accent(Accent::Kind kind, double from, bool high) {
    const double y = y_ - ((high ? height_of_capitals : height_of_x) + 0.12) * size_;
    // Over the letter that leans to the right.
    label_.accents.push_back({kind, {from + 0.12 * size_, y}, {x_ + 0.02 * size_, y}});
    label_.box.include(Point2{x_, y - 2});
  }
  // The bar of a root over what stands from a place on.
  void root(double from) {
    const double y = y_ - (height_of_capitals + 0.12) * size_;
    label_.accents.push_back({Accent::Kind::bar, {from, y}, {x_, y}});
    label_.box.include(Point2{x_, y - 1});
    x_ += 0.06 * size_;
  }
  bool full() const { return x_ > longest_label; }
  Label take() {
    if (full()) put("…", Face::upright);
    label_.box.include(Point2{x_, 0});
    label_.box.include(Point2{0, 0});
    return std::move(label_);
  }

 private:
  // An index of an index stands lower than it, and is little smaller: it must be read.
  void shift(double part) {
    constexpr double index_of_index = 0.85;
    lines_.push_back({size_, y_, lowered_});
    y_ += part * size_;
    lowered_ = y_ > 0;
    size_ *= lines_.size() > 1 ? index_of_index : index_size;
  }
  struct Line {
    double size, y;
    bool lowered;
  };
  Label label_;
  std::vector<Line> lines_;  // those that are left for an index or a power
  double size_, x_ = 0, y_ = 0;
  bool lowered_ = false;
};

class TexReader {
 public:
  TexReader(std::string_view tex, double size) : tex_(tex), setter_(size) {}

  Label read() {
    while (at_ < tex_.size() && !setter_.full()) item(Face::italic);
    if (setter_.full()) setter_.put("…", Face::upright);
    return setter_.take();
  }

 private:
  std::string_view command() {
    const std::size_t begin = ++at_;
    while (at_ < tex_.size() && std::isalpha(static_cast<unsigned char>(tex_[at_])) != 0) ++at_;
    if (at_ == begin && at_ < tex_.size()) ++at_;
    return tex_.substr(begin, at_ - begin);
  }

  // A group in braces, or the next item alone.
  void group(Face face) {
    while (at_ < tex_.size() && tex_[at_] == ' ') ++at_;
    if (at_ >= tex_.size()) return;
    if (tex_[at_] != '{') return item(face);
    if (depth_ == deepest) {
      at_ = tex_.size();
      return;
    }
    ++depth_;
    ++at_;
    while (at_ < tex_.size() && tex_[at_] != '}' && !setter_.full()) item(face);
    if (at_ < tex_.size()) ++at_;
    --depth_;
  }

  void index(Face face, bool low) {
    constexpr int smallest = 2;
    if (small_ == smallest) return group(face);
    ++small_;
    low ? setter_.lower() : setter_.raise();
    group(face);
    setter_.restore();
    --small_;
  }

  void accented(Accent::Kind kind, Face face) {
    const double from = setter_.x();
    const std::size_t begin = at_;
    group(face);
    bool high = false;
    for (std::size_t i = begin; i < at_; ++i)
      high = high || std::isupper(static_cast<unsigned char>(tex_[i])) != 0 || tex_[i] == 'd' || tex_[i] == 'b';
    // The names of commands do not count: only what follows them.
    if (const std::size_t brace = tex_.find_last_of('{', at_ - 1); brace != std::string_view::npos && brace >= begin) {
      high = false;
      for (std::size_t i = brace; i < at_; ++i) high = high || std::isupper(static_cast<unsigned char>(tex_[i])) != 0;
    }
    setter_.accent(kind, from, high);
  }

  void item(Face face) {
    const char c = tex_[at_];
    if (c == '\\') return take_command(command(), face);
    if (c == '{') return group(face);
    if (c == '_' || c == '^') {
      ++at_;
      return index(face, c == '_');
    }
    if (c == ' ' || c == '}' || c == '~' || c == '&') {
      ++at_;
      if (face == Face::upright && c == ' ') setter_.put(" ", face);
      return;
    }
    const std::size_t length = length_of_letter(tex_, at_);
    const bool sloped = is_letter(c) || face == Face::bold;
    setter_.put(c == '-' ? std::string_view("−") : tex_.substr(at_, length), sloped ? face : Face::upright);
    at_ += length;
  }

  void take_command(std::string_view name, Face face) {
    if (name == "mathbf" || name == "vec") return group(Face::bold);
    if (name == "boldsymbol" || name == "bm") return group(Face::bold_italic);
    if (name == "mathrm" || name == "text" || name == "operatorname" || name == "textrm") return group(Face::upright);
    if (name == "mathit") return group(Face::italic);
    if (name == "bar" || name == "overline") return accented(Accent::Kind::bar, face);
    if (name == "dot") return accented(Accent::Kind::dot, face);
    if (name == "ddot") return accented(Accent::Kind::two_dots, face);
    if (name == "," || name == ";" || name == ":" || name == " " || name == "quad") return setter_.gap(0.17);
    if (name == "!" || name == "left" || name == "right") return;
    if (name == "Delta" && face == Face::italic) face = Face::upright;
    for (const auto& [word, letter] : letters_of_tex)
      if (word == name) return setter_.put(letter, face);
    setter_.put(name, Face::upright);
  }

  std::string_view tex_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int small_ = 0;  // of what an index or a power stands at
  Setter setter_;
};

bool is_of_name(char c) {
  return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\'';
}

// A name as people read it: phidot1' is the rate of phi with the index 1 and a prime.
struct NameParts {
  std::string_view stem, rate;  // rate: "dot", "ddot" or nothing
  std::string index;
  std::string_view primes;
};

bool is_greek(std::string_view word) {
  return word.size() > 1 && std::isalpha(static_cast<unsigned char>(word[0])) != 0 &&
         std::ranges::any_of(letters_of_tex, [&](const Word& letter) {
           return letter.first == word && word != "cdot" && word != "times" && word != "circ" && word != "prime" &&
                  word != "sum";
         });
}
std::string greek_or(std::string_view word) {
  if (is_greek(word))
    for (const auto& [name, letter] : letters_of_tex)
      if (name == word) return std::string(letter);
  return std::string(word);
}

NameParts parts_of(std::string_view name) {
  NameParts parts;
  std::size_t end = name.size();
  while (end > 0 && name[end - 1] == '\'') --end;
  parts.primes = name.substr(end);
  std::string_view rest = name.substr(0, end);
  std::string_view low;
  if (const std::size_t bar = rest.find('_'); bar != std::string_view::npos && bar > 0 && bar + 1 < rest.size()) {
    low = rest.substr(bar + 1);
    rest = rest.substr(0, bar);
  }
  std::size_t digits = rest.size();
  while (digits > 1 && std::isdigit(static_cast<unsigned char>(rest[digits - 1])) != 0) --digits;
  parts.index = std::string(rest.substr(digits)) + std::string(low);
  rest = rest.substr(0, digits);
  for (const std::string_view rate : {std::string_view("ddot"), std::string_view("dot")})
    if (rest.size() > rate.size() && rest.ends_with(rate)) {
      const std::string_view stem = rest.substr(0, rest.size() - rate.size());
      // "robot" is no rate: what is left is a letter, Latin or Greek.
      if (stem.size() != 1 && !is_greek(stem)) continue;
      parts.rate = rate;
      rest = stem;
      break;
    }
  parts.stem = rest;
  return parts;
}

// Whether it rises above small letters without a stroke upward.
bool is_tall(std::string_view stem) {
  constexpr std::string_view tall_letters = "bdfhklt";
  if (is_greek(stem))
    return std::isupper(static_cast<unsigned char>(stem[0])) != 0 || stem == "theta" || stem == "beta";
  return stem.size() == 1 && (std::isupper(static_cast<unsigned char>(stem[0])) != 0 ||
                              tall_letters.find(stem[0]) != std::string_view::npos);
}

void put_name(Setter& setter, std::string_view name) {
  const NameParts parts = parts_of(name);
  const double from = setter.x();
  const std::string stem = greek_or(parts.stem);
  for (std::size_t i = 0; i < stem.size();) {
    const std::size_t length = length_of_letter(stem, i);
    setter.put(std::string_view(stem).substr(i, length), is_letter(stem[i]) ? Face::italic : Face::upright);
    i += length;
  }
  if (!parts.rate.empty())
    setter.accent(parts.rate == "dot" ? Accent::Kind::dot : Accent::Kind::two_dots, from, is_tall(parts.stem));
  if (!parts.index.empty()) {
    setter.lower();
    for (std::size_t i = 0; i < parts.index.size() && !setter.full();) {
      const std::size_t length = length_of_letter(parts.index, i);
      setter.put(std::string_view(parts.index).substr(i, length),
                 is_letter(parts.index[i]) ? Face::italic : Face::upright);
      i += length;
    }
    setter.restore();
  }
  for (std::size_t i = 0; i < parts.primes.size(); ++i) setter.put("′", Face::upright);
}

// A character that is of no name, with a minus for a hyphen. Returns how many bytes it has.
std::size_t put_sign(Setter& setter, std::string_view text, std::size_t at) {
  const std::size_t length = length_of_letter(text, at);
  setter.put(text[at] == '-' ? "−" : text.substr(at, length), Face::upright);
  return length;
}

}  // namespace

std::string clean(std::string_view text) { return printable(text); }

Label tex_label(std::string_view tex, double size) {
  const std::string text = clean(tex.substr(0, longest_tex));
  return TexReader(text, size).read();
}

Label name_label(std::string_view name, double size) {
  const std::string text = clean(name);
  Setter setter(size);
  for (std::size_t i = 0; i < text.size() && !setter.full();) {
    std::size_t end = i;
    while (end < text.size() && is_of_name(text[end])) ++end;
    if (end > i && is_letter(text[i])) {
      put_name(setter, std::string_view(text).substr(i, end - i));
      i = end;
    } else {
      i += put_sign(setter, text, i);
    }
  }
  return setter.take();
}

std::string with_greek_letters(std::string_view name) {
  const NameParts parts = parts_of(name);
  return parts.rate.empty() ? greek_or(parts.stem) + parts.index : std::string(name);
}

Label words_label(std::string_view words, double size) {
  const std::string text = clean(words);
  Setter setter(size);
  const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  constexpr std::string_view minus = "−";
  for (std::size_t i = 0; i < text.size() && !setter.full();) {
    const bool below_zero = std::string_view(text).substr(i + 1).starts_with(minus);
    if (text[i] == '^' && is_digit(i + 1 + (below_zero ? minus.size() : 0))) {
      // A power of ten.
      setter.raise();
      if (below_zero) setter.put(minus, Face::upright);
      for (i += 1 + (below_zero ? minus.size() : 0); is_digit(i); ++i)
        setter.put(std::string_view(text).substr(i, 1), Face::upright);
      setter.restore();
      continue;
    }
    const std::size_t length = length_of_letter(text, i);
    setter.put(std::string_view(text).substr(i, length), Face::upright);
    i += length;
  }
  return setter.take();
}

namespace {

// Where the bracket that opens at a place is closed; npos if it is not.
std::size_t end_of_brackets(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i;
  }
  return std::string_view::npos;
}

void put_formula(Setter& setter, std::string_view text, int depth = 0) {
  for (std::size_t i = 0; i < text.size() && !setter.full();) {
    std::size_t end = i;
    while (end < text.size() && is_of_name(text[end])) ++end;
    const std::string_view word = std::string_view(text).substr(i, end - i);
    if (end > i && is_letter(text[i])) {
      const std::size_t close =
          word == "sqrt" && end < text.size() && depth < deepest ? end_of_brackets(text, end) : std::string_view::npos;
      if (close != std::string_view::npos && text[end] == '(') {
        // A root has a bar over what is in its brackets.
        setter.put("√", Face::upright);
        const double from = setter.x();
        put_formula(setter, text.substr(end + 1, close - end - 1), depth + 1);
        setter.root(from);
        i = close + 1;
        continue;
      }
      if (end < text.size() && text[end] == '(')
        setter.put(word, Face::upright);
      else
        put_name(setter, word);
      i = end;
    } else if (text[i] == '*') {
      setter.gap(0.12);
      ++i;
    } else if (text[i] == '^' && i + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0) {
      end = ++i;
      while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
      setter.raise();
      setter.put(std::string_view(text).substr(i, end - i), Face::upright);
      setter.restore();
      i = end;
    } else {
      i += put_sign(setter, text, i);
    }
  }
}

}  // namespace

Label formula_label(std::string_view formula, double size) {
  const std::string text = clean(formula);
  Setter setter(size);
  put_formula(setter, text);
  return setter.take();
}

Label joined(Label first, const Label& second, double gap) {
  const Point2 by{first.box.right + gap, 0};
  for (Run run : second.runs) {
    run.offset = run.offset + by;
    first.runs.push_back(std::move(run));
  }
  for (const Accent& accent : second.accents) first.accents.push_back({accent.kind, accent.from + by, accent.to + by});
  first.box.include(second.box.moved(by));
  return first;
}

}  // namespace poinsot::pictures
