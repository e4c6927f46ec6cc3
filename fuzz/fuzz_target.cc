#include "fuzz/fuzz_target.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <memory>
#include <string>

#include "core/case.h"
#include "core/verdict.h"
#include "props/codec/codec.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/builtin/builtin.h"

namespace rasterproof::fuzz {
namespace {

// Subjects are stateless, so one of each serves every execution.
Subject& SubjectOf(std::string_view name) {
  static std::map<std::string, std::unique_ptr<Subject>, std::less<>> subjects;
  auto found = subjects.find(name);
  if (found == subjects.end()) {
    found = subjects.emplace(name, subjects::MakeBuiltin(name)).first;
    if (found->second == nullptr) Fail("no such subject: " + std::string(name), {});
  }
  return *found->second;
}

// A fault of ours is no finding about the subject, and no input to go past either.
Verdict Judged(Subject& subject, const props::Property& property, const Case& c,
               std::span<const std::uint8_t> bytes) {
  try {
    return props::RunCase(subject, property, c);
  } catch (const std::exception& error) {
    Fail(std::string("a fault of the program itself: ") + error.what(), bytes);
  }
}

}  // namespace

void Fail(std::string_view what, std::span<const std::uint8_t> bytes) {
  std::fprintf(stderr, "rasterproof: %.*s\n", static_cast<int>(what.size()), what.data());
  for (const std::uint8_t byte : bytes) std::fprintf(stderr, "%02x", byte);
  std::fprintf(stderr, "\n");
  std::abort();
}

void PutToTheTest(std::span<const Checked> all, std::span<const std::uint8_t> bytes) {
  for (const Checked& checked : all) {
    Subject& subject = SubjectOf(checked.subject);
    const props::Property* property = props::FindProperty(checked.property);
    if (property == nullptr) Fail("no such property: " + std::string(checked.property), bytes);
    const Case c = props::DecodeCase(bytes, subject.Info());
    const Verdict verdict = Judged(subject, *property, c, bytes);
    if (verdict.outcome != Outcome::kViolated) continue;
    std::fprintf(
        stderr,
        "to see it: rasterproof decode INPUT --subject %s --property %s --output case.json; "
        "rasterproof explain case.json\n",
        subject.Info().name.c_str(), std::string(property->name).c_str());
    Fail(std::string(checked.property) + " is violated by " + std::string(checked.subject) + ": " +
             verdict.message,
         bytes);
  }
}

}  // namespace rasterproof::fuzz
