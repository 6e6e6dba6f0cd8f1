#include "problem/entries/read_asks.h"

#include <algorithm>
#include <charconv>

#include "problem/entries/read_claims.h"
#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

// The text of an ask as its author wrote it.
std::string written(const Entry& entry) {
  if (entry.kind == Entry::Kind::scalar) return entry.text;
  std::string text;
  for (const Entry& item : entry.items) text += (text.empty() ? "[" : ", ") + written(item);
  return text.empty() ? "" : text + "]";
}

// Reads {largest: w, while: stable(plate), situation: hanging}.
Extremum read_extremum(const Members& members, const Key& ask, const std::string& file) {
  Extremum extremum;
  extremum.largest = members.find("largest") != nullptr;
  const char* key = extremum.largest ? "largest" : "smallest";
  for (const char* other : {"of", "axes", extremum.largest ? "smallest" : "axes"})
    if (members.find(other))
      fail(file, members.mark_of(other),
           "ask '" + ask.text + "' asks for the " + key + " value of a datum: no " + other,
           "write {" + std::string(key) + ": w, while: stable(plate)}");
  extremum.name = scalar_text(*members.find(key), file, "the name of a datum or letter");
  extremum.name_mark = members.mark_of(key);
  const Entry& conditions = members.require("while", "while: stable(plate)");
  if (conditions.kind == Entry::Kind::list)
    extremum.conditions = expression_list(conditions, file);
  else
    extremum.conditions.push_back(parse_expression(conditions, file));
  if (extremum.conditions.empty()) fail(file, conditions.mark, "no condition stands under while:");
  if (const Entry* situation = members.find("situation")) {
    extremum.situation = scalar_text(*situation, file, "the name of a situation");
    extremum.situation_mark = members.mark_of("situation");
  }
  return extremum;
}

// Reads {table: {t: time, Ay: reaction(A).y}, over: {time: 0 s .. 2 s by 0.2 s}}.
Table read_table(const Members& members, const std::string& file) {
  Table table;
  const Entry& columns = members.require("table", "table: {t: time, w: norm(angular_velocity(disk))}");
  if (columns.kind != Entry::Kind::map || columns.members.empty())
    fail(file, columns.mark, "expected columns: a name and what stands in it, each",
         "write table: {t: time, w: norm(angular_velocity(disk))}");
  for (const auto& [column, value] : columns.members)
    table.columns.push_back({column.text, parse_expression(value, file), column.mark});
  const Entry& over = members.require("over", "over: {time: 0 s .. 2 s by 0.2 s}");
  if (over.kind != Entry::Kind::map || over.members.size() != 1)
    fail(file, over.mark, "a table runs over one thing: time, a coordinate or a datum",
         "write over: {time: 0 s .. 2 s by 0.2 s}");
  table.over = over.members.front().first.text;
  table.over_mark = over.members.front().first.mark;
  if (is_name(table.over)) table.over_value = parse_expression(table.over, file, table.over_mark);
  table.values = parse_expression(over.members.front().second, file);
  if (!table.values.as<Range>() && !table.values.as<List>())
    fail(file, over.members.front().second.mark, "a table runs over a range or a list of values",
         "write 0 s .. 2 s by 0.2 s, or [0 s, 0.5 s, 1 s]");
  if (const Entry* units = members.find("unit")) {
    if (units->kind != Entry::Kind::map)
      fail(file, units->mark, "a table has a unit for each column", "write unit: {t: s, w: rpm}");
    for (const auto& [column, unit] : units->members) {
      if (std::none_of(table.columns.begin(), table.columns.end(),
                       [&, &column = column](const NamedExpression& known) { return known.name == column.text; }))
        fail(file, column.mark, "the table has no column '" + column.text + "'");
      table.units.emplace(column.text, read_unit(unit, file));
    }
  }
  return table;
}

// Reads {first_time: reaction(A).z == 0} or {times: ..., from: 0 s, to: 4 s}.
WhenAsk read_when(const Members& members, const std::string& file) {
  WhenAsk when;
  when.first = members.find("first_time") != nullptr;
  if (when.first && members.find("times"))
    fail(file, members.mark_of("times"), "an ask is for the first time or for all times, not both");
  when.condition = *members.expression(when.first ? "first_time" : "times");
  const At* at = when.condition.as<At>();  // @ situation
  const Call* call = (at ? at->expression : when.condition).as<Call>();
  const bool of_state =
      call && (call->function == "sticking" || call->function == "sliding" || call->function == "parting" ||
               call->function == "touching" || call->function == "taut");
  if (!when.condition.as<Comparison>() && !of_state)
    fail(file, when.condition.mark(), "when something happens is told by a comparison",
         "write first_time: reaction(A).z == 0, or touching(floor)");
  when.from = members.expression("from");
  when.to = members.expression("to");
  if (!when.first && !when.to)
    fail(file, members.mark_of("times"), "all times of an endless motion are too many", "write to: 4 s");
  return when;
}

}  // namespace

Ask read_ask(const Key& name, const Entry& entry, const std::string& file) {
  Ask ask;
  ask.name = name.text;
  ask.mark = name.mark;
  const Entry* of = &entry;
  if (entry.kind == Entry::Kind::map) {
    if (entry.find("largest") || entry.find("smallest"))
      for (const auto& [key, value] : entry.members)
        if (key.text == "when" || key.text == "if" || key.text == "until")
          fail(file, key.mark, "unknown key '" + key.text + "' in an ask",
               "what is to hold up to there stands under 'while:'");
    const Members members(entry, file, {"ask"});
    if (members.find("largest") || members.find("smallest")) {
      ask.extremum = read_extremum(members, name, file);
      if (const Entry* unit = members.find("unit")) ask.unit = read_unit(*unit, file);
      ask.text = std::string(ask.extremum->largest ? "largest " : "smallest ") + ask.extremum->name + " while ";
      for (std::size_t i = 0; i < ask.extremum->conditions.size(); ++i)
        ask.text += (i > 0 ? " and " : "") + to_string(ask.extremum->conditions[i]);
      if (!ask.extremum->situation.empty()) ask.text += " @ " + ask.extremum->situation;
      return ask;
    }
    const auto refuse = [&](const char* kind, std::initializer_list<const char*> others) {
      for (const char* other : others)
        if (members.find(other))
          fail(file, members.mark_of(other),
               "ask '" + name.text + "' asks for " + kind + ": no " + other + " stands beside it");
    };
    if (members.find("table")) {
      refuse("a table", {"of", "first_time", "times", "from", "to", "while", "situation"});
      ask.table = read_table(members, file);
      ask.axes = members.expression("axes");
      ask.text = "table over " + ask.table->over + ":";
      for (const NamedExpression& column : ask.table->columns) ask.text += " " + column.name;
      return ask;
    }
    if (members.find("first_time") || members.find("times")) {
      refuse("a time", {"of", "table", "over", "while", "situation"});
      ask.when = read_when(members, file);
      ask.axes = members.expression("axes");
      if (const Entry* unit = members.find("unit")) ask.unit = read_unit(*unit, file);
      ask.text = std::string(ask.when->first ? "first time when " : "times when ") + to_string(ask.when->condition);
      return ask;
    }
    refuse("a quantity", {"over", "from", "to", "while", "situation"});
    of = &members.require("of", "of: angular_momentum(disk about G)");
    if (const Entry* unit = members.find("unit")) ask.unit = read_unit(*unit, file);
    ask.axes = members.expression("axes");
  }
  ask.text = written(*of);
  if (of->kind == Entry::Kind::list) {
    ask.is_list = true;
    ask.of = expression_list(*of, file);
    if (ask.of.empty()) fail(file, of->mark, "ask '" + name.text + "' asks for nothing");
  } else {
    ask.of.push_back(parse_expression(*of, file));
  }
  for (const Expression& expression : ask.of) refuse_compared_words(expression, file);
  return ask;
}

namespace {

double read_number(const Entry& entry, const std::string& file) {
  const std::string& text = scalar_text(entry, file, "a number");
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end || !(number >= 0) || number > 1e300)
    fail(file, entry.mark, "'" + text + "' is not a tolerance", "write a number such as 1e-6");
  return number;
}

Expected read_expected(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"expected"});
  Expected expected;
  expected.part = name.text;
  expected.mark = name.mark;
  expected.roots = members.find("roots") != nullptr;
  if (expected.roots && members.find("value"))
    fail(file, entry.mark, "'" + name.text + "' expects a value and roots", "state one of them");
  expected.value = members.expression(expected.roots ? "roots" : "value");
  expected.formula = members.expression("formula");
  expected.holds = members.boolean("holds");
  if (const Entry* unit = members.find("unit")) expected.unit = read_unit(*unit, file);
  if (const Entry* names = members.find("names")) {
    if (names->kind != Entry::Kind::list) fail(file, names->mark, "expected a list of names");
    expected.names.emplace();
    for (const Entry& item : names->items) expected.names->push_back(scalar_text(item, file, "a name"));
  }
  if (const Entry* columns = members.find("columns")) {
    if (columns->kind != Entry::Kind::map || columns->members.empty())
      fail(file, columns->mark, "expected columns and their numbers", "write columns: {t: [0 s, 1 s], w: [0, 3.2]}");
    for (const auto& [column, value] : columns->members) {
      expected.columns.push_back({column.text, parse_expression(value, file), column.mark});
      if (!expected.columns.back().value.as<List>()) fail(file, value.mark, "expected a list of numbers");
    }
  }
  if (const Entry* rtol = members.find("rtol")) expected.relative_tolerance = read_number(*rtol, file);
  if (const Entry* atol = members.find("atol")) expected.absolute_tolerance = read_number(*atol, file);
  if (expected.value.has_value() + expected.formula.has_value() + expected.names.has_value() +
          expected.holds.has_value() + !expected.columns.empty() !=
      1)
    fail(file, entry.mark, "'" + name.text + "' expects one of value, formula, names, columns or holds");
  return expected;
}

}  // namespace

// `expect:` holds one case, in which `letters:` gives values to letters, or several cases under `cases:`.
std::vector<ExpectedCase> read_expect(const Entry& entry, const std::string& file) {
  if (entry.kind != Entry::Kind::map) fail(file, entry.mark, "expected parts and what they should be");
  const auto read_case = [&](const Key& name, const Entry& body) {
    ExpectedCase one;
    one.name = name.text;
    one.mark = name.mark;
    if (body.kind != Entry::Kind::map) fail(file, body.mark, "expected parts and what they should be");
    for (const auto& [key, value] : body.members) {
      if (key.text == "cases") continue;
      if (key.text == "letters" || key.text == "set") {
        if (value.kind != Entry::Kind::map) fail(file, value.mark, "expected names and values");
        for (const auto& [letter, amount] : value.members)
          one.sets.emplace_back(letter.text, scalar_text(amount, file, "a value with its unit"));
      } else {
        one.parts.push_back(read_expected(key, value, file));
      }
    }
    return one;
  };
  std::vector<ExpectedCase> cases;
  ExpectedCase whole = read_case(Key{"", entry.mark}, entry);
  const Entry* list = entry.find("cases");
  if (!list || !whole.parts.empty()) cases.push_back(std::move(whole));
  if (list) {
    if (list->kind != Entry::Kind::map) fail(file, list->mark, "expected named cases");
    for (const auto& [key, value] : list->members) cases.push_back(read_case(key, value));
  }
  return cases;
}

}  // namespace poinsot::problem
