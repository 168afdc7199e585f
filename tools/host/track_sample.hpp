// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where things that move are thought to be, for pictures. Nothing is proven with it.
#ifndef TERN_HOST_TRACK_SAMPLE_HPP
#define TERN_HOST_TRACK_SAMPLE_HPP

#include <vector>

#include "tern/track.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// A thing at a time.
struct TrackSample {
  bool is_there = false;
  tern::Vec3 place{};  ///< of its centre, world frame
  double error = 0.0;  ///< m; with a reach, that of the smaller tube
};

/// `time`: s of the clock that the track is on.
TrackSample sample_of(const tern::Track& track, double time);

/// How far a point is outside of a thing's tube, m; negative inside. With a reach, what is outside of one of its two
/// tubes is outside. Infinite while the thing is not there.
double tube_gap(const tern::Track& track, double time, const tern::Vec3& point);

/// Points on the surface of the shape about a place, grown by the error: its corners, or points on its rims or all
/// round.
std::vector<tern::Vec3> surface_of(const tern::Track& track, const TrackSample& sample);

}  // namespace tern_host

#endif
