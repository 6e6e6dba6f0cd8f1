// Writes expressions as text, and compares two of them.
#include <algorithm>
#include <cstdio>
#include <type_traits>

#include "problem/language/expression.h"

namespace poinsot::problem {
namespace {

// How tightly each form of an expression binds, in the order of the grammar in expression.h.
enum Tightness {
  range_level,
  comparison_level,
  sum_level,
  product_level,
  signed_level,
  power_level,
  stamped_level,
  riding_level,
  directed_level,
  postfix_level,
  primary_level
};

bool is_fraction(const Number& number) {
  const std::string_view text = number.text;
  return text.substr(0, text.find(' ')).find('/') != std::string_view::npos;
}

bool is_number_with_unit(const Expression& e) {
  const Number* number = e.as<Number>();
  return number && number->has_unit;
}

// Whether the text may end in a unit, so that a blank is needed before what follows.
bool ends_in_unit(const std::string& text) {
  const std::size_t blank = text.find_last_of(' ');
  if (blank == std::string::npos) return false;
  const bool bracket = text.back() == ')' || text.back() == ']';
  return !bracket || text.find("^(", blank) != std::string::npos;
}

// Whether the text begins with a number that has a unit.
bool begins_with_quantity(const std::string& text) {
  return ((text[0] >= '0' && text[0] <= '9') || text[0] == '.') && text.find(' ') != std::string::npos;
}

// frequencies(disk)[2]
bool is_element(const Call& call) { return call.function == "element" && call.pattern() == "at"; }

class Writer {
 public:
  // The text of an expression, in parentheses if it binds less tightly than `least`.
  std::string text(const Expression& e, Tightness least) const {
    std::string plain = std::visit(*this, e->content);
    return tightness(e) >= least ? plain : "(" + plain + ")";
  }

  std::string operator()(const Number& number) const { return number.text; }
  std::string operator()(const Name& name) const {
    return name.name + std::string(static_cast<std::size_t>(name.primes), '\'');
  }
  std::string operator()(const Member& member) const {
    return guarded(member.object, postfix_level) + "." + member.name;
  }
  std::string operator()(const Arrow& arrow) const {
    return guarded(arrow.from, postfix_level) + "->" + guarded(arrow.to, postfix_level);
  }
  std::string operator()(const Of& of) const {
    return guarded(of.point, postfix_level) + " of " + guarded(of.body, postfix_level);
  }
  std::string operator()(const Call& call) const {
    if (is_element(call))
      return guarded(call.arguments[0].value, postfix_level) + "[" + text(call.arguments[1].value, sum_level) + "]";
    std::string inside;
    for (const Argument& argument : call.arguments) {
      if (!inside.empty()) inside += " " + argument.preposition + " ";
      inside += text(argument.value, range_level);
    }
    return call.function + "(" + inside + ")";
  }
  std::string operator()(const Unary& unary) const { return unary.sign + text(unary.operand, signed_level); }
  std::string operator()(const Binary& binary) const {
    const bool sum = binary.operation == '+' || binary.operation == '-';
    if (binary.operation == '^') {
      const std::string base = guarded(binary.left, stamped_level);
      return (ends_in_unit(base) ? "(" + base + ")" : base) + "^" + exponent(binary.right);
    }
    const std::string left = text(binary.left, sum ? sum_level : product_level);
    const std::string right = text(binary.right, sum ? product_level : signed_level);
    // Blanks are needed after a unit, which would take a sign or letter that touches it, and in a quotient before a
    // number with a unit, which would be read as one literal.
    const bool apart = sum || ends_in_unit(left) || (binary.operation == '/' && begins_with_quantity(right));
    const std::string sign(1, binary.operation);
    return left + (apart ? " " + sign + " " : sign) + right;
  }
  std::string operator()(const Comparison& comparison) const {
    std::string chain = text(comparison.operands[0], sum_level);
    for (std::size_t i = 0; i < comparison.relations.size(); ++i) {
      chain += " " + std::string(symbol(comparison.relations[i])) + " " + text(comparison.operands[i + 1], sum_level);
    }
    return chain;
  }
  std::string operator()(const At& at) const {
    const bool number = at.expression.as<Number>() != nullptr;
    return (number ? "(" + text(at.expression, range_level) + ")" : text(at.expression, riding_level)) + " @ " +
           at.instant;
  }
  std::string operator()(const List& list) const {
    std::string inside;
    for (const Expression& item : list.items) inside += (inside.empty() ? "" : ", ") + text(item, range_level);
    return "[" + inside + "]";
  }
  std::string operator()(const Range& range) const {
    return text(range.from, comparison_level) + " .. " + text(range.to, comparison_level) + " by " +
           text(range.step, comparison_level);
  }

 private:
  static Tightness tightness(const Expression& e) {
    struct Visitor {
      Tightness operator()(const Number& number) const { return is_fraction(number) ? product_level : primary_level; }
      Tightness operator()(const Name&) const { return primary_level; }
      Tightness operator()(const Member&) const { return postfix_level; }
      Tightness operator()(const Arrow&) const { return directed_level; }
      Tightness operator()(const Of&) const { return riding_level; }
      Tightness operator()(const Call&) const { return primary_level; }
      Tightness operator()(const Unary&) const { return signed_level; }
      Tightness operator()(const Binary& binary) const {
        return binary.operation == '^'                              ? power_level
               : binary.operation == '*' || binary.operation == '/' ? product_level
                                                                    : sum_level;
      }
      Tightness operator()(const Comparison&) const { return comparison_level; }
      Tightness operator()(const At&) const { return stamped_level; }
      Tightness operator()(const List&) const { return primary_level; }
      Tightness operator()(const Range&) const { return range_level; }
    };
    return std::visit(Visitor{}, e->content);
  }

  // A number stands in parentheses as the operand of a tight operator, since its unit would take the operator.
  std::string guarded(const Expression& e, Tightness least) const {
    return e.as<Number>() && (least != stamped_level || is_number_with_unit(e)) ? "(" + text(e, range_level) + ")"
                                                                                : text(e, least);
  }
  std::string exponent(const Expression& e) const {
    return is_number_with_unit(e) ? "(" + text(e, range_level) + ")" : text(e, signed_level);
  }
};

bool same_lists(const std::vector<Expression>& a, const std::vector<Expression>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_tree);
}

struct Same {
  bool operator()(const Number& a, const Number& b) const {
    return a.value == b.value && a.has_unit == b.has_unit && a.unit.text == b.unit.text;
  }
  bool operator()(const Name& a, const Name& b) const { return a.name == b.name && a.primes == b.primes; }
  bool operator()(const Member& a, const Member& b) const { return a.name == b.name && same_tree(a.object, b.object); }
  bool operator()(const Arrow& a, const Arrow& b) const { return same_tree(a.from, b.from) && same_tree(a.to, b.to); }
  bool operator()(const Of& a, const Of& b) const { return same_tree(a.point, b.point) && same_tree(a.body, b.body); }
  bool operator()(const Call& a, const Call& b) const {
    return a.function == b.function && std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(),
                                                  b.arguments.end(), [](const Argument& x, const Argument& y) {
                                                    return x.preposition == y.preposition &&
                                                           same_tree(x.value, y.value);
                                                  });
  }
  bool operator()(const Unary& a, const Unary& b) const { return a.sign == b.sign && same_tree(a.operand, b.operand); }
  bool operator()(const Binary& a, const Binary& b) const {
    return a.operation == b.operation && same_tree(a.left, b.left) && same_tree(a.right, b.right);
  }
  bool operator()(const Comparison& a, const Comparison& b) const {
    return a.relations == b.relations && same_lists(a.operands, b.operands);
  }
  bool operator()(const At& a, const At& b) const {
    return a.instant == b.instant && same_tree(a.expression, b.expression);
  }
  bool operator()(const List& a, const List& b) const { return same_lists(a.items, b.items); }
  bool operator()(const Range& a, const Range& b) const {
    return same_tree(a.from, b.from) && same_tree(a.to, b.to) && same_tree(a.step, b.step);
  }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

}  // namespace

std::string to_string(const Expression& expression) { return expression ? Writer().text(expression, range_level) : ""; }

bool same_tree(const Expression& a, const Expression& b) {
  if (!a || !b) return !a && !b;
  return a.node == b.node || std::visit(Same{}, a->content, b->content);
}

}  // namespace poinsot::problem
