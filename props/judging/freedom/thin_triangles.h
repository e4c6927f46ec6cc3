// Clip-space triangles that a legal choice could turn over.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_THIN_TRIANGLES_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_THIN_TRIANGLES_H_

#include <span>
#include <vector>

#include "core/vertex.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// How far the subject may have moved what the profile's canonical model places, in pixels: 0 where
/// one model is legal, the grid points that a tolerance leaves free, or kMovedOutlineMargin where
/// the grid is not stated at all, on each axis; and how far a sample may lie from where its pattern
/// has it.
double LegalReach(const PlacedCase& c);

/// The least, over the sides of a convex polygon, of how far it reaches from that side.
double WidthOf(std::span<const Point2> polygon);

/// The triangles of a clip-space case, around the eye as they may lie, that may turn over or vanish
/// when what is drawn of them moves by the reach: those with a vertex at w <= 0, which are drawn in
/// pieces of the subject's own cutting, and of the others those less than twice the reach across; a
/// broader one can't. Cruder than OpenTriangles, which needs every w > 0.
class ThinTriangles {
 public:
  /// None.
  ThinTriangles() = default;
  ThinTriangles(const PlacedCase& c, double reach);

  /// Whether a triangle that can turn could come to cover p.
  bool AreNear(Point2 p) const;

 private:
  double reach_ = 0;
  bool everywhere_ = false;  ///< doubles can't decide where some triangle lies
  std::vector<std::vector<Point2>> outlines_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_THIN_TRIANGLES_H_
