// Suspects of clip space: what lies behind the eye, division, transforms.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/transform.h"
#include "props/cause/suspect.h"

namespace rasterproof::props {
namespace {

using Pieces = std::vector<variants::ClipTriangle>;

void AddMirrored(std::vector<Suspect>& list) {
  list.push_back({"clip-space",
                  "draws what lies behind the eye upside down as well",
                  {.clip = [](const variants::ClipTriangle& v) {
                    variants::ClipTriangle mirrored = v;
                    for (Vertex& p : mirrored) p = {-p.x, -p.y, p.z, -p.w};
                    return Pieces{v, mirrored};
                  }}});
}

void AddBehindTheEye(std::vector<Suspect>& list) {
  const auto dropping = [&](const std::string& what, auto drops) {
    list.push_back({"clip-space", what, {.clip = [drops](const variants::ClipTriangle& v) {
                      return drops(v) ? Pieces{} : Pieces{v};
                    }}});
  };
  const auto changing = [&](const std::string& what, auto change) {
    list.push_back({"clip-space", what, {.clip = [change](const variants::ClipTriangle& v) {
                      Pieces pieces{v};
                      for (Vertex& p : pieces.front()) change(p);
                      return pieces;
                    }}});
  };
  dropping("leaves out triangles with a vertex behind the eye",
           [](const variants::ClipTriangle& v) {
             return std::ranges::any_of(v, [](const Vertex& p) { return p.w <= 0; });
           });
  dropping("leaves out triangles with a vertex of negative w", [](const variants::ClipTriangle& v) {
    return std::ranges::any_of(v, [](const Vertex& p) { return p.w < 0; });
  });
  for (std::size_t k = 0; k < 3; ++k) {
    dropping("leaves out triangles whose vertex " + std::to_string(k) + " is behind the eye",
             [k](const variants::ClipTriangle& v) { return v[k].w <= 0; });
  }
  for (const int power : {-24, -20, -16, -10}) {
    const double limit = std::ldexp(1.0, power);
    dropping("leaves out triangles with a w near zero", [limit](const variants::ClipTriangle& v) {
      return std::ranges::any_of(v, [&](const Vertex& p) { return std::fabs(p.w) < limit; });
    });
    changing("raises w to 2^" + std::to_string(power),
             [limit](Vertex& p) { p.w = std::max(p.w, limit); });
  }
  changing("projects vertices behind the eye like the others", [](Vertex& p) {
    if (p.w < 0) p = {-p.x, -p.y, -p.z, -p.w};
  });
  list.push_back({"clip-space",
                  "projects a single vertex behind the eye like the others",
                  {.clip = [](const variants::ClipTriangle& v) {
                    variants::ClipTriangle projected = v;
                    const auto is_behind = [](const Vertex& p) { return p.w < 0; };
                    if (std::ranges::count_if(v, is_behind) == 1) {
                      for (Vertex& p : projected) {
                        if (is_behind(p)) p = {-p.x, -p.y, -p.z, -p.w};
                      }
                    }
                    return Pieces{projected};
                  }}});
  changing("does not divide by w", [](Vertex& p) { p.w = 1; });
  changing("takes the size of w", [](Vertex& p) { p.w = std::fabs(p.w); });
  changing("takes w = 0 for 1", [](Vertex& p) { p.w = p.w == 0 ? 1 : p.w; });
  AddMirrored(list);
  changing("divides by w in float32", [](Vertex& p) {
    if (p.w <= 0) return;
    const auto w = static_cast<float>(p.w);
    p = {double{static_cast<float>(p.x) / w}, double{static_cast<float>(p.y) / w}, p.z, 1};
  });
}

void AddTransforms(const Profile& profile, std::vector<Suspect>& list) {
  if (!profile.transform) return;
  const Transform stated = *profile.transform;
  const auto add = [&](const std::string& what, auto change) {
    Transform other = stated;
    change(other);
    if (other == stated) return;
    list.push_back(
        {"transform", what, {.model = [other](Profile& p, const Scene&) { p.transform = other; }}});
  };
  add("divides by w", [](Transform& t) { t.division = Division::kQuotient; });
  add("multiplies by the reciprocal", [](Transform& t) { t.division = Division::kReciprocal; });
  add("computes its transform in float32", [](Transform& t) { t.precision = Precision::kFloat32; });
  add("computes its transform in float64", [](Transform& t) { t.precision = Precision::kFloat64; });
  add("turns y over where it is stated not to, or the other way round",
      [](Transform& t) { t.flips_y = !t.flips_y; });
  add("adds one before it scales to the viewport",
      [](Transform& t) { t.viewport = ViewportForm::kAddMultiply; });
  add("fuses the viewport's product and sum",
      [](Transform& t) { t.viewport = ViewportForm::kFused; });
  add("rounds the viewport's product before its sum",
      [](Transform& t) { t.viewport = ViewportForm::kMultiplyAdd; });
}

}  // namespace

void AddClipping(const Profile& profile, std::vector<Suspect>& list) {
  AddBehindTheEye(list);
  AddTransforms(profile, list);
}

}  // namespace rasterproof::props
