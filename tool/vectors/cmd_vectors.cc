// rasterproof vectors generate: cases and what is required of them, as files.
#include "tool/vectors/cmd_vectors.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/test_vector.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/vectors/draw_vectors.h"
#include "props/vectors/stated_world.h"
#include "props/vectors/value_vectors.h"
#include "report/vectors_json.h"
#include "report/vectors_tables.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/progress.h"

namespace rasterproof::tool {
namespace {

constexpr std::uint64_t kCasesOfLevel1 = 500;
constexpr std::uint64_t kCasesOfLevel2 = 50'000;
// Of a world, without --yes; and of its file, which is put together in memory.
constexpr std::uint64_t kMostUnasked = 1'000'000;
constexpr double kMostBytes = 16e9;

VectorsHeader HeaderOf(const GenerateOptions& options, const Profile& profile) {
  VectorsHeader header;
  header.program = "rasterproof " RASTERPROOF_VERSION;
  header.profile = profile;
  header.seed = options.seed;
  header.level = options.level;
  if (!options.world.empty()) header.world = props::ParseStatedWorld(options.world).Name();
  header.lattice_bits = props::LatticeBitsOf(profile);
  header.sample_clauses = props::SampleClausesOf(profile);
  header.joint_clauses = props::JointClausesOf(profile);
  if (options.values) header.values = 0;
  return header;
}

// What a world costs, from a few of its cases.
struct WorldCost {
  double seconds = 0;
  double bytes = 0;
};

WorldCost CostOf(const props::StatedWorld& world, const VectorsHeader& header) {
  constexpr std::uint64_t kMeasured = 256;
  const std::uint64_t measured = std::min(kMeasured, world.Cases());
  std::size_t bytes = 0;
  const auto before = std::chrono::steady_clock::now();
  for (std::uint64_t k = 0; k < measured; ++k) {
    const std::uint64_t index = k * (world.Cases() / measured);
    const auto vector = props::VectorOf(CaseOfStatedWorld(world, index, header.profile),
                                        {.with_values = header.values.has_value()});
    if (vector) bytes += report::VectorLines(*vector, header).size();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
  const double share = static_cast<double>(world.Cases()) / static_cast<double>(measured);
  return {took.count() * share, static_cast<double>(bytes) * share};
}

// Says what the world costs, and refuses one that costs too much.
void RequireAffordable(const props::StatedWorld& world, const GenerateOptions& options,
                       const VectorsHeader& header) {
  const WorldCost cost = CostOf(world, header);
  const std::string costs = fmt::format("{} triangles, about {:.0f} s and {:.0f} MB as jsonl",
                                        world.Cases(), cost.seconds, cost.bytes / 1e6);
  Tell(fmt::format("world {}: {}\n", world.Name(), costs));
  if (cost.bytes > kMostBytes) {
    throw InputError("--world " + options.world, "it has " + costs + ", more than 16 GB",
                     "give fewer bits: each bit less divides the triangles by 64");
  }
  if (world.Cases() > kMostUnasked && !options.yes) {
    throw InputError("--world " + options.world, "it has " + costs,
                     "give --yes if that is what you want, or fewer bits");
  }
}

// Every triangle of the world that is a vector.
template <class Take>
void TakeWorld(const props::StatedWorld& world, const VectorsHeader& header,
               const props::VectorChoice& choice, const Take& take) {
  for (std::uint64_t k = 0; k < world.Cases(); ++k) {
    auto vector = props::VectorOf(CaseOfStatedWorld(world, k, header.profile), choice);
    if (!vector) continue;
    vector->domain = "every triangle of a lattice of few bits";
    take(*vector);
  }
}

// Draws the vectors, counts them in the header and hands each to `keep`.
template <class Keep>
void DrawAll(const GenerateOptions& options, VectorsHeader& header, const Keep& keep) {
  props::VectorChoice choice{.seed = options.seed,
                             .only_on_lattice = options.format != "jsonl",
                             .with_values = options.values};
  choice.cases = options.level == 1 ? kCasesOfLevel1 : kCasesOfLevel2;
  if (options.cases != 0) choice.cases = options.cases;
  std::optional<props::StatedWorld> world;
  if (!options.world.empty()) world = props::ParseStatedWorld(options.world);
  if (world) choice.cases = world->Cases();
  Progress progress;
  progress.Stage("vectors of profile " + header.profile.name, choice.cases);
  const auto take = [&](const TestVector& vector) {
    ++header.cases;
    header.triangles += vector.triangles.size();
    header.joint += vector.joint.size();
    if (header.values) *header.values += vector.values.size();
    keep(vector);
    progress.Done(header.cases);
    return true;
  };
  if (world) {
    TakeWorld(*world, header, choice, take);
  } else {
    props::DrawVectors(header.profile, choice, take);
  }
  if (header.cases == 0) {
    throw InputError("profile \"" + header.profile.name + "\"", "no drawn case can become a vector",
                     "give a profile whose grid and limits leave room in a target of 64x64");
  }
}

}  // namespace

int RunGenerate(const GenerateOptions& options) {
  RequireHonestEnvironment();
  const Profile profile = io::ReadProfile(options.profile);
  props::RequireStatesSamples(profile);
  if (options.values) props::RequireStatesValues(profile);
  VectorsHeader header = HeaderOf(options, profile);
  if (options.format == "readmemh") {
    if (options.output == "-") {
      throw InputError("--out -", "readmemh writes several files", "name a folder");
    }
    io::RequireFolderCanBe(options.output);
  } else {
    io::RequireFileCanBe(options.output);
  }
  if (!options.world.empty())
    RequireAffordable(props::ParseStatedWorld(options.world), options, header);
  if (options.format == "jsonl") {
    std::string body;
    DrawAll(options, header,
            [&](const TestVector& vector) { body += report::VectorLines(vector, header); });
    io::WriteOutput(options.output, report::VectorsHeaderLine(header, body) + body);
  } else {
    std::vector<TestVector> vectors;
    DrawAll(options, header, [&](const TestVector& vector) { vectors.push_back(vector); });
    if (options.format == "c") {
      io::WriteOutput(options.output, report::VectorsAsC(header, vectors));
    } else {
      io::MakeFolder(options.output);
      for (const auto& [name, text] : report::VectorsAsReadmemh(header, vectors))
        io::WriteFile(options.output + "/" + name, text);
    }
  }
  Tell(fmt::format("{} cases with {} triangles and {} joint constraints of profile {}\n",
                   header.cases, header.triangles, header.joint, profile.name));
  return kExitHolds;
}

}  // namespace rasterproof::tool
