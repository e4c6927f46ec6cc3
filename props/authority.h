// Whether a clause, the stated model or only users ask for a property.
#ifndef RASTERPROOF_PROPS_AUTHORITY_H_
#define RASTERPROOF_PROPS_AUTHORITY_H_

#include <span>
#include <string_view>
#include <vector>

#include "core/authority.h"
#include "core/clauses/clauses.h"
#include "core/profile.h"
#include "core/subject_info.h"
#include "props/property.h"

namespace rasterproof::props {

/// Who asks for a property, and by which sentences.
struct Grounds {
  Authority authority = Authority::kStatedModel;
  std::vector<const Clause*> clauses = {};  ///< kClause: at least one, in the row's order
};

/// Returns those of the clauses that bind a subject that states the profile: of its specification,
/// or of its base, and about its squares, if it has any, and its values: a key "values.provoking"
/// with a value has the profile's. Empty if it is no specification's.
std::vector<const Clause*> ClausesFor(std::span<const std::string_view> ids,
                                      const Profile& profile);

/// Returns who asks for the property of a subject that states the profile, and nothing beside it.
///
/// kClause       the profile is a specification's, and the row names a clause of it or of its base.
/// kStatedModel  otherwise, if the profile is nobody's but the subject's own and states it, or
///               leaves one model; or if the property is judged by bounds that the subject states.
/// kQuality      otherwise: the specification, or the profile, leaves it open.
Grounds AuthorityOf(const Property& property, const Profile& profile);

/// Returns who asks for the property of the subject: as of its profile, with the clauses that
/// require it once the subject states how far off its barycentrics, depths or values may be,
/// whichever of them the property looks at.
Grounds AuthorityOf(const Property& property, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_AUTHORITY_H_
