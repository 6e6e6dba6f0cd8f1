// The grammar of expressions, by recursive descent. An element of a list in brackets, frequencies(disk)[2], is the call
// element(frequencies(disk) at 2). Of several @ behind each other, X @ 2 s @ small, one At is made.
#include "problem/language/parser.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "problem/language/expression.h"
#include "problem/language/expression_walk.h"
#include "problem/language/lexer.h"
#include "problem/language/misread.h"
#include "problem/language/token_reader.h"
#include "problem/language/units.h"

namespace poinsot::problem {
namespace {

class Parser {
 public:
  Parser(const ExpressionSource& source, bool list_item)
      : source_(source), list_item_(list_item), tokens_(tokens_of(source)) {}

  Expression run() {
    if (now().kind == Token::Kind::end)
      source_.fail(0, "an expression is missing", "write a number, a name or a formula");
    Expression expression = range();
    if (now().kind != Token::Kind::end) fail_left_over(source_, tokens_, false);
    return expression;
  }

 private:
  const Token& now() const { return tokens_.now(); }

  template <class Content>
  Expression make(Content content, std::size_t offset) {
    if (height_below(content) >= ExpressionLimits::height) {
      source_.fail(offset, "this expression has too many terms in a row",
                   "name parts of it under 'given:' or 'define:' and use the names");
    }
    return built(std::move(content), source_.place(offset));
  }

  // Counts how deep constructs stand within each other. The count goes down again when the object is destroyed.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > ExpressionLimits::depth) {
        parser_.source_.fail(parser_.now().begin,
                             "this expression is nested more than " + std::to_string(ExpressionLimits::depth) + " deep",
                             "name parts of it under 'given:' or 'define:' and use the names");
      }
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  Expression range() {
    Expression from = comparison();
    if (!now().is_sign("..")) return from;
    const std::size_t mark = now().begin;
    tokens_.step();
    Expression to = comparison();
    if (!now().is_preposition("by")) {
      source_.fail(now().begin, "the step of this range is missing", "write it as 0 s .. 2 s by 0.1 s");
    }
    tokens_.step();
    Expression step = comparison();
    return make(Range{from, to, step}, mark);
  }

  Expression comparison() {
    static constexpr std::array<std::pair<std::string_view, Relation>, 5> relations{{{"<", Relation::less},
                                                                                     {"<=", Relation::less_equal},
                                                                                     {">", Relation::greater},
                                                                                     {">=", Relation::greater_equal},
                                                                                     {"==", Relation::equal}}};
    Expression first = sum();
    Comparison chain{{first}, {}};
    std::size_t mark = 0;
    while (now().kind == Token::Kind::sign) {
      const auto found =
          std::find_if(relations.begin(), relations.end(), [&](const auto& r) { return now().text == r.first; });
      if (found == relations.end()) break;
      if (chain.relations.empty()) mark = now().begin;
      tokens_.step();
      chain.relations.push_back(found->second);
      chain.operands.push_back(sum());
    }
    if (chain.relations.empty()) return first;
    return make(std::move(chain), mark);
  }

  Expression sum() {
    Expression left = product();
    while (now().is_sign("+") || now().is_sign("-")) left = binary(std::move(left), [this] { return product(); });
    return left;
  }
  Expression product() {
    Expression left = signed_operand();
    while (now().is_sign("*") || now().is_sign("/"))
      left = binary(std::move(left), [this] { return signed_operand(); });
    return left;
  }
  template <class Operand>
  Expression binary(Expression left, const Operand& operand) {
    const Token& operation = now();
    tokens_.step();
    Expression right = operand();
    return make(Binary{operation.text[0], std::move(left), std::move(right)}, operation.begin);
  }

  Expression signed_operand() {
    if (!now().is_sign("+") && !now().is_sign("-")) return power();
    const Nesting nesting(*this);
    const Token& sign = now();
    tokens_.step();
    Expression operand = signed_operand();
    return make(Unary{sign.text[0], operand}, sign.begin);
  }

  Expression power() {
    Expression base = stamped();
    if (!now().is_sign("^")) return base;
    const Nesting nesting(*this);
    return binary(std::move(base), [this] { return signed_operand(); });
  }

  Expression stamped() {
    const bool literal = now().kind == Token::Kind::literal;
    Expression expression = riding();
    int stamps = 0;
    while (now().is_sign("@")) {
      const std::size_t mark = now().begin;
      if (literal) {
        source_.fail(mark, "'@' stands after a number, which is the same at every instant",
                     "put what is meant into parentheses, (x^2) @ start");
      }
      tokens_.step();
      At at = instant();
      if (const At* inner = stamps++ > 0 ? expression.as<At>() : nullptr)
        join(at, *inner, mark);
      else
        at.expression = expression;
      expression = make(std::move(at), mark);
    }
    return expression;
  }

  // X @ 2 s @ small, X @ lowest @ small: an instant in a situation.
  void join(At& at, const At& inner, std::size_t mark) const {
    const bool outer_time = at.when.as<Number>() != nullptr, inner_time = inner.when.as<Number>() != nullptr;
    if (outer_time && inner_time)
      source_.fail(mark, "two times stand after each other", "one instant is meant: x @ 2 s, x @ 2 s @ situation");
    if (inner.names.size() >= ExpressionLimits::height)
      source_.fail(mark, "this expression has too many terms in a row", "write x @ instant @ situation");
    at.instant = outer_time || inner_time ? inner.instant + " @ " + at.instant : at.instant + "." + inner.instant;
    at.names.insert(at.names.end(), inner.names.begin(), inner.names.end());
    if (!outer_time) at.when = inner.when;
    at.expression = inner.expression;
  }

  // What stands after an @, without the expression before it.
  At instant() {
    At at;
    at.instant_mark = source_.place(now().begin);
    if (now().kind == Token::Kind::literal) {
      const Token& literal = now();
      if (!literal.has_unit || literal.unit.dimension != dimensions::time) {
        source_.fail(literal.begin, "the instant after '@' is no time",
                     "write a name, or a time with its unit: x @ 2 s");
      }
      at.instant = literal.text;
      at.when = primary();
      return at;
    }
    if (now().is_sign("-"))
      source_.fail(now().begin, "the motion begins at 0 s: there is no time before it", "write x @ start, x @ 2 s");
    if (now().kind != Token::Kind::name || now().primes > 0) {
      source_.fail(now().begin, "an instant is missing after '@'", "write its name or a time: x @ start, x @ 2 s");
    }
    at.names = {now().text};
    tokens_.step();
    while (now().is_sign(".") && tokens_.next().kind == Token::Kind::name && tokens_.next().primes == 0) {
      at.names.push_back(tokens_.next().text);
      tokens_.step(2);
    }
    for (const std::string& name : at.names) at.instant += (at.instant.empty() ? "" : ".") + name;
    at.when = built(Name{at.names.back()}, at.instant_mark);
    return at;
  }

  Expression riding() {
    const std::size_t begin = now().begin;
    Expression point = directed();
    if (!now().is_preposition("of")) return point;
    const std::size_t mark = now().begin;
    if (point.as<Number>())
      source_.fail(begin, "a number cannot ride on a body", "before 'of' stands a point, A of plate");
    tokens_.step();
    Expression body = operand_of("of", "A of plate");
    return make(Of{point, body}, mark);
  }

  Expression directed() {
    const std::size_t begin = now().begin;
    Expression from = postfix();
    if (!now().is_sign("->")) return from;
    const std::size_t mark = now().begin;
    if (from.as<Number>()) source_.fail(begin, "an arrow begins at a number", "it goes from point to point, A->B");
    tokens_.step();
    Expression to = operand_of("->", "A->B");
    if (now().is_sign("->")) {
      source_.fail(now().begin, "an arrow follows an arrow",
                   "write two arrows, A->B and B->C, or the one from end to end, A->C");
    }
    if (now().is_preposition("of")) {
      source_.fail(now().begin, "'of' after an arrow can be read in two ways",
                   "put the arrow, or what is meant, into parentheses");
    }
    return make(Arrow{from, to}, mark);
  }

  // Parses what stands after `->` or `of`: a name, a call or something in parentheses.
  Expression operand_of(std::string_view word, const char* example) {
    const Token& token = now();
    if (token.kind == Token::Kind::literal ||
        (token.kind == Token::Kind::sign && !token.is_sign("(") && !token.is_sign("["))) {
      source_.fail(token.begin, "after '" + std::string(word) + "' a name is expected, not " + source_.quoted(token),
                   "write " + std::string(example));
    }
    return postfix();
  }

  Expression postfix() {
    Expression expression = primary();
    while (now().is_sign(".") || now().is_sign("[")) {
      const std::size_t mark = now().begin;
      if (now().is_sign("[")) {
        expression = element_of(std::move(expression));
        continue;
      }
      tokens_.step();
      if (expression.as<Number>()) {
        source_.fail(mark, "a point stands after a number",
                     now().kind == Token::Kind::end ? "units are written without one: 12 in"
                                                    : "components are those of vectors, v.x");
      }
      if (now().kind == Token::Kind::name && now().primes > 0)
        source_.fail(now().begin, "a prime stands behind a component",
                     "write the component of the rate, v'.x, of a name v under define:");
      if (now().kind != Token::Kind::name) {
        source_.fail(now().begin, "a name is missing after '.'", "write a component or part of something, v.x");
      }
      std::string name = now().text;
      tokens_.step();
      expression = make(Member{expression, std::move(name)}, mark);
    }
    return expression;
  }

  Expression element_of(Expression list) {
    const Nesting nesting(*this);
    const Token& opening = now();
    if (list.as<Number>())
      source_.fail(opening.begin, "brackets stand after a number", "elements are those of lists, frequencies(disk)[1]");
    tokens_.step();
    if (now().is_sign("]"))
      source_.fail(now().begin, "the number of the element is missing", "write frequencies(disk)[1]");
    Expression place = sum();
    close(opening, "]", "");
    return make(Call{"element", {{"", std::move(list)}, {"at", std::move(place)}}}, opening.begin);
  }

  Expression primary() {
    const Token& token = now();
    switch (token.kind) {
      case Token::Kind::literal:
        tokens_.step();
        return make(Number{token.value, token.unit, token.has_unit, token.text}, token.begin);
      case Token::Kind::name:
        tokens_.step();
        if (now().is_sign("(") && token.primes == 0) return call(token);
        if (now().is_sign("(")) {
          source_.fail(token.begin, "a call has no primes",
                       "to derive it give it a name under 'define:' and put the primes behind that name");
        }
        return make(Name{token.text, token.primes}, token.begin);
      case Token::Kind::sign:
        if (token.is_sign("(")) return parenthesised();
        if (token.is_sign("[")) return list();
        break;
      case Token::Kind::preposition:
      case Token::Kind::end:
        break;
    }
    fail_missing(source_, tokens_);
  }

  Expression parenthesised() {
    const Nesting nesting(*this);
    const Token& opening = now();
    tokens_.step();
    Expression inside = range();
    close(opening, ")", "");
    return inside;
  }

  Expression list() {
    const Nesting nesting(*this);
    const Token& opening = now();
    tokens_.step();
    List list;
    if (!now().is_sign("]")) {
      do {
        list.items.push_back(range());
      } while (tokens_.accept(","));
    }
    close(opening, "]", "");
    return make(std::move(list), opening.begin);
  }

  Expression call(const Token& name) {
    const Nesting nesting(*this);
    const Token& opening = now();
    tokens_.step();
    Call call{name.text, {}};
    if (!now().is_sign(")")) {
      std::string preposition;
      while (true) {
        call.arguments.push_back({preposition, range()});
        if (now().kind != Token::Kind::preposition) break;
        preposition = now().text;
        if (call.argument(preposition)) {
          source_.fail(now().begin, "'" + preposition + "' stands twice in '" + name.text + "(...)'",
                       "remove one of the two");
        }
        tokens_.step();
      }
    }
    close(opening, ")", name.text);
    return make(std::move(call), name.begin);
  }

  void close(const Token& opening, std::string_view sign, const std::string& function) {
    if (!tokens_.accept(sign)) fail_unclosed(source_, tokens_, {opening, sign, function, list_item_});
  }

  const ExpressionSource& source_;
  bool list_item_;
  TokenReader tokens_;
  int depth_ = 0;
};

}  // namespace

Expression parse_scalar(const Entry& entry, const std::string& file, bool list_item) {
  const ExpressionSource source(entry, file);
  return Parser(source, list_item).run();
}

}  // namespace poinsot::problem
