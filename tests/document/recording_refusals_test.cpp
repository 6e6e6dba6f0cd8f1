#include <nlohmann/json.hpp>

#include "document/failure.h"
#include "document/recording_support.h"

namespace poinsot::document {
namespace recording_refusals_test {

using Fault = RecordingError::Fault;

TEST_F(Recorded, AFailureOnTheWayLeavesTheRowsBeforeIt) {
  const std::string text =
      pendulum + "record: {every: 1 ms, for: 2 s, columns: {t: time, r: \"sqrt(0.7 s - time)\"}}\n";
  const std::string what = failure_of([&] { record(text, "a.csv"); });
  EXPECT_NE(what.find("problem.yaml:8:"), std::string::npos) << what;
  EXPECT_NE(what.find("sqrt"), std::string::npos) << what;
  EXPECT_EQ(rows(path("a.csv")).size(), 500U);
  EXPECT_TRUE(bytes(path("a.csv")).ends_with("# incomplete: 500 rows of 2001\r\n"));
}

TEST_F(Recorded, AJournalOfAnythingElseIsKept) {
  const Recording first = record(pendulum + pendulum_record, "a.csv");
  const std::string journal = bytes(first.journal), data = bytes(first.data);
  const std::string begin = first.journal + " is not overwritten, it holds a recording ",
                    advice = ": move it away, or record to another file";
  EXPECT_EQ(refusal(pendulum + "record: {every: 1 ms, for: 3 s, columns: {t: time}}\n", "a.csv", {}, Fault::caller),
            begin + "of another problem, or of an older text of it" + advice);
  EXPECT_EQ(refusal(pendulum + pendulum_record, "a.csv", {.sets = {{"b", "41 deg"}}}, Fault::caller),
            begin + "with other settings" + advice);
  EXPECT_EQ(bytes(first.journal), journal);
  EXPECT_EQ(bytes(first.data), data);

  RecordingHead old = head_of(Journal(first.journal).head().value());
  old.program = "poinsot 0.0.1";
  Journal(first.journal).begin(to_bytes(old));
  EXPECT_EQ(refusal(pendulum + pendulum_record, "a.csv", {}, Fault::caller),
            begin + "by poinsot 0.0.1, and this is poinsot " POINSOT_VERSION + advice);
  Journal(first.journal).begin("what a later version may write");
  EXPECT_EQ(refusal(pendulum + pendulum_record, "a.csv", {}, Fault::caller),
            first.journal + " is not overwritten, it holds a recording by another version of poinsot" + advice);
  file("a.csv.journal", "poinsot journal\nand then something");
  EXPECT_EQ(refusal(pendulum + pendulum_record, "a.csv", {}, Fault::caller),
            first.journal + " is not overwritten: it is no journal of a recording" + advice);
  EXPECT_EQ(bytes(first.journal), "poinsot journal\nand then something");
}

TEST_F(Recorded, DamageBehindAGoodChecksumIsTold) {
  const Recording first = interrupted(pendulum + pendulum_record, "a.csv", 1);
  {
    Journal journal(first.journal);
    journal.read([](std::string_view) {});
    journal.append("no block");
  }
  const std::string left = bytes(first.journal);
  EXPECT_EQ(refusal(pendulum + pendulum_record, "a.csv", {}, Fault::caller),
            first.journal + " is damaged behind row 500: move it away and record anew");
  EXPECT_EQ(bytes(first.journal), left);
}

TEST_F(Recorded, AMeshIsPartOfTheProblem) {
  const auto tetrahedron = [](const char* height) {
    return std::string("v 0 0 0\nv 1000 0 0\nv 0 1000 0\nv 0 0 ") + height + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  };
  const std::string text =
      "title: A corner\npoints: {O: [0, 0, 0]}\nbodies: {corner: {mesh: {file: corner.obj, unit: mm}, mass: 2 kg}}\n"
      "joints: {pin: {revolute: x, at: O, to: corner, angle: a}}\ngravity: -z\ninstants: {start: rest}\n"
      "record: {every: 10 ms, for: 1 s, columns: {a: a}}\n";
  file("corner.obj", tetrahedron("1000"));
  const Recording first = record(text, "a.csv");
  EXPECT_EQ(record(text, "a.csv").resumed_at, first.rows);
  file("corner.obj", tetrahedron("1001"));
  EXPECT_NE(refusal(text, "a.csv", {}, Fault::caller).find("it holds a recording with another mesh"),
            std::string::npos);
}

TEST_F(Recorded, WhatHasNoAnswerIsNotRecorded) {
  const std::string name = path("problem.yaml");
  const std::string columns = "record: {every: 1 ms, for: 1 s, columns: {N: norm(reaction(pin))}}\n";
  std::string open = pendulum;
  open.replace(open.find("mass: 2 kg"), 10, "mass: any");
  EXPECT_EQ(refusal(open + columns, "a.csv", {}, Fault::problem).substr(0, name.size() + 40),
            name + ": what is to be recorded has no answer: ");
  std::string letters = pendulum;
  letters.replace(letters.find("mass: 2 kg"), 10, "mass: m");
  EXPECT_EQ(refusal(letters + "letters: {m: kg}\n" + columns, "a.csv", {}, Fault::problem),
            name + ": what is to be recorded needs values for m: --set 'm=...'");
  EXPECT_TRUE(record(letters + "letters: {m: kg}\n" + columns, "a.csv", {.sets = {{"m", "3 kg"}}}).complete);
  // Nothing of what is refused leaves a file.
  fs::remove(path("a.csv"));
  fs::remove(path("a.csv.journal"));
  refusal(open + columns, "a.csv", {}, Fault::problem);
  EXPECT_FALSE(fs::exists(path("a.csv.journal")));
}

TEST_F(Recorded, WhatIsWrongIsSaidAtItsPlace) {
  const std::string name = path("problem.yaml");
  const auto message = [&](const std::string& record_text) {
    return failure_of([&] { record(pendulum + record_text + "\n", "a.csv"); });
  };
  EXPECT_EQ(failure_of([&] { record(pendulum + "ask: {a: theta}\n", "a.csv"); }),
            name +
                ":1:1: error: the file does not say what to record (write record: {every: 1 ms, for: 10 s, columns: "
                "{t: time, theta: theta}})");
  EXPECT_EQ(message("record: {for: 1 s, columns: {t: time}}"),
            name + ":8:9: error: a record needs the key 'every' (write every: 1 ms)");
  EXPECT_EQ(
      message("record: {every: 1 ms, for: 1 s}"),
      name +
          ":8:9: error: a record needs the key 'columns' (write columns: {t: time, w: norm(angular_velocity(disk))})");
  EXPECT_EQ(message("record: {every: 1 ms, columns: {t: time}}"),
            name + ":8:9: error: the motion has no end (say how long it is recorded: for: 10 s)");
  EXPECT_EQ(message("record: {every: 0 s, for: 1 s, columns: {t: time}}"),
            name + ":8:17: error: the rows of a recording need a time between them");
  EXPECT_EQ(message("record: {every: 1 m, for: 1 s, columns: {t: time}}"),
            name + ":8:17: error: expected a time, not a length");
  EXPECT_EQ(message("record: {every: 1 ms, for: -1 s, columns: {t: time}}"),
            name + ":8:28: error: a recording lasts no negative time");
  EXPECT_EQ(message("record: {every: 1e-15 s, for: 10 s, columns: {t: time}}"),
            name + ":8:17: error: the recording would have more rows than can be counted (take a larger step)");
  EXPECT_EQ(message("record: {every: 1 ms, for: 1 s, columns: {'a/b': time}}"),
            name +
                ":8:43: error: 'a/b' cannot name a column (such names are letters, digits and _ . ' -, and begin with "
                "a letter)");
  EXPECT_EQ(message("record: {every: 1 ms, for: 1 s, columns: {t: time}, unit: {u: s}}"),
            name + ":8:60: error: there is no column 'u'");
  EXPECT_EQ(message("record: {every: 1 ms, for: 1 s, columns: {t: time, P: position(P of bob)}}"),
            name + ":8:52: error: column 'P' is no number (ask for a component such as .x, or norm(...))");
  EXPECT_EQ(message("record: {every: 1 ms, for: 1 s, columns: {t: tim}}"), name + ":8:46: error: 'tim' is not defined");
  EXPECT_EQ(message("record: {each: 1 ms}"),
            name + ":8:10: error: unknown key 'each' in a record (known keys: columns, every, for, unit, axes)");
  EXPECT_EQ(message("situations: {a: {record: {every: 1 s}}}"),
            name + ":8:18: error: 'record' cannot stand in a situation (it belongs at the top of the file)");
  EXPECT_EQ(
      message("situations: {s: {given: {b: 1 deg}}, u: {given: {b: 2 deg}}}\n"
              "record: {every: 1 ms, for: 1 s, columns: {t: time}}"),
      name + ":9:9: error: a recording is of a file with one situation (state the situations in files of their own)");
  EXPECT_FALSE(fs::exists(path("a.csv.journal")));
}

TEST_F(Recorded, TooMuchIsRefusedBeforeItBegins) {
  EXPECT_EQ(
      refusal(pendulum + "record: {every: 1e-9 s, for: 10 s, columns: {t: time}}\n", "a.csv", {}, Fault::caller),
      "the recording would have more than 1000000000 numbers (1 columns): record for a shorter time, or less often");
  EXPECT_FALSE(fs::exists(path("a.csv")));
}

TEST_F(Recorded, AnyValueAtAnyKeyIsARecordingOrAnError) {
  using Json = nlohmann::ordered_json;
  const Json good = {{"every", "0.1 s"},
                     {"for", "1 s"},
                     {"columns", {{"t", "time"}, {"a", "theta"}}},
                     {"unit", {{"t", "s"}}},
                     {"axes", "bob"}};
  std::vector<Json> values = {nullptr,
                              true,
                              0,
                              -1,
                              1e308,
                              Json::array(),
                              Json::object(),
                              Json::array({1, 2, 3}),
                              Json{{"t", "any"}},
                              Json{{"t", Json::array({1})}}};
  for (const char* text : {"", "any", "none", "rest", "x", "bob", "ground", "3 m", "-3 s", "1e308 s", "1e-308 s", "nan",
                           "1/0", "sqrt(-1)", "theta @ 1 s", "max(theta)", "((((", "t", "{"})
    values.emplace_back(text);
  int recorded = 0, refused = 0;
  const auto attempt = [&](const Json& one) {
    try {
      record(pendulum + "record: " + one.dump() + "\n", "a.csv");
      ++recorded;
    } catch (const StatementError& error) {
      EXPECT_NE(std::string(error.what()).find("problem.yaml:"), std::string::npos);
      ++refused;
    } catch (const RecordingError&) {
      ++refused;
    }
    fs::remove(path("a.csv.journal"));
    fs::remove(path("a.csv"));
  };
  for (const Json& value : values) {
    for (const char* key : {"every", "for", "columns", "unit", "axes"}) {
      Json one = good;
      one[key] = value;
      attempt(one);
    }
    for (const char* key : {"columns", "unit"}) {
      Json one = good;
      one[key]["t"] = value;
      attempt(one);
    }
    attempt(value);
  }
  EXPECT_GT(recorded, 4);
  EXPECT_GT(refused, 50);
}

}  // namespace recording_refusals_test
}  // namespace poinsot::document
