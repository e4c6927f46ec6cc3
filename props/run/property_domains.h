// Which domains put a property to the test on a subject.
#ifndef RASTERPROOF_PROPS_RUN_PROPERTY_DOMAINS_H_
#define RASTERPROOF_PROPS_RUN_PROPERTY_DOMAINS_H_

#include <string>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/property.h"

namespace rasterproof::props {

/// The domains of the property whose scenes the subject takes, in the property's order; one that
/// is to be drawn more often than others stands there as often.
std::vector<const Domain*> DomainsFor(const SubjectInfo& info, const Property& property);

/// Names the domains that DomainsFor leaves out, and why; empty if it leaves none out.
std::string LeftOutDomains(const SubjectInfo& info, const Property& property);

/// Draws a case of the domain; its scene bears the domain's name.
Case DrawNamed(const Domain& domain, BitSource& bits, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_PROPERTY_DOMAINS_H_
