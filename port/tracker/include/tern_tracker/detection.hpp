// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRACKER_DETECTION_HPP
#define TERN_TRACKER_DETECTION_HPP

#include <limits>

#include "tern/track_class.hpp"
#include "tern/vec3.hpp"
#include "tern_onboard/sighting.hpp"
#include "tern_tracker/clusters.hpp"

namespace tern_tracker {

struct DetectionSettings {
  double deviation = 0.05;  ///< m: the standard one of the centre, along each axis
  /// m: the height of the ground, on which people and vehicles stand. Minus infinity: not known.
  double ground = -std::numeric_limits<double>::infinity();
};

/// A detection for Tracker::scan(): the thing of this class of which a sensor at `eye` sees a cluster. World frame, m.
/// A sensor sees the near side of a thing, perhaps not its whole width, and not all of its height. So the detection is
/// placed as deep behind the nearest point as the class's radius. Its error is what the class may be wider than the
/// cluster, and its height spans all heights that such a thing may reach: from the ground, if it stands there. Where
/// the cluster is larger than its class, so is the detection.
tern_onboard::Sighting detection_of(const Cluster& cluster, const tern::Vec3& eye, tern::TrackClass kind,
                                    const DetectionSettings& settings = {});

}  // namespace tern_tracker

#endif
