#include "io/freedom_json.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/freedom.h"
#include "core/snap.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/number_text.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr std::array<std::pair<bool, std::string_view>, 2> kRoundings{
    {{false, "stated"}, {true, "unspecified"}}};
constexpr std::array<std::pair<TieOwnership, std::string_view>, 4> kTieOwnerships{
    {{TieOwnership::kStated, "stated"},
     {TieOwnership::kAxisAligned, "axis-aligned"},
     {TieOwnership::kPerEdge, "per-edge"},
     {TieOwnership::kOpen, "open"}}};

double SnapTolerance(const JsonValue& value) {
  const double steps = CoordinateFromJson(value, Precision::kFloat64);
  if (steps >= 0 && steps <= kMaxSnapTolerance) return steps;
  throw value.Error("is not a snap tolerance", "write a number of grid steps from 0 to 1");
}

std::optional<int> LeastBits(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  return Integer(value, 0, kMaxSubpixelBits);
}

std::optional<double> TransformError(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  const double units = CoordinateFromJson(value, Precision::kFloat64);
  if (units >= 0 && std::isfinite(units)) return units;
  throw value.Error("is not the error of a transform",
                    "write a number of 2^-24 of a coordinate, 0 or more, or null where none is "
                    "stated");
}

}  // namespace

void ReadFreedom(const JsonValue& profile, Freedom& freedom) {
  ReadIfThere(profile, "snap_tolerance", freedom.snap_tolerance, SnapTolerance);
  ReadIfThere(profile, "rounding", freedom.any_rounding,
              [](const JsonValue& v) { return FromName(v, Names<bool>(kRoundings)); });
  ReadIfThere(profile, "least_subpixel_bits", freedom.least_bits, LeastBits);
  ReadIfThere(profile, "tie_ownership", freedom.ties,
              [](const JsonValue& v) { return FromName(v, Names<TieOwnership>(kTieOwnerships)); });
  ReadIfThere(profile, "transform_error", freedom.transform_error, TransformError);
}

std::string FreedomToJson(const Freedom& freedom, const std::string& line) {
  std::string json =
      line + "\"snap_tolerance\": " + InQuotes(ExactText(freedom.snap_tolerance)) + line +
      "\"rounding\": " + InQuotes(NameOf(freedom.any_rounding, Names<bool>(kRoundings)));
  if (freedom.least_bits)
    json += line + "\"least_subpixel_bits\": " + std::to_string(*freedom.least_bits);
  json += line + "\"tie_ownership\": " +
          InQuotes(NameOf(freedom.ties, Names<TieOwnership>(kTieOwnerships)));
  if (!freedom.transform_error) return json + line + "\"transform_error\": null";
  if (*freedom.transform_error == 0) return json;
  return json + line + "\"transform_error\": " + InQuotes(ExactText(*freedom.transform_error));
}

}  // namespace rasterproof::io
