// Meshes as engines place them: through cameras and viewports in floating point, frame after frame.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"
#include "props/domains/planar_mesh.h"

namespace rasterproof::props {
namespace engines {

using Place3 = std::array<double, 3>;
using Row = std::array<double, 4>;

Row Sum(double s, const Row& a, double t, const Row& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2], s * a[3] + t * b[3]};
}

// A camera anywhere in a world, and the matrix by which a vertex shader in the scene's precision
// multiplies.
class Camera {
 public:
  explicit Camera(CaseBuilder& builder)
      : builder_(builder), is_orthographic_(builder.bits().Chance(48)) {
    TurnAndMove();
    DrawFrustum();
    const Row& w = is_orthographic_ ? kOne : axes_[2];
    const std::array<Row, 4> exact{Sum(focal_.x, axes_[0], shift_.x, w),
                                   Sum(focal_.y, axes_[1], shift_.y, w), DrawDepthRow(), w};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) matrix_[i][j] = Rounded(exact[i][j]);
    }
  }

  // How far apart in the world two places at that depth are that a pixel is between.
  double PixelAt(double depth) const {
    return 2 * (is_orthographic_ ? 1 : depth) / (focal_.y * builder_.height());
  }
  // The place of the world that is seen there at that depth.
  Place3 Seen(Point2 at, double depth) const {
    const double w = is_orthographic_ ? 1 : depth;
    const double right = w * (2 * at.x / builder_.width() - 1 - shift_.x) / focal_.x;
    const double up = w * (1 - 2 * at.y / builder_.height() - shift_.y) / focal_.y;
    Place3 place{};
    for (std::size_t i = 0; i < 3; ++i) {
      place[i] = eye_[i] + right * axes_[0][i] + up * axes_[1][i] + depth * axes_[2][i];
    }
    return place;
  }
  // The vertex shader, then the viewport without its division.
  void Add(const Place3& place) {
    std::array<double, 4> clip{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Row& m = matrix_[i];
      double sum = Rounded(m[0] * place[0]);
      sum = Rounded(sum + Rounded(m[1] * place[1]));
      sum = Rounded(sum + Rounded(m[2] * place[2]));
      clip[i] = Rounded(sum + m[3]);
    }
    const double half_width = builder_.width() / 2.0;
    const double half_height = builder_.height() / 2.0;
    builder_.AddRaw({Rounded(clip[0] * half_width) + Rounded(clip[3] * half_width),
                     Rounded(clip[3] * half_height) - Rounded(clip[1] * half_height), clip[2],
                     clip[3]});
  }
  double Rounded(double x) const { return builder_.lattice().RoundToFloat(x); }

 private:
  static constexpr Row kOne{0, 0, 0, 1};

  // Half of the eyes are at the origin, as where an engine draws relative to the camera.
  void TurnAndMove() {
    const double yaw = builder_.Uniform(-1, 1);
    const double pitch = builder_.Uniform(-0.45, 0.45);
    const Place3 forward{CosPi(pitch) * SinPi(yaw), SinPi(pitch), -CosPi(pitch) * CosPi(yaw)};
    const Place3 right{CosPi(yaw), 0, SinPi(yaw)};
    const Place3 up{-SinPi(pitch) * SinPi(yaw), CosPi(pitch), SinPi(pitch) * CosPi(yaw)};
    if (builder_.bits().Chance(128)) {
      for (double& x : eye_) x = Rounded(builder_.LogUniform(-2, 10));
    }
    axes_ = {FromEye(right), FromEye(up), FromEye(forward)};
  }
  Row FromEye(const Place3& axis) const {
    const double moved = axis[0] * eye_[0] + axis[1] * eye_[1] + axis[2] * eye_[2];
    return {axis[0], axis[1], axis[2], -moved};
  }
  // A cascade of shadows takes in 2 to 2^17 units; a field of view is of 20 to 179 degrees.
  void DrawFrustum() {
    const double degrees =
        builder_.bits().Chance(64) ? builder_.Uniform(120, 179) : builder_.Uniform(20, 110);
    const double scale = std::fabs(builder_.LogUniform(-16, 0));
    const double focal = is_orthographic_ ? scale : CosPi(degrees / 360) / SinPi(degrees / 360);
    focal_ = {focal * builder_.height() / builder_.width(), focal};
    const std::int64_t kind = builder_.bits().Int(0, 2);
    if (kind == 1) {  // jitter within a pixel, sixteenths as most sequences have them
      const auto sixteenths = static_cast<double>(builder_.bits().Int(-8, 8));
      shift_ = {sixteenths / 8 / builder_.width(),
                static_cast<double>(builder_.bits().Int(-8, 8)) / 8 / builder_.height()};
    } else if (kind == 2) {  // one of two eyes, whose frustums meet at a distance
      const double apart = builder_.Sign() * 0.032;
      for (std::size_t i = 0; i < 3; ++i) eye_[i] += apart * axes_[0][i];
      axes_[0][3] -= apart;
      shift_.x = focal_.x * apart / builder_.Uniform(0.5, 8);
    }
  }
  // Depth reversed, reversed with no far plane, up to an oblique near plane, or plain.
  Row DrawDepthRow() {
    const double nearest = std::fabs(builder_.LogUniform(-10, 0));
    const double farthest = nearest * std::fabs(builder_.LogUniform(4, 16));
    const double scale = 1 / (farthest - nearest);
    const std::int64_t kind = builder_.bits().Int(0, 3);
    if (kind == 0) return Sum(-nearest * scale, axes_[2], nearest * farthest * scale, kOne);
    if (kind == 1) return Sum(0, axes_[2], nearest, kOne);
    if (kind == 2) {
      const double tilt = builder_.Uniform(-2, 2);
      return Sum(1, Sum(tilt, axes_[1], scale, axes_[2]), -nearest, kOne);
    }
    return Sum(farthest * scale, axes_[2], -nearest * farthest * scale, kOne);
  }

  CaseBuilder& builder_;
  bool is_orthographic_;
  Place3 eye_{};
  std::array<Row, 3> axes_{};  // right, up, forward: what each makes of a place of the world
  Point2 focal_;
  Point2 shift_;
  std::array<Row, 4> matrix_{};
};

constexpr std::array<double, 7> kScales{1.25, 1.5, 1.0 / 1080, 1.0 / 720, 1.1, 4.0 / 3, 2.0 / 3};

// A float viewport transform along one axis.
struct Viewport {
  double scale = 1;
  double offset = 0;

  double Window(const CaseBuilder& builder, double x) const {
    const InputLattice& lattice = builder.lattice();
    return lattice.RoundToFloat(lattice.RoundToFloat(x * scale) + offset);
  }
};

// Rows of quads around the origin, in the coordinates of a source: multiples of 2^-bits. A quad is
// at least 2 pixels wide.
struct Source {
  int columns = 1;
  int rows = 1;
  int first_column = 0;
  int first_row = 0;
  double spacing = 1;
  int bits = 0;
};

Source DrawSource(CaseBuilder& builder, double scale, bool is_normalized) {
  BitSource& bits = builder.bits();
  Source source{.columns = static_cast<int>(bits.Int(1, 6)),
                .rows = static_cast<int>(bits.Int(1, 6))};
  source.first_column = static_cast<int>(-bits.Int(0, source.columns));
  source.first_row = static_cast<int>(-bits.Int(0, source.rows));
  source.bits = is_normalized ? 12 : static_cast<int>(bits.Int(0, 2));
  source.spacing = OnGrid(static_cast<double>(bits.Int(4, 24)) / (2 * scale), source.bits);
  return source;
}

PlanarMesh MakeSource(CaseBuilder& builder, const Source& source, double jitter) {
  PlanarMesh mesh;
  const auto place = [&](int k) {
    const double moved = jitter * builder.Uniform(-1, 1);
    return OnGrid((k + moved) * source.spacing, source.bits);
  };
  for (int j = 0; j <= source.rows; ++j) {
    for (int i = 0; i <= source.columns; ++i) {
      const double x = place(source.first_column + i);
      mesh.AddVertex({x, place(source.first_row + j)});
    }
  }
  mesh.AddCells(builder.bits(), source.columns, source.rows);
  return mesh;
}

// A place on an edge of the mesh, an end of it included.
Point2 DrawOnEdge(CaseBuilder& builder, const PlanarMesh& mesh) {
  BitSource& bits = builder.bits();
  const Triangle& t = bits.OneOf(std::span<const Triangle>(mesh.triangles));
  const Point2 a = mesh.vertices[static_cast<std::size_t>(t[0])];
  const Point2 b = mesh.vertices[static_cast<std::size_t>(t[1])];
  const double along =
      bits.Chance(128) ? builder.Uniform(0, 1) : static_cast<double>(bits.Int(0, 15)) / 16;
  return {a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
}

Point2 Turn(double half_turns) { return {CosPi(half_turns), SinPi(half_turns)}; }

constexpr int kFrameSide = 12;   // of a frame's part of the target
constexpr int kFrameMiddle = 5;  // the pixel that the hub is in

// A hub and its rim, from the hub. No wedge reaches half a turn, and a frame holds it wherever a
// sweep moves it.
std::vector<Point2> DrawFan(CaseBuilder& builder) {
  const auto rim = static_cast<std::int32_t>(builder.bits().Int(4, 7));
  const bool on_half_pixels = builder.bits().Chance(128);
  std::vector<Point2> fan{{0, 0}};
  for (std::int32_t k = 0; k < rim; ++k) {
    const double turn = 2 * (k + builder.Uniform(0, 0.4)) / rim;
    const double radius = builder.Uniform(2.5, 4.5);
    const Point2 toward = Turn(turn);
    const Point2 p{radius * toward.x, radius * toward.y};
    fan.push_back(on_half_pixels ? Point2{OnGrid(p.x, 1), OnGrid(p.y, 1)} : p);
  }
  return fan;
}

}  // namespace engines

static Case Cameras(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  engines::Camera camera(builder);
  // A grid on a plane of the world, as large as it likes on the target: it may pass the eye.
  const double depth = std::fabs(builder.LogUniform(-1, 8));
  const double pixels = std::fabs(builder.LogUniform(0, 5));
  double cell = pixels * camera.PixelAt(depth);
  if (bits.Chance(128)) cell = std::ldexp(1.0, std::ilogb(cell));
  // It is modelled on multiples of its cells, or lies so that a sample is on an edge.
  const bool is_modelled = bits.Chance(64);
  const engines::Place3 middle = camera.Seen(builder.Sample(), depth);
  const auto across = static_cast<std::size_t>(bits.Int(0, 2));  // the axis that it stands on
  const auto columns = static_cast<int>(bits.Int(1, 6));
  const auto rows = static_cast<int>(bits.Int(1, 6));
  const auto along = static_cast<double>(bits.Int(0, 15)) / 16;
  const std::int64_t edge = bits.Int(0, 3);  // a row's, a column's, or one of two diagonals
  const double column = static_cast<double>(bits.Int(0, columns - 1)) + (edge == 1 ? 0 : along);
  const double row = static_cast<double>(bits.Int(0, rows - 1)) + (edge == 0   ? 0
                                                                   : edge == 3 ? 1 - along
                                                                               : along);
  PlanarMesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      engines::Place3 place = middle;
      place[(across + 1) % 3] += (i - column) * cell;
      place[(across + 2) % 3] += (j - row) * cell;
      for (double& x : place) {
        x = camera.Rounded(is_modelled ? cell * std::nearbyint(x / cell) : x);
      }
      camera.Add(place);
    }
  }
  mesh.AddCells(bits, columns, rows);
  for (const Triangle& t : mesh.triangles) builder.AddTriangle(t[0], t[1], t[2]);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kCamerasDomain{
    .number = 102,
    .bits = 0xc1eeda5302d3ae3a,
    .listed = 791,
    .name = "cameras",
    .summary = "grids seen by cameras: float matrices, any depth range, 20 to 179 degrees",
    .theme = DomainTheme::kClip,
    .clip = true,
    .mesh = true,
    .draw = Cameras};

static Case ScaledViewports(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  // Beside the scales of user interfaces, half of an odd size, for normalized coordinates.
  const Point2 half{(builder.width() | 1) / 2.0, (builder.height() | 1) / 2.0};
  const bool is_normalized = bits.Chance(48);
  const double drawn = bits.OneOf(std::span<const double>(engines::kScales));
  const double scale = builder.lattice().RoundToFloat(is_normalized ? half.x : drawn);
  const engines::Source source = engines::DrawSource(builder, scale, is_normalized);
  PlanarMesh mesh = engines::MakeSource(builder, source, bits.Chance(128) ? 0.2 : 0);
  // The target's middle; or what puts a sample on an edge, but for what the floats round.
  Point2 offset = half;
  if (bits.Chance(192)) {
    const Point2 sample = builder.Sample();
    const Point2 on_edge = engines::DrawOnEdge(builder, mesh);
    offset = {sample.x - scale * on_edge.x, sample.y - scale * on_edge.y};
  }
  const engines::Viewport along_x{scale, builder.lattice().RoundToFloat(offset.x)};
  const engines::Viewport along_y{scale, builder.lattice().RoundToFloat(offset.y)};
  const auto through = [&](PlanarMesh shown) {
    for (Point2& p : shown.vertices) {
      p = {along_x.Window(builder, p.x), along_y.Window(builder, p.y)};
    }
    return shown;
  };
  PlanarMesh snapped = through(mesh);
  for (Point2& p : snapped.vertices) p = OnLattice(builder, p);
  // Without jitter a column stays a column, and no rounding puts one past the next.
  if (!snapped.IsFacingOneWay()) mesh = engines::MakeSource(builder, source, 0);
  for (const Point2 p : through(mesh).vertices) builder.AddRaw({p.x, p.y});
  for (const Triangle& t : mesh.triangles) builder.AddTriangle(t[0], t[1], t[2]);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kScaledViewportsDomain{
    .number = 81,
    .bits = 0x5ecbd54bc8e28841,
    .name = "scaled-viewports",
    .summary = "grids scaled by 1.25, 1.5, 1/1080 or half an odd size, and moved, in floats",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .mesh = true,
    .draw = ScaledViewports};

static Case FrameSweeps(BitSource& bits, const SubjectInfo& info) {
  const auto frames = static_cast<int>(bits.Int(4, 12));
  CaseBuilder builder(bits, info, frames * engines::kFrameSide, engines::kFrameSide);
  const auto sample = static_cast<int>(bits.Int(0, builder.profile().pattern.samples() - 1));
  const std::vector<Point2> fan = engines::DrawFan(builder);
  const auto rim = static_cast<std::int32_t>(fan.size()) - 1;
  const std::int64_t kind = bits.Int(0, 2);
  auto dx = bits.Int(-2, 2);
  const auto dy = bits.Int(-2, 2);
  if (dx == 0 && dy == 0) dx = 1;
  const double sign = builder.Sign();
  const double half_turns = std::ldexp(sign, -static_cast<int>(bits.Int(9, 24)));
  const auto still = static_cast<int>(bits.Int(0, frames - 1));  // its hub is on a sample
  PlanarMesh mesh;
  for (int frame = 0; frame < frames; ++frame) {
    const int t = frame - still;
    const Point2 hub = builder.profile().pattern.At(
        frame * engines::kFrameSide + engines::kFrameMiddle, engines::kFrameMiddle, sample);
    const auto [c, s] = kind == 0 ? engines::Turn(t * half_turns) : Point2{1, 0};
    const double pixels = kind == 1 ? t / 256.0 : 0;
    const std::int32_t first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Point2 p : fan) {
      Point2 at =
          OnLattice(builder, {hub.x + c * p.x - s * p.y + pixels * static_cast<double>(dx),
                              hub.y + s * p.x + c * p.y + pixels * static_cast<double>(dy)});
      if (kind == 2) {
        at = {builder.lattice().Move(at.x, t * dx), builder.lattice().Move(at.y, t * dy)};
      }
      mesh.AddVertex(OnLattice(builder, at));
    }
    for (std::int32_t k = 0; k < rim; ++k) {
      mesh.triangles.push_back({first, first + 1 + k, first + 1 + (k + 1) % rim});
    }
  }
  // A coarse lattice or an end of the range has folded a frame.
  if (!mesh.IsFacingOneWay()) mesh.triangles.resize(1);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kFrameSweepsDomain{
    .number = 103,
    .bits = 0x9aad71cdd65589ab,
    .listed = 841,
    .name = "frame-sweeps",
    .summary = "a fan frame after frame: 1/256 pixel on, a lattice step on, turned a little",
    .theme = DomainTheme::kMeshes,
    .in_theme = 791,
    .near_edge = true,
    .mesh = true,
    .draw = FrameSweeps};

}  // namespace rasterproof::props
