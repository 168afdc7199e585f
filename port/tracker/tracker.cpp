// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_tracker/tracker.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "tracker/matching.hpp"

namespace tern_tracker {
namespace {

using tern_onboard::Sighting;

constexpr double kLeastDeviation = 0.01;  // m: of a detection that claims to be exact
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min();
constexpr double kNewVariance = 1.0;  // m^2: where else a thing could be that is at the gate of a track

double seconds(std::int64_t ns) {
  return 1e-9 * static_cast<double>(ns);
}

Eigen::Vector3d place_of(const Sighting& sighting) {
  return {sighting.position.x, sighting.position.y, sighting.position.z};
}

tern::Track bounds_of(tern::TrackClass kind) {
  tern::Track bounds;
  tern::track_of_class(kind, bounds);
  return bounds;
}

}  // namespace

/// The three axes have the same covariance, of position and velocity, because detections have one deviation.
struct Tracker::Track {
  std::uint64_t number;
  Eigen::Matrix<double, 3, 2> state;  // m and m/s
  Eigen::Matrix2d covariance;
  std::array<int, tern::kTrackClasses> votes{};
  int hits = 1;
  std::int64_t seen = 0;

  tern::TrackClass kind() const {
    return static_cast<tern::TrackClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }
  void predict(double dt) {
    Eigen::Matrix2d step;
    step << 1.0, dt, 0.0, 1.0;
    const double strength = bounds_of(kind()).error_growth;
    const Eigen::Vector2d pushed = strength * Eigen::Vector2d(0.5 * dt * dt, dt);
    state.col(0) += dt * state.col(1);
    covariance = step * covariance * step.transpose() + pushed * pushed.transpose();
  }
  static double variance_of(const Sighting& detection) {
    const double deviation = std::max(detection.deviation, kLeastDeviation);
    return deviation * deviation;
  }
  /// How much likelier the detection is of this track than of a new one, as twice a logarithm; 0 beyond the gate. Of
  /// two tracks that are equally many deviations away, the one that knew better where it is gains more.
  double gain_of(const Sighting& detection, double gate) const {
    const double variance = covariance(0, 0) + variance_of(detection);
    const double distance = (place_of(detection) - state.col(0)).squaredNorm() / variance;
    return distance < gate * gate ? gate * gate - distance - 3.0 * std::log(variance / kNewVariance) : 0.0;
  }
  void take(const Sighting& detection, std::int64_t stamp) {
    const Eigen::Vector2d gain = covariance.col(0) / (covariance(0, 0) + variance_of(detection));
    state += (place_of(detection) - state.col(0)) * gain.transpose();
    covariance -= gain * covariance.row(0).eval();
    ++votes[static_cast<std::size_t>(detection.kind)];
    ++hits;
    seen = stamp;
  }
  Sighting sighting(const Sighting& detection) const {
    Sighting told = detection;
    told.name = "track " + std::to_string(number);
    told.kind = kind();
    told.stamp = seen;
    told.position = {state(0, 0), state(1, 0), state(2, 0)};
    told.has_velocity = true;
    told.velocity = {state(0, 1), state(1, 1), state(2, 1)};
    told.deviation = std::sqrt(covariance(0, 0));
    told.speed_deviation = std::sqrt(covariance(1, 1));
    return told;
  }
};

Tracker::Tracker(const TrackerSettings& settings) : settings_(settings), last_(kNever) {}

Tracker::~Tracker() = default;

void Tracker::restart() {
  tracks_.clear();
  last_ = kNever;
}

std::size_t Tracker::count() const {
  const auto is_confirmed = [this](const Track& track) { return track.hits >= settings_.hits; };
  return static_cast<std::size_t>(std::count_if(tracks_.begin(), tracks_.end(), is_confirmed));
}

std::vector<Sighting> Tracker::scan(std::int64_t stamp, const std::vector<Sighting>& detections) {
  if (stamp <= last_ && seconds(last_ - stamp) <= settings_.lost_after) return {};
  if (stamp <= last_) restart();  // the clock was set back
  end_lost(stamp);
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    tracks_[t].predict(seconds(stamp - last_));
    for (std::size_t d = 0; d < detections.size(); ++d) {
      const double gain = tracks_[t].gain_of(detections[d], settings_.gate);
      if (gain > 0.0) pairs.push_back({t, d, gain});
    }
  }
  last_ = stamp;
  const std::vector<std::size_t> matched = best_matching(tracks_.size(), detections.size(), pairs);
  std::vector<Sighting> told;
  std::vector<bool> is_taken(detections.size(), false);
  for (std::size_t t = 0; t < matched.size(); ++t) {
    if (matched[t] == kNoColumn) continue;
    is_taken[matched[t]] = true;
    tracks_[t].take(detections[matched[t]], stamp);
    if (tracks_[t].hits >= settings_.hits) told.push_back(tracks_[t].sighting(detections[matched[t]]));
  }
  for (std::size_t d = 0; d < detections.size(); ++d) {
    if (is_taken[d]) continue;
    begin(detections[d]);
    if (settings_.hits <= 1) told.push_back(tracks_.back().sighting(detections[d]));
  }
  return told;
}

void Tracker::end_lost(std::int64_t stamp) {
  const auto is_lost = [&](const Track& track) {
    const double patience = track.hits >= settings_.hits ? settings_.lost_after : settings_.confirm_within;
    return seconds(stamp - track.seen) > patience;
  };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), is_lost), tracks_.end());
}

/// Nothing is known of its velocity but its class's largest one, at two deviations.
void Tracker::begin(const Sighting& detection) {
  Track track;
  track.number = next_++;
  track.state << place_of(detection), Eigen::Vector3d::Zero();
  const double speed = 0.5 * bounds_of(detection.kind).reach;
  track.covariance << Track::variance_of(detection), 0.0, 0.0, speed * speed;
  track.votes[static_cast<std::size_t>(detection.kind)] = 1;
  track.seen = last_;
  tracks_.push_back(track);
}

}  // namespace tern_tracker
