// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/track_sample.hpp"

#include <algorithm>
#include <cmath>

#include "host/nanoseconds.hpp"
#include "host/things/surface_distance.hpp"

namespace tern_host {
namespace {

using tern::Track;
using tern::TrackEnd;
using tern::TrackShape;
using tern::Vec3;

constexpr double kFullTurn = 6.283185307179586;
constexpr int kAround = 24;
constexpr int kUp = 8;

Vec3 on_piece(const tern::TrackPiece& piece, double u) {
  Vec3 points[tern::kControlPoints];
  std::copy(std::begin(piece.points), std::end(piece.points), points);
  for (int last = tern::kDegree; last > 0; --last) {
    for (int i = 0; i < last; ++i) {
      const Vec3& a = points[i];
      const Vec3& b = points[i + 1];
      points[i] = {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y), a.z + u * (b.z - a.z)};
    }
  }
  return points[0];
}

/// Relative to Track::position, `since` seconds after it was measured.
Vec3 way_of(const Track& track, double since) {
  const Vec3& v = track.velocity;
  if (track.piece_count == 0) return {since * v.x, since * v.y, since * v.z};
  for (int p = 0; p < track.piece_count; ++p) {
    const tern::TrackPiece& piece = track.pieces[p];
    if (since < piece.duration) return on_piece(piece, since / piece.duration);
    since -= piece.duration;
  }
  return on_piece(track.pieces[track.piece_count - 1], 1.0);
}

Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

TrackSample on_curve(const Track& track, double time) {
  const double since = time - seconds_of(track.measured);
  const double known_for = seconds_of(track.until - track.measured);
  const bool is_over = track.end != TrackEnd::kGoesOn && since > known_for;
  TrackSample sample;
  sample.is_there = since >= 0.0 && !(is_over && track.end == TrackEnd::kGone);
  const double known = is_over ? known_for : since;
  const double growth = is_over && track.end == TrackEnd::kReach ? track.reach * (since - known) : 0.0;
  sample.place = sum(track.position, way_of(track, known));
  sample.error = track.error + known * (track.error_speed + 0.5 * track.error_growth * known) + growth;
  return sample;
}

/// Where it was measured, and how far it may have gone since.
TrackSample within_reach(const Track& track, double time) {
  const double since = time - seconds_of(track.measured);
  return {since >= 0.0, sum(track.position, way_of(track, 0.0)), track.error + track.reach * since};
}

}  // namespace

TrackSample sample_of(const Track& track, double time) {
  const TrackSample sample = on_curve(track, time);
  if (!(track.reach > 0.0)) return sample;
  TrackSample reached = within_reach(track, time);
  reached.is_there = sample.is_there;
  return reached.error < sample.error ? reached : sample;
}

double tube_gap(const Track& track, double time, const Vec3& point) {
  const auto gap = [&](const TrackSample& at) { return surface_distance(track, at.place, point) - at.error; };
  const TrackSample sample = on_curve(track, time);
  if (!sample.is_there) return HUGE_VAL;
  return track.reach > 0.0 ? std::fmax(gap(sample), gap(within_reach(track, time))) : gap(sample);
}

std::vector<Vec3> surface_of(const Track& track, const TrackSample& sample) {
  const Vec3& c = sample.place;
  const double e = sample.error;
  std::vector<Vec3> points;
  if (track.shape == TrackShape::kBox) {
    const Vec3 half{track.half.x + e, track.half.y + e, track.half.z + e};
    for (int k = 0; k < 8; ++k) {
      points.push_back(
          {c.x + (k & 1 ? half.x : -half.x), c.y + (k & 2 ? half.y : -half.y), c.z + (k & 4 ? half.z : -half.z)});
    }
    return points;
  }
  const bool is_ball = track.shape == TrackShape::kBall;
  const double radius = track.radius + e;
  for (int k = 0; k <= kUp; ++k) {
    const double tilt = 0.5 * kFullTurn * (static_cast<double>(k) / kUp - 0.5);
    const double across = is_ball ? radius * std::cos(tilt) : radius;
    const double up = is_ball ? radius * std::sin(tilt) : (2.0 * k / kUp - 1.0) * (track.half.z + e);
    for (int i = 0; i < kAround; ++i) {
      const double angle = kFullTurn * i / kAround;
      points.push_back({c.x + across * std::cos(angle), c.y + across * std::sin(angle), c.z + up});
    }
  }
  return points;
}

}  // namespace tern_host
