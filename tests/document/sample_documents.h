// Documents that show every kind of answer; their renderings stand in tests/document/golden.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/document.h"

namespace poinsot::document {

inline Datum list(std::vector<Datum> items) { return Datum{std::move(items)}; }
inline Datum numbers(const std::vector<double>& values) {
  std::vector<Datum> items;
  for (double value : values) items.push_back(Datum{value});
  return list(std::move(items));
}
inline Datum texts(const std::vector<std::string>& values) {
  std::vector<Datum> items;
  for (const std::string& value : values) items.push_back(Datum{value});
  return list(std::move(items));
}

inline Answer found(std::string name, Datum value, std::string unit, Datum si) {
  Answer answer;
  answer.name = std::move(name);
  answer.ask = "ask for " + answer.name;
  answer.value = std::move(value);
  answer.unit = std::move(unit);
  answer.si = std::move(si);
  return answer;
}

inline Answer unanswered(std::string name, AnswerState state, std::string reason) {
  Answer answer;
  answer.name = std::move(name);
  answer.ask = "ask for " + answer.name;
  answer.state = state;
  answer.reason = std::move(reason);
  return answer;
}

// One solution, one answer.
inline Document document_of(Answer answer) {
  Document document;
  document.solutions.push_back({{}, {std::move(answer)}, {}, {}});
  return document;
}

// Vectors, matrices, lists, names, truth values, texts and a table, in one solution.
inline Document every_kind() {
  Document document;
  document.file = "plate.yaml";
  document.title = "Plate on two bearings";
  Solution solution;

  Answer momentum = found("H", numbers({0.236, -0.268, 1e-17}), "kg*m^2/s", numbers({0.236, -0.268, 1e-17}));
  momentum.ask = "angular_momentum(disk about G)";
  momentum.words = "angular momentum of disk about G";
  momentum.component_names = {"x", "y", "z"};
  solution.answers.push_back(momentum);

  Answer angle = found("theta", Datum{48.64532191}, "deg", Datum{0.8490210264});
  angle.words = "angle from the angular velocity of plate to the direction u";
  solution.answers.push_back(angle);

  solution.answers.push_back(
      found("inertia", list({numbers({1.25, -0.5, 0}), numbers({-0.5, 10.75, 1e-16}), numbers({0, 1e-16, 12})}),
            "kg*m^2", list({numbers({1.25, -0.5, 0}), numbers({-0.5, 10.75, 1e-16}), numbers({0, 1e-16, 12})})));
  solution.answers.push_back(found("times", numbers({0.10121057, 1.2718192}), "s", numbers({0.10121057, 1.2718192})));
  solution.answers.push_back(found("fired", texts({"B", "C"}), "", {}));
  solution.answers.push_back(found("taut", Datum{true}, "", {}));
  solution.answers.push_back(found("sense", Datum{std::string("retrograde")}, "", {}));

  Answer table = found("motion", {}, "", {});
  table.words = "reaction at A while the plate starts";
  table.columns = {{"t", "s", {0, 0.5, 1}, {0, 0.5, 1}},
                   {"Ay", "lb", {0, -12.25, 1e-16}, {0, -54.4904, 4.4e-16}},
                   {"θ", "deg", {0, 90, 360}, {0, 1.5707963267948966, 6.283185307179586}}};
  solution.answers.push_back(table);

  solution.checks = {{"momentum", 2.1e-14}, {"newton_euler", 1e-13}};
  document.solutions.push_back(solution);
  document.warnings = {"the datum 'k' is not used"};
  return document;
}

// Two roots, and every reason not to answer.
inline Document every_state() {
  Document document;
  document.file = "-";
  document.open_letters = {{"m", "kg"}, {"r", "m"}, {"n", ""}};
  for (const double rate : {5.548195, 395.000744}) {
    Solution solution;
    solution.unknowns.push_back({"phidot", Datum{rate}, "rpm", Datum{rate * 0.10471975511965977}});
    solution.unknowns.push_back({"M", numbers({0, 1.5, 0}), "N*m", numbers({0, 1.5, 0})});
    solution.answers.push_back(found("b", Datum{rate}, "rpm", Datum{rate * 0.10471975511965977}));
    Answer letters = unanswered("force", AnswerState::needs_letters, "it depends on letters without value");
    letters.letters = {"m", "n"};
    letters.unit = "N";
    solution.answers.push_back(letters);
    solution.answers.push_back(unanswered("reaction", AnswerState::undetermined,
                                          "six unknown forces at A and B, five equations; let a support carry less"));
    solution.answers.push_back(unanswered("couple", AnswerState::refused, "its check fell short: Newton-Euler 3e-2"));
    solution.checks = {{"newton_euler", 0.03}, {"constraint_rates", 0}};
    document.solutions.push_back(solution);
  }
  return document;
}

// The text of tests/document/golden/NAME; std::runtime_error if there is none.
inline std::string golden(const std::string& name) {
  const std::string path = std::string(POINSOT_SOURCE_DIR) + "/tests/document/golden/" + name;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace poinsot::document
