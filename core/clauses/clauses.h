// The clause table: sentences of specifications about coverage and values, and how they were read.
#ifndef RASTERPROOF_CORE_CLAUSES_CLAUSES_H_
#define RASTERPROOF_CORE_CLAUSES_CLAUSES_H_

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/profile.h"

namespace rasterproof {

/// How far a specification binds an implementation in one matter.
enum class Force : std::uint8_t {
  kRequired,  ///< it binds every implementation
  kAllowed,   ///< it leaves a choice, or states that the matter is undefined
  kSilent     ///< it says nothing: a sentence was looked for and not found
};

/// One sentence of a specification, or the lack of one.
struct Clause {
  std::string_view id = {};     ///< "vulkan.common-edge": the specification, and the matter
  std::string_view place = {};  ///< section, table or figure
  Force force = Force::kRequired;
  std::string_view sentence = {};  ///< a few of its words in quotes, else in our words
  std::string_view reading = {};   ///< how it was read: one sentence
  /// The profile keys that express it, separated by "; ": "tie_ownership=per-edge; tie_rule". A key
  /// without a value has any value that a preset gives it. Empty if no key expresses it.
  std::string_view keys = {};
  /// The test that checks it by the specification's figure or example: "Suite.Name". Or empty.
  std::string_view shown_by = {};
  /// Whether verdicts rest on a reading that no sentence settles: it is printed with them.
  bool is_assumed = false;
};

/// A specification that has clauses in the table.
struct Specification {
  std::string_view api = {};  ///< the prefix of its ids and presets: "vulkan"
  std::string_view title = {};
  std::string_view edition = {};  ///< which text was read, and where it was not the publisher's own
  std::vector<Clause> clauses = {};
  /// The api of the specification that it builds on, whose clauses hold for it as well: "d3d11" for
  /// Direct3D 12. Or empty.
  std::string_view base = {};
};

/// All of them, in the order in which they are listed.
std::span<const Specification> Specifications();
/// nullptr if there is none of that name.
const Specification* FindSpecification(std::string_view api);
/// Returns the specification that a profile of this name expresses: Vulkan for "vulkan" and for
/// presets whose names begin with "vulkan-". Returns nullptr for "real", for models
/// ("vulkan-canonical") and for users' profiles.
const Specification* SpecificationOf(std::string_view profile_name);
/// The same for the legal set that the profile names, or for its name if it names none.
const Specification* SpecificationOf(const Profile& profile);
/// nullptr if there is none of that name.
const Clause* FindClause(std::string_view id);

/// "vulkan" of "vulkan.common-edge".
std::string_view ApiOf(const Clause& clause);
/// "required", "allowed", "silent".
std::string_view ForceName(Force force);

/// A profile key that expresses a clause, and its value; empty for any value.
struct ClauseKey {
  std::string_view key;
  std::string_view value;
};
std::vector<ClauseKey> KeysOf(const Clause& clause);

/// The readings that no sentence settles and that verdicts by the specification rest on, those of
/// its base first. Empty if there is no such specification.
std::vector<const Clause*> AssumptionsOf(std::string_view api);

/// A file of core/clauses/: one specification in lines "field: text", first its fields, then those
/// of its clauses, each of which begins with its id. Fields have the names of the members above,
/// but "assumed: yes" is is_assumed; what is required or not assumed has no line for it. Lines that
/// begin with '#' are comments.
struct ClauseFile {
  std::string_view name;
  std::string_view text;
};
/// All of them, in the order in which they are listed. core/CMakeLists.txt writes this function.
std::vector<ClauseFile> ClauseFiles();
/// The result points into the file's text.
///
/// Error:      InputError, with file and line, for an unknown field, one that is given twice or
///             missing, a value that is none, and an id that is not this specification's alone.
Specification ReadSpecification(const ClauseFile& file);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CLAUSES_CLAUSES_H_
