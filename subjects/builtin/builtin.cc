#include "subjects/builtin/builtin.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/barycentrics.h"
#include "reference/proved.h"
#include "reference/rasterize.h"
#include "subjects/builtin/kernel_subjects.h"

namespace rasterproof::subjects {
namespace {

constexpr std::string_view kCanonicalSuffix = ":canonical";

/// One method, with or without canonical edges. Holds no state: threads may share it.
class BuiltinSubject final : public Subject {
 public:
  BuiltinSubject(const reference::Method& method, bool canonical)
      : method_(method), canonical_(canonical), info_(method.info) {
    if (canonical) {
      info_.name += kCanonicalSuffix;
      info_.summary += "; each edge from its lexicographically smaller end";
    }
    if (ShowsBarycentrics()) {
      for (Proof& proof : reference::BarycentricProofs()) info_.proofs.push_back(std::move(proof));
    }
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    reference::Rasterize(scene, method_, {options, canonical_}, counts);
  }

  const EdgeEvaluator* Edges() const override {
    return canonical_ ? method_.canonical_edges : method_.edges;
  }

  const BarycentricEvaluator* Barycentrics() const override {
    return ShowsBarycentrics() ? &reference::ReferenceBarycentrics(info_.input) : nullptr;
  }

 private:
  // The reference's barycentrics take window-space vertices as they are: not snapped, not divided.
  bool ShowsBarycentrics() const { return info_.takes_window && info_.profile.snap.IsNone(); }

  const reference::Method& method_;
  bool canonical_;
  SubjectInfo info_;
};

struct NamedMethod {
  const reference::Method* method;
  bool canonical;
};

NamedMethod Find(std::string_view name) {
  const bool canonical = name.ends_with(kCanonicalSuffix);
  if (canonical) name.remove_suffix(kCanonicalSuffix.size());
  const reference::Method* method = reference::FindMethod(name);
  if (method != nullptr && canonical && !method->can_be_canonical) method = nullptr;
  return {method, canonical};
}

}  // namespace

std::vector<std::string> BuiltinNames() {
  std::vector<std::string> names;
  for (const reference::Method& method : reference::Methods()) {
    names.emplace_back(method.name);
    if (method.can_be_canonical) names.push_back(names.back() + std::string(kCanonicalSuffix));
  }
  for (std::string& name : KernelSubjectNames()) names.push_back(std::move(name));
  return names;
}

bool IsBuiltin(std::string_view name) {
  const std::vector<std::string> kernels = KernelSubjectNames();
  return Find(name).method != nullptr || std::ranges::find(kernels, name) != kernels.end();
}

std::unique_ptr<Subject> MakeBuiltin(std::string_view name) {
  const NamedMethod found = Find(name);
  if (found.method == nullptr) return MakeKernelSubject(name);
  return std::make_unique<BuiltinSubject>(*found.method, found.canonical);
}

}  // namespace rasterproof::subjects
