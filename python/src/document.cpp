// The answer document (poinsot/document.h) as plain objects.
#include "poinsot/document.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.h"
#include "poinsot/pictures.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

nb::object object_of(const Datum& datum) {
  if (const auto* number = std::get_if<double>(&datum.content)) return nb::float_(*number);
  if (const auto* truth = std::get_if<bool>(&datum.content)) return nb::bool_(*truth);
  if (const auto* text = std::get_if<std::string>(&datum.content)) return nb::str(text->data(), text->size());
  if (const auto* list = std::get_if<std::vector<Datum>>(&datum.content)) {
    nb::list items;
    for (const Datum& item : *list) items.append(object_of(item));
    return items;
  }
  return nb::none();
}

const char* word_of(AnswerState state) {
  switch (state) {
    case AnswerState::found:
      return "found";
    case AnswerState::needs_letters:
      return "needs_letters";
    case AnswerState::undetermined:
      return "undetermined";
    case AnswerState::refused:
      return "refused";
  }
  throw std::logic_error("a state of answers without a word");
}

// The numbers of a column, which live as long as the document does.
nb::typed<nb::list, double> numbers(const std::vector<double>& column) {
  nb::typed<nb::list, double> list;
  for (const double number : column) list.append(number);
  return list;
}

template <class Owner>
nb::object value_in_si(const Owner& owner) {
  return object_of(owner.si.empty() ? owner.value : owner.si);
}

}  // namespace

void bind_document(nb::module_& module) {
  nb::class_<Letter>(module, "Letter").def_ro("name", &Letter::name).def_ro("unit", &Letter::unit);
  nb::class_<Column>(module, "Column")
      .def_ro("name", &Column::name)
      .def_ro("unit", &Column::unit)
      .def_prop_ro("value", [](const Column& column) { return numbers(column.value); })
      .def_prop_ro("si", [](const Column& column) { return numbers(column.si); });
  nb::class_<ClaimOutcome::Value>(module, "ClaimValue")
      .def_ro("letter", &ClaimOutcome::Value::letter)
      .def_ro("value", &ClaimOutcome::Value::value)
      .def_ro("unit", &ClaimOutcome::Value::unit)
      .def_ro("si", &ClaimOutcome::Value::si)
      .def("__repr__", [](const ClaimOutcome::Value& value) {
        const std::string unit = value.unit.empty() ? "" : " " + value.unit;
        return nb::str("<{} = {:.6g}{}>").format(value.letter, value.value, unit);
      });
  nb::class_<ClaimOutcome>(module, "ClaimOutcome")
      .def_ro("holds", &ClaimOutcome::holds)
      .def_ro("how", &ClaimOutcome::how)
      .def_ro("counterexample", &ClaimOutcome::counterexample)
      .def_ro("sides", &ClaimOutcome::sides)
      .def_ro("difference", &ClaimOutcome::difference)
      .def_ro("unit", &ClaimOutcome::unit)
      .def_ro("assumptions", &ClaimOutcome::assumptions)
      .def("__repr__", [](const ClaimOutcome& claim) {
        return claim.holds ? "<holds, " + claim.how + ">" : std::string("<does not hold>");
      });
  nb::class_<Answer>(module, "Answer")
      .def_ro("name", &Answer::name)
      .def_ro("ask", &Answer::ask)
      .def_ro("words", &Answer::words)
      .def_prop_ro("state", [](const Answer& answer) { return word_of(answer.state); })
      .def_prop_ro("value", [](const Answer& answer) { return object_of(answer.value); })
      .def_ro("unit", &Answer::unit)
      .def_prop_ro("si", &value_in_si<Answer>)
      .def_ro("axes", &Answer::component_names)
      .def_ro("reason", &Answer::reason)
      .def_ro("letters", &Answer::letters)
      .def_ro("columns", &Answer::columns)
      .def_ro("over", &Answer::over)
      .def_prop_ro("formula", [](const Answer& answer) { return object_of(answer.formula); })
      .def_ro("no_formula", &Answer::no_formula)
      .def_ro("claim", &Answer::claim);
  nb::class_<Unknown>(module, "Unknown")
      .def_ro("name", &Unknown::name)
      .def_prop_ro("value", [](const Unknown& unknown) { return object_of(unknown.value); })
      .def_ro("unit", &Unknown::unit)
      .def_prop_ro("si", &value_in_si<Unknown>)
      .def_prop_ro("formula", [](const Unknown& unknown) { return object_of(unknown.formula); });
  nb::class_<Condition>(module, "Condition").def_ro("words", &Condition::words).def_ro("formula", &Condition::formula);
  nb::class_<Solution>(module, "Solution")
      .def_ro("unknowns", &Solution::unknowns)
      .def_ro("answers", &Solution::answers)
      .def_ro("checks", &Solution::checks)
      .def_ro("notes", &Solution::notes)
      .def_ro("assumptions", &Solution::assumptions)
      .def_ro("conditions", &Solution::conditions);
  nb::class_<Constant>(module, "Constant")
      .def_ro("name", &Constant::name)
      .def_ro("digits", &Constant::digits)
      .def_ro("unit", &Constant::unit);
  nb::class_<Document>(module, "Document")
      .def_ro("file", &Document::file)
      .def_ro("title", &Document::title)
      .def_ro("open_letters", &Document::open_letters)
      .def_ro("solutions", &Document::solutions)
      .def_ro("warnings", &Document::warnings)
      .def_ro("constants", &Document::constants)
      .def_prop_ro("ended",
                   [](const Document& document) -> std::optional<std::string> {
                     if (!document.ended) return std::nullopt;
                     return *document.ended == BudgetEnd::deadline ? "deadline" : "interrupted";
                   })
      .def_prop_ro("fully_answered", &fully_answered)
      .def("to_json", &to_json)
      .def(
          "to_text", [](const Document& document, int digits) { return to_terminal(document, {.digits = digits}); },
          "digits"_a)
      .def("to_markdown", [](const Document& document) { return to_markdown(document); })
      .def(
          "figures",
          [](const Document& document, std::size_t solution) {
            std::vector<std::pair<std::string, std::string>> titles;
            for (const FigureTitle& one : figures(document, solution)) titles.emplace_back(one.name, one.title);
            return titles;
          },
          "solution"_a)
      .def(
          "to_svg",
          [](const Document& document, std::size_t solution, const std::string& of, const std::string& view,
             bool values) { return to_svg(document, solution, {.of = of, .view = view, .values = values}); },
          "solution"_a, "of"_a, "view"_a, "values"_a)
      .def(
          "to_gltf",
          [](const Document& document, std::size_t solution) {
            const std::string bytes = to_gltf(document, solution);
            return nb::bytes(bytes.data(), bytes.size());
          },
          "solution"_a)
      .def(
          "to_html",
          [](const Document& document, const Problem& problem, const std::string& text) {
            return to_html(problem, text, document);
          },
          "problem"_a, "text"_a);
}

}  // namespace poinsot::python
