#include "props/judging/values/value_channels.h"

#include <cstddef>
#include <utility>

namespace rasterproof::props {
namespace {

constexpr double kEqual = 65534;  // a colour of 16 bits that a fade must keep

using NumberOf = double (*)(std::size_t vertex);

// No two of 256 vertices in a row share one; eight places far apart, and 32 next to each.
double Different(std::size_t k) {
  return static_cast<double>(1 + 3 * k % 8) / 8 - static_cast<double>(k / 8 % 32) / 256;
}
double Signed(std::size_t k) {
  return static_cast<double>(5 * k % 16) / 8 - 1 + static_cast<double>(k / 16 % 16) / 128;
}
double Equal(std::size_t /*k*/) { return kEqual; }
double NearlyEqual(std::size_t k) { return 1 + static_cast<double>(k % 3) * 0x1p-23; }
// A million and a bit, of either sign.
double Cancelling(std::size_t k) {
  const double size = 1e6 + static_cast<double>(k % 5) / 8;
  return k % 2 == 0 ? size : -size;
}
double Large(std::size_t k) { return (1 + static_cast<double>(k % 3) / 4) * 0x1p60; }
// Subnormal in float32.
double Small(std::size_t k) { return static_cast<double>(1 + k % 7) * 0x1p-130; }
double Numbered(std::size_t k) { return static_cast<double>(k % 4096 + 1); }

}  // namespace

std::vector<Channel> ChannelsFor(const Scene& scene, const ValueRule& rule) {
  if (!scene.channels.empty()) return scene.channels;
  std::vector<Channel> channels;
  const auto add = [&](const char* name, Interpolation interpolation, NumberOf number,
                       EvaluatedAt at = EvaluatedAt::kSample) {
    Channel channel{name, interpolation, at};
    if (number != nullptr) {
      channel.values.reserve(scene.vertices.size());
      for (std::size_t k = 0; k < scene.vertices.size(); ++k) channel.values.push_back(number(k));
    }
    channels.push_back(std::move(channel));
  };
  add("different", Interpolation::kPerspective, Different);
  add("signed", Interpolation::kPerspective, Signed);
  add("equal", Interpolation::kPerspective, Equal);
  add("nearly-equal", Interpolation::kPerspective, NearlyEqual);
  add("cancelling", Interpolation::kPerspective, Cancelling);
  add("large", Interpolation::kPerspective, Large);
  add("small", Interpolation::kPerspective, Small);
  if (rule.linear) {
    add("linear", Interpolation::kLinear, Different);
    add("linear-cancelling", Interpolation::kLinear, Cancelling);
    add("linear-equal", Interpolation::kLinear, Equal);
  }
  if (rule.flat) add("flat", Interpolation::kFlat, Numbered);
  if (rule.inverse_w) add("inverse-w", Interpolation::kInverseW, nullptr);
  if (rule.centres) add("centre", Interpolation::kPerspective, Different, EvaluatedAt::kCentre);
  if (rule.centroids) {
    add("centroid", Interpolation::kPerspective, Different, EvaluatedAt::kCentroid);
    add("centroid-signed", Interpolation::kPerspective, Signed, EvaluatedAt::kCentroid);
  }
  return channels;
}

}  // namespace rasterproof::props
