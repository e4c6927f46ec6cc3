#include "props/domains/case_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/target_profile.h"

namespace rasterproof::props {
namespace {

constexpr std::array<int, 8> kTiles{1, 2, 3, 4, 7, 8, 16, 64};

int DrawSide(BitSource& bits) {
  const std::int64_t kind = bits.Int(0, 7);
  if (kind == 0) return static_cast<int>(bits.Int(1, 7));
  if (kind == 1) return static_cast<int>(bits.Int(25, 48));
  return static_cast<int>(bits.Int(8, 24));
}

// A float64 subject also takes float32 scenes, and some of its worst cases are such.
Precision DrawPrecision(BitSource& bits, const SubjectInfo& info) {
  if (info.profile.fixed) return PrecisionOf(*info.profile.fixed);
  if (info.input == Precision::kFloat32 || bits.Chance(64)) return Precision::kFloat32;
  return Precision::kFloat64;
}

}  // namespace

CaseBuilder::CaseBuilder(BitSource& source, const SubjectInfo& info)
    : CaseBuilder(source, info, 1, 1) {
  const LargestTarget& most = info.profile.max_target;
  case_.scene.width = std::min(DrawSide(source), most.width);
  case_.scene.height = std::min(DrawSide(source), most.height);
  if (info.profile.by_target_size.empty()) return;
  profile_ = TargetProfile(info.profile, width(), height());
  lattice_ = InputLattice(profile_, lattice_.precision());
}

CaseBuilder::CaseBuilder(BitSource& source, const SubjectInfo& info, int width, int height)
    : bits_(&source),
      info_(&info),
      profile_(info.profile, std::min(width, info.profile.max_target.width),
               std::min(height, info.profile.max_target.height)),
      lattice_(profile_, DrawPrecision(source, info)) {
  case_.scene.width = std::min(width, info.profile.max_target.width);
  case_.scene.height = std::min(height, info.profile.max_target.height);
  case_.scene.precision = lattice_.precision();
  case_.profile = info.profile;
}

Point2 CaseBuilder::Sample() {
  const int i = static_cast<int>(bits_->Int(0, width() - 1));
  const int j = static_cast<int>(bits_->Int(0, height() - 1));
  const int s = static_cast<int>(bits_->Int(0, profile().pattern.samples() - 1));
  return profile().pattern.At(i, j, s);
}

double CaseBuilder::Coordinate(int extent, bool along_y) {
  const int margin = extent / 4 + 2;
  const std::int64_t kind = bits_->Int(0, 7);
  const auto pixel = static_cast<double>(bits_->Int(-margin, extent + margin));
  double x = pixel;
  if (kind < 4) {
    const Point2 place = bits_->OneOf(std::span<const Point2>(profile().pattern.locations));
    x = pixel + (along_y ? place.y : place.x);
  } else if (kind == 4) {
    x = pixel + (bits_->Chance(128) ? 0.5 : 0.0);
  } else {
    x = Uniform(-margin, extent + margin);
  }
  x = lattice_.Round(x);
  return bits_->Chance(32) ? lattice_.Move(x, bits_->Int(-2, 2)) : x;
}

double CaseBuilder::Uniform(double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(bits_->Bits(53)), -53);
}

double CaseBuilder::LogUniform(int low, int high) {
  const double mantissa = 1.0 + std::ldexp(static_cast<double>(bits_->Bits(52)), -52);
  const auto exponent = static_cast<int>(bits_->Int(low, high));
  return Sign() * std::ldexp(mantissa, exponent);
}

std::int32_t CaseBuilder::Add(Point2 p) {
  if (!within_limit_) return AddRaw({lattice_.Round(p.x), lattice_.Round(p.y)});
  return AddRaw({lattice_.RoundWithinLimit(p.x), lattice_.RoundWithinLimit(p.y)});
}

std::int32_t CaseBuilder::AddRaw(const Vertex& v) {
  case_.scene.vertices.push_back({lattice_.RoundToPrecision(v.x), lattice_.RoundToPrecision(v.y),
                                  lattice_.RoundToFloat(v.z), lattice_.RoundToFloat(v.w)});
  return static_cast<std::int32_t>(case_.scene.vertices.size() - 1);
}

void CaseBuilder::AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c) {
  case_.scene.triangles.push_back({a, b, c});
}

void CaseBuilder::AddTriangle(const std::array<Point2, 3>& v) {
  const std::int32_t a = Add(v[0]);
  const std::int32_t b = Add(v[1]);
  AddTriangle(a, b, Add(v[2]));
}

void CaseBuilder::OrderTriangles(Finish finish) {
  if (finish == Finish::kAsIs) return;
  const bool reverse_all = bits_->Chance(128);
  std::vector<Triangle>& triangles = case_.scene.triangles;
  for (Triangle& t : triangles) {
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(bits_->Int(0, 2)), t.end());
    if (finish == Finish::kMesh ? reverse_all : bits_->Chance(128)) std::swap(t[1], t[2]);
  }
  if (!bits_->Chance(128)) return;
  for (std::size_t i = triangles.size(); i > 1; --i) {
    std::swap(triangles[i - 1],
              triangles[static_cast<std::size_t>(bits_->Int(0, static_cast<std::int64_t>(i) - 1))]);
  }
}

void CaseBuilder::RepeatSharedVertices() {
  std::vector<Vertex> repeated;
  for (Triangle& t : case_.scene.triangles) {
    for (std::int32_t& index : t) {
      repeated.push_back(case_.scene.vertices[static_cast<std::size_t>(index)]);
      index = static_cast<std::int32_t>(repeated.size() - 1);
    }
  }
  case_.scene.vertices = std::move(repeated);
}

void CaseBuilder::DrawOptionsFor(Finish finish) {
  DrawOptions& options = case_.options;
  if (bits_->Chance(64)) options.tile = bits_->OneOf(std::span<const int>(kTiles));
  if (bits_->Chance(32)) options.threads = static_cast<int>(bits_->Int(1, 4));
  if (finish == Finish::kMesh) return;
  if (bits_->Chance(24)) {
    const int x0 = static_cast<int>(bits_->Int(0, width()));
    const int y0 = static_cast<int>(bits_->Int(0, height()));
    options.scissor = PixelRect{x0, y0, static_cast<int>(bits_->Int(x0, width())),
                                static_cast<int>(bits_->Int(y0, height()))};
  }
  if (bits_->Chance(24)) options.cull = bits_->Chance(128) ? Cull::kFront : Cull::kBack;
}

void CaseBuilder::PutIntoClipSpace() {
  Scene& scene = case_.scene;
  if (info_->takes_window || scene.clip_space) return;
  scene.clip_space = true;
  for (Vertex& v : scene.vertices) {
    // x w and y w must be exact, or the window position would move.
    const double w = std::ldexp(1.0, static_cast<int>(bits_->Int(-3, 3)));
    const double x = lattice_.RoundToPrecision(v.x * w);
    const double y = lattice_.RoundToPrecision(v.y * w);
    if (x / w == v.x && y / w == v.y) v = {x, y, v.z, w};
  }
}

void CaseBuilder::LeaveOutWhatIsNotTaken() {
  DrawOptions& options = case_.options;
  if (!info_->takes_tiles) options.tile = 0;
  if (!info_->takes_scissor) options.scissor.reset();
  if (!info_->takes_culling) options.cull = Cull::kNone;
}

Case CaseBuilder::Done(Finish finish) {
  OrderTriangles(finish);
  if (bits_->Chance(32)) RepeatSharedVertices();
  DrawOptionsFor(finish);
  LeaveOutWhatIsNotTaken();
  PutIntoClipSpace();
  return std::move(case_);
}

}  // namespace rasterproof::props
