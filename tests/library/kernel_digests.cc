// What every kernel draws, in digests: machines of other kinds must print the same lines.
// Status 1: two targets of this machine draw different bits.
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "library/kernels/kernel.h"
#include "tests/library/drawn_scenes.h"

namespace rasterproof::library::kernels {
namespace {

// FNV-1a over the pixels, eight bytes each.
std::uint64_t DigestOf(const Surface& surface) {
  std::uint64_t digest = 14695981039346656037U;
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::uint64_t pixel = surface.At(x, y);
      for (int byte = 0; byte < 8; ++byte) {
        digest = (digest ^ ((pixel >> (8 * byte)) & 0xff)) * 1099511628211U;
      }
    }
  }
  return digest;
}

std::uint64_t Drawn(Sink sink, Target target, const OwnedScene& scene) {
  Surface surface(sink, scene.width, scene.height);
  Draw(target, scene.View(), surface);
  return DigestOf(surface);
}

// The same triangles as clip space, each vertex with a w of its own.
std::uint64_t DrawnClip(Sink sink, Target target, const OwnedScene& scene) {
  std::vector<ClipVertex> vertices;
  for (const KernelVertex& v : scene.vertices) {
    const float w = static_cast<float>(vertices.size() % 7) * 0.5F - 0.5F;
    vertices.push_back({v.x * w, v.y * w, v.z * w, w});
  }
  Surface surface(sink, scene.width, scene.height);
  DrawClip(target, {vertices, scene.indices, scene.width, scene.height, NearPlane::kMinusW},
           surface);
  return DigestOf(surface);
}

// Prints what `drawn` gives for the first target. Returns whether every other one gives the same.
template <class Drawing>
bool PrintDigest(const std::string& what, const Drawing& drawn) {
  const std::uint64_t digest = drawn(SupportedTargets().front());
  std::printf("%s %016llx\n", what.c_str(), static_cast<unsigned long long>(digest));
  bool same = true;
  for (const Target target : SupportedTargets()) {
    if (drawn(target) == digest) continue;
    std::fprintf(stderr, "%s: %s draws other bits than %s\n", what.c_str(),
                 std::string(NameOf(target)).c_str(),
                 std::string(NameOf(SupportedTargets().front())).c_str());
    same = false;
  }
  return same;
}

int PrintAll() {
  int status = 0;
  for (const OwnedScene& scene : DrawnScenes(100)) {
    for (const Sink sink : kSinks) {
      const std::string what = scene.name + " exact " + std::string(NameOf(sink));
      const auto drawn = [&](Target target) { return Drawn(sink, target, scene); };
      if (!PrintDigest(what, drawn)) status = 1;
    }
    for (const Sink sink : kSinks) {
      const std::string what = scene.name + " clip " + std::string(NameOf(sink));
      const auto drawn = [&](Target target) { return DrawnClip(sink, target, scene); };
      if (!PrintDigest(what, drawn)) status = 1;
    }
  }
  for (const Target target : SupportedTargets()) {
    std::fprintf(stderr, "target %s\n", std::string(NameOf(target)).c_str());
  }
  return status;
}

}  // namespace
}  // namespace rasterproof::library::kernels

int main() { return rasterproof::library::kernels::PrintAll(); }
