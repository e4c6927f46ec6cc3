// Writes tiny scenes with counts and what the search through all legal models says of them, a line
// of JSON each, for tests of the command: write_tiny_scenes NUMBER.
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "io/profile_json.h"
#include "tests/legal/all_models.h"

namespace rasterproof::legal::testing {
namespace {

using nlohmann::json;

json ToJson(const Scene& scene) {
  json vertices = json::array();
  for (const Vertex& v : scene.vertices) vertices.push_back({v.x, v.y});
  return {{"rasterproof_scene", 1},
          {"width", scene.width},
          {"height", scene.height},
          {"vertices", vertices},
          {"triangles", scene.triangles}};
}

void Write(int number) {
  Draws draws(73);
  for (int n = 0; n < number;) {
    const Scene scene = draws.AThinScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
    const CoverageCounts counts =
        n++ % 2 == 0 ? draws.AMixture(scene, profile) : draws.ANearMiss(scene, profile);
    json line;
    line["scene"] = ToJson(scene);
    line["profile"] = io::WholeProfileLine(profile);
    line["legal"] = IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
      return ExplainsCounts(scene, profile, rule, model, counts);
    });
    for (std::size_t s = 0; s < counts.size(); ++s) {
      const std::uint64_t numbers = NumbersBySearch(scene, profile, s);
      line["counts"].push_back(counts.Count(s));
      line["least"].push_back(std::countr_zero(numbers));
      line["most"].push_back(std::bit_width(numbers) - 1);
    }
    std::puts(line.dump().c_str());
  }
}

}  // namespace
}  // namespace rasterproof::legal::testing

int main(int argc, char** argv) {
  int number = 0;
  if (argc == 2) {
    const std::string_view text = argv[1];
    std::from_chars(text.data(), text.data() + text.size(), number);
  }
  if (number <= 0) {
    std::fputs("usage: write_tiny_scenes NUMBER\n", stderr);
    return 2;
  }
  rasterproof::legal::testing::Write(number);
}
