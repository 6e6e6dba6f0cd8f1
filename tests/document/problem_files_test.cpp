// A problem from memory to its document: no disk, each file that it names read once.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "document/failure.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace problem_files_test {

// Files in memory, which are counted as they are read.
class InMemory : public FileProvider {
 public:
  explicit InMemory(std::map<std::string, std::string> files) : files_(std::move(files)) {}
  std::string bytes(const std::string& name) const override {
    ++reads[name];
    const auto found = files_.find(name);
    if (found == files_.end()) throw FileError("nobody has it", "ask for another");
    return found->second;
  }
  mutable std::map<std::string, int> reads;

 private:
  std::map<std::string, std::string> files_;
};

// A tetrahedron with edges of one along the axes: its mass center is at a quarter of them.
const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

double number(const Document& document, std::size_t answer) {
  return std::get<double>(document.solutions.at(0).answers.at(answer).si.content);
}

// The mass of a tetrahedron of edge 1 m and density 6 kg/m^3 is 1 kg, of edge 1 mm a billionth of that.
TEST(ProblemFiles, ComeFromTheProviderAndAreReadOnce) {
  const InMemory files({{"parts/t.obj", tetrahedron}});
  const Problem problem = Problem::from_text(
      "title: Two in three\ngiven: {s: 2 m}\n"
      "bodies:\n"
      "  large: {mesh: {file: parts/t.obj, unit: m, at: [s, 0, 0]}, density: 6 kg/m^3}\n"
      "  again: {mesh: {file: parts/t.obj, unit: m}, density: 6 kg/m^3}\n"
      "  small: {mesh: {file: parts/t.obj, unit: mm}, density: 6 kg/m^3}\n"
      "situations: {here: {}, there: {given: {s: 3 m}}}\n"
      "ask: {a: mass(large) @ here, b: center(large).x @ here, c: center(large).x @ there, d: center(again).x @ here, "
      "e: mass(small) @ here, f: 'moment_of_inertia(large about z at [2.25 m, 0.25 m, 0]) @ here'}\n",
      "nowhere/two.yaml", files);
  const Document document = problem.solve();
  ASSERT_TRUE(fully_answered(document)) << to_json(document);
  EXPECT_NEAR(number(document, 0), 1, 1e-14);
  EXPECT_NEAR(number(document, 1), 2.25, 1e-14);
  EXPECT_NEAR(number(document, 2), 3.25, 1e-14);
  EXPECT_NEAR(number(document, 3), 0.25, 1e-14);
  EXPECT_NEAR(number(document, 4), 1e-9, 1e-22);
  // Two of the squares' means about the center, 3/80 of the edge's square each.
  EXPECT_NEAR(number(document, 5), 0.075, 1e-14);
  // The body as particles, which come from the same triangles on another road.
  for (const auto& [name, residual] : document.solutions.at(0).checks) EXPECT_LT(residual, 1e-12) << name;
  problem.solve({{"s", "5 m"}});
  EXPECT_EQ(files.reads, (std::map<std::string, int>{{"parts/t.obj", 1}}));
}

// Where an unknown places the mesh, the machine is built hundreds of times.
TEST(ProblemFiles, AreReadOnceForAnUnknown) {
  const InMemory files({{"t.OBJ", tetrahedron}});
  const Problem problem = Problem::from_text(
      "title: Unknown place\nfind: {s: m}\nwhere: [s > 0]\n"
      "bodies: {t: {mesh: {file: t.OBJ, unit: m, at: [s, 0, 0]}, density: 6 kg/m^3}}\n"
      "facts: {'moment_of_inertia(t about z at [0, 0, 0])': 4.2 kg*m^2}\nask: {x: center(t).x}\n",
      "unknown.yaml", files);
  const Document document = problem.solve();
  ASSERT_EQ(document.solutions.size(), 1U) << to_json(document);
  // 0.075 + 0.25^2 + x^2 = 4.2, all in kg m^2 and m.
  EXPECT_NEAR(number(document, 0) * number(document, 0), 4.2 - 0.075 - 0.0625, 1e-9);
  EXPECT_EQ(files.reads.at("t.OBJ"), 1);
}

TEST(ProblemFiles, ThatCannotBeHadAreErrorsAtTheirPlace) {
  const InMemory files({{"open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n"}, {"junk.stl", "junk"}, {"t.ply", ""}});
  const auto failure = [&](const std::string& file, const std::string& unit) {
    return failure_of([&] {
      Problem::from_text(
          "title: t\nbodies: {t: {mesh: {file: " + file + ", unit: " + unit + "}, mass: 1 kg}}\nask: {a: mass(t)}\n",
          "t.yaml", files);
    });
  };
  EXPECT_EQ(failure("no.stl", "m"), "t.yaml:2:20: error: mesh 'no.stl': nobody has it (ask for another)");
  EXPECT_NE(failure("open.obj", "m").find("a body needs a closed surface"), std::string::npos);
  EXPECT_TRUE(failure("junk.stl", "m").starts_with("t.yaml:2:20: error: mesh 'junk.stl'")) << failure("junk.stl", "m");
  EXPECT_EQ(failure("t.ply", "m"),
            "t.yaml:2:20: error: mesh 't.ply': unknown kind of mesh file; expected a name that ends in .stl or .obj");
  EXPECT_EQ(failure("no.stl", "kg"), "t.yaml:2:20: error: the unit of a mesh is a unit of length, not a mass");
  EXPECT_EQ(files.reads, (std::map<std::string, int>{{"junk.stl", 1}, {"no.stl", 1}, {"open.obj", 1}}));
}

}  // namespace problem_files_test
}  // namespace poinsot::document
