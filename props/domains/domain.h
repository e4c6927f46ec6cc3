// A domain: a named family of hard cases, as a recipe over a bit source.
#ifndef RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_
#define RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_

#include <span>
#include <string_view>

#include "core/case.h"
#include "core/subject.h"
#include "props/domains/bit_source.h"

namespace rasterproof::props {

struct Domain {
  std::string_view name;     ///< "needles", "edges-through-centres"
  std::string_view summary;  ///< what is hard about it, one line
  /// True if cases of this domain always have samples on an edge or within a few lattice steps of
  /// one.
  bool near_edge = false;
  /// Draws a case on the input lattice of `info` (its precision, snap, sample lattice, window or
  /// clip space). The case's profile is info.profile. Total: every bit string gives a valid scene.
  Case (*draw)(BitSource&, const SubjectInfo& info);
};

std::span<const Domain> Domains();
/// nullptr if there is none of that name.
const Domain* FindDomain(std::string_view name);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_
