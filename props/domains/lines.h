// Lines through samples, on an input lattice.
#ifndef RASTERPROOF_PROPS_DOMAINS_LINES_H_
#define RASTERPROOF_PROPS_DOMAINS_LINES_H_

#include "core/vertex.h"
#include "props/domains/case_builder.h"

namespace rasterproof::props {

struct Segment {
  Point2 a;
  Point2 b;
};

/// Rounds to a multiple of 2^-grid_bits.
double OnGrid(double x, int grid_bits);

/// A place around the target whose coordinates have few enough bits that sums and small multiples
/// of them stay on the lattice. With probability 1/4 a half pixel.
Point2 GridPlace(CaseBuilder& builder);

/// Returns the end b of a segment from `a` that passes exactly through p: b = a + m (p - a).
///
/// Domain:     a from GridPlace, p a sample.
/// Properties: b is on the lattice's uniform grid even where p is not (m is a multiple of the power
///             of two that brings p onto it).
Point2 ThroughSample(CaseBuilder& builder, Point2 a, Point2 p);

/// A segment that passes exactly through p, p strictly inside it.
Segment SegmentThrough(CaseBuilder& builder, Point2 p);

/// Moves one coordinate of p by up to `most` lattice steps either way.
Point2 Nudged(CaseBuilder& builder, Point2 p, int most);

/// The lattice place nearest to p, within the profile's limit.
Point2 OnLattice(const CaseBuilder& builder, Point2 p);

/// A lattice place v near `guess` on the line through q and p for which |E(v, q; p)| is as small as
/// the lattice allows without being zero.
Point2 Hardest(CaseBuilder& builder, Point2 guess, Point2 q, Point2 p);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_LINES_H_
