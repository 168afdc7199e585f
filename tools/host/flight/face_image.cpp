// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points are held as (right / depth, down / depth, 1 / depth). There, faces stay flat, so the nearest point of a face
// in a pixel's area is a corner of the face cut to that area.
#include "host/flight/face_image.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

using Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;

constexpr double kClosest = 0.01;  ///< metres
constexpr double kBulge = 0.002;   ///< metres from a cylinder to the corners of its prism

/// The part of a convex polygon at which sign * (coordinate - border) >= 0.
void cut(const Polygon& from, int axis, double border, double sign, Polygon& to) {
  to.clear();
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Vector3d& a = from[k];
    const Vector3d& b = from[k + 1 < from.size() ? k + 1 : 0];
    const double in_a = sign * (a[axis] - border);
    const double in_b = sign * (b[axis] - border);
    if (in_a >= 0.0) to.push_back(a);
    if ((in_a > 0.0 && in_b < 0.0) || (in_a < 0.0 && in_b > 0.0)) {
      to.push_back(a + in_a / (in_a - in_b) * (b - a));
      to.back()[axis] = border;
    }
  }
}

/// The largest third coordinate of a convex polygon between two borders of the first; 0 where there is none.
double most_between(const Polygon& polygon, double low, double high) {
  double most = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector3d& a = polygon[k];
    const Vector3d& b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    if (a.x() >= low && a.x() <= high) most = std::max(most, a.z());
    for (const double border : {low, high}) {
      if ((a.x() < border) == (b.x() < border)) continue;
      most = std::max(most, a.z() + (border - a.x()) / (b.x() - a.x()) * (b.z() - a.z()));
    }
  }
  return most;
}

/// Pixels of one axis: where the area of each begins and ends, in metres aside for each metre ahead.
struct PixelAxis {
  double focal, center, half;
  int count;

  double low(int k) const { return (k - center - half) / focal; }
  double high(int k) const { return (k - center + half) / focal; }
  int first(double at) const { return index(std::ceil(at * focal + center - half)); }
  int last(double at) const { return index(std::floor(at * focal + center + half)); }
  int index(double k) const { return static_cast<int>(std::clamp(k, -1.0, static_cast<double>(count))); }
};

class FaceImage {
 public:
  FaceImage(const tern::Pose& camera, const tern::DepthView& view, double far, double part)
      : eye_(camera.position.x, camera.position.y, camera.position.z),
        turn_(Eigen::Quaterniond(camera.quaternion[0], camera.quaternion[1], camera.quaternion[2], camera.quaternion[3])
                  .conjugate()
                  .toRotationMatrix()),
        columns_{view.fx, view.cx, 0.5 * part, view.width},
        rows_{view.fy, view.cy, 0.5 * part, view.height},
        least_(1.0 / far),
        inverse_(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), least_) {}

  const Vector3d& eye() const { return eye_; }

  /// A flat, convex face.
  void draw(const Polygon& face) {
    seen_.clear();
    for (const Vector3d& corner : face) seen_.push_back(turn_ * (corner - eye_));
    cut(seen_, 2, kClosest, 1.0, cut_);
    double top = 1e9, bottom = -1e9, nearest = 0.0;
    for (Vector3d& p : cut_) {
      p = {p.x() / p.z(), p.y() / p.z(), 1.0 / p.z()};
      top = std::min(top, p.y());
      bottom = std::max(bottom, p.y());
      nearest = std::max(nearest, p.z());
    }
    if (nearest <= least_) return;
    const int last = std::min(rows_.count - 1, rows_.last(bottom));
    for (int v = std::max(0, rows_.first(top)); v <= last; ++v) {
      cut(cut_, 1, rows_.low(v), 1.0, half_);
      cut(half_, 1, rows_.high(v), -1.0, band_);
      draw_row(v, band_);
    }
  }

  std::vector<double> depths() const {
    std::vector<double> depths;
    for (const double inverse : inverse_) depths.push_back(1.0 / inverse);
    return depths;
  }

 private:
  void draw_row(int v, const Polygon& band) {
    double left = 1e9, right = -1e9, nearest = 0.0;
    for (const Vector3d& p : band) {
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      nearest = std::max(nearest, p.z());
    }
    const int last = std::min(columns_.count - 1, columns_.last(right));
    for (int u = std::max(0, columns_.first(left)); u <= last; ++u) {
      double& inverse = inverse_[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_.count) +
                                 static_cast<std::size_t>(u)];
      if (nearest > inverse) inverse = std::max(inverse, most_between(band, columns_.low(u), columns_.high(u)));
    }
  }

  Vector3d eye_;
  Eigen::Matrix3d turn_;
  PixelAxis columns_, rows_;
  double least_;
  std::vector<double> inverse_;
  Polygon seen_, cut_, half_, band_;
};

/// The faces that the eye sees from outside, or, of the boundary, all of them, from inside.
void draw_box(const tern::Box& box, bool from_inside, FaceImage& image) {
  const Vector3d corner[2] = {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}};
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const double out = (side == 0 ? -1.0 : 1.0) * (image.eye()[axis] - corner[side][axis]);
      if (!from_inside && out <= 0.0) continue;
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      Polygon face(4, corner[side]);
      face[0][u] = face[3][u] = corner[0][u];
      face[1][u] = face[2][u] = corner[1][u];
      face[0][v] = face[1][v] = corner[0][v];
      face[2][v] = face[3][v] = corner[1][v];
      image.draw(face);
    }
  }
}

void draw_cylinder(const Cylinder& c, FaceImage& image) {
  const double half_angle = std::acos(c.radius / (c.radius + kBulge));
  const int sides = std::clamp(static_cast<int>(std::ceil(0.5 * kTurn / half_angle)), 6, 64);
  const double radius = c.radius / std::cos(0.5 * kTurn / sides);
  const auto corner = [&](int k, double z) {
    const double angle = kTurn * (k + 0.5) / sides;
    return Vector3d(c.x + radius * std::cos(angle), c.y + radius * std::sin(angle), z);
  };
  Polygon top, bottom;
  for (int k = 0; k < sides; ++k) {
    top.push_back(corner(k, c.top));
    bottom.push_back(corner(k, c.bottom));
    const double angle = kTurn * (k + 1.0) / sides;
    const double ahead =
        (image.eye().x() - c.x) * std::cos(angle) + (image.eye().y() - c.y) * std::sin(angle) - c.radius;
    if (ahead > 0.0) {
      image.draw({corner(k, c.bottom), corner(k + 1, c.bottom), corner(k + 1, c.top), corner(k, c.top)});
    }
  }
  if (image.eye().z() > c.top) image.draw(top);
  if (image.eye().z() < c.bottom) image.draw(bottom);
}

}  // namespace

std::vector<double> depths_of_faces(const FlightWorld& world, const tern::Pose& camera, const tern::DepthView& view,
                                    double far, double part) {
  const double aside = std::max(view.cx, view.width - view.cx) / view.fx;
  const double down = std::max(view.cy, view.height - view.cy) / view.fy;
  const double reach = far * std::hypot(1.0, aside, down);
  FaceImage image(camera, view, far, part);
  draw_box(world.boundary, true, image);
  for (const tern::Box& block : world.blocks) {
    if (distance_to(block, camera.position) < reach) draw_box(block, false, image);
  }
  for (const Cylinder& cylinder : world.cylinders) {
    if (distance_to(cylinder, camera.position) < reach) draw_cylinder(cylinder, image);
  }
  return image.depths();
}

}  // namespace tern_host
