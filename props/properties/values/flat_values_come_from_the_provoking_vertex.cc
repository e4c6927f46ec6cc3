// A flat value is the provoking vertex's number, to the bit.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace flat_values_come_from_the_provoking_vertex {

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& /*owners*/) {
  std::uint64_t exercised = 0;
  const std::size_t provoking = shown.rule.provoking == ProvokingVertex::kFirst ? 0 : 2;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (channel.interpolation != Interpolation::kFlat) continue;
    const std::array<double, 3> a = NumbersAt(f, channel);
    exercised += a[0] != a[1] && a[1] != a[2] && a[2] != a[0] ? 1 : 0;
    const double x = shown.Of(f, k);
    if (x == a[provoking] || (std::isnan(x) && std::isnan(a[provoking]))) continue;
    return ValueViolation(f, channel, "is not the provoking vertex's", {x}, {a[provoking]},
                          NumberKind::kValue, /*to_the_bit=*/true);
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAlone, Judge);
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) {
                  return p.values.flat && p.values.provoking != ProvokingVertex::kUnstated;
                },
                "flat values of a stated provoking vertex",
                "the profile does not state flat values and their provoking vertex"}};

}  // namespace flat_values_come_from_the_provoking_vertex

extern constinit const Property kFlatValuesComeFromTheProvokingVertex{
    .name = "FlatValuesComeFromTheProvokingVertex",
    .group = "values",
    .clause =
        "A flat value is that of one vertex of the triangle: which one, the API or the pipeline's "
        "state says (OpenGL 4.6 section 13.6; Vulkan 1.4, Flat Shading; Direct3D 11.3 sections "
        "8.14 and 16.4; WGSL, Interpolation).",
    .required_by = kFlatClauses,
    .tolerance = kExact,
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kValues, flat_values_come_from_the_provoking_vertex::kRules,
                   "three different numbers"),
    .ask = flat_values_come_from_the_provoking_vertex::Ask,
};

}  // namespace rasterproof::props
