// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/others_fences.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/airspace/airspace.hpp"
#include "host/airspace/zone_fences.hpp"
#include "host/intent/conflicts.hpp"
#include "host/intent/outer_outline.hpp"

namespace tern_host {
namespace {

/// Fences have few sides, for which they may be this much wider, metres.
constexpr std::size_t kFewSides = 4;
constexpr double kMostWider = 5.0;
/// Times of volumes are rounded to milliseconds at both ends, seconds.
constexpr double kRounded = 0.002;

/// What to add to a volume, so that a way that is clear of the sum has volumes that are clear of the volume. A volume
/// of a way reaches no farther than the radius and the looseness beyond some place of it; all places of a column are
/// within a looseness of each other, and all heights of any other volume.
struct Growth {
  double around;
  double upwards;
  double seconds;
};

Growth growth_of(const OwnFlight& own, const TubeSettings& tube) {
  return {own.clearance + 2.0 * tube.looseness + kTouching, own.clearance + tube.looseness + kTouching,
          tube.longest + tube.clock_error + kRounded};
}

std::vector<tern::Halfspace> sides_of(const PlanPolygon& outline, double by) {
  std::vector<tern::Halfspace> planes;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ConvexPiece::Vertex& a = outline[i];
    const ConvexPiece::Vertex& b = outline[(i + 1) % outline.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const tern::Vec3 normal{(b.y - a.y) / length, (a.x - b.x) / length, 0.0};
    planes.push_back({normal, normal.x * a.x + normal.y * a.y + by});
  }
  return planes;
}

/// Makes fences of one volume after the other.
class OthersFences {
 public:
  OthersFences(const OwnFlight& own, const LocalFrame& frame, const TubeSettings& tube, FenceHeights heights)
      : growth_(growth_of(own, tube)), epoch_(tube.epoch), heights_(heights), zone_heights_(frame.origin(), {}) {
    const double by = growth_.around;
    fit_.boundary = {{own.boundary.lower.x - by, own.boundary.lower.y - by, own.boundary.lower.z - growth_.upwards},
                     {own.boundary.upper.x + by, own.boundary.upper.y + by, own.boundary.upper.z + growth_.upwards}};
    fit_.clearance = own.clearance;
    check_fit(fit_);
  }

  void add(const Zone& volume) {
    try {
      const FittedZone fitted = fit_zone(volume, zone_heights_, fit_);
      for (const FittedFence& fence : fitted.fences) out_.push_back(record_of(fence, fitted.off, volume));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(printable(volume.name) + ", " + volume.place + ": " + error.what());
    }
  }

  std::vector<FenceRecord> take() { return std::move(out_); }

 private:
  FenceRecord record_of(const FittedFence& fence, double off, const Zone& volume) const {
    FenceRecord record;
    record.fence.kind = tern::FenceKind::kKeepOut;
    record.key = "volume of " + volume.name;
    record.planes = sides_of(outer_outline(fence.outline, kFewSides, kMostWider), growth_.around + off);
    if (heights_ == FenceHeights::kAsTheyAre) {
      if (std::isfinite(fence.top)) record.planes.push_back({{0.0, 0.0, 1.0}, fence.top + growth_.upwards});
      if (std::isfinite(fence.bottom)) record.planes.push_back({{0.0, 0.0, -1.0}, -fence.bottom + growth_.upwards});
    }
    const TimeSpan span = span_of(volume);
    record.fence.from = span.from - epoch_;
    record.fence.until = span.until - epoch_;
    record.fence.clock_error = growth_.seconds;
    return record;
  }

  Growth growth_;
  Instant epoch_;
  FenceHeights heights_;
  ZoneHeights zone_heights_;
  FitSettings fit_{};
  std::vector<FenceRecord> out_;
};

}  // namespace

std::vector<FenceRecord> others_fences(const std::vector<UtmEntity>& others, const OwnFlight& own,
                                       const LocalFrame& frame, const TubeSettings& tube, FenceHeights heights) {
  OthersFences fences(own, frame, tube, heights);
  for (const UtmEntity& other : others) {
    const bool binds = other.kind == EntityKind::kConstraint || other.priority >= own.priority;
    if (!binds || other.id == own.id) continue;
    for (const Zone& volume : other.volumes) fences.add(volume);
  }
  return fences.take();
}

}  // namespace tern_host
