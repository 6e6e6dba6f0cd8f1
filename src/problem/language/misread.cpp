#include "problem/language/misread.h"

#include <algorithm>
#include <array>
#include <vector>

#include "problem/habits/customary_words.h"
#include "problem/language/diagnostic.h"
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
    CallForm{"center", "center(disk)"},
    CallForm{"position", "position(A of plate)"},
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

// How a call of the function is written; "" if the table does not have it.
std::string known_form(std::string_view function) {
  const auto known = std::ranges::find(call_forms, function, &CallForm::function);
  return known == call_forms.end() ? "" : std::string(known->form);
}

std::string form_of(const std::string& function, const char* otherwise) {
  if (const std::string form = known_form(function); !form.empty()) return "write " + form;
  return std::string("arguments ") + otherwise + ", as in cross(u with v)";
}

}  // namespace

void fail_unclosed(const ExpressionSource& source, const TokenReader& tokens, const OpenBracket& bracket) {
  const Token& token = tokens.now();
  const std::string& function = bracket.function;
  if (token.is_sign(",") && !function.empty())
    source.fail(token.begin, "a comma stands between the arguments of '" + function + "'",
                form_of(function, "are joined by prepositions"));
  if (token.is_sign(",") && bracket.opening.is_sign("("))
    source.fail(token.begin, "a comma stands in parentheses", "a vector goes into brackets, [a, b, c]");
  if (token.kind == Token::Kind::end || token.is_sign(")") || token.is_sign("]")) {
    std::string hint = "add '" + std::string(bracket.closing) + "'";
    if (bracket.list_item && bracket.opening.is_sign("(")) {
      hint += function.empty() ? "; a comma ends the item of a list"
                               : "; a comma ends the item of a list, so " + form_of(function, "are joined by words");
    } else if (token.kind == Token::Kind::end && bracket.opening.is_sign("(")) {
      hint += "; if a comma ended it, " +
              (function.empty() ? "a vector goes into brackets, [a, b, c]" : form_of(function, "are joined by words"));
    }
    source.fail(bracket.opening.begin, "'" + bracket.opening.text + "' is never closed", hint);
  }
  fail_left_over(source, tokens, true, function);
}

void fail_missing(const ExpressionSource& source, const TokenReader& tokens) {
  const Token& token = tokens.now();
  const std::string after = tokens.at_beginning() ? "" : " after " + source.quoted(tokens.before());
  if (token.kind == Token::Kind::end)
    source.fail(token.begin, "the expression ends too early: something is missing" + after);
  if (token.is_sign("*") && !tokens.at_beginning() && tokens.before().is_sign("*")) {
    source.fail(tokens.before().begin, "'**' is no sign of the language", "write a power as x^2");
  }
  if (token.kind == Token::Kind::preposition) {
    source.fail(token.begin, "something is missing before " + source.quoted(token),
                source.quoted(token) + " is a word of the language and no name");
  }
  source.fail(token.begin, "something is missing between " +
                               (tokens.at_beginning() ? "the beginning" : source.quoted(tokens.before())) + " and " +
                               source.quoted(token));
}

void fail_left_over(const ExpressionSource& source, const TokenReader& tokens, bool in_call,
                    const std::string& function) {
  const Token& token = tokens.now();
  const std::string here = source.quoted(token);
  if (token.is_sign(")") || token.is_sign("]")) {
    source.fail(token.begin, here + " has no opening '" + (token.is_sign(")") ? "(" : "[") + "'",
                "remove it, or add the opening one");
  }
  if (token.is_sign(",")) {
    const Token& before = tokens.before();
    const Token& after = tokens.next();
    const bool decimal = !tokens.at_beginning() && before.kind == Token::Kind::literal && !before.has_unit &&
                         before.end == token.begin && after.kind == Token::Kind::literal && after.begin == token.end;
    source.fail(token.begin, decimal ? "a comma stands in a number" : "a comma stands outside of a list",
                decimal ? "a decimal is written with a point: " + before.text + "." + after.text
                        : "a decimal is written with a point, 1.5; a vector goes into brackets, [a, b, c]");
  }
  if (token.kind == Token::Kind::preposition) {
    source.fail(token.begin, here + " cannot stand here",
                token.text == "at" && !in_call ? "an instant stands behind '@': kinetic_energy(disk) @ 2 s"
                                               : "it joins the arguments of a call, as in component(v along u)");
  }
  if (token.is_sign(".."))
    source.fail(token.begin, "a range cannot stand in a range", "write it as 0 s .. 2 s by 0.1 s");
  if (in_call && token.kind == Token::Kind::name) {
    static const std::vector<std::string> joining{"about", "along", "to", "with", "from", "of", "on", "by", "at"};
    if (const std::string hint = did_you_mean(std::string(token.text), joining); !hint.empty())
      source.fail(token.begin, here + " is no word that joins the arguments of a call", hint);
  }
  if (const std::string customary = customary_joining(token.text); !customary.empty()) {
    const std::string of = in_call ? function : tokens.at_beginning() ? "" : tokens.before().text;
    if (const std::string form = known_form(of); in_call ? !function.empty() : !form.empty())
      source.fail(token.begin, here + " is no word that joins the arguments of a call",
                  "the language says " + customary + (form.empty() ? "" : ": write " + form));
  }
  for (const std::string_view instant : {"after", "before", "at", "when", "during"})
    if (!in_call && !tokens.at_beginning() && token.kind == Token::Kind::name && token.text == instant)
      source.fail(token.begin, here + " cannot stand here",
                  "an instant stands behind '@': kinetic_energy(disk) @ after");
  const bool simple = tokens.before().kind != Token::Kind::sign && token.kind != Token::Kind::sign;
  if (tokens.before().kind == Token::Kind::name && token.kind == Token::Kind::name && is_unit_name(token.text))
    source.fail(token.begin, here + " is a unit, which stands behind a number",
                "write '" + tokens.before().text + " * 1 " + token.text + "'");
  if (const Token& before = tokens.before();
      before.kind == Token::Kind::literal && before.has_unit && token.kind == Token::Kind::literal && token.has_unit)
    source.fail(token.begin, "a sign is missing between " + source.quoted(before) + " and " + here,
                "write '" + source.written(before) + " + " + source.written(token) + "' to add");
  if (const Token& before = tokens.before();
      before.kind == Token::Kind::literal && !before.has_unit && token.kind == Token::Kind::literal)
    source.fail(token.begin, "two numbers stand side by side",
                "a mixed number is written as a decimal or as one fraction: 1.5 or 3/2");
  const std::string repair = simple ? source.written(tokens.before()) + "*" + source.written(token) : "a*b";
  const bool two_names = tokens.before().kind == Token::Kind::name && token.kind == Token::Kind::name;
  const std::string& first = tokens.before().text;
  const std::string call = two_names && tokens.before().primes == 0
                               ? ", '" + first + "(" + token.text + ")' of a quantity, or '" + first + "_" +
                                     token.text + "' where both are one name"
                               : "";
  source.fail(token.begin, "an operator is missing between " + source.quoted(tokens.before()) + " and " + here,
              "write '" + repair + "' to multiply" + call);
}

std::string undefined_name_hint(const std::string& name, const std::vector<std::string>& known) {
  if (is_unit_name(name)) return "it is a unit too: one stands behind its number and a blank, as in 3 m/s or 180 rpm";
  if (std::string hint = did_you_mean(name, known); !hint.empty()) return hint;
  if (const std::string form = known_form(name); !form.empty()) return "it is asked of something: write " + form;
  const std::string unit = nearest(name, unit_names());
  return unit.empty() ? "" : "if a unit is meant, write '" + unit + "'; if a datum, define it under given: or letters:";
}

}  // namespace poinsot::problem
