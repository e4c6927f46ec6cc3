// A domain: a named family of hard cases, as a recipe over a bit source. Its row stands beside its
// recipe (recipes_*.cc); the build makes the list of the rows.
#ifndef RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_
#define RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_

#include <cstdint>
#include <span>
#include <string_view>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"

namespace rasterproof::props {

/// What domains are hard for; props/compare/families.cc has a sentence of each.
enum class DomainTheme : std::uint8_t {
  kOrdinary,
  kNearEdges,
  kThin,
  kMagnitudes,
  kSnapping,
  kNothing,
  kMeshes,
  kCalls,
  kPixelSides,
  kClip
};

/// A row of the table. Its cases depend only on its number and recipe: adding or removing a domain
/// changes no other's cases.
struct Domain {
  /// Part of the seed of a case, and the byte that names the domain in a fuzz input (no byte does
  /// from 256 on). From 1 on, unique, and never given to another recipe, not even after the domain
  /// is removed: tests/props/domain_bits_test.cc has those that are no longer used. A recipe that
  /// changes its draws gets a new number: names of its cases then mean wholly new cases, and an old
  /// fuzz input means none of them.
  std::uint16_t number = 0;
  /// The hash of its first cases, which domain_bits_test compares with what is drawn, and prints
  /// for a new number. It is never changed alone.
  std::uint64_t bits = 0;
  /// Domains are listed by this: ten times the number, unless it says otherwise.
  std::uint16_t listed = static_cast<std::uint16_t>(10 * number);
  std::string_view name;     ///< "needles", "edges-through-samples"
  std::string_view summary;  ///< why it is hard, one line
  DomainTheme theme;         ///< the one whose sentence holds for it
  /// Domains of a theme are listed by this.
  std::uint16_t in_theme = listed;
  /// True if its vertices leave the subpixel grid: it is about snapping.
  bool off_grid = false;
  /// True if cases of this domain always have samples on an edge or within a few lattice steps of
  /// one.
  bool near_edge = false;
  /// True if many of its cases have a sample exactly on an edge, where the lattice has the samples.
  bool ties = false;
  /// True if many of its cases need the oracle's exact tier, where nothing is snapped.
  bool exact_tier = false;
  /// True if its scenes are clip space with w other than 1, which subjects of window space refuse.
  bool clip = false;
  /// True if some of its cases go beyond the profile's coordinate limit, or are not finite.
  bool beyond_limits = false;
  /// True if its scenes are meshes: they are drawn without culling and without a scissor.
  bool mesh = false;
  /// True if its meshes, once snapped, may overlap themselves or fold.
  bool overlaps = false;
  /// True if some of its scenes have NaN or infinities, which no fixed-point input takes.
  bool non_finite = false;
  /// The number of its cases in a round over a property's domains.
  std::uint8_t in_a_round = 1;
  /// The same for a subject that owns its transform.
  std::uint8_t in_a_round_behind_transforms = in_a_round;
  /// The contract that the domain is for, if it is useless without it.
  bool (*is_stated)(const Profile&) = nullptr;
  /// Draws a case on the input lattice of `info` (its precision, snap, sample pattern, window or
  /// clip space). The case's profile is info.profile. Total: every bit string gives a valid scene,
  /// the same under every compiler: no two draws occur in the arguments of one call or on both
  /// sides of an operator, whose order C++ leaves open.
  Case (*draw)(BitSource&, const SubjectInfo& info);
};

/// In the order in which they are listed.
std::span<const Domain> Domains();
/// nullptr if there is none of that name.
const Domain* FindDomain(std::string_view name);
/// nullptr if there is none of that number.
const Domain* DomainOfNumber(std::uint16_t number);

/// Returns whether the subject takes scenes of the domain and has its contract, if it names one.
/// (Window-space domains give clip-space scenes with a power of two as w to a subject that takes
/// nothing else.)
bool Suits(const Domain& domain, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_DOMAIN_H_
