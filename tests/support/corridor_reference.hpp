// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slow and simple geometry to hold polyhedra against: voxel by voxel, vertex by vertex, nothing of the core's own.
#ifndef TERN_TESTS_SUPPORT_CORRIDOR_REFERENCE_HPP
#define TERN_TESTS_SUPPORT_CORRIDOR_REFERENCE_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/random.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "world/hull_gap.hpp"

namespace tern_test {

inline double dot3(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double norm3(const tern::Vec3& a) {
  return std::sqrt(dot3(a, a));
}
inline tern::Vec3 minus3(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline tern::Vec3 mix3(const tern::Vec3& a, const tern::Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// A grid with its storage, origin at zero so that the local frame is the world.
struct MarkedWorld {
  std::vector<std::uint64_t> words;
  tern::Grid grid;

  MarkedWorld(const tern::Voxel& dims, double cell, double radius) {
    const tern::Box all{{0.0, 0.0, 0.0}, {dims.x * cell, dims.y * cell, dims.z * cell}};
    bind(dims, cell, radius, all);
  }
  MarkedWorld(const tern::Voxel& dims, double cell, double radius, const tern::Box& boundary) {
    bind(dims, cell, radius, boundary);
  }
  void bind(const tern::Voxel& dims, double cell, double radius, const tern::Box& boundary) {
    words.assign(tern::grid_words(dims), 0);
    tern::GridSpec spec{};
    spec.cell = cell;
    spec.dims = dims;
    spec.boundary = boundary;
    spec.radius = radius;
    ASSERT_EQ(grid.bind(spec, words.data(), words.size()), tern::Status::kOk);
  }
  void mark(int x, int y, int z) { ASSERT_EQ(grid.mark_voxel({x, y, z}), tern::Status::kOk); }
  /// Voxels lower <= v < upper.
  void fill(const tern::Voxel& lower, const tern::Voxel& upper) {
    for (int z = lower.z; z < upper.z; ++z) {
      for (int y = lower.y; y < upper.y; ++y) {
        for (int x = lower.x; x < upper.x; ++x) mark(x, y, z);
      }
    }
  }
  void clear(int x, int y, int z) { ASSERT_EQ(grid.clear_voxel({x, y, z}), tern::Status::kOk); }
};

/// Every obstacle voxel of the grid as a solid cube, asked for bit by bit.
inline std::vector<tern::Box> obstacle_cubes(const tern::Grid& grid) {
  std::vector<tern::Box> cubes;
  const tern::GridSpec& spec = grid.spec();
  const double c = spec.cell;
  for (int z = 0; z < spec.dims.z; ++z) {
    for (int y = 0; y < spec.dims.y; ++y) {
      for (int x = 0; x < spec.dims.x; ++x) {
        if (grid.obstacle({x, y, z})) cubes.push_back({{x * c, y * c, z * c}, {(x + 1) * c, (y + 1) * c, (z + 1) * c}});
      }
    }
  }
  return cubes;
}

inline double point_cube_distance(const tern::Vec3& p, const tern::Box& b) {
  const double x = std::max({b.lower.x - p.x, 0.0, p.x - b.upper.x});
  const double y = std::max({b.lower.y - p.y, 0.0, p.y - b.upper.y});
  const double z = std::max({b.lower.z - p.z, 0.0, p.z - b.upper.z});
  return std::sqrt(x * x + y * y + z * z);
}

/// By golden sections would be faster; by thirds is plainer. The distance is convex along the segment.
inline double segment_cube_distance(const tern::Vec3& a, const tern::Vec3& b, const tern::Box& cube) {
  double lo = 0.0;
  double hi = 1.0;
  for (int i = 0; i < 80; ++i) {
    const double p = lo + (hi - lo) / 3.0;
    const double q = hi - (hi - lo) / 3.0;
    if (point_cube_distance(mix3(a, b, p), cube) <= point_cube_distance(mix3(a, b, q), cube)) {
      hi = q;
    } else {
      lo = p;
    }
  }
  return point_cube_distance(mix3(a, b, 0.5 * (lo + hi)), cube);
}

/// The least distance of a segment from the cubes; `far` where none is nearer.
inline double segment_clearance(const tern::Vec3& a, const tern::Vec3& b, const std::vector<tern::Box>& cubes,
                                double far) {
  const tern::Vec3 middle = mix3(a, b, 0.5);
  const double half = 0.5 * norm3(minus3(b, a));
  double least = far;
  for (const tern::Box& cube : cubes) {
    if (point_cube_distance(middle, cube) - half >= least) continue;
    least = std::min(least, segment_cube_distance(a, b, cube));
  }
  return least;
}

inline double cube_support(const tern::Vec3& n, const tern::Box& b) {
  return std::min(n.x * b.lower.x, n.x * b.upper.x) + std::min(n.y * b.lower.y, n.y * b.upper.y) +
         std::min(n.z * b.lower.z, n.z * b.upper.z);
}

inline double signed_excess(const tern::Halfspace& h, const tern::Vec3& p) {
  return dot3(h.normal, p) - h.offset;
}

/// All corners of the intersection of half-spaces, by intersecting every three planes.
inline std::vector<tern::Vec3> corners_of(const std::vector<tern::Halfspace>& planes, double tolerance) {
  std::vector<tern::Vec3> corners;
  const auto cross = [](const tern::Vec3& a, const tern::Vec3& b) {
    return tern::Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const tern::Halfspace& a = planes[i];
        const tern::Halfspace& b = planes[j];
        const tern::Halfspace& c = planes[k];
        const tern::Vec3 bc = cross(b.normal, c.normal);
        const tern::Vec3 ca = cross(c.normal, a.normal);
        const tern::Vec3 ab = cross(a.normal, b.normal);
        const double det = dot3(a.normal, bc);
        if (std::fabs(det) < 1e-9) continue;
        const tern::Vec3 p{(a.offset * bc.x + b.offset * ca.x + c.offset * ab.x) / det,
                           (a.offset * bc.y + b.offset * ca.y + c.offset * ab.y) / det,
                           (a.offset * bc.z + b.offset * ca.z + c.offset * ab.z) / det};
        const auto holds = [&](const tern::Halfspace& h) { return signed_excess(h, p) <= tolerance; };
        if (std::all_of(planes.begin(), planes.end(), holds)) corners.push_back(p);
      }
    }
  }
  return corners;
}

inline std::vector<tern::Vec3> vertices_of(const tern::Polyhedron& polyhedron) {
  return corners_of({polyhedron.planes, polyhedron.planes + polyhedron.count}, 1e-9);
}

inline tern::Vec3 cross3(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Directions along which a polyhedron and a cube are furthest apart: normals of both, and at right angles to an edge
/// of each.
inline std::vector<tern::Vec3> parting_directions(const tern::Polyhedron& polyhedron) {
  std::vector<tern::Vec3> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (int p = 0; p < polyhedron.count; ++p) directions.push_back(polyhedron.planes[p].normal);
  for (int p = 0; p < polyhedron.count; ++p) {
    for (int q = 0; q < p; ++q) {
      const tern::Vec3 edge = cross3(polyhedron.planes[p].normal, polyhedron.planes[q].normal);
      for (int a = 0; a < 6; ++a) {
        const tern::Vec3 n = cross3(edge, directions[static_cast<std::size_t>(a)]);
        if (norm3(n) > 1e-9) directions.push_back({n.x / norm3(n), n.y / norm3(n), n.z / norm3(n)});
      }
    }
  }
  return directions;
}

/// A plane lies between each cube and the polyhedron, with the radius to spare.
inline void expect_cut_off(const tern::Polyhedron& polyhedron, const std::vector<tern::Box>& cubes, double radius) {
  const std::vector<tern::Vec3> vertices = vertices_of(polyhedron);
  const std::vector<tern::Vec3> directions = parting_directions(polyhedron);
  const auto reach_along = [&](const tern::Vec3& n) {
    double reach = -1e300;
    for (const tern::Vec3& v : vertices) reach = std::max(reach, dot3(n, v));
    return reach;
  };
  std::vector<double> reach;
  for (const tern::Vec3& n : directions) reach.push_back(reach_along(n));
  for (const tern::Box& cube : cubes) {
    tern::Vec3 corners[8];
    for (int c = 0; c < 8; ++c) {
      corners[c] = {(c & 1 ? cube.upper : cube.lower).x, (c & 2 ? cube.upper : cube.lower).y,
                    (c & 4 ? cube.upper : cube.lower).z};
    }
    double best = -1e300;
    for (std::size_t k = 0; k < directions.size() && best < radius; ++k) {
      best = std::max(best, cube_support(directions[k], cube) - reach[k]);
    }
    if (best < radius) {
      const tern::HullGap gap = tern::hull_gap({vertices.data(), static_cast<int>(vertices.size())}, {corners, 8});
      best = std::max(best, cube_support(gap.normal, cube) - reach_along(gap.normal));
    }
    ASSERT_GE(best, radius - 1e-9) << "no plane parts a cube from the polyhedron";
  }
}

/// Both ways: each cube is cut off, and points all over the polyhedron (vertices and random means of them) keep the
/// radius from every cube.
inline void expect_clear(const tern::Polyhedron& polyhedron, const std::vector<tern::Box>& cubes, double radius,
                         Random& random) {
  ASSERT_NO_FATAL_FAILURE(expect_cut_off(polyhedron, cubes, radius));
  const std::vector<tern::Vec3> vertices = vertices_of(polyhedron);
  ASSERT_GE(vertices.size(), 4u) << "a bounded polyhedron with an interior has four vertices at least";
  for (std::size_t i = 0; i < vertices.size() + 20; ++i) {
    tern::Vec3 p = vertices[i % vertices.size()];
    if (i >= vertices.size()) {
      for (int k = 0; k < 3; ++k) {
        const std::size_t other = static_cast<std::size_t>(random.integer(0, static_cast<int>(vertices.size()) - 1));
        p = mix3(p, vertices[other], random.unit());
      }
    }
    for (const tern::Box& cube : cubes) ASSERT_GE(point_cube_distance(p, cube), radius - 1e-6);
  }
}

/// True for a half-space that is one of the box's own faces.
inline bool is_face_of(const tern::Halfspace& h, const tern::Box& box) {
  const tern::Vec3& corner = h.normal.x + h.normal.y + h.normal.z > 0.0 ? box.upper : box.lower;
  return std::max({std::fabs(h.normal.x), std::fabs(h.normal.y), std::fabs(h.normal.z)}) >= 1.0 &&
         std::fabs(signed_excess(h, corner)) < 1e-12;
}

/// How far a half-space keeps from its segment where the obstacle it is made for leaves so much room: it grows with the
/// room, so that the nearest obstacle bounds all.
inline double promised_margin(double room, double cell) {
  return std::min(room, std::max(tern::kSightMargin * cell, std::min(0.5 * room, 0.25)));
}

/// Unit normals, the segment inside, the boundary kept, and the promised distance between planes and segment.
inline void expect_holds_segment(const tern::Grid& grid, const tern::Polyhedron& polyhedron, double clearance) {
  const double room = clearance - grid.spec().radius;
  const double margin = promised_margin(room, grid.spec().cell);
  const tern::Box boundary = grid.local_boundary();
  ASSERT_LE(polyhedron.count, tern::kMaxPlanes);
  for (int p = 0; p < polyhedron.count; ++p) {
    const tern::Halfspace& h = polyhedron.planes[p];
    ASSERT_NEAR(norm3(h.normal), 1.0, 1e-12);
    const double excess = std::max(signed_excess(h, polyhedron.from), signed_excess(h, polyhedron.to));
    ASSERT_LE(excess, 1e-12);
    // The segment may lie in the boundary.
    if (!is_face_of(h, boundary)) {
      ASSERT_LE(excess, -margin + 1e-9);
    }
  }
  for (const tern::Vec3& v : vertices_of(polyhedron)) {
    ASSERT_GE(std::min({v.x - boundary.lower.x, v.y - boundary.lower.y, v.z - boundary.lower.z}), -1e-6);
    ASSERT_GE(std::min({boundary.upper.x - v.x, boundary.upper.y - v.y, boundary.upper.z - v.z}), -1e-6);
  }
}

/// How far the half-spaces other than `index` reach beyond it, in metres, by listing their corners: negative where they
/// keep short of it, 1e3 or so where nothing else bounds them on that side.
inline double reach_beyond(const tern::Polyhedron& polyhedron, int index) {
  // Around the segment, so that coordinates are small, in a box much larger than any polyhedron.
  std::vector<tern::Halfspace> planes;
  for (int p = 0; p < polyhedron.count; ++p) {
    if (p == index) continue;
    planes.push_back({polyhedron.planes[p].normal, -signed_excess(polyhedron.planes[p], polyhedron.from)});
  }
  for (int a = 0; a < 3; ++a) {
    const tern::Vec3 n{a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0};
    planes.push_back({n, 1e3});
    planes.push_back({{-n.x, -n.y, -n.z}, 1e3});
  }
  double reach = -1e9;
  for (const tern::Vec3& v : corners_of(planes, 1e-10))
    reach = std::max(reach, dot3(polyhedron.planes[index].normal, v));
  return reach + signed_excess(polyhedron.planes[index], polyhedron.from);
}

/// No half-space of the polyhedron follows from the others.
inline void expect_no_redundancy(const tern::Polyhedron& polyhedron) {
  for (int p = 0; p < polyhedron.count; ++p) ASSERT_GT(reach_beyond(polyhedron, p), 0.0) << "half-space " << p;
}

}  // namespace tern_test

#endif
