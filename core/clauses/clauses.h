// What specifications say about coverage, sentence by sentence: the clause table.
#ifndef RASTERPROOF_CORE_CLAUSES_CLAUSES_H_
#define RASTERPROOF_CORE_CLAUSES_CLAUSES_H_

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/profile.h"

namespace rasterproof {

/// What a specification does about a matter.
enum class Force : std::uint8_t {
  kRequired,  ///< it binds every implementation
  kAllowed,   ///< it leaves a choice, or says outright that nothing is defined
  kSilent     ///< it says nothing: looked for, and not found
};

/// One sentence of a specification, or the lack of one.
struct Clause {
  std::string_view id = {};     ///< "vulkan.common-edge": the specification, and the matter
  std::string_view place = {};  ///< section, table or figure
  Force force = Force::kRequired;
  std::string_view sentence = {};  ///< a few of its words in quotes, else in our words
  std::string_view reading = {};   ///< how it was read: one sentence
  /// The profile keys that it stands for, "; " between them: "tie_ownership=per-edge; tie_rule". A
  /// key without a value: whatever the presets say there. Empty: of no key.
  std::string_view keys = {};
  /// The test that shows it by the specification's own figure or example: "Suite.Name". Or empty.
  std::string_view shown_by = {};
  /// True of a reading that no sentence settles and that verdicts rest on: it is printed with them.
  bool is_assumed = false;
};

/// A specification that has clauses in the table.
struct Specification {
  std::string_view api = {};  ///< as ids and presets begin: "vulkan"
  std::string_view title = {};
  std::string_view edition = {};  ///< which text was read, and where it was not the publisher's own
  std::vector<Clause> clauses = {};
  /// The one that it builds on, whose clauses hold for it as well: "d3d11" of "d3d12". Or empty.
  std::string_view base = {};
};

/// All of them, in the order in which they are listed.
std::span<const Specification> Specifications();
/// nullptr if there is none of that name.
const Specification* FindSpecification(std::string_view api);
/// The specification that a profile of this name stands for: "vulkan" is Vulkan's, as is a preset
/// whose name begins so and goes on with a hyphen. nullptr for all others: "real", models
/// ("vulkan-canonical") and users' own.
const Specification* SpecificationOf(std::string_view profile_name);
/// The same for a profile: that of the set which it names, or else of its own name.
const Specification* SpecificationOf(const Profile& profile);
/// nullptr if there is none of that name.
const Clause* FindClause(std::string_view id);

/// "vulkan" of "vulkan.common-edge".
std::string_view ApiOf(const Clause& clause);
/// "required", "allowed", "silent".
std::string_view ForceName(Force force);

/// A profile key that a clause stands for, and the value, empty where it is any.
struct ClauseKey {
  std::string_view key;
  std::string_view value;
};
std::vector<ClauseKey> KeysOf(const Clause& clause);

/// The readings that no sentence settles and that verdicts by the specification rest on, those of
/// its base first. Empty if there is no such specification.
std::vector<const Clause*> AssumptionsOf(std::string_view api);

/// A file of core/clauses/, a specification each: lines "field: text", those of the specification
/// before those of its clauses, each of which begins with its id. Fields have the names of the
/// members above; "force: required" and "assumed: no" are never written. A line that begins with
/// '#' is a comment.
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
