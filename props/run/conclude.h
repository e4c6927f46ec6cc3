// The result of a run: begun, counted case by case, concluded; whatever engine the cases come from.
#ifndef RASTERPROOF_PROPS_RUN_CONCLUDE_H_
#define RASTERPROOF_PROPS_RUN_CONCLUDE_H_

#include <cstddef>
#include <cstdint>

#include "core/case.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/domains/worlds.h"
#include "props/property.h"

namespace rasterproof::props {

/// Whether a property was hardly asked: more cases were refused than put it to the test. Scenes
/// beyond the profile's limits don't count: who states a limit may refuse them.
constexpr bool RefusesTooMuch(std::uint64_t refused, std::uint64_t tested) {
  return refused > tested;
}

/// The result before any case: the property's words, and a count for each domain of DomainsFor;
/// none of a world.
PropertyResult NothingRun(const SubjectInfo& info, const Property& property, std::uint64_t seed,
                          const World* world = nullptr);

/// Adds a case to what NothingRun began: it is one of the domain of that place in
/// DomainsFor(), or of the world. Of a world no samples near edges are counted: it has them by
/// construction.
void AddCase(std::size_t place, const Case& c, const Verdict& verdict, PropertyResult& result);

/// Sets outcome and message by the counters and the end, as often as they change. Domains that the
/// subject can't take are named last in the message.
///
/// A run that ended in time is no pass if nothing was exercised, if a near-edge domain gave nothing
/// near an edge, if 100 cases exercised the property and none reached what its domains can reach (a
/// sample on an edge, either sign of area, a clip, the exact tier), if the subject refused too
/// much, if it took one side for the front in some cases and the other side in others, or if no
/// grid explains all its calls.
/// Domain:     a result of the subject and the property, as NothingRun begins it.
void Conclude(const SubjectInfo& info, const Property& property, PropertyResult& result);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CONCLUDE_H_
