// Meshes made by splitting: triangulations of hard places, recursive subdivision, T-junctions.
#include <cmath>
#include <cstdint>

#include "props/domains/lines.h"
#include "props/domains/planar_mesh.h"
#include "props/domains/recipes.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

Point2 OnLattice(const Sketch& sketch, Point2 p) {
  return {sketch.lattice().RoundWithinLimit(p.x), sketch.lattice().RoundWithinLimit(p.y)};
}

// A quad around the target, on whole pixels a few off its border, cut along a diagonal.
PlanarMesh DrawFrame(Sketch& sketch) {
  BitSource& bits = sketch.bits();
  const auto margin = [&] { return static_cast<double>(bits.Int(1, 6)); };
  const auto vertex = [&](double x, double y) { return OnLattice(sketch, {x, y}); };
  PlanarMesh mesh;
  mesh.AddVertex(vertex(-margin(), -margin()));
  mesh.AddVertex(vertex(-margin(), sketch.height() + margin()));
  mesh.AddVertex(vertex(sketch.width() + margin(), sketch.height() + margin()));
  mesh.AddVertex(vertex(sketch.width() + margin(), -margin()));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// The middle of an edge of a random triangle, on the lattice.
Point2 DrawMidpoint(Sketch& sketch, const PlanarMesh& mesh) {
  BitSource& bits = sketch.bits();
  const auto count = static_cast<std::int64_t>(mesh.triangles.size());
  const Triangle& t = mesh.triangles[static_cast<std::size_t>(bits.Int(0, count - 1))];
  const std::int64_t edge = bits.Int(0, 2);
  const Point2 a = mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(edge)])];
  const Point2 b =
      mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>((edge + 1) % 3)])];
  return OnLattice(sketch, {(a.x + b.x) / 2, (a.y + b.y) / 2});
}

}  // namespace

Case Triangulations(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  PlanarMesh mesh = DrawFrame(sketch);
  mesh.Insert(OnLattice(sketch, sketch.Sample()));
  const std::int64_t places = bits.Int(1, 16);
  for (std::int64_t i = 0; i < places; ++i) {
    const std::int64_t kind = bits.Int(0, 3);
    if (kind == 0) {
      mesh.Insert(DrawMidpoint(sketch, mesh));
    } else if (kind == 1) {
      mesh.Insert(OnLattice(sketch, sketch.Sample()));
    } else if (kind == 2) {
      mesh.Insert(OnLattice(sketch, Nudged(sketch, sketch.Sample(), 2)));
    } else {
      mesh.Insert(OnLattice(sketch, sketch.Place()));
    }
  }
  mesh.AddTo(sketch);
  return sketch.Done(Finish::kMesh);
}

Case Subdivisions(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  PlanarMesh mesh = DrawFrame(sketch);
  mesh.Insert(OnLattice(sketch, sketch.Sample()));
  // Every split is taken by both sides of the edge, so the mesh stays conforming; midpoints halve
  // until the lattice ends them.
  const std::int64_t splits = bits.Int(4, 40);
  for (std::int64_t i = 0; i < splits; ++i) mesh.Insert(DrawMidpoint(sketch, mesh));
  mesh.AddTo(sketch);
  return sketch.Done(Finish::kMesh);
}

Case TJunctions(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  PlanarMesh mesh = DrawFrame(sketch);
  const Point2 p = sketch.Sample();
  mesh.Insert(OnLattice(sketch, p));
  const std::int64_t splits = bits.Int(1, 8);
  for (std::int64_t i = 0; i < splits; ++i) {
    Point2 middle = DrawMidpoint(sketch, mesh);
    if (bits.Chance(96)) middle = OnLattice(sketch, Nudged(sketch, middle, 1));
    mesh.InsertIntoOne(middle);
  }
  mesh.AddTo(sketch);
  return sketch.Done(Finish::kMesh);
}

}  // namespace rasterproof::props
