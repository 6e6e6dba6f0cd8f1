#include "problem/entries/read_record.h"

#include <algorithm>
#include <cctype>

#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_columns = 1000;

// Data sets of a recording are named after its columns, so that these names are restricted.
void check_column_name(const Key& name, const std::string& file) {
  const auto good = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_.'-").find(c) != std::string_view::npos;
  };
  if (!name.text.empty() && std::isalpha(static_cast<unsigned char>(name.text.front())) != 0 &&
      std::ranges::all_of(name.text, good))
    return;
  fail(file, name.mark, "'" + name.text + "' cannot name a column",
       "such names are letters, digits and _ . ' -, and begin with a letter");
}

}  // namespace

Record read_record(const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"record"});
  Record record;
  record.mark = entry.mark;
  const Entry& columns = members.require("columns", "columns: {t: time, w: norm(angular_velocity(disk))}");
  if (columns.kind != Entry::Kind::map || columns.members.empty())
    fail(file, columns.mark, "expected columns: a name and what stands in it, each",
         "write columns: {t: time, w: norm(angular_velocity(disk))}");
  if (columns.members.size() > most_columns)
    fail(file, columns.mark, "there are more than " + std::to_string(most_columns) + " columns");
  for (const auto& [name, value] : columns.members) {
    check_column_name(name, file);
    record.columns.push_back({name.text, parse_expression(value, file), name.mark});
  }
  record.every = members.require_expression("every", "every: 1 ms");
  record.lasts = members.expression("for");
  record.axes = members.expression("axes");
  if (const Entry* units = members.find("unit")) {
    if (units->kind != Entry::Kind::map)
      fail(file, units->mark, "each column has a unit of its own", "write unit: {t: s, w: rpm}");
    for (const auto& [column, unit] : units->members) {
      std::vector<std::string> known;
      for (const NamedExpression& one : record.columns) known.push_back(one.name);
      if (std::ranges::find(known, column.text) == known.end())
        fail(file, column.mark, "there is no column '" + column.text + "'", did_you_mean(column.text, known));
      record.units.emplace(column.text, read_unit(unit, file));
    }
  }
  return record;
}

}  // namespace poinsot::problem
