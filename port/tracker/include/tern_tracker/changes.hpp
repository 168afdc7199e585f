// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What changed in a map: what a frame or a scan hits where the map has seen free space. No heap; every loop has a
// bound.
#ifndef TERN_TRACKER_CHANGES_HPP
#define TERN_TRACKER_CHANGES_HPP

#include <limits>

#include "tern/map.hpp"
#include "tern_tracker/clusters.hpp"

namespace tern_tracker {

/// Errors of more voxels than this are too large: nothing is a change then.
constexpr int kMostErrorVoxels = 4;

/// True if the map has seen free all voxels within `error` of `point`, axis by axis; world frame, m. What stands still
/// is in none of them. So if a hit is off by at most `error`, it is of something that moves, or that was put there.
/// False while the map slides.
bool is_change(const tern::RollingMap& map, const tern::Vec3& point, double error);

/// Adds the changes that an image shows, as RollingMap::begin_frame() gets it, within the map's range. A pixel's error
/// is that of depth and pose which MapSpec states, and half the pixel's diagonal. To be called before the next slide of
/// the map. The first status that is not kOk; the other points are added all the same. kInvalidArgument without an
/// image. `ground`: what is within its error of this height, m, or below it, is no change: assume_free() may have
/// stated that the ground is free. Minus infinity: not known.
ClusterStatus add_changes(const tern::RollingMap& map, const tern::DepthView& view, const tern::Pose& pose,
                          Clusters& clusters, double ground = -std::numeric_limits<double>::infinity());
/// The same of a scan. What a beam shows is taken to be within 0.36 MapSpec::scan_pixel of it: half the diagonal
/// between beams that are half a scan_pixel apart.
ClusterStatus add_changes(const tern::RollingMap& map, const tern::Beams& beams, const tern::Vec3& origin,
                          Clusters& clusters, double ground = -std::numeric_limits<double>::infinity());

}  // namespace tern_tracker

#endif
