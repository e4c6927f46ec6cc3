// A suspect: a small exact rasterizer of the stated profile with one thing changed.
#ifndef RASTERPROOF_PROPS_CAUSE_SUSPECT_H_
#define RASTERPROOF_PROPS_CAUSE_SUSPECT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof::props {

/// The pixel that a coordinate lies in, rounded toward zero; far outside one at 2^28 pixels.
///
/// Domain:     not NaN.
int ToPixel(double x);

/// One sample of the target, in axes of the screen: x right, y down, also where y is up.
struct SuspectSample {
  int x = 0;
  int row = 0;  ///< from the top
  int number = 0;
  Point2 at;
  int width = 0;  ///< of the target, in pixels
  int height = 0;
};

/// A triangle as placed, in axes of the screen. After its facing is known it is turned over if it
/// is a back face, so that its inner side is the positive one.
struct SuspectTriangle {
  std::size_t number = 0;  ///< its place in the list
  std::array<Vertex, 3> given;
  std::array<std::int32_t, 3> indices{};
  std::array<Point2, 3> v;
  bool is_front = true;
};

/// A directed edge of a triangle that is turned over if need be.
struct SuspectEdge {
  int opposite = 0;  ///< the vertex that it does not touch
  Point2 a;
  Point2 b;
  bool owns = false;  ///< a sample exactly on it, by the profile's tie rule
};

/// A triangle of clip space.
using SuspectClip = std::array<Vertex, 3>;

/// The stages of a suspect, in their order. An empty function leaves its stage as the profile
/// states it.
struct SuspectStages {
  /// What it takes the stated profile for.
  std::function<void(Profile&)> profile = {};
  /// The triangles of clip space that it draws in place of one: none, itself, pieces.
  std::function<std::vector<SuspectClip>(const SuspectClip&)> clip = {};
  std::function<void(DrawOptions&, const Scene&)> options = {};
  std::function<void(Vertex&)> input = {};
  std::function<double(double x, bool along_y)> snap = {};
  std::function<void(Point2&)> place = {};
  /// Returns whether the triangle, not turned over yet, is left out.
  std::function<bool(const SuspectTriangle&, const Scene&)> drops = {};
  /// Returns the sign of the area; 0: it is not drawn.
  std::function<int(const std::array<Point2, 3>&)> area = {};
  bool draws_flat = false;  ///< a triangle without area covers the samples on it
  std::function<void(SuspectTriangle&)> facing = {};
  std::function<void(PixelRect&, const SuspectTriangle&, const Scene&)> box = {};
  std::function<Point2(const SuspectSample&)> sample = {};
  /// Returns the sign of the edge's value at the sample.
  std::function<int(const SuspectEdge&, const SuspectSample&)> value = {};
  std::function<bool(const SuspectEdge&, const SuspectTriangle&, const SuspectSample&)> owns = {};
  /// How often the triangle counts at a sample that it covers.
  std::function<std::uint32_t(const SuspectSample&, const SuspectTriangle&)> times = {};
  std::function<void(CoverageCounts&)> after = {};
};

/// A suspect of a profile.
struct Suspect {
  std::string cause;  ///< its section of docs/causes.md: "truncation"
  std::string what;   ///< completes "a rasterizer that ..."
  SuspectStages stages;
};

/// Both at once. Nothing if they change the same stage in two ways that exclude each other.
std::optional<SuspectStages> Composed(const SuspectStages& a, const SuspectStages& b);

/// Whether suspects are drawn stage by stage: samples are points, edges are not rounded where they
/// cross rows, and the scene is in window space or taken there. Of others they have three stages:
/// options, profile and clip.
bool HasStages(const Scene& scene, const Profile& profile);

/// The samples of the target times the triangles.
double WorkOf(const Scene& scene, const SubjectInfo& info);

/// Whether suspects draw the scene at all: it is decided, and its size leaves the cost small.
bool SuspectsDraw(const Scene& scene, const SubjectInfo& info);

/// Makes a subject that draws as the stages say and shows what `info` states. Without stages it
/// draws the canonical model.
///
/// Domain:     scenes that SuspectsDraw.
/// Error:      none; signs are exact where no stage computes them.
std::unique_ptr<Subject> MakeSuspect(const SubjectInfo& info, SuspectStages stages);

/// The suspects of a profile, the likeliest first.
std::vector<Suspect> SuspectsOf(const Profile& profile);

// Parts of them.
void AddPlacing(const Profile& profile, std::vector<Suspect>& list);  // snap, samples, overflow
void AddEdges(const Profile& profile, std::vector<Suspect>& list);    // ties, edge values
void AddTaking(const Profile& profile, std::vector<Suspect>& list);   // facing, dropped, odd input
void AddTraversal(const Profile& profile, std::vector<Suspect>& list);  // box, target, scissor
void AddClipping(const Profile& profile, std::vector<Suspect>& list);   // clip space, transforms

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_SUSPECT_H_
