#include "props/compare/compare.h"

#include <chrono>
#include <utility>

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMostStops = 4;

void Excuse(const std::string& why, Cell& cell) {
  if (cell.excused++ == 0 && cell.why.empty()) cell.why = why;
}

// A case without a drawing.
void AddEnd(const Case& given, const CallEnd& end, Cell& cell) {
  if (!IsBreakdown(end.stop)) {
    cell.refused += end.stop == Stop::kRefused ? 1 : 0;
    return Excuse(end.why, cell);
  }
  ++cell.cases;
  ++cell.wrong;
  cell.has_hung = cell.has_hung || end.stop == Stop::kHung;
  if (cell.ended++ != 0) return;
  cell.ended_on = given;
  cell.why = end.why;
}

void AddReading(const Case& given, const Reading& reading, std::size_t samples, Cell& cell) {
  if (reading.end.stop != Stop::kNone) return AddEnd(given, reading.end, cell);
  ++cell.cases;
  cell.samples += samples;
  cell.wrong_samples += reading.wrong.size();
  if (reading.wrong.empty()) return;
  ++cell.wrong;
  cell.by_snap += reading.is_by_snap ? 1 : 0;
  if (cell.worst && reading.furthest <= cell.furthest) return;
  cell.worst = given;
  cell.furthest = reading.furthest;
}

class Comparing {
 public:
  Comparing(const Row& row, std::span<const Yardstick> yardsticks)
      : row_(row), yardsticks_(yardsticks), cells_(yardsticks.size()) {}

  bool IsGivenUp() const { return stops_ >= kMostStops; }

  void Take(std::uint64_t index) {
    const Case given = row_.at(index);
    const CaseAtHand at(index, given);
    std::vector<std::pair<Judging, Cell*>> judgings;
    for (std::size_t k = 0; k < yardsticks_.size(); ++k) {
      Judging judging = yardsticks_[k](at);
      if (judging.why_not.empty()) {
        judgings.emplace_back(std::move(judging), &cells_[k]);
      } else {
        Excuse(judging.why_not, cells_[k]);
      }
    }
    if (judgings.empty()) return;
    const Drawn drawn = row_.draw(at);
    stops_ += EndsTheCall(drawn.end.stop) ? 1 : 0;
    for (const auto& [judging, cell] : judgings) {
      if (drawn.end.stop != Stop::kNone) {
        AddEnd(given, drawn.end, *cell);
      } else {
        AddReading(given, judging.read(drawn), drawn.drawing->counts.size(), *cell);
      }
    }
  }

  std::vector<Cell> Cells() { return std::move(cells_); }

 private:
  const Row& row_;
  std::span<const Yardstick> yardsticks_;
  std::vector<Cell> cells_;
  std::uint64_t stops_ = 0;
};

}  // namespace

std::vector<Cell> CompareRow(const Row& row, std::span<const Yardstick> yardsticks,
                             const Limits& limits) {
  const Clock::time_point began = Clock::now();
  const auto is_over = [&] {
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    return (limits.seconds > 0 && seconds >= limits.seconds) || (limits.stop && limits.stop());
  };
  Comparing comparing(row, yardsticks);
  for (std::uint64_t k = 0; k < row.cases && !comparing.IsGivenUp() && !is_over(); ++k) {
    comparing.Take(k);
    if (limits.progress) limits.progress(k + 1);
  }
  return comparing.Cells();
}

}  // namespace rasterproof::props
