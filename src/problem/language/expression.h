// Expressions of the problem language: `cross(A->B with A->C)`, `(1 rev)/period`, `turn' @ coasting`.
//
//   range       comparison ['..' comparison 'by' comparison]
//   comparison  sum (('<' | '<=' | '>' | '>=' | '==') sum)*
//   sum         product (('+' | '-') product)*
//   product     signed (('*' | '/') signed)*
//   signed      ('+' | '-') signed | power
//   power       stamped ['^' signed]                        2^3^2 = 2^(3^2), -x^2 = -(x^2)
//   stamped     riding ('@' instant)*                       instant = name ('.' name)* | time literal
//   riding      directed ['of' postfix]                     A of plate
//   directed    postfix ['->' postfix]                      A->B
//   postfix     primary ('.' name)*
//   primary     literal | name primes | name '(' arguments ')' | '(' range ')' | '[' range (',' range)* ']'
//   arguments   [range (preposition range)*]                no commas
//   literal     number ['/' number] [blank unit]            5/8 oz/ft, 1/23.93 rev/h; a unit ends at the next blank
//
// Prepositions: about along to with from of on at by, relative to. They are no names. After a number they are no units
// either; `in` after a number is the inch.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/tree.h"
#include "problem/language/units.h"

namespace poinsot::problem {

struct Node;

// An immutable tree, cheap to copy.
struct Expression {
  std::shared_ptr<const Node> node;

  const Node& operator*() const { return *node; }
  const Node* operator->() const { return node.get(); }
  explicit operator bool() const { return node != nullptr; }

  // The node's content if it is of this type, else nullptr: e.as<Name>().
  template <class T>
  const T* as() const;
  Mark mark() const;
};

// For 12.5 lb the value is 12.5 and the unit lb; for 5/8 oz/ft the value is 0.625.
struct Number {
  double value = 0;  // in `unit`
  Unit unit;         // of factor 1 and without dimension if has_unit is false
  bool has_unit = false;
  std::string text;  // the literal as written, one blank before the unit
};

// For turn'' the name is turn and there are 2 primes.
struct Name {
  std::string name;
  int primes = 0;
};

// angular_velocity(figure).x, driven.start
struct Member {
  Expression object;
  std::string name;
};

// A->B
struct Arrow {
  Expression from;
  Expression to;
};

// A of plate
struct Of {
  Expression point;
  Expression body;
};

struct Argument {
  std::string preposition;  // "" for the first, else "about", "relative to", ...
  Expression value;
};

struct Call {
  std::string function;
  std::vector<Argument> arguments;

  // The argument after a preposition ("" for the first), or nullptr if there is none.
  const Expression* argument(std::string_view preposition) const;
  // The prepositions in order: "on about" for couple(J on B about P), "" for one argument or none.
  std::string pattern() const;
};

struct Unary {
  char sign = '-';  // '+' or '-'
  Expression operand;
};

struct Binary {
  char operation = '+';  // + - * / ^
  Expression left;
  Expression right;
};

enum class Relation { less, less_equal, greater, greater_equal, equal };
std::string_view symbol(Relation relation);

// a < b <= c: operands a, b, c and the two relations between them.
struct Comparison {
  std::vector<Expression> operands;
  std::vector<Relation> relations;
};

// X @ instant
struct At {
  Expression expression;
  std::string instant;             // as written: a name, dotted name or time literal "2 s"
  std::vector<std::string> names;  // those between the dots; none for a time literal
  Expression when;                 // the time literal as a number; else the last name, which may be that of a time
  Mark instant_mark;
};

struct List {
  std::vector<Expression> items;
};

// from .. to by step
struct Range {
  Expression from;
  Expression to;
  Expression step;
};

struct Node {
  std::variant<Number, Name, Member, Arrow, Of, Call, Unary, Binary, Comparison, At, List, Range> content;
  Mark mark;       // of an operation the place of its operator, of anything else its beginning
  int height = 1;  // of the tree
};

template <class T>
const T* Expression::as() const {
  return node ? std::get_if<T>(&node->content) : nullptr;
}

struct ExpressionLimits {
  static constexpr int depth = 64;  // how deep parentheses, calls, lists, signs and powers may stand within each other
  static constexpr int height = 256;  // of the tree; this also bounds the number of terms of a sum
};

// Parses the expression of an entry: of a scalar its text, of a list the List of its items' expressions. Throws
// StatementError with the place in the file.
Expression parse_expression(const Entry& entry, const std::string& file);

// Parses the expression of a text that begins at `mark`.
Expression parse_expression(std::string_view text, const std::string& file, Mark mark = {1, 1});

// Writes the expression as text that reads back to the same tree.
std::string to_string(const Expression& expression);

// Where the first letter of the expression stands. (mark() of an operation is the place of its operator.)
Mark beginning(const Expression& expression);

// Whether the expression is the word `any`, which stands for a value that may be any.
bool is_any(const Expression& expression);

// Whether two expressions are equal but for marks and for how numbers are written.
bool same_tree(const Expression& a, const Expression& b);

// All prepositions of the language; "relative to" is one of them.
const std::vector<std::string>& prepositions();
bool is_preposition(std::string_view word);

// Whether the word is a letter or underscore followed by letters, digits and underscores, and no preposition.
bool is_name(std::string_view word);

}  // namespace poinsot::problem
