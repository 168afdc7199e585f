// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/paper_corridor.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tern_bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using tern::Vec3;

/// A point this close to the surface, relative, is outside.
constexpr double kTouching = 1e-9;

Vector3d vector(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// Columns of `turn` are the axes; the ellipsoid is { center + turn diag(semi) q : |q| <= 1 }.
struct Ellipsoid {
  Vector3d center;
  Matrix3d turn;
  Vector3d semi;

  Vector3d local(const Vector3d& p) const { return turn.transpose() * (p - center); }
  double reach(const Vector3d& p) const { return local(p).cwiseQuotient(semi).norm(); }
};

class Grower {
 public:
  Grower(std::vector<Vector3d> points, PaperPolyhedron& out) : points_(std::move(points)), out_(out) {}

  /// The points inside; each look counts.
  std::vector<Vector3d> inside(const Ellipsoid& e) {
    std::vector<Vector3d> found;
    for (const Vector3d& p : points_) {
      if (look(e, p) < 1.0 - kTouching) found.push_back(p);
    }
    return found;
  }

  /// Drops what is not inside any more and finds the nearest of the rest; false where nothing is left.
  bool nearest_inside(const Ellipsoid& e, std::vector<Vector3d>& points, Vector3d& nearest) {
    double least = 1.0 - kTouching;
    std::vector<Vector3d> kept;
    for (const Vector3d& p : points) {
      const double reach = look(e, p);
      if (reach >= 1.0 - kTouching) continue;
      kept.push_back(p);
      if (reach < least) {
        least = reach;
        nearest = p;
      }
    }
    points.swap(kept);
    return !points.empty();
  }

  void shrink_across(Ellipsoid& e) {
    std::vector<Vector3d> candidates = inside(e);
    Vector3d p = Vector3d::Zero();
    while (nearest_inside(e, candidates, p)) {
      ++out_.shrinks;
      // The second axis turns towards the point.
      const Vector3d along = e.turn.col(0);
      const Vector3d d = p - e.center;
      const Vector3d across = d - along * along.dot(d);
      const double used = along.dot(d) / e.semi.x();
      if (across.norm() < 1e-9 || used * used >= 1.0) break;
      e.turn.col(1) = across.normalized();
      e.turn.col(2) = along.cross(e.turn.col(1));
      e.semi.y() = std::min(e.semi.y(), across.norm() / std::sqrt(1.0 - used * used));
      e.semi.z() = e.semi.y();
    }
  }

  void stretch_third(Ellipsoid& e) {
    e.semi.z() = e.semi.x();
    std::vector<Vector3d> candidates = inside(e);
    Vector3d p = Vector3d::Zero();
    while (nearest_inside(e, candidates, p)) {
      ++out_.shrinks;
      const Vector3d q = e.local(p).cwiseQuotient(e.semi);
      const double left = 1.0 - q.x() * q.x() - q.y() * q.y();
      if (left <= 0.0) break;
      e.semi.z() = std::min(e.semi.z(), std::fabs(e.local(p).z()) / std::sqrt(left));
    }
  }

  void cut(const Ellipsoid& e) {
    std::vector<Vector3d> left = points_;
    while (!left.empty()) {
      Vector3d nearest = Vector3d::Zero();
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3d& p : left) {
        const double reach = look(e, p);
        if (reach >= least) continue;
        least = reach;
        nearest = p;
      }
      const Vector3d scaled = e.local(nearest).cwiseQuotient(e.semi.cwiseProduct(e.semi));
      const Vector3d normal = (e.turn * scaled).normalized();
      const double offset = normal.dot(nearest);
      out_.planes.push_back({{normal.x(), normal.y(), normal.z()}, offset});
      std::vector<Vector3d> kept;
      for (const Vector3d& p : left) {
        ++out_.checks;
        if (normal.dot(p) < offset - kTouching) kept.push_back(p);
      }
      left.swap(kept);
    }
  }

 private:
  double look(const Ellipsoid& e, const Vector3d& p) {
    ++out_.checks;
    return e.reach(p);
  }

  std::vector<Vector3d> points_;
  PaperPolyhedron& out_;
};

bool within(const Vector3d& p, const Vector3d& low, const Vector3d& high, double margin) {
  return ((p - low).array() >= -margin).all() && ((p - high).array() <= margin).all();
}

}  // namespace

std::vector<Vec3> surface_points(const PaperMap& map) {
  std::vector<Vec3> points;
  const tern::Voxel& dims = map.dims();
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (!map.obstacle({x, y, z})) continue;
        const bool buried = map.obstacle({x - 1, y, z}) && map.obstacle({x + 1, y, z}) && map.obstacle({x, y - 1, z}) &&
                            map.obstacle({x, y + 1, z}) && map.obstacle({x, y, z - 1}) && map.obstacle({x, y, z + 1});
        if (!buried) points.push_back(map.center({x, y, z}));
      }
    }
  }
  return points;
}

PaperPolyhedron grow_paper_polyhedron(const Vec3& from, const Vec3& to, const std::vector<Vec3>& points,
                                      double box_margin) {
  PaperPolyhedron out{};
  const Vector3d a = vector(from);
  const Vector3d b = vector(to);
  const double half = 0.5 * (b - a).norm();
  if (half < 0.5e-9) return out;
  std::vector<Vector3d> near;
  for (const Vec3& p : points) {
    if (within(vector(p), a.cwiseMin(b), a.cwiseMax(b), box_margin)) near.push_back(vector(p));
  }
  Ellipsoid e;
  e.center = 0.5 * (a + b);
  e.semi = Vector3d::Constant(half);
  e.turn.col(0) = (b - a).normalized();
  e.turn.col(1) = e.turn.col(0).unitOrthogonal();
  e.turn.col(2) = e.turn.col(0).cross(e.turn.col(1));
  Grower grower(std::move(near), out);
  grower.shrink_across(e);
  grower.stretch_third(e);
  for (int k = 0; k < 3; ++k) out.semi_axes[k] = e.semi[k];
  grower.cut(e);
  return out;
}

}  // namespace tern_bench
