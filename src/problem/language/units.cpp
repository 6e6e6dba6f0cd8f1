// The grammar of composed units.
#include "problem/language/units.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "problem/language/tree.h"
#include "problem/language/unit_table.h"
#include "problem/language/utf8.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t longest_unit = 100;
constexpr int largest_exponent = 100;  // the same as for dimensions, so that the program can read what it writes

// Whether a character can begin the name of a unit: a letter, % or the underscore.
bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '%' || c == '_'; }

struct ForeignSpelling {
  std::string_view sign;
  std::string_view meaning;
};
// Signs that stand for an operation elsewhere, and how the language writes it.
constexpr ForeignSpelling foreign_signs[] = {{"**", "^"},
                                             {".", "*"},
                                             {"-", "*"},
                                             {"\xc2\xb7", "*"},      // middle dot
                                             {"\xe2\x8b\x85", "*"},  // dot operator
                                             {"\xc3\x97", "*"},      // multiplication sign
                                             {"\xc2\xb2", "^2"},
                                             {"\xc2\xb3", "^3"},
                                             {"\xe2\x81\xbb\xc2\xb9", "^-1"},
                                             {"\xe2\x81\xbb\xc2\xb2", "^-2"}};

const ForeignSpelling* foreign_sign(std::string_view text) {
  for (const ForeignSpelling& sign : foreign_signs) {
    if (text.substr(0, sign.sign.size()) == sign.sign) return &sign;
  }
  return nullptr;
}

std::size_t name_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const bool beyond_ascii = (static_cast<unsigned char>(text[length]) & 0x80) != 0;
    const bool quote = text[length] == '"' || text[length] == '\'';
    if (!begins_name(text[length]) && !quote && (!beyond_ascii || foreign_sign(text.substr(length)))) break;
    length += beyond_ascii ? character_at(text, length).value_or(Character{}).bytes : 1;
  }
  return length;
}

// The text with foreign signs, raised digits and other spellings replaced by the language's own.
std::string in_own_form(std::string_view text) {
  std::string own;
  bool after_name = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t name = name_length(text.substr(i));
    if (name > 0) {
      const std::string_view word = text.substr(i, name);
      const WrongUnit* wrong = find_unit(word) ? nullptr : find_wrong_unit(word);
      if (wrong && wrong->repair.find('\'') == std::string_view::npos) {
        own += wrong->repair;
      } else {
        own += !find_unit(word) && !wrong ? nearest(word, unit_names()) : std::string(word);
      }
      i += name;
    } else if (after_name && is_digit(text[i])) {
      own += '^';
      own += text[i++];
    } else if (const ForeignSpelling* sign = foreign_sign(text.substr(i));
               sign && (sign->sign != "-" || after_name || i == 0)) {
      own += sign->meaning;
      i += sign->sign.size();
    } else {
      const bool exponent_in_product = text[i] == '-';
      own += text[i++];
      if (exponent_in_product && i >= text.size()) break;
    }
    after_name = name > 0;
  }
  return own;
}

class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  Unit read() {
    if (text_.empty()) fail("a unit is missing", "write one such as m, kg*m^2/s or 1/s", 0);
    if (text_.size() > longest_unit)
      fail("this unit is too long", "write at most " + std::to_string(longest_unit) + " letters", 0);
    Unit unit{1, {}, std::string(text_)};
    bool inverse = false;
    while (true) {
      piece(unit, inverse);
      if (at_ >= text_.size()) break;
      const char operation = text_[at_];
      if (operation != '*' && operation != '/') fail_at_sign();
      inverse = operation == '/';
      ++at_;
    }
    // Of 1/s nobody thinks of turns, of 1/min most do.
    for (const std::string_view slow : {"1/min", "1/h", "1/day", "min^-1", "h^-1", "day^-1"})
      if (unit.text == slow)
        fail("'" + unit.text + "' is ambiguous: it may count turns or radians", "write 'rpm', 'rev/h', 'rad/min'", 0);
    if (!reasonable(unit.dimension) || !std::isnormal(unit.factor)) {
      fail("the exponents of this unit are beyond all measure", "use fewer factors", 0);
    }
    return unit;
  }

 private:
  void piece(Unit& unit, bool inverse) {
    const std::size_t begin = at_;
    if (at_ >= text_.size())
      fail("a unit is missing after '" + std::string(1, text_[at_ - 1]) + "'", "complete the unit", at_ - 1);
    if (text_[at_] == '1' && !(at_ + 1 < text_.size() && (is_digit(text_[at_ + 1]) || text_[at_ + 1] == '.'))) {
      ++at_;
      return;
    }
    const std::size_t length = name_length(text_.substr(at_));
    if (length == 0) fail_at_sign();
    const std::string_view name = text_.substr(at_, length);
    const NamedUnit* named = find_unit(name);
    at_ += length;
    if (!named) fail_unknown(name, begin);
    int numerator = 1, denominator = 1;
    if (at_ < text_.size() && text_[at_] == '^') exponent(numerator, denominator);
    if (at_ < text_.size() && is_digit(text_[at_])) {
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      fail("'" + std::string(text_.substr(begin, at_ - begin)) + "' is not a unit", repair(""), begin);
    }
    if (inverse) numerator = -numerator;
    const std::optional<Dimension> dimension = problem::power(named->dimension, numerator, denominator);
    if (!dimension)
      fail("this exponent is not possible for a unit", "exponents go by halves, thirds, quarters, sixths or twelfths",
           begin);
    unit.dimension = unit.dimension * *dimension;
    // Whole powers are formed by multiplication, which is exact where the factors are.
    if (denominator != 1) {
      unit.factor *= std::pow(named->factor, static_cast<double>(numerator) / denominator);
    } else {
      for (int i = 0; i < std::abs(numerator); ++i)
        unit.factor = numerator > 0 ? unit.factor * named->factor : unit.factor / named->factor;
    }
  }

  // Reads an exponent: ^2, ^-1, ^(1/2), ^(-3/2).
  void exponent(int& numerator, int& denominator) {
    const std::size_t begin = at_++;
    const bool bracket = at_ < text_.size() && text_[at_] == '(';
    if (bracket) ++at_;
    const bool negative = at_ < text_.size() && text_[at_] == '-';
    if (negative) ++at_;
    numerator = whole(begin, bracket ? 12 * largest_exponent : largest_exponent);
    if (negative) numerator = -numerator;
    if (!bracket) return;
    if (at_ < text_.size() && text_[at_] == '/') {
      ++at_;
      denominator = whole(begin, 12);
    }
    if (at_ >= text_.size() || text_[at_] != ')') fail_exponent(begin);
    ++at_;
  }

  int whole(std::size_t begin, int largest) {
    int number = 0;
    const std::size_t first = at_;
    while (at_ < text_.size() && is_digit(text_[at_]) && number <= largest) number = 10 * number + (text_[at_++] - '0');
    if (at_ == first || number == 0 || number > largest || (at_ < text_.size() && text_[at_] == '.'))
      fail_exponent(begin);
    return number;
  }

  [[noreturn]] void fail_exponent(std::size_t begin) const {
    fail("an exponent of a unit must be a whole number up to " + std::to_string(largest_exponent) + ", not 0",
         "write it like m^2, s^-1 or m^(1/2)", begin);
  }

  [[noreturn]] void fail_unknown(std::string_view name, std::size_t begin) const {
    const std::string quoted = "'" + std::string(name) + "'";
    if (const WrongUnit* wrong = find_wrong_unit(name)) {
      std::string message =
          wrong->message.empty() ? quoted + " is not how the unit is written" : std::string(wrong->message);
      fail(std::move(message), repair(wrong->repair), begin);
    }
    const std::string near = nearest(name, unit_names());
    fail(quoted + " is not a unit", near.empty() ? "" : "did you mean '" + near + "'?", begin);
  }

  [[noreturn]] void fail_at_sign() const {
    const std::string sign = character_text(text_, at_);
    if (sign == "(") fail("a unit has no parentheses", "kg/(m*s) is written kg/m/s", at_);
    if (sign == "^") fail("an exponent stands without a unit before it", "write it like m^2", at_);
    if (sign == "*" || sign == "/")
      fail("a unit is missing before '" + sign + "'", repair("", "write it like N*m or 1/s"), at_);
    if (is_digit(sign[0])) fail("a number stands within a unit", "put the number before the unit", at_);
    if (sign == " " || sign == "\t") fail("a blank stands within a unit", "write it without blanks, as in N*m", at_);
    fail("'" + sign + "' does not belong into a unit", repair("", "factors are joined by * and /"), at_);
  }

  // A hint "write '...'" with the whole unit in the language's spelling, if that is a unit; otherwise with the repair
  // for the piece that is wrong.
  std::string repair(std::string_view piece, const std::string& otherwise = "") const {
    const std::string whole = in_own_form(text_);
    if (piece.find('\'') == std::string_view::npos && whole != text_ && is_unit(whole)) return "write '" + whole + "'";
    if (piece.find('\'') != std::string_view::npos) return "write " + std::string(piece);
    if (!piece.empty()) return "write '" + std::string(piece) + "'";
    return otherwise.empty() ? "write it like m^2" : otherwise;
  }

  static bool is_unit(const std::string& text) {
    if (text.empty()) return false;
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t name = name_length(std::string_view(text).substr(i));
      if (name > 0 && !find_unit(std::string_view(text).substr(i, name))) return false;
      i += name > 0 ? name : 1;
    }
    try {
      UnitReader(text).read();
      return true;
    } catch (const UnitError&) {
      return false;
    }
  }

  [[noreturn]] static void fail(std::string message, std::string hint, std::size_t offset) {
    throw UnitError(std::move(message), std::move(hint), offset);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

UnitError::UnitError(std::string message_, std::string hint_, std::size_t offset_)
    : std::invalid_argument(hint_.empty() ? message_ : message_ + " (" + hint_ + ")"),
      message(std::move(message_)),
      hint(std::move(hint_)),
      offset(offset_) {}

Unit parse_unit(std::string_view text) { return UnitReader(text).read(); }

Unit parse_unit(const Entry& entry, const std::string& file) {
  if (!entry.is_scalar()) {
    throw StatementError(file, entry.mark, "expected a unit, not " + std::string(in_words(entry.kind)),
                         "write one such as m, kg*m^2/s or rpm");
  }
  try {
    return parse_unit(entry.text);
  } catch (const UnitError& error) {
    throw StatementError(file, entry.place(error.offset), error.message, error.hint);
  }
}

bool is_unit_name(std::string_view name) { return find_unit(name) != nullptr; }

const std::vector<std::string>& unit_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const NamedUnit& unit : unit_table()) all.emplace_back(unit.name);
    return all;
  }();
  return names;
}

std::string wrong_unit_message(std::string_view word) {
  const WrongUnit* wrong = find_wrong_unit(word);
  if (!wrong || find_unit(word)) return "";
  return wrong->message.empty() ? "'" + std::string(word) + "' is not how the unit is written"
                                : std::string(wrong->message);
}

}  // namespace poinsot::problem
