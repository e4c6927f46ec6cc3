#include "subjects/process/serve.h"

#include <algorithm>
#include <exception>
#include <istream>
#include <optional>
#include <string>

#include "core/error.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

std::string OneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string Answer(Subject& subject, const DrawRequest& request) {
  const std::string id = std::to_string(request.id);
  CoverageCounts counts(request.scene.width, request.scene.height, request.samples);
  try {
    subject.Draw(request.scene, request.options, counts);
  } catch (const InputError& error) {
    return "refused " + id + " " + OneLine(error.what()) + "\n";
  } catch (const std::exception& error) {
    return "fault " + id + " " + OneLine(error.what()) + "\n";
  } catch (...) {
    return "fault " + id + " it threw something that is no std::exception\n";
  }
  return CountsText(request.id, counts, subject.Info().coverage == CoverageKind::kFacingCounts);
}

}  // namespace

void Serve(Subject& subject, std::istream& in, const std::function<void(const std::string&)>& say) {
  while (const std::optional<DrawRequest> request = ReadRequest(in)) say(Answer(subject, *request));
}

}  // namespace rasterproof::subjects
