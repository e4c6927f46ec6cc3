#include "bench/contender.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/exact_triangles.h"
#include "bench/shared_target.h"
#include "core/clock.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/subject_info.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"
#include "reference/barycentrics.h"
#include "reference/rasterize.h"

namespace rasterproof::bench {
namespace {

namespace kernels = library::kernels;
namespace rivals = library::rivals;

// The kind of a method, by what it computes in and whether 0 wrong samples are stated of it.
std::string KindOf(const SubjectInfo& info) {
  if (!info.profile.snap.IsNone()) return "fixed point";
  if (info.states_exact) return "exact";
  return info.input == Precision::kFloat64 || info.name.find("f64") != std::string::npos
             ? "float64"
             : "float32";
}

class MethodContender final : public Contender {
 public:
  explicit MethodContender(const reference::Method& table_row) : row_(table_row) {
    const SubjectInfo& info = table_row.info;
    model_ = info.profile;
    edges_ = table_row.edges;
    method_.name = table_row.name;
    method_.summary = table_row.summary;
    method_.kind = KindOf(info);
    method_.target = "compiler";
    method_.sink = NameOf(kernels::Sink::kFacing);
    // What draws whole scenes at once is a kernel under another name.
    method_.traversal = table_row.whole != nullptr ? "a kernel's" : "box loop";
    method_.arithmetic = table_row.name;
    method_.space = info.takes_window ? "window" : "clip";
    method_.model = info.profile.name;
    method_.is_proved = info.states_exact;
    method_.coordinate_limit = info.profile.coordinate_limit;
    method_.vertex_bytes = sizeof(Vertex);
    method_.pixel_bits = 8 * sizeof(std::uint64_t);
  }

  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    if (Takes(row_.info, family.scene)) return std::nullopt;
    if (family.scene.clip_space) return "it draws window space, and the family is clip space";
    if (!row_.info.takes_window) return "it draws clip space, and the family is window space";
    return "it computes in float32, and the family's coordinates are float64";
  }

  void Load(const FamilyInput& family) override {
    family_ = &family;
    const int width = family.scene.width;
    const int height = family.scene.height;
    static thread_local SharedTarget<CoverageCounts> shared;
    counts_ = shared.Of(
        [&](const CoverageCounts& counts) {
          return counts.width == width && counts.height == height;
        },
        [&] { return CoverageCounts(width, height); });
    Clear();
    alone_ = Scene{.name = family.scene.name,
                   .width = width,
                   .height = height,
                   .precision = family.scene.precision,
                   .clip_space = family.scene.clip_space,
                   .vertices = std::vector<Vertex>(3),
                   .triangles = {{0, 1, 2}}};
  }

  DrawTime Draw() override {
    Clear();
    return DrawForNothing();
  }
  bool NeedsClearing() const override { return false; }

  DrawTime DrawForNothing() override {
    return Timed([&] { reference::Rasterize(family_->scene, row_, {}, *counts_); });
  }

  bool MoveDrawn(CoverageCounts& to) override {
    if (to.size() != counts_->size()) to = CoverageCounts(counts_->width, counts_->height);
    to.width = counts_->width;
    to.height = counts_->height;
    std::swap(to, *counts_);
    Clear();
    return true;
  }

  void DrawAlone(std::size_t triangle, const PixelRect& area,
                 std::vector<std::uint8_t>& box) override {
    const auto corners = Corners(family_->scene, family_->scene.triangles[triangle]);
    std::ranges::copy(corners, alone_.vertices.begin());
    reference::Rasterize(alone_, row_, {}, *counts_);
    std::size_t at = 0;
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = area.x0; x < area.x1; ++x) {
        const std::size_t i = counts_->Index(x, y);
        box[at++] = counts_->Count(i) != 0 ? 1 : 0;
        counts_->front[i] = counts_->back[i] = 0;
      }
    }
  }

  // A scissor changes no sample within it.
  std::vector<std::uint8_t> CoverAlone(std::span<const std::size_t> triangles,
                                       const PixelRect& /*target*/, Pixel at) override {
    reference::RasterOptions options;
    options.scissor = PixelRect{at.x, at.y, at.x + 1, at.y + 1};
    const std::size_t i = counts_->Index(at.x, at.y);
    std::vector<std::uint8_t> covered;
    for (const std::size_t triangle : triangles) {
      const auto corners = Corners(family_->scene, family_->scene.triangles[triangle]);
      std::ranges::copy(corners, alone_.vertices.begin());
      reference::Rasterize(alone_, row_, options, *counts_);
      covered.push_back(counts_->Count(i) != 0 ? 1 : 0);
      counts_->front[i] = counts_->back[i] = 0;
    }
    return covered;
  }

  // In window space; of snapped vertices they are the snapped triangle's.
  std::vector<PixelValues> ValuesAlone(std::size_t triangle,
                                       std::span<const Pixel> pixels) override {
    std::vector<PixelValues> values;
    if (family_->scene.clip_space || !row_.info.profile.snap.IsNone()) return values;
    const auto corners = Corners(family_->scene, family_->scene.triangles[triangle]);
    const std::array<Point2, 3> v{WindowPoint(corners[0]), WindowPoint(corners[1]),
                                  WindowPoint(corners[2])};
    const std::array<double, 3> z{corners[0].z, corners[1].z, corners[2].z};
    const std::array<Corner, 3> deep{{{v[0]}, {v[1]}, {v[2]}}};
    const BarycentricEvaluator& evaluator = reference::ReferenceBarycentrics(row_.info.input);
    for (const Pixel& at : pixels) {
      const Point2 p = CentreOf(at.x, at.y);
      values.push_back(
          {.barycentrics = evaluator.Barycentrics(BarycentricForm::kVertexArea, v, p),
           .depth = evaluator.Interpolate(InterpolationForm::kBarycentrics, deep, z, p)});
    }
    return values;
  }

  std::uint64_t LeftBehind() override {
    std::uint64_t left = 0;
    for (std::size_t i = 0; i < counts_->size(); ++i) left += counts_->Count(i) != 0 ? 1 : 0;
    if (left != 0) Clear();
    return left;
  }

 private:
  void Clear() {
    std::ranges::fill(counts_->front, 0);
    std::ranges::fill(counts_->back, 0);
  }

  const reference::Method& row_;
  const FamilyInput* family_ = nullptr;
  std::shared_ptr<CoverageCounts> counts_;
  Scene alone_;
};

}  // namespace

std::vector<std::uint8_t> Contender::CoverAlone(std::span<const std::size_t> triangles,
                                                const PixelRect& target, Pixel at) {
  std::vector<std::uint8_t> covered;
  std::vector<std::uint8_t> box(static_cast<std::size_t>(target.x1) *
                                static_cast<std::size_t>(target.y1));
  for (const std::size_t triangle : triangles) {
    DrawAlone(triangle, target, box);
    covered.push_back(box[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(target.x1) +
                          static_cast<std::size_t>(at.x)]);
  }
  return covered;
}

std::unique_ptr<Contender> MakeMethodContender(const reference::Method& method) {
  return std::make_unique<MethodContender>(method);
}

double StoreLimit(kernels::Sink sink) {
  static std::array<double, kernels::kSinks.size()> known{};
  double& limit = known[static_cast<std::size_t>(sink)];
  if (limit > 0) return limit;
  constexpr int kSide = 1024;
  constexpr int kPasses = 8;
  kernels::Surface surface(sink, kSide, kSide);
  limit = std::numeric_limits<double>::infinity();
  for (int repetition = 0; repetition < 8; ++repetition) {
    const DrawTime time = Timed([&] {
      for (int pass = 0; pass < kPasses; ++pass) {
        kernels::Fill(kernels::SupportedTargets().back(), surface);
      }
    });
    limit = std::min(limit, time.seconds / (kPasses * double{kSide} * kSide));
  }
  return limit;
}

}  // namespace rasterproof::bench
