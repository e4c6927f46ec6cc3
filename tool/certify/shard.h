// Which cases of a campaign one worker runs.
#ifndef RASTERPROOF_TOOL_CERTIFY_SHARD_H_
#define RASTERPROOF_TOOL_CERTIFY_SHARD_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tool/certify/cmd_certify.h"

namespace rasterproof::tool {

inline constexpr std::uint64_t kMostShards = 1'000'000;
inline constexpr std::uint64_t kMostCases = std::uint64_t{1} << 62;

/// Shard `number` of `count`, counted from 1 as they are typed.
struct Shard {
  std::uint64_t number = 1;
  std::uint64_t count = 1;

  friend bool operator==(const Shard&, const Shard&) = default;
};

/// "2/5"
std::string ShardText(const Shard& shard);

/// What --cases says: "1000", or "200..400" (200 is the first of them, 399 the last).
///
/// Error:      InputError.
void ParseCases(const std::string& text, CertifyOptions& options);

/// The value of a variable of the environment; nothing if it is not set.
using Variables = std::function<std::optional<std::string>(const std::string& name)>;
Variables EnvironmentVariables();

/// What --shard says: "2/5", or "auto": what the variables of an engine say, of GoogleTest
/// (GTEST_SHARD_INDEX), Slurm's arrays (SLURM_ARRAY_TASK_ID) or Open MPI (OMPI_COMM_WORLD_RANK).
///
/// Error:      InputError if it is no shard; for "auto" also if no engine says anything, if one
///             says only half of it or what cannot be, or if two say different things.
Shard ParseShard(const std::string& text, const Variables& variables);

/// The shard's cases of `total`: those of all shards follow each other, as long as each other but
/// for one case.
CaseRange CasesOf(const Shard& shard, std::uint64_t total);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_SHARD_H_
