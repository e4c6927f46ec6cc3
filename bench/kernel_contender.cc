// The kernels: of window space, of clip space, after a division, and with nothing to find out.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/contender.h"
#include "bench/span_record.h"
#include "bench/surface_contender.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"

namespace rasterproof::bench {
namespace {

namespace kernels = library::kernels;

namespace rivals = library::rivals;

using KernelDrawing = std::function<void(const kernels::KernelScene&, kernels::Surface&)>;

void Describe(std::string summary, std::string_view traversal, std::string_view arithmetic,
              BenchMethod& method) {
  method.summary = std::move(summary);
  method.traversal = traversal;
  method.arithmetic = arithmetic;
}

KernelDrawing ExactDrawing(kernels::Target target) {
  return [=](const kernels::KernelScene& scene, kernels::Surface& surface) {
    kernels::Draw(target, scene, surface);
  };
}

KernelDrawing DrawingOf(const rivals::Rival& rival, kernels::Target target) {
  return [=](const kernels::KernelScene& scene, kernels::Surface& surface) {
    rivals::Draw(rival, target, scene, surface);
  };
}

// A kernel of window space, or a rival of it.
class KernelContender final : public SurfaceContender {
 public:
  KernelContender(kernels::Target target, kernels::Sink sink)
      : SurfaceContender(target, sink), draw_(ExactDrawing(target)) {
    method_.name = "kernel-exact";
    Describe("crossings of edges with rows, decided exactly", "spans", "exact", method_);
    method_.kind = "exact";
    method_.is_proved = true;
    DescribeModel(double{std::numeric_limits<float>::max()});
  }

  KernelContender(const rivals::Rival& rival, kernels::Target target, kernels::Sink sink)
      : SurfaceContender(target, sink),
        draw_(DrawingOf(rival, target)),
        draws_alone_(rival.traversal != rivals::Traversal::kMaskTiles) {
    method_.name = NameOf(rival);
    Describe(SummaryOf(rival), NameOf(rival.traversal), NameOf(rival.arithmetic), method_);
    if (Snaps(rival.arithmetic)) {
      model_.name = "snapped to 1/256";
      model_.snap = {8, SnapRule::kNearestEven};
      method_.kind = "fixed point";
      method_.is_proved = rival.traversal == rivals::Traversal::kTiles;
      DescribeModel(double{rivals::kFixedRange});
    } else {
      method_.kind = NameOf(rival.arithmetic).starts_with("f64") ? "float64" : "float32";
      DescribeModel(double{std::numeric_limits<float>::max()});
    }
  }

  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    if (family.KernelsDrawIt()) return std::nullopt;
    return "kernels draw float32 vertices in window space";
  }
  // Masks that know when they are full are the one kernel without another sink.
  bool DrawsAlone() const override { return draws_alone_; }

 protected:
  void DrawTriangles(std::span<const std::uint32_t> indices, kernels::Surface& surface) override {
    kernels::KernelScene scene = family().KernelScene();
    scene.indices = indices;
    draw_(scene, surface);
  }

 private:
  void DescribeModel(double coordinate_limit) {
    model_.coordinate_limit = coordinate_limit;
    method_.space = "window";
    method_.model = model_.name;
    method_.coordinate_limit = coordinate_limit;
    method_.vertex_bytes = sizeof(kernels::KernelVertex);
  }

  KernelDrawing draw_;
  bool draws_alone_ = true;
};

// What both ways through clip space share.
class ClipSpaceContender : public SurfaceContender {
 public:
  ClipSpaceContender(kernels::Target target, kernels::Sink sink) : SurfaceContender(target, sink) {
    model_.coordinate_limit = double{std::numeric_limits<float>::max()};
    method_.space = "clip";
    method_.model = model_.name;
    method_.coordinate_limit = model_.coordinate_limit;
    method_.vertex_bytes = sizeof(kernels::ClipVertex);
  }

  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    if (family.ClipKernelsDrawIt()) return std::nullopt;
    return "it draws float32 vertices in clip space";
  }
};

class ClipContender final : public ClipSpaceContender {
 public:
  ClipContender(kernels::Target target, kernels::Sink sink) : ClipSpaceContender(target, sink) {
    method_.name = "kernel-clip";
    Describe("crossings of homogeneous edges with rows, decided exactly", "spans", "exact",
             method_);
    method_.kind = "exact";
    method_.is_proved = true;
  }

 protected:
  void DrawTriangles(std::span<const std::uint32_t> indices, kernels::Surface& surface) override {
    kernels::DrawClip(target(),
                      {family().clip_vertices, indices, surface.width(), surface.height(),
                       kernels::NearPlane::kNone},
                      surface);
  }
};

class HomogeneousContender final : public ClipSpaceContender {
 public:
  HomogeneousContender(kernels::Target target, kernels::Sink sink)
      : ClipSpaceContender(target, sink) {
    method_.name = rivals::kHomogeneous;
    Describe("crossings of homogeneous edges with rows: float32", "spans", "f32-homogeneous",
             method_);
    method_.kind = "float32";
  }

 protected:
  void DrawTriangles(std::span<const std::uint32_t> indices, kernels::Surface& surface) override {
    rivals::DrawHomogeneous(target(),
                            {family().clip_vertices, indices, surface.width(), surface.height(),
                             kernels::NearPlane::kNone},
                            surface);
  }
};

// Every draw divides all vertices by their w first, in float32.
class DividedContender final : public ClipSpaceContender {
 public:
  DividedContender(KernelDrawing draw, const BenchMethod& of, kernels::Target target,
                   kernels::Sink sink)
      : ClipSpaceContender(target, sink), draw_(std::move(draw)) {
    constexpr std::string_view kKernel = "kernel-";
    method_.name = "divided-" + of.name.substr(of.name.starts_with(kKernel) ? kKernel.size() : 0);
    method_.summary = "x / w and y / w in float32, then " + of.summary;
    method_.traversal = of.traversal;
    method_.arithmetic = "f32-divided, then " + of.arithmetic;
    method_.kind = "float32";
  }

 protected:
  void Prepare() override {
    using Four = float __attribute__((vector_size(16)));
    const auto& given = family().clip_vertices;
    // One more: four numbers are stored of a vertex that has three, its successor's first over
    // the last of them.
    divided_.resize(given.size() + 1);
    auto* to = reinterpret_cast<std::byte*>(divided_.data());
    for (const kernels::ClipVertex& v : given) {
      Four all;
      std::memcpy(&all, &v, sizeof all);
      all /= Four{v.w, v.w, v.w, v.w};
      std::memcpy(to, &all, sizeof all);
      to += sizeof(kernels::KernelVertex);
    }
  }
  void DrawTriangles(std::span<const std::uint32_t> indices, kernels::Surface& surface) override {
    draw_({divided_, indices, surface.width(), surface.height()}, surface);
  }

 private:
  KernelDrawing draw_;
  std::vector<kernels::KernelVertex> divided_;
};

class KnownContender final : public SurfaceContender {
 public:
  KnownContender(kernels::Target target, kernels::Sink sink) : SurfaceContender(target, sink) {
    method_.name = kFloor;
    Describe("spans that were found before, only written: the floor", "known spans", "none",
             method_);
    method_.kind = "floor";
    method_.space = "window";
    method_.model = model_.name;
    method_.coordinate_limit = double{std::numeric_limits<float>::max()};
    method_.vertex_bytes = sizeof(kernels::KernelVertex);
  }

  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    if (family.KernelsDrawIt()) return std::nullopt;
    if (!family.ClipKernelsDrawIt()) return "kernels find its spans, which draw float32 vertices";
    if (sink() != kernels::Sink::kDepth) return std::nullopt;
    return "planes of depths in clip space are found with the edges";
  }

  void Load(const FamilyInput& family) override {
    SurfaceContender::Load(family);
    record_ = family.ClipKernelsDrawIt()
                  ? SpanRecord(target(), {family.clip_vertices, family.indices, family.scene.width,
                                          family.scene.height, kernels::NearPlane::kNone})
                  : SpanRecord(target(), family.KernelScene());
  }

  // It knows the spans of the whole family alone.
  bool DrawsAlone() const override { return false; }
  std::vector<PixelValues> ValuesAlone(std::size_t /*triangle*/,
                                       std::span<const Pixel> /*pixels*/) override {
    return {};
  }

 protected:
  void DrawTriangles(std::span<const std::uint32_t> indices, kernels::Surface& surface) override {
    kernels::KernelScene scene = family().KernelScene();
    scene.indices = indices;
    kernels::DrawKnown(target(), record_.View(), scene, surface);
  }

 private:
  SpanRecord record_;
};

}  // namespace

std::unique_ptr<Contender> MakeKernelContender(kernels::Target target, kernels::Sink sink) {
  return std::make_unique<KernelContender>(target, sink);
}

std::unique_ptr<Contender> MakeRivalContender(const rivals::Rival& rival, kernels::Target target,
                                              kernels::Sink sink) {
  return std::make_unique<KernelContender>(rival, target, sink);
}

std::unique_ptr<Contender> MakeClipContender(kernels::Target target, kernels::Sink sink) {
  return std::make_unique<ClipContender>(target, sink);
}

std::unique_ptr<Contender> MakeHomogeneousContender(kernels::Target target, kernels::Sink sink) {
  return std::make_unique<HomogeneousContender>(target, sink);
}

std::unique_ptr<Contender> MakeDividedContender(kernels::Target target, kernels::Sink sink) {
  return std::make_unique<DividedContender>(ExactDrawing(target),
                                            KernelContender(target, sink).method(), target, sink);
}

std::unique_ptr<Contender> MakeDividedContender(const rivals::Rival& rival, kernels::Target target,
                                                kernels::Sink sink) {
  return std::make_unique<DividedContender>(
      DrawingOf(rival, target), KernelContender(rival, target, sink).method(), target, sink);
}

std::unique_ptr<Contender> MakeFloorContender(kernels::Target target, kernels::Sink sink) {
  return std::make_unique<KnownContender>(target, sink);
}

}  // namespace rasterproof::bench
