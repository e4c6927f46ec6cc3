#include "subjects/plugin/described.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/error.h"
#include "core/fixed_input.h"
#include "core/profile.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kFirstSize = offsetof(rasterproof_plugin, fixed_integer_bits);

void RequireSoundFixedInput(const rasterproof_plugin& plugin, const std::string& path) {
  if (plugin.input != RASTERPROOF_FIXED) return;
  if (plugin.fixed_integer_bits < 1 || plugin.fixed_integer_bits > kMaxIntegerBits ||
      plugin.fixed_fraction_bits > kMaxSubpixelBits) {
    throw InputError(path,
                     "its fixed-point input has " + std::to_string(plugin.fixed_integer_bits) +
                         " bits before the point and " +
                         std::to_string(plugin.fixed_fraction_bits) + " after it",
                     "set fixed_integer_bits from 1 to 31 and fixed_fraction_bits from 0 to 16");
  }
  if (Has(plugin, RASTERPROOF_TAKES_CLIP_SPACE) || Has(plugin, RASTERPROOF_TAKES_NO_WINDOW_SPACE)) {
    throw InputError(path, "a fixed-point input cannot take clip space",
                     "clear the clip-space bits of takes");
  }
}

}  // namespace

rasterproof_plugin Described(const rasterproof_plugin* plugin, const std::string& path) {
  const auto require = [&](bool holds, const std::string& reason, const std::string& remedy) {
    if (!holds) throw InputError(path, reason, remedy);
  };
  require(plugin != nullptr, std::string(kPluginSymbol).append(" returned NULL"),
          "return a description");
  require(
      plugin->version == RASTERPROOF_PLUGIN_VERSION,
      "it is written for version " + std::to_string(plugin->version) + " of the interface",
      "build it with the header of this version, " + std::to_string(RASTERPROOF_PLUGIN_VERSION));
  require(plugin->size >= kFirstSize,
          "its description has " + std::to_string(plugin->size) + " bytes, fewer than " +
              std::to_string(kFirstSize),
          "set size to sizeof(rasterproof_plugin)");
  rasterproof_plugin described{};
  std::memcpy(&described, plugin, std::min<std::size_t>(plugin->size, sizeof described));
  const auto require_known = [&](const char* what, std::uint32_t value, std::uint32_t last) {
    require(value <= last, std::string("its ") + what + " is " + std::to_string(value),
            "use the header's constants");
  };
  require(described.draw != nullptr, "it has no draw function", "set draw");
  require_known("input", described.input, RASTERPROOF_FIXED);
  require_known("coverage", described.coverage, RASTERPROOF_FRAGMENTS);
  require_known("visible", described.visible, RASTERPROOF_FIRST_DRAWN);
  require_known("barycentrics_of", described.barycentrics_of, RASTERPROOF_OF_GIVEN);
  require((described.takes & RASTERPROOF_SHOWS_CENTROIDS) == 0 ||
              described.coverage == RASTERPROOF_FRAGMENTS,
          "it shows centroids without fragments", "set coverage to RASTERPROOF_FRAGMENTS");
  require((described.takes & (RASTERPROOF_SHOWS_VALUES | RASTERPROOF_SHOWS_DERIVATIVES)) == 0 ||
              described.coverage == RASTERPROOF_FRAGMENTS,
          "it shows values without fragments", "set coverage to RASTERPROOF_FRAGMENTS");
  require((described.takes & RASTERPROOF_SHOWS_DERIVATIVES) == 0 ||
              (described.takes & RASTERPROOF_SHOWS_VALUES) != 0,
          "it shows derivatives without values", "set RASTERPROOF_SHOWS_VALUES too");
  const auto require_error = [&](const char* what, double error) {
    require(std::isfinite(error) && error >= 0,
            std::string("its ") + what + " is " + std::to_string(error),
            "give a finite number, or 0 for none stated");
  };
  require_error("barycentric_error", described.barycentric_error);
  require_error("depth_error", described.depth_error);
  for (const double error : {described.edge_error, described.stepping_error}) {
    require(std::isfinite(error), "the stated error of its edge values is not a number",
            "give a finite number, 0 for exact values, or -1 for none stated");
  }
  require(described.edge_value != nullptr || described.edge_steps == nullptr,
          "it shows steps without edge values", "set edge_value too");
  RequireSoundFixedInput(described, path);
  return described;
}

}  // namespace rasterproof::subjects
