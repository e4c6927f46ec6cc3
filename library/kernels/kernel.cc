#include "library/kernels/kernel.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/float_environment.h"
#include "library/kernels/kernel_table.h"

namespace rasterproof::library::kernels {
namespace {

constexpr std::size_t kAlignment = 64;
constexpr std::size_t Up(std::size_t n, std::size_t unit) { return (n + unit - 1) / unit * unit; }

std::size_t BytesOfPixel(Sink sink) { return sink == Sink::kCount8 ? 1 : 4; }

// Room for a vector of 64 pixels that begins at the last one of a row.
std::ptrdiff_t PitchOf(Sink sink, int width) {
  const std::size_t pixels = Up(static_cast<std::size_t>(width), 64) + 64;
  return static_cast<std::ptrdiff_t>(sink == Sink::kMask ? pixels / 8 : pixels);
}

bool Runs([[maybe_unused]] Target target) {
#if defined(__x86_64__)
  const bool sse4 = __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt") &&
                    __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
                    __builtin_cpu_supports("f16c");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw");
  switch (target) {
    case Target::kScalar:
      return true;
    case Target::kSse4:
      return sse4;
    case Target::kAvx2:
      return avx2;
    case Target::kAvx512:
      return avx512;
    case Target::kNeon:
      break;
  }
  return false;
#elif defined(__aarch64__)
  return target == Target::kScalar || target == Target::kNeon;
#else
  return target == Target::kScalar;
#endif
}

const KernelTable& TableOf([[maybe_unused]] Target target) {
#if defined(__x86_64__)
  switch (target) {
    case Target::kScalar:
    case Target::kNeon:
      break;
    case Target::kSse4:
      return kSse4Kernels;
    case Target::kAvx2:
      return kAvx2Kernels;
    case Target::kAvx512:
      return kAvx512Kernels;
  }
#elif defined(__aarch64__)
  if (target == Target::kNeon) return kNeonKernels;
#endif
  return kScalarKernels;
}

void RequireSupported(Target target) {
  if (std::ranges::find(SupportedTargets(), target) != SupportedTargets().end()) return;
  throw InputError("target " + std::string(NameOf(target)), "this machine does not run it",
                   "choose one of SupportedTargets()");
}

void RequireSize(const Surface& surface, int width, int height) {
  if (surface.width() == width && surface.height() == height) return;
  throw InputError("surface", "its size is not the scene's", "make one of the scene's size");
}

// Small triangles are scattered over more pages of 4 KiB than a processor remembers. Where the
// system does not know the advice, nothing is lost.
void AdviseLargePages(std::byte* bytes, std::size_t size) {
#if defined(__linux__)
  constexpr std::size_t kPage = 4096;
  const auto address = std::bit_cast<std::uintptr_t>(bytes);
  const std::size_t skipped = Up(address, kPage) - address;
  if (size <= skipped + kPage) return;
  madvise(bytes + skipped, (size - skipped) / kPage * kPage, MADV_HUGEPAGE);
#else
  (void)bytes;
  (void)size;
#endif
}

void Draw(Target target, KernelFunction draw, KernelView view) {
  RequireSupported(target);
  std::array<std::uint64_t, 3> tiers{};
  view.tiers = tiers.data();
  draw(view);
}

template <class SomeScene>
KernelView ViewOfScene(const SomeScene& scene) {
  KernelView view{};
  view.vertices = scene.vertices.empty() ? nullptr : &scene.vertices.front().x;
  view.indices = scene.indices.data();
  view.triangles = scene.indices.size() / 3;
  view.width = scene.width;
  view.height = scene.height;
  return view;
}

template <class T>
T Load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

}  // namespace

std::string_view NameOf(Target target) {
  constexpr std::array<std::string_view, 5> kNames{"scalar", "sse4", "avx2", "avx512", "neon"};
  return kNames[static_cast<std::size_t>(target)];
}

std::string_view NameOf(Sink sink) {
  constexpr std::array<std::string_view, 5> kNames{"count8", "facing", "mask", "id", "depth"};
  return kNames[static_cast<std::size_t>(sink)];
}

std::span<const Target> SupportedTargets() {
  static const std::vector<Target> supported = [] {
    std::vector<Target> targets;
    std::ranges::copy_if(kTargets, std::back_inserter(targets), Runs);
    return targets;
  }();
  return supported;
}

Surface::Surface(Sink sink, int width, int height)
    : sink_(sink), width_(width), height_(height), pitch_(PitchOf(sink, width)) {
  // Room for a tile that begins in the last row.
  const std::size_t rows = Up(static_cast<std::size_t>(height), 8) + 8;
  const std::size_t bytes_of_unit = sink == Sink::kMask ? 1 : BytesOfPixel(sink);
  plane_bytes_ = Up(rows * static_cast<std::size_t>(pitch_) * bytes_of_unit, kAlignment);
  const std::size_t bytes = plane_bytes_ * (sink == Sink::kFacing ? 2 : 1) + kAlignment;
  bytes_.reserve(bytes);
  AdviseLargePages(bytes_.data(), bytes);
  bytes_.resize(bytes);
  const auto address = std::bit_cast<std::uintptr_t>(bytes_.data());
  start_ = Up(address, kAlignment) - address;
  Clear();
}

void Surface::Clear() {
  std::ranges::fill(bytes_, sink_ == Sink::kId ? std::byte{0xff} : std::byte{0});
  if (sink_ == Sink::kDepth) {
    std::fill_n(reinterpret_cast<float*>(plane(0)), plane_bytes_ / sizeof(float),
                std::numeric_limits<float>::infinity());
  }
}

std::byte* Surface::plane(int index) {
  if (index == 0) return bytes_.data() + start_;
  return sink_ == Sink::kFacing ? bytes_.data() + start_ + plane_bytes_ : nullptr;
}

std::uint64_t Surface::At(int x, int y) const {
  const std::byte* plane = bytes_.data() + start_;
  const auto pixel = static_cast<std::size_t>(y * pitch_ + x);
  switch (sink_) {
    case Sink::kCount8:
      return Load<std::uint8_t>(plane + pixel);
    case Sink::kMask:
      return (Load<std::uint8_t>(plane + y * pitch_ + (x >> 3)) >> (x & 7)) & 1;
    case Sink::kId:
    case Sink::kDepth:
      return Load<std::uint32_t>(plane + 4 * pixel);
    case Sink::kFacing:
      break;
  }
  return Load<std::uint32_t>(plane + 4 * pixel) |
         std::uint64_t{Load<std::uint32_t>(plane + plane_bytes_ + 4 * pixel)} << 32;
}

KernelView ViewOf(const KernelScene& scene) { return ViewOfScene(scene); }
KernelView ViewOf(const ClipScene& scene) {
  KernelView view = ViewOfScene(scene);
  view.near_plane = scene.near_plane;
  return view;
}

void Attach(Surface& surface, KernelView& view) {
  view.planes[0] = surface.plane(0);
  view.planes[1] = surface.plane(1);
  view.pitch = surface.pitch();
}

void Draw(Target target, const KernelScene& scene, Surface& surface) {
  RequireSupported(target);
  RequireSize(surface, scene.width, scene.height);
  const FloatEnvironment sane;  // the guesses' errors are those of rounding to nearest
  KernelView view = ViewOf(scene);
  Attach(surface, view);
  DrawExact(target, surface.sink(), view);
}

void DrawClip(Target target, const ClipScene& scene, Surface& surface) {
  RequireSupported(target);
  RequireSize(surface, scene.width, scene.height);
  const FloatEnvironment sane;
  KernelView view = ViewOf(scene);
  Attach(surface, view);
  DrawClip(target, surface.sink(), view);
}

void DrawExact(Target target, Sink sink, KernelView view) {
  Draw(target, TableOf(target).exact[static_cast<std::size_t>(sink)], view);
}

void DrawClip(Target target, Sink sink, KernelView view) {
  Draw(target, TableOf(target).clip[static_cast<std::size_t>(sink)], view);
}

void DrawExactSpans(Target target, KernelView view) {
  Draw(target, TableOf(target).exact_spans, view);
}

void DrawClipSpans(Target target, KernelView view) {
  Draw(target, TableOf(target).clip_spans, view);
}

void DrawKnown(Target target, const KnownSpans& spans, const KernelScene& scene, Surface& surface) {
  RequireSupported(target);
  RequireSize(surface, scene.width, scene.height);
  KernelView view = ViewOf(scene);
  Attach(surface, view);
  view.known = &spans;
  TableOf(target).known[static_cast<std::size_t>(surface.sink())](view);
}

void Fill(Target target, Surface& surface) {
  RequireSupported(target);
  KernelView view{};
  view.width = surface.width();
  view.height = surface.height();
  Attach(surface, view);
  TableOf(target).fill[static_cast<std::size_t>(surface.sink())](view);
}

}  // namespace rasterproof::library::kernels
