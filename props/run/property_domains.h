// Which domains put a property to the test on a subject.
#ifndef RASTERPROOF_PROPS_RUN_PROPERTY_DOMAINS_H_
#define RASTERPROOF_PROPS_RUN_PROPERTY_DOMAINS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "props/property.h"

namespace rasterproof::props {

/// The domains of the property whose scenes the subject takes, in the property's order, each as
/// often as its row says (Domain::in_a_round).
std::vector<const Domain*> DomainsFor(const SubjectInfo& info, const Property& property);

/// Names the domains that DomainsFor leaves out, and why; empty if it leaves none out.
std::string LeftOutDomains(const SubjectInfo& info, const Property& property);

/// The first index of the property's cases in every domain: states that draw from one domain see
/// different cases, so that properties do not all meet, or all miss, the same rare scene.
///
/// Returns:    a multiple of 1000 below 10^7, by the property's name alone.
std::uint64_t FirstIndex(std::string_view property);

/// The name of what a run over these domains (at least one) takes as its case `number`, chosen
/// cases apart (props/run/first_cases.cc): of domain number % n, the next one from `first` on that
/// the run has not had of it. Worked out from
/// `number` alone, so that shards and replays agree, and different for different numbers, however
/// often a domain is listed.
CaseName NameOfCase(const std::vector<const Domain*>& domains, std::uint64_t first,
                    std::uint64_t seed, std::uint64_t number);

/// The name of a world's case: its seed is 0, for nothing of it is left to chance.
CaseName NameOfCase(const World& world, std::uint64_t index);

/// The case of that name for the subject, of a domain or of a world. Its origin is the name.
///
/// Error:      InputError if there is no such domain or world, the subject takes none of its
///             scenes, or the world has no case of that number or seed.
Case DrawCase(const SubjectInfo& info, const CaseName& name);

/// Draws a case of the domain from any bits; its scene bears the domain's name.
Case DrawNamed(const Domain& domain, BitSource& bits, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_PROPERTY_DOMAINS_H_
