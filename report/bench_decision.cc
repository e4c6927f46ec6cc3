#include "report/bench_decision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "fmt/format.h"

namespace rasterproof::report {
namespace {

constexpr double kMostWrong = 0.01;
constexpr double kMostMoved = 1e-3;  // pixels

double Share(std::uint64_t count, std::uint64_t of) {
  return of == 0 ? 0 : static_cast<double>(count) / static_cast<double>(of);
}

double WrongShare(const BenchRow& row) {
  return Share(WrongBesideEdges(row, row.real), row.boundary_pairs);
}

ErrorLane ZeroLane(bool is_proved) { return is_proved ? ErrorLane::kProved : ErrorLane::kNone; }

RowError DisplacementOf(const BenchRow& row, ErrorLane zero) {
  if (row.real.Wrong() == 0) return {zero, 0};
  return {row.real.lost != 0 ? ErrorLane::kLost : ErrorLane::kRate, row.real.displacement};
}

RowError EdgeErrorOf(const BenchRow& row) {
  const double error = row.values.edge;
  if (std::isnan(error)) return {};
  return {error == 0 ? ErrorLane::kNone : ErrorLane::kRate, error};
}

std::vector<const BenchRow*> RivalsOf(const BenchResult& result, std::uint32_t family,
                                      std::string_view sink) {
  std::vector<const BenchRow*> rivals;
  for (const BenchRow& row : result.rows) {
    const bool is_here = row.family == family && result.methods[row.method].sink == sink;
    if (is_here && IsRival(result, row)) rivals.push_back(&row);
  }
  return rivals;
}

const BenchRow* Fastest(const std::vector<const BenchRow*>& rows) {
  return *std::ranges::min_element(
      rows, {}, [](const BenchRow* row) { return std::pair(row->ratio.median, row->method); });
}

}  // namespace

std::uint64_t WrongBesideEdges(const BenchRow& row, const BenchErrors& errors) {
  if (errors.Wrong() == 0) return 0;
  return std::clamp<std::uint64_t>(errors.beside_edges, 1,
                                   std::max<std::uint64_t>(1, row.boundary_pairs));
}

RowError ErrorOf(const BenchResult& result, const BenchRow& row, ErrorKind kind) {
  if (!row.is_judged) return {};
  const BenchFamily& family = result.families[row.family];
  const BenchMethod& method = result.methods[row.method];
  const bool is_inside = family.largest_coordinate <= method.coordinate_limit;
  const ErrorLane own_zero = ZeroLane(method.is_proved && is_inside);
  const ErrorLane real_zero = ZeroLane(method.is_proved && is_inside && method.model == "real");
  const auto share = [](std::uint64_t count, std::uint64_t of, ErrorLane zero) {
    return RowError{count == 0 ? zero : ErrorLane::kRate, Share(count, of)};
  };
  switch (kind) {
    case ErrorKind::kReal:
      return share(WrongBesideEdges(row, row.real), row.boundary_pairs, real_zero);
    case ErrorKind::kOwn:
      return share(WrongBesideEdges(row, row.own), row.boundary_pairs, own_zero);
    case ErrorKind::kDisplacement:
      return DisplacementOf(row, real_zero);
    case ErrorKind::kLeaks:
      if (family.shared_pairs == 0) return {};
      return share(row.leaks.Sum(), family.shared_pairs, own_zero);
    case ErrorKind::kEdge:
      return EdgeErrorOf(row);
  }
  return {};
}

std::string_view ErrorName(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kReal:
      return "share wrong, by real geometry";
    case ErrorKind::kOwn:
      return "share wrong, by the method's own model";
    case ErrorKind::kDisplacement:
      return "farthest wrong sample from the boundary";
    case ErrorKind::kLeaks:
      return "leaks along shared edges";
    case ErrorKind::kEdge:
      return "largest error of an edge's value";
  }
  return "";
}

bool IsInPixels(ErrorKind kind) {
  return kind == ErrorKind::kDisplacement || kind == ErrorKind::kEdge;
}

std::string RatioText(const BenchRow& row, int digits) {
  const Interval& ratio = row.ratio;
  if (!HasInterval(row))
    return fmt::format("{:.{}g} ({} round{})", ratio.median, digits, row.seconds.size(),
                       row.seconds.size() == 1 ? "" : "s");
  return fmt::format("{:.{}g} [{:.{}g}, {:.{}g}]", ratio.median, digits, ratio.low, digits,
                     ratio.high, digits);
}

bool IsBaselineAgain(const BenchResult& result, const BenchRow& row) {
  const BenchFamily& family = result.families[row.family];
  return row.method == family.twin && family.twin != family.baseline;
}

bool IsRival(const BenchResult& result, const BenchRow& row) {
  const BenchFamily& family = result.families[row.family];
  return row.is_judged && WrongShare(row) < kMostWrong &&
         family.largest_coordinate <= result.methods[row.method].coordinate_limit &&
         !IsBaselineAgain(result, row);
}

std::vector<const BenchRow*> Frontier(const BenchResult& result, std::uint32_t family,
                                      std::string_view sink, ErrorKind kind) {
  const auto error = [&](const BenchRow* row) {
    const RowError one = ErrorOf(result, *row, kind);
    return std::pair(one.lane, one.value);
  };
  std::vector<const BenchRow*> rivals = RivalsOf(result, family, sink);
  std::erase_if(rivals,
                [&](const BenchRow* row) { return error(row).first == ErrorLane::kNotJudged; });
  std::vector<const BenchRow*> frontier;
  for (const BenchRow* row : rivals) {
    const bool is_beaten = std::ranges::any_of(rivals, [&](const BenchRow* other) {
      return other->ratio.high < row->ratio.low && error(other) <= error(row);
    });
    const bool is_tied_and_worse = std::ranges::any_of(rivals, [&](const BenchRow* other) {
      return !AreApart(other->ratio, row->ratio) && error(other) < error(row);
    });
    if (!is_beaten && !is_tied_and_worse) frontier.push_back(row);
  }
  std::ranges::sort(frontier, {},
                    [](const BenchRow* row) { return std::pair(row->ratio.median, row->method); });
  return frontier;
}

std::string_view NeedName(Need need) {
  switch (need) {
    case Need::kProvedZero:
      return "proved 0";
    case Need::kZeroOfN:
      return "0 of N";
    case Need::kNoLeaks:
      return "leaks nothing";
    case Need::kMilliPixel:
      return "under 1/1000 px";
    case Need::kAnything:
      return "anything";
  }
  return "";
}

bool Meets(const BenchResult& result, const BenchRow& row, Need need) {
  if (!IsRival(result, row)) return false;
  switch (need) {
    case Need::kProvedZero:
      return ErrorOf(result, row, ErrorKind::kReal).lane == ErrorLane::kProved;
    case Need::kZeroOfN:
      return row.real.Wrong() == 0;
    case Need::kNoLeaks:
      return row.leaks.Sum() == 0;
    case Need::kMilliPixel:
      return row.real.lost == 0 && row.real.displacement < kMostMoved;
    case Need::kAnything:
      return true;
  }
  return false;
}

std::optional<Decision> Decide(const BenchResult& result, std::uint32_t family, Need need) {
  const std::vector<const BenchRow*> rivals = RivalsOf(result, family, kCommonSink);
  std::vector<const BenchRow*> good;
  std::ranges::copy_if(rivals, std::back_inserter(good),
                       [&](const BenchRow* row) { return Meets(result, *row, need); });
  if (good.empty()) return std::nullopt;
  const BenchRow* cheapest = Fastest(good);
  std::erase_if(good, [&](const BenchRow* row) { return AreApart(row->ratio, cheapest->ratio); });
  std::ranges::sort(good, {}, [&](const BenchRow* row) {
    const RowError error = ErrorOf(result, *row, ErrorKind::kReal);
    return std::tuple(error.lane, error.value, row->ratio.median, row->method);
  });
  const BenchRow* fastest = Fastest(rivals);
  Decision decision;
  decision.row = good.front();
  decision.tied.assign(good.begin() + 1, good.end());
  decision.ratio = decision.row->ratio.median / fastest->ratio.median;
  decision.is_tied_with_fastest = !AreApart(decision.row->ratio, fastest->ratio);
  return decision;
}

double NanosecondsATriangle(const BenchResult& result, const BenchRow& row) {
  const std::uint64_t triangles = result.families[row.family].triangles;
  return triangles == 0 ? 0 : 1e9 * row.time.median / static_cast<double>(triangles);
}

double MillisecondsAFrame(const BenchResult& result, const BenchRow& row, std::uint64_t pixels) {
  const std::uint64_t covered = result.families[row.family].covered;
  return covered == 0
             ? 0
             : 1e3 * row.time.median * static_cast<double>(pixels) / static_cast<double>(covered);
}

std::string FullName(const BenchMethod& method) {
  return method.target == "compiler" || method.target.empty() ? method.name
                                                              : method.name + " " + method.target;
}

}  // namespace rasterproof::report
