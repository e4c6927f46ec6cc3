#include "tool/subject_kinds.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace rasterproof::tool {
namespace {

using Makers = std::map<std::string, SubjectMaker, std::less<>>;

Makers& OwnMakers() {
  static Makers makers;
  return makers;
}

}  // namespace

SubjectKinds& Kinds() {
  static SubjectKinds kinds;
  return kinds;
}

const SubjectKind* BuiltInKind(std::string_view name) {
  const std::vector<SubjectKind>& kinds = Kinds().built_in;
  const auto kind = std::ranges::find_if(kinds, [&](const auto& one) { return one.has(name); });
  return kind == kinds.end() ? nullptr : &*kind;
}

std::vector<std::string> BuiltInNames() {
  std::vector<std::string> names;
  for (const SubjectKind& kind : Kinds().built_in) {
    if (kind.names == nullptr) continue;
    for (std::string& name : kind.names()) names.push_back(std::move(name));
  }
  return names;
}

subjects::ProcessLimits& OutsideLimits() {
  static subjects::ProcessLimits limits;
  return limits;
}

void RegisterOwn(const std::string& name, SubjectMaker make) {
  OwnMakers()[name] = std::move(make);
}

std::vector<std::string> OwnNames() {
  std::vector<std::string> names;
  for (const auto& maker : OwnMakers()) names.push_back(maker.first);
  return names;
}

bool IsOwn(std::string_view name) { return OwnMakers().contains(name); }

std::unique_ptr<Subject> MakeOwn(std::string_view name) {
  const auto own = OwnMakers().find(name);
  return own == OwnMakers().end() ? nullptr : own->second();
}

bool NamesWhatToRun(std::string_view name) {
  return name.starts_with(kPluginPrefix) || name.starts_with(kExecPrefix) ||
         name.ends_with(kDescriptionEnding);
}

bool IsOutside(std::string_view name) { return NamesWhatToRun(name) || IsOwn(name); }

}  // namespace rasterproof::tool
