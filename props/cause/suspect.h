// A suspect: a small exact rasterizer of the stated profile with one thing changed.
#ifndef RASTERPROOF_PROPS_CAUSE_SUSPECT_H_
#define RASTERPROOF_PROPS_CAUSE_SUSPECT_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "variants/stages.h"

namespace rasterproof::props {

using variants::ToPixel;
using SuspectStages = variants::Stages<Point2>;
using SuspectEdge = SuspectStages::Edge;
using SuspectTriangle = SuspectStages::Placed;
using SuspectSample = SuspectStages::Sample;

/// A suspect of a profile.
struct Suspect {
  std::string cause;  ///< its section of docs/causes.md: "truncation"
  std::string what;   ///< completes "a rasterizer that ..."; "{}" is its budget
  SuspectStages stages;
  /// If set, its stages within a budget: of what is beyond nothing is drawn.
  std::function<SuspectStages(std::int64_t budget)> within = {};
};

/// Whether suspects are drawn stage by stage: samples are points, edges are not rounded where they
/// cross rows, and the scene is in window space or taken there. Of others they have few stages
/// (variants/stages.h).
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
