#include "web/engine/packed.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/call_end.h"
#include "core/error.h"
#include "core/shown_outputs.h"

namespace rasterproof::web {
namespace {

void Add(std::string& bytes, const void* from, std::size_t size) {
  bytes.append(static_cast<const char*>(from), size);
}

// What is wanted of fragments and shown, in the order in which it is answered.
struct Wanted {
  Wanted(const DrawJob& job, const SubjectInfo& info) {
    if (info.coverage != CoverageKind::kFragments) return;
    wants = ShownOutputs(job, info);
    channels = wants.values ? job.scene->channels.size() : 0;
  }

  std::int32_t Bits() const {
    const std::array<bool, 5> each{wants.barycentrics, wants.depths, wants.centroids, wants.values,
                                   wants.derivatives};
    std::int32_t bits = 0;
    for (std::size_t k = 0; k < each.size(); ++k) bits += each[k] ? 1 << k : 0;
    return bits;
  }
  // Doubles of a sample.
  std::size_t Doubles() const {
    const auto times = [](bool wanted, std::size_t count) { return wanted ? count : 0; };
    return times(wants.barycentrics, 3) + times(wants.depths, 1) + times(wants.centroids, 3) +
           channels + times(wants.derivatives, 2 * channels);
  }

  Outputs wants = kCoverageAlone;
  std::size_t channels = 0;
};

void AddChannel(std::string& bytes, const Channel& channel) {
  const std::array<std::int32_t, 2> how{static_cast<std::int32_t>(channel.interpolation),
                                        static_cast<std::int32_t>(channel.at)};
  Add(bytes, how.data(), sizeof(how));
  Add(bytes, channel.values.data(), channel.values.size() * sizeof(double));
}

void AddJob(std::string& bytes, const DrawJob& job, const SubjectInfo& info) {
  const Scene& scene = *job.scene;
  const auto triangles = job.Triangles();
  const PixelRect scissor = job.options.scissor.value_or(PixelRect{});
  const Wanted wanted(job, info);
  const std::array<std::int32_t, 14> head{scene.width,
                                          scene.height,
                                          job.samples,
                                          scene.clip_space ? 1 : 0,
                                          static_cast<std::int32_t>(job.options.cull),
                                          job.options.scissor ? 1 : 0,
                                          scissor.x0,
                                          scissor.y0,
                                          scissor.x1,
                                          scissor.y1,
                                          wanted.Bits(),
                                          static_cast<std::int32_t>(wanted.channels),
                                          static_cast<std::int32_t>(scene.vertices.size()),
                                          static_cast<std::int32_t>(triangles.size())};
  Add(bytes, head.data(), sizeof(head));
  for (const Vertex& v : scene.vertices) {
    const std::array<double, 4> numbers{v.x, v.y, v.z, v.w};
    Add(bytes, numbers.data(), sizeof(numbers));
  }
  for (std::size_t c = 0; c < wanted.channels; ++c) AddChannel(bytes, scene.channels[c]);
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
  template <class T>
  void Into(std::vector<T>& values) {
    const std::string_view bytes = Bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
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

void TakeFragments(AnswerReader& in, const Wanted& wanted, std::size_t size, Drawing& drawing) {
  const auto take = [&](bool is_there, auto& values, std::size_t count) {
    values.resize(is_there ? count : 0);
    in.Into(values);
  };
  const Outputs& wants = wanted.wants;
  take(wants.barycentrics, drawing.barycentrics, size);
  take(wants.depths, drawing.depths, size);
  take(wants.centroids, drawing.centroids, size);
  take(wants.values, drawing.values, size * wanted.channels);
  take(wants.derivatives, drawing.derivatives, size * wanted.channels);
}

DrawOutcome Answered(AnswerReader& in, std::size_t length, const DrawJob& job,
                     const SubjectInfo& info) {
  DrawOutcome outcome;
  CoverageCounts& counts = outcome.drawing.counts;
  counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  const bool has_facings = info.coverage == CoverageKind::kFacingCounts;
  const Wanted wanted(job, info);
  const std::size_t size = counts.size();
  if (length != size * (has_facings ? 2 : 1 + 2 * wanted.Doubles())) {
    throw InputError(
        "answers",
        std::to_string(length) + " numbers for a target of " + std::to_string(size) + " samples",
        "give height * width * samples of them, twice as many with facings, and of fragments what "
        "is wanted, in doubles");
  }
  if (ShowsPrimitiveIds(info)) {
    std::vector<std::int32_t> ids(size);
    in.Into(ids);
    TakeFragments(in, wanted, size, outcome.drawing);
    TakeIds(ids, job.Triangles().size(), outcome);
    return outcome;
  }
  const std::string_view bytes = in.Bytes(4 * length);
  std::memcpy(counts.front.data(), bytes.data(), 4 * size);
  if (has_facings) std::memcpy(counts.back.data(), bytes.data() + 4 * size, 4 * size);
  if (info.coverage == CoverageKind::kMask) {
    for (std::uint32_t& count : counts.front) count = count == 0 ? 0 : 1;
  }
  return outcome;
}

}  // namespace

std::string PackedJobs(std::span<const DrawJob> jobs, const SubjectInfo& info) {
  const std::array<std::int32_t, 2> head{static_cast<std::int32_t>(jobs.size()), 0};
  std::string bytes;
  Add(bytes, head.data(), sizeof(head));
  for (const DrawJob& job : jobs) AddJob(bytes, job, info);
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
