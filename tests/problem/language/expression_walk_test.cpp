#include "problem/language/expression_walk.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace poinsot::problem {
namespace expression_walk_test {

Expression walked(const std::string& text) { return parse_expression(text, "f"); }

std::vector<std::string> children_of(const std::string& text) {
  std::vector<std::string> children;
  for_each_child(walked(text), [&](const Expression& child) { children.push_back(to_string(child)); });
  return children;
}

using Texts = std::vector<std::string>;

TEST(ExpressionWalk, GoesThroughTheChildrenOfEachKindInTheOrderOfWriting) {
  EXPECT_EQ(children_of("12 lb"), Texts{});
  EXPECT_EQ(children_of("turn''"), Texts{});
  EXPECT_EQ(children_of("v.x"), Texts{"v"});
  EXPECT_EQ(children_of("A->B"), (Texts{"A", "B"}));
  EXPECT_EQ(children_of("A of plate"), (Texts{"A", "plate"}));
  EXPECT_EQ(children_of("couple(J on B about P)"), (Texts{"J", "B", "P"}));
  EXPECT_EQ(children_of("-a"), Texts{"a"});
  EXPECT_EQ(children_of("a*b"), (Texts{"a", "b"}));
  EXPECT_EQ(children_of("a < b <= c"), (Texts{"a", "b", "c"}));
  EXPECT_EQ(children_of("x @ start"), Texts{"x"});
  EXPECT_EQ(children_of("[a, b, c]"), (Texts{"a", "b", "c"}));
  EXPECT_EQ(children_of("a .. b by c"), (Texts{"a", "b", "c"}));
  for_each_child(Expression{}, [](const Expression&) { FAIL() << "an expression without node has children"; });
}

TEST(ExpressionWalk, AsksNoChildAfterTheFirstThatPasses) {
  int asked = 0;
  const auto is_b = [&](const Expression& child) {
    ++asked;
    return to_string(child) == "b";
  };
  EXPECT_TRUE(any_child(walked("[a, b, c]"), is_b));
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(any_child(walked("[a, c]"), is_b));
}

// Names replaced by sums in every kind of node, and read back.
TEST(ExpressionWalk, TransformsEveryKindAndKeepsMarks) {
  struct Replaced {
    Expression operator()(const Expression& expression) const {
      const Name* name = expression.as<Name>();
      return name && name->name == "x" ? walked("abs(y + 1)") : transformed(expression, *this);
    }
  };
  for (const std::string text : {"x.a", "(x)->B", "x of plate", "f(x on x)", "-x", "x + 2 ft", "x < x == 3",
                                 "x @ start", "[x, 1, [x]]", "x .. 2 by x", "12 lb", "z'"}) {
    std::string expected = text;
    for (std::size_t at = 0; (at = expected.find('x', at)) != std::string::npos; at += 10)
      expected.replace(at, 1, "abs(y + 1)");
    const Expression before = walked(text), after = Replaced{}(before), read = walked(expected);
    EXPECT_TRUE(same_tree(after, read)) << to_string(after);
    EXPECT_EQ(after->height, read->height) << text;
    EXPECT_EQ(after.mark().column, before.mark().column) << text;
  }
}

TEST(ExpressionWalk, BuildsNodesOfTheHeightOfTheirParts) {
  const Expression sum = built(Binary{'+', walked("f(g(a))"), walked("b")}, {3, 4});
  EXPECT_EQ(sum->height, walked("f(g(a)) + b")->height);
  EXPECT_EQ(sum.mark().line, 3);
  EXPECT_EQ(sum.mark().column, 4);
  EXPECT_EQ(built(Name{"a"}, {})->height, 1);
}

TEST(ExpressionWalk, GathersNamesAndFunctionsAlsoBeforeAnAtWhereWanted) {
  const Expression expression = walked("abs(a)*[sqrt(b'), c.x] + (sin(d) @ start)");
  std::set<std::string> names, functions;
  collect_names(expression, names);
  collect_functions(expression, functions);
  EXPECT_EQ(names, (std::set<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(functions, (std::set<std::string>{"abs", "sin", "sqrt"}));
  names.clear();
  functions.clear();
  collect_names(expression, names, false);
  collect_functions(expression, functions, false);
  EXPECT_EQ(names, (std::set<std::string>{"a", "b", "c"}));
  EXPECT_EQ(functions, (std::set<std::string>{"abs", "sqrt"}));
}

TEST(ExpressionWalk, FindsTheFirstAtInTheOrderOfWriting) {
  EXPECT_EQ(first_at(walked("a + b")), nullptr);
  EXPECT_EQ(first_at(walked("max(a with (b @ later)) - (c @ start)"))->instant, "later");
  EXPECT_EQ(first_at(walked("((b @ inner) + 1) @ outer"))->instant, "outer");
}

}  // namespace expression_walk_test
}  // namespace poinsot::problem
