#include "poinsot/problem.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "document/own_expectations.h"
#include "document/recording.h"
#include "document/statement_document.h"
#include "poinsot/engine/math/trace/straight_line_text.h"
#include "poinsot/engine/work/budget.h"
#include "poinsot/rendering.h"
#include "problem/answers/asked_motion.h"
#include "problem/answers/contact_states.h"
#include "problem/answers/read_settings.h"
#include "problem/answers/solve_statement.h"
#include "problem/cases/cases.h"
#include "problem/cases/varied_data.h"
#include "problem/entries/named_files.h"
#include "problem/entries/statement.h"
#include "problem/equations/equations.h"
#include "problem/explanation/explanation.h"
#include "problem/keys/keys.h"
#include "problem/language/diagnostic.h"
#include "problem/language/tree.h"
#include "problem/language/units.h"
#include "problem/machine/data.h"
#include "problem/plane/planar_statement.h"
#include "problem/scene/scene.h"

namespace poinsot {
namespace {

// Returns the result of the call. An error in the file is thrown as that of the public header, with the same words.
template <class Call>
auto with_public_errors(const Call& call) {
  try {
    return call();
  } catch (const problem::StatementError& error) {
    std::vector<Diagnostic> diagnostics;
    for (const problem::Diagnostic& one : error.diagnostics())
      diagnostics.push_back({one.file, one.mark.line, one.mark.column, one.message, one.hint});
    throw StatementError(std::move(diagnostics), error.what());
  }
}

// The same for what is asked of a motion.
template <class Call>
auto with_motion_errors(const Call& call) {
  try {
    return with_public_errors(call);
  } catch (const problem::UnansweredRecord& error) {
    throw NoMotion(error.what());
  }
}

StatedDatum stated_datum(const problem::NamedExpression& given) {
  const auto* number = given.value.as<problem::Number>();
  return {given.name, to_string(given.value), number && number->has_unit ? number->unit.text : ""};
}

StatedSituation stated_situation(const problem::Situation& situation) {
  StatedSituation stated;
  stated.name = situation.name;
  for (const problem::NamedExpression& given : situation.given) stated.data.push_back(stated_datum(given));
  for (const problem::Letter& letter : situation.letters) stated.letters.push_back({letter.name, letter.unit.text});
  for (const problem::Unknown& unknown : situation.find)
    stated.unknowns.push_back({unknown.name, unknown.unit.text, unknown.vector});
  return stated;
}

// What a document has beside the answers.
struct Beside {
  bool explanation = false, scene = false;
};

void add_scenes(Solution& solution, std::vector<scene::Scene> scenes) {
  for (scene::Scene& scene : scenes) {
    auto shared = std::make_shared<const scene::Scene>(std::move(scene));
    if (solution.scene)
      solution.other_scenes.push_back(std::move(shared));
    else
      solution.scene = std::move(shared);
  }
}

// What is found as far as the budget lasts.
Document solved_document(const problem::Statement& stated, const Settings& sets, const Beside& beside,
                         const Budget& budget) {
  const BudgetScope scope(budget);
  Document document;
  document.file = stated.file;
  document.title = stated.title;
  try {
    const problem::SolvedStatement solved = problem::solve_statement(stated, sets, beside.explanation);
    {
      // What was found is put down, also after the end.
      const BudgetRespite respite;
      document = document::document_of(stated, solved);
    }
    for (std::size_t i = 0; i < document.solutions.size(); ++i) {
      if (!beside.explanation && !beside.scene) continue;
      const problem::Statement found = problem::in_contact_states(stated, solved.solutions[i].contact_states);
      if (beside.explanation)
        document.solutions[i].explanation =
            std::make_shared<const problem::Explanation>(problem::explain(found, sets, solved, i));
      if (beside.scene) add_scenes(document.solutions[i], problem::scenes_of(found, sets, solved, i));
    }
  } catch (const BudgetEnded& budget_end) {
    document.ended = budget_end.end;
  }
  if (document.ended && document.solutions.empty())
    document.warnings.push_back("the search was ended before a solution was found: " +
                                std::string(words_of(*document.ended)));
  return document;
}

problem::EquationPart engine_part(EquationPart part) {
  switch (part) {
    case EquationPart::mass_matrix:
      return problem::EquationPart::mass_matrix;
    case EquationPart::right_side:
      return problem::EquationPart::right_side;
    case EquationPart::constraint_matrix:
      return problem::EquationPart::constraint_matrix;
    case EquationPart::reduced:
      return problem::EquationPart::reduced;
    case EquationPart::position_rate:
      return problem::EquationPart::position_rate;
    case EquationPart::forward_dynamics:
      return problem::EquationPart::forward_dynamics;
    case EquationPart::inverse_dynamics:
      return problem::EquationPart::inverse_dynamics;
  }
  throw std::invalid_argument("no part of the equations of motion");
}

TextForm text_form(EquationForm form) {
  switch (form) {
    case EquationForm::text:
      return TextForm::plain;
    case EquationForm::tex:
      return TextForm::tex;
    case EquationForm::c:
      return TextForm::c;
    case EquationForm::cpp:
      return TextForm::cpp;
    case EquationForm::python:
      return TextForm::python;
    case EquationForm::sympy:
      return TextForm::sympy;
  }
  throw std::invalid_argument("no form of equations");
}

}  // namespace

struct Problem::Parts {
  Parts(problem::Statement stated, std::string_view whole) : statement(std::move(stated)), text(whole) {
    for (const problem::Situation& one : statement.situations) situations.push_back(stated_situation(one));
    for (const problem::Ask& ask : statement.asks) questions.push_back({ask.name, ask.text});
    for (const problem::Claim& claim : statement.claims) claims.push_back({claim.name, claim.text});
  }

  problem::Statement statement;
  std::string text;
  std::vector<StatedSituation> situations;
  std::vector<StatedQuestion> questions, claims;
};

Problem::Problem(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
Problem::Problem(const Problem&) = default;
Problem::Problem(Problem&&) noexcept = default;
Problem& Problem::operator=(const Problem&) = default;
Problem& Problem::operator=(Problem&&) noexcept = default;
Problem::~Problem() = default;

Problem Problem::read(std::string_view text, const std::string& name, const FileProvider* files) {
  problem::ReadNamedFile read = problem::files_beside(name);
  if (files != nullptr)
    read = [files](const std::string& named) {
      try {
        return files->bytes(named);
      } catch (const FileError& error) {
        throw problem::FileRefused(error.what(), error.hint());
      }
    };
  problem::Statement statement = with_public_errors([&] {
    problem::Statement stated = problem::read_statement(text, name, read);
    problem::restrict_to_plane(stated);
    problem::check_every_datum(stated);
    return stated;
  });
  return Problem(std::make_shared<const Parts>(std::move(statement), text));
}

Problem Problem::with_letters(const std::vector<std::string>& names) const {
  return with_public_errors([&] {
    const problem::Statement& stated = parts_->statement;
    const std::vector<problem::VariedDatum> data = problem::varied_data(stated, names, "the letter");
    for (const problem::Situation& situation : stated.situations)
      for (const problem::Unknown& unknown : situation.find)
        if (std::ranges::find(names, unknown.name) != names.end())
          problem::fail("the letter " + unknown.name, {}, "'" + unknown.name + "' is to be found and no datum");
    return Problem(std::make_shared<const Parts>(problem::with_letters(stated, data), parts_->text));
  });
}

Problem Problem::from_text(std::string_view text, const std::string& name, const FileProvider& files) {
  return read(text, name, &files);
}

Problem Problem::from_text(std::string_view text, const std::string& name) { return read(text, name, nullptr); }

Problem Problem::from_file(const std::string& path) {
  return from_text(with_public_errors([&] { return problem::read_file(path); }), path);
}

const std::string& Problem::name() const { return parts_->statement.file; }
const std::string& Problem::title() const { return parts_->statement.title; }
const std::vector<StatedSituation>& Problem::situations() const { return parts_->situations; }
const std::vector<StatedQuestion>& Problem::questions() const { return parts_->questions; }
const std::vector<StatedQuestion>& Problem::claims() const { return parts_->claims; }
bool Problem::expects() const { return parts_->statement.expects; }
bool Problem::records() const { return parts_->statement.record.has_value(); }

double Problem::value_in_si(const std::string& name, const std::string& text) const {
  return with_public_errors([&] {
    const problem::Value<double> value = problem::read_settings(parts_->statement, {{name, text}}).at(name);
    if (!value.is_number()) problem::fail(name, {}, "'" + text + "' is no number");
    return value.number;
  });
}

Document Problem::solve(const Settings& sets, const Budget& budget) const {
  return with_public_errors([&] { return solved_document(parts_->statement, sets, {}, budget); });
}

Document Problem::explain(const Settings& sets, const Budget& budget) const {
  return with_public_errors([&] { return solved_document(parts_->statement, sets, {.explanation = true}, budget); });
}

Document Problem::illustrate(const Settings& sets, const Budget& budget, bool with_explanation) const {
  return with_public_errors([&] {
    return solved_document(parts_->statement, sets, {.explanation = with_explanation, .scene = true}, budget);
  });
}

std::vector<std::string> Problem::check(const Budget& budget) const {
  const BudgetScope scope(budget);
  return with_public_errors([&] { return document::own_shortfalls(parts_->statement); });
}

Cases Problem::cases(const CaseQuestions& questions, const Budget& budget) const {
  const BudgetScope scope(budget);
  return with_public_errors([&] {
    return Cases(std::make_shared<const problem::CompiledCases>(
        parts_->statement, problem::CasesAsked{.over = questions.over,
                                               .asks = questions.asks,
                                               .sets = questions.sets,
                                               .first = questions.first,
                                               .with_formulas = questions.formulas,
                                               .sensitivities = questions.sensitivities,
                                               .usual = questions.usual}));
  });
}

Recording Problem::record(const std::string& output, const RecordOptions& options, const Budget& budget) const {
  const BudgetScope scope(budget);
  return with_public_errors([&] { return document::record_motion(parts_->statement, parts_->text, output, options); });
}

struct Motion::Parts {
  Parts(const problem::Statement& statement, const Settings& sets) : asked(statement, sets) {}

  std::mutex mutex;
  problem::AskedMotion asked;
};

Motion::Motion(std::shared_ptr<Parts> parts) : parts_(std::move(parts)) {}

Motion Problem::motion(const Settings& sets, const Budget& budget) const {
  const BudgetScope scope(budget);
  return with_motion_errors([&] { return Motion(std::make_shared<Motion::Parts>(parts_->statement, sets)); });
}

std::vector<std::string> Motion::coordinates(const Budget& budget) const {
  const std::lock_guard lock(parts_->mutex);
  const BudgetScope scope(budget);
  return with_motion_errors([&] { return parts_->asked.coordinate_names(); });
}

MotionStart Motion::start(const Budget& budget) const {
  const std::lock_guard lock(parts_->mutex);
  const BudgetScope scope(budget);
  problem::TreeAtStart start = with_motion_errors([&] { return parts_->asked.start(); });
  return {std::move(start.tree), std::move(start.state), std::move(start.coordinates), std::move(start.origins),
          std::move(start.others)};
}

MotionValues Motion::values(const std::vector<double>& times, const std::vector<std::string>& quantities,
                            const std::string& axes, const Budget& budget) const {
  const std::lock_guard lock(parts_->mutex);
  const BudgetScope scope(budget);
  problem::AskedValues asked = with_motion_errors([&] { return parts_->asked.values(times, quantities, axes); });
  MotionValues values{{}, std::move(asked.checks), std::move(asked.notes)};
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    problem::AskedSeries& one = asked.series[i];
    values.series.push_back({quantities[i], one.unit.text, std::move(one.component_names), std::move(one.values)});
  }
  return values;
}

std::string Problem::equations(const EquationsOptions& options, const Budget& budget) const {
  if (!is_function_name(options.function))
    throw std::invalid_argument("'" + options.function + "' cannot be the name of a function");
  problem::EquationsOptions wanted;
  for (const EquationPart part : options.parts) wanted.parts.push_back(engine_part(part));
  wanted.form = text_form(options.form);
  wanted.function = options.function;
  wanted.situation = options.situation;
  wanted.sets = options.sets;
  wanted.letters = options.letters;
  const BudgetScope scope(budget);
  try {
    return with_public_errors([&] { return problem::equations_text(parts_->statement, wanted); });
  } catch (const problem::NoEquations& error) {
    throw NoEquations(error.what());
  }
}

bool is_function_name(std::string_view text) { return is_code_name(text); }

std::string si_unit_of(std::string_view unit) {
  return unit.empty() ? "" : problem::format_unit(problem::parse_unit(unit).dimension);
}

std::string problem_schema() { return problem::problem_schema(); }

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  return problem::did_you_mean(word, candidates);
}

}  // namespace poinsot
