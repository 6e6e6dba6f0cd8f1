#include "problem/language/expression.h"

#include <gtest/gtest.h>

#include <random>

#include "problem/language/failure.h"

namespace poinsot::problem {
namespace expression_test {

Expression parsed(const std::string& text) { return parse_expression(text, "f"); }

// The tree in full parentheses, to see how the text was understood.
struct Shape {
  std::string operator()(const Number& number) const { return number.text; }
  std::string operator()(const Name& name) const {
    return name.name + std::string(static_cast<std::size_t>(name.primes), '\'');
  }
  std::string operator()(const Member& member) const { return "(" + of(member.object) + "." + member.name + ")"; }
  std::string operator()(const Arrow& arrow) const { return "(" + of(arrow.from) + "->" + of(arrow.to) + ")"; }
  std::string operator()(const Of& riding) const { return "(" + of(riding.point) + " of " + of(riding.body) + ")"; }
  std::string operator()(const Call& call) const {
    std::string text = call.function;
    for (const Argument& argument : call.arguments) text += "{" + argument.preposition + ":" + of(argument.value) + "}";
    return text;
  }
  std::string operator()(const Unary& unary) const { return std::string("(") + unary.sign + of(unary.operand) + ")"; }
  std::string operator()(const Binary& binary) const {
    return "(" + of(binary.left) + binary.operation + of(binary.right) + ")";
  }
  std::string operator()(const Comparison& comparison) const {
    std::string text = "(" + of(comparison.operands[0]);
    for (std::size_t i = 0; i < comparison.relations.size(); ++i) {
      text += std::string(symbol(comparison.relations[i])) + of(comparison.operands[i + 1]);
    }
    return text + ")";
  }
  std::string operator()(const At& at) const { return "(" + of(at.expression) + "@" + at.instant + ")"; }
  std::string operator()(const List& list) const {
    std::string text = "[";
    for (const Expression& item : list.items) text += of(item) + ";";
    return text + "]";
  }
  std::string operator()(const Range& range) const {
    return "(" + of(range.from) + ".." + of(range.to) + " by " + of(range.step) + ")";
  }
  static std::string of(const Expression& e) { return std::visit(Shape{}, e->content); }
};

std::string shape(const std::string& text) { return Shape::of(parsed(text)); }

std::string failure(const std::string& text) {
  return failure_of([&] { parsed(text); });
}

TEST(Expression, PrecedenceAndAssociation) {
  const std::pair<const char*, const char*> table[] = {
      {"a + b*c", "(a+(b*c))"},
      {"a - b - c", "((a-b)-c)"},
      {"a/b*c", "((a/b)*c)"},
      {"-a^2", "(-(a^2))"},
      {"a^-b", "(a^(-b))"},
      {"2^3^2", "(2^(3^2))"},
      {"a*-b", "(a*(-b))"},
      {"- -a", "(-(-a))"},
      {"+y", "(+y)"},
      {"(a + b)*c", "((a+b)*c)"},
      {"a < b <= c", "(a<b<=c)"},
      {"a + b == c > d >= e", "((a+b)==c>d>=e)"},
      {"a + b @ start", "(a+(b@start))"},
      {"-x @ start", "(-(x@start))"},
      {"(x^2) @ start", "((x^2)@start)"},
      {"a->b.x", "(a->(b.x))"},
      {"A->B @ now", "((A->B)@now)"},
      {"-A->B", "(-(A->B))"},
      {"A of plate @ now", "((A of plate)@now)"},
      {"A - r*[cos(t), sin(t), 0]", "(A-(r*[cos{:t};sin{:t};0;]))"},
      {"0 .. 2*a by a/4", "(0..(2*a) by (a/4))"},
  };
  for (const auto& [text, expected] : table) EXPECT_EQ(shape(text), expected) << text;
}

TEST(Expression, LiteralsTakeTheirUnit) {
  struct Case {
    const char* text;
    double value;
    const char* unit;
  };
  const Case table[] = {
      {"12.5 lb", 12.5, "lb"},
      {"5/8 oz/ft", 0.625, "oz/ft"},
      {"1/23.93 rev/h", 1 / 23.93, "rev/h"},
      {"1.5e-3 m", 1.5e-3, "m"},
      {"2E+3 kg*m^2/s", 2e3, "kg*m^2/s"},
      {".5 in", 0.5, "in"},
      {"5 %", 5, "%"},
      {"3 1/s", 3, "1/s"},
      {"1e5", 1e5, ""},
      {"7", 7, ""},
      {"2 m^(1/2)", 2, "m^(1/2)"},
      {"3   ft", 3, "ft"},
      {"4 s^-2", 4, "s^-2"},
  };
  for (const Case& c : table) {
    const Expression expression = parsed(c.text);
    const Number* number = expression.as<Number>();
    ASSERT_NE(number, nullptr) << c.text;
    EXPECT_EQ(number->value, c.value) << c.text;
    EXPECT_EQ(number->unit.text, c.unit) << c.text;
    EXPECT_EQ(number->has_unit, c.unit[0] != '\0') << c.text;
  }
  EXPECT_EQ(parsed("3   ft").as<Number>()->text, "3 ft") << "the text has one blank";
}

TEST(Expression, UnitsEndWhereTheyShould) {
  const std::pair<const char*, const char*> table[] = {
      {"(1 rev)/period", "(1 rev/period)"},
      {"365.24*24 h", "(365.24*24 h)"},
      {"2 m*3", "(2 m*3)"},
      {"2 m/2", "(2 m/2)"},
      {"2 m * r", "(2 m*r)"},
      {"2 m+r", "(2 m+r)"},
      {"2 m*r", "(2 m*r)"},
      {"2 m-r", "(2 m-r)"},
      {"40 mm*cos(b)", "(40 mm*cos{:b})"},
      {"9.81 m/s^2/L", "(9.81 m/s^2/L)"},
      {"2 kg*m*r^2", "(2 kg*m*(r^2))"},
      {"2 m*s'/2", "((2 m*s')/2)"},
      {"1/2 m/r", "(1/2 m/r)"},
      {"2 m - s", "(2 m-s)"},
      {"[1 m, 2 ft]", "[1 m;2 ft;]"},
      {"1/2", "(1/2)"},
      {"1/2*r", "((1/2)*r)"},
      {"1/2 + 3 s", "((1/2)+3 s)"},
      {"a*5/8 oz", "(a*5/8 oz)"},
      {"component(2 along x)", "component{:2}{along:x}"},
      {"0 deg .. 180 deg by 10 deg", "(0 deg..180 deg by 10 deg)"},
      {"0..5 by 1", "(0..5 by 1)"},
      {"x @ 2 s", "(x@2 s)"},
      {"x @ 1/2 s", "(x@1/2 s)"},
  };
  for (const auto& [text, expected] : table) EXPECT_EQ(shape(text), expected) << text;
}

TEST(Expression, NamesPrimesMembersAndInstants) {
  EXPECT_EQ(shape("turn''"), "turn''");
  EXPECT_EQ(parsed("turn''").as<Name>()->primes, 2);
  EXPECT_EQ(parsed("turn''").as<Name>()->name, "turn");
  EXPECT_EQ(shape("angular_velocity(figure).x"), "(angular_velocity{:figure}.x)");
  EXPECT_EQ(shape("driven.start"), "(driven.start)");
  EXPECT_EQ(shape("turn' @ driven.start"), "(turn'@driven.start)");
  EXPECT_EQ(shape("reaction(A).y @ start"), "((reaction{:A}.y)@start)");
  EXPECT_EQ(parsed("w @ after").as<At>()->instant_mark, (Mark{1, 5}));
  EXPECT_EQ(parsed("w @ large.run.end").as<At>()->names, (std::vector<std::string>{"large", "run", "end"}));
  EXPECT_EQ(parsed("w @ large.run.end").as<At>()->when.as<Name>()->name, "end");
  EXPECT_EQ(parsed("w @ 1/2 s").as<At>()->when.as<Number>()->value, 0.5);
  EXPECT_TRUE(parsed("w @ 1/2 s").as<At>()->names.empty());
}

TEST(Expression, CallsWithPrepositions) {
  EXPECT_EQ(shape("angular_momentum(disk about G)"), "angular_momentum{:disk}{about:G}");
  EXPECT_EQ(shape("cross(A->B with A->C)"), "cross{:(A->B)}{with:(A->C)}");
  EXPECT_EQ(shape("couple(J on B about P)"), "couple{:J}{on:B}{about:P}");
  EXPECT_EQ(shape("component(w along axis(spin))"), "component{:w}{along:axis{:spin}}");
  EXPECT_EQ(shape("velocity(A of plate relative to car)"), "velocity{:(A of plate)}{relative to:car}");
  EXPECT_EQ(shape("velocity(A relative   to car)"), "velocity{:A}{relative to:car}");
  EXPECT_EQ(shape("f()"), "f");
  const Expression expression = parsed("couple(J on B about P)");
  const Call* call = expression.as<Call>();
  ASSERT_NE(call, nullptr);
  EXPECT_EQ(call->pattern(), "on about");
  EXPECT_EQ(to_string(*call->argument("about")), "P");
  EXPECT_EQ(to_string(*call->argument("")), "J");
  EXPECT_EQ(call->argument("with"), nullptr);
}

TEST(Expression, MarksStandAtOperatorsAndBeginnings) {
  const Expression sum = parse_expression("ab + cd*e", "f", {7, 10});
  EXPECT_EQ(sum.mark(), (Mark{7, 13}));
  EXPECT_EQ(beginning(sum), (Mark{7, 10}));
  EXPECT_EQ(sum.as<Binary>()->right.mark(), (Mark{7, 17}));
  EXPECT_EQ(parsed("  f(x)").mark(), (Mark{1, 3}));
}

TEST(Expression, ListsOfTheFileAreLists) {
  const Entry root = read_tree("a: [1 m, [b, 'c'], d + e]\n", "f");
  const Expression expression = parse_expression(*root.find("a"), "f");
  EXPECT_EQ(Shape::of(expression), "[1 m;[b;c;];(d+e);]");
  EXPECT_EQ(expression.mark(), (Mark{1, 4}));
  EXPECT_EQ(expression.as<List>()->items[2].mark(), (Mark{1, 22}));
}

TEST(Expression, EntriesThatAreNoExpressions) {
  const Entry root = read_tree("a:\nb: {c: 1}\nd: ''\ne: [1, ]\nf: [1, ~]\n", "f");
  EXPECT_EQ(failure_of([&] { parse_expression(*root.find("a"), "f"); }),
            "f:1:1: error: a value is missing here (write a number, a name or a formula)");
  EXPECT_EQ(
      failure_of([&] { parse_expression(*root.find("b"), "f"); }),
      "f:2:4: error: expected an expression, not a map (a ': ' in an expression makes a map of it; so do braces)");
  EXPECT_EQ(failure_of([&] { parse_expression(*root.find("d"), "f"); }),
            "f:3:4: error: an expression is missing (write a number, a name or a formula)");
  EXPECT_EQ(failure_of([&] { parse_expression(*root.find("e"), "f"); }), "no error");
  EXPECT_EQ(failure_of([&] { parse_expression(*root.find("f"), "f"); }),
            "f:5:8: error: a value is missing here (write a number, a name or a formula)");
}

TEST(Expression, ErrorsPointIntoTheFile) {
  const Entry root = read_tree("given:\n  a: [1 m, 3 + 5kg]\n  b: 1 +\n     2 r\n  \xc3\xa4: 1 \xc3\xa4\n", "f");
  const Entry& given = *root.find("given");
  EXPECT_EQ(failure_of([&] { parse_expression(*given.find("a"), "f"); }),
            "f:2:17: error: a blank is missing between the number and its unit 'kg' (write '5 kg')");
  EXPECT_EQ(failure_of([&] { parse_expression(*given.find("b"), "f"); }),
            "f:4:8: error: 'r' is not a unit (write '2*r' to multiply)");
  EXPECT_EQ(failure_of([&] { parse_expression(*given.find("\xc3\xa4"), "f"); }),
            "f:5:8: error: '\xc3\xa4' is no sign of the language");
}

TEST(Expression, WrongUnits) {
  const std::pair<const char*, const char*> table[] = {
      {"5kg", "f:1:2: error: a blank is missing between the number and its unit 'kg' (write '5 kg')"},
      {"5kg*m^2", "f:1:2: error: a blank is missing between the number and its unit 'kg*m^2' (write '5 kg*m^2')"},
      {"5%", "f:1:2: error: a blank is missing between the number and its unit '%' (write '5 %')"},
      {"25\xc2\xb0",
       "f:1:3: error: a blank is missing between the number and its unit '\xc2\xb0' (a blank belongs between number "
       "and unit; "
       "write 'deg')"},
      {"5lbs",
       "f:1:2: error: a blank is missing between the number and its unit 'lbs' (a blank belongs between number and "
       "unit; write "
       "'lb')"},
      {"6'", "f:1:2: error: a prime stands after a number (feet are written '6 ft')"},
      {"2r",
       "f:1:2: error: an operator is missing between '2' and 'r' (write '2*r' to multiply; a unit stands after a "
       "blank)"},
      {"0x10",
       "f:1:2: error: an operator is missing between '0' and 'x10' (write '0*x10' to multiply; a unit stands after a "
       "blank)"},
      {"2 r", "f:1:3: error: 'r' is not a unit (write '2*r' to multiply)"},
      {"2 ab", "f:1:3: error: 'ab' is not a unit (write '2*ab' to multiply; did you mean the unit 'lb'?)"},
      {"2 RPM", "f:1:3: error: 'RPM' is not a unit (write '2*RPM' to multiply; did you mean the unit 'rpm'?)"},
      {"2 turn'", "f:1:3: error: an operator is missing between '2' and 'turn'' (write '2*turn'' to multiply)"},
      {"2 sin(x)", "f:1:3: error: 'sin' is not a unit (write '2*sin(...)' to multiply)"},
      {"2 min(x)", "f:1:3: error: an operator is missing between '2' and 'min' (write '2*min(...)' to multiply)"},
      {"2 lbs*ft", "f:1:3: error: 'lbs' is not how the unit is written (write 'lb*ft')"},
      {"2 m*d",
       "f:1:5: error: 'd' is not how the unit is written (write 'm*day', or, if it is a name, put blanks around the "
       "'*')"},
      {"2 m2", "f:1:3: error: 'm2' is not a unit (write 'm^2')"},
      {"1 1/j",
       "f:1:3: error: two numbers stand side by side (a mixed number is written as a decimal or as one fraction: 1.5 "
       "or 3/2)"},
      {"2 kg.m2", "f:1:5: error: '.' does not belong into a unit (write 'kg*m^2')"},
      {"2 m**2", "f:1:5: error: a unit is missing before '*' (write 'm^2')"},
      {"2 m/s\xc2\xb2", "f:1:6: error: '\xc2\xb2' does not belong into a unit (write 'm/s^2')"},
      {"2 N\xc2\xb7m", "f:1:4: error: '\xc2\xb7' does not belong into a unit (write 'N*m')"},
      {"2 ft-lb",
       "f:1:5: error: it is not clear whether '-' belongs to the unit 'ft-lb' or subtracts (write 'ft*lb' for the "
       "unit; to "
       "subtract, put blanks around the '-')"},
      {"1 kg/(m*s)",
       "f:1:6: error: a unit has no parentheses (kg/(m*s) is written kg/m/s; if 'm*s' is a name, put blanks around the "
       "'/')"},
      {"2 m^n",
       "f:1:4: error: an exponent of a unit must be a whole number up to 100, not 0 (write it like m^2, s^-1 or "
       "m^(1/2))"},
      {"3/2/4 m",
       "f:1:3: error: a fraction with a unit after '/' can be read in two ways (put the fraction and its unit, or what "
       "is meant, "
       "into parentheses)"},
      {"1/0 m", "f:1:2: error: this fraction has the denominator zero"},
      {"3 Hz", "f:1:3: error: 'Hz' is ambiguous: a hertz may count turns or radians (write 'rev/s' or 'rad/s')"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
}

TEST(Expression, WrongNumbers) {
  const std::pair<const char*, const char*> table[] = {
      {"5.", "f:1:2: error: digits are missing after the decimal point (write '5.0')"},
      {"1.2.3", "f:1:4: error: this number has two decimal points"},
      {"1e999", "f:1:1: error: this number is beyond the range of numbers, 1e-308 to 1e308"},
      {"3,5 m", "f:1:2: error: a comma stands in a number (a decimal is written with a point: 3.5 m)"},
      {"3, 5 m",
       "f:1:2: error: a comma stands outside of a list (a decimal is written with a point, 1.5; a vector goes into "
       "brackets, [a, b, c])"},
      {".nan kg", "f:1:1: error: '.nan' is no number (write the value, or 'any' for what is open)"},
      {"-.inf", "f:1:2: error: '.inf' is no number (write the value, or 'any' for what is open)"},
      {"1e101 kg", "f:1:1: error: this number is beyond what can be reckoned with, 1e-100 to 1e100"},
      {"2e-101 m", "f:1:1: error: this number is beyond what can be reckoned with, 1e-100 to 1e100"},
      {"3000 1/min",
       "f:1:6: error: '1/min' is ambiguous: it may count turns or radians (write 'rpm', 'rev/h', 'rad/min')"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
}

TEST(Expression, WrongForms) {
  const std::pair<const char*, const char*> table[] = {
      {"cross(a, b)", "f:1:8: error: a comma stands between the arguments of 'cross' (write cross(u with v))"},
      {"angular_momentum(disk, G)",
       "f:1:22: error: a comma stands between the arguments of 'angular_momentum' (write angular_momentum(disk about "
       "G))"},
      {"foo(a, b)",
       "f:1:6: error: a comma stands between the arguments of 'foo' (arguments are joined by prepositions, as in "
       "cross(u with "
       "v))"},
      {"(a, b)", "f:1:3: error: a comma stands in parentheses (a vector goes into brackets, [a, b, c])"},
      {"(a + b",
       "f:1:1: error: '(' is never closed (add ')'; if a comma ended it, a vector goes into brackets, [a, b, c])"},
      {"velocity(bar",
       "f:1:9: error: '(' is never closed (add ')'; if a comma ended it, write velocity(A of plate relative to car))"},
      {"5 ft 3 in", "f:1:6: error: a sign is missing between '5 ft' and '3 in' (write '5 ft + 3 in' to add)"},
      {"12 in.", "f:1:6: error: a point stands after a number (units are written without one: 12 in)"},
      {"2*(a + (b)",
       "f:1:3: error: '(' is never closed (add ')'; if a comma ended it, a vector goes into brackets, [a, b, c])"},
      {"[a, b", "f:1:1: error: '[' is never closed (add ']')"},
      {"a + b)", "f:1:6: error: ')' has no opening '(' (remove it, or add the opening one)"},
      {"(a]", "f:1:1: error: '(' is never closed (add ')')"},
      {"a b",
       "f:1:3: error: an operator is missing between 'a' and 'b' (write 'a*b' to multiply, 'a(b)' of a quantity, or "
       "'a_b' where both are one name)"},
      {"a (b)(c)", "f:1:6: error: an operator is missing between ')' and '(' (write 'a*b' to multiply)"},
      {"a + ", "f:1:5: error: the expression ends too early: something is missing after '+'"},
      {"a */ b", "f:1:4: error: something is missing between '*' and '/'"},
      {"*a", "f:1:1: error: something is missing between the beginning and '*'"},
      {"a about b",
       "f:1:3: error: 'about' cannot stand here (it joins the arguments of a call, as in component(v along u))"},
      {"f(about b)",
       "f:1:3: error: something is missing before 'about' ('about' is a word of the language and no name)"},
      {"f(a about b about c)", "f:1:13: error: 'about' stands twice in 'f(...)' (remove one of the two)"},
      {"f(a relative b)",
       "f:1:5: error: 'relative' stands without 'to' (write 'relative to', as in velocity(A relative to car))"},
      {"a .. b", "f:1:7: error: the step of this range is missing (write it as 0 s .. 2 s by 0.1 s)"},
      {"a .. b by c .. d", "f:1:13: error: a range cannot stand in a range (write it as 0 s .. 2 s by 0.1 s)"},
      {"2 @ start",
       "f:1:3: error: '@' stands after a number, which is the same at every instant (put what is meant into "
       "parentheses, (x^2) @ "
       "start)"},
      {"x^2 @ start",
       "f:1:5: error: '@' stands after a number, which is the same at every instant (put what is meant into "
       "parentheses, (x^2) @ "
       "start)"},
      {"x @", "f:1:4: error: an instant is missing after '@' (write its name or a time: x @ start, x @ 2 s)"},
      {"x @ 2 m", "f:1:5: error: the instant after '@' is no time (write a name, or a time with its unit: x @ 2 s)"},
      {"x @ 2", "f:1:5: error: the instant after '@' is no time (write a name, or a time with its unit: x @ 2 s)"},
      {"2->B", "f:1:1: error: an arrow begins at a number (it goes from point to point, A->B)"},
      {"A->2", "f:1:4: error: after '->' a name is expected, not '2' (write A->B)"},
      {"A->-B", "f:1:4: error: after '->' a name is expected, not '-' (write A->B)"},
      {"A->B->C",
       "f:1:5: error: an arrow follows an arrow (write two arrows, A->B and B->C, or the one from end to end, A->C)"},
      {"A->B of c",
       "f:1:6: error: 'of' after an arrow can be read in two ways (put the arrow, or what is meant, into parentheses)"},
      {"2 of c", "f:1:1: error: a number cannot ride on a body (before 'of' stands a point, A of plate)"},
      {"A of", "f:1:5: error: the expression ends too early: something is missing after 'of'"},
      {"a.", "f:1:3: error: a name is missing after '.' (write a component or part of something, v.x)"},
      {"f'(x)",
       "f:1:1: error: a call has no primes (to derive it give it a name under 'define:' and put the primes behind that "
       "name)"},
      {"f(x)'",
       "f:1:5: error: ''' is no sign of the language (a prime stands right after a name, turn'; to derive anything "
       "else give it a "
       "name under 'define:')"},
      {"a''''''''''", "f:1:1: error: 'a' has more than 9 primes"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
}

TEST(Expression, SignsOfOtherPlaces) {
  const std::pair<const char*, const char*> table[] = {
      {"a**2", "f:1:2: error: '**' is no sign of the language (write a power as x^2)"},
      {"a = 3", "f:1:3: error: '=' is no sign of the language (write == for a condition)"},
      {"a \xe2\x88\x92 b", "f:1:3: error: a typographic minus is no sign of the language (write -)"},
      {"a \xe2\x80\x93 b", "f:1:3: error: a dash is no sign of the language (write -)"},
      {"a\xc2\xb7"
       "b",
       "f:1:2: error: a raised dot is no sign of the language (write * to multiply, dot(a with b) for vectors)"},
      {"r\xc2\xb2", "f:1:2: error: a raised digit is no sign of the language (write a power as x^2)"},
      {"theta + \xc2\xb0",
       "f:1:9: error: a degree sign is no sign of the language (write deg after a number and a blank, 25 deg)"},
      {"\xcf\x89", "f:1:1: error: a Greek letter is no sign of the language (names have plain letters: write omega)"},
      {"\xce\x98", "f:1:1: error: a Greek letter is no sign of the language (names have plain letters: write Theta)"},
      {"turn\xe2\x80\x99", "f:1:5: error: a typographic quote is no sign of the language (a prime is written ')"},
      {"turn\"", "f:1:5: error: '\"' is no sign of the language (write two primes, turn'')"},
      {"a\xc2\xa0+ b", "f:1:2: error: a non-breaking blank is no sign of the language (write an ordinary blank)"},
      {"A \xe2\x86\x92 B", "f:1:3: error: a typographic arrow is no sign of the language (write A->B)"},
      {"a ? b", "f:1:3: error: '?' is no sign of the language"},
      {"a != b",
       "f:1:3: error: '!=' is no sign of the language (there is no 'unequal'; say what it is with <, <=, >, >= or ==)"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
}

TEST(Expression, WordsThatJoinElsewhere) {
  const std::pair<const char*, const char*> table[] = {
      {"|v|",
       "f:1:1: error: '|' is no sign of the language (the size of a vector is written norm(v), that of a number "
       "abs(x))"},
      {"angle(u and v)",
       "f:1:9: error: 'and' is no word that joins the arguments of a call (the language says 'to' or 'with': write "
       "angle(u to v))"},
      {"I(b about x through O)",
       "f:1:13: error: 'through' is no word that joins the arguments of a call (the language says 'at')"},
      {"angle between u",
       "f:1:7: error: 'between' is no word that joins the arguments of a call (the language says 'to': write angle(u "
       "to "
       "v))"},
      {"velocity(b) after",
       "f:1:13: error: 'after' cannot stand here (an instant stands behind '@': kinetic_energy(disk) @ after)"},
      {"(u and v)",
       "f:1:4: error: an operator is missing between 'u' and 'and' (write 'u*and' to multiply, 'u(and)' of "
       "a quantity, or 'u_and' where both are one name)"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
}

TEST(Expression, AListItemCutAtItsCommaIsExplained) {
  const Entry root = read_tree("a: [cross(u, v), 0, 0]\nb: [(u, v)]\n", "f");
  EXPECT_EQ(failure_of([&] { parse_expression(*root.find("a"), "f"); }),
            "f:1:10: error: '(' is never closed (add ')'; a comma ends the item of a list, so write cross(u with v))");
  EXPECT_EQ(failure_of([&] { parse_expression(*root.find("b"), "f"); }),
            "f:2:5: error: '(' is never closed (add ')'; a comma ends the item of a list)");
}

TEST(Expression, DepthAndLengthAreBounded) {
  const auto repeated = [](const std::string& text, int n) {
    std::string all;
    for (int i = 0; i < n; ++i) all += text;
    return all;
  };
  const std::string deep =
      "this expression is nested more than 64 deep (name parts of it under 'given:' or 'define:' and use the names)";
  EXPECT_EQ(failure(repeated("(", 64) + "a" + repeated(")", 64)), "no error");
  EXPECT_EQ(failure(repeated("(", 65) + "a" + repeated(")", 65)), "f:1:65: error: " + deep);
  for (const char* opening : {"(", "[", "f(", "-", "+", "2^", "f(a with "}) {
    EXPECT_NE(failure(repeated(opening, 1000)).find(deep), std::string::npos) << opening;
  }
  EXPECT_EQ(failure(repeated("a + ", 255) + "a"), "no error");
  EXPECT_EQ(failure(repeated("a + ", 256) + "a"),
            "f:1:1023: error: this expression has too many terms in a row (name parts of it under 'given:' or "
            "'define:' and use "
            "the names)");
  for (const char* link : {"*a", "/a", ".a", " @ a"}) {
    EXPECT_NE(failure("a" + repeated(link, 300)).find("too many terms in a row"), std::string::npos) << link;
  }
  EXPECT_EQ(failure("a" + repeated(" < a", 1000)), "no error") << "a chain of comparisons is flat";
  EXPECT_EQ(failure(std::string(10'001, 'a')),
            "f:1:1: error: this expression is longer than 10000 bytes (name parts of it and use the names)");
}

TEST(ExpressionText, IsCompactAndKeepsTheTree) {
  const std::pair<const char*, const char*> table[] = {
      {"( a+b )*  c", "(a + b)*c"},
      {"a-(b-c)", "a - (b - c)"},
      {"(a-b)-c", "a - b - c"},
      {"(1 rev)/period", "1 rev / period"},
      {"(5/8) * 3 m", "5/8*3 m"},
      {"(5/8) / (3 m)", "5/8 / 3 m"},
      {"(x @ 2 s)^2", "(x @ 2 s)^2"},
      {"(x @ 2 s)*a", "x @ 2 s * a"},
      {"(5/8 oz)^2", "(5/8 oz)^2"},
      {"a/(5/8 oz)", "a/(5/8 oz)"},
      {"(2 m)^2", "(2 m)^2"},
      {"(-a)^2", "(-a)^2"},
      {"a^(b^c)", "a^b^c"},
      {"(a^b)^c", "(a^b)^c"},
      {"(A->B).x", "(A->B).x"},
      {"(A->B) of c", "(A->B) of c"},
      {"cross( A->B  with A->C )", "cross(A->B with A->C)"},
      {"0 deg..theta by 1 deg", "0 deg .. theta by 1 deg"},
      {"(x^2)@start", "(x^2) @ start"},
      {"(a<b)+c", "(a < b) + c"},
      {"[1, [a,b],-c]", "[1, [a, b], -c]"},
  };
  for (const auto& [text, expected] : table) {
    EXPECT_EQ(to_string(parsed(text)), expected) << text;
    EXPECT_TRUE(same_tree(parsed(expected), parsed(text))) << text;
  }
}

TEST(ExpressionText, SameTreeSeesEveryDifference) {
  const char* different[] = {"a",     "b",      "a'",        "1",           "2",           "1 m",    "1 ft",
                             "a.x",   "a.y",    "a->b",      "a->c",        "a of b",      "a of c", "f(a)",
                             "g(a)",  "f(b)",   "f(a to b)", "f(a by b)",   "-a",          "+a",     "a + b",
                             "a - b", "a + c",  "a < b",     "a <= b",      "a < b < c",   "a @ s",  "a @ t",
                             "[a]",   "[a, b]", "[b]",       "0 .. 1 by a", "0 .. 1 by b", "f()"};
  for (const char* a : different) {
    for (const char* b : different) {
      EXPECT_EQ(same_tree(parsed(a), parsed(b)), std::string(a) == b) << a << " against " << b;
    }
  }
  EXPECT_TRUE(same_tree({}, {}));
  EXPECT_FALSE(same_tree({}, parsed("a")));
}

// Random expressions of the grammar.
class RandomText {
 public:
  explicit RandomText(std::uint64_t seed) : random_(seed) {}

  std::string range(int depth) {
    if (pick(8) == 0) return comparison(depth) + " .. " + comparison(depth) + " by " + comparison(depth);
    return comparison(depth);
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string comparison(int depth) {
    static const char* relations[] = {" < ", " <= ", " > ", " >= ", " == "};
    std::string text = sum(depth);
    while (pick(10) == 0) text += relations[pick(5)] + sum(depth);
    return text;
  }
  std::string sum(int depth) {
    std::string text = product(depth);
    while (pick(4) == 0) text += (pick(2) == 0 ? " + " : " - ") + product(depth);
    return text;
  }
  std::string product(int depth) {
    std::string text = factor(depth);
    while (pick(4) == 0) text += (pick(2) == 0 ? " * " : " / ") + factor(depth);
    return text;
  }
  std::string factor(int depth) {
    std::string text = pick(6) == 0 ? (pick(2) == 0 ? "-" : "+") : "";
    text += "(" + tight(depth) + ")";
    if (pick(6) == 0) text += "^" + factor(depth - 1);
    return text;
  }
  std::string tight(int depth) {
    static const char* plain[] = {"a",   "theta'",    "w''",        "pi",    "2",    "0.5",
                                  "3 m", "5/8 oz/ft", "4 kg*m^2/s", "1 1/s", "2 in", "1e-3"};
    if (depth <= 0) return plain[pick(12)];
    switch (pick(12)) {
      case 0:
        return "(-(" + range(depth - 1) + "))." + (pick(2) == 0 ? "x" : "start");
      case 1:
        return "(-(" + range(depth - 1) + "))->f(" + range(depth - 1) + ")";
      case 2:
        return "(-(" + range(depth - 1) + ")) of plate";
      case 3:
        return "(" + range(depth - 1) + ") @ " + (pick(2) == 0 ? "2 s" : "driven.start");
      case 4:
        return "[" + range(depth - 1) + ", " + range(depth - 1) + "]";
      case 5:
        return "g(" + range(depth - 1) + " relative to " + range(depth - 1) + " about " + range(depth - 1) + ")";
      case 6:
        return "(" + range(depth - 1) + ")";
      default:
        return plain[pick(12)];
    }
  }

  std::mt19937_64 random_;
};

TEST(ExpressionText, RandomExpressionsReadBackToTheSameTree) {
  RandomText text(7);
  for (int i = 0; i < 1500; ++i) {
    const std::string original = text.range(3);
    if (original.size() > TreeLimits::scalar_bytes) continue;
    const Expression expression = parsed(original);
    const std::string written = to_string(expression);
    ASSERT_TRUE(same_tree(parsed(written), expression)) << original << "\n" << written;
    ASSERT_EQ(to_string(parsed(written)), written);
  }
}

TEST(Expression, RandomTextGivesATreeOrAnErrorWithItsPlace) {
  std::mt19937_64 random(11);
  const char* pieces[] = {"a", "2", " ",    "m", "/",        "*",  "^",   "(",  ")",        "[",   "]",
                          ",", ".", "->",   "@", "of",       "by", "..",  "'",  "kg",       "<",   "==",
                          "-", "+", "5/8 ", "%", "\xc2\xb0", "\"", "1e5", "to", "relative", "sin", "\xc3\xa9"};
  for (int i = 0; i < 50'000; ++i) {
    std::string text;
    for (std::uint64_t n = random() % 12; n > 0; --n) text += pieces[random() % std::size(pieces)];
    try {
      const Expression expression = parsed(text);
      ASSERT_TRUE(same_tree(parsed(to_string(expression)), expression)) << text;
    } catch (const StatementError& error) {
      const Mark mark = error.diagnostics()[0].mark;
      ASSERT_EQ(mark.line, 1) << text;
      ASSERT_GE(mark.column, 1) << text;
      ASSERT_LE(mark.column, static_cast<int>(text.size()) + 1) << text;
    }
  }
}

TEST(Names, WhatIsAName) {
  for (const char* name : {"a", "_b", "AB2", "in", "theta_0"}) EXPECT_TRUE(is_name(name)) << name;
  for (const char* word : {"", "2a", "a b", "a'", "about", "relative", "relative to", "by", "\xc3\xa4"})
    EXPECT_FALSE(is_name(word)) << word;
}

}  // namespace expression_test
}  // namespace poinsot::problem
