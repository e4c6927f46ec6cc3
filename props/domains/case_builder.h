// A case under construction: every recipe draws its parts, adds to it and finishes it.
#ifndef RASTERPROOF_PROPS_DOMAINS_CASE_BUILDER_H_
#define RASTERPROOF_PROPS_DOMAINS_CASE_BUILDER_H_

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/case.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "model/target_profile.h"
#include "props/domains/bit_source.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::props {

/// How a recipe's triangles are put in order and drawn at the end.
enum class Finish : std::uint8_t {
  kAnyOrder,  ///< each triangle in any of its six orders; any options
  kMesh,      ///< facings stay those of the recipe, or all are reversed; no culling, no scissor
  kAsIs       ///< as the recipe wrote them
};

/// Draws the parts of a case from a bit source, on the input lattice of a subject.
class CaseBuilder {
 public:
  /// A target of 1 to 48 pixels a side, mostly 8 to 24.
  CaseBuilder(BitSource& source, const SubjectInfo& info);
  CaseBuilder(BitSource& source, const SubjectInfo& info, int width, int height);

  BitSource& bits() { return *bits_; }
  const InputLattice& lattice() const { return lattice_; }
  /// The subject's profile, as it is on a target of this size.
  const TargetProfile& profile() const { return profile_; }
  int width() const { return case_.scene.width; }
  int height() const { return case_.scene.height; }
  /// The stated range; for real geometry, a range whose edge values are still readable.
  double Range() const { return std::min(lattice_.limit(), 0x1p24); }
  /// Its other end: not the negative of the first for a fixed-point input.
  double LeastOfRange() const { return std::max(lattice_.lowest(), -0x1p24); }

  /// A sample of the target: exact, and a lattice place of every lattice that can hold it.
  Point2 Sample();
  /// A coordinate around [0, extent]: with probability 1/2 that of a sample, else half pixels,
  /// lattice places, or one of these moved by a step or two.
  double Coordinate(int extent, bool along_y);
  Point2 Place() { return {Coordinate(width(), false), Coordinate(height(), true)}; }
  /// Uniform in [low, high), 53 bits.
  double Uniform(double low, double high);
  /// +-2^e m, e of [low, high], m of [1, 2), both uniform.
  double LogUniform(int low, int high);
  double Sign() { return bits_->Chance(128) ? 1.0 : -1.0; }

  /// From now on Add() keeps to the lattice, but not within the profile's limit.
  void IgnoreLimit() { within_limit_ = false; }
  bool WithinLimit() const { return within_limit_; }
  /// Adds the vertex that lies nearest on the lattice, within the profile's limit.
  std::int32_t Add(Point2 p);
  /// Adds the vertex, rounded only to the precision: it may lie off the subpixel grid or beyond the
  /// limit, or not be finite.
  std::int32_t AddRaw(const Vertex& v);
  void AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c);
  void AddTriangle(const std::array<Point2, 3>& v);
  /// Says that the vertices are clip space.
  void UseClipSpace() { case_.scene.clip_space = true; }

  /// Orders the triangles, draws the options, and turns the scene into clip space (w a power of
  /// two, exactly) for a subject that takes nothing else.
  Case Done(Finish finish);

 private:
  void OrderTriangles(Finish finish);
  void RepeatSharedVertices();
  void DrawOptionsFor(Finish finish);
  void LeaveOutWhatIsNotTaken();
  void PutIntoClipSpace();

  BitSource* bits_;
  const SubjectInfo* info_;
  bool within_limit_ = true;
  Case case_;
  TargetProfile profile_;
  InputLattice lattice_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_CASE_BUILDER_H_
