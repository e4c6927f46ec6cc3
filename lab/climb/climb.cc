#include "lab/climb/climb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/subject_info.h"
#include "core/ulp.h"
#include "props/domains/bit_source.h"
#include "props/run/campaign.h"

namespace rasterproof::lab {
namespace {

constexpr std::size_t kKept = 16;
constexpr std::uint64_t kDrawnShare = 8;  // one in so many evaluations is spent on drawn cases
constexpr std::uint64_t kPerProgress = 64;
// No stream of a domain has this number: they are small.
constexpr std::uint64_t kStream = std::uint64_t{1} << 32;

struct Kept {
  Case value;
  double ratio = 0;
};

double Moved(double x, std::int64_t ulps, Precision precision) {
  if (!std::isfinite(x)) return x;
  if (precision == Precision::kFloat64) return MoveByUlps(x, ulps);
  return MoveByUlps(static_cast<float>(x), ulps);
}

// The coordinate with other bits, as many steps away as a power of two, up to half of the mantissa.
double Changed(double x, const Scene& scene, bool along_y, props::BitSource& bits) {
  const bool is_float32 = scene.precision == Precision::kFloat32;
  switch (bits.Int(0, 5)) {
    case 0: {
      const auto& other = scene.vertices[static_cast<std::size_t>(
          bits.Int(0, static_cast<std::int64_t>(scene.vertices.size()) - 1))];
      return along_y ? other.y : other.x;
    }
    case 1:
      return x * (bits.Chance(128) ? 2 : 0.5);
    case 2:
      return -x;
    default: {
      const std::int64_t step = std::int64_t{1} << bits.Int(0, is_float32 ? 22 : 51);
      return Moved(x, bits.Chance(128) ? step : -step, scene.precision);
    }
  }
}

Case Mutated(const Case& parent, props::BitSource& bits) {
  Case child = parent;
  Scene& scene = child.scene;
  const std::int64_t changes = bits.Int(1, 3);
  for (std::int64_t k = 0; k < changes; ++k) {
    const auto last = static_cast<std::int64_t>(scene.vertices.size()) - 1;
    Vertex& v = scene.vertices[static_cast<std::size_t>(bits.Int(0, last))];
    const std::int64_t axis = bits.Int(0, scene.clip_space ? 2 : 1);
    double& x = axis == 0 ? v.x : axis == 1 ? v.y : v.w;
    const double changed = Changed(x, scene, axis == 1, bits);
    if (std::isfinite(changed) && (scene.precision == Precision::kFloat64 || IsFloat32(changed))) {
      x = changed;
    }
  }
  child.origin = parent.origin.ends_with(", climbed") ? parent.origin : parent.origin + ", climbed";
  return child;
}

class Climb {
 public:
  Climb(Subject& subject, const props::Property& property, const ClimbOptions& options)
      : subject_(subject),
        property_(property),
        options_(options),
        bits_(options.seed, 0, kStream) {}

  Climbed Run() {
    for (std::uint64_t k = 0; k < options_.evaluations / kDrawnShare + 1 && !IsOver(); ++k) {
      Try(props::DrawCase(subject_.Info(), property_, options_.seed, k));
    }
    if (!kept_.empty()) found_.drawn_ratio = Best().ratio;
    if (options_.from && !IsOver()) Try(*options_.from);
    while (!IsOver() && !kept_.empty()) {
      const auto parent =
          static_cast<std::size_t>(bits_.Int(0, static_cast<std::int64_t>(kept_.size()) - 1));
      const Case child = Mutated(kept_[parent].value, bits_);
      if (Takes(subject_.Info(), child.scene) && WithinLimits(child.scene, child.profile)) {
        Try(child);
      } else {
        ++found_.evaluations;  // or a search among what is not taken would never end
      }
    }
    if (!is_violated_ && !kept_.empty()) found_.best = Best().value;
    if (!is_violated_ && found_.best) {
      found_.verdict = props::RunCase(subject_, property_, *found_.best);
    }
    return std::move(found_);
  }

 private:
  bool IsOver() const {
    return is_violated_ || found_.evaluations >= options_.evaluations ||
           (options_.stop && options_.stop());
  }

  const Kept& Best() const { return *std::ranges::max_element(kept_, {}, &Kept::ratio); }

  void Try(const Case& c) {
    const Verdict verdict = props::RunCase(subject_, property_, c);
    if (++found_.evaluations % kPerProgress == 0 && options_.progress) {
      options_.progress(found_.evaluations);
    }
    if (verdict.outcome == Outcome::kViolated) {
      is_violated_ = true;
      found_.best = c;
      found_.verdict = verdict;
      return;
    }
    if (verdict.outcome != Outcome::kHolds || verdict.worst_ratio == 0) return;
    if (kept_.size() < kKept) {
      kept_.push_back({c, verdict.worst_ratio});
      return;
    }
    Kept& least = *std::ranges::min_element(kept_, {}, &Kept::ratio);
    if (verdict.worst_ratio >= least.ratio) least = {c, verdict.worst_ratio};
  }

  Subject& subject_;
  const props::Property& property_;
  const ClimbOptions& options_;
  props::PhiloxSource bits_;
  std::vector<Kept> kept_;
  bool is_violated_ = false;
  Climbed found_;
};

}  // namespace

Climbed ClimbRatio(Subject& subject, const props::Property& property, const ClimbOptions& options) {
  return Climb(subject, property, options).Run();
}

}  // namespace rasterproof::lab
