#include "problem/language/lexer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "problem/language/expression.h"
#include "problem/language/foreign_signs.h"
#include "problem/language/utf8.h"

namespace poinsot::problem {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// Signs for the product of units that the language does not have: the middle dot, the dot operator, the cross.
constexpr std::array<std::string_view, 3> foreign_products{"\xc2\xb7", "\xe2\x8b\x85", "\xc3\x97"};
// Raised digits, which the language does not have either.
constexpr std::array<std::string_view, 2> raised_digits{"\xc2\xb2", "\xc2\xb3"};
// Units whose names are signs and not letters.
constexpr std::array<std::string_view, 5> unit_signs{"%", "\"", "\xc2\xb0", "\xc2\xb5", "\xce\xbc"};

template <std::size_t N>
std::size_t any_of(const std::array<std::string_view, N>& signs, std::string_view text) {
  for (const std::string_view sign : signs) {
    if (text.substr(0, sign.size()) == sign) return sign.size();
  }
  return 0;
}

class Lexer {
 public:
  explicit Lexer(const ExpressionSource& source) : source_(source), text_(source.text()) {}

  std::vector<Token> run() {
    while (true) {
      skip_blanks();
      Token token = next();
      token.end = at_;
      tokens_.push_back(std::move(token));
      if (tokens_.back().kind == Token::Kind::end) return std::move(tokens_);
    }
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::string_view rest(std::size_t offset) const { return text_.substr(std::min(offset, text_.size())); }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  Token next() {
    Token token;
    token.begin = at_;
    if (at_ >= text_.size()) return token;
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) return literal();
    if (is_letter(peek())) return name();
    for (const std::string_view sign : {"->", "<=", ">=", "=="}) {
      if (rest(at_).substr(0, 2) == sign) return sign_token(2);
    }
    const ForeignSign foreign = foreign_sign_of_expression(rest(at_));
    if (!foreign.message.empty()) source_.fail(at_, foreign.message, foreign.hint);
    if (rest(at_).substr(0, 2) == "..") return sign_token(2);
    if (peek() == '.' && (tokens_.empty() || tokens_.back().kind == Token::Kind::sign))
      for (const std::string_view word : {"nan", "NaN", "NAN", "inf", "Inf", "INF"})
        if (rest(at_ + 1).substr(0, word_length(at_ + 1)) == word)
          source_.fail(at_, "'." + std::string(word) + "' is no number", "write the value, or 'any' for what is open");
    if (std::string_view("+-*/^()[],.@<>").find(peek()) != std::string_view::npos) return sign_token(1);
    source_.fail(at_, "'" + character_text(text_, at_) + "' is no sign of the language");
  }

  Token sign_token(std::size_t length) {
    Token token;
    token.kind = Token::Kind::sign;
    token.begin = at_;
    token.text = text_.substr(at_, length);
    at_ += length;
    return token;
  }

  std::size_t word_length(std::size_t offset) const {
    std::size_t length = 0;
    while (offset + length < text_.size() && (is_letter(text_[offset + length]) || is_digit(text_[offset + length])))
      ++length;
    return length;
  }

  Token name() {
    Token token;
    token.begin = at_;
    const std::size_t length = word_length(at_);
    token.text = text_.substr(at_, length);
    at_ += length;
    if (token.text == "relative") return relative(std::move(token));
    if (is_preposition(token.text)) {
      token.kind = Token::Kind::preposition;
      return token;
    }
    token.kind = Token::Kind::name;
    while (peek() == '\'') {
      ++token.primes;
      ++at_;
    }
    if (peek() == '"') source_.fail(at_, "'\"' is no sign of the language", "write two primes, " + token.text + "''");
    if (token.primes > 9) source_.fail(token.begin, "'" + token.text + "' has more than 9 primes");
    return token;
  }

  Token relative(Token token) {
    std::size_t to = at_;
    while (to < text_.size() && is_blank(text_[to])) ++to;
    if (rest(to).substr(0, word_length(to)) != "to") {
      source_.fail(token.begin, "'relative' stands without 'to'",
                   "write 'relative to', as in velocity(A relative to car)");
    }
    at_ = to + 2;
    token.kind = Token::Kind::preposition;
    token.text = "relative to";
    return token;
  }

  // Reads a literal: number ['/' number] [blank unit].
  Token literal() {
    Token token;
    token.kind = Token::Kind::literal;
    token.begin = at_;
    token.value = decimal();
    const std::size_t after_number = at_;
    // A fraction belongs to the literal only if a unit follows.
    if (peek() == '/' && (is_digit(peek(1)) || (peek(1) == '.' && is_digit(peek(2))))) {
      ++at_;
      const double divisor = decimal();
      const std::size_t number_end = at_;
      const std::size_t begin = unit_begin(number_end);
      if (begin != std::string_view::npos && is_unit_like(begin)) {
        check_fraction(token.begin);
        if (divisor == 0) source_.fail(after_number, "this fraction has the denominator zero");
        token.value /= divisor;
        read_unit(token, number_end, begin);
        return token;
      }
      at_ = after_number;
    }
    token.text = text_.substr(token.begin, at_ - token.begin);
    refuse_glued(token);
    if (const std::size_t begin = unit_begin(at_); begin != std::string_view::npos) {
      if (is_unit_like(begin)) {
        read_unit(token, at_, begin);
      } else {
        refuse_juxtaposed(token, begin);
      }
    }
    return token;
  }

  // Refuses a fraction with a unit after a quotient or a power: 2/3/4 m and x^3/4 m can be read in two ways.
  void check_fraction(std::size_t begin) const {
    if (tokens_.empty() || !(tokens_.back().is_sign("/") || tokens_.back().is_sign("^"))) return;
    source_.fail(begin, "a fraction with a unit after '" + tokens_.back().text + "' can be read in two ways",
                 "put the fraction and its unit, or what is meant, into parentheses");
  }

  double decimal() {
    const std::size_t begin = at_;
    while (is_digit(peek())) ++at_;
    if (peek() == '.' && is_digit(peek(1))) {
      ++at_;
      while (is_digit(peek())) ++at_;
    }
    if (peek() == '.' && is_digit(peek(1))) source_.fail(at_, "this number has two decimal points");
    if (peek() == '.' && peek(1) != '.' && !is_letter(peek(1))) {
      source_.fail(at_, "digits are missing after the decimal point",
                   "write '" + std::string(text_.substr(begin, at_ - begin)) + ".0'");
    }
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      at_ += 1 + sign;
      while (is_digit(peek())) ++at_;
    }
    double value = 0;
    const auto [end, situation] = std::from_chars(text_.data() + begin, text_.data() + at_, value);
    if (situation != std::errc() || end != text_.data() + at_ || !std::isfinite(value)) {
      source_.fail(begin, "this number is beyond the range of numbers, 1e-308 to 1e308");
    }
    return value;
  }

  // The place behind the blanks after a number at which a unit may begin; npos if there can be none.
  std::size_t unit_begin(std::size_t number_end) const {
    std::size_t begin = number_end;
    while (begin < text_.size() && is_blank(text_[begin])) ++begin;
    if (begin == number_end || begin >= text_.size()) return std::string_view::npos;
    if (any_of(unit_signs, rest(begin)) > 0) return begin;
    if (rest(begin).starts_with("1/") && begin + 2 < text_.size() && is_letter(text_[begin + 2]) &&
        is_unit_like(begin + 2))
      return begin;
    if (!is_letter(text_[begin])) return std::string_view::npos;
    return is_preposition_word(begin) ? std::string_view::npos : begin;
  }

  bool is_preposition_word(std::size_t begin) const {
    const std::string_view word = rest(begin).substr(0, word_length(begin));
    return word == "relative" || is_preposition(word);
  }

  // Whether a word is meant as a unit: one of the table, a common wrong word for one, or either of these followed by
  // digits.
  bool is_unit_like(std::size_t begin) const {
    if (!is_letter(text_[begin])) return true;
    std::size_t length = word_length(begin);
    const char after = begin + length < text_.size() ? text_[begin + length] : '\0';
    if (after == '\'' || after == '(') return false;
    const auto known = [&](std::string_view word) { return is_unit_name(word) || !wrong_unit_message(word).empty(); };
    if (known(rest(begin).substr(0, length))) return true;
    while (length > 0 && is_digit(text_[begin + length - 1])) --length;
    return known(rest(begin).substr(0, length));
  }

  // Finds the end of a unit. Its factors are joined without blanks; signs that are wrong in a unit are included, so
  // that the grammar of units can refuse them. A word that can be no unit ends it: in 40 mm*cos(b) and 3 m-r the sign
  // is an operator.
  std::size_t unit_end(std::size_t begin) const {
    std::size_t end = begin;
    const auto piece = [&](std::size_t from) -> std::size_t {
      std::size_t to = from;
      while (const std::size_t sign = any_of(unit_signs, rest(to))) to += sign;
      to += word_length(to);
      return to;
    };
    const auto begins_piece = [&](std::size_t from) {
      return from < text_.size() && (is_letter(text_[from]) || text_[from] == '%');
    };
    const auto begins_factor = [&](std::size_t from) { return begins_piece(from) && is_unit_like(from); };
    end = text_[begin] == '1' ? begin + 1 : piece(begin);
    while (end < text_.size()) {
      if (const std::size_t raised = any_of(raised_digits, rest(end))) {
        end += raised;
      } else if (text_[end] == '^') {
        end = exponent_end(end + 1);
      } else if (rest(end).substr(0, 2) == "**" && end + 2 < text_.size() && is_digit(text_[end + 2])) {
        end += 3;
      } else if (const std::size_t dot = any_of(foreign_products, rest(end)); dot > 0 && begins_piece(end + dot)) {
        end = piece(end + dot);
      } else if ((text_[end] == '.' && begins_piece(end + 1)) ||
                 ((text_[end] == '*' || text_[end] == '/') && begins_factor(end + 1))) {
        end = piece(end + 1);
      } else if (text_[end] == '-' && begins_factor(end + 1)) {
        refuse_hyphen(begin, end, piece(end + 1));
      } else if ((text_[end] == '*' || text_[end] == '/') && end + 1 < text_.size() && text_[end + 1] == '(') {
        refuse_parenthesised_unit(end);
        break;
      } else {
        break;
      }
    }
    return end;
  }

  std::size_t exponent_end(std::size_t end) const {
    if (end < text_.size() && text_[end] == '(') {
      const std::size_t close = text_.find(')', end);
      return close == std::string_view::npos ? text_.size() : close + 1;
    }
    if (end < text_.size() && text_[end] == '-') ++end;
    end += word_length(end);
    if (end + 1 < text_.size() && text_[end] == '.' && is_digit(text_[end + 1])) end += 1 + word_length(end + 1);
    return end;
  }

  [[noreturn]] void refuse_hyphen(std::size_t begin, std::size_t hyphen, std::size_t end) const {
    const std::string unit(text_.substr(begin, end - begin));
    std::string repair;
    try {
      parse_unit(unit);
    } catch (const UnitError& error) {
      if (error.hint.substr(0, 5) == "write") repair = error.hint + " for the unit; ";
    }
    source_.fail(hyphen, "it is not clear whether '-' belongs to the unit '" + unit + "' or subtracts",
                 repair + "to subtract, put blanks around the '-'");
  }

  // Refuses a unit with parentheses, such as kg/(m*s), and says what to write.
  void refuse_parenthesised_unit(std::size_t sign) const {
    const std::size_t close = text_.find(')', sign);
    if (close == std::string_view::npos) return;
    const std::string_view inside = text_.substr(sign + 2, close - sign - 2);
    try {
      parse_unit(inside);
    } catch (const UnitError&) {
      return;
    }
    source_.fail(sign + 1, "a unit has no parentheses",
                 "kg/(m*s) is written kg/m/s; if '" + std::string(inside) + "' is a name, put blanks around the '" +
                     text_[sign] + "'");
  }

  void read_unit(Token& token, std::size_t number_end, std::size_t begin) {
    const std::size_t end = unit_end(begin);
    const std::string_view unit = text_.substr(begin, end - begin);
    try {
      token.unit = parse_unit(unit);
    } catch (const UnitError& error) {
      std::string hint = error.hint;
      const bool factor = error.offset > 0 && (unit[error.offset - 1] == '*' || unit[error.offset - 1] == '/');
      const bool tells_writing = hint.starts_with("write"),
                 word = error.offset < unit.size() && is_letter(unit[error.offset]);
      if (factor && (word || !tells_writing)) {
        if (!hint.empty()) hint += tells_writing ? ", or, " : " ";
        hint += std::string("if it is a name, put blanks around the '") + unit[error.offset - 1] + "'";
      }
      source_.fail(begin + error.offset, error.message, hint);
    }
    // Moments of inertia, energies and their products have to remain numbers.
    if (token.value > 1e100 || (token.value > 0 && token.value < 1e-100))
      source_.fail(token.begin, "this number is beyond what can be reckoned with, 1e-100 to 1e100");
    token.has_unit = true;
    token.text = std::string(text_.substr(token.begin, number_end - token.begin)) + " " + token.unit.text;
    at_ = end;
  }

  // Refuses a unit that touches its number: 5kg, 5%, 6', 5°.
  void refuse_glued(const Token& token) const {
    const std::size_t sign = any_of(unit_signs, rest(at_));
    if (peek() == '\'') source_.fail(at_, "a prime stands after a number", "feet are written '" + token.text + " ft'");
    if (!is_letter(peek()) && sign == 0) return;
    const bool unit = sign > 0 || is_unit_like(at_);
    const std::size_t length = sign > 0 ? sign + word_length(at_ + sign) : word_length(at_);
    std::string word(text_.substr(at_, length));
    if (!unit) {
      source_.fail(at_, "an operator is missing between '" + token.text + "' and '" + word + "'",
                   "write '" + token.text + "*" + word + "' to multiply; a unit stands after a blank");
    }
    word = text_.substr(at_, std::max(unit_end(at_), at_ + length) - at_);
    std::string hint = "write '" + token.text + " " + word + "'";
    try {
      parse_unit(word);
    } catch (const UnitError& error) {
      hint = "a blank belongs between number and unit; " + error.hint;
    }
    source_.fail(at_, "a blank is missing between the number and its unit '" + word + "'", hint);
  }

  [[noreturn]] void refuse_juxtaposed(const Token& token, std::size_t begin) const {
    std::size_t length = word_length(begin);
    const std::string word(rest(begin).substr(0, length));
    while (begin + length < text_.size() && text_[begin + length] == '\'') ++length;
    const std::string whole(rest(begin).substr(0, length));
    const bool call = begin + length < text_.size() && text_[begin + length] == '(';
    std::string hint = "write '" + token.text + "*" + whole + (call ? "(...)" : "") + "' to multiply";
    const std::string near = call ? "" : nearest(word, unit_names());
    if (!near.empty()) hint += "; did you mean the unit '" + near + "'?";
    if (is_unit_name(word))
      source_.fail(begin, "an operator is missing between '" + token.text + "' and '" + whole + "'", hint);
    source_.fail(begin, "'" + word + "' is not a unit", hint);
  }

  const ExpressionSource& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(const ExpressionSource& source) { return Lexer(source).run(); }

}  // namespace poinsot::problem
