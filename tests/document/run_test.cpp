#include "document/run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "problem/language/diagnostic.h"
#include "problem/language/failure.h"

namespace poinsot::document {
namespace {

using problem::failure_of;
namespace fs = std::filesystem;

// A disk of 3 kg and 0.2 m that turns with 2 rad/s about its axis: H = 0.12 kg m^2/s, T = 0.12 J.
const std::string disk =
    "title: A disk\nletters: {m: kg}\ngiven: {r: 0.2 m}\n"
    "bodies: {disk: {disk: {center: [0, 0, 0], normal: y, radius: r}, mass: m}}\n"
    "joints: {shaft: {revolute: y, at: [0, 0, 0], to: disk, rate: 2 rad/s}}\n"
    "ask: {a: \"angular_momentum(disk about [0, 0, 0])\", b: {of: kinetic_energy(disk), unit: J}}\n";

class Run : public ::testing::Test {
 protected:
  Run() : folder_(fs::temp_directory_path() / ("poinsot_run_test_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Run() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::vector<std::string> failures(const std::string& expect) const {
    const std::vector<CheckResult> results = check_paths({file("one.yaml", disk + expect)});
    EXPECT_EQ(results.size(), 1U);
    return results.at(0).failures;
  }

  fs::path folder_;
};

TEST_F(Run, AFileBecomesADocument) {
  const Document document = run_file(file("disk.yaml", disk), {{{"m", "1 kg"}, {"m", "3 kg"}}});
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

TEST_F(Run, OpenLettersStandInTheDocument) {
  const Document document = run_file(file("disk.yaml", disk), {});
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

TEST_F(Run, DataTakeOtherValues) {
  const Document document = run_file(file("disk.yaml", disk), {{{"m", "3 kg"}, {"r", "400 mm"}}});
  EXPECT_NEAR(std::get<double>(document.solutions.at(0).answers.at(1).si.content), 0.48, 1e-14);
}

TEST_F(Run, WrongFilesAndSettingsAreErrors) {
  const std::string missing = (folder_ / "missing.yaml").string();
  EXPECT_EQ(failure_of([&] { run_file(missing, {}); }),
            missing + ":1:1: error: there is no such file (check the path)");
  EXPECT_NE(failure_of([&] { run_file(folder_.string(), {}); }).find("this is a folder, not a problem file"),
            std::string::npos);
  const std::string path = file("disk.yaml", disk);
  EXPECT_NE(failure_of([&] {
              run_file(path, {{{"n", "3 kg"}}});
            }).find("the problem has no letter or datum 'n'"),
            std::string::npos);
  EXPECT_NE(failure_of([&] {
              run_file(path, {{{"m", "3 N"}}});
            }).find("m is a mass, but 3 N is a force"),
            std::string::npos);
}

TEST_F(Run, ACheckPassesWhatAgrees) {
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

TEST_F(Run, ACheckNamesWhatFallsShort) {
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

TEST_F(Run, SeveralCasesLookAtDifferentLetters) {
  const std::string a = "a: {value: [0, 0.12, 0], unit: kg*m^2/s}", b = "b: {value: 0.24, unit: J}";
  EXPECT_EQ(
      failures("expect: {cases: {light: {letters: {m: 3 kg}, " + a + "}, heavy: {letters: {m: 6 kg}, " + b + "}}}\n"),
      std::vector<std::string>{});
  const auto off =
      failures("expect: {cases: {light: {letters: {m: 3 kg}, " + a + "}, heavy: {letters: {m: 5 kg}, " + b + "}}}\n");
  ASSERT_EQ(off.size(), 1U);
  EXPECT_TRUE(off[0].starts_with("case heavy: b")) << off[0];
}

TEST_F(Run, FoldersAreCheckedFileByFile) {
  const std::string good =
      disk + "expect: {letters: {m: 3 kg}, a: {value: [0, 0.12, 0], unit: kg*m^2/s}, b: {value: 0.12, unit: J}}\n";
  file("folder/b.yaml", good);
  file("folder/a/c.yaml", "title: [\n");
  file("folder/notes.txt", "no problem");
  const std::vector<CheckResult> results = check_paths({(folder_ / "folder").string()});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_TRUE(results[0].file.ends_with("a/c.yaml"));
  ASSERT_EQ(results[0].failures.size(), 1U);
  EXPECT_NE(results[0].failures[0].find("c.yaml:"), std::string::npos);
  EXPECT_TRUE(results[1].failures.empty());
  EXPECT_NE(failure_of([&] { check_paths({(folder_ / "nowhere").string()}); }).find("there is no such file"),
            std::string::npos);
}

}  // namespace
}  // namespace poinsot::document
