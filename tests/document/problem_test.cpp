#include "poinsot/problem.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "document/failure.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace problem_test {

namespace fs = std::filesystem;

// A disk of 3 kg and 0.2 m that turns with 2 rad/s about its axis: H = 0.12 kg m^2/s, T = 0.12 J.
const std::string disk =
    "title: A disk\nletters: {m: kg}\ngiven: {r: 0.2 m}\n"
    "bodies: {disk: {disk: {center: [0, 0, 0], normal: y, radius: r}, mass: m}}\n"
    "joints: {shaft: {revolute: y, at: [0, 0, 0], to: disk, rate: 2 rad/s}}\n"
    "ask: {a: \"angular_momentum(disk about [0, 0, 0])\", b: {of: kinetic_energy(disk), unit: J}}\n";

class ProblemFile : public ::testing::Test {
 protected:
  ProblemFile() : folder_(fs::temp_directory_path() / ("poinsot_problem_test_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~ProblemFile() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::vector<std::string> failures(const std::string& expect) const {
    return Problem::from_text(disk + expect, "one.yaml").check();
  }

  fs::path folder_;
};

TEST_F(ProblemFile, AFileBecomesADocument) {
  const Document document = Problem::from_file(file("disk.yaml", disk)).solve({{"m", "1 kg"}, {"m", "3 kg"}});
  EXPECT_EQ(document.file, (folder_ / "disk.yaml").string());
  EXPECT_EQ(document.title, "A disk");
  EXPECT_TRUE(document.open_letters.empty());
  ASSERT_EQ(document.solutions.size(), 1U);
  ASSERT_EQ(document.solutions[0].answers.size(), 2U);
  const Answer& a = document.solutions[0].answers[0];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.ask, "angular_momentum(disk about [0, 0, 0])");
  EXPECT_EQ(a.state, AnswerState::found);
  EXPECT_EQ(a.component_names, (std::vector<std::string>{"x", "y", "z"}));
  const auto& components = std::get<std::vector<Datum>>(a.si.content);
  ASSERT_EQ(components.size(), 3U);
  EXPECT_NEAR(std::get<double>(components[1].content), 0.12, 1e-15);
  const Answer& b = document.solutions[0].answers[1];
  EXPECT_EQ(b.unit, "J");
  EXPECT_NEAR(std::get<double>(b.value.content), 0.12, 1e-15);
  EXPECT_TRUE(fully_answered(document));
  for (const auto& [name, residual] : document.solutions[0].checks) EXPECT_LT(residual, 1e-12) << name;
}

// Painleve's rod (Genot and Brogliato, Eur. J. Mech. A 18, 653, 1999): a push on the end drives it into so rough a
// floor, and without one it sinks in by omega^2 l sin b - g < 0, if it turns slowly.
TEST_F(ProblemFile, MayExpectThatNoMotionIsPossible) {
  const auto failures = [](const std::string& omega) {
    return Problem::from_text("title: A rod\ngiven: {l: 1 m, b: 55 deg, mu: 3, omega: " + omega +
                                  "}\npoints: {A: [0, 0, 0], B: [2*l*cos(b), 2*l*sin(b), 0]}\nbodies: {rod: {rod: [A, "
                                  "B], mass: 1 kg}}\n"
                                  "contacts: {floor: {of: rod, at: A, normal: y, friction: mu}}\ngravity: -y\n"
                                  "facts: {velocity(A of rod): [-1 m/s, 0, 0], angular_velocity(rod): [0, 0, -omega]}\n"
                                  "ask: {N: normal_force(floor)}\nexpect: {N: {roots: []}}\n",
                              "rod.yaml")
        .check();
  };
  EXPECT_EQ(failures("1 rad/s"), std::vector<std::string>{});
  EXPECT_EQ(failures("5 rad/s").size(), 1U);
}

TEST_F(ProblemFile, OpenLettersStandInTheDocument) {
  const Document document = Problem::from_text(disk, "disk.yaml").solve();
  ASSERT_EQ(document.open_letters.size(), 1U);
  EXPECT_EQ(document.open_letters[0].name, "m");
  EXPECT_EQ(document.open_letters[0].unit, "kg");
  for (const Answer& answer : document.solutions.at(0).answers) {
    EXPECT_EQ(answer.state, AnswerState::needs_letters);
    EXPECT_EQ(answer.letters, std::vector<std::string>{"m"});
    EXPECT_TRUE(answer.value.empty());
  }
  // With a formula a question has its answer.
  EXPECT_EQ(std::get<std::string>(document.solutions[0].answers[1].formula.content), "m/25");
  EXPECT_TRUE(fully_answered(document));
}

TEST_F(ProblemFile, DataTakeOtherValues) {
  const Document document = Problem::from_text(disk, "disk.yaml").solve({{"m", "3 kg"}, {"r", "400 mm"}});
  EXPECT_NEAR(std::get<double>(document.solutions.at(0).answers.at(1).si.content), 0.48, 1e-14);
}

// H = m r^2 n/2 and T = m r^2 n^2/4 of a disk that turns about its axis with n = 2 rad/s, once the radius is a letter
// too; and with a value it is what it was.
TEST_F(ProblemFile, DataBecomeLetters) {
  const Problem problem = Problem::from_text(disk, "disk.yaml"), opened = problem.with_letters({"r", "m"});
  EXPECT_EQ(problem.situations().front().letters.size(), 1U);
  ASSERT_EQ(opened.situations().front().letters.size(), 2U);
  EXPECT_TRUE(opened.situations().front().data.empty());
  EXPECT_EQ(opened.situations().front().letters[1].unit, "m");
  const Document document = opened.solve();
  EXPECT_EQ(std::get<std::string>(document.solutions.at(0).answers.at(1).formula.content), "m*r^2");
  EXPECT_EQ(document.open_letters.size(), 2U);
  const Document again = opened.solve({{"m", "3 kg"}, {"r", "0.2 m"}});
  EXPECT_NEAR(std::get<double>(again.solutions.at(0).answers.at(1).si.content), 0.12, 1e-15);
  EXPECT_EQ(failure_of([&] { problem.with_letters({"q"}); }),
            "the letter q: error: the problem has no letter or datum 'q' (it has m, r)");
  const Problem sought = Problem::from_text(
      "given: {m: 2 kg, c: [1 m, 2 m, 3 m]}\nfind: {F: N}\nbodies: {b: {particle: c, mass: m}}\ngravity: none\n"
      "loads: {push: {body: b, force: [F, 0, 0]}}\ninstants: {now: {acceleration(b): [3 m/s^2, 0, 0]}}\nask: {F: F}\n",
      "push.yaml");
  EXPECT_EQ(std::get<std::string>(sought.with_letters({"m"}).solve().solutions.at(0).answers.at(0).formula.content),
            "3*m");
  EXPECT_EQ(failure_of([&] { sought.with_letters({"F"}); }), "the letter F: error: 'F' is to be found and no datum");
  EXPECT_NE(failure_of([&] { sought.with_letters({"c"}); }).find("'c' is no number"), std::string::npos);
}

TEST_F(ProblemFile, WrongFilesAndSettingsAreErrors) {
  const std::string missing = (folder_ / "missing.yaml").string();
  EXPECT_EQ(failure_of([&] { Problem::from_file(missing); }),
            missing + ":1:1: error: there is no such file (check the path)");
  EXPECT_NE(failure_of([&] { Problem::from_file(folder_.string()); }).find("this is a folder, not a problem file"),
            std::string::npos);
  const Problem problem = Problem::from_text(disk, "disk.yaml");
  EXPECT_NE(failure_of([&] {
              problem.solve({{"n", "3 kg"}});
            }).find("the problem has no letter or datum 'n'"),
            std::string::npos);
  EXPECT_NE(failure_of([&] {
              problem.solve({{"m", "3 N"}});
            }).find("m is a mass, but 3 N is a force"),
            std::string::npos);
}

TEST_F(ProblemFile, ACheckPassesWhatAgrees) {
  EXPECT_EQ(failures("expect: {letters: {m: 3 kg}, a: {value: [0, 0.12, 0], unit: kg*m^2/s}, b: {formula: m*r^2}}\n"),
            std::vector<std::string>{"b: expected a moment of inertia, but the answer is a moment or an energy"});
  EXPECT_EQ(
      failures(
          "expect: {letters: {m: 3 kg}, a: {value: [0, 0.12, 0], unit: kg*m^2/s}, b: {formula: m*r^2*(1 rad/s)^2}}\n"),
      std::vector<std::string>{});
  EXPECT_EQ(
      failures("expect: {letters: {m: 3 kg}, a: {value: [0, 120, 0], unit: g*m^2/s}, b: {value: 0.12, unit: J}}\n"),
      std::vector<std::string>{});
}

TEST_F(ProblemFile, ACheckNamesWhatFallsShort) {
  EXPECT_EQ(failures(""), std::vector<std::string>{"it has no expect block"});
  const auto leaves_out = failures("expect: {letters: {m: 3 kg}, a: {value: [0, 0.12, 0], unit: kg*m^2/s}}\n");
  EXPECT_EQ(leaves_out, std::vector<std::string>{"b: the expect block leaves it out"});
  const auto off = failures(
      "expect: {letters: {m: 3 kg}, a: {value: [0, 0.12001, 0], unit: kg*m^2/s}, b: {value: 0.12, unit: J}}\n");
  ASSERT_EQ(off.size(), 1U);
  EXPECT_TRUE(off[0].starts_with("a")) << off[0];
  // Letters without value have no answer to compare.
  EXPECT_FALSE(failures("expect: {a: {value: [0, 0.12, 0], unit: kg*m^2/s}, b: {value: 0.12, unit: J}}\n").empty());
  // A value in another kind of unit is no agreement, whatever its number.
  EXPECT_FALSE(
      failures("expect: {letters: {m: 3 kg}, a: {value: [0, 0.12, 0], unit: N*m}, b: {value: 0.12, unit: J}}\n")
          .empty());
}

TEST_F(ProblemFile, SeveralCasesLookAtDifferentLetters) {
  const std::string a = "a: {value: [0, 0.12, 0], unit: kg*m^2/s}", b = "b: {value: 0.24, unit: J}";
  EXPECT_EQ(
      failures("expect: {cases: {light: {letters: {m: 3 kg}, " + a + "}, heavy: {letters: {m: 6 kg}, " + b + "}}}\n"),
      std::vector<std::string>{});
  const auto off =
      failures("expect: {cases: {light: {letters: {m: 3 kg}, " + a + "}, heavy: {letters: {m: 5 kg}, " + b + "}}}\n");
  ASSERT_EQ(off.size(), 1U);
  EXPECT_TRUE(off[0].starts_with("case heavy: b")) << off[0];
}

TEST_F(ProblemFile, SaysWhatItStates) {
  const Problem problem = Problem::from_text(
      "title: Two\ngiven: {r: 200 mm, A: 'm/r^2', c: [0, r, 0]}\nletters: {m: kg, n: rpm}\n"
      "find: {T: N, M: {vector: N*m}}\nbodies: {p: {particle: c, mass: m}}\n"
      "loads: {f: {body: p, at: c, force: [T, 0, 0]}, k: {body: p, couple: M}}\n"
      "situations: {one: {given: {r: 300 mm}}, two: {}}\n"
      "ask: {x: mass(p) @ one}\nclaim: {y: {claim: m > 0, situation: two}}\nexpect: {x: {formula: m}}\n",
      "two.yaml");
  EXPECT_EQ(problem.name(), "two.yaml");
  EXPECT_EQ(problem.title(), "Two");
  ASSERT_EQ(problem.situations().size(), 2U);
  const StatedSituation& one = problem.situations()[0];
  EXPECT_EQ(one.name, "one");
  ASSERT_EQ(one.data.size(), 3U);
  EXPECT_EQ(one.data[0].name + " " + one.data[0].text + " " + one.data[0].unit, "r 300 mm mm");
  EXPECT_EQ(one.data[1].name + " " + one.data[1].text + " " + one.data[1].unit, "A m/r^2 ");
  EXPECT_EQ(one.data[2].text, "[0, r, 0]");
  EXPECT_EQ(problem.situations()[1].data[0].text, "200 mm");
  ASSERT_EQ(one.letters.size(), 2U);
  EXPECT_EQ(one.letters[1].name + " " + one.letters[1].unit, "n rpm");
  ASSERT_EQ(one.unknowns.size(), 2U);
  EXPECT_EQ(one.unknowns[0].name + " " + one.unknowns[0].unit, "T N");
  EXPECT_FALSE(one.unknowns[0].vector);
  EXPECT_TRUE(one.unknowns[1].vector);
  ASSERT_EQ(problem.questions().size(), 1U);
  EXPECT_EQ(problem.questions()[0].name + ": " + problem.questions()[0].text, "x: mass(p) @ one");
  ASSERT_EQ(problem.claims().size(), 1U);
  EXPECT_EQ(problem.claims()[0].name + ": " + problem.claims()[0].text, "y: m > 0");
  EXPECT_TRUE(problem.expects());
  EXPECT_FALSE(problem.records());
}

TEST_F(ProblemFile, AnErrorHasItsPlace) {
  try {
    Problem::from_text("title: A\ngiven: {r: 3 kgg}\n", "a.yaml");
    FAIL() << "no error";
  } catch (const StatementError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    const Diagnostic& one = error.diagnostics().front();
    EXPECT_EQ(one.file, "a.yaml");
    EXPECT_EQ(one.line, 2);
    EXPECT_EQ(one.column, 14);
    EXPECT_FALSE(one.message.empty());
    EXPECT_TRUE(std::string(error.what()).starts_with("a.yaml:2:14: error: " + one.message)) << error.what();
  }
}

TEST_F(ProblemFile, AnExplanationStandsInTheDocumentWhereItIsAskedFor) {
  const Problem problem = Problem::from_text(disk, "disk.yaml");
  const std::string with = to_markdown(problem.explain({{"m", "3 kg"}})),
                    without = to_markdown(problem.solve({{"m", "3 kg"}}));
  EXPECT_EQ(without.find("## Answers"), without.find("## "));
  EXPECT_LT(with.find("## "), with.find("## Answers"));
  EXPECT_TRUE(with.ends_with(without.substr(without.find("## Answers"))));
}

TEST_F(ProblemFile, EquationsAreWrittenInTheFormAskedFor) {
  const Problem problem = Problem::from_text(disk, "disk.yaml");
  const std::string c =
      problem.equations({.parts = {EquationPart::mass_matrix}, .form = EquationForm::c, .function = "disk"});
  EXPECT_NE(c.find("void disk("), std::string::npos) << c;
  EXPECT_NE(problem.equations({.form = EquationForm::python}).find("def equations("), std::string::npos);
  EXPECT_THROW(problem.equations({.function = "a b"}), std::invalid_argument);
  EXPECT_FALSE(is_function_name("a b"));
  EXPECT_TRUE(is_function_name("a_b"));
  EXPECT_NE(failure_of([&] { problem.equations({.situation = "nowhere"}); }).find("nowhere"), std::string::npos);
}

// A vector is told as the file writes it, in the plane by two components.
TEST_F(ProblemFile, QuestionsWithVectorsAreToldInWords) {
  EXPECT_EQ(Problem::from_text(disk, "disk.yaml").solve().solutions.at(0).answers.at(0).words,
            "angular momentum of disk about [0, 0, 0]");
  const Document planar =
      Problem::from_text(
          "plane: [x, y]\ngiven: {b: 30 deg}\ngravity: none\nbodies: {bob: {particle: [0 m, 0 m], mass: 1 kg}}\n"
          "instants: {now: {velocity(bob): [3 m/s, 0 m/s]}}\n"
          "ask: {u: 'dot(velocity(bob) with [cos(b), sin(b)])'}\n",
          "bob.yaml")
          .solve();
  EXPECT_EQ(planar.solutions.at(0).answers.at(0).words,
            "scalar product of velocity of the mass center of bob and [cos(b), sin(b)]");
}

TEST_F(ProblemFile, CopiesAreTheSameProblem) {
  Problem problem = Problem::from_text(disk, "disk.yaml");
  const Problem copy = problem;
  problem = Problem::from_text("title: Other\n", "other.yaml");
  EXPECT_EQ(problem.title(), "Other");
  EXPECT_EQ(copy.title(), "A disk");
  EXPECT_EQ(to_json(copy.solve()), to_json(Problem::from_text(disk, "disk.yaml").solve()));
}

}  // namespace problem_test
}  // namespace poinsot::document
