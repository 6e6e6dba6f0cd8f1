#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "problem/entries/name_checks.h"
#include "problem/keys/entry_words.h"
#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

void check_coordinates_of(const Situation& situation, const std::set<std::string>& used) {
  std::set<std::string> known;
  for (const NamedExpression& datum : situation.given) known.insert(datum.name);
  for (const Letter& letter : situation.letters) known.insert(letter.name);
  for (const Unknown& unknown : situation.find) known.insert(unknown.name);
  std::vector<std::string> unused;
  std::copy_if(known.begin(), known.end(), std::back_inserter(unused),
               [&](const std::string& name) { return !used.contains(name); });
  if (unused.empty()) return;
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms) {
      const Name* name = freedom.position ? freedom.position->as<Name>() : nullptr;
      if (!name || known.contains(name->name)) continue;
      const std::string near = nearest(name->name, unused);
      if (near.empty()) continue;
      fail(situation.file, freedom.position->mark(),
           "'" + name->name + "' is no datum, and '" + near + "', which is one, is used nowhere",
           "did you mean '" + near + "'? If '" + name->name + "' is to name a coordinate, remove '" + near + "'");
    }
}

}  // namespace

void check_misspelt_coordinates(const Entry& root, const Statement& statement) {
  std::set<std::string> used;
  collect_words(root, Keys::left_out, used);
  for (const Situation& situation : statement.situations) check_coordinates_of(situation, used);
}

}  // namespace poinsot::problem
