// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/conflicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host/airspace/airspace.hpp"
#include "host/airspace/zone_fences.hpp"
#include "host/intent/convex_gap.hpp"

namespace tern_host {
namespace {

/// Outlines become polygons that are off by no more than this, so that two of them are off by a centimetre at most.
constexpr double kLooseness = 0.004;
/// How far one's own outlines may reach beyond the area that others' are cut to, metres.
constexpr double kAround = 1.0;
constexpr double kLowest = -1e5, kHighest = 1e6;

/// A volume's outline as convex polygons, and what it spans.
struct Shape {
  std::vector<PlanPolygon> pieces;
  double off = 0.0;
};

double low_of(const Zone& zone) {
  return zone.lower ? zone.lower->metres : -std::numeric_limits<double>::infinity();
}

double high_of(const Zone& zone) {
  return zone.upper ? zone.upper->metres : std::numeric_limits<double>::infinity();
}

bool same_time_and_height(const Zone& a, const Zone& b) {
  const TimeSpan s = span_of(a), t = span_of(b);
  return s.from <= t.until && t.from <= s.until && low_of(a) <= high_of(b) && low_of(b) <= high_of(a);
}

/// Compares volumes in one frame.
class Comparison {
 public:
  Comparison(const UtmEntity& own, const std::vector<UtmEntity>& others, const LocalFrame& frame)
      : own_(own), others_(others), frame_(frame), heights_({frame.origin().point, 0.0}, {}) {
    fit_.clearance = 0.0;
    fit_.looseness = kLooseness;
    find_boundary();
  }

  std::vector<Conflict> run() {
    for (std::size_t i = 0; i < own_.volumes.size(); ++i) own_shapes_.push_back(shape_of(own_.volumes[i]));
    for (std::size_t i = 0; i < others_.size(); ++i) {
      if (others_[i].id != own_.id) compare_with(i);
    }
    std::stable_sort(out_.begin(), out_.end(),
                     [](const Conflict& a, const Conflict& b) { return a.volume < b.volume; });
    return std::move(out_);
  }

 private:
  /// All of one's own outlines, by their corners; a circle is within a square.
  void find_boundary() {
    tern::Box box{{HUGE_VAL, HUGE_VAL, kLowest}, {-HUGE_VAL, -HUGE_VAL, kHighest}};
    const auto add = [&box](const Plan2& p, double by) {
      box.lower = {std::min(box.lower.x, p.east - by), std::min(box.lower.y, p.north - by), box.lower.z};
      box.upper = {std::max(box.upper.x, p.east + by), std::max(box.upper.y, p.north + by), box.upper.z};
    };
    for (const Zone& zone : own_.volumes) {
      for (const GeoPoint& corner : zone.areas[0].ring) add(frame_.plan(corner), kAround);
      if (zone.areas[0].radius > 0.0) add(frame_.plan(zone.areas[0].centre), zone.areas[0].radius + kAround);
    }
    fit_.boundary = box;
    check_fit(fit_);
  }

  Shape shape_of(const Zone& zone) const {
    try {
      const FittedZone fitted = fit_zone(zone, heights_, fit_);
      Shape shape{{}, fitted.off};
      for (const FittedFence& fence : fitted.fences) shape.pieces.push_back(fence.outline);
      return shape;
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(printable(zone.name) + ", " + zone.place + ": " + error.what());
    }
  }

  void compare_with(std::size_t index) {
    const UtmEntity& other = others_[index];
    for (std::size_t j = 0; j < other.volumes.size(); ++j) {
      const Zone& zone = other.volumes[j];
      const auto meets = [&zone](const Zone& own) { return same_time_and_height(own, zone); };
      if (std::none_of(own_.volumes.begin(), own_.volumes.end(), meets)) continue;
      const Shape shape = shape_of(zone);
      for (std::size_t i = 0; i < own_.volumes.size(); ++i) {
        if (meets(own_.volumes[i])) compare(i, index, j, shape);
      }
    }
  }

  void compare(std::size_t i, std::size_t index, std::size_t j, const Shape& shape) {
    const double touching = std::max(kTouching, own_shapes_[i].off + shape.off);
    for (const PlanPolygon& a : own_shapes_[i].pieces) {
      for (const PlanPolygon& b : shape.pieces) {
        if (gap_between(a, b) > touching) continue;
        const ConvexPiece::Vertex at = common_place(a, b);
        out_.push_back(conflict(i, index, j, frame_.point({at.x, at.y})));
        return;
      }
    }
  }

  Conflict conflict(std::size_t i, std::size_t index, std::size_t j, const GeoPoint& place) const {
    const Zone& a = own_.volumes[i];
    const Zone& b = others_[index].volumes[j];
    const TimeSpan s = span_of(a), t = span_of(b);
    const bool binding = others_[index].kind == EntityKind::kConstraint || others_[index].priority >= own_.priority;
    return {i,
            index,
            j,
            {std::max(s.from, t.from), std::min(s.until, t.until)},
            std::max(low_of(a), low_of(b)),
            std::min(high_of(a), high_of(b)),
            place,
            binding};
  }

  const UtmEntity& own_;
  const std::vector<UtmEntity>& others_;
  const LocalFrame& frame_;
  const ZoneHeights heights_;
  FitSettings fit_{};
  std::vector<Shape> own_shapes_;
  std::vector<Conflict> out_;
};

}  // namespace

std::vector<Conflict> conflicts_of(const UtmEntity& own, const std::vector<UtmEntity>& others,
                                   const LocalFrame& frame) {
  return Comparison(own, others, frame).run();
}

bool has_binding(const std::vector<Conflict>& conflicts) {
  return std::any_of(conflicts.begin(), conflicts.end(), [](const Conflict& c) { return c.binding; });
}

}  // namespace tern_host
