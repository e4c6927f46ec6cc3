#include "props/domains/planar_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/coverage.h"
#include "exact/edge.h"

namespace rasterproof::props {
namespace {

Point2 VertexOf(const PlanarMesh& mesh, std::int32_t index) {
  return mesh.vertices[static_cast<std::size_t>(index)];
}

int FacingOf(const PlanarMesh& mesh, const Triangle& t) {
  return exact::Facing({VertexOf(mesh, t[0]), VertexOf(mesh, t[1]), VertexOf(mesh, t[2])});
}

}  // namespace

std::int32_t PlanarMesh::AddVertex(Point2 p) {
  vertices.push_back(p);
  return static_cast<std::int32_t>(vertices.size() - 1);
}

void PlanarMesh::AddQuads(BitSource& bits, int columns, int rows) {
  const int across = columns + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * across + i;
      const int b = a + 1, c = a + across, d = c + 1;
      const bool falling = bits.Chance(128);
      triangles.push_back(falling ? Triangle{a, d, b} : Triangle{a, c, b});
      triangles.push_back(falling ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  }
}

std::array<int, 3> PlanarMesh::Sides(std::size_t t, Point2 p) const {
  const Triangle& v = triangles[t];
  const int facing = FacingOf(*this, v);
  std::array<int, 3> sides{};
  for (std::size_t e = 0; e < 3; ++e) {
    const Point2 from = VertexOf(*this, v[(e + 1) % 3]);
    const Point2 to = VertexOf(*this, v[(e + 2) % 3]);
    sides[e] = facing * exact::EdgeSign(from, to, p);
  }
  return sides;
}

void PlanarMesh::Split(std::size_t t, const std::array<int, 3>& sides, std::int32_t p) {
  const Triangle v = triangles[t];
  bool first = true;
  for (std::size_t e = 0; e < 3; ++e) {
    if (sides[e] == 0) continue;  // the part between p and an edge that p lies on has no area
    const Triangle part{p, v[(e + 1) % 3], v[(e + 2) % 3]};
    if (first) {
      triangles[t] = part;
    } else {
      triangles.push_back(part);
    }
    first = false;
  }
}

void PlanarMesh::Insert(Point2 p) {
  if (std::ranges::find(vertices, p) != vertices.end()) return;
  std::int32_t index = -1;
  const std::size_t count = triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const std::array<int, 3> sides = Sides(t, p);
    if (std::ranges::any_of(sides, [](int side) { return side < 0; })) continue;
    if (index < 0) index = AddVertex(p);
    Split(t, sides, index);
  }
}

void PlanarMesh::SplitOneSide(std::size_t t, std::size_t edge, Point2 p) {
  const Triangle v = triangles[t];
  const std::int32_t index = AddVertex(p);
  triangles[t] = {v[edge], v[(edge + 1) % 3], index};
  triangles.push_back({v[edge], index, v[(edge + 2) % 3]});
}

bool PlanarMesh::IsFacingOneWay() const {
  const int facing = triangles.empty() ? 0 : FacingOf(*this, triangles.front());
  return facing != 0 && std::ranges::all_of(triangles, [&](const Triangle& t) {
           return FacingOf(*this, t) == facing;
         });
}

void PlanarMesh::AddTo(CaseBuilder& builder) const {
  std::vector<std::int32_t> index;
  for (const Point2& p : vertices) index.push_back(builder.Add(p));
  for (const Triangle& t : triangles) {
    builder.AddTriangle(index[static_cast<std::size_t>(t[0])],
                        index[static_cast<std::size_t>(t[1])],
                        index[static_cast<std::size_t>(t[2])]);
  }
}

}  // namespace rasterproof::props
