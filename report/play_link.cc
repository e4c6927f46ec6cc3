#include "report/play_link.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fmt/format.h"
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

// Without padding.
std::string AddressBase64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < count ? static_cast<unsigned char>(bytes[k + i]) : 0U);
    for (std::size_t i = 0; i <= count; ++i) text += kDigits[bits >> (18 - 6 * i) & 63];
  }
  return text;
}

}  // namespace

std::string PlayFragment(const Case& c, const std::string& subject) {
  const Scene& scene = c.scene;
  if (scene.triangles.size() > kMostTriangles ||
      std::int64_t{scene.width} * scene.height > kMostPixels) {
    return "";
  }
  const std::string json = io::InOneLine(io::CaseToJson({c, subject, "", nullptr}));
  return fmt::format("#scene={:08x}{}", CheckSum(json), AddressBase64(json));
}

}  // namespace rasterproof::report
