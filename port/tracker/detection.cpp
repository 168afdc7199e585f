// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_tracker/detection.hpp"

#include <algorithm>
#include <cmath>

namespace tern_tracker {

tern_onboard::Sighting detection_of(const Cluster& cluster, const tern::Vec3& eye, tern::TrackClass kind,
                                    double deviation) {
  tern::Track bounds;
  tern::track_of_class(kind, bounds);
  const double tallest = bounds.shape == tern::TrackShape::kBall ? 2.0 * bounds.radius : 2.0 * bounds.half.z;
  const double far = std::hypot(cluster.center.x - eye.x, cluster.center.y - eye.y);
  const double x = far > 0.0 ? (cluster.center.x - eye.x) / far : 0.0,
               y = far > 0.0 ? (cluster.center.y - eye.y) / far : 0.0;
  const double deep = std::abs(x) * cluster.half.x + std::abs(y) * cluster.half.y,
               wide = std::abs(y) * cluster.half.x + std::abs(x) * cluster.half.y;
  const double behind = std::max(0.0, bounds.radius - deep);
  tern_onboard::Sighting detection;
  detection.kind = kind;
  detection.position = {cluster.center.x + behind * x, cluster.center.y + behind * y, cluster.center.z};
  detection.deviation = deviation;
  detection.error = std::max(0.0, bounds.radius - wide);
  detection.radius = std::max(bounds.radius, std::hypot(cluster.half.x, cluster.half.y));
  detection.half_height = std::max(tallest - cluster.half.z, cluster.half.z);
  return detection;
}

}  // namespace tern_tracker
