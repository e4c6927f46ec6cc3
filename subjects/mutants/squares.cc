#include "subjects/mutants/squares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "library/exact_sign.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

using Corners4 = std::array<Point2, 4>;

class Squares final : public Subject {
 public:
  Squares(const std::string& name, const std::string& summary, SquareStages stages)
      : stages_(std::move(stages)) {
    info_.name = name;
    info_.summary = summary;
    info_.profile = stages_.profile;
    info_.takes_tiles = false;
    info_.takes_scissor = false;
    info_.takes_culling = false;
    info_.coverage = stages_.coverage;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& /*options*/, CoverageCounts& counts) override {
    for (const Triangle& t : scene.triangles) {
      const std::array<Vertex, 3> corners = Corners(scene, t);
      if (std::ranges::all_of(corners, IsFinite)) DrawOne(Placed(corners), counts);
    }
  }

 private:
  std::array<Point2, 3> Placed(const std::array<Vertex, 3>& corners) const {
    std::array<Point2, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = {corners[k].x, corners[k].y};
      if (stages_.placing.IsNone()) continue;
      v[k] = {SnapToGrid(v[k].x, stages_.placing), SnapToGrid(v[k].y, stages_.placing)};
    }
    return v;
  }

  static bool TouchCounts(Contact contact, const std::array<int, 4>& signs) {
    switch (contact) {
      case Contact::kAny:
        return true;
      case Contact::kFloor:
        return signs[0] == 0;
      case Contact::kCeiling:
        return signs[3] == 0;
      case Contact::kNone:
        break;
    }
    return false;
  }

  // Whether the square reaches the inner side of the edge, or keeps to it.
  bool Passes(Point2 a, Point2 b, int inner, Contact contact, const Corners4& corners) const {
    std::array<int, 4> signs{};
    for (std::size_t k = 0; k < 4; ++k) {
      signs[k] = inner * library::EdgeSign(a, b, corners[k]);
    }
    const auto [least, most] = std::ranges::minmax(signs);
    const int deciding = stages_.holds ? least : most;
    return deciding > 0 || (deciding == 0 && TouchCounts(contact, signs));
  }

  static bool MeetsAlong(Contact contact, double a, double b, double low, double high) {
    const bool at_low = contact == Contact::kAny || contact == Contact::kFloor;
    const bool at_high = contact == Contact::kAny || contact == Contact::kCeiling;
    return (b > low || (b == low && at_low)) && (a < high || (a == high && at_high));
  }

  bool Covers(const SquareQuestion& q, int facing) const {
    const auto [left, right] = std::minmax({q.v[0].x, q.v[1].x, q.v[2].x});
    const auto [top, bottom] = std::minmax({q.v[0].y, q.v[1].y, q.v[2].y});
    const Contact contact = facing == 0 ? stages_.flat_contact : stages_.contact;
    if (!stages_.holds && !(MeetsAlong(contact, left, right, q.low.x, q.high.x) &&
                            MeetsAlong(contact, top, bottom, q.low.y, q.high.y))) {
      return false;
    }
    if (stages_.holds && facing == 0) return false;
    const Corners4 corners = CornersOf(q);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2& a = q.v[k];
      const Point2& b = q.v[(k + 1) % 3];
      if (a == b) continue;
      for (const int inner : {+1, -1}) {
        if ((facing == 0 || inner == facing) && !Passes(a, b, inner, contact, corners))
          return false;
      }
    }
    return true;
  }

  void DrawOne(const std::array<Point2, 3>& v, CoverageCounts& counts) const {
    const int facing = library::EdgeSign(v[0], v[1], v[2]);
    if (facing == 0 && !stages_.draws_flat) return;
    if (stages_.drops && stages_.drops(v)) return;
    const double u = stages_.half_width;
    const bool up = stages_.profile.y_axis == YAxis::kUp;
    for (int j = 0; j < counts.height; ++j) {
      for (int i = 0; i < counts.width; ++i) {
        const SquareQuestion q{v, {i - u, j - u}, {i + 1 + u, j + 1 + u}};
        const bool sound = Covers(q, facing);
        if (!(stages_.instead ? stages_.instead(q, sound) : sound)) continue;
        std::uint32_t& count = counts.front[counts.Index(i, up ? counts.height - 1 - j : j)];
        count = stages_.coverage == CoverageKind::kMask ? 1 : count + 1;
      }
    }
  }

  SquareStages stages_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> MakeSquares(const std::string& name, const std::string& summary,
                                     SquareStages stages) {
  return std::make_unique<Squares>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
