// The grammar of expressions, by recursive descent.
#include "problem/language/parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include "problem/language/expression.h"
#include "problem/language/lexer.h"
#include "problem/language/units.h"

namespace poinsot::problem {
namespace {

struct CallForm {
  std::string_view function;
  std::string_view form;
};
// How functions of several arguments are written. This is shown to an author who separates them by commas.
constexpr std::array call_forms{
    CallForm{"cross", "cross(u with v)"},
    CallForm{"dot", "dot(u with v)"},
    CallForm{"atan2", "atan2(y to x)"},
    CallForm{"angle", "angle(u to v)"},
    CallForm{"acute_angle", "acute_angle(u to v)"},
    CallForm{"component", "component(v along u)"},
    CallForm{"min", "min(a with b)"},
    CallForm{"max", "max(a with b)"},
    CallForm{"distance", "distance(P to Q)"},
    CallForm{"velocity", "velocity(A of plate relative to car)"},
    CallForm{"acceleration", "acceleration(A of plate relative to car)"},
    CallForm{"angular_velocity", "angular_velocity(disk relative to car)"},
    CallForm{"angular_acceleration", "angular_acceleration(disk relative to car)"},
    CallForm{"angular_momentum", "angular_momentum(disk about G)"},
    CallForm{"kinetic_energy", "kinetic_energy(disk about G)"},
    CallForm{"moment_of_inertia", "moment_of_inertia(disk about A->B)"},
    CallForm{"force", "force(J on disk)"},
    CallForm{"impulse", "impulse(J on disk)"},
    CallForm{"couple", "couple(J on disk about P)"},
    CallForm{"moment", "moment(J on disk about P)"},
    CallForm{"spin_rate", "spin_rate(disk about y)"},
};

int height_of(const Expression& e) { return e ? e->height : 0; }

class Parser {
 public:
  Parser(const ExpressionSource& source, bool list_item)
      : source_(source), list_item_(list_item), tokens_(tokens_of(source)) {}

  Expression run() {
    if (now().kind == Token::Kind::end)
      source_.fail(0, "an expression is missing", "write a number, a name or a formula");
    Expression expression = range();
    if (now().kind != Token::Kind::end) fail_left_over(false);
    return expression;
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  const Token& before() const { return tokens_[at_ == 0 ? 0 : at_ - 1]; }
  bool accept(std::string_view sign) {
    if (!now().is_sign(sign)) return false;
    ++at_;
    return true;
  }
  std::string quoted(const Token& token) const {
    return "'" + std::string(source_.text().substr(token.begin, token.end - token.begin)) + "'";
  }

  template <class Content>
  Expression make(Content content, std::size_t offset, std::initializer_list<const Expression*> children = {}) {
    int height = 0;
    for (const Expression* child : children) height = std::max(height, height_of(*child));
    return made(std::move(content), offset, height);
  }
  template <class Content>
  Expression made(Content content, std::size_t offset, int height_below) {
    if (height_below >= ExpressionLimits::height) {
      source_.fail(offset, "this expression has too many terms in a row",
                   "name parts of it under 'given:' or 'define:' and use the names");
    }
    return {std::make_shared<const Node>(Node{std::move(content), source_.place(offset), height_below + 1})};
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
    ++at_;
    Expression to = comparison();
    if (!now().is_preposition("by")) {
      source_.fail(now().begin, "the step of this range is missing", "write it as 0 s .. 2 s by 0.1 s");
    }
    ++at_;
    Expression step = comparison();
    return make(Range{from, to, step}, mark, {&from, &to, &step});
  }

  Expression comparison() {
    static constexpr std::array<std::pair<std::string_view, Relation>, 5> relations{{{"<", Relation::less},
                                                                                     {"<=", Relation::less_equal},
                                                                                     {">", Relation::greater},
                                                                                     {">=", Relation::greater_equal},
                                                                                     {"==", Relation::equal}}};
    Expression first = sum();
    Comparison chain{{first}, {}};
    int height = height_of(first);
    std::size_t mark = 0;
    while (now().kind == Token::Kind::sign) {
      const auto found =
          std::find_if(relations.begin(), relations.end(), [&](const auto& r) { return now().text == r.first; });
      if (found == relations.end()) break;
      if (chain.relations.empty()) mark = now().begin;
      ++at_;
      chain.relations.push_back(found->second);
      chain.operands.push_back(sum());
      height = std::max(height, height_of(chain.operands.back()));
    }
    if (chain.relations.empty()) return first;
    return made(std::move(chain), mark, height);
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
    ++at_;
    Expression right = operand();
    return make(Binary{operation.text[0], left, right}, operation.begin, {&left, &right});
  }

  Expression signed_operand() {
    if (!now().is_sign("+") && !now().is_sign("-")) return power();
    const Nesting nesting(*this);
    const Token& sign = now();
    ++at_;
    Expression operand = signed_operand();
    return make(Unary{sign.text[0], operand}, sign.begin, {&operand});
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
    while (now().is_sign("@")) {
      const std::size_t mark = now().begin;
      if (literal) {
        source_.fail(mark, "'@' stands after a number, which is the same at every instant",
                     "put what is meant into parentheses, (x^2) @ start");
      }
      ++at_;
      const std::size_t instant_mark = now().begin;
      std::string name = instant();
      expression = make(At{expression, std::move(name), source_.place(instant_mark)}, mark, {&expression});
    }
    return expression;
  }

  std::string instant() {
    if (now().kind == Token::Kind::literal) {
      const Token& literal = now();
      if (!literal.has_unit || literal.unit.dimension != dimensions::time) {
        source_.fail(literal.begin, "the instant after '@' is no time",
                     "write a name, or a time with its unit: x @ 2 s");
      }
      ++at_;
      return literal.text;
    }
    if (now().is_sign("-"))
      source_.fail(now().begin, "the motion begins at 0 s: there is no time before it", "write x @ start, x @ 2 s");
    if (now().kind != Token::Kind::name || now().primes > 0) {
      source_.fail(now().begin, "an instant is missing after '@'", "write its name or a time: x @ start, x @ 2 s");
    }
    std::string name = now().text;
    ++at_;
    while (now().is_sign(".") && tokens_[at_ + 1].kind == Token::Kind::name && tokens_[at_ + 1].primes == 0) {
      name += '.' + tokens_[at_ + 1].text;
      at_ += 2;
    }
    return name;
  }

  Expression riding() {
    const std::size_t begin = now().begin;
    Expression point = directed();
    if (!now().is_preposition("of")) return point;
    const std::size_t mark = now().begin;
    if (point.as<Number>())
      source_.fail(begin, "a number cannot ride on a body", "before 'of' stands a point, A of plate");
    ++at_;
    Expression body = operand_of("of", "A of plate");
    return make(Of{point, body}, mark, {&point, &body});
  }

  Expression directed() {
    const std::size_t begin = now().begin;
    Expression from = postfix();
    if (!now().is_sign("->")) return from;
    const std::size_t mark = now().begin;
    if (from.as<Number>()) source_.fail(begin, "an arrow begins at a number", "it goes from point to point, A->B");
    ++at_;
    Expression to = operand_of("->", "A->B");
    if (now().is_sign("->")) {
      source_.fail(now().begin, "an arrow follows an arrow",
                   "write two arrows, A->B and B->C, or the one from end to end, A->C");
    }
    if (now().is_preposition("of")) {
      source_.fail(now().begin, "'of' after an arrow can be read in two ways",
                   "put the arrow, or what is meant, into parentheses");
    }
    return make(Arrow{from, to}, mark, {&from, &to});
  }

  // Parses what stands after `->` or `of`: a name, a call or something in parentheses.
  Expression operand_of(std::string_view word, const char* example) {
    const Token& token = now();
    if (token.kind == Token::Kind::literal ||
        (token.kind == Token::Kind::sign && !token.is_sign("(") && !token.is_sign("["))) {
      source_.fail(token.begin, "after '" + std::string(word) + "' a name is expected, not " + quoted(token),
                   "write " + std::string(example));
    }
    return postfix();
  }

  Expression postfix() {
    Expression expression = primary();
    while (now().is_sign(".")) {
      const std::size_t mark = now().begin;
      ++at_;
      if (expression.as<Number>()) {
        source_.fail(mark, "a point stands after a number", "components are those of vectors, v.x");
      }
      if (now().kind != Token::Kind::name || now().primes > 0) {
        source_.fail(now().begin, "a name is missing after '.'", "write a component or part of something, v.x");
      }
      std::string name = now().text;
      ++at_;
      expression = make(Member{expression, std::move(name)}, mark, {&expression});
    }
    return expression;
  }

  Expression primary() {
    const Token& token = now();
    switch (token.kind) {
      case Token::Kind::literal:
        ++at_;
        return make(Number{token.value, token.unit, token.has_unit, token.text}, token.begin);
      case Token::Kind::name:
        ++at_;
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
    fail_missing();
  }

  Expression parenthesised() {
    const Nesting nesting(*this);
    const Token& opening = now();
    ++at_;
    Expression inside = range();
    close(opening, ")", "");
    return inside;
  }

  Expression list() {
    const Nesting nesting(*this);
    const Token& opening = now();
    ++at_;
    List list;
    int height = 0;
    if (!now().is_sign("]")) {
      do {
        list.items.push_back(range());
        height = std::max(height, height_of(list.items.back()));
      } while (accept(","));
    }
    close(opening, "]", "");
    return made(std::move(list), opening.begin, height);
  }

  Expression call(const Token& name) {
    const Nesting nesting(*this);
    const Token& opening = now();
    ++at_;
    Call call{name.text, {}};
    int height = 0;
    if (!now().is_sign(")")) {
      std::string preposition;
      while (true) {
        call.arguments.push_back({preposition, range()});
        height = std::max(height, height_of(call.arguments.back().value));
        if (now().kind != Token::Kind::preposition) break;
        preposition = now().text;
        if (call.argument(preposition)) {
          source_.fail(now().begin, "'" + preposition + "' stands twice in '" + name.text + "(...)'",
                       "remove one of the two");
        }
        ++at_;
      }
    }
    close(opening, ")", name.text);
    return made(std::move(call), name.begin, height);
  }

  void close(const Token& opening, std::string_view sign, const std::string& function) {
    if (accept(sign)) return;
    if (now().is_sign(",") && !function.empty()) fail_comma_in_call(function);
    if (now().is_sign(",") && opening.is_sign("(")) {
      source_.fail(now().begin, "a comma stands in parentheses", "a vector goes into brackets, [a, b, c]");
    }
    if (now().kind == Token::Kind::end || now().is_sign(")") || now().is_sign("]")) {
      std::string hint = "add '" + std::string(sign) + "'";
      if (list_item_ && opening.is_sign("(")) {
        hint += function.empty() ? "; a comma ends the item of a list"
                                 : "; a comma ends the item of a list, so " + form_of(function, "are joined by words");
      }
      source_.fail(opening.begin, "'" + opening.text + "' is never closed", hint);
    }
    fail_left_over(true);
  }

  static std::string form_of(const std::string& function, const char* otherwise) {
    for (const CallForm& form : call_forms) {
      if (form.function == function) return "write " + std::string(form.form);
    }
    return std::string("arguments ") + otherwise + ", as in cross(u with v)";
  }

  [[noreturn]] void fail_comma_in_call(const std::string& function) const {
    source_.fail(now().begin, "a comma stands between the arguments of '" + function + "'",
                 form_of(function, "are joined by prepositions"));
  }

  // Reports that no expression can begin with the present token.
  [[noreturn]] void fail_missing() const {
    const Token& token = now();
    const std::string after = at_ == 0 ? "" : " after " + quoted(before());
    if (token.kind == Token::Kind::end)
      source_.fail(token.begin, "the expression ends too early: something is missing" + after);
    if (token.is_sign("*") && at_ > 0 && before().is_sign("*")) {
      source_.fail(before().begin, "'**' is no sign of the language", "write a power as x^2");
    }
    if (token.kind == Token::Kind::preposition) {
      source_.fail(token.begin, "something is missing before " + quoted(token),
                   quoted(token) + " is a word of the language and no name");
    }
    source_.fail(token.begin, "something is missing between " + (at_ == 0 ? "the beginning" : quoted(before())) +
                                  " and " + quoted(token));
  }

  // Reports a token that does not continue the expression read before it.
  [[noreturn]] void fail_left_over(bool in_call) const {
    const Token& token = now();
    const std::string here = quoted(token);
    if (token.is_sign(")") || token.is_sign("]")) {
      source_.fail(token.begin, here + " has no opening '" + (token.is_sign(")") ? "(" : "[") + "'",
                   "remove it, or add the opening one");
    }
    if (token.is_sign(",")) {
      source_.fail(token.begin, "a comma stands outside of a list",
                   "a decimal is written with a point, 1.5; a vector goes into brackets, [a, b, c]");
    }
    if (token.kind == Token::Kind::preposition) {
      source_.fail(token.begin, here + " cannot stand here",
                   "it joins the arguments of a call, as in component(v along u)");
    }
    if (token.is_sign(".."))
      source_.fail(token.begin, "a range cannot stand in a range", "write it as 0 s .. 2 s by 0.1 s");
    if (in_call && token.kind == Token::Kind::name) {
      static const std::vector<std::string> joining{"about", "along", "to", "with", "from", "of", "on", "by", "at"};
      if (const std::string hint = did_you_mean(std::string(token.text), joining); !hint.empty())
        source_.fail(token.begin, here + " is no word that joins the arguments of a call", hint);
    }
    const bool simple = before().kind != Token::Kind::sign && token.kind != Token::Kind::sign;
    if (before().kind == Token::Kind::name && token.kind == Token::Kind::name && is_unit_name(token.text))
      source_.fail(token.begin, here + " is a unit, which stands behind a number",
                   "write '" + before().text + " * 1 " + token.text + "'");
    const std::string repair = simple
                                   ? std::string(source_.text().substr(before().begin, before().end - before().begin)) +
                                         "*" + std::string(source_.text().substr(token.begin, token.end - token.begin))
                                   : "a*b";
    source_.fail(token.begin, "an operator is missing between " + quoted(before()) + " and " + here,
                 "write '" + repair + "' to multiply");
  }

  const ExpressionSource& source_;
  bool list_item_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression parse_scalar(const Entry& entry, const std::string& file, bool list_item) {
  const ExpressionSource source(entry, file);
  return Parser(source, list_item).run();
}

}  // namespace poinsot::problem
