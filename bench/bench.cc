#include "bench/bench.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/errors.h"
#include "bench/paired.h"
#include "bench/values.h"
#include "core/clock.h"
#include "core/coverage.h"
#include "exact/coverage.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"
#include "reference/method.h"

namespace rasterproof::bench {
namespace {

namespace kernels = library::kernels;

// Shorter draws are repeated until they add up to this: clocks cost some tenths of a microsecond.
constexpr double kLeastSeconds = 1e-4;
constexpr int kMostDraws = 8;
constexpr std::string_view kAgain = " again";

// Measures the same method under another name.
class Twin final : public Contender {
 public:
  explicit Twin(std::unique_ptr<Contender> same) : same_(std::move(same)) {
    method_ = same_->method();
    method_.name += kAgain;
    method_.summary = "the baseline measured a second time: the floor of the noise";
    model_ = same_->model();
  }
  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    return same_->WhyNot(family);
  }
  void Load(const FamilyInput& family) override { same_->Load(family); }
  DrawTime Draw() override { return same_->Draw(); }
  DrawTime DrawForNothing() override { return same_->DrawForNothing(); }
  bool NeedsClearing() const override { return same_->NeedsClearing(); }
  bool MoveDrawn(CoverageCounts& to) override { return same_->MoveDrawn(to); }
  bool DrawsAlone() const override { return false; }
  void DrawAlone(std::size_t triangle, const PixelRect& area,
                 std::vector<std::uint8_t>& box) override {
    same_->DrawAlone(triangle, area, box);
  }
  std::uint64_t LeftBehind() override { return same_->LeftBehind(); }

 private:
  std::unique_ptr<Contender> same_;
};

// A contender on one family, and what is measured of it.
struct Run {
  Contender* contender = nullptr;
  std::uint32_t method = 0;
  int draws = 1;                                                 // of one measurement
  double seconds_each = 0;                                       // elapsed, of one measurement
  std::size_t rounds = std::numeric_limits<std::size_t>::max();  // that it takes part in
  std::string failure{};                                         // why it takes part no more
  std::vector<double> seconds{};
  std::vector<double> wall{};
};

// Draws once for nothing, unless that takes long, then measures.
void Measure(Run& run) {
  constexpr double kLong = 5e-3;
  const double begun = WallSeconds();
  const DrawTime first =
      run.seconds_each > kLong ? DrawTime{.seconds = kLong} : run.contender->DrawForNothing();
  if (run.seconds.empty()) {
    const double wanted = kLeastSeconds / std::max(first.seconds, 1e-9);
    run.draws = std::clamp(static_cast<int>(std::ceil(wanted)), 1, kMostDraws);
  }
  DrawTime sum;
  for (int draw = 0; draw < run.draws; ++draw) {
    const DrawTime time = run.contender->DrawTimed();
    sum.seconds += time.seconds;
    sum.wall_seconds += time.wall_seconds;
  }
  run.seconds.push_back(sum.seconds / run.draws);
  run.wall.push_back(sum.wall_seconds / run.draws);
  run.seconds_each = WallSeconds() - begun;
}

// A subject of the user's may break down over any draw.
void MeasureUnlessItFails(Run& run) {
  try {
    Measure(run);
  } catch (const std::exception& error) {
    if (!run.contender->method().is_users) throw;
    run.failure = error.what();
  }
}

// Whose measurements take more than `share` seconds in all does not take part beyond the least
// number of rounds; whose single one takes long, in as many as `seconds` leave time for.
std::size_t RoundsOf(const Run& run, double seconds, double share, std::size_t least) {
  constexpr double kSlow = 1;
  const auto rounds = [&](double of) {
    return static_cast<std::size_t>(std::clamp(of / run.seconds_each, 1.0, 1e6));
  };
  return run.seconds_each < kSlow ? std::max(least, rounds(share)) : rounds(seconds);
}

std::size_t MeasureInRounds(std::vector<Run>& runs, const BenchOptions& options, double seconds) {
  const double begun = WallSeconds();
  std::size_t rounds = 0;
  while (rounds < options.most_rounds) {
    const bool is_late = WallSeconds() - begun > seconds;
    if (rounds >= options.least_rounds && is_late) break;
    // A step that is coprime to most counts spreads few rounds over the whole design.
    for (const std::size_t k : RoundOrder(runs.size(), 7 * rounds)) {
      if (rounds < runs[k].rounds && runs[k].failure.empty()) MeasureUnlessItFails(runs[k]);
    }
    if (rounds++ > 0) continue;
    const double share = seconds / static_cast<double>(runs.size());
    for (Run& run : runs) run.rounds = RoundsOf(run, seconds, share, options.least_rounds);
  }
  return rounds;
}

// What exact geometry covers of the whole scene, once for each model.
class WholeScene {
 public:
  explicit WholeScene(const Scene& scene) : scene_(scene) {}
  // Of what the contender drew last; nothing of a sink that keeps no counts.
  std::optional<std::uint64_t> WrongSamples(Contender& contender) {
    if (!contender.MoveDrawn(drawn_)) return std::nullopt;
    const Profile& model = contender.model();
    for (const auto& [known, counts] : known_) {
      if (SameModel(known, model)) return Compare(drawn_, counts).wrong;
    }
    return Compare(drawn_, known_.emplace_back(model, exact::Coverage(scene_, model)).second).wrong;
  }

 private:
  const Scene& scene_;
  std::list<std::pair<Profile, CoverageCounts>> known_;
  CoverageCounts drawn_;
};

std::uint32_t IndexOf(const std::vector<Run>& runs, std::string_view name) {
  const auto found = std::ranges::find(
      runs, name, [](const Run& run) { return std::string_view(run.contender->method().name); });
  return found == runs.end() ? runs.front().method : found->method;
}

kernels::Sink SinkOf(const BenchMethod& method) {
  return *std::ranges::find(kernels::kSinks, method.sink,
                            [](kernels::Sink sink) { return NameOf(sink); });
}

// Its errors, and how far its whole drawing is off.
BenchRow JudgedRow(Run& run, const FamilyInput& family, WholeScene& whole, CoverageJudge& judge) {
  Contender& contender = *run.contender;
  BenchRow row;
  row.method = run.method;
  const double begun = WallSeconds();
  contender.Draw();
  run.seconds_each = WallSeconds() - begun;
  row.drawing_wrong = whole.WrongSamples(contender);
  if (contender.DrawsAlone()) {
    const Judgement& judgement = judge.Of(contender);
    row.real = judgement.real;
    row.own = judgement.own;
    row.leaks = judgement.leaks;
    row.is_judged = true;
    row.judged_triangles = judgement.judged_triangles;
    row.boundary_pairs = judgement.boundary_pairs;
  }
  row.values = ValuesOf(contender, family);
  return row;
}

void AddTimes(const Run& run, const Run& base, const BenchFamily& described, BenchRow& row) {
  row.seconds = run.seconds;
  row.time = MedianInterval(run.seconds);
  row.wall_median = MedianInterval(run.wall).median;
  row.ratio = RatioInterval(run.seconds, base.seconds);
  const double stored =
      StoreLimit(SinkOf(run.contender->method())) * static_cast<double>(described.covered);
  row.binds_at_store = row.time.median < 2 * stored;
}

enum class RivalChoice : std::uint8_t { kNone, kFew, kAll };

bool IsRivalAsked(const library::rivals::Rival& rival, RivalChoice choice) {
  if (rival == library::rivals::kTwin) return true;
  const std::string name = NameOf(rival);
  const bool is_among_few = name.starts_with("kernel-") || name == "spans-f64";
  return choice == RivalChoice::kAll || (choice == RivalChoice::kFew && is_among_few);
}

// All that draw by vectors, and their floor.
void AddKernels(kernels::Target target, kernels::Sink sink, RivalChoice choice,
                std::vector<std::unique_ptr<Contender>>& contenders) {
  contenders.push_back(MakeKernelContender(target, sink));
  for (const library::rivals::Rival& rival : library::rivals::kRivals) {
    if (!Draws(rival, target, sink) || !IsRivalAsked(rival, choice)) continue;
    contenders.push_back(MakeRivalContender(rival, target, sink));
  }
  contenders.push_back(MakeClipContender(target, sink));
  contenders.push_back(MakeDividedContender(target, sink));
  const library::rivals::Rival scanline{library::rivals::Traversal::kSpans,
                                        library::rivals::Arithmetic::kFloat32Direct};
  if (choice != RivalChoice::kNone && Draws(scanline, target, sink)) {
    contenders.push_back(MakeDividedContender(scanline, target, sink));
  }
  if (choice != RivalChoice::kNone && library::rivals::DrawsHomogeneous(target, sink)) {
    contenders.push_back(MakeHomogeneousContender(target, sink));
  }
  contenders.push_back(MakeFloorContender(target, sink));
}

}  // namespace

bool IsTwin(std::string_view name) { return name.ends_with(kAgain); }

bool IsBaseline(std::string_view name) {
  if (IsTwin(name)) name.remove_suffix(kAgain.size());
  return name == kBaseline || name == kClipBaseline;
}

std::vector<std::unique_ptr<Contender>> OwnContenders(ContenderChoice choice,
                                                      std::optional<kernels::Target> target) {
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const std::string_view name : {kBaseline, kClipBaseline}) {
    const reference::Method& method = *reference::FindMethod(name);
    contenders.push_back(MakeMethodContender(method));
    contenders.push_back(std::make_unique<Twin>(MakeMethodContender(method)));
  }
  for (const reference::Method& method : reference::Methods()) {
    if (method.name == kBaseline || method.name == kClipBaseline) continue;
    contenders.push_back(MakeMethodContender(method));
  }
  const bool is_full = choice == ContenderChoice::kFull;
  std::span<const kernels::Target> targets = kernels::SupportedTargets();
  if (target) {
    targets = std::span(&*target, 1);
  } else if (!is_full) {
    targets = targets.last(1);
  }
  for (const kernels::Target each : targets) {
    for (const kernels::Sink sink : kernels::kSinks) {
      const bool is_quick = sink == kernels::Sink::kFacing || sink == kernels::Sink::kMask;
      if (!is_full && !is_quick) continue;
      // Of rivals by kScalar no time is taken: they are compiled to be compared with.
      const bool is_timed = target || each != kernels::Target::kScalar;
      const RivalChoice rivals = !is_timed                         ? RivalChoice::kNone
                                 : choice == ContenderChoice::kFew ? RivalChoice::kFew
                                                                   : RivalChoice::kAll;
      AddKernels(each, sink, rivals, contenders);
    }
  }
  return contenders;
}

void RunFamily(const FamilyInput& family, std::span<const std::unique_ptr<Contender>> contenders,
               const BenchOptions& options, BenchResult& result) {
  const double begun = WallSeconds();
  const auto say = [&](const std::string& what) {
    if (options.progress) options.progress(family.name + ": " + what);
  };
  const auto at = static_cast<std::uint32_t>(result.families.size());
  for (std::size_t k = result.methods.size(); k < contenders.size(); ++k) {
    result.methods.push_back(contenders[k]->method());
  }
  say("samples");
  const JudgedTriangles judged(family.scene, options.judged_pixels);
  BenchFamily described = Describe(family, judged);
  say("errors");
  CoverageJudge judge(family, judged);
  WholeScene whole(family.scene);
  std::vector<Run> runs;
  std::vector<BenchRow> rows;
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    Run run{.contender = contenders[k].get(), .method = static_cast<std::uint32_t>(k)};
    if (auto why = run.contender->WhyNot(family)) {
      result.left_out.push_back({at, run.method, *why});
      continue;
    }
    try {
      run.contender->LimitTime(options.seconds_of_users);
      run.contender->Load(family);
      rows.push_back(JudgedRow(run, family, whole, judge));
      runs.push_back(std::move(run));
    } catch (const std::exception& error) {
      if (!run.contender->method().is_users) throw;
      result.left_out.push_back({at, run.method, error.what()});
    }
  }
  say("times");
  if (!runs.empty()) {
    described.rounds =
        MeasureInRounds(runs, options, options.seconds_per_family - (WallSeconds() - begun));
    const std::string_view baseline = family.scene.clip_space ? kClipBaseline : kBaseline;
    described.baseline = IndexOf(runs, baseline);
    described.twin = IndexOf(runs, std::string(baseline) + std::string(kAgain));
  }
  const auto base = std::ranges::find(runs, described.baseline, &Run::method);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    rows[k].conversion_seconds = runs[k].contender->conversion_seconds();
    if (!runs[k].failure.empty()) {
      result.left_out.push_back({at, runs[k].method, runs[k].failure});
      continue;
    }
    rows[k].family = at;
    AddTimes(runs[k], *base, described, rows[k]);
    result.rows.push_back(std::move(rows[k]));
  }
  result.families.push_back(std::move(described));
}

}  // namespace rasterproof::bench
