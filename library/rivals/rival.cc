#include "library/rivals/rival.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "library/kernels/kernel_table.h"
#include "library/rivals/rival_table.h"

namespace rasterproof::library::rivals {
namespace {

using kernels::Sink;
using kernels::Target;

// A table is as long as the list.
static_assert(sizeof(RivalTable::draw) == kRivals.size() * sizeof(kernels::KernelFunction[5]));

// Nothing for an instruction set that rivals are not compiled for.
const RivalTable* TableOf(Target target) {
#if defined(__x86_64__)
  if (target == Target::kAvx2) return &kAvx2Rivals;
  if (target == Target::kAvx512) return &kAvx512Rivals;
#endif
  return target == Target::kScalar ? &kScalarRivals : nullptr;
}

kernels::KernelFunction FunctionOf(const Rival& rival, Target target, Sink sink) {
  const RivalTable* const table = TableOf(target);
  const auto row = static_cast<std::size_t>(std::ranges::find(kRivals, rival) - kRivals.begin());
  if (table == nullptr || row == kRivals.size()) return nullptr;
  return table->draw[row][static_cast<std::size_t>(sink)];
}

void RequireDrawn(bool is_drawn, const std::string& name, Target target,
                  const kernels::Surface& surface, int width, int height) {
  const auto targets = kernels::SupportedTargets();
  if (!is_drawn || std::ranges::find(targets, target) == targets.end()) {
    throw InputError("rival " + name,
                     "it does not draw into the sink " + std::string(NameOf(surface.sink())) +
                         " by " + std::string(NameOf(target)),
                     "ask Draws() first");
  }
  if (surface.width() != width || surface.height() != height) {
    throw InputError("surface", "its size is not the scene's", "make one of the scene's size");
  }
}

// Of the rivals that were kernels before there was a frame, which subjects are called by.
std::string_view OldNameOf(const Rival& rival) {
  if (rival == kTwin) return "kernel-exact-unsafe";
  if (rival.traversal == Traversal::kRows) return "kernel-incremental";
  if (rival.traversal == Traversal::kMaskTiles) return "kernel-mask-rows";
  const bool is_spans = rival.traversal == Traversal::kSpans;
  if (is_spans && rival.arithmetic == Arithmetic::kFloat32Direct) return "kernel-scanline";
  if (!is_spans && rival.arithmetic == Arithmetic::kFloat32Stepped) return "kernel-tiles";
  if (!is_spans && rival.arithmetic == Arithmetic::kInt32) return "kernel-fixed-tiles";
  return "";
}

std::string_view InWords(Arithmetic arithmetic) {
  constexpr std::array<std::string_view, 9> kWords{"float32 from an end",
                                                   "float32 A x + B y + C",
                                                   "float32 stepped",
                                                   "float64 from an end",
                                                   "float64 A x + B y + C",
                                                   "float64 stepped",
                                                   "vertices on 1/256 pixel, 32 bits a tile",
                                                   "vertices on 1/256 pixel, 64 bits",
                                                   "the exact kernel without its checks"};
  return kWords[static_cast<std::size_t>(arithmetic)];
}

}  // namespace

std::string_view NameOf(Traversal traversal) {
  constexpr std::array<std::string_view, 4> kNames{"tiles", "spans", "rows", "mask-tiles"};
  return kNames[static_cast<std::size_t>(traversal)];
}

std::string_view NameOf(Arithmetic arithmetic) {
  constexpr std::array<std::string_view, 9> kNames{"f32", "f32-affine", "f32-stepped",
                                                   "f64", "f64-affine", "f64-stepped",
                                                   "i32", "i64",        "exact, unchecked"};
  return kNames[static_cast<std::size_t>(arithmetic)];
}

std::string NameOf(const Rival& rival) {
  const std::string_view old = OldNameOf(rival);
  if (!old.empty()) return std::string(old);
  return std::string(NameOf(rival.traversal)) + "-" + std::string(NameOf(rival.arithmetic));
}

std::string SummaryOf(const Rival& rival) {
  constexpr std::array<std::string_view, 4> kWays{
      "8x8 tiles: ", "crossings of edges with rows: ", "the box, 32 pixels at a time: ",
      "crossings into tiles that know when full: "};
  return std::string(kWays[static_cast<std::size_t>(rival.traversal)]) +
         std::string(InWords(rival.arithmetic));
}

std::optional<Rival> FindRival(std::string_view name) {
  for (const Rival& rival : kRivals) {
    if (NameOf(rival) == name) return rival;
  }
  return std::nullopt;
}

bool Draws(const Rival& rival, Target target, Sink sink) {
  return FunctionOf(rival, target, sink) != nullptr;
}

Target WidestTarget() {
  Target widest = Target::kScalar;
  for (const Target target : kernels::SupportedTargets()) {
    if (TableOf(target) != nullptr) widest = target;
  }
  return widest;
}

bool DrawsHomogeneous(Target target, Sink sink) {
  const RivalTable* const table = TableOf(target);
  return table != nullptr && table->homogeneous[static_cast<std::size_t>(sink)] != nullptr;
}

void DrawHomogeneous(Target target, const kernels::ClipScene& scene, kernels::Surface& surface) {
  const bool is_drawn = DrawsHomogeneous(target, surface.sink());
  RequireDrawn(is_drawn, std::string(kHomogeneous), target, surface, scene.width, scene.height);
  if (scene.near_plane != kernels::NearPlane::kNone) {
    throw InputError("scene", "this rival knows no near plane", "give kNone");
  }
  kernels::KernelView view = kernels::ViewOf(scene);
  kernels::Attach(surface, view);
  TableOf(target)->homogeneous[static_cast<std::size_t>(surface.sink())](view);
}

void Draw(const Rival& rival, Target target, const kernels::KernelScene& scene,
          kernels::Surface& surface) {
  const kernels::KernelFunction draw = FunctionOf(rival, target, surface.sink());
  RequireDrawn(draw != nullptr, NameOf(rival), target, surface, scene.width, scene.height);
  kernels::KernelView view = kernels::ViewOf(scene);
  kernels::Attach(surface, view);
  std::array<std::uint64_t, 3> tiers{};
  view.tiers = tiers.data();
  std::vector<std::uint32_t> words;
  std::vector<std::uint64_t> full;
  if (rival.traversal == Traversal::kMaskTiles) {
    // A strip more than the width has, and rows for a tile that begins in the last one.
    const std::size_t height = (static_cast<std::size_t>(scene.height) + 7) / 8 * 8 + 8;
    const std::size_t strips = (static_cast<std::size_t>(scene.width) + 31) / 32 + 1;
    const std::size_t full_pitch = (strips + 63) / 64;
    words.resize(strips * height);
    full.resize(height / 8 * full_pitch);
    view.strips = words.data();
    view.strip_height = static_cast<std::ptrdiff_t>(height);
    view.full_tiles = full.data();
    view.full_pitch = static_cast<std::ptrdiff_t>(full_pitch);
  }
  draw(view);
}

}  // namespace rasterproof::library::rivals
