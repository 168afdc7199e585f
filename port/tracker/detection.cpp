// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_tracker/detection.hpp"

#include <algorithm>
#include <cmath>

namespace tern_tracker {
namespace {

bool stands(tern::TrackClass kind) {
  return kind == tern::TrackClass::kPerson || kind == tern::TrackClass::kCyclist || kind == tern::TrackClass::kCar ||
         kind == tern::TrackClass::kTruck;
}

struct Heights {
  double low, high;
};

/// All heights that a thing of this class may reach of which this much is seen, m.
Heights heights_of(const Cluster& cluster, tern::TrackClass kind, const tern::Track& bounds, double ground) {
  const double tallest = bounds.shape == tern::TrackShape::kBall ? 2.0 * bounds.radius : 2.0 * bounds.half.z;
  const double bottom = cluster.center.z - cluster.half.z, top = cluster.center.z + cluster.half.z;
  if (stands(kind) && std::isfinite(ground)) return {std::min(ground, bottom), std::max(ground + tallest, top)};
  return {std::min(top - tallest, bottom), std::max(bottom + tallest, top)};
}

}  // namespace

tern_onboard::Sighting detection_of(const Cluster& cluster, const tern::Vec3& eye, tern::TrackClass kind,
                                    const DetectionSettings& settings) {
  tern::Track bounds;
  tern::track_of_class(kind, bounds);
  const Heights heights = heights_of(cluster, kind, bounds, settings.ground);
  const double far = std::hypot(cluster.center.x - eye.x, cluster.center.y - eye.y);
  const double x = far > 0.0 ? (cluster.center.x - eye.x) / far : 0.0,
               y = far > 0.0 ? (cluster.center.y - eye.y) / far : 0.0;
  const double deep = std::abs(x) * cluster.half.x + std::abs(y) * cluster.half.y,
               wide = std::abs(y) * cluster.half.x + std::abs(x) * cluster.half.y;
  const double behind = std::max(0.0, bounds.radius - deep);
  tern_onboard::Sighting detection;
  detection.kind = kind;
  detection.position = {cluster.center.x + behind * x, cluster.center.y + behind * y,
                        0.5 * (heights.low + heights.high)};
  detection.deviation = settings.deviation;
  detection.error = std::max(0.0, bounds.radius - wide);
  detection.radius = std::max(bounds.radius, std::hypot(cluster.half.x, cluster.half.y));
  detection.half_height = 0.5 * (heights.high - heights.low);
  return detection;
}

}  // namespace tern_tracker
