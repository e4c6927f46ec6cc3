#include "report/claims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "report/bench_decision.h"

namespace rasterproof::report {
namespace {

constexpr std::string_view kKnownSpans = "known spans";

constexpr ClaimSide Spans(std::string_view arithmetic) { return {"spans", arithmetic}; }
constexpr ClaimSide Tiles(std::string_view arithmetic) { return {"tiles", arithmetic}; }
constexpr ClaimSide By(std::string_view vectors) { return {"spans", "exact", vectors}; }
constexpr ClaimSide InClipSpace(std::string_view arithmetic, std::string_view sink = "mask") {
  return {"spans", arithmetic, kWidest, sink, "clip", 16};
}
// A loop has no sink but counts by facing, and reads vertices of four doubles.
constexpr ClaimSide Loop(std::string_view arithmetic, std::string_view space = "window") {
  return {"box loop", arithmetic, "compiler", "facing", space, 32};
}
constexpr ClaimSide kExactCounts{"spans", "exact", kWidest, "facing"};

constexpr std::array kClaims{
    Claim{"exactness", "What makes it exact", Spans("exact"), Spans("exact, unchecked"),
          Trait::kArithmetic},
    Claim{"doubles", "Use doubles", Spans("f64"), Spans("exact"), Trait::kArithmetic},
    Claim{"doubles-affine", "Doubles as A x + B y + C", Spans("f64-affine"), Spans("exact"),
          Trait::kArithmetic},
    Claim{"floats", "Float32 is good enough", Spans("f32"), Spans("exact"), Trait::kArithmetic},
    Claim{"stepping", "From the first row by multiples of the step", Spans("f32-stepped"),
          Spans("f32"), Trait::kArithmetic},
    Claim{"stepping-tiles", "From the first pixel by multiples of the step, in tiles",
          Tiles("f32-stepped"), Tiles("f32"), Trait::kArithmetic},
    Claim{"affine", "A x + B y + C is the same", Spans("f32-affine"), Spans("f32"),
          Trait::kArithmetic},
    Claim{"affine-tiles", "A x + B y + C is the same, in tiles", Tiles("f32-affine"), Tiles("f32"),
          Trait::kArithmetic},
    Claim{"integers", "Snap, and use integers of 32 bits", Tiles("i32"), Tiles("f32-stepped"),
          Trait::kArithmetic},
    Claim{"wide-integers", "Snap, and use integers of 64 bits", Spans("i64"), Spans("exact"),
          Trait::kArithmetic},
    Claim{"tiles", "Tiles beside spans", Tiles("f32"), Spans("f32"), Trait::kTraversal},
    Claim{"tiles-doubles", "Tiles beside spans, of doubles", Tiles("f64"), Spans("f64"),
          Trait::kTraversal},
    Claim{"rows",
          "Row by row beside tiles",
          {"rows", "f32-stepped"},
          Tiles("f32-stepped"),
          Trait::kTraversal},
    Claim{"full-tiles",
          "Tiles that know when they are full",
          {"mask-tiles", "f32"},
          Spans("f32"),
          Trait::kTraversal},
    Claim{"vectors", "Half as wide vectors", By("avx2"), By("avx512"), Trait::kVectors},
    Claim{"divided", "Divide by w first", InClipSpace("f32-divided, then exact"),
          InClipSpace("exact"), Trait::kArithmetic},
    Claim{"divided-floats", "Divide by w, then float32", InClipSpace("f32-divided, then f32"),
          InClipSpace("exact"), Trait::kArithmetic},
    Claim{"homogeneous", "Homogeneous float32", InClipSpace("f32-homogeneous"),
          InClipSpace("exact"), Trait::kArithmetic},
    Claim{"textbook-doubles",
          "Doubles as a scalar textbook loop, not a kernel",
          Loop("f64-direct"),
          kExactCounts,
          {}},
    Claim{"textbook-floats",
          "Float32 as a scalar textbook loop, not a kernel",
          Loop("f32-direct"),
          kExactCounts,
          {}},
    Claim{"textbook-stepping",
          "Steps of float32 as a scalar textbook loop, not a kernel",
          Loop("f32-incremental"),
          kExactCounts,
          {}},
    Claim{"textbook-clip",
          "Homogeneous doubles as a scalar textbook loop, not a kernel",
          Loop("hom-f64", "clip"),
          InClipSpace("exact", "facing"),
          {}},
};

std::string TraitOf(const ClaimSide& side, Trait trait) {
  switch (trait) {
    case Trait::kTraversal:
      return std::string(side.traversal);
    case Trait::kArithmetic:
      return std::string(side.arithmetic);
    case Trait::kVectors:
      return std::string(side.vectors);
    case Trait::kSink:
      return std::string(side.sink);
    case Trait::kSpace:
      return std::string(side.space);
    case Trait::kVertexBytes:
      break;
  }
  return std::to_string(side.vertex_bytes);
}

// The widest instruction set by which a kernel of the run draws families; that of curves may be
// another.
std::string_view WidestOf(const BenchResult& result) {
  constexpr std::array<std::string_view, 5> kOrder{"scalar", "neon", "sse4", "avx2", "avx512"};
  std::size_t widest = 0;
  for (const BenchRow& row : result.rows) {
    const auto found = std::ranges::find(kOrder, result.methods[row.method].target);
    if (found == kOrder.end()) continue;
    widest = std::max(widest, static_cast<std::size_t>(found - kOrder.begin()));
  }
  return kOrder[widest];
}

bool IsOf(const ClaimSide& side, std::string_view widest, const BenchMethod& method) {
  const std::string_view vectors = side.vectors == kWidest ? widest : side.vectors;
  return method.traversal == side.traversal && method.arithmetic == side.arithmetic &&
         method.target == vectors && method.sink == side.sink && method.space == side.space &&
         method.vertex_bytes == side.vertex_bytes && !method.is_users;
}

const BenchRow* ClaimRow(const BenchResult& result, std::uint32_t family, const ClaimSide& side,
                         std::string_view widest) {
  const auto found = std::ranges::find_if(result.rows, [&](const BenchRow& row) {
    return row.family == family && !IsBaselineAgain(result, row) &&
           IsOf(side, widest, result.methods[row.method]);
  });
  return found == result.rows.end() ? nullptr : &*found;
}

// Seconds of each round less the floor's; all of them without a floor.
std::vector<double> LessFloor(const BenchRow& row, const BenchRow* floor) {
  std::vector<double> seconds = row.seconds;
  if (floor == nullptr) return seconds;
  seconds.resize(std::min(seconds.size(), floor->seconds.size()));
  for (std::size_t k = 0; k < seconds.size(); ++k) seconds[k] -= floor->seconds[k];
  return seconds;
}

// Nothing where a side is not above the floor: a quotient would say what noise says.
std::optional<Interval> Quotient(std::vector<double> a, std::vector<double> b) {
  a.resize(std::min(a.size(), b.size()));
  b.resize(a.size());
  if (a.empty() || MedianInterval(a).low <= 0 || MedianInterval(b).low <= 0) return std::nullopt;
  for (std::size_t k = 0; k < a.size(); ++k) {
    // A single round at the floor: as far off as any, on the side on which it lies.
    a[k] = b[k] > 0 ? a[k] / b[k] : std::numeric_limits<double>::infinity();
  }
  return MedianInterval(std::move(a));
}

std::optional<ClaimCell> CellOf(const Claim& claim, const BenchResult& result, std::uint32_t family,
                                std::string_view widest) {
  const BenchRow* a = ClaimRow(result, family, claim.a, widest);
  const BenchRow* b = ClaimRow(result, family, claim.b, widest);
  if (a == nullptr || b == nullptr) return std::nullopt;
  if (!claim.differs) return ClaimCell{family, Quotient(a->seconds, b->seconds)};
  const BenchRow* of_a = FloorOf(result, *a);
  const BenchRow* of_b = FloorOf(result, *b);
  if (of_a == nullptr || of_b == nullptr) return std::nullopt;
  return ClaimCell{family, Quotient(LessFloor(*a, of_a), LessFloor(*b, of_b))};
}

std::string RangeText(const BenchResult& result, const std::vector<ClaimCell>& cells) {
  std::vector<const ClaimCell*> told;
  for (const ClaimCell& cell : cells) {
    if (cell.ratio) told.push_back(&cell);
  }
  if (told.empty()) return {};
  const auto median = [](const ClaimCell* cell) { return cell->ratio->median; };
  const auto [least, most] = std::ranges::minmax_element(told, {}, median);
  const auto text = [&](const ClaimCell& cell) {
    return fmt::format("{:.3g} [{:.3g}, {:.3g}] (`{}`)", cell.ratio->median, cell.ratio->low,
                       cell.ratio->high, result.families[cell.family].name);
  };
  return least == most ? text(**least) : text(**least) + " to " + text(**most);
}

// "wrong in 17 of 18 families, by up to 0.07 pixel"
std::string FamiliesWrong(const BenchResult& result, const std::vector<ClaimCell>& cells,
                          const ClaimSide& side, std::string_view widest) {
  std::size_t wrong = 0;
  std::size_t judged = 0;
  double farthest = 0;
  bool is_proved = true;
  for (const ClaimCell& cell : cells) {
    const BenchRow& row = *ClaimRow(result, cell.family, side, widest);
    if (!row.is_judged) continue;
    ++judged;
    wrong += row.real.Wrong() != 0 ? 1U : 0U;
    farthest = std::max(farthest, row.real.displacement);
    is_proved &= ErrorOf(result, row, ErrorKind::kReal).lane == ErrorLane::kProved;
  }
  if (judged == 0) return "not judged";
  if (wrong == 0) return is_proved ? "never wrong, by proof" : "never seen wrong";
  return fmt::format("wrong in {} of {} families, by up to {:.2g} pixel", wrong, judged, farthest);
}

void Tell(const Claim& claim, const BenchResult& result, std::string_view widest,
          ClaimFigure& figure) {
  figure.sentence = fmt::format("{}: ", claim.about);
  if (figure.cells.empty()) {
    figure.times = "not measured";
    figure.sentence += figure.times + ".";
    return;
  }
  figure.times = RangeText(result, figure.cells);
  const auto overlaps = std::ranges::count_if(figure.cells, &ClaimCell::Overlaps);
  const auto at_floor =
      std::ranges::count_if(figure.cells, [](const ClaimCell& cell) { return !cell.ratio; });
  std::vector<std::string> parts{
      figure.times.empty()
          ? fmt::format("`{}` beside `{}`", figure.a, figure.b)
          : fmt::format("`{}` takes {} times as long as `{}`", figure.a, figure.times, figure.b)};
  if (overlaps != 0) {
    parts.push_back(fmt::format("overlap in {} of {} families", overlaps, figure.cells.size()));
  }
  if (at_floor != 0) {
    parts.push_back(fmt::format("at the floor in {} of {}", at_floor, figure.cells.size()));
  }
  if (figure.times.empty()) figure.times = "at the floor";
  figure.a_wrong = FamiliesWrong(result, figure.cells, claim.a, widest);
  figure.b_wrong = FamiliesWrong(result, figure.cells, claim.b, widest);
  figure.sentence +=
      fmt::format("{}; they differ in {}. `{}` was {}, `{}` {}.", fmt::join(parts, "; "),
                  DifferenceText(claim), figure.a, figure.a_wrong, figure.b, figure.b_wrong);
}

}  // namespace

std::string_view TraitName(Trait trait) {
  constexpr std::array<std::string_view, kTraits.size()> kNames{
      "traversal", "arithmetic", "vectors", "sink", "space", "bytes of a vertex"};
  return kNames[static_cast<std::size_t>(trait)];
}

std::span<const Claim> Claims() { return kClaims; }

std::vector<Trait> Differences(const Claim& claim) {
  std::vector<Trait> differences;
  for (const Trait trait : kTraits) {
    if (TraitOf(claim.a, trait) != TraitOf(claim.b, trait)) differences.push_back(trait);
  }
  return differences;
}

std::string FaultOf(const Claim& claim) {
  const std::vector<Trait> differences = Differences(claim);
  if (!claim.differs) {
    if (differences.size() < 2) return "its methods differ in one thing or none, and it names none";
    return claim.about.find(kTextbook) == claim.about.npos
               ? "several things differ, and it does not say so: " + std::string(kTextbook)
               : "";
  }
  if (differences.empty()) return "its methods do not differ";
  if (differences.size() > 1) {
    return fmt::format("its methods differ in {} things", differences.size());
  }
  if (differences.front() != *claim.differs) return "its methods differ in another thing";
  if (claim.differs == Trait::kArithmetic && claim.a.sink != "mask") {
    return "arithmetic is compared in the mask sink: in others stores hide it";
  }
  return "";
}

ClaimFigure FigureOf(const Claim& claim, const BenchResult& result) {
  ClaimFigure figure;
  const std::string_view widest = WidestOf(result);
  for (std::uint32_t family = 0; family < result.families.size(); ++family) {
    const bool is_asked =
        claim.families.empty() ||
        std::ranges::find(claim.families, result.families[family].name) != claim.families.end();
    if (!is_asked) continue;
    const auto cell = CellOf(claim, result, family, widest);
    if (!cell) continue;
    figure.cells.push_back(*cell);
    figure.a = FullName(result.methods[ClaimRow(result, family, claim.a, widest)->method]);
    figure.b = FullName(result.methods[ClaimRow(result, family, claim.b, widest)->method]);
  }
  Tell(claim, result, widest, figure);
  return figure;
}

std::string DifferenceText(const Claim& claim) {
  std::vector<std::string_view> names;
  for (const Trait trait : Differences(claim)) names.push_back(TraitName(trait));
  return fmt::format("{}{}", fmt::join(names, ", "), claim.differs ? "" : ": not like for like");
}

const BenchRow* FloorOf(const BenchResult& result, const BenchRow& row) {
  const BenchMethod& of = result.methods[row.method];
  const auto found = std::ranges::find_if(result.rows, [&](const BenchRow& one) {
    const BenchMethod& method = result.methods[one.method];
    return one.family == row.family && method.traversal == kKnownSpans && method.sink == of.sink &&
           method.target == of.target;
  });
  return found == result.rows.end() ? nullptr : &*found;
}

double NanosecondsLessFloor(const BenchResult& result, const BenchRow& row) {
  const BenchRow* const floor = FloorOf(result, row);
  if (floor == nullptr) return std::numeric_limits<double>::quiet_NaN();
  return NanosecondsATriangle(result, row) - NanosecondsATriangle(result, *floor);
}

}  // namespace rasterproof::report
