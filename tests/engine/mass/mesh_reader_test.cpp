#include "poinsot/engine/mass/mesh_reader.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "engine/mass/mesh_examples.h"
#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace mesh_reader_test {

using testing::near;
using Vector = Vector3<double>;

TriangleMesh<double> sample() {
  return testing::box_mesh(Vector{0.5, -1, 2}, Vector{2, 0, 0}, Vector{0, 1.5, 0}, Vector{0, 0, 0.25});
}

void append(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

// The reader's formats as they are laid down; this machine stores numbers with the low byte first.
std::string binary_stl(const TriangleMesh<double>& mesh, std::string header = "made for a test") {
  header.resize(80, ' ');
  std::string bytes = header;
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  append(bytes, &count, 4);
  for (const auto& t : mesh.triangles) {
    bytes.append(12, '\0');
    for (const auto corner : t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto value = static_cast<float>(mesh.vertices[corner][i]);
        append(bytes, &value, 4);
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string text_stl(const TriangleMesh<double>& mesh) {
  std::ostringstream text;
  text << "solid a part  with words\n";
  for (const auto& t : mesh.triangles) {
    text << "  facet normal 0 0 nan\n    outer loop\n";
    for (const auto corner : t) {
      const auto& v = mesh.vertices[corner];
      text << "      vertex " << v.x << ' ' << v.y << ' ' << v.z << "\n";
    }
    text << "    endloop\n  endfacet\n";
  }
  text << "endsolid a part\n";
  return text.str();
}

void expect_sample(const MeshReadResult& result) {
  ASSERT_TRUE(result.mesh) << result.error.message;
  EXPECT_TRUE(result.error.message.empty());
  EXPECT_EQ(result.mesh->vertices.size(), 8u);
  EXPECT_EQ(result.mesh->triangles.size(), 12u);
  EXPECT_TRUE(find_faults(*result.mesh, "sample").empty());
  EXPECT_TRUE(near(solid_of_mesh(*result.mesh), solid_of_mesh(sample()), 1e-14));
}

MeshReadResult stl(std::string_view bytes, const MeshLimits& limits = {}) {
  return read_mesh(bytes, MeshFormat::stl, "a.stl", limits);
}
MeshReadResult obj(std::string_view bytes, const MeshLimits& limits = {}) {
  return read_mesh(bytes, MeshFormat::obj, "a.obj", limits);
}

TEST(StlReader, ReadsBinaryFiles) {
  expect_sample(stl(binary_stl(sample())));
  // Some programs write "solid" into the header of binary files.
  expect_sample(stl(binary_stl(sample(), "solid but binary")));
  // And bytes after the triangles are passed over.
  expect_sample(stl(binary_stl(sample()) + "tail"));
}

TEST(StlReader, ReadsTextFiles) {
  const std::string text = text_stl(sample());
  expect_sample(stl(text));
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_sample(stl(windows));
  std::string capitals;
  for (const char c : text) capitals += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_sample(stl(" \n\t" + capitals));
  // Plus signs and exponents; two solids in a file are one mesh.
  const auto two =
      stl("solid\nfacet normal 0 0 1 outer loop vertex +1 0 0 vertex 1.5e0 -2E+1 .5 vertex -0 0 1e-400\n"
          "endloop endfacet endsolid x\nsolid y\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 "
          "vertex 0 1 0 endloop endfacet endsolid");
  ASSERT_TRUE(two.mesh) << two.error.message;
  EXPECT_EQ(two.mesh->triangles.size(), 2u);
  // Minus zero, an underflow and zero are one vertex, and (1, 0, 0) occurs twice.
  EXPECT_EQ(two.mesh->vertices.size(), 4u);
  EXPECT_EQ(two.mesh->vertices[1].y, -20);
}

TEST(ObjReader, ReadsVerticesAndFaces) {
  std::ostringstream text;
  text << "# a box\nmtllib x.mtl\no box\n";
  for (const auto& v : sample().vertices) text << "v " << v.x << ' ' << v.y << '\t' << v.z << " 1.0\r\n";
  text << "vn 0 0 1\nvt 0 0\ns off\ng sides\nusemtl steel\n";
  for (const auto& t : sample().triangles)
    text << "f " << t[0] + 1 << "/1 " << t[1] + 1 << "//1 " << t[2] + 1 << "/1/1 # face\n";
  expect_sample(obj(text.str()));
}

TEST(ObjReader, FacesOfManyCornersAndRelativeNumbers) {
  const auto result =
      obj("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 3\nv 2 0 3\nv 2 1 3\nv 0 1 3\n"
          "f -5 -6 -7 -8\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 \\\n 7 6\nf 3 4 8 7\nf 4 1 5 8");
  ASSERT_TRUE(result.mesh) << result.error.message;
  EXPECT_TRUE(find_faults(*result.mesh, "box").empty());
  EXPECT_TRUE(near(solid_of_mesh(*result.mesh), shapes::box_between(Vector{0, 0, 0}, Vector{2, 1, 3}), 1e-14));
}

TEST(StlReader, TellsTheLineOfTextErrors) {
  const std::string facet = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  const std::vector<std::pair<std::string, std::pair<std::string, std::size_t>>> cases{
      {"solid s\nfacet normal 0 0 1\n  outer lop\n", {"a.stl:3: expected 'loop', found 'lop'", 3}},
      {"solid s\nfacets\n", {"a.stl:2: expected 'facet' or 'endsolid', found 'facets'", 2}},
      {"solid s\n", {"a.stl:2: the file ends before 'endsolid'", 2}},
      {"solid s\nfacet normal 0 x 1\n", {"a.stl:2: expected three numbers for the normal, found 'x'", 2}},
      {facet + "vertex 0 1\nendloop", {"a.stl:7: expected three numbers for the vertex, found 'endloop'", 7}},
      {facet + "vertex 0 1 0x1\n", {"a.stl:6: expected three numbers for the vertex, found '0x1'", 6}},
      {facet + "vertex 0 1 +-1\n", {"a.stl:6: expected three numbers for the vertex, found '+-1'", 6}},
      {facet + "vertex 0 1 inf\n", {"a.stl:6: a coordinate of the vertex is not a finite number: 'inf'", 6}},
      {facet + "vertex 0 1 1e999\n", {"a.stl:6: a coordinate of the vertex is not a finite number: '1e999'", 6}},
      {facet + "vertex 0 1 0\nvertex 1 1 0\n",
       {"a.stl:7: a facet with more than three vertices; STL facets are triangles", 7}},
      {facet + "vertex 0 1 0\nendloop\n", {"a.stl:8: expected 'endfacet', found the end of the file", 8}},
      {facet + "vertex 0", {"a.stl:6: expected three numbers for the vertex, found the end of the file", 6}},
      {"solid s\nendsolid s\nsolids t\n", {"a.stl:3: expected 'solid', found 'solids'", 3}},
      {"solid s\n\x01\xff" + std::string(100, 'y'),
       {"a.stl:2: expected 'facet' or 'endsolid', found '\?\?" + std::string(28, 'y') + "...'", 2}},
  };
  for (const auto& [text, expected] : cases) {
    const auto result = stl(text);
    EXPECT_FALSE(result.mesh);
    EXPECT_EQ(result.error.message, expected.first);
    EXPECT_EQ(result.error.line, expected.second);
  }
}

TEST(StlReader, TellsTheByteOfBinaryErrors) {
  std::string bytes = binary_stl(sample());
  auto result = stl(bytes.substr(0, 400));
  EXPECT_EQ(result.error.message,
            "a.stl: byte 400: the binary STL file ends early: 12 triangles need 684 bytes, but it has 400");
  EXPECT_EQ(result.error.offset, 400u);
  result = stl("not a mesh");
  EXPECT_EQ(
      result.error.message,
      "a.stl: byte 10: neither a text STL file, which starts with 'solid', nor a binary one, which has at least 84 "
      "bytes");
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&bytes[84 + 50 * 3 + 12 + 12 + 4], &bad, 4);
  result = stl(bytes);
  EXPECT_FALSE(result.mesh);
  EXPECT_EQ(result.error.offset, 84u + 50 * 3 + 24);
  EXPECT_EQ(result.error.message.substr(0, 65), "a.stl: byte 258: corner 2 of triangle 4 is not finite: (2.5, nan,");
  // A count that no file can have does not take memory.
  std::string huge(84, '\0');
  std::memset(&huge[80], 0xff, 4);
  result = stl(huge);
  EXPECT_EQ(result.error.message, "a.stl: byte 80: more than 10000000 triangles; simplify the mesh or raise the limit");
  EXPECT_EQ(stl(std::string(84, '\0')).error.message, "a.stl: the file has no triangles");
}

TEST(ObjReader, TellsTheLineOfErrors) {
  const std::vector<std::pair<std::string, std::pair<std::string, std::size_t>>> cases{
      {"v 0 0\n", {"a.obj:1: expected three numbers after 'v', found the end of the line", 1}},
      {"v 0 0 1.2.3\n", {"a.obj:1: expected three numbers after 'v', found '1.2.3'", 1}},
      {"v 0 0 nan\n", {"a.obj:1: a coordinate is not a finite number: 'nan'", 1}},
      {"v 0 0 0\nv 1 0 0\nf 1 2\n", {"a.obj:3: a face needs at least three corners, found 2", 3}},
      {"v 0 0 0\nf 1 1 2\n",
       {"a.obj:2: vertex number 2 of a face is outside 1 to 1 (or -1 to -1): a face follows its vertices", 2}},
      {"v 0 0 0\nf 0 1 1\n",
       {"a.obj:2: vertex number 0 of a face is outside 1 to 1 (or -1 to -1): a face follows its vertices", 2}},
      {"v 0 0 0\nf -2 1 1\n",
       {"a.obj:2: vertex number -2 of a face is outside 1 to 1 (or -1 to -1): a face follows its vertices", 2}},
      {"v 0 0 0\nf 1 a/1 1\n", {"a.obj:2: expected a vertex number in a face, found 'a/1'", 2}},
      {"v 0 0 0\nf 1 /1 1\n", {"a.obj:2: expected a vertex number in a face, found '/1'", 2}},
      {"v 0 0 0\nf 1 99999999999999999999 1\n",
       {"a.obj:2: expected a vertex number in a face, found '99999999999999999999'", 2}},
      {"\n\nvertex 0 0 0\n", {"a.obj:3: expected an OBJ statement such as 'v x y z' or 'f i j k', found 'vertex'", 3}},
      {"v 0 0 \\\n x\n", {"a.obj:2: expected three numbers after 'v', found 'x'", 2}},
  };
  for (const auto& [text, expected] : cases) {
    const auto result = obj(text);
    EXPECT_FALSE(result.mesh);
    EXPECT_EQ(result.error.message, expected.first);
    EXPECT_EQ(result.error.line, expected.second);
  }
  EXPECT_EQ(obj("").error.message, "a.obj: the file has no triangles");
  EXPECT_EQ(obj("v 0 0 0\n").error.message, "a.obj: the file has no triangles");
}

TEST(MeshReader, HoldsToItsLimits) {
  MeshLimits limits;
  limits.triangles = 11;
  EXPECT_EQ(stl(binary_stl(sample()), limits).error.message,
            "a.stl: byte 80: more than 11 triangles; simplify the mesh or raise the limit");
  EXPECT_EQ(stl(text_stl(sample()), limits).error.message,
            "a.stl:79: more than 11 triangles; simplify the mesh or raise the limit");
  limits.triangles = 1;
  EXPECT_EQ(obj("v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nf 1 2 3 4\n", limits).error.message,
            "a.obj:5: more than 1 triangles; simplify the mesh or raise the limit");
  limits = {};
  limits.bytes = 5;
  EXPECT_EQ(obj("v 0 0 0\n", limits).error.message, "a.obj: 8 bytes are more than the limit of 5");
}

// Cut off at any byte, or with one byte changed, an input gives a mesh or a message.
TEST(MeshReader, TakesAnyBytes) {
  testing::Random<double> random(16);
  const std::string text = text_stl(sample());
  const std::string binary = binary_stl(sample());
  for (const std::string& whole : {text, binary, std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf -1 \\\n-2 -3\n")}) {
    for (int i = 0; i < 2000; ++i) {
      std::string bytes = whole.substr(0, static_cast<std::size_t>(random.whole(0, static_cast<int>(whole.size()))));
      for (int k = random.whole(0, 3); k > 0 && !bytes.empty(); --k) {
        bytes[static_cast<std::size_t>(random.whole(0, static_cast<int>(bytes.size()) - 1))] =
            static_cast<char>(random.whole(0, 255));
      }
      for (const auto& result : {stl(bytes), obj(bytes)}) {
        ASSERT_NE(result.mesh.has_value(), !result.error.message.empty());
        if (result.mesh) {
          for (const auto& fault : find_faults(*result.mesh, "junk")) ASSERT_NE(fault.rule, MeshRule::known_vertices);
        }
      }
    }
  }
}

class MeshFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("poinsot_mesh_" +
         std::to_string(std::hash<std::string>{}(::testing::UnitTest::GetInstance()->current_test_info()->name())));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& bytes) const {
    const auto path = folder_ / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path.string();
  }
  std::filesystem::path folder_;
};

TEST_F(MeshFile, FormatGoesByTheNamesEnding) {
  expect_sample(read_mesh_file(write("a.stl", binary_stl(sample()))));
  expect_sample(read_mesh_file(write("b.STL", text_stl(sample()))));
  const std::string path = write("c.Obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(read_mesh_file(path).mesh);
  const std::string other = write("d.ply", "ply\n");
  EXPECT_EQ(read_mesh_file(other).error.message,
            other + ": unknown kind of mesh file; expected a name that ends in .stl or .obj");
}

TEST_F(MeshFile, TellsWhatIsWrongWithTheFile) {
  const std::string missing = (folder_ / "missing.stl").string();
  EXPECT_EQ(read_mesh_file(missing).error.message, missing + ": the file does not exist");
  const auto folder = folder_ / "folder.stl";
  std::filesystem::create_directory(folder);
  EXPECT_EQ(read_mesh_file(folder.string()).error.message, folder.string() + ": not a file");
  const std::string large = write("large.obj", std::string(200, '\n'));
  EXPECT_EQ(read_mesh_file(large, {100, 10}).error.message, large + ": 200 bytes are more than the limit of 100");
  const std::string empty = write("empty.stl", "");
  EXPECT_EQ(read_mesh_file(empty).error.message, empty +
                                                     ": byte 0: neither a text STL file, which starts with 'solid', "
                                                     "nor a binary one, which has at least 84 bytes");
  const std::string bad = write("bad.obj", "v 1\n");
  EXPECT_EQ(read_mesh_file(bad).error.message, bad + ":1: expected three numbers after 'v', found the end of the line");
}

}  // namespace mesh_reader_test
}  // namespace poinsot
