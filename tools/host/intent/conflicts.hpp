// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where volumes of two entities of UTM meet, in time, height and outline.
#ifndef TERN_HOST_INTENT_CONFLICTS_HPP
#define TERN_HOST_INTENT_CONFLICTS_HPP

#include <vector>

#include "host/airspace/f3548.hpp"
#include "host/airspace/zone_heights.hpp"

namespace tern_host {

/// Outlines that are no farther apart than this count as touching, metres. Some that are up to this much farther apart
/// count, too, because circles are polygons here.
constexpr double kTouching = 0.01;

/// A volume of one's own and one of another's that have a place and an instant in common, or touch.
struct Conflict {
  std::size_t volume;        ///< of one's own
  std::size_t other;         ///< index of the other entity
  std::size_t other_volume;  ///< of its volumes
  TimeSpan span;             ///< while both hold
  double low;                ///< heights that both have, m above the ellipsoid
  double high;
  GeoPoint place;  ///< in both outlines, or where they touch
  bool binding;    ///< the other is a constraint, or an intent of no less priority: the own one must give way
};

/// All of them, in the order of one's own volumes. Another entity with the same id is an earlier version of one's own,
/// and left out. Throws std::invalid_argument where a volume cannot be read (`fit_zone`), or one's own is farther from
/// the frame's origin than that is good for.
std::vector<Conflict> conflicts_of(const UtmEntity& own, const std::vector<UtmEntity>& others, const LocalFrame& frame);

bool has_binding(const std::vector<Conflict>& conflicts);

}  // namespace tern_host

#endif
