// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ellipsoid and polyhedron of one segment as the paper describes them (Section 3.3.1): obstacles are points, and every
// look at one is counted.
#ifndef TERN_BENCH_PAPER_CORRIDOR_HPP
#define TERN_BENCH_PAPER_CORRIDOR_HPP

#include <cstdint>
#include <vector>

#include "baselines/paper_map.hpp"
#include "tern/corridor.hpp"

namespace tern_bench {

/// Centres of the map's obstacle voxels that have a free or outer face.
std::vector<tern::Vec3> surface_points(const PaperMap& map);

struct PaperPolyhedron {
  std::vector<tern::Halfspace> planes;  ///< one a tangent point; without the faces of any box
  double semi_axes[3];                  ///< of the ellipsoid: along the segment, then the two across, metres
  std::uint64_t checks = 0;             ///< times that an obstacle point was looked at
  int shrinks = 0;                      ///< times that the ellipsoid was made smaller
};

/// A sphere over the segment shrinks at its nearest point until it is empty, is stretched again along its third axis as
/// far as that goes, and then grows: each point that it meets gives a tangent plane and takes all points beyond that
/// away. Only points within `box_margin` metres (max norm) of the segment's bounding box are looked at after a first
/// pass over all of them; infinite: no bounding box. A segment shorter than a nanometre gives no planes.
PaperPolyhedron grow_paper_polyhedron(const tern::Vec3& from, const tern::Vec3& to,
                                      const std::vector<tern::Vec3>& points, double box_margin);

}  // namespace tern_bench

#endif
