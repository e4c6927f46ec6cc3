// The sound base of most mutants: a fixed-point rasterizer, with every stage open to a change.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_FIXED_POINT_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_FIXED_POINT_H_

#include <memory>
#include <string>

#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "variants/points.h"
#include "variants/stages.h"

namespace rasterproof::subjects::mutants {

using variants::GridPoint;
using variants::TileTest;
using GridStages = variants::Stages<GridPoint>;
using GridEdge = GridStages::Edge;
using GridTriangle = GridStages::Placed;
using Sample = GridStages::Sample;
using TileCorners = GridStages::TileCorners;

/// Eight subpixel bits, nearest-even, top-left, up to 2^15 pixels: the model of the API presets,
/// and a triangle that is not finite covers nothing.
Profile FixedPointProfile();

/// The stages of the rasterizer; a mutant fills in one or two.
struct FixedStages : GridStages {
  /// What the subject states, and what the sound stages do.
  Profile profile = FixedPointProfile();
  int bits = 8;  ///< of the grid that holds vertices and samples, if the profile's are fewer
  /// Whether it takes tiles and threads, unless it states its own info; if not, it has no twin.
  bool has_workers = true;
};

/// Whether a sample exactly on the edge is inside: on those of flat triangles all are.
bool OwnsIfFlat(const GridEdge& edge, const GridTriangle& triangle, const Sample& sample);

/// The rasterizer with the given stages, on integers and in tiles of 8 pixels.
///
/// Domain:     float32 scenes in window space. A triangle that is not finite or leaves twice the
///             profile's limit is not drawn. 2 limit 2^bits <= 2^60; edge values are held to 64
///             bits, which is all of them while 2 limit 2^bits <= 2^30.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const FixedStages& stages);

/// What such a subject states.
SubjectInfo FixedPointInfo(const std::string& name, const std::string& summary,
                           const Profile& profile);
/// The same, under other statements.
std::unique_ptr<Subject> Make(const SubjectInfo& info, const FixedStages& stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_FIXED_POINT_H_
