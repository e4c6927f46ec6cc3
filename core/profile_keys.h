// The keys of a profile. This table is the only list of them; for a key whose values are not all
// words, io/profile_json.cc adds how it is read and written.
#ifndef RASTERPROOF_CORE_PROFILE_KEYS_H_
#define RASTERPROOF_CORE_PROFILE_KEYS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/profile.h"

namespace rasterproof {

/// The subject matter of a key.
enum class KeyKind : std::uint8_t {
  kName,      ///< what the profile is called
  kModel,     ///< which samples its canonical model covers
  kContract,  ///< the requirement on results
  kFreedom,   ///< where legal results may differ from the model, or must still agree
  kLimit      ///< where nothing is stated
};

/// Returns "name", "model", "contract", "freedom" or "limit".
std::string_view KeyKindName(KeyKind kind);

/// Flags of a key.
enum KeyMarks : std::uint8_t {
  kUnmarked = 0,
  kOfDevice = 1,  ///< a device fills it in where its profile is a specification's legal set
  kHinders = 2,   ///< its value can keep the contract's properties from being exercised
  kWritten = 4    ///< files have it even where it is the default
};

/// Access to the members of a profile that a key sets.
struct KeyMember {
  void (*copy)(const Profile& from, Profile& to);  ///< copies this key's members alone
  /// If all values are words: returns the index of a profile's word, and sets it.
  std::size_t (*word)(const Profile& profile) = nullptr;
  void (*set_word)(std::size_t word, Profile& profile) = nullptr;
  std::string_view example = {};  ///< else: a value other than the default, as files spell it
};

struct ProfileKey {
  std::string_view name;  ///< as files spell it
  KeyKind kind;
  KeyMember member;
  // For the reader, as `rasterproof list keys` prints it.
  std::string_view values;  ///< the words in the order of the enumerators, if all values are words
  std::string_view usual;   ///< the default
  std::string_view says;
  int marks = kUnmarked;
};

/// Returns a profile's member, or with several pointers the member of a member.
template <auto... kMembers>
constexpr auto& MemberOf(auto& profile) {
  return (profile.*....*kMembers);
}

template <auto... kMembers>
void Copy(const Profile& from, Profile& to) {
  MemberOf<kMembers...>(to) = MemberOf<kMembers...>(from);
}

template <auto... kMembers>
constexpr KeyMember ByExample(std::string_view example) {
  return {.copy = Copy<kMembers...>, .example = example};
}

/// The member is an enumerator or a bool, and `values` has a word for each.
template <auto... kMembers>
inline constexpr KeyMember kWord{
    Copy<kMembers...>,
    [](const Profile& profile) { return static_cast<std::size_t>(MemberOf<kMembers...>(profile)); },
    [](std::size_t word, Profile& profile) {
      auto& member = MemberOf<kMembers...>(profile);
      member = static_cast<std::remove_reference_t<decltype(member)>>(word);
    }};

/// All keys, in the order in which they are read and written.
inline constexpr auto kProfileKeys = std::to_array<ProfileKey>({
    {"name", KeyKind::kName, ByExample<&Profile::name>(R"("mine")"), "text", "", "for the reader",
     kWritten},
    {"specification", KeyKind::kName, ByExample<&Profile::specification>(R"("d3d11")"),
     "d3d11, vulkan, gl, webgpu", "",
     "the legal set that this is, with a device's numbers: `subpixel_bits` or "
     "`least_subpixel_bits`, `sample_locations`, `coordinate_limit`, `guard_band`, `front_face`. "
     "All other keys are the set's"},
    {"subpixel_bits", KeyKind::kModel, ByExample<&Profile::snap, &Snap::bits>("5"), "0 to 16, null",
     "null", "the grid that vertices snap to; null: none", kHinders | kWritten},
    {"snap_rule", KeyKind::kModel, kWord<&Profile::snap, &Snap::rule>,
     "nearest-even, nearest-away, half-up, floor, truncate", "nearest-even",
     "which of two grid points", kWritten},
    {"snap_form", KeyKind::kModel, kWord<&Profile::snap, &Snap::form>,
     "coordinate, float32-difference, exact-difference", "coordinate",
     "what is rounded: x; or x - c, in float32 or exactly, and c is added again", kHinders},
    {"snap_origin", KeyKind::kModel, ByExample<&Profile::snap, &Snap::origin>("0.25"),
     "multiple of 1/256 in [0, 1)", "0", "c of the two differences"},
    {"sample_locations", KeyKind::kModel,
     ByExample<&Profile::pattern>("[[0.125, 0.875], [0.5, 0.25]]"),
     "list of [x, y]; standard-1, -2, -4, -8, -16", "[[0.5, 0.5]]",
     "places within a pixel, multiples of 1/256", kOfDevice | kWritten},
    {"y_axis", KeyKind::kModel, kWord<&Profile::y_axis>, "down, up", "down", "which way y grows",
     kWritten},
    {"tie_rule", KeyKind::kModel, ByExample<&Profile::tie_rule>(R"("bottom-left-y")"),
     "top-left, top-right, bottom-left, bottom-right, each with -y; inclusive, exclusive",
     "top-left",
     "which side owns a sample on an edge (-y: y decides first); inclusive: both; exclusive: "
     "none",
     kHinders | kWritten},
    {"contract", KeyKind::kContract, kWord<&Profile::contract>,
     "sample-exact, watertight, closed, at-least-model, at-most-model, squares, none",
     "sample-exact",
     "what is judged. Watertight and closed: a grid that is stated binds, to a step of it; leave "
     "`subpixel_bits` out for a grid of your own",
     kWritten},
    {"snap_tolerance", KeyKind::kFreedom,
     ByExample<&Profile::freedom, &Freedom::snap_tolerance>("0.625"), "0 to 1", "0",
     "grid steps that a vertex may be off", kHinders},
    {"rounding", KeyKind::kFreedom, kWord<&Profile::freedom, &Freedom::any_rounding>,
     "stated, unspecified", "stated",
     "unspecified: any grid point less than a step away, on each axis", kHinders},
    {"least_subpixel_bits", KeyKind::kFreedom,
     ByExample<&Profile::freedom, &Freedom::least_bits>("3"), "0 to 16, null", "null",
     "the grid has so many bits or more, one number for everything, or there is no grid", kHinders},
    {"tie_ownership", KeyKind::kFreedom, kWord<&Profile::freedom, &Freedom::ties>,
     "stated, axis-aligned, per-edge, open", "stated",
     "the owner of a sample on an edge: the tie rule's; that of any of the eight consistent rules, "
     "one for all; one of the two triangles, for each sample; not stated",
     kHinders},
    {"transform_error", KeyKind::kFreedom,
     ByExample<&Profile::freedom, &Freedom::transform_error>("1.5"),
     "number of 2^-24 of a coordinate, null", "0",
     "what a window coordinate that the subject computes from clip space may be off, before it is "
     "snapped; null: no error is stated, and no sample of clip space is judged",
     kHinders},
    {"coordinate_limit", KeyKind::kLimit, ByExample<&Profile::coordinate_limit>("4096"),
     "positive number", "2^127", "beyond it nothing is stated", kOfDevice | kHinders | kWritten},
    {"degenerate_triangles", KeyKind::kFreedom, kWord<&Profile::degenerate_triangles>,
     "nothing, unspecified", "nothing", "what a triangle without area covers", kHinders},
    {"infinite_vertex", KeyKind::kFreedom, kWord<&Profile::infinite_vertex>, "nothing, unspecified",
     "nothing; of all presets but `real`: unspecified",
     "what a triangle with an infinite x, y or w covers"},
    {"nan_vertex", KeyKind::kFreedom, kWord<&Profile::nan_vertex>, "nothing, unspecified",
     "nothing", "what a triangle with a NaN in x, y or w covers"},
    {"nan_z", KeyKind::kFreedom, kWord<&Profile::nan_z>, "ignored, nothing, unspecified", "ignored",
     "what a triangle with a NaN in z alone covers"},
    {"front_face", KeyKind::kFreedom, kWord<&Profile::front_face>, "positive-area, unstated",
     "positive-area; of a legal set unstated",
     "the side that is counted as front. Unstated: either, one for all triangles of all calls; the "
     "output says which it is",
     kOfDevice},
    {"culls", KeyKind::kModel, kWord<&Profile::culls>, "none, front, back", "none",
     "the side that is never drawn, also where no draw asks for culling. Front: the side of "
     "positive area, which turns counter-clockwise on screen after the snap",
     kHinders},
    {"sample_positions", KeyKind::kFreedom, kWord<&Profile::sample_positions>,
     "stated, fixed, vary", "stated; of `vulkan` and `gl` with several samples: vary",
     "whether samples lie there; fixed: somewhere in the pixel, in every pixel alike"},
    {"centroid", KeyKind::kFreedom, kWord<&Profile::centroid>, "unstated, direct3d, inside",
     "unstated; of `d3d11`: direct3d; of `gl`, `vulkan`, `webgpu`: inside",
     "where attributes asked for at the centroid are evaluated. direct3d: the pixel's centre if "
     "all samples are covered, else the covered sample of least index; inside: any point of pixel "
     "and triangle, outlines included. Of one sample: the centre"},
    {"translation_invariant", KeyKind::kFreedom, ByExample<&Profile::translation_invariant>("true"),
     "true, false", "false",
     "a scene moved by whole pixels covers the moved samples, whatever the freedom"},
    {"edge_samples", KeyKind::kFreedom, kWord<&Profile::shares_edge_samples>,
     "owned, may-be-shared", "owned",
     "a sample on an edge may be covered by every triangle that has the edge", kHinders},
    {"fixed", KeyKind::kModel,
     ByExample<&Profile::fixed>(
         R"({"integer_bits": 12, "fraction_bits": 4, "signed": false, "wrap": true})"),
     R"({"integer_bits": 1 to 31, "fraction_bits": 0 to 16, "signed": true, "wrap": false}, null)",
     "null",
     "coordinates are integers in units of 2^-fraction_bits, of range [-2^(n-1), 2^(n-1)) or "
     "[0, 2^n); with `wrap` others come too and are taken modulo 2^n. Window space",
     kHinders},
    {"max_primitive_extent", KeyKind::kModel,
     ByExample<&Profile::max_primitive_extent>("[1023, 511]"), "[width, height], null", "null",
     "a triangle wider or higher after snapping covers nothing. Window space", kHinders},
    {"max_target", KeyKind::kLimit, ByExample<&Profile::max_target>("[2048, 1024]"),
     "[width, height], 1 to 65536", "[65536, 65536]",
     "of larger targets nothing is stated; cases keep within it", kHinders},
    {"guard_band", KeyKind::kLimit, ByExample<&Profile::guard_band>(R"("viewport+64")"),
     R"([x0, y0, x1, y1], "viewport", "viewport+64", "unknown", "none", null)",
     R"(null (none); the sets: "unknown")",
     "a triangle with a corner outside is clipped and its edges may move. One model: samples are "
     "not judged, meshes are. Grid points left free: edges that leave move by less than a step. "
     "\"unknown\": the target, or any wider rectangle. Window space",
     kOfDevice | kHinders},
    {"scanline_rounding", KeyKind::kModel,
     ByExample<&Profile::scanline_rounding>(R"({"bits": 7, "rule": "floor", "origin": 0.5})"),
     R"({"bits": 0 to 16, "rule": as snap_rule, "origin": as snap_origin}, null)", "null",
     "where an edge crosses a row of samples, x is rounded to this grid. Window space", kHinders},
    {"transform", KeyKind::kModel,
     ByExample<&Profile::transform>(
         R"({"precision": "float64", "division": "reciprocal", "map": [8, 9, 0.5, -0.5]})"),
     R"({"precision": float32 or float64, "division": quotient or reciprocal, "viewport": none, )"
     R"(multiply-add, fused or add-multiply, "flips_y": true or false, )"
     R"("map": [x0, y0, dx, dy] or null}, null)",
     "null", "clip space, or a map, is taken to the window by these operations, each rounded once",
     kHinders},
    {"coverage", KeyKind::kModel,
     ByExample<&Profile::squares>(
         R"({"must": {"relation": "intersects", "half_width": 0.25}, "flat": "drawn"})"),
     R"({"must": region or null, "may": region or null, "flat": nothing, free or drawn}, null)",
     "null",
     "with contract `squares`: a triangle covers at least the pixels of `must`, at most those of "
     "`may`; `flat`: what one without area covers. Window space"},
    {"values", KeyKind::kContract,
     ByExample<&Profile::values>(
         R"({"weights": "perspective", "error": {"ulps": 2, "conditions": 8}, "hull": true})"),
     R"({"weights": screen or perspective, "provoking": first or last, )"
     R"("derivatives": analytic, fine or coarse, "quads": even or odd, "error", )"
     R"("derivative_error": {"ulps", "absolute", "conditions": numbers}, "depth": float32, )"
     R"(float64, unorm16, unorm24 or unorm32, "depth_rounding": either or nearest, )"
     R"("flat", "linear", "inverse_w", )"
     R"("centres", "centroids", "flushes", "equal_stay_equal", "exact_at_vertices", "hull", )"
     R"("edges_agree", "any_order", "monotone_rows": true or false})",
     "{}",
     "what covered samples hold: of which plane barycentrics are, where flat values come from, how "
     "derivatives are computed and where quads begin, how far values may be off, what is computed "
     "beside perspective values at samples, whether what is below the normal floats may count as "
     "zero where no error is stated, and what is promised to the bit",
     kOfDevice},
    // After the keys that its entries can leave out.
    {"by_target_size", KeyKind::kModel,
     ByExample<&Profile::by_target_size>(
         R"([{"max_width": 64, "subpixel_bits": 6}, {"tie_rule": "inclusive"}])"),
     "list of {`max_width`, `max_height`, and any of `subpixel_bits`, `snap_rule`, `snap_form`, "
     "`snap_origin`, `sample_locations`, `tie_rule`}",
     "[]",
     "the first entry that fits the target holds there; what it leaves out is the profile's own",
     kHinders},
});

/// Domain:     a name of the table.
const ProfileKey& KeyNamed(std::string_view name);

/// Returns the words of a key whose values are words alone.
std::vector<std::string_view> WordsOf(const ProfileKey& key);

/// Returns the word of the key `contract`, `snap_rule` or `snap_form`.
std::string_view ContractName(Contract contract);
std::string_view SnapRuleName(SnapRule rule);
std::string_view SnapFormName(SnapForm form);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_PROFILE_KEYS_H_
