// The camera: its words, and what it sees.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/scene.h"
#include "io/mesh.h"

namespace rasterproof::io {
namespace {

using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double Length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

struct Ball {
  Vector centre{};
  double radius = 0;
};

// The ball around the box of the mesh.
Ball Around(const Mesh& mesh) {
  Vector low{};
  Vector high{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto less = [i](const auto& a, const auto& b) { return a[i] < b[i]; };
    if (mesh.vertices.empty()) continue;
    low[i] = double{(*std::ranges::min_element(mesh.vertices, less))[i]};
    high[i] = double{(*std::ranges::max_element(mesh.vertices, less))[i]};
  }
  const Vector centre{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
  const double radius = Length(high - centre);
  return {centre, radius > 0 ? radius : 1};
}

double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

InputError BadCamera(const std::string& text, const std::string& reason) {
  return {"camera \"" + text + "\"", reason,
          "write front, inside, or eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES"};
}

double Number(const std::string& camera, std::string_view text) {
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw BadCamera(camera, "\"" + std::string(text) + "\" is not a finite number");
  }
  return value;
}

// The word up to the next separator; takes both from the text.
std::string_view Take(std::string_view& text, std::string_view separators) {
  const std::size_t end = std::min(text.find_first_of(separators), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

// Three numbers, "X,Y,Z" or "X Y Z", from the front of the text.
Vector TakeVector(const std::string& camera, std::string_view& text) {
  Vector v{};
  for (double& x : v) x = Number(camera, Take(text, ", "));
  return v;
}

Camera ParseFields(const std::string& camera, Camera result) {
  std::string_view rest = camera;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(", "), rest.size()));
    if (rest.empty()) return result;
    if (rest.find('=') == std::string_view::npos) {
      throw BadCamera(camera, "\"" + std::string(rest) + "\" is no field");
    }
    const std::string_view key = Take(rest, "=");
    if (key == "eye") {
      result.eye = TakeVector(camera, rest);
    } else if (key == "target") {
      result.target = TakeVector(camera, rest);
    } else if (key == "up") {
      result.up = TakeVector(camera, rest);
    } else if (key == "fov") {
      result.vertical_fov_degrees = Number(camera, Take(rest, ", "));
    } else {
      throw BadCamera(camera, "\"" + std::string(key) + "\" is unknown");
    }
  }
}

// Camera axes, orthonormal; and the depth range of the mesh.
struct View {
  Vector eye;
  Vector right;
  Vector up;
  Vector forward;
  double focal;  // pixels at depth 1
  double centre_x;
  double centre_y;
  double near = 0;
  double far = 0;
};

View ViewOf(const Camera& camera, int width, int height) {
  const Vector ahead = camera.target - camera.eye;
  const double distance = Length(ahead);
  if (!(distance > 0)) {
    throw InputError("camera", "the eye is at the target", "move one of them");
  }
  const double fov = camera.vertical_fov_degrees;
  if (!(fov > 0 && fov < 180)) {
    throw InputError("camera", "the field of view is not between 0 and 180 degrees", "change fov");
  }
  View view;
  view.eye = camera.eye;
  view.forward = 1 / distance * ahead;
  const Vector side = Cross(view.forward, camera.up);
  // Nearly parallel directions have no side worth the name.
  constexpr double kLeastSine = 1e-9;
  if (!(Length(side) > kLeastSine * Length(camera.up))) {
    throw InputError("camera", "up points along the line of sight", "change up");
  }
  view.right = 1 / Length(side) * side;
  view.up = Cross(view.right, view.forward);
  view.focal = height / 2.0 / std::tan(Radians(fov) / 2);
  view.centre_x = width / 2.0;
  view.centre_y = height / 2.0;
  return view;
}

Vector ToVector(const std::array<float, 3>& p) {
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

void SetDepthRange(const Mesh& mesh, View& view) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  view.near = kInfinity;
  view.far = -kInfinity;
  for (const auto& p : mesh.vertices) {
    const double depth = Dot(ToVector(p) - view.eye, view.forward);
    view.near = std::min(view.near, depth);
    view.far = std::max(view.far, depth);
  }
  // Vertices beside or behind the eye have no depth in the window: a small near plane stands in.
  constexpr double kLeastNearToFar = 0x1p-10;
  if (!(view.far > 0)) view.far = 1;
  view.near = std::max(view.near, kLeastNearToFar * view.far);
}

// Clip coordinates in double: window = (x / w, y / w), and z / w runs from 0 at `near` to 1 at
// `far`, so that it is affine in the window.
Vertex Project(const View& view, const Vector& p) {
  const Vector d = p - view.eye;
  const double w = Dot(d, view.forward);
  const double range = view.far - view.near;
  return {view.focal * Dot(d, view.right) + view.centre_x * w,
          view.centre_y * w - view.focal * Dot(d, view.up),
          range > 0 ? view.far / range * (w - view.near) : 0, w};
}

void RoundToFloat32(Vertex& v) {
  for (double* c : {&v.x, &v.y, &v.z, &v.w}) *c = double{static_cast<float>(*c)};
}

}  // namespace

Camera ParseCamera(const std::string& text, const Mesh& mesh) {
  const Ball ball = Around(mesh);
  Camera camera;
  if (text == "front") {
    // As near as the ball stays within the field of view, and a little farther.
    constexpr double kMargin = 1.05;
    const double distance = ball.radius / std::sin(Radians(camera.vertical_fov_degrees) / 2);
    camera.target = ball.centre;
    camera.eye = ball.centre;
    camera.eye[2] += kMargin * distance;
    return camera;
  }
  if (text == "inside") {
    camera.eye = ball.centre;
    camera.target = ball.centre;
    camera.target[2] -= ball.radius;
    camera.vertical_fov_degrees = 90;
    return camera;
  }
  return ParseFields(text, camera);
}

Scene ProjectMesh(const Mesh& mesh, const Camera& camera, int width, int height, ProjectTo to) {
  View view = ViewOf(camera, width, height);
  SetDepthRange(mesh, view);
  Scene scene;
  scene.name = mesh.name;
  scene.width = width;
  scene.height = height;
  scene.clip_space = to == ProjectTo::kClip;
  scene.triangles = mesh.triangles;
  scene.vertices.reserve(mesh.vertices.size());
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    const std::string place = mesh.name + ": vertex " + std::to_string(k);
    Vertex v = Project(view, ToVector(mesh.vertices[k]));
    if (to == ProjectTo::kWindow) {
      if (!(v.w > 0)) {
        throw InputError(place, "is not in front of the eye",
                         "draw in clip space, or move the camera back");
      }
      v = {v.x / v.w, v.y / v.w, v.z / v.w, 1};
    }
    RoundToFloat32(v);
    if (!IsFinite(v) || !std::isfinite(v.z)) {
      throw InputError(place, "lies beyond float32 in this view", "move the camera or the mesh");
    }
    scene.vertices.push_back(v);
  }
  return scene;
}

}  // namespace rasterproof::io
