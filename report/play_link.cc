#include "report/play_link.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fmt/format.h"
#include "io/base64.h"
#include "io/case_file.h"
#include "io/check_json.h"

namespace rasterproof::report {
namespace {

// As in web/page/scene.mjs.
constexpr std::size_t kMostTriangles = 256;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 22;

std::uint32_t CheckSum(std::string_view bytes) {
  std::uint32_t hash = 0x811c9dc5U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193U;
  return hash;
}

// Section 5 of RFC 4648: base64 for addresses; without padding.
std::string ForAddresses(std::string base64) {
  std::ranges::replace(base64, '+', '-');
  std::ranges::replace(base64, '/', '_');
  base64.resize(base64.find_last_not_of('=') + 1);
  return base64;
}

}  // namespace

std::string PlayFragment(const Case& c, const std::string& subject) {
  const Scene& scene = c.scene;
  if (scene.triangles.size() > kMostTriangles ||
      std::int64_t{scene.width} * scene.height > kMostPixels) {
    return "";
  }
  const std::string json = io::InOneLine(io::CaseToJson({c, subject, "", nullptr}));
  return fmt::format("#scene={:08x}{}", CheckSum(json), ForAddresses(io::ToBase64(json)));
}

}  // namespace rasterproof::report
