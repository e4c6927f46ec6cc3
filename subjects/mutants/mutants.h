// Rasterizers with a bug planted in them, and unusual ones that keep their profile: what the
// suite's own worth is measured by.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_MUTANTS_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_MUTANTS_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/subject.h"

namespace rasterproof::subjects {

/// One planted bug or legal variant.
struct MutantInfo {
  std::string name;    ///< "mutant:ties-inclusive", "legal:snap-floor"
  std::string change;  ///< completes "a sound rasterizer, but ..."
  std::string source;  ///< where it was met; may be empty
  /// The causes that are right for it, sections of docs/causes.md with "|" between them. Empty: no
  /// suspect is made for what was planted in it, and to name none is right.
  std::string causes;
  bool legal = false;    ///< must pass, under its own profile
  bool is_late = false;  ///< written after the generators and the properties were frozen
  /// Properties that must find it, each by itself. Empty: that any does is enough.
  std::vector<std::string> killers = {};
};

/// Every mutant, the late ones last, and then every legal variant.
const std::vector<MutantInfo>& Mutants();

/// True of the names in Mutants().
bool IsMutant(std::string_view name);

/// Returns the subject of that name ("mutant:NAME" or "legal:NAME"), or nullptr. Some hold state: a
/// thread has its own.
std::unique_ptr<Subject> MakeMutant(std::string_view name);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_MUTANTS_H_
