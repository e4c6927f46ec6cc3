#include "props/codec/spelled.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "model/target_profile.h"

namespace rasterproof::props {
namespace {

// A byte that answers "no" to every question of chance; 0 says yes to the least likely.
constexpr std::uint8_t kAnswersNo = 255;

bool HaveSameBits(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

// The two bytes of a coordinate.
class CoordinateSpeller {
 public:
  CoordinateSpeller(double x, const InputLattice& lattice) : x_(x), lattice_(lattice) {}

  bool Find() {
    if (!std::isfinite(x_)) return false;
    if (FindFrom(x_, 0)) return true;
    // A step beside such a place: from there back.
    for (std::size_t k = 0; k < kSpelledSteps.size(); ++k) {
      if (FindFrom(lattice_.Move(x_, -kSpelledSteps[k]), kFirstStep + k)) return true;
    }
    return false;
  }
  std::uint8_t anchor() const { return static_cast<std::uint8_t>(anchor_); }
  std::uint8_t fine() const { return static_cast<std::uint8_t>(fine_); }

 private:
  bool Is(std::uint64_t anchor, std::uint64_t fine) {
    anchor_ = anchor;
    fine_ = fine;
    return HaveSameBits(SpelledCoordinate(anchor, fine, lattice_), x_);
  }
  // Finds an anchor at `place`; if there is no step, a subpixel after the anchor may remain.
  bool FindFrom(double place, std::uint64_t fine) {
    const double halves = 2 * (place - kFirstPixel);
    const double near = std::floor(halves);
    for (const double anchor : {near, near + 1}) {
      if (!(anchor >= 0 && anchor < static_cast<double>(kHalfPixels))) continue;
      if (FindAt(static_cast<std::uint64_t>(anchor), halves - anchor, fine)) return true;
    }
    if (!std::isfinite(place) || std::fabs(place) < 1) return false;
    const int exponent = std::ilogb(place);
    for (const int far : {2 * (exponent - 7), 2 * (exponent - 6)}) {
      const int signed_far = far + (place < 0 ? 1 : 0);
      if (far < 0 || signed_far > static_cast<int>(kAnswersNo - kFirstFarAnchor)) continue;
      const double subpixel = std::fabs(std::ldexp(place, -(far / 2 + 7))) - 1;
      const std::uint64_t anchor = kFirstFarAnchor + static_cast<std::uint64_t>(signed_far);
      if (FindAt(anchor, subpixel, fine)) return true;
    }
    return false;
  }
  bool FindAt(std::uint64_t anchor, double subpixel, std::uint64_t fine) {
    if (Is(anchor, fine)) return true;
    const double sixtyfourths = std::round(std::ldexp(subpixel, 6));
    return fine == 0 && sixtyfourths >= 0 && sixtyfourths < 64 &&
           Is(anchor, kFirstSubpixel + static_cast<std::uint64_t>(sixtyfourths));
  }

  double x_;
  const InputLattice& lattice_;
  std::uint64_t anchor_ = 0;
  std::uint64_t fine_ = 0;
};

bool IsOfTheCode(const Case& c, const SubjectInfo& info) {
  const Scene& scene = c.scene;
  const auto vertices = static_cast<std::int64_t>(scene.vertices.size());
  const auto triangles = static_cast<std::int64_t>(scene.triangles.size());
  return info.takes_window && !scene.clip_space && scene.width <= kMostSpelledSide &&
         scene.height <= kMostSpelledSide && vertices >= 3 && vertices <= kMostSpelledVertices &&
         triangles >= 1 && triangles <= kMostSpelledTriangles && c.options == DrawOptions{} &&
         scene.name.empty() && c.origin.empty();
}

}  // namespace

double SpelledCoordinate(std::uint64_t anchor, std::uint64_t fine, const InputLattice& lattice) {
  const double subpixel =
      fine < kFirstSubpixel ? 0 : std::ldexp(static_cast<double>(fine - kFirstSubpixel), -6);
  double x = kFirstPixel + (static_cast<double>(anchor % kHalfPixels) + subpixel) / 2;
  if (anchor >= kFirstFarAnchor) {
    const auto far = static_cast<int>(anchor - kFirstFarAnchor);
    x = std::ldexp(far % 2 == 0 ? 1.0 : -1.0, 7 + far / 2) * (1 + subpixel);
  }
  x = lattice.RoundWithinLimit(x);
  const bool steps = fine >= kFirstStep && fine < kFirstSubpixel;
  return steps ? lattice.Move(x, kSpelledSteps[fine & 7]) : x;
}

std::optional<std::vector<std::uint8_t>> SpellCase(const Case& c, const SubjectInfo& info) {
  if (!IsOfTheCode(c, info)) return std::nullopt;
  const Scene& scene = c.scene;
  const InputLattice lattice(TargetProfile(info.profile, scene), scene.precision);
  const std::size_t vertices = scene.vertices.size();
  std::vector<std::uint8_t> bytes{0, static_cast<std::uint8_t>(scene.width - 1),
                                  static_cast<std::uint8_t>(scene.height - 1),
                                  static_cast<std::uint8_t>(vertices - 3)};
  // Which precision is asked for only where the subject takes both.
  const bool is_asked = !info.profile.fixed && info.input == Precision::kFloat64;
  if (is_asked) bytes.push_back(scene.precision == Precision::kFloat32 ? 0 : kAnswersNo);
  for (const Vertex& v : scene.vertices) {
    if (!HaveSameBits(v.z, 0) || v.w != 1) return std::nullopt;
    for (const double x : {v.x, v.y}) {
      CoordinateSpeller speller(x, lattice);
      if (!speller.Find()) return std::nullopt;
      bytes.push_back(speller.anchor());
      bytes.push_back(speller.fine());
    }
  }
  bytes.push_back(static_cast<std::uint8_t>(scene.triangles.size() - 1));
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = static_cast<std::size_t>(scene.triangles[t][k]);
      const std::size_t counted = (index + 2 * vertices - (t + k) % vertices) % vertices;
      bytes.push_back(static_cast<std::uint8_t>(counted));
    }
  }
  // Neither repeated vertices, nor a tile, threads, a scissor, culling.
  bytes.insert(bytes.end(), 5, kAnswersNo);
  return bytes;
}

}  // namespace rasterproof::props
