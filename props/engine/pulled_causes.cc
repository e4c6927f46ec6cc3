#include "props/engine/pulled_causes.h"

#include <limits>
#include <memory>
#include <span>

namespace rasterproof::props {
namespace {

// Draws by the answers: a subject of its own wherever one is made.
class Answering final : public Subject {
 public:
  explicit Answering(KnownAnswers& answers) : answers_(answers) {}
  const SubjectInfo& OwnInfo() const override { return answers_.Info(); }
  bool SharesCalls() const override { return true; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    return answers_.DrawMany(jobs);
  }

 private:
  KnownAnswers& answers_;
};

}  // namespace

bool PulledCauses::GoOn(KnownAnswers& answers) {
  if (result_) return true;
  const auto failures = failures_();
  if (!failures) return false;
  const std::uint64_t before = answers.missed();
  Causes causes = FindCauses([&] { return std::make_unique<Answering>(answers); }, *failures,
                             std::numeric_limits<double>::infinity());
  if (answers.missed() != before) return false;
  result_ = std::move(causes);
  return true;
}

}  // namespace rasterproof::props
