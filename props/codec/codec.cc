#include "props/codec/codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "props/domains/domain.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kFirstRecipeByte = 192;
constexpr int kMostSide = 32;
constexpr int kMostTriangles = 8;
constexpr int kMostVertices = 16;
// Anchors from here on stand for magnitudes 2^7, 2^8, ... of either sign; the others count half
// pixels from -4 on and start again past the largest target.
constexpr std::uint64_t kFirstFarAnchor = 240;
constexpr std::uint64_t kHalfPixels = 80;
constexpr double kFirstPixel = -4;

// The second byte of a coordinate: below 128 the half pixel itself, so that a sixteenth of all
// edges join two of them; then some steps of the lattice beside it; then a subpixel.
constexpr std::uint64_t kFirstStep = 128;
constexpr std::uint64_t kFirstSubpixel = 192;
constexpr std::array<int, 8> kSteps{1, -1, 2, -2, 3, -3, 16, -16};

double Spelled(Sketch& sketch) {
  const std::uint64_t anchor = sketch.bits().Bits(8);
  const std::uint64_t fine = sketch.bits().Bits(8);
  const double subpixel =
      fine < kFirstSubpixel ? 0 : std::ldexp(static_cast<double>(fine - kFirstSubpixel), -6);
  double x = kFirstPixel + (static_cast<double>(anchor % kHalfPixels) + subpixel) / 2;
  if (anchor >= kFirstFarAnchor) {
    const auto far = static_cast<int>(anchor - kFirstFarAnchor);
    x = std::ldexp(far % 2 == 0 ? 1.0 : -1.0, 7 + far / 2) * (1 + subpixel);
  }
  x = sketch.lattice().RoundWithinLimit(x);
  const bool steps = fine >= kFirstStep && fine < kFirstSubpixel;
  return steps ? sketch.lattice().Move(x, kSteps[fine & 7]) : x;
}

// One coordinate of an example: a whole or half pixel, and `step` steps from it.
void Spell(std::vector<std::uint8_t>& bytes, double x, int step) {
  const auto place = std::ranges::find(kSteps, step) - kSteps.begin();
  const auto code =
      static_cast<std::uint8_t>(step == 0 ? 0 : static_cast<std::ptrdiff_t>(kFirstStep) + place);
  bytes.push_back(static_cast<std::uint8_t>(2 * (x - kFirstPixel)));
  bytes.push_back(code);
}

struct ExampleVertex {
  double x = 0;
  double y = 0;
  int step = 0;  ///< of x
};

CodecExample Example(std::string name, const std::vector<ExampleVertex>& vertices,
                     const std::vector<std::array<std::uint8_t, 3>>& triangles) {
  CodecExample example{std::move(name), {0, 11, 11}};  // spelled out, 12 x 12
  example.bytes.push_back(static_cast<std::uint8_t>(vertices.size() - 3));
  for (const ExampleVertex& v : vertices) {
    Spell(example.bytes, v.x, v.step);
    Spell(example.bytes, v.y, 0);
  }
  example.bytes.push_back(static_cast<std::uint8_t>(triangles.size() - 1));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t place = (t + k) % vertices.size();
      example.bytes.push_back(
          static_cast<std::uint8_t>((triangles[t][k] + vertices.size() - place) % vertices.size()));
    }
  }
  return example;
}

}  // namespace

Case LatticeCase(BitSource& bits, const SubjectInfo& info) {
  const int width = 1 + static_cast<int>(bits.Bits(8) % kMostSide);
  const int height = 1 + static_cast<int>(bits.Bits(8) % kMostSide);
  const auto vertices = static_cast<std::int32_t>(3 + bits.Bits(8) % (kMostVertices - 2));
  Sketch sketch(bits, info, width, height);
  for (std::int32_t v = 0; v < vertices; ++v) {
    const double x = Spelled(sketch);
    sketch.Add({x, Spelled(sketch)});
  }
  const auto triangles = static_cast<std::int32_t>(1 + bits.Bits(8) % kMostTriangles);
  for (std::int32_t t = 0; t < triangles; ++t) {
    // Counted from a strip's own vertices, so that bytes that run out make a strip, not a point.
    const auto index = [&](std::int32_t k) {
      return (t + k + static_cast<std::int32_t>(bits.Bits(8))) % vertices;
    };
    const std::int32_t a = index(0);
    const std::int32_t b = index(1);
    sketch.AddTriangle(a, b, index(2));
  }
  return sketch.Done(Finish::kAsIs);
}

Case DecodeCase(std::span<const std::uint8_t> bytes, const SubjectInfo& info) {
  ByteSource source(bytes);
  if (source.Bits(8) < kFirstRecipeByte) return LatticeCase(source, info);
  const Domain* domain = DomainOfNumber(static_cast<std::uint16_t>(source.Bits(8)));
  if (domain == nullptr || !Suits(*domain, info)) return LatticeCase(source, info);
  Case c = domain->draw(source, info);
  c.scene.name = domain->name;
  return c;
}

std::vector<CodecExample> CodecExamples() {
  std::vector<CodecExample> examples{
      Example("triangle-on-centres", {{1.5, 1.5}, {1.5, 9.5}, {9.5, 1.5}}, {{0, 1, 2}}),
      Example("triangle-on-corners", {{1, 1}, {1, 9}, {9, 1}}, {{0, 1, 2}}),
      Example("quad-through-centres", {{0.5, 0.5}, {0.5, 10.5}, {10.5, 10.5}, {10.5, 0.5}},
              {{0, 1, 2}, {0, 2, 3}}),
      Example("quad-one-step-off", {{0.5, 0.5, 1}, {0.5, 10.5}, {10.5, 10.5, -1}, {10.5, 0.5}},
              {{0, 1, 2}, {0, 2, 3}}),
      Example("fan-on-a-centre", {{5.5, 5.5}, {0, 0}, {0, 11}, {11, 11}, {11, 0}},
              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}),
      Example("fold", {{2.5, 2.5}, {2.5, 8.5}, {8.5, 2.5}, {3.5, 3.5}}, {{0, 1, 2}, {2, 1, 3}}),
      Example("zero-area", {{1.5, 1.5}, {4.5, 4.5}, {9.5, 9.5}}, {{0, 1, 2}, {0, 0, 1}}),
      Example("both-windings", {{1.5, 1.5}, {1.5, 9.5}, {9.5, 1.5}}, {{0, 1, 2}, {0, 2, 1}}),
  };
  constexpr std::uint64_t kExampleBytes = 96;
  constexpr std::uint16_t kLargestByte = 255;
  for (const Domain& domain : Domains()) {
    if (domain.is_stated != nullptr) continue;  // few subjects would decode it to that
    if (domain.number > kLargestByte) continue;
    CodecExample example{
        std::string(domain.name),
        {static_cast<std::uint8_t>(kFirstRecipeByte), static_cast<std::uint8_t>(domain.number)}};
    PhiloxSource random(0, domain.number - std::uint64_t{1});
    for (std::uint64_t i = 0; i < kExampleBytes; ++i) {
      example.bytes.push_back(static_cast<std::uint8_t>(random.Bits(8)));
    }
    examples.push_back(std::move(example));
  }
  return examples;
}

}  // namespace rasterproof::props
