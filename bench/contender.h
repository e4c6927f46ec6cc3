// What a benchmark times: one way to draw, called as its user would call it.
#ifndef RASTERPROOF_BENCH_CONTENDER_H_
#define RASTERPROOF_BENCH_CONTENDER_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/family.h"
#include "core/bench_result.h"
#include "core/clock.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/evaluators.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"
#include "reference/method.h"

namespace rasterproof::bench {

struct Pixel {
  int x = 0;
  int y = 0;
};

/// What a method computes at a pixel's centre beside coverage. NaN: it shows none.
struct PixelValues {
  std::array<double, 3> barycentrics{kNoValue, kNoValue, kNoValue};  ///< entry i of vertex i
  double depth = kNoValue;

  static constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
};

/// One way to draw.
class Contender {
 public:
  virtual ~Contender() = default;

  const BenchMethod& method() const { return method_; }
  /// The model that it is held to.
  const Profile& model() const { return model_; }
  /// What it converts, besides its draws: seconds a triangle of the loaded family. NaN: nothing.
  double conversion_seconds() const { return conversion_seconds_; }
  /// Its edge values, if it shows them.
  const EdgeEvaluator* edges() const { return edges_; }

  /// Why it does not draw the family; nothing if it does.
  virtual std::optional<std::string> WhyNot(const FamilyInput& family) const = 0;
  /// Makes ready to draw the family. Not timed. The family outlives the draws.
  virtual void Load(const FamilyInput& family) = 0;
  /// The most seconds that all draws of a family may take. A user's whose draws take longer says so
  /// by a SubjectStop at Load().
  virtual void LimitTime(double /*seconds*/) {}
  /// Clears the target, not timed, then draws the family once, timed.
  ///
  /// Domain:     after Load().
  virtual DrawTime Draw() = 0;
  /// Draws onto what is there, to have everything at hand for the draw that counts: the target need
  /// not be cleared for that, which costs more than most draws.
  virtual DrawTime DrawForNothing() { return Draw(); }
  /// Whether a draw takes another time on what is there than on a cleared target.
  virtual bool NeedsClearing() const { return true; }
  /// A draw whose time counts.
  DrawTime DrawTimed() { return NeedsClearing() ? Draw() : DrawForNothing(); }
  /// Moves what the last Draw() drew into the counts; false of sinks that keep no counts by facing.
  virtual bool MoveDrawn(CoverageCounts& to) = 0;
  /// Whether triangles can be drawn alone, so that its decisions are judged one by one.
  virtual bool DrawsAlone() const { return true; }
  /// Whether drawing one takes so long that a part of the triangles is judged.
  virtual bool IsSlowAlone() const { return false; }
  /// Draws one triangle of the loaded family alone onto the cleared target; `box` becomes 1 where
  /// it is covered. The target is cleared again within the box.
  ///
  /// Shape:      row-major, area.x1 - area.x0 bytes a row.
  virtual void DrawAlone(std::size_t triangle, const PixelRect& area,
                         std::vector<std::uint8_t>& box) = 0;
  /// Which of these triangles of the loaded family cover the pixel, each drawn alone onto the
  /// cleared target: 1 or 0.
  ///
  /// Domain:     `target` is the whole of it.
  virtual std::vector<std::uint8_t> CoverAlone(std::span<const std::size_t> triangles,
                                               const PixelRect& target, Pixel at);
  /// The values that it shows of the triangle drawn alone, at the centres of these pixels, which it
  /// covers: as many, or none if it shows no values.
  virtual std::vector<PixelValues> ValuesAlone(std::size_t /*triangle*/,
                                               std::span<const Pixel> /*pixels*/) {
    return {};
  }
  /// How many samples are covered still, outside of the areas of all triangles drawn alone. They
  /// are cleared.
  virtual std::uint64_t LeftBehind() = 0;

 protected:
  BenchMethod method_;
  Profile model_;
  const EdgeEvaluator* edges_ = nullptr;
  double conversion_seconds_ = std::numeric_limits<double>::quiet_NaN();
};

/// A method of the table, into counts of either facing.
std::unique_ptr<Contender> MakeMethodContender(const reference::Method& method);

/// The exact kernel.
///
/// Domain:     a target of SupportedTargets().
std::unique_ptr<Contender> MakeKernelContender(library::kernels::Target target,
                                               library::kernels::Sink sink);

/// What kernels are measured against.
///
/// Domain:     Draws(rival, target, sink).
std::unique_ptr<Contender> MakeRivalContender(const library::rivals::Rival& rival,
                                              library::kernels::Target target,
                                              library::kernels::Sink sink);

/// The kernel of clip space.
///
/// Domain:     as MakeKernelContender.
std::unique_ptr<Contender> MakeClipContender(library::kernels::Target target,
                                             library::kernels::Sink sink);

/// The rival of clip space.
///
/// Domain:     DrawsHomogeneous(target, sink).
std::unique_ptr<Contender> MakeHomogeneousContender(library::kernels::Target target,
                                                    library::kernels::Sink sink);

/// The exact kernel, or a rival, after a division by w in float32, done again in each draw.
///
/// Domain:     as MakeKernelContender.
std::unique_ptr<Contender> MakeDividedContender(library::kernels::Target target,
                                                library::kernels::Sink sink);
std::unique_ptr<Contender> MakeDividedContender(const library::rivals::Rival& rival,
                                                library::kernels::Target target,
                                                library::kernels::Sink sink);

/// The spans of the exact kernel, or of that of clip space, found before and only written: what any
/// method pays for the sink.
///
/// Domain:     as MakeKernelContender.
inline constexpr std::string_view kFloor = "spans-known";
std::unique_ptr<Contender> MakeFloorContender(library::kernels::Target target,
                                              library::kernels::Sink sink);

/// A user's subject in this process, into what it shows. Its time is that of a draw less that of a
/// draw of the same vertices without triangles, the conversion, which is reported separately.
///
/// A crash in this process would end it. So `first`, a copy in another process, draws each family
/// before; with nullptr nothing is drawn before.
///
/// Domain:     one sample a pixel, in its centre; the subjects outlive the contender. A subject in
///             another process has a limit of its own, `most_seconds`, for a draw.
/// Error:      of Load(): what `first` throws.
std::unique_ptr<Contender> MakeSubjectContender(Subject& subject, std::string march = "",
                                                Subject* first = nullptr, double most_seconds = 10);

/// A user's subject in another process. Its time is the slope of the processor time of all its
/// threads over k, 2 k and 4 k draws: of repeats in one request, so that starting, reading and
/// answering drop out; of one that takes no repeats, over requests in one call. The name is the
/// subject's own unless one is given.
///
/// Domain:     as MakeSubjectContender.
/// Error:      of its calls: what the subject throws, where it breaks down over a family.
std::unique_ptr<Contender> MakeProgramContender(Subject& subject, double most_seconds = 10,
                                                std::string name = "");

/// Seconds that storing one pixel takes at least, by the widest vectors. Measured when first asked
/// for.
double StoreLimit(library::kernels::Sink sink);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CONTENDER_H_
