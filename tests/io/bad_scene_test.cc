// Files that are no scenes: each is refused, and the message names place and reason.
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "gtest/gtest.h"
#include "io/scene_file.h"

namespace rasterproof::io {
namespace {

struct BadFile {
  std::string text;
  std::string message;  // a part of it
};

std::string MessageFor(const std::string& text) {
  try {
    ParseScene(text, "bad.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

void ExpectRefused(const std::vector<BadFile>& files) {
  for (const BadFile& file : files) {
    const std::string message = MessageFor(file.text);
    EXPECT_TRUE(message.starts_with("bad.json")) << message;
    EXPECT_NE(message.find(file.message), std::string::npos)
        << "  file:     " << file.text.substr(0, 200) << "\n  message:  " << message
        << "\n  expected: " << file.message;
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
    EXPECT_LT(message.size(), 600U) << message;
  }
}

// A scene with these texts in place of a good value.
std::string With(std::string_view vertices, std::string_view triangles = "[[0, 1, 2]]",
                 std::string_view target = R"("width": 4, "height": 4)") {
  return R"({"rasterproof_scene": 1, )" + std::string(target) + R"(, "vertices": )" +
         std::string(vertices) + R"(, "triangles": )" + std::string(triangles) + "}";
}

constexpr std::string_view kThree = "[[0, 0], [4, 0], [0, 4]]";

TEST(BadSceneTest, TheGoodOneIsAccepted) { EXPECT_EQ(MessageFor(With(kThree)), "(accepted)"); }

TEST(BadSceneTest, JsonThatIsNoneNamesLineAndColumn) {
  const std::string whole = With(kThree);
  ExpectRefused({
      {"", "bad.json: is empty"},
      {" \n\t", "bad.json: is empty"},
      {whole.substr(0, whole.size() - 1), "cut short"},
      {whole.substr(0, 60), "unexpected end of input"},
      {"{\n  \"width\": 4,\n  \"height\" 4}", "bad.json: line 3, column 12"},
      {"{\"name\": \"\xC3\xA9\", !}", "bad.json: line 1, column 15"},
      {whole + "x", "line 1, column " + std::to_string(whole.size() + 1)},
      {whole + whole, "expected end of input"},
      {"{\"name\": \"\xFF\"}", "ill-formed UTF-8"},
      {"{\"name\": \"\xC0\xAF\"}", "ill-formed UTF-8"},
      {std::string("{\0}", 3), "bad.json: line 1, column 2"},
      {"{\"width\": 04}", "bad.json: line 1, column 12"},
      {"{\"width\": NaN}", "invalid literal"},
      {"{}\n// comment", "bad.json: line 2, column 1"},
      {std::string(5000, 'x'), "bad.json: line 1, column 1"},
  });
}

TEST(BadSceneTest, NestingBombsAreRefusedAtOnce) {
  ExpectRefused({
      {std::string(1000000, '['), "nested more than 16 levels deep"},
      {With(std::string(1000000, '[')), "vertices[0][0][0]"},
      {std::string(20, '[') + std::string(20, ']'), "nested more than 16 levels deep"},
  });
}

TEST(BadSceneTest, KeysMustBeThoseOfAScene) {
  std::string many = "{";
  for (int k = 0; k < 100; ++k) many += "\"k" + std::to_string(k) + "\": 0, ";
  ExpectRefused({
      {"[]", "bad.json: is an array, not an object"},
      {"7", "is a number, not an object"},
      {"null", "is null, not an object"},
      {"{}", "the key \"rasterproof_scene\" is missing"},
      {R"({"rasterproof_case": 2, "scene": {}})", "is a case, not a scene"},
      {R"({"rasterproof_scene": 2})", "bad.json: rasterproof_scene: version 2 is unknown"},
      {R"({"rasterproof_scene": "1"})", "is a string, not an integer"},
      {R"({"rasterproof_scene": 1, "width": 1, "height": 1, "vertices": []})",
       "the key \"triangles\" is missing"},
      {R"({"rasterproof_scene": 1, "height": 1, "vertices": [], "triangles": []})",
       "the key \"width\" is missing"},
      {R"({"rasterproof_scene": 1, "colour": 1, "width": 1})", "unknown key \"colour\""},
      {R"({"rasterproof_scene": 1, "width": 1, "width": 2})", "says the key \"width\" twice"},
      {With(R"([[0, {"x": 1, "x": 2}]])"), "bad.json: vertices[0][1]: says the key \"x\" twice"},
      {many, "more than 64 keys"},
      {With(kThree, "[]", R"("width": 1, "height": 1, "name": 3)"), "name: is a number"},
      {With(kThree, "[]", R"("width": 1, "height": 1, "precision": "half")"),
       "bad.json: precision: \"half\" is no precision"},
  });
}

TEST(BadSceneTest, TargetsMustBePossible) {
  const auto target = [](const std::string& w, const std::string& h) {
    return With(kThree, "[]", "\"width\": " + w + ", \"height\": " + h);
  };
  ExpectRefused({
      {target("0", "4"), "bad.json: width: the number 0 is out of range"},
      {target("4", "0"), "bad.json: height: the number 0 is out of range"},
      {target("-0", "4"), "width"},
      {target("-1", "4"), "width: the number -1 is out of range"},
      {target("65537", "1"), "write an integer from 1 to 65536"},
      {target("2147483648", "1"), "width: the number 2147483648 is out of range"},
      {target("1", "99999999999999999999"), "height: the number 99999999999999999999"},
      {target("65536", "65536"), "4294967296 samples; at most 268435456"},
      {target("65536", "4097"), "samples"},
      {target("4.5", "4"), "width: the number 4.5 is not an integer"},
      {target("4e0", "4"), "is not an integer"},
      {target("\"4\"", "4"), "width: is a string, not an integer"},
      {target("null", "4"), "width: is null"},
      {target("1e400", "4"), "bad.json: width: the number \"1e400\" rounds to infinity"},
  });
  EXPECT_EQ(MessageFor(target("65536", "4096")), "(accepted)");
}

TEST(BadSceneTest, CoordinatesMustBeReadable) {
  ExpectRefused({
      {With("7"), "bad.json: vertices: is a number, not an array"},
      {With("[[0, 0], 7]"), "bad.json: vertices[1]: is a number, not an array"},
      {With("[[0, null]]"), "bad.json: vertices[0][1]: is neither a number nor a string"},
      {With("[[0, [1]]]"), "bad.json: vertices[0][1]: is neither"},
      {With("[[0, 0], [0, 0], [0, 1e39]]"),
       "bad.json: vertices[2][1]: \"1e39\" rounds to infinity"},
      {With("[[0, 0], [0, 0], [0, 0], [0, 1e400]]"), "bad.json: vertices[3][1]"},
      {With("[[0, 1e400]]"), "rounds to infinity; write \"inf\""},
      {With("[[0, -1e99999999999]]"), "vertices[0][1]"},
      {With(R"([["0x1.000001p0", 0]])"),
       "vertices[0][0]: \"0x1.000001p0\" is not exactly a float32"},
      {With(R"([["0x1.8", 0]])"), "is a malformed hex float"},
      {With(R"([["1.5", 0]])"), "is not a hex float"},
      {With(R"([["Infinity", 0]])"), "write a hex float"},
      {With(R"([["\n\u0000", 0]])"), R"("\x0a\x00" is not a hex float)"},
      {With("[[\"" + std::string(100000, '7') + "\", 0]]"), "...\" is not a hex float"},
  });
}

TEST(BadSceneTest, VerticesMustAllHaveTheirCoordinates) {
  ExpectRefused({
      {With("[[]]"), "bad.json: vertices[0]: has 0 coordinates"},
      {With("[[1]]"), "vertices[0]: has 1 coordinates; write [x, y]"},
      {With("[[1, 2, 3, 4, 5]]"), "has 5 coordinates"},
      {With("[[0, 0, 0, 1], [0, 0, 0], [0, 0, 0, 1]]"),
       "bad.json: vertices[1]: has no w, but bad.json: vertices[0] has"},
      {With("[[0, 0], [0, 0, 0], [0, 0, 0, 1]]"), "bad.json: vertices[0]: has no w"},
  });
}

TEST(BadSceneTest, TrianglesMustNameVertices) {
  const auto triangles = [](const std::string& text) { return With(kThree, text); };
  ExpectRefused({
      {triangles("{}"), "bad.json: triangles: is an object, not an array"},
      {triangles("[0, 1, 2]"), "bad.json: triangles[0]: is a number, not an array"},
      {triangles("[[0, 1]]"), "triangles[0]: has 2 indices"},
      {triangles("[[0, 1, 2, 0]]"), "triangles[0]: has 4 indices"},
      {triangles("[[0, 1, 2], [0, 3, 1]]"),
       "bad.json: triangles[1][1]: the index 3 names no vertex; the vertices are numbered from 0 "
       "to 2"},
      {triangles("[[0, 1, -1]]"), "triangles[0][2]: the index -1 names no vertex"},
      {triangles("[[0, 1, 1.0]]"), "triangles[0][2]: the number 1.0 is not an integer"},
      {triangles("[[0, 1, 4294967296]]"), "triangles[0][2]: the number 4294967296"},
      {triangles("[[0, 1, 18446744073709551616]]"), "triangles[0][2]"},
      {triangles("[[0, 1, \"2\"]]"), "triangles[0][2]: is a string, not an integer"},
      {With("[]", "[[0, 0, 0]]"), "the scene has no vertices"},
  });
}

TEST(BadSceneTest, FilesThatCannotBeReadAreNamed) {
  for (const std::string path : {"no/such/scene.json", "/", "/dev/null/x"}) {
    try {
      ReadScene(path);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string_view(error.what()).starts_with(path + ": can't be read"))
          << error.what();
    }
  }
}

}  // namespace
}  // namespace rasterproof::io
