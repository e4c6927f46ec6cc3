#include "io/mesh.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/error.h"
#include "gtest/gtest.h"
#include "tests/share.h"
#include "tests/temporary_folder.h"

namespace rasterproof::io {
namespace {

Mesh ReadText(const std::string& extension, const std::string& content) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("mesh_test-" + std::to_string(::getpid()) + extension);
  std::ofstream(path, std::ios::binary) << content;
  return ReadMesh(path);
}

std::string MessageFor(const std::string& extension, const std::string& content) {
  try {
    ReadText(extension, content);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

// Directed edges without an equal number of reverse ones: none in a closed mesh.
std::size_t OpenEdges(const Mesh& mesh) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> balance;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = t[k];
      const std::int32_t b = t[(k + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(balance, [](const auto& entry) { return entry.second != 0; }));
}

const std::string kObjTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

const std::string kOffTetrahedron =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

const std::string kPlyTetrahedron =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

// STL repeats the position at every corner.
std::string StlTetrahedron() {
  const char* const corners[4] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::string text = "solid t\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : face) text += std::string("vertex ") + corners[k] + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid t\n";
}

TEST(MeshTest, EveryFormatGivesTheSameClosedTetrahedron) {
  for (const auto& [extension, text] :
       {std::pair{".obj", kObjTetrahedron}, std::pair{".off", kOffTetrahedron},
        std::pair{".ply", kPlyTetrahedron}, std::pair{".stl", StlTetrahedron()}}) {
    const Mesh mesh = ReadText(extension, text);
    EXPECT_TRUE(mesh.name.starts_with("mesh_test-")) << mesh.name;
    EXPECT_EQ(mesh.vertices.size(), 4U) << extension;
    EXPECT_EQ(mesh.triangles.size(), 4U) << extension;
    EXPECT_EQ(OpenEdges(mesh), 0U) << extension;
  }
}

std::string Base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t block = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      block = block << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[block >> shift & 63U];
  }
  return text;
}

// One triangle of 9 floats, drawn by two nodes: one as it is, one below two moved and scaled ones.
TEST(MeshTest, NodesOfAGltfPlaceTheirMeshes) {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, -0.0F};
  std::string bytes(sizeof corners, '\0');
  std::memcpy(bytes.data(), corners, sizeof corners);
  const std::string gltf =
      R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
  "nodes": [{"mesh": 0}, {"translation": [10, 0, 0], "children": [2]},
            {"scale": [2, 3, 1], "translation": [0, 0.5, 0], "mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                 "min": [0, 0, 0], "max": [1, 1, 0]}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)" +
      Base64(bytes) + R"("}]})";
  const Mesh mesh = ReadText(".gltf", gltf);
  ASSERT_EQ(mesh.triangles.size(), 2U);
  ASSERT_EQ(mesh.vertices.size(), 6U);
  EXPECT_TRUE(std::signbit(mesh.vertices[2][2])) << "bits of an unmoved vertex change";
  EXPECT_EQ(mesh.vertices[3], (std::array{10.0F, 0.5F, 0.0F}));
  EXPECT_EQ(mesh.vertices[4], (std::array{12.0F, 0.5F, 0.0F}));
  EXPECT_EQ(mesh.vertices[5], (std::array{10.0F, 3.5F, 0.0F}));
}

TEST(MeshTest, OnlyEqualBitsAreWelded) {
  const Mesh mesh = ReadText(".obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0.0000001 0\nv 0 -1 0\n"
                             "f 1 2 3\nf 4 5 6\n");
  EXPECT_EQ(mesh.vertices.size(), 5U);
  EXPECT_EQ(mesh.triangles[1][0], 0);
  EXPECT_NE(mesh.triangles[1][1], mesh.triangles[0][1]);
}

TEST(MeshTest, PolygonsBecomeTrianglesAndDegenerateOnesStay) {
  EXPECT_EQ(ReadText(".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").triangles.size(),
            2U);
  const Mesh mesh = ReadText(".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 2\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.triangles[1], (Triangle{0, 1, 1}));
}

// Importers have aborted the program, or never returned, on files like these.
TEST(MeshTest, FilesCutShortAreReadOrRefused) {
  for (const auto& [extension, text] :
       {std::pair{".off", kOffTetrahedron}, std::pair{".ply", kPlyTetrahedron},
        std::pair{".obj", kObjTetrahedron}, std::pair{".stl", StlTetrahedron()}}) {
    for (std::size_t size = 0; size < text.size(); size += kOneCaseIn > 1 ? 35 : 5) {
      try {
        EXPECT_GT(ReadText(extension, text.substr(0, size)).triangles.size(), 0U);
      } catch (const InputError&) {
        continue;
      }
    }
  }
}

TEST(MeshTest, BadMeshesAreRefusedWithFileReasonAndRemedy) {
  const auto expect = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find("mesh_test-"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message;
  };
  expect(MessageFor(".obj", ""), "can't be read as a mesh");
  expect(MessageFor(".ply", "ply\nformat ascii 1.0\nelement ver"), "can't be read as a mesh");
  expect(MessageFor(".gltf", "{"), "can't be read as a mesh");
  expect(MessageFor(".glb", "not glTF at all"), "can't be read as a mesh");
  expect(MessageFor(".off", "OFF\n0 0 0\n"), "can't be read as a mesh");
  expect(MessageFor(".txt", kObjTetrahedron), "has no name of a mesh");
  expect(MessageFor(".obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "has no triangles");
  expect(MessageFor(".obj", "v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n"), "not finite");
  for (const std::string path : {"no/such/mesh.obj", "scenes.obj/"}) {
    EXPECT_THROW(ReadMesh(path), InputError);
  }
}

std::string Repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

// A glTF of no mesh but the nodes.
std::string GltfOfNodes(const std::string& nodes) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" +
         nodes + "]}";
}

std::string ChainOfNodes(int depth, int children) {
  std::string nodes;
  for (int k = 1; k < depth; ++k) {
    const std::string next = std::to_string(k);
    nodes += R"({"children": [)" + next + (children == 2 ? ", " + next : "") + "]}, ";
  }
  return GltfOfNodes(nodes + "{}");
}

const std::string kPlyOfBillions =
    "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4000000000\nproperty list uchar int vertex_indices\n"
    "end_header\n0 0 0\n";

// A header, and a chunk of almost 4 GiB that is not there.
const std::string kShortGlb("glTF\x02\0\0\0\x16\0\0\0\xf0\xff\xff\xffJSON{}", 22);

// Small files that crash the library, or make it take all time and memory.
TEST(MeshTest, FilesThatAreBuiltToCrashOrToExhaustAreRefusedInSeconds) {
  for (const auto& [name, extension, content] :
       {std::tuple{"deep nodes", ".gltf", ChainOfNodes(200000, 1)},
        std::tuple{"nested arrays", ".gltf", Repeated("[", 1000000)},
        std::tuple{"a DAG of nodes", ".gltf", ChainOfNodes(40, 2)},
        std::tuple{"billions", ".ply", kPlyOfBillions},
        std::tuple{"short glb", ".glb", kShortGlb}}) {
    const std::string message = MessageFor(extension, content);
    EXPECT_NE(message, "(accepted)") << name;
    EXPECT_NE(message.find("mesh_test-"), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message;
    if (kOneCaseIn != 1) continue;  // sanitizers take memory of their own
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    EXPECT_LT(used.ru_maxrss, 1 << 20) << name << ", KiB";
  }
}

// The importer compares each object's or material's name with all before it.
TEST(MeshTest, AnObjOfManyPartsIsReadAsOneOfNone) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const std::string part : {"g g", "o o", "usemtl m"}) {
    std::string text = corners;
    for (int k = 0; k < 100000; ++k) text += part + std::to_string(k) + "\nf 1 2 3\n";
    EXPECT_EQ(ReadText(".obj", text).triangles.size(), 100000U) << part;
  }
}

TEST(MeshTest, LinesOfAnObjThatGoOnAndThatEndOtherwiseAreRead) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const std::string& text :
       {corners + "g a \\\nb\nf 1 2 3\n", corners + "g a \\\r\nb\r\nf 1 2 3\n",
        corners + "o\n\tusemtl m\nf 1 2 3", corners + "g a\rf 1 2 3\r",
        corners + "f 1 2 \\\n3\n"}) {
    EXPECT_EQ(ReadText(".obj", text).triangles, (std::vector<Triangle>{{0, 1, 2}})) << text;
  }
}

TEST(MeshTest, AFaceThatNamesAVertexWhichIsNotThereIsRefused) {
  const std::string off = "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 ";
  EXPECT_EQ(ReadText(".off", off + "2\n").triangles.size(), 1U);
  const std::string coloured = "OFF 3 1 3\n# of\n0 0 0\n\n1 0 0\n0 1 0\n3 0 1 2 -0.5\n";
  EXPECT_NE(MessageFor(".off", coloured).find("accepted"), std::string::npos);
  for (const auto& [extension, content] :
       {std::pair{".off", off + "3\n"}, std::pair{".off", off + "-1\n"},
        std::pair{".off", off + "4294967298\n"},
        std::pair{".obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")}}) {
    const std::string message = MessageFor(extension, content);
    EXPECT_NE(message.find("mesh_test-"), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace rasterproof::io
