#include "subjects/process/serve.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <istream>
#include <string>
#include <vector>

#include "core/error.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

std::string OneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string Answer(const DrawRequest& request, const DrawOutcome& outcome, CoverageKind kind) {
  const std::string id = std::to_string(request.id);
  try {
    return AnswerText(request.id, outcome.Get(), kind);
  } catch (const InputError& error) {
    return "refused " + id + " " + OneLine(error.what()) + "\n";
  } catch (const std::exception& error) {
    return "fault " + id + " " + OneLine(error.what()) + "\n";
  } catch (...) {
    return "fault " + id + " it threw something that is no std::exception\n";
  }
}

}  // namespace

void Serve(Subject& subject, std::istream& in, const std::function<void(const std::string&)>& say) {
  for (;;) {
    const std::vector<DrawRequest> call = ReadCall(in);
    if (call.empty()) return;
    std::vector<DrawJob> jobs;
    for (const DrawRequest& request : call) jobs.push_back(request.job);
    const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
    std::string answers;
    for (std::size_t k = 0; k < outcomes.size(); ++k) {
      answers += Answer(call[k], outcomes[k], subject.Info().coverage);
    }
    say(answers);
  }
}

}  // namespace rasterproof::subjects
