#include "web/engine/packed.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/call_end.h"
#include "core/error.h"

namespace rasterproof::web {
namespace {

void Add(std::string& bytes, const void* from, std::size_t size) {
  bytes.append(static_cast<const char*>(from), size);
}

void AddJob(std::string& bytes, const DrawJob& job) {
  const Scene& scene = *job.scene;
  const auto triangles = job.Triangles();
  const PixelRect scissor = job.options.scissor.value_or(PixelRect{});
  const std::array<std::int32_t, 12> head{scene.width,
                                          scene.height,
                                          job.samples,
                                          scene.clip_space ? 1 : 0,
                                          static_cast<std::int32_t>(job.options.cull),
                                          job.options.scissor ? 1 : 0,
                                          scissor.x0,
                                          scissor.y0,
                                          scissor.x1,
                                          scissor.y1,
                                          static_cast<std::int32_t>(scene.vertices.size()),
                                          static_cast<std::int32_t>(triangles.size())};
  Add(bytes, head.data(), sizeof(head));
  for (const Vertex& v : scene.vertices) {
    const std::array<double, 4> numbers{v.x, v.y, v.z, v.w};
    Add(bytes, numbers.data(), sizeof(numbers));
  }
  for (const Triangle& t : triangles) Add(bytes, t.data(), 3 * sizeof(std::int32_t));
  if (bytes.size() % 8 != 0) bytes.append(4, '\0');
}

class AnswerReader {
 public:
  explicit AnswerReader(std::string_view bytes) : bytes_(bytes) {}
  bool AtEnd() const { return bytes_.empty(); }
  std::int32_t Number() {
    std::int32_t number = 0;
    std::memcpy(&number, Bytes(sizeof(number)).data(), sizeof(number));
    return number;
  }
  std::string_view Bytes(std::size_t size) {
    if (size > bytes_.size()) throw InputError("answers", "end too soon", "write them whole");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

 private:
  std::string_view bytes_;
};

// What is said of a draw that has no answer, in the words of a program on a pipe.
CallEnd EndOf(std::int32_t how, std::string reason, const SubjectInfo& info) {
  if (how == 1) {
    const InputError refusal("subject " + info.name, "it refused the scene: " + reason,
                             "give it another one");
    return {Stop::kRefused, refusal.what()};
  }
  return {how == 2 ? Stop::kBrokeDown : Stop::kOutOfMemory, std::move(reason)};
}

void TakeIds(const std::vector<std::int32_t>& ids, std::size_t triangles, DrawOutcome& outcome) {
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (ids[k] < kNoPrimitive || ids[k] >= static_cast<std::int64_t>(triangles)) {
      outcome = {{},
                 {Stop::kBrokeDown, "it names triangle " + std::to_string(ids[k]) +
                                        " as visible at a sample, in a scene of " +
                                        std::to_string(triangles) + " triangles"}};
      return;
    }
    outcome.drawing.counts.front[k] = ids[k] == kNoPrimitive ? 0 : 1;
  }
  outcome.drawing.primitive_ids = ids;
}

DrawOutcome Answered(AnswerReader& in, std::size_t length, const DrawJob& job,
                     const SubjectInfo& info) {
  DrawOutcome outcome;
  CoverageCounts& counts = outcome.drawing.counts;
  counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  const bool has_facings = info.coverage == CoverageKind::kFacingCounts;
  const std::size_t size = counts.size();
  if (length != (has_facings ? 2 * size : size)) {
    throw InputError(
        "answers",
        std::to_string(length) + " numbers for a target of " + std::to_string(size) + " samples",
        "give height * width * samples of them, twice as many with facings");
  }
  const std::string_view bytes = in.Bytes(4 * length);
  if (ShowsPrimitiveIds(info)) {
    std::vector<std::int32_t> ids(size);
    std::memcpy(ids.data(), bytes.data(), bytes.size());
    TakeIds(ids, job.Triangles().size(), outcome);
    return outcome;
  }
  std::memcpy(counts.front.data(), bytes.data(), 4 * size);
  if (has_facings) std::memcpy(counts.back.data(), bytes.data() + 4 * size, 4 * size);
  if (info.coverage == CoverageKind::kMask) {
    for (std::uint32_t& count : counts.front) count = count == 0 ? 0 : 1;
  }
  return outcome;
}

}  // namespace

std::string PackedJobs(std::span<const DrawJob> jobs) {
  const std::array<std::int32_t, 2> head{static_cast<std::int32_t>(jobs.size()), 0};
  std::string bytes;
  Add(bytes, head.data(), sizeof(head));
  for (const DrawJob& job : jobs) AddJob(bytes, job);
  return bytes;
}

std::vector<DrawOutcome> OutcomesFrom(std::string_view bytes, std::span<const DrawJob> jobs,
                                      const SubjectInfo& info) {
  AnswerReader in(bytes);
  std::vector<DrawOutcome> outcomes;
  while (!in.AtEnd()) {
    if (outcomes.size() == jobs.size())
      throw InputError("answers", "are more than the requests", "answer each of them once");
    const std::int32_t how = in.Number();
    const std::int32_t length = in.Number();
    if (how < 0 || how > 3 || length < 0)
      throw InputError("answers", "are damaged", "write them as web/engine/packed.h says");
    const auto size = static_cast<std::size_t>(length);
    if (how == 0) {
      outcomes.push_back(Answered(in, size, jobs[outcomes.size()], info));
    } else {
      std::string reason(in.Bytes((size + 3) / 4 * 4).substr(0, size));
      outcomes.push_back({{}, EndOf(how, std::move(reason), info)});
    }
  }
  return outcomes;
}

}  // namespace rasterproof::web
