#include "problem/entries/read_choices.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <vector>

#include "problem/keys/reader.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

Choice read_choice(const Key& name, const Entry& entry, const std::string& file) {
  check_name(name.text, name.mark, file);
  const Members choice(entry, file, {"choice"});
  Choice stated;
  stated.name = name.text;
  stated.mark = name.mark;
  const Entry& of = choice.require("of", "of: [A, B, C, D]");
  if (of.kind != Entry::Kind::list) fail(file, of.mark, "expected a list of names", "write of: [A, B, C, D]");
  for (const Entry& item : of.items) stated.of.push_back(scalar_text(item, file, "a name"));
  if (stated.of.size() > 16) fail(file, of.mark, "a choice among more than 16 things is too large");
  if (const Entry* least = choice.find("least")) {
    if (choice.find("exactly"))
      fail(file, choice.mark_of("least"), "a choice states `exactly` or `least`, not both", "remove one of them");
    if (scalar_text(*least, file, "the word total") != "total")
      fail(file, least->mark, "'" + least->text + "' is nothing of which the least can be chosen",
           "write least: total, for the least sum of their amounts");
    stated.least_total = true;
    return stated;
  }
  const std::string& count =
      scalar_text(choice.require("exactly", "exactly: 2, or least: total"), file, "a whole number");
  const char* const end = count.data() + count.size();
  const auto read = std::from_chars(count.data(), end, stated.exactly);
  if (read.ec != std::errc() || read.ptr != end || stated.exactly < 0 ||
      static_cast<std::size_t>(stated.exactly) > stated.of.size())
    fail(file, choice.mark_of("exactly"),
         "'" + count + "' is no number of things among " + std::to_string(stated.of.size()));
  return stated;
}

void check_choices(Situation& situation) {
  std::vector<std::string> added, all;
  for (const Body& body : situation.bodies)
    for (const Part& part : body.added) added.push_back(part.name);
  all = added;
  for (const Impulse& impulse : situation.impulses) all.push_back(impulse.name);
  for (const Load& load : situation.loads) all.push_back(load.name);
  for (const Choice& choice : situation.choose)
    for (const std::string& name : choice.of)
      if (std::find(all.begin(), all.end(), name) == all.end())
        fail(situation.file, choice.mark, "'" + name + "' is no impulse, load or added mass", did_you_mean(name, all));
  for (const std::string& name : situation.without)
    if (std::find(added.begin(), added.end(), name) == added.end())
      fail(situation.file, Mark{1, 1}, "without: '" + name + "' is no added mass", did_you_mean(name, added));
  for (Body& body : situation.bodies)
    std::erase_if(body.added, [&](const Part& part) {
      return std::find(situation.without.begin(), situation.without.end(), part.name) != situation.without.end();
    });
}

}  // namespace poinsot::problem
