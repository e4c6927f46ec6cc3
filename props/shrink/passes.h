// The ways to make a case simpler.
#ifndef RASTERPROOF_PROPS_SHRINK_PASSES_H_
#define RASTERPROOF_PROPS_SHRINK_PASSES_H_

#include <vector>

#include "core/case.h"

namespace rasterproof::props {

/// Where the passes take their case from and bring their candidates to.
class Attempts {
 public:
  virtual ~Attempts() = default;
  /// The simplest failing case so far.
  virtual const Case& Current() const = 0;
  /// Returns whether the candidate became the current case: it is simpler and still fails.
  virtual bool Try(Case candidate) = 0;
  /// Whether trying more is pointless.
  virtual bool Exhausted() const = 0;
};

/// Runs every pass once, boldest first: triangles, vertices, target, options, coordinates.
void RunPasses(Attempts& attempts);

// passes_structure.cc
void RemoveTriangles(Attempts& attempts);
void MergeVertices(Attempts& attempts);
void CropTarget(Attempts& attempts);
void ResetOptions(Attempts& attempts);

// passes_coordinates.cc
void SimplifyAllCoordinates(Attempts& attempts);
void SimplifyEachCoordinate(Attempts& attempts);

/// Numbers to try in place of x, boldest first. Not all of them cost less.
std::vector<double> SimplerCoordinates(double x);

/// Returns the case without the vertices that no triangle uses, and their numbers in channels.
Case WithoutUnusedVertices(Case c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_SHRINK_PASSES_H_
