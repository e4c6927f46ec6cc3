// rasterproof certify --merge: the certificate of a campaign that was run in parts.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/subject_info.h"
#include "fmt/format.h"
#include "props/domains/worlds.h"
#include "report/text.h"
#include "tool/case_choice.h"
#include "tool/certify/certify.h"
#include "tool/certify/cmd_certify.h"
#include "tool/certify/part_check.h"
#include "tool/certify/part_file.h"
#include "tool/certify/shard.h"
#include "tool/environment.h"
#include "tool/resolve.h"
#include "tool/resolve_case.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

using Parts = std::vector<SubjectPart>;

std::string RangeText(const CaseRange& range) {
  return fmt::format("{}..{}", range.first, range.end);
}

// What all parts must agree on.
struct Agreement {
  std::string what;
  std::function<std::string(const SubjectPart&)> of;
};

std::string EnvironmentText(const SubjectPart& part) {
  std::string text;
  for (const auto& [name, value] : part.environment) text += fmt::format("{} {}; ", name, value);
  return text;
}

std::string CutText(const SubjectPart& part) {
  return part.shard ? fmt::format("into {} shards", part.shard->count) : "by --cases A..B";
}

std::vector<Agreement> Agreements() {
  return {{"version", [](const SubjectPart& part) { return part.tool_version; }},
          {"build", EnvironmentText},
          {"subject", [](const SubjectPart& part) { return part.subject; }},
          {"profile or description of the subject",
           [](const SubjectPart& part) { return part.stated; }},
          {"seed", [](const SubjectPart& part) { return std::to_string(part.seed); }},
          {"options", [](const SubjectPart& part) { return part.options; }},
          {"cut", CutText},
          {"number of cases", [](const SubjectPart& part) {
             return part.cases ? std::to_string(*part.cases) : std::string("unknown");
           }}};
}

// In short: a description takes many lines.
std::string Shown(const std::string& text) {
  constexpr std::size_t kMost = 60;
  const bool is_long = text.size() > kMost || text.find('\n') != std::string::npos;
  return is_long ? "" : " (" + (text.empty() ? "none" : report::CleanText(text)) + ")";
}

void RequireAgreement(const Parts& parts) {
  for (const Agreement& agreement : Agreements()) {
    const std::string first = agreement.of(parts.front());
    for (const SubjectPart& part : parts) {
      const std::string other = agreement.of(part);
      if (other == first) continue;
      throw InputError(part.file,
                       fmt::format("its {}{} is not that of {}{}", agreement.what, Shown(other),
                                   parts.front().file, Shown(first)),
                       "merge parts of one campaign, or run this part again as the others");
    }
  }
}

// In the order of their cases. Empty shards come before the one that begins where they do.
void SortByCases(Parts& parts) {
  std::ranges::sort(parts, {}, [](const SubjectPart& part) {
    return part.shard ? part.shard->number : part.range.first;
  });
}

// Throws if there are shards that are in no file; `file` is the one before the first.
void RequireNoHoles(const std::string& file, const std::vector<std::uint64_t>& holes,
                    std::uint64_t count) {
  if (holes.empty()) return;
  constexpr std::size_t kMostNamed = 16;
  std::vector<std::string> numbers;
  std::vector<std::string> shards;
  for (const std::uint64_t hole : std::span(holes).first(std::min(holes.size(), kMostNamed))) {
    numbers.push_back(std::to_string(hole));
    shards.push_back("--shard " + ShardText({hole, count}));
  }
  if (holes.size() > kMostNamed) {
    numbers.push_back(fmt::format("{} more", holes.size() - kMostNamed));
  }
  const bool is_one = holes.size() == 1;
  throw InputError(file,
                   fmt::format("{} {} of {} {} in none of the files", is_one ? "shard" : "shards",
                               fmt::join(numbers, ", "), count, is_one ? "is" : "are"),
                   fmt::format("run {} ({}) and give {} too", is_one ? "it" : "each",
                               fmt::join(shards, ", "), is_one ? "its file" : "their files"));
}

void RequireShards(const Parts& parts) {
  const std::uint64_t count = parts.front().shard->count;
  std::uint64_t next = 1;
  std::vector<std::uint64_t> holes;
  const SubjectPart* last = nullptr;
  const SubjectPart* before_hole = nullptr;
  const auto add_holes = [&](std::uint64_t end) {
    if (next < end && holes.empty()) before_hole = last == nullptr ? &parts.front() : last;
    for (; next < end; ++next) holes.push_back(next);
  };
  for (const SubjectPart& part : parts) {
    if (last != nullptr && last->shard == part.shard) {
      throw InputError(part.file,
                       fmt::format("shard {} is in {} too", ShardText(*part.shard), last->file),
                       "give one of them");
    }
    add_holes(part.shard->number);
    if (part.range != CasesOf(*part.shard, part.cases.value_or(0))) {
      throw InputError(part.file, "its cases are not those of its shard", "run it again");
    }
    last = &part;
    ++next;
  }
  add_holes(count + 1);
  RequireNoHoles(before_hole == nullptr ? "" : before_hole->file, holes, count);
}

void RequireRanges(const Parts& parts) {
  std::uint64_t next = 0;
  const SubjectPart* last = nullptr;
  for (const SubjectPart& part : parts) {
    if (part.range.first < next) {
      throw InputError(part.file,
                       fmt::format("its cases {} overlap those of {} ({})", RangeText(part.range),
                                   last->file, RangeText(last->range)),
                       "give one of them, or run one that ends where the other begins");
    }
    if (part.range.first > next) {
      const std::string hole = RangeText({next, part.range.first});
      throw InputError(part.file,
                       fmt::format("the cases {} before it are in none of the files", hole),
                       fmt::format("run them (--cases {}) and give their file too", hole));
    }
    next = part.range.end;
    last = &part;
  }
}

Parts ReadAll(const std::vector<std::string>& files) {
  Parts parts;
  for (const std::string& file : files) {
    if (file.starts_with("--")) {
      throw InputError("--merge", "it takes " + file + " for a file, as every word after it",
                       "write other options before it");
    }
    parts.push_back(ReadPart(file));
  }
  RequireAgreement(parts);
  SortByCases(parts);
  if (parts.front().shard) {
    RequireShards(parts);
  } else {
    RequireRanges(parts);
  }
  return parts;
}

std::string SubjectOf(const CertifyOptions& options, const SubjectPart& part) {
  if (options.subjects.empty() && NamesWhatToRun(part.subject)) {
    throw InputError(part.file,
                     "it names a subject outside this program, and no file decides what is run",
                     "if you trust it, name it yourself: " + SubjectOption(part.subject));
  }
  const auto is_other = [&](const std::string& name) { return name != part.subject; };
  if (std::ranges::none_of(options.subjects, is_other)) return part.subject;
  throw InputError(part.file, "it is about the subject " + report::CleanText(part.subject),
                   "merge it with " + SubjectOption(part.subject));
}

void RequireKnownWorlds(const SubjectPart& part) {
  for (const std::string& world : part.worlds) {
    RequireWorld(part.file, world);
  }
}

// The subject that draws the scenes is the one that drew the cases, by this very program.
void RequireSame(const SubjectPart& part, const SubjectPart& mine) {
  const auto require = [&](bool is_same, const std::string& what, const std::string& remedy) {
    if (!is_same) throw InputError(part.file, what, remedy);
  };
  require(part.tool_version == mine.tool_version && part.environment == mine.environment,
          fmt::format("another build of rasterproof wrote it (version {})",
                      report::CleanText(part.tool_version)),
          "run all parts and merge by one build");
  require(part.stated == mine.stated, "the subject stated something else then, or is another build",
          "run the parts again, or merge with the subject that they were run on");
  require(part.options == mine.options,
          "it was run with other options:" + report::CleanText(part.options),
          "merge with the same --time-limit and --memory-limit");
  const auto is_same = [](const PropertyResult& one, const PropertyResult& other) {
    return NameOf(one) == NameOf(other);
  };
  require(std::ranges::equal(part.tests, mine.tests, is_same),
          "its properties are not those that this program has",
          "run all parts and merge by one build of rasterproof");
}

// Checks the digest, after all other checks: if a changed number is itself wrong, the error names
// that number.
void RequireUnchanged(const SubjectPart& part) {
  if (part.digest == DigestOf(part)) return;
  throw InputError(part.file, "its content is not what it was written with (another digest)",
                   "run the part again");
}

}  // namespace

int RunMerge(const CertifyOptions& options) {
  RequireHonestEnvironment();
  const Parts parts = ReadAll(options.parts);
  const SubjectPart& first = parts.front();
  CertifyOptions whole = options;
  whole.subjects = {SubjectOf(options, first)};
  RequireKnownWorlds(first);
  const SubjectInfo info = ResolveSubject(whole.subjects.front(), options.profile).Make()->Info();
  const SubjectPart mine = DescribePart(info, first.worlds);
  // All of them, before anything of any is added.
  for (const SubjectPart& part : parts) {
    RequireSame(part, mine);
    RequireSound(part, info);
    RequireUnchanged(part);
  }
  whole.campaign.seed = first.seed;
  whole.campaign.cases = parts.back().range.end;
  whole.worlds = first.worlds;
  Source source;
  source.parts = parts;
  return Certify(whole, source);
}

}  // namespace rasterproof::tool
