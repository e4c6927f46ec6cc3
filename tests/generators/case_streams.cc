#include "tests/generators/case_streams.h"

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/scene.h"
#include "core/vertex.h"
#include "fuzz/fuzz_target.h"
#include "props/codec/codec.h"
#include "props/domains/bit_source.h"
#include "props/run/campaign.h"

namespace rasterproof::generators {
namespace {

constexpr std::array<std::string_view, 5> kNames{"uniform", "rapidcheck", "domains", "code-bytes",
                                                 "raw-bytes"};
// Of Philox, which no domain has: their numbers are 16 bits.
constexpr std::uint64_t kStream = 1 << 20;
constexpr std::uint64_t kMostBytes = 128;
constexpr int kSizes = 101;  // of rc::check's defaults

double OfPrecision(double x, Precision precision) {
  return precision == Precision::kFloat32 ? double{static_cast<float>(x)} : x;
}

// A triangle, or a quad split by its diagonal, without places yet.
Case Shape(const SubjectInfo& info, bool is_quad) {
  Case c;
  c.profile = info.profile;
  c.scene.width = c.scene.height = kSide;
  c.scene.precision = info.input;
  c.scene.clip_space = !info.takes_window;
  c.scene.vertices.resize(is_quad ? 4 : 3);
  c.scene.triangles.push_back({0, 1, 2});
  if (is_quad) c.scene.triangles.push_back({0, 2, 3});
  return c;
}

class Uniform final : public CaseStream {
 public:
  Uniform(const SubjectInfo& info, std::uint64_t seed) : info_(info), seed_(seed) {}

  Case Next() override {
    props::PhiloxSource bits(seed_, next_++, kStream);
    Case c = Shape(info_, bits.Chance(128));
    const auto unit = [&] { return static_cast<double>(bits.Bits(53)) * 0x1p-53; };
    for (Vertex& v : c.scene.vertices) {
      if (c.scene.clip_space) v.w = OfPrecision(0.125 + 7.875 * unit(), info_.input);
      v.x = OfPrecision(v.w * (unit() * 2 * kSide - kSide / 2.0), info_.input);
      v.y = OfPrecision(v.w * (unit() * 2 * kSide - kSide / 2.0), info_.input);
    }
    return c;
  }

 private:
  const SubjectInfo& info_;
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

class RapidCheckDefaults final : public CaseStream {
 public:
  RapidCheckDefaults(const SubjectInfo& info, std::uint64_t seed) : info_(info), random_(seed) {}

  Case Next() override {
    size_ = (size_ + 1) % kSizes;
    Case c = Shape(info_, Draw<bool>());
    for (Vertex& v : c.scene.vertices) {
      v.x = Coordinate();
      v.y = Coordinate();
      if (c.scene.clip_space) v.w = Coordinate();
    }
    return c;
  }

 private:
  template <class T>
  T Draw() {
    return rc::gen::arbitrary<T>()(random_.split(), size_).value();
  }
  double Coordinate() {
    return info_.input == Precision::kFloat32 ? double{Draw<float>()} : Draw<double>();
  }

  const SubjectInfo& info_;
  rc::Random random_;
  int size_ = -1;
};

class OurDomains final : public CaseStream {
 public:
  OurDomains(const SubjectInfo& info, std::vector<const props::Property*> properties,
             std::uint64_t seed)
      : info_(info), properties_(std::move(properties)), seed_(seed) {}

  Case Next() override {
    const std::uint64_t n = next_++;
    const props::Property& property = *properties_[n % properties_.size()];
    return props::DrawCase(info_, property, seed_, n / properties_.size());
  }

 private:
  const SubjectInfo& info_;
  std::vector<const props::Property*> properties_;
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

class RandomBytes final : public CaseStream {
 public:
  RandomBytes(const SubjectInfo& info, bool raw, std::uint64_t seed)
      : info_(info), raw_(raw), seed_(seed) {}

  Case Next() override {
    props::PhiloxSource bits(seed_, next_++, kStream);
    std::vector<std::uint8_t> bytes(1 + bits.Bits(32) % kMostBytes);
    std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(bits.Bits(8)); });
    Case c = props::DecodeCase(raw_ ? fuzz::FloatsOf(bytes, info_) : bytes, info_);
    if (!fuzz::Limits{}.Admit(c)) c.scene.triangles.clear();
    return c;
  }

 private:
  const SubjectInfo& info_;
  bool raw_;
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

}  // namespace

std::span<const std::string_view> StreamNames() { return kNames; }

std::unique_ptr<CaseStream> MakeStream(std::string_view name, const SubjectInfo& info,
                                       const std::vector<const props::Property*>& properties,
                                       std::uint64_t seed) {
  if (name == "uniform") return std::make_unique<Uniform>(info, seed);
  if (name == "rapidcheck") return std::make_unique<RapidCheckDefaults>(info, seed);
  if (name == "domains") return std::make_unique<OurDomains>(info, properties, seed);
  if (name == "code-bytes") return std::make_unique<RandomBytes>(info, false, seed);
  if (name == "raw-bytes") return std::make_unique<RandomBytes>(info, true, seed);
  return nullptr;
}

}  // namespace rasterproof::generators
