// Part of a subject's campaign as a file: what `certify --shard` writes and `--merge` reads.
#ifndef RASTERPROOF_TOOL_CERTIFY_PART_FILE_H_
#define RASTERPROOF_TOOL_CERTIFY_PART_FILE_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "tool/certify/cmd_certify.h"
#include "tool/certify/shard.h"

namespace rasterproof::tool {

struct SubjectPart {
  std::string file;  ///< where it was read
  std::string tool_version;
  std::map<std::string, std::string> environment;
  std::string subject;
  std::string stated;   ///< what the subject says of itself: JSON
  std::string options;  ///< the options that all parts share, as typed; worlds among them
  std::vector<std::string> worlds;
  std::uint64_t seed = 0;
  CaseRange range;                     ///< of drawn cases
  std::optional<Shard> shard;          ///< nothing: --cases A..B
  std::optional<std::uint64_t> cases;  ///< of the campaign, where that is known: with a shard
  /// Of each property and world: the names, counters, end and counterexample alone.
  std::vector<PropertyResult> tests;
  std::string digest;  ///< as read: of all that it was written with
};

/// The part's digest: HashText() of its content, however a file spells it. It tells whether two
/// differ, not who made them.
std::string DigestOf(const SubjectPart& part);

/// Reads back what PartToJson wrote. Of a counterexample all but `compared` is kept.
std::string PartToJson(const SubjectPart& part);

/// Error:      InputError if it can't be read, is no part, or names no shard or range that can be.
SubjectPart ReadPart(const std::string& path);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_PART_FILE_H_
