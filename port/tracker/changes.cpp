// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_tracker/changes.hpp"

#include <cmath>

#include "tern_onboard/pose.hpp"

namespace tern_tracker {
namespace {

using tern::Vec3;

constexpr double kBeamShows = 0.36;  // of a scan_pixel

/// A range of voxels along one axis; false if it is not in the window.
bool voxels_within(double at, double error, double origin, double cell, std::int32_t dim, std::int32_t& first,
                   std::int32_t& last) {
  const double low = std::floor((at - error - origin) / cell), high = std::floor((at + error - origin) / cell);
  if (!(low >= 0.0 && high < dim)) return false;
  first = static_cast<std::int32_t>(low);
  last = static_cast<std::int32_t>(high);
  return true;
}

/// A pose as begin_frame() takes it: its quaternion's length may be a little off.
tern::Pose with_unit_quaternion(const tern::Pose& pose) {
  tern::Pose unit = pose;
  double square = 0.0;
  for (const double q : pose.quaternion) square += q * q;
  for (double& q : unit.quaternion) q /= std::sqrt(square);
  return unit;
}

Vec3 along(const Vec3& from, double way, const Vec3& direction) {
  return tern_onboard::plus(from, tern_onboard::times(direction, way));
}

/// The depth of a pixel, m; 0 where it has none.
double depth_of(const tern::DepthView& view, std::int32_t u, std::int32_t v) {
  const auto pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(view.stride) + static_cast<std::size_t>(u);
  if (view.z16 != nullptr && view.z16[pixel] == 65535) return 0.0;
  const double depth = view.scale * (view.z16 != nullptr ? view.z16[pixel] : static_cast<double>(view.z32[pixel]));
  return depth > 0.0 && depth >= view.min && depth < view.max ? depth : 0.0;
}

double depth_error(const tern::MapSpec& spec, double depth) {
  return spec.depth_margin + spec.depth_margin_square * depth * depth;
}

/// Takes the points of a frame. The first status that was not kOk stays.
struct Frame {
  const tern::RollingMap& map;
  double ground;
  Clusters& clusters;
  ClusterStatus status = ClusterStatus::kOk;

  void add(const Vec3& point, double error) {
    if (point.z - error <= ground || !is_change(map, point, error)) return;
    const ClusterStatus added = clusters.add(point);
    if (status == ClusterStatus::kOk) status = added;
  }
};

}  // namespace

bool is_change(const tern::RollingMap& map, const Vec3& point, double error) {
  if (!map.bound() || !map.safe().bound()) return false;
  const tern::GridSpec& spec = map.safe().spec();
  if (!(error >= 0.0 && error <= kMostErrorVoxels * spec.cell)) return false;
  tern::Voxel first{}, last{};
  if (!voxels_within(point.x, error, spec.origin.x, spec.cell, spec.dims.x, first.x, last.x) ||
      !voxels_within(point.y, error, spec.origin.y, spec.cell, spec.dims.y, first.y, last.y) ||
      !voxels_within(point.z, error, spec.origin.z, spec.cell, spec.dims.z, first.z, last.z)) {
    return false;
  }
  for (std::int32_t z = first.z; z <= last.z; ++z) {
    for (std::int32_t y = first.y; y <= last.y; ++y) {
      for (std::int32_t x = first.x; x <= last.x; ++x) {
        if (!map.seen({x, y, z})) return false;
      }
    }
  }
  return true;
}

ClusterStatus add_changes(const tern::RollingMap& map, const tern::DepthView& view, const tern::Pose& pose,
                          Clusters& clusters, double ground) {
  if (!map.bound() || (view.z16 == nullptr) == (view.z32 == nullptr)) return ClusterStatus::kInvalidArgument;
  const tern::MapSpec& spec = map.spec();
  const double half_pixel = 0.5 * std::sqrt(1.0 / (view.fx * view.fx) + 1.0 / (view.fy * view.fy));
  const tern::Pose camera = with_unit_quaternion(pose);
  Frame frame{map, ground, clusters};
  for (std::int32_t v = 0; v < view.height; ++v) {
    for (std::int32_t u = 0; u < view.width; ++u) {
      const double depth = depth_of(view, u, v);
      if (!(depth > 0.0 && depth <= spec.range)) continue;
      const Vec3 ray{(u - view.cx) / view.fx, (v - view.cy) / view.fy, 1.0};
      const double longer = tern_onboard::length(ray);
      const double error =
          spec.pose_margin + longer * (depth_error(spec, depth) + spec.angle_margin * depth) + half_pixel * depth;
      frame.add(along(camera.position, depth, tern_onboard::turn(camera.quaternion, ray)), error);
    }
  }
  return frame.status;
}

ClusterStatus add_changes(const tern::RollingMap& map, const tern::Beams& beams, const Vec3& origin, Clusters& clusters,
                          double ground) {
  const bool there = beams.count == 0 || (beams.directions != nullptr && beams.ranges != nullptr);
  if (!map.bound() || !there) return ClusterStatus::kInvalidArgument;
  const tern::MapSpec& spec = map.spec();
  Frame frame{map, ground, clusters};
  for (std::size_t k = 0; k < beams.count; ++k) {
    const double range = static_cast<double>(beams.ranges[k]), norm = tern_onboard::length(beams.directions[k]);
    if (!(range > 0.0 && range >= beams.min && range < beams.max && range <= spec.range && norm > 0.0)) continue;
    const double error =
        spec.pose_margin + depth_error(spec, range) + (spec.angle_margin + kBeamShows * spec.scan_pixel) * range;
    frame.add(along(origin, range / norm, beams.directions[k]), error);
  }
  return frame.status;
}

}  // namespace tern_tracker
