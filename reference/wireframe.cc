#include "reference/wireframe.h"

#include <array>
#include <cmath>
#include <limits>

#include "reference/running_error.h"

namespace rasterproof::reference {
namespace {

/// One coordinate of A, B, C.
template <class N>
std::array<N, 3> Coordinates(N p, N u, N v, N dpdu, N dpdv) {
  const N a = (p - u * dpdu) - v * dpdv;
  return {a, a + dpdu, a + dpdv};
}

template <class T>
std::array<Point3, 3> VerticesIn(const SurfacePoint& s) {
  const auto along = [&](double Point3::* c) {
    return Coordinates<T>(static_cast<T>(s.p.*c), static_cast<T>(s.u), static_cast<T>(s.v),
                          static_cast<T>(s.dpdu.*c), static_cast<T>(s.dpdv.*c));
  };
  const auto x = along(&Point3::x);
  const auto y = along(&Point3::y);
  const auto z = along(&Point3::z);
  return {Point3{x[0], y[0], z[0]}, Point3{x[1], y[1], z[1]}, Point3{x[2], y[2], z[2]}};
}

template <class T>
std::array<Point3, 3> BoundsIn(const SurfacePoint& s) {
  const auto number = [](double x) {
    const T value = static_cast<T>(x);
    return RunningError<T>(value, std::isfinite(x) && static_cast<double>(value) == x
                                      ? 0
                                      : std::numeric_limits<double>::quiet_NaN());
  };
  const auto along = [&](double Point3::* c) {
    return Coordinates(number(s.p.*c), number(s.u), number(s.v), number(s.dpdu.*c),
                       number(s.dpdv.*c));
  };
  const auto x = along(&Point3::x);
  const auto y = along(&Point3::y);
  const auto z = along(&Point3::z);
  const auto bounds = [&](std::size_t i) { return Point3{x[i].error, y[i].error, z[i].error}; };
  return {bounds(0), bounds(1), bounds(2)};
}

template <class T>
struct Vector {
  T x, y, z;
  Vector(Point3 from, Point3 to)
      : x(static_cast<T>(to.x) - static_cast<T>(from.x)),
        y(static_cast<T>(to.y) - static_cast<T>(from.y)),
        z(static_cast<T>(to.z) - static_cast<T>(from.z)) {}
};

/// |a x b|.
template <class T>
T CrossLength(const Vector<T>& a, const Vector<T>& b) {
  const T x = a.y * b.z - a.z * b.y;
  const T y = a.z * b.x - a.x * b.z;
  const T z = a.x * b.y - a.y * b.x;
  return std::sqrt((x * x + y * y) + z * z);
}

template <class T>
std::array<double, 3> UnsignedBarycentricsIn(const std::array<Point3, 3>& v, Point3 p) {
  const Vector<T> ab(v[0], v[1]);
  const Vector<T> bc(v[1], v[2]);
  const T whole = CrossLength(ab, bc);
  const T l2 = CrossLength(ab, Vector<T>(v[1], p)) / whole;
  const T l0 = CrossLength(bc, Vector<T>(v[2], p)) / whole;
  return {l0, (T{1} - l2) - l0, l2};
}

}  // namespace

std::array<Point3, 3> ReconstructVertices(Precision precision, const SurfacePoint& point) {
  return precision == Precision::kFloat32 ? VerticesIn<float>(point) : VerticesIn<double>(point);
}

std::array<Point3, 3> ReconstructionErrorBounds(Precision precision, const SurfacePoint& point) {
  return precision == Precision::kFloat32 ? BoundsIn<float>(point) : BoundsIn<double>(point);
}

std::array<double, 3> UnsignedBarycentrics(Precision precision, const std::array<Point3, 3>& v,
                                           Point3 p) {
  return precision == Precision::kFloat32 ? UnsignedBarycentricsIn<float>(v, p)
                                          : UnsignedBarycentricsIn<double>(v, p);
}

}  // namespace rasterproof::reference
