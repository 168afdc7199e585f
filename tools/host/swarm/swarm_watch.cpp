// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_watch.hpp"

#include <algorithm>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"

namespace tern_host {
namespace {

/// What is nearer than a body's size by less than this is not counted: proofs round.
constexpr double kTouch = 1e-6;
/// Time is not halved below this, ns.
constexpr std::int64_t kShortest = 1000;
/// What is slower rests, m/s; and how long that is looked at, ns.
constexpr double kMoving = 1e-3;
constexpr std::int64_t kGlance = 100000;

/// Calls `far(t)`, which says how far a distance at an instant is above what is needed, until no instant between the
/// two can be below 0 at this closing speed, or one is. Halves, at most 40 deep.
template <typename Far>
bool stays_clear(Far far, double closing, std::int64_t from, std::int64_t until, int depth = 0) {
  const std::int64_t middle = from + (until - from) / 2;
  const double room = far(middle);
  if (room < -kTouch) return false;
  if (room > closing * 0.5e-9 * static_cast<double>(until - from)) return true;
  if (until - from < kShortest || depth > 40) return true;
  return stays_clear(far, closing, from, middle, depth + 1) && stays_clear(far, closing, middle, until, depth + 1);
}

}  // namespace

SwarmWatch::SwarmWatch(int vehicles, double body_radius, double top_speed, Position position, Clearance clearance)
    : vehicles_(vehicles),
      body_radius_(body_radius),
      top_speed_(top_speed),
      position_(std::move(position)),
      clearance_(std::move(clearance)) {}

void SwarmWatch::note(std::int64_t time, int i, int j, double distance, bool touches) {
  if (!touches) {
    touching_.erase({i, j});
  } else if (touching_.insert({i, j}).second) {
    contacts_.push_back({time, i, j, distance});
  }
}

void SwarmWatch::look_at_pair(int i, int j, std::int64_t from, std::int64_t until) {
  std::int64_t at = from;
  double nearest = 1e9;
  const auto far = [&](std::int64_t t) {
    const double d = distance_between(position_(i, t), position_(j, t));
    if (d < nearest) {
      nearest = d;
      at = t;
    }
    return d - 2.0 * body_radius_;
  };
  // Most pairs are too far apart for anything else to matter, and all share the places at the middle.
  const double apart = distance_between(middle_[static_cast<std::size_t>(i)], middle_[static_cast<std::size_t>(j)]);
  const bool is_far = apart - 2.0 * body_radius_ > top_speed_ * seconds_of(until - from);
  if (is_far) nearest = apart;
  const bool clear = is_far || stays_clear(far, 2.0 * top_speed_, from, until);
  least_distance_ = std::min(least_distance_, nearest);
  note(at, i, j, nearest, !clear);
}

void SwarmWatch::look_at_body(int i, std::int64_t from, std::int64_t until) {
  std::int64_t at = from;
  double nearest = 1e9;
  const auto far = [&](std::int64_t t) {
    const double d = clearance_(position_(i, t));
    if (d < nearest) {
      nearest = d;
      at = t;
    }
    return d - body_radius_;
  };
  const bool clear = stays_clear(far, top_speed_, from, until);
  least_clearance_ = std::min(least_clearance_, nearest);
  note(at, i, -1, nearest, !clear);
}

/// Around t, between two instants.
bool SwarmWatch::moves(int i, std::int64_t t, std::int64_t from, std::int64_t until) const {
  const std::int64_t a = std::max(from, t - kGlance / 2);
  const std::int64_t b = std::min(until, t + kGlance / 2);
  return distance_between(position_(i, a), position_(i, b)) > kMoving * seconds_of(b - a);
}

void SwarmWatch::look_at_intruder(int i, int k, std::int64_t from, std::int64_t until) {
  const WatchedIntruder& intruder = intruders_[static_cast<std::size_t>(k)];
  const double size = body_radius_ + intruder.radius;
  std::int64_t at = from + (until - from) / 2;
  double nearest = 1e9;
  const auto far = [&](std::int64_t t) {
    const double d = distance_between(position_(i, t), intruder.position(t));
    if (d < nearest) {
      nearest = d;
      at = t;
    }
    return d - size;
  };
  const bool clear = stays_clear(far, top_speed_ + intruder.top_speed, from, until);
  bool in_motion = nearest - size < least_gap_ && moves(i, at, from, until);
  if (in_motion) least_gap_ = nearest - size;
  if (clear) {
    resting_.erase({i, k});
    moving_.erase({i, k});
    return;
  }
  in_motion = moves(i, at, from, until);
  const SwarmContact contact{at, i, -1, nearest, k};
  for (std::int64_t t = from; t < until && !in_motion; t += kGlance)
    in_motion = far(t) < 0.0 && moves(i, t, from, until);
  if (in_motion && moving_.insert({i, k}).second) {
    contacts_.push_back(contact);
  } else if (!in_motion && moving_.count({i, k}) == 0 && resting_.insert({i, k}).second) {
    touched_at_rest_.push_back(contact);
  }
}

void SwarmWatch::look(std::int64_t from, std::int64_t until) {
  middle_.clear();
  for (int i = 0; i < vehicles_; ++i) middle_.push_back(position_(i, from + (until - from) / 2));
  for (int i = 0; i < vehicles_; ++i) {
    if (clearance_) look_at_body(i, from, until);
    for (int j = 0; j < i; ++j) look_at_pair(i, j, from, until);
    for (std::size_t k = 0; k < intruders_.size(); ++k) look_at_intruder(i, static_cast<int>(k), from, until);
  }
}

}  // namespace tern_host
