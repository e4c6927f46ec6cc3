// Subjects that own the transform from clip space to window space.
//
// Such a subject is given clip space and held to what its transform, computed operation by
// operation, makes of it. Properties see a window-space subject and the transformed case: all that
// is claimed of window space holds for it.
#ifndef RASTERPROOF_PROPS_RUN_OWN_TRANSFORM_H_
#define RASTERPROOF_PROPS_RUN_OWN_TRANSFORM_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"

namespace rasterproof::props {

/// Returns whether the subject takes clip space through a transform of its own.
inline bool OwnsTransform(const SubjectInfo& info) {
  return info.takes_clip && info.profile.transform.has_value();
}

/// What recipes draw for the subject: itself, or for an owner of a transform a taker of window
/// space in the transform's precision.
SubjectInfo AsSeenByRecipes(const SubjectInfo& info);

/// The case with every vertex in clip space, so that the transform takes it back to its place, or
/// some roundings beside it. Vertices of one place stay at one place.
Case PutBehindTransform(Case window, const SubjectInfo& info, BitSource& bits);

/// The case as properties see it: after the profile's transform, if it has one and the scene is in
/// clip space.
Case SeenCase(const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_OWN_TRANSFORM_H_
