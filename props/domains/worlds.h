// Worlds: every triangle, pair and fan on a few points, and cases of extreme size. Each case has a
// number.
#ifndef RASTERPROOF_PROPS_DOMAINS_WORLDS_H_
#define RASTERPROOF_PROPS_DOMAINS_WORLDS_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/case.h"
#include "core/subject_info.h"

namespace rasterproof::props {

/// A numbered set of cases that can be run to the end. There are two kinds, beside
/// `edge-widths` (width_inputs.h):
///
/// All choices of the vertices of a shape among n x n points, half a pixel apart from the target's
/// corner on: every second one along a row or a column is at the centre of a pixel. The
/// vertices of case k are its digits to the base n n, the first vertex the lowest one; a digit is a
/// row times n plus a column. No symmetry is assumed: a triangle is there from each of its vertices
/// and in both windings, at every position that the points allow, flat ones included. The shapes:
/// `triangles`; `pairs` (a, b, c) and (b, a, d), on both sides of a common edge or on one; `fans`
/// of a hub and a ring of six, embedded, folded or flat.
///
/// Sizes at which a number is cut off: indices of 16 bits, targets past 2^14, 2^26 samples.
struct World {
  std::string_view name;     ///< "triangles-7x7"
  std::string_view summary;  ///< one line
  std::uint64_t cases = 0;
  int reach = 0;            ///< the largest coordinate, in half pixels; the least is 0
  std::int64_t pixels = 0;  ///< of the largest target
  /// Names of the properties that it exercises, where they apply to the subject.
  std::span<const std::string_view> properties;
  /// CaseOfWorld calls it.
  Case (*draw)(std::uint64_t index, const SubjectInfo&) = nullptr;
  /// Why the subject can't be given what `reach` says nothing of; nullptr: `reach` says it.
  std::string (*why_not)(const SubjectInfo&) = nullptr;
};

/// Sizes first, then from the fewest cases to the most.
std::span<const World> Worlds();
/// One of Worlds(), or WidthInputs(); nullptr if there is none of that name.
const World* FindWorld(std::string_view name);

/// Why the subject can't be given the world; empty if it can: its points are places that the
/// subject's input takes without rounding, in window space or lifted to clip space by an exact w.
std::string WhyNotGiven(const World& world, const SubjectInfo& info);

/// Case `index` of the world. All options are the plain ones.
///
/// Domain:     index < world.cases, and WhyNotGiven(world, info) is empty.
Case CaseOfWorld(const World& world, std::uint64_t index, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_WORLDS_H_
