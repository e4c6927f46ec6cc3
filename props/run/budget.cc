#include "props/run/budget.h"

#include <algorithm>

namespace rasterproof::props {

Budget::Budget(Subject& subject, const CampaignOptions& options)
    : subject_(subject), options_(options) {
  if (options.seconds > 0) end_ = In(options.seconds);
  GiveSubjectAll();
}

Budget::~Budget() { subject_.SetDeadline(Clock::time_point::max()); }

Budget::Clock::time_point Budget::Now() const {
  return options_.now ? options_.now() : Clock::now();
}

double Budget::Since(Clock::time_point start) const {
  return std::chrono::duration<double>(Now() - start).count();
}

void Budget::GiveSubject(double seconds) { subject_.SetDeadline(std::min(end_, In(seconds))); }

void Budget::GiveSubjectAll() { subject_.SetDeadline(end_); }

Budget::Clock::time_point Budget::In(double seconds) const {
  constexpr double kForEver = 1e9;  // 30 years, which no clock overflows by
  if (seconds >= kForEver) return Clock::time_point::max();
  const std::chrono::duration<double> time(seconds);
  return Now() + std::chrono::duration_cast<Clock::duration>(time);
}

}  // namespace rasterproof::props
