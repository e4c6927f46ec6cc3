#include "tool/certify/shard.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"

namespace rasterproof::tool {
namespace {

constexpr std::string_view kByHand = "give it by hand: --shard 1/3";

std::optional<std::uint64_t> WholeNumber(std::string_view text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || at != end) return std::nullopt;
  return number;
}

// A shard, and the variables that say so.
struct Said {
  Shard shard;
  std::string by;
};

// Reads variables of one engine.
class Engine {
 public:
  explicit Engine(const Variables& variables) : variables_(variables) {}

  bool Has(const std::string& name) const { return variables_(name).has_value(); }

  std::uint64_t Number(const std::string& name) const {
    const std::optional<std::string> text = variables_(name);
    if (!text) {
      throw InputError("--shard auto", name + " is not set, though related variables are",
                       std::string(kByHand));
    }
    const std::optional<std::uint64_t> number = WholeNumber(*text);
    if (number) return *number;
    throw InputError("--shard auto", fmt::format("{} is '{}', not a count", name, *text),
                     std::string(kByHand));
  }

 private:
  const Variables& variables_;
};

Said Numbered(std::uint64_t index, std::uint64_t count, const std::string& by) {
  if (index >= count || count > kMostShards) {
    throw InputError("--shard auto", fmt::format("{} say shard {} of {}", by, index + 1, count),
                     std::string(kByHand));
  }
  return {{index + 1, count}, by};
}

std::optional<Said> Indexed(const Engine& engine, const std::string& index,
                            const std::string& count) {
  if (!engine.Has(index) && !engine.Has(count)) return std::nullopt;
  return Numbered(engine.Number(index), engine.Number(count), index + " and " + count);
}

// Task ids begin where the user says, and go on in steps.
std::optional<Said> OfSlurm(const Engine& engine) {
  if (!engine.Has("SLURM_ARRAY_TASK_ID")) return std::nullopt;
  const std::uint64_t id = engine.Number("SLURM_ARRAY_TASK_ID");
  const std::uint64_t least = engine.Number("SLURM_ARRAY_TASK_MIN");
  const std::uint64_t count = engine.Number("SLURM_ARRAY_TASK_COUNT");
  const std::uint64_t step =
      engine.Has("SLURM_ARRAY_TASK_STEP") ? engine.Number("SLURM_ARRAY_TASK_STEP") : 1;
  if (id < least || step == 0 || (id - least) % step != 0) {
    throw InputError("--shard auto",
                     fmt::format("SLURM_ARRAY_TASK_ID is {}, in an array from {} in steps of {}",
                                 id, least, step),
                     "number the array's tasks 1-N, or " + std::string(kByHand));
  }
  return Numbered((id - least) / step, count, "SLURM_ARRAY_TASK_ID, _MIN, _STEP and _COUNT");
}

Shard FromVariables(const Variables& variables) {
  const Engine engine(variables);
  std::vector<Said> all;
  for (const std::optional<Said>& said :
       {Indexed(engine, "GTEST_SHARD_INDEX", "GTEST_TOTAL_SHARDS"), OfSlurm(engine),
        Indexed(engine, "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE")}) {
    if (said) all.push_back(*said);
  }
  if (all.empty()) {
    throw InputError(
        "--shard auto",
        "none of GTEST_SHARD_INDEX, SLURM_ARRAY_TASK_ID and OMPI_COMM_WORLD_RANK is set",
        std::string(kByHand));
  }
  for (const Said& other : all) {
    if (other.shard == all.front().shard) continue;
    throw InputError("--shard auto",
                     fmt::format("{} say {}, but {} say {}", all.front().by,
                                 ShardText(all.front().shard), other.by, ShardText(other.shard)),
                     "unset those of one engine, or " + std::string(kByHand));
  }
  return all.front().shard;
}

}  // namespace

std::string ShardText(const Shard& shard) {
  return fmt::format("{}/{}", shard.number, shard.count);
}

void ParseCases(const std::string& text, CertifyOptions& options) {
  const std::size_t dots = text.find("..");
  const auto refuse = [&](const std::string& reason) {
    return InputError("--cases " + text, reason,
                      "give a number above 0, or a range: 200..400 for cases 200 to 399");
  };
  if (dots == std::string::npos) {
    const std::optional<std::uint64_t> cases = WholeNumber(text);
    if (!cases || *cases == 0 || *cases > kMostCases) throw refuse("not a number of cases");
    options.campaign.cases = *cases;
    return;
  }
  const std::string_view whole = text;
  const std::optional<std::uint64_t> first = WholeNumber(whole.substr(0, dots));
  const std::optional<std::uint64_t> end = WholeNumber(whole.substr(dots + 2));
  if (!first || !end || *end > kMostCases) throw refuse("not two numbers of cases");
  if (*first >= *end) throw refuse("the range is empty");
  options.range = CaseRange{*first, *end};
}

Variables EnvironmentVariables() {
  return [](const std::string& name) -> std::optional<std::string> {
    const char* const value = std::getenv(name.c_str());
    if (value == nullptr) return std::nullopt;
    return value;
  };
}

Shard ParseShard(const std::string& text, const Variables& variables) {
  if (text == "auto") return FromVariables(variables);
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const std::string_view whole = text;
    const std::optional<std::uint64_t> number = WholeNumber(whole.substr(0, slash));
    const std::optional<std::uint64_t> count = WholeNumber(whole.substr(slash + 1));
    const bool is_one = number && count && *number >= 1 && *number <= *count;
    if (is_one && *count <= kMostShards) return {*number, *count};
  }
  throw InputError("--shard " + text, "not a shard",
                   fmt::format("give 1/N to N/N with N up to {}, or auto", kMostShards));
}

CaseRange CasesOf(const Shard& shard, std::uint64_t total) {
  // The first `rest` shards have one case more.
  const std::uint64_t each = total / shard.count;
  const std::uint64_t rest = total % shard.count;
  const auto begin_of = [&](std::uint64_t index) { return index * each + std::min(index, rest); };
  return {begin_of(shard.number - 1), begin_of(shard.number)};
}

}  // namespace rasterproof::tool
