// Forms as lines of text: plain, C, Python.
#include "poinsot/engine/math/formula/formula_text.h"

#include "engine/math/formula/formula_form.h"

namespace poinsot {
namespace symbolic {
namespace {

bool is_number(const Form& form) { return form.kind == Form::Kind::number; }

bool is_large_whole(const Form& form) { return form.text.size() > 9 && form.text.find('.') == std::string::npos; }

class Writer {
 public:
  explicit Writer(Notation notation) : notation_(notation) {}

  std::string written(const Form& form) const {
    switch (form.kind) {
      case Form::Kind::number:
        // Whole numbers beyond the range of int.
        return notation_ == Notation::c && is_large_whole(form) ? form.text + ".0" : form.text;
      case Form::Kind::name:
        return notation_ == Notation::c && form.text == "pi" ? "M_PI" : form.text;
      case Form::Kind::negative:
        return "-" + bracketed(form.parts[0], is_compound(form.parts[0]));
      case Form::Kind::sum:
        return sum(form);
      case Form::Kind::product:
        return product(form);
      case Form::Kind::quotient:
        return quotient(form);
      case Form::Kind::power:
        return power(form);
      case Form::Kind::call:
        if (const Form* sized = notation_ == Notation::with_sizes ? sized_part(form) : nullptr)
          return "abs(" + written(*sized) + ")";
        break;
    }
    std::string call = form.text + "(" + written(form.parts[0]);
    for (std::size_t i = 1; i < form.parts.size(); ++i) call += ", " + written(form.parts[i]);
    return call + ")";
  }

 private:
  std::string bracketed(const Form& form, bool brackets) const {
    return brackets ? "(" + written(form) + ")" : written(form);
  }
  std::string sum(const Form& form) const {
    std::string sum = written(form.parts[0]);
    for (std::size_t i = 1; i < form.parts.size(); ++i) {
      const Form& part = form.parts[i];
      const bool negative = part.kind == Form::Kind::negative;
      sum += negative ? " - " : " + ";
      sum += negative ? bracketed(part.parts[0], is_compound(part.parts[0])) : written(part);
    }
    return sum;
  }
  std::string product(const Form& form) const {
    std::string product;
    for (std::size_t i = 0; i < form.parts.size(); ++i) {
      const Form& part = form.parts[i];
      const bool brackets = is_compound(part) || (i > 0 && part.kind == Form::Kind::quotient);
      product += (i == 0 ? "" : "*") + bracketed(part, brackets);
    }
    return product;
  }
  std::string quotient(const Form& form) const {
    const Form& above = form.parts[0];
    const Form& below = form.parts[1];
    const bool below_brackets = is_compound(below) || below.kind == Form::Kind::product ||
                                below.kind == Form::Kind::quotient || spelled_out(below);
    if (is_number(above) && is_number(below)) {
      if (notation_ == Notation::sympy) return "Rational(" + above.text + ", " + below.text + ")";
      if (notation_ == Notation::c && !is_large_whole(above)) return above.text + ".0/" + written(below);
    }
    return bracketed(above, is_compound(above)) + "/" + bracketed(below, below_brackets);
  }
  // x*x for x^2.
  bool spelled_out(const Form& form) const {
    return notation_ == Notation::c && form.kind == Form::Kind::power && form.parts[0].kind == Form::Kind::name &&
           form.exponent <= 4;
  }
  std::string power(const Form& form) const {
    const Form& base = form.parts[0];
    if (spelled_out(form)) {
      std::string product = written(base);
      for (int k = 1; k < form.exponent; ++k) product += "*" + written(base);
      return product;
    }
    if (notation_ == Notation::c) return "pow(" + written(base) + ", " + std::to_string(form.exponent) + ")";
    const bool simple = is_number(base) || base.kind == Form::Kind::name || base.kind == Form::Kind::call;
    return bracketed(base, !simple) + (notation_ == Notation::python || notation_ == Notation::sympy ? "**" : "^") +
           std::to_string(form.exponent);
  }

  Notation notation_;
};

}  // namespace

std::string text_of(const Form& form) { return Writer(Notation::plain).written(form); }

}  // namespace symbolic

std::string text(const Formula& x, Notation notation) {
  const symbolic::Form form = symbolic::form_of(x);
  return notation == Notation::tex ? symbolic::tex_of(form) : symbolic::Writer(notation).written(form);
}

}  // namespace poinsot
