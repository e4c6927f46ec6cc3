#include "props/codec/raw_code.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <string>

#include "model/target_profile.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::props {
namespace {

constexpr std::uint8_t kRawByte = 255;
constexpr std::uint8_t kNoDomain = 0;

enum RawFlag : unsigned {
  kDouble = 1,
  kIsClip = 2,
  kHasZ = 4,
  kHasW = 8,
  kHasTile = 16,
  kHasThreads = 32,
  kHasScissor = 64,
  kIsNamed = 128
};

constexpr std::uint64_t kMostTile = kMaxTargetSide;
constexpr std::uint64_t kMostThreads = 4096;
constexpr std::uint64_t kMostListed = std::uint64_t{1} << 18;

class RawReader {
 public:
  explicit RawReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint64_t Bytes(std::size_t count) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < count && next_ < bytes_.size(); ++k) {
      bits |= std::uint64_t{bytes_[next_++]} << (8 * k);
    }
    return bits;
  }
  std::uint64_t Count() {
    std::uint64_t count = 0;
    for (int shift = 0; shift < 63; shift += 7) {
      const std::uint64_t byte = Bytes(1);
      count |= (byte & 127) << shift;
      if (byte < 128) break;
    }
    return count;
  }
  // Reads a count of things of `bytes_each` bytes, limited to what the remaining bytes can hold.
  std::size_t CountOf(std::size_t bytes_each) {
    const std::size_t left = (bytes_.size() - next_) / bytes_each + 1;
    return static_cast<std::size_t>(std::min<std::uint64_t>({Count(), left, kMostListed}));
  }
  std::string Text() {
    std::string text(CountOf(1), '\0');
    for (char& c : text) c = static_cast<char>(Bytes(1));
    return text;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

class RawWriter {
 public:
  void Bytes(std::uint64_t bits, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      bytes_.push_back(static_cast<std::uint8_t>(bits >> (8 * k)));
    }
  }
  void Count(std::uint64_t count) {
    for (; count >= 128; count >>= 7) Bytes((count & 127) | 128, 1);
    Bytes(count, 1);
  }
  void Text(const std::string& text) {
    Count(text.size());
    for (const char c : text) Bytes(static_cast<std::uint8_t>(c), 1);
  }
  std::vector<std::uint8_t> Take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

double ReadFloat(RawReader& reader, bool is_double) {
  if (is_double) return std::bit_cast<double>(reader.Bytes(8));
  return std::bit_cast<float>(static_cast<std::uint32_t>(reader.Bytes(4)));
}

void WriteFloat(RawWriter& writer, double x, bool is_double) {
  if (is_double) return writer.Bytes(std::bit_cast<std::uint64_t>(x), 8);
  writer.Bytes(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
}

bool HasZ(const Vertex& v) { return std::bit_cast<std::uint64_t>(v.z) != 0; }
bool HasW(const Vertex& v) { return !(v.w == 1); }

unsigned FlagsOf(const Case& c) {
  const Scene& scene = c.scene;
  unsigned flags = 0;
  if (scene.precision == Precision::kFloat64) flags |= kDouble;
  if (scene.clip_space) flags |= kIsClip;
  if (std::ranges::any_of(scene.vertices, HasZ)) flags |= kHasZ;
  if (std::ranges::any_of(scene.vertices, HasW)) flags |= kHasW;
  if (c.options.tile != 0) flags |= kHasTile;
  if (c.options.threads != 1) flags |= kHasThreads;
  if (c.options.scissor) flags |= kHasScissor;
  if (!scene.name.empty() || !c.origin.empty()) flags |= kIsNamed;
  return flags;
}

int Within(std::uint64_t x, std::uint64_t most) { return static_cast<int>(x % (most + 1)); }

PixelRect ReadScissor(RawReader& reader) {
  PixelRect rect;
  for (int* const side : {&rect.x0, &rect.y0, &rect.x1, &rect.y1}) {
    *side = static_cast<int>(static_cast<std::uint32_t>(reader.Bytes(4)));
  }
  return rect;
}

void ReadOptions(RawReader& reader, unsigned flags, DrawOptions& options) {
  if ((flags & kHasTile) != 0) options.tile = Within(reader.Count(), kMostTile);
  if ((flags & kHasThreads) != 0) options.threads = Within(reader.Count(), kMostThreads);
  if ((flags & kHasScissor) != 0) options.scissor = ReadScissor(reader);
}

void ReadLists(RawReader& reader, unsigned flags, Scene& scene) {
  const bool is_double = (flags & kDouble) != 0;
  const std::size_t vertices = reader.CountOf(is_double ? 16 : 8);
  const std::size_t triangles = reader.CountOf(3);
  for (std::size_t k = 0; k < vertices; ++k) {
    Vertex v;
    v.x = ReadFloat(reader, is_double);
    v.y = ReadFloat(reader, is_double);
    if ((flags & kHasZ) != 0) v.z = ReadFloat(reader, is_double);
    if ((flags & kHasW) != 0) v.w = ReadFloat(reader, is_double);
    scene.vertices.push_back(v);
  }
  if (vertices == 0) return;
  for (std::size_t k = 0; k < triangles; ++k) {
    Triangle& t = scene.triangles.emplace_back();
    for (std::int32_t& index : t) index = static_cast<std::int32_t>(reader.Count() % vertices);
  }
}

// Of what the bytes say, what the subject takes.
void FitTo(const SubjectInfo& info, Case& c) {
  Scene& scene = c.scene;
  if (!info.takes_tiles) c.options.tile = 0;
  if (!info.takes_scissor) c.options.scissor.reset();
  if (!info.takes_culling) c.options.cull = Cull::kNone;
  scene.clip_space = info.takes_clip && (scene.clip_space || !info.takes_window);
  if (!scene.clip_space) {
    for (Vertex& v : scene.vertices) v.w = 1;
  }
  if (Takes(info, scene)) return;
  const std::optional<FixedInput>& fixed = info.profile.fixed;
  scene.precision = fixed ? PrecisionOf(*fixed) : Precision::kFloat32;
  const InputLattice lattice(TargetProfile(info.profile, scene), scene.precision);
  for (Vertex& v : scene.vertices) {
    for (double* const x : {&v.x, &v.y}) {
      if (fixed) *x = std::isfinite(*x) ? lattice.RoundWithinLimit(*x) : 0;
      *x = lattice.RoundToPrecision(*x);
    }
    v.z = lattice.RoundToFloat(v.z);
    v.w = lattice.RoundToFloat(v.w);
  }
  if (scene.precision == Precision::kFloat64) return;
  for (Vertex& v : scene.vertices) {
    // Of a NaN, the bits that a float has.
    for (double* const x : {&v.x, &v.y, &v.z, &v.w}) {
      if (std::isnan(*x)) *x = static_cast<float>(*x);
    }
  }
}

}  // namespace

bool IsRawCode(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 2 && bytes[0] == kRawByte && bytes[1] == kNoDomain;
}

Case RawCase(std::span<const std::uint8_t> bytes, const SubjectInfo& info) {
  RawReader reader(bytes.subspan(2));
  Case c;
  c.profile = info.profile;
  Scene& scene = c.scene;
  const auto flags = static_cast<unsigned>(reader.Bytes(1));
  scene.precision = (flags & kDouble) != 0 ? Precision::kFloat64 : Precision::kFloat32;
  scene.clip_space = (flags & kIsClip) != 0;
  c.options.cull = static_cast<Cull>(reader.Bytes(1) % 3);
  scene.width = 1 + static_cast<int>(reader.Bytes(2));
  const std::int64_t row = std::int64_t{scene.width} * info.profile.pattern.samples();
  const auto highest =
      static_cast<int>(std::min<std::int64_t>(kMaxTargetSide, kMaxTargetSamples / row));
  scene.height = std::min(highest, 1 + static_cast<int>(reader.Bytes(2)));
  ReadOptions(reader, flags, c.options);
  ReadLists(reader, flags, scene);
  if ((flags & kIsNamed) != 0) {
    scene.name = reader.Text();
    c.origin = reader.Text();
  }
  FitTo(info, c);
  return c;
}

std::vector<std::uint8_t> RawCodeOf(const Case& c) {
  const unsigned flags = FlagsOf(c);
  const bool is_double = (flags & kDouble) != 0;
  const Scene& scene = c.scene;
  RawWriter writer;
  writer.Bytes(kRawByte, 1);
  writer.Bytes(kNoDomain, 1);
  writer.Bytes(flags, 1);
  writer.Bytes(static_cast<std::uint64_t>(c.options.cull), 1);
  writer.Bytes(static_cast<std::uint64_t>(scene.width - 1), 2);
  writer.Bytes(static_cast<std::uint64_t>(scene.height - 1), 2);
  const auto count = [&](int x) { writer.Count(static_cast<std::uint64_t>(x)); };
  if ((flags & kHasTile) != 0) count(c.options.tile);
  if ((flags & kHasThreads) != 0) count(c.options.threads);
  if (const auto& rect = c.options.scissor) {
    for (const int side : {rect->x0, rect->y0, rect->x1, rect->y1}) {
      writer.Bytes(static_cast<std::uint32_t>(side), 4);
    }
  }
  writer.Count(scene.vertices.size());
  writer.Count(scene.triangles.size());
  for (const Vertex& v : scene.vertices) {
    WriteFloat(writer, v.x, is_double);
    WriteFloat(writer, v.y, is_double);
    if ((flags & kHasZ) != 0) WriteFloat(writer, v.z, is_double);
    if ((flags & kHasW) != 0) WriteFloat(writer, v.w, is_double);
  }
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) count(index);
  }
  if ((flags & kIsNamed) != 0) {
    writer.Text(scene.name);
    writer.Text(c.origin);
  }
  return writer.Take();
}

}  // namespace rasterproof::props
