// Problems (poinsot/problem.h).
#include "poinsot/problem.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <utility>

#include "all_or_nothing.h"
#include "bindings.h"
#include "poinsot/engine/work/budget.h"
#include "poinsot/rendering.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

const std::map<std::string, EquationForm, std::less<>> forms{
    {"text", EquationForm::text}, {"tex", EquationForm::tex},       {"c", EquationForm::c},
    {"c++", EquationForm::cpp},   {"python", EquationForm::python}, {"sympy", EquationForm::sympy}};
const std::map<std::string, EquationPart, std::less<>> parts{{"mass-matrix", EquationPart::mass_matrix},
                                                             {"right-hand-side", EquationPart::right_side},
                                                             {"constraint-matrix", EquationPart::constraint_matrix},
                                                             {"reduced", EquationPart::reduced},
                                                             {"position-rate", EquationPart::position_rate},
                                                             {"forward-dynamics", EquationPart::forward_dynamics},
                                                             {"inverse-dynamics", EquationPart::inverse_dynamics}};

template <class Kind>
Kind chosen(const std::map<std::string, Kind, std::less<>>& table, const std::string& word, const char* what) {
  if (const auto found = table.find(word); found != table.end()) return found->second;
  std::vector<std::string> known;
  std::string expected;
  for (const auto& [name, value] : table) {
    known.push_back(name);
    expected += (expected.empty() ? "" : ", ") + name;
  }
  const std::string hint = did_you_mean(word, known);
  throw nb::value_error((std::string("there is no ") + what + " '" + word + "': expected " + expected +
                         (hint.empty() ? "" : " (" + hint + ")"))
                            .c_str());
}

Found<Document> solve(const Problem& problem, const Settings& sets, bool scene, bool explanation, Timeout timeout,
                      nb::object listener) {
  LongCall call(timeout, std::move(listener));
  Document document = call([&](const Budget& budget) {
    if (scene) return problem.illustrate(sets, budget, explanation);
    return explanation ? problem.explain(sets, budget) : problem.solve(sets, budget);
  });
  return {std::move(document), call.raised()};
}

Found<std::optional<std::string>> equations(const Problem& problem, const std::vector<std::string>& of,
                                            const std::string& form, const std::string& function,
                                            const std::string& situation, const Settings& sets,
                                            const std::vector<std::string>& letters, Timeout timeout,
                                            nb::object listener) {
  EquationsOptions options{.form = chosen(forms, form, "form of equations"),
                           .function = function,
                           .situation = situation,
                           .sets = sets,
                           .letters = letters};
  for (const std::string& part : of) options.parts.push_back(chosen(parts, part, "part of the equations of motion"));
  return all_or_nothing(timeout, std::move(listener),
                        [&](const Budget& budget) { return problem.equations(options, budget); });
}

}  // namespace

void bind_problem(nb::module_& module) {
  nb::class_<StatedDatum>(module, "StatedDatum")
      .def_ro("name", &StatedDatum::name)
      .def_ro("text", &StatedDatum::text)
      .def_ro("unit", &StatedDatum::unit);
  nb::class_<StatedUnknown>(module, "StatedUnknown")
      .def_ro("name", &StatedUnknown::name)
      .def_ro("unit", &StatedUnknown::unit)
      .def_ro("vector", &StatedUnknown::vector);
  nb::class_<StatedQuestion>(module, "StatedQuestion")
      .def_ro("name", &StatedQuestion::name)
      .def_ro("text", &StatedQuestion::text);
  nb::class_<StatedSituation>(module, "StatedSituation")
      .def_ro("name", &StatedSituation::name)
      .def_ro("data", &StatedSituation::data)
      .def_ro("letters", &StatedSituation::letters)
      .def_ro("unknowns", &StatedSituation::unknowns);

  nb::class_<Recording>(module, "Recording")
      .def_ro("data", &Recording::data)
      .def_ro("journal", &Recording::journal)
      .def_ro("rows", &Recording::rows)
      .def_ro("columns", &Recording::columns)
      .def_ro("end", &Recording::end)
      .def_ro("complete", &Recording::complete)
      .def_ro("resumed_at", &Recording::resumed_at)
      .def_ro("notes", &Recording::notes);

  nb::class_<Problem>(module, "Problem")
      .def_static(
          "from_text",
          [](const std::string& text, const std::string& name, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener), [&](const Budget& budget) {
              const BudgetScope scope(budget);
              return Problem::from_text(text, name);
            });
          },
          "text"_a, "name"_a, "timeout"_a.none(), "listener"_a.none())
      .def_prop_ro("name", &Problem::name)
      .def_prop_ro("title", &Problem::title)
      .def_prop_ro("situations", &Problem::situations)
      .def_prop_ro("questions", &Problem::questions)
      .def_prop_ro("claims", &Problem::claims)
      .def_prop_ro("expects", &Problem::expects)
      .def("solve", &solve, "sets"_a, "scene"_a, "explanation"_a, "timeout"_a.none(), "listener"_a.none())
      .def(
          "check",
          [](const Problem& problem, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener),
                                  [&](const Budget& budget) { return problem.check(budget); });
          },
          "timeout"_a.none(), "listener"_a.none())
      .def(
          "motion",
          [](const Problem& problem, const Settings& sets, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener),
                                  [&](const Budget& budget) { return problem.motion(sets, budget); });
          },
          "sets"_a, "timeout"_a.none(), "listener"_a.none())
      .def(
          "record",
          [](const Problem& problem, const std::string& output, const Settings& sets, bool replace, Timeout timeout,
             nb::object listener) {
            return all_or_nothing(timeout, std::move(listener), [&](const Budget& budget) {
              return problem.record(output, {.sets = sets, .replace = replace}, budget);
            });
          },
          "output"_a, "sets"_a, "replace"_a, "timeout"_a.none(), "listener"_a.none())
      .def(
          "cases",
          [](const Problem& problem, const CaseQuestions& questions, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener),
                                  [&](const Budget& budget) { return problem.cases(questions, budget); });
          },
          "questions"_a, "timeout"_a.none(), "listener"_a.none())
      .def("value_in_si", &Problem::value_in_si, "name"_a, "text"_a)
      .def("with_letters", &Problem::with_letters, "names"_a)
      .def("equations", &equations, "of"_a, "form"_a, "function"_a, "situation"_a, "sets"_a, "letters"_a,
           "timeout"_a.none(), "listener"_a.none());

  module.def("problem_schema", &problem_schema);
  module.def("answer_schema", &answer_schema);
  module.def(
      "language_help", [](const std::string& word) { return language_help(word); }, "word"_a);
  module.def("language_words", &language_words);
  module.def(
      "si_unit_of", [](const std::string& unit) { return si_unit_of(unit); }, "unit"_a);
  module.def(
      "did_you_mean",
      [](const std::string& word, const std::vector<std::string>& candidates) {
        return did_you_mean(word, candidates);
      },
      "word"_a, "candidates"_a);
}

}  // namespace poinsot::python
