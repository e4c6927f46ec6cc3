#include "props/codec/codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "props/codec/raw_code.h"
#include "props/codec/spelled.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kFirstRecipeByte = 192;

double Spelled(CaseBuilder& builder) {
  const std::uint64_t anchor = builder.bits().Bits(8);
  return SpelledCoordinate(anchor, builder.bits().Bits(8), builder.lattice());
}

}  // namespace

Case LatticeCase(BitSource& bits, const SubjectInfo& info) {
  const int width = 1 + static_cast<int>(bits.Bits(8) % kMostSpelledSide);
  const int height = 1 + static_cast<int>(bits.Bits(8) % kMostSpelledSide);
  const auto vertices = static_cast<std::int32_t>(3 + bits.Bits(8) % (kMostSpelledVertices - 2));
  CaseBuilder builder(bits, info, width, height);
  for (std::int32_t v = 0; v < vertices; ++v) {
    const double x = Spelled(builder);
    builder.Add({x, Spelled(builder)});
  }
  const auto triangles = static_cast<std::int32_t>(1 + bits.Bits(8) % kMostSpelledTriangles);
  for (std::int32_t t = 0; t < triangles; ++t) {
    // Counted from a strip's own vertices, so that bytes that run out make a strip, not a point.
    const auto index = [&](std::int32_t k) {
      return (t + k + static_cast<std::int32_t>(bits.Bits(8))) % vertices;
    };
    const std::int32_t a = index(0);
    const std::int32_t b = index(1);
    builder.AddTriangle(a, b, index(2));
  }
  return builder.Done(Finish::kAsIs);
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
  const auto same_channel = [](const Channel& p, const Channel& q) {
    return p.name == q.name && p.interpolation == q.interpolation && p.at == q.at &&
           std::ranges::equal(p.values, q.values, {}, std::bit_cast<std::uint64_t, double>,
                              std::bit_cast<std::uint64_t, double>);
  };
  return std::ranges::equal(a.scene.vertices, b.scene.vertices, same_bits) &&
         std::ranges::equal(a.scene.channels, b.scene.channels, same_channel) &&
         a.scene.triangles == b.scene.triangles && a.scene.name == b.scene.name &&
         a.scene.width == b.scene.width && a.scene.height == b.scene.height &&
         a.scene.precision == b.scene.precision && a.scene.clip_space == b.scene.clip_space &&
         a.profile == b.profile && a.options == b.options && a.origin == b.origin;
}

}  // namespace rasterproof::props
