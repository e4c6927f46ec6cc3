// Resolves which subject a command line asks for, once: its name and the profile that it is judged
// by. A wrong name is an error before anything runs. Names of properties and cases are resolved by
// tool/resolve_case.h.
#ifndef RASTERPROOF_TOOL_RESOLVE_H_
#define RASTERPROOF_TOOL_RESOLVE_H_

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {

/// The built-in subjects, the oracle by each decider, then the types that this program was built
/// with (kit/main.h). Mutants, plugins and programs have names too, but are not among these.
std::vector<std::string> SubjectNames();

/// A subject that was asked for by name: its profile is read and what it is is looked up, once.
class SubjectFactory {
 public:
  SubjectFactory(std::string name, SubjectMaker make)
      : name_(std::move(name)), make_(std::move(make)) {}
  const std::string& name() const { return name_; }
  /// One more of it, judged by the profile that was asked for. Several threads may call it.
  std::unique_ptr<Subject> Make() const { return make_(); }

 private:
  std::string name_;
  SubjectMaker make_;
};

/// The subject of that name, judged by another profile than its own ("": its own), with `device` by
/// that legal set with the numbers that the subject states (FilledIn). Its longest list has
/// `list_length` triangles before the mesh (0: what the subject's own has).
///
/// Error:      InputError naming the subjects there are, or what is wrong with the profile.
SubjectFactory ResolveSubject(const std::string& name, const std::string& profile = "",
                              bool device = false, std::size_t list_length = 0);

/// The same, made at once: for a verb that needs one.
std::unique_ptr<Subject> MakeSubject(const std::string& name, const std::string& profile = "",
                                     std::size_t list_length = 0);

/// From here on the subject is judged by a profile that is not its own.
void JudgeBy(const Profile& profile, Subject& subject);

/// Says on standard error, once for each of them, that the preset of an API is one of the models
/// that it leaves legal, so that nobody takes another legal one for wrong.
void NotePreset(const Profile& profile);

/// For commands that look for a model of samples. Throws InputError if the subject's profile states
/// whole pixels.
void RequireSamples(const SubjectInfo& info);

/// True of the subjects that this program is made of: methods, kernels, oracle, mutants, and the
/// types that it was built with. No name of these makes another program run than the user's own.
bool IsOurs(const std::string& name);

/// True of the names of the oracle's deciders, and of no other.
bool IsOracle(std::string_view name);

/// The oracle as a subject ("exact", "exact-integers", "exact-cgal") that models the profile.
std::unique_ptr<Subject> MakeOracle(std::string_view name, const Profile& profile);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_RESOLVE_H_
