#include "props/codec/codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "props/codec/raw_code.h"
#include "props/codec/spelled.h"
#include "props/domains/domain.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kFirstRecipeByte = 192;
double Spelled(Sketch& sketch) {
  const std::uint64_t anchor = sketch.bits().Bits(8);
  return SpelledCoordinate(anchor, sketch.bits().Bits(8), sketch.lattice());
}

// One coordinate of an example: a whole or half pixel, and `step` steps from it.
void Spell(std::vector<std::uint8_t>& bytes, double x, int step) {
  const auto place = std::ranges::find(kSpelledSteps, step) - kSpelledSteps.begin();
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
  const int width = 1 + static_cast<int>(bits.Bits(8) % kMostSpelledSide);
  const int height = 1 + static_cast<int>(bits.Bits(8) % kMostSpelledSide);
  const auto vertices = static_cast<std::int32_t>(3 + bits.Bits(8) % (kMostSpelledVertices - 2));
  Sketch sketch(bits, info, width, height);
  for (std::int32_t v = 0; v < vertices; ++v) {
    const double x = Spelled(sketch);
    sketch.Add({x, Spelled(sketch)});
  }
  const auto triangles = static_cast<std::int32_t>(1 + bits.Bits(8) % kMostSpelledTriangles);
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
  if (IsRawCode(bytes)) return RawCase(bytes, info);
  ByteSource source(bytes);
  if (source.Bits(8) < kFirstRecipeByte) return LatticeCase(source, info);
  const Domain* domain = DomainOfNumber(static_cast<std::uint16_t>(source.Bits(8)));
  if (domain == nullptr || !Suits(*domain, info)) return LatticeCase(source, info);
  Case c = domain->draw(source, info);
  c.scene.name = domain->name;
  return c;
}

std::vector<std::uint8_t> EncodeCase(const Case& c, const SubjectInfo& info) {
  std::optional<std::vector<std::uint8_t>> spelled = SpellCase(c, info);
  if (spelled && SameCase(DecodeCase(*spelled, info), c)) return *std::move(spelled);
  return RawCodeOf(c);
}

bool SameCase(const Case& a, const Case& b) {
  const auto same_bits = [](const Vertex& v, const Vertex& w) {
    using Bits = std::array<std::uint64_t, 4>;
    return std::bit_cast<Bits>(v) == std::bit_cast<Bits>(w);
  };
  return std::ranges::equal(a.scene.vertices, b.scene.vertices, same_bits) &&
         a.scene.triangles == b.scene.triangles && a.scene.name == b.scene.name &&
         a.scene.width == b.scene.width && a.scene.height == b.scene.height &&
         a.scene.precision == b.scene.precision && a.scene.clip_space == b.scene.clip_space &&
         a.profile == b.profile && a.options == b.options && a.origin == b.origin;
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
