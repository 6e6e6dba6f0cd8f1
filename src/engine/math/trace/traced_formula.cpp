#include "poinsot/engine/math/trace/traced_formula.h"

#include <numbers>
#include <stdexcept>

#include "engine/math/formula/formula_form.h"
#include "engine/math/trace/trace_nodes.h"

namespace poinsot {
namespace {

using symbolic::Form;
using Letter = std::function<Traced(const std::string&)>;

// pi is no fraction of anything.
constexpr std::uint64_t pi_seed = 0x243f6a8885a308d3U;

Traced of_form(const Form& form, const Letter& letter) {
  const auto part = [&](std::size_t i) { return of_form(form.parts[i], letter); };
  switch (form.kind) {
    case Form::Kind::number:
      return traced_constant(symbolic::number_of_digits(form.text), residue_of_digits(form.text));
    case Form::Kind::name:
      if (form.text == "pi") return traced_constant(std::numbers::pi, symbolic::Residue::random(pi_seed));
      return letter(form.text);
    case Form::Kind::negative:
      return -part(0);
    case Form::Kind::sum: {
      Traced sum;
      for (std::size_t i = 0; i < form.parts.size(); ++i) sum += part(i);
      return sum;
    }
    case Form::Kind::product: {
      Traced product(1);
      for (std::size_t i = 0; i < form.parts.size(); ++i) product *= part(i);
      return product;
    }
    case Form::Kind::quotient:
      return part(0) / part(1);
    case Form::Kind::power: {
      const Traced base = part(0);
      Traced power = base;
      for (int i = 1; i < form.exponent; ++i) power *= base;
      return power;
    }
    case Form::Kind::call:
      break;
  }
  if (form.text == "sqrt") return sqrt(part(0));
  if (form.text == "abs") return abs(part(0));
  if (form.text == "sin") return sin(part(0));
  if (form.text == "cos") return cos(part(0));
  if (form.text == "tan") return tan(part(0));
  if (form.text == "asin") return asin(part(0));
  if (form.text == "acos") return acos(part(0));
  if (form.text == "atan") return atan(part(0));
  if (form.text == "atan2") return atan2(part(0), part(1));
  throw std::domain_error("a formula calls " + form.text + ", which cannot be traced");
}

}  // namespace

Traced traced(const Formula& x, const Letter& letter) {
  return x.is_zero() ? Traced() : of_form(symbolic::form_of(x), letter);
}

}  // namespace poinsot
