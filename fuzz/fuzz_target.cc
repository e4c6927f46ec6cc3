#include "fuzz/fuzz_target.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

#include "core/verdict.h"
#include "exact/edge.h"
#include "fuzz/guidance.h"
#include "props/codec/codec.h"
#include "props/judging/gate.h"
#include "props/judging/witness.h"
#include "props/properties/contract_properties.h"
#include "props/run/description.h"
#include "props/run/trial.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"

namespace rasterproof::fuzz {
namespace {

// Says at the program's end how many signs the oracle decided on its fast path, what a target's
// speed is measured by beside its executions; and how wrong anything was.
class Closing {
 public:
  Closing() = default;
  Closing(const Closing&) = delete;
  Closing& operator=(const Closing&) = delete;
  ~Closing() {
    for (std::size_t slot = 0; slot < kGuidedSlots; ++slot) {
      const double ratio = LargestErrorOverBound(slot);
      if (ratio > 0) std::fprintf(stderr, "check %zu: largest error / bound %.4f\n", slot, ratio);
    }
    const TierCounts counts = scope_.Counts();
    const std::uint64_t signs = counts.filter + counts.stable + counts.exact + counts.symbolic;
    std::fprintf(stderr, "%s exact signs\n", std::to_string(signs).c_str());
  }

 private:
  exact::TierScope scope_;
};
const Closing closing;

// What Fail shows. One thread runs one case at a time.
const Case* shown_case = nullptr;
std::span<const std::uint8_t> shown_bytes;

const props::Property& PropertyNamed(std::string_view name) {
  const props::Property* const property = props::FindProperty(name);
  if (property == nullptr) Fail("no such property: " + std::string(name));
  return *property;
}

// FNV-1a.
std::uint32_t HashOf(std::span<const std::uint8_t> bytes) {
  std::uint32_t hash = 2166136261U;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 16777619U;
  return hash;
}

// Whether any bytes mean the same case to both.
bool DecodesAlike(const SubjectInfo& a, const SubjectInfo& b) {
  return a.profile == b.profile && a.input == b.input && a.takes_window == b.takes_window &&
         a.takes_clip == b.takes_clip && a.takes_tiles == b.takes_tiles &&
         a.takes_scissor == b.takes_scissor && a.takes_culling == b.takes_culling;
}

}  // namespace

std::unique_ptr<Subject> SubjectNamed(std::string_view name) {
  std::unique_ptr<Subject> subject = subjects::MakeBuiltin(name);
  if (subject == nullptr) subject = subjects::MakeMutant(name);
  if (subject == nullptr) Fail("no such subject: " + std::string(name));
  return subject;
}

bool Limits::Admit(const Case& c) const {
  const std::int64_t pixels = std::int64_t{c.scene.width} * c.scene.height;
  return pixels * c.profile.pattern.samples() <= samples && c.scene.triangles.size() <= triangles;
}

Bound::Bound(std::span<const Checked> all, Limits limits) : limits_(limits) {
  for (const Checked& checked : all) {
    const auto known = std::ranges::find_if(
        subjects_, [&](const auto& subject) { return subject->Info().name == checked.subject; });
    const auto at = static_cast<std::size_t>(known - subjects_.begin());
    if (at == subjects_.size()) subjects_.push_back(SubjectNamed(checked.subject));
    Subject& subject = *subjects_[at];
    Bind(subject, PropertyNamed(checked.property));
  }
}

Bound::Bound(std::unique_ptr<Subject> subject, std::span<const std::string_view> properties,
             Limits limits)
    : limits_(limits) {
  subjects_.push_back(std::move(subject));
  for (const std::string_view property : properties) {
    Bind(*subjects_.back(), PropertyNamed(property));
  }
}

void Bound::Bind(Subject& subject, const props::Property& property) {
  auto group = std::ranges::find_if(
      groups_, [&](const Group& g) { return DecodesAlike(g.info, subject.Info()); });
  if (group == groups_.end()) group = groups_.insert(groups_.end(), {subject.Info(), {}});
  auto bound = std::ranges::find(group->subjects, &subject, &BoundSubject::subject);
  if (bound == group->subjects.end()) {
    bound = group->subjects.insert(group->subjects.end(), {&subject, {}, slots_});
  }
  bound->properties.push_back(&property);
  ++slots_;
}

int Bound::LookAt(const Group& group, std::span<const std::uint8_t> bytes,
                  const std::function<void(const Group&, const Case&)>& look) const {
  shown_bytes = bytes;
  const Case c = props::DecodeCase(bytes, group.info);
  if (!limits_.Admit(c)) return kPassedOver;
  shown_case = &c;
  // A fault of ours is no finding about the subject, and no input to go past either.
  try {
    look(group, c);
  } catch (const std::exception& error) {
    Fail(std::string("a fault of the program itself: ") + error.what());
  }
  shown_case = nullptr;
  return kLookedAt;
}

int Bound::ForEachCase(std::span<const std::uint8_t> bytes,
                       const std::function<void(const Group&, const Case&)>& look) const {
  int looked_at = kPassedOver;
  for (const Group& group : groups_) {
    if (LookAt(group, bytes, look) == kLookedAt) looked_at = kLookedAt;
  }
  return looked_at;
}

int Bound::PutToTheTest(std::span<const std::uint8_t> bytes) const {
  return ForEachCase(bytes, [](const Group& group, const Case& c) {
    for (const BoundSubject& bound : group.subjects) fuzz::PutToTheTest(bound, c);
  });
}

int Bound::PutOneToTheTest(std::span<const std::uint8_t> bytes) const {
  std::size_t left = HashOf(bytes) % slots_;
  for (const Group& group : groups_) {
    for (const BoundSubject& bound : group.subjects) {
      if (left < bound.properties.size()) {
        return LookAt(group, bytes,
                      [&](const Group&, const Case& c) { fuzz::PutToTheTest(bound, left, c); });
      }
      left -= bound.properties.size();
    }
  }
  return kPassedOver;
}

std::vector<std::string_view> ContractPropertiesOf(Subject& subject) {
  std::vector<std::string_view> names;
  const props::Description description = props::AsJudged(props::DescriptionOf(subject));
  for (const std::string_view name : props::PropertiesOf(subject.Info().profile.contract)) {
    if (!props::DoesNotApply(PropertyNamed(name).gate, description)) names.push_back(name);
  }
  return names;
}

void RequireApplies(Subject& subject, std::string_view property) {
  const auto why = props::DoesNotApply(PropertyNamed(property).gate,
                                       props::AsJudged(props::DescriptionOf(subject)));
  if (why) Fail(std::string(property) + " does not apply to " + subject.Info().name + ": " + *why);
}

void PutToTheTest(const BoundSubject& bound, const Case& c) {
  for (std::size_t k = 0; k < bound.properties.size(); ++k) PutToTheTest(bound, k, c);
}

void PutToTheTest(const BoundSubject& bound, std::size_t index, const Case& c) {
  const props::Property& property = *bound.properties[index];
  const props::Trial trial = props::TryCase(*bound.subject, property, c);
  NoteErrorOverBound(bound.slot + index, trial.verdict.worst_ratio);
  if (trial.verdict.outcome != Outcome::kViolated) return;
  const std::string name(property.name);
  const std::string& subject = bound.subject->Info().name;
  std::fprintf(stderr, "to see it: rasterproof replay INPUT --subject %s --property %s\n",
               subject.c_str(), name.c_str());
  Fail(name + " is violated by " + subject + ": " + trial.verdict.message);
}

void Fail(std::string_view what) {
  std::fprintf(stderr, "rasterproof: %.*s\n", static_cast<int>(what.size()), what.data());
  if (shown_case != nullptr) std::fprintf(stderr, "%s", TextOf(*shown_case).c_str());
  for (const std::uint8_t byte : shown_bytes) std::fprintf(stderr, "%02x", byte);
  std::fprintf(stderr, "\n");
  std::abort();
}

std::string TextOf(const Case& c) {
  const Scene& scene = c.scene;
  const std::string& name = c.origin.empty() ? scene.name : c.origin;
  std::string text = (name.empty() ? "case without a name: " : "case " + name + ": ") +
                     std::to_string(scene.width) + "x" + std::to_string(scene.height) +
                     (scene.precision == Precision::kFloat32 ? " float32" : " float64") +
                     (scene.clip_space ? " clip space\n" : " window space\n");
  for (const Vertex& v : scene.vertices) {
    text += ' ';
    for (const double x : {v.x, v.y, v.z, v.w}) {
      text += ' ';
      text += props::HexText(x);
    }
    text += '\n';
  }
  text += "  triangles";
  for (const Triangle& t : scene.triangles) {
    char separator = ' ';
    for (const std::int32_t index : t) {
      text += std::exchange(separator, ',');
      text += std::to_string(index);
    }
  }
  return text + "\n";
}

}  // namespace rasterproof::fuzz
