// The answer document as JSON, for other programs.
#include <cmath>
#include <nlohmann/json.hpp>

#include "document/program_version.h"
#include "document/scene_json.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace {

using Json = nlohmann::ordered_json;

Json datum_json(const Datum& datum) {
  if (const auto* number = std::get_if<double>(&datum.content)) return *number;
  if (const auto* truth = std::get_if<bool>(&datum.content)) return *truth;
  if (const auto* text = std::get_if<std::string>(&datum.content)) return *text;
  if (const auto* list = std::get_if<std::vector<Datum>>(&datum.content)) {
    Json items = Json::array();
    for (const Datum& item : *list) items.push_back(datum_json(item));
    return items;
  }
  return nullptr;
}

// A value without unit stands for its own SI value.
const Datum& si_of(const Datum& value, const Datum& si) { return si.empty() ? value : si; }

Json column_json(const Column& column) {
  return {{"name", column.name}, {"unit", column.unit}, {"value", column.value}, {"si", column.si}};
}

Json table_json(const Answer& answer) {
  Json json = {{"columns", Json::array()}};
  for (const Column& column : answer.columns) json["columns"].push_back(column_json(column));
  if (answer.over) json["over"] = column_json(*answer.over);
  return json;
}

void add_claim(Json& json, const ClaimOutcome& claim) {
  json["holds"] = claim.holds;
  if (claim.holds) {
    json["how"] = claim.how;
  } else {
    Json letters = Json::object();
    for (const ClaimOutcome::Value& item : claim.counterexample)
      letters[item.letter] = {{"value", item.value}, {"unit", item.unit}, {"si", item.si}};
    json["counterexample"] = {{"letters", letters}};
    if (claim.sides.size() == 2) {
      json["counterexample"]["left"] = claim.sides[0];
      json["counterexample"]["right"] = claim.sides[1];
      if (claim.difference) json["counterexample"]["difference"] = *claim.difference;
      json["counterexample"]["unit"] = claim.unit;
    }
  }
  if (!claim.assumptions.empty()) json["assumptions"] = claim.assumptions;
}

Json answer_json(const Answer& answer) {
  Json json = Json::object();
  json["ask"] = answer.ask;
  if (!answer.words.empty()) json["words"] = answer.words;
  switch (answer.state) {
    case AnswerState::found:
      if (!answer.columns.empty()) {
        json["table"] = table_json(answer);
        break;
      }
      json["value"] = datum_json(answer.value);
      json["unit"] = answer.unit;
      json["si"] = datum_json(si_of(answer.value, answer.si));
      if (!answer.component_names.empty()) json["axes"] = answer.component_names;
      break;
    case AnswerState::needs_letters:
      json["value"] = nullptr;
      json["unit"] = answer.unit;
      json["si"] = nullptr;
      json["letters"] = answer.letters;
      if (!answer.component_names.empty() && !answer.formula.empty()) json["axes"] = answer.component_names;
      for (const Column& column : answer.columns) json["heads"].push_back(column.name);
      if (!answer.reason.empty()) json["reason"] = answer.reason;
      break;
    case AnswerState::undetermined:
      json["determined"] = false;
      json["reason"] = answer.reason;
      break;
    case AnswerState::refused:
      json["refused"] = true;
      json["reason"] = answer.reason;
      break;
  }
  if (!answer.formula.empty()) json["formula"] = datum_json(answer.formula);
  for (const FormulaWhere& one : answer.formulas)
    json["formulas"].push_back({{"formula", datum_json(one.formula)}, {"where", one.where}});
  if (!answer.no_formula.empty()) json["no_formula"] = answer.no_formula;
  if (answer.claim) add_claim(json, *answer.claim);
  return json;
}

Json solution_json(const Document& document, std::size_t index) {
  const Solution& solution = document.solutions[index];
  Json unknowns = Json::object();
  for (const Unknown& unknown : solution.unknowns) {
    unknowns[unknown.name] = {{"value", datum_json(unknown.value)},
                              {"unit", unknown.unit},
                              {"si", datum_json(si_of(unknown.value, unknown.si))}};
    if (!unknown.formula.empty()) unknowns[unknown.name]["formula"] = datum_json(unknown.formula);
  }
  Json answers = Json::object();
  for (const Answer& answer : solution.answers) answers[answer.name] = answer_json(answer);
  Json checks = Json::object();
  for (const auto& [name, residual] : solution.checks) {
    checks[name] = std::isfinite(residual) ? Json(residual) : Json(nullptr);
  }
  Json json = {{"unknowns", unknowns}, {"answers", answers}, {"checks", checks}};
  if (!solution.assumptions.empty()) json["assumptions"] = solution.assumptions;
  if (!solution.conditions.empty()) {
    json["conditions"] = Json::array();
    for (const Condition& one : solution.conditions)
      json["conditions"].push_back({{"words", one.words}, {"formula", one.formula}});
  }
  if (!solution.notes.empty()) json["notes"] = solution.notes;
  if (solution.explanation) json["explanation"] = to_markdown(document, index);
  if (solution.scene) json["scene"] = scene_json(*solution.scene);
  for (const auto& scene : solution.other_scenes) json["other_scenes"].push_back(scene_json(*scene));
  return json;
}

std::string on_one_line(const Json& json) {
  constexpr int no_indentation = -1;
  return json.dump(no_indentation, ' ', false, Json::error_handler_t::replace);
}

}  // namespace
}  // namespace poinsot::document

namespace poinsot {

std::string to_json(const Document& document) {
  require_values(document);
  document::Json solutions = document::Json::array();
  for (std::size_t i = 0; i < document.solutions.size(); ++i) solutions.push_back(document::solution_json(document, i));
  document::Json json{{"poinsot", document::program_version()},
                      {"file", document.file},
                      {"title", document.title},
                      {"solutions", solutions},
                      {"warnings", document.warnings}};
  for (const Constant& constant : document.constants)
    json["constants"][constant.name] = {{"digits", constant.digits}, {"unit", constant.unit}};
  if (document.ended) json["ended"] = *document.ended == BudgetEnd::deadline ? "deadline" : "interrupted";
  return document::on_one_line(json);
}

std::string checks_to_json(const std::vector<CheckedFile>& files) {
  document::Json list = document::Json::array();
  std::size_t passed = 0;
  for (const CheckedFile& file : files) {
    list.push_back({{"file", file.file}, {"passed", file.shortfalls.empty()}, {"shortfalls", file.shortfalls}});
    passed += file.shortfalls.empty() ? 1 : 0;
  }
  return document::on_one_line({{"poinsot", document::program_version()},
                                {"files", list},
                                {"passed", passed},
                                {"failed", files.size() - passed}});
}

}  // namespace poinsot
