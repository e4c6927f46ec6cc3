// A domain: a named family of hard cases, as a recipe over a bit source.
#ifndef RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_
#define RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_

#include <cstdint>
#include <span>
#include <string_view>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"

namespace rasterproof::props {

/// A row of the table. What its cases are depends on nothing but the row's own number and recipe: a
/// domain that comes or goes changes no other's.
struct Domain {
  /// Part of what a case is drawn from, and the byte that names the domain in a fuzz input (from
  /// 256 on none does). From 1 on, unique, and never given to another recipe, not even when the
  /// domain is gone. A recipe that draws otherwise than before gets a new number: names of its
  /// cases then stand for wholly new ones, and an old fuzz input for none of them.
  std::uint16_t number = 0;
  std::string_view name;     ///< "needles", "edges-through-samples"
  std::string_view summary;  ///< what is hard about it, one line
  /// True if cases of this domain always have samples on an edge or within a few lattice steps of
  /// one.
  bool near_edge = false;
  /// True if its scenes are clip space with w other than 1: nothing for a subject of window space.
  bool clip = false;
  /// True if some of its cases go beyond the profile's coordinate limit, or are not finite.
  bool beyond_limits = false;
  /// True if its scenes are meshes: they are drawn without culling and without a scissor.
  bool mesh = false;
  /// True if some of its scenes have what no integer holds: NaN and infinities.
  bool non_finite = false;
  /// How many of its cases a round over a property's domains has.
  std::uint8_t in_a_round = 1;
  /// The same for a subject that owns its transform.
  std::uint8_t in_a_round_behind_transforms = in_a_round;
  /// The contract that it is about, for a domain that means nothing without it.
  bool (*is_stated)(const Profile&) = nullptr;
  /// Draws a case on the input lattice of `info` (its precision, snap, sample pattern, window or
  /// clip space). The case's profile is info.profile. Total: every bit string gives a valid scene.
  Case (*draw)(BitSource&, const SubjectInfo& info);
};

std::span<const Domain> Domains();
/// nullptr if there is none of that name.
const Domain* FindDomain(std::string_view name);
/// nullptr if there is none of that number.
const Domain* DomainOfNumber(std::uint16_t number);

/// Returns whether the subject takes scenes of the domain, and states what it is about.
/// (Window-space domains give clip-space
/// scenes with a power of two as w to a subject that takes nothing else.)
bool Suits(const Domain& domain, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_
