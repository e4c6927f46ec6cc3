// The pipe's protocol: a first byte of 'q' for requests, which are read and written again; any
// other for a program's answers, of a kind that the byte chooses.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/subject_info.h"
#include "fuzz/files/parser.h"
#include "fuzz/fuzz_target.h"
#include "subjects/process/protocol.h"

namespace {

using rasterproof::CoverageKind;
using rasterproof::DrawJob;
using rasterproof::InputError;
using rasterproof::SubjectInfo;
using rasterproof::SubjectStop;
using rasterproof::fuzz::TextOf;

// The requests of all calls, written again.
std::string Rewritten(std::string_view text) {
  std::istringstream in{std::string(text)};
  rasterproof::subjects::RequestReader reader(in);
  SubjectInfo info;
  info.takes_same = info.takes_wants = info.takes_npy = true;
  info.coverage = CoverageKind::kFragments;
  info.takes_threads = true;
  info.fragments.shows_values = info.fragments.shows_derivatives = true;
  std::string written;
  for (std::uint64_t id = 1;;) {
    if (const auto edge = reader.NextEdgeRequest()) {
      written += rasterproof::subjects::RequestsText(std::vector{*edge});
      continue;
    }
    std::vector<DrawJob> jobs;
    for (auto& request : reader.NextCall()) jobs.push_back(std::move(request.job));
    if (jobs.empty()) return written;
    if (jobs.size() > 1) written += rasterproof::subjects::BatchText(jobs.size());
    written += rasterproof::subjects::RequestsText(id, jobs, info);
    id += jobs.size();
  }
}

void ReadRequests(std::string_view text) {
  const auto written = rasterproof::fuzz::IfRead(Rewritten, text);
  if (!written) return;
  const auto again = rasterproof::fuzz::IfRead(Rewritten, *written);
  if (!again) rasterproof::fuzz::Fail("requests as written are refused: " + *written);
  if (*again != *written) {
    rasterproof::fuzz::Fail("requests read back differently: " + *written + "\nthen " + *again);
  }
}

// What follows is a program's answer to a draw of 3x2 pixels of two samples.
void ReadAnswers(std::uint8_t kind, std::string_view text) {
  rasterproof::Scene scene;
  scene.width = 3;
  scene.height = 2;
  scene.vertices = {{0, 0}, {1, 0}, {0, 1}};
  scene.triangles = {{0, 1, 2}};
  const DrawJob job(scene, {}, 2);
  SubjectInfo info;
  info.coverage = static_cast<CoverageKind>(kind % 5);
  const auto next_line = [&](std::size_t /*most_bytes*/) {
    if (text.empty()) throw SubjectStop(rasterproof::Stop::kBrokeDown, "no more lines");
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
  };
  const auto next_bytes = [&](std::size_t count) {
    if (text.size() < count) throw SubjectStop(rasterproof::Stop::kBrokeDown, "no more bytes");
    const std::string_view bytes = text.substr(0, count);
    text.remove_prefix(count);
    return bytes;
  };
  try {
    const auto drawing = rasterproof::subjects::ReadAnswer(1, job, info, next_line, next_bytes);
    constexpr std::size_t kSamples = 12;
    if (drawing.counts.size() != kSamples) {
      rasterproof::fuzz::Fail("an answer of the wrong shape was taken");
    }
    rasterproof::subjects::EdgeRequest edge;
    edge.id = 1;
    edge.steps = 3;
    rasterproof::subjects::ReadValues(edge, "fuzz", next_line);
  } catch (const InputError&) {
    return;
  } catch (const SubjectStop&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return rasterproof::fuzz::kLookedAt;
  const std::string_view text = TextOf(data + 1, size - 1);
  if (data[0] == 'q') {
    ReadRequests(text);
  } else {
    ReadAnswers(data[0], text);
  }
  return rasterproof::fuzz::kLookedAt;
}
