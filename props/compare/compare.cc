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
  cell.triangles += given.scene.triangles.size();
  cell.samples += samples;
  cell.wrong_samples += reading.wrong.size();
  if (reading.wrong.empty()) return;
  ++cell.wrong;
  cell.by_snap += reading.is_by_snap ? 1 : 0;
  if (cell.worst && reading.furthest <= cell.furthest) return;
  cell.worst = given;
  cell.furthest = reading.furthest;
}

// Puts the yardsticks to a case. Returns whether a draw ended the subject or took it too long.
bool Take(const Row& row, std::span<const Yardstick> yardsticks, const CaseAtHand& at,
          std::vector<Cell>& cells) {
  std::vector<std::pair<Judging, Cell*>> judgings;
  for (std::size_t k = 0; k < yardsticks.size(); ++k) {
    Judging judging = yardsticks[k](at);
    if (!judging.why_not.empty()) {
      Excuse(judging.why_not, cells[k]);
    } else {
      judgings.emplace_back(std::move(judging), &cells[k]);
    }
  }
  if (judgings.empty()) return false;
  const Drawn drawn = row.draw(at);
  bool ends = EndsTheCall(drawn.end.stop);
  for (const auto& [judging, cell] : judgings) {
    if (drawn.end.stop != Stop::kNone) {
      AddEnd(at.given, drawn.end, *cell);
      continue;
    }
    const Reading reading = judging.read(drawn);
    ends = ends || EndsTheCall(reading.end.stop);
    AddReading(at.given, reading, drawn.drawing->counts.size(), *cell);
  }
  return ends;
}

}  // namespace

std::vector<Cell> CompareRow(const Row& row, std::span<const Yardstick> yardsticks,
                             const Limits& limits) {
  const Clock::time_point began = Clock::now();
  const auto is_over = [&] {
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    return (limits.seconds > 0 && seconds >= limits.seconds) || (limits.stop && limits.stop());
  };
  std::vector<Cell> cells(yardsticks.size());
  std::uint64_t stops = 0;
  for (std::uint64_t k = 0; k < row.cases && stops < kMostStops && !is_over(); ++k) {
    const Case given = row.at(k);
    stops += Take(row, yardsticks, {k, given}, cells) ? 1 : 0;
    if (limits.progress) limits.progress(k + 1);
  }
  return cells;
}

}  // namespace rasterproof::props
