// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_traffic.hpp"

#include <algorithm>
#include <utility>

#include "host/flight/vectors.hpp"

namespace tern_host {
namespace {

/// Between a place and the points of a track, m.
double distance_to_track(const tern::Track& track, const tern::Vec3& place) {
  double nearest = distance_between(track.position, place);
  for (std::int32_t p = 0; p < track.piece_count; ++p) {
    for (const tern::Vec3& point : track.pieces[p].points) {
      nearest = std::min(nearest, distance_between(along(track.position, 1.0, point), place));
    }
  }
  return nearest;
}

/// A member numbers its plans anew in each.
std::uint32_t incarnation_of(const tern::Fleet& fleet, std::uint32_t id) {
  for (std::int32_t k = 0; k < fleet.neighbours(); ++k) {
    const tern::Neighbour other = fleet.neighbour(k);
    if (other.id == id) return other.incarnation;
  }
  return 0;
}

}  // namespace

/// Takes all that the fleet has to say, with more room if it does not fit.
void SwarmTraffic::ask(const tern::Fleet& fleet, std::int64_t time) {
  tracks_.resize(2 * static_cast<std::size_t>(fleet.neighbours()));
  while (fleet.traffic(time, tracks_.data(), static_cast<std::int32_t>(tracks_.size()), pieces_.data(),
                       static_cast<std::int32_t>(pieces_.size()), count_) == tern::Status::kTrackPiecesFull) {
    pieces_.resize(2 * pieces_.size());
  }
}

/// What the flight is to know, by id: an even one for the plan that a member flies, the next one for the plan that it
/// announced.
std::map<std::uint32_t, SwarmTraffic::Told> SwarmTraffic::choose(const tern::Fleet& fleet,
                                                                 const tern::Vec3& place) const {
  std::vector<std::pair<double, std::int32_t>> order;
  for (std::int32_t k = 0; k < count_; ++k) {
    order.emplace_back(distance_to_track(tracks_[static_cast<std::size_t>(k)], place), k);
  }
  std::sort(order.begin(), order.end());
  std::map<std::uint32_t, Told> chosen;
  std::int32_t pieces = 0;
  for (const auto& [distance, k] : order) {
    const tern::Track& track = tracks_[static_cast<std::size_t>(k)];
    const bool is_second = k > 0 && tracks_[static_cast<std::size_t>(k) - 1].id == track.id;
    pieces += track.piece_count;
    if (chosen.size() == tern::kMaxFlightTracks || pieces > tern::kMaxTrackPieces) break;
    const std::uint64_t plan = (std::uint64_t{incarnation_of(fleet, track.id)} << 32) + track.kind + 1;
    chosen[2 * track.id + (is_second ? 1 : 0)] = {&track, plan};
  }
  return chosen;
}

int SwarmTraffic::tell(const tern::Fleet& fleet, tern::Flight& flight, const tern::Vec3& place, std::int64_t time) {
  ask(fleet, time);
  const std::map<std::uint32_t, Told> chosen = choose(fleet, place);
  for (auto at = known_.begin(); at != known_.end();) {
    const bool stays = chosen.count(at->first) != 0;
    if (!stays) flight.forget_track(at->first);
    at = stays ? std::next(at) : known_.erase(at);
  }
  int told = 0;
  for (const auto& [id, news] : chosen) {
    std::uint64_t& plan = known_[id];
    if (plan != news.plan) {
      flight.forget_track(id);
      tern::Track track = *news.track;
      track.id = id;
      // A place at rest is measured now. A flight takes nothing from more than a tick after its last one, which is
      // where a late tick begins.
      if (track.piece_count == 0) track.measured = std::min(track.measured, last_tick_ + tick_);
      plan = flight.update_track(track) == tern::Status::kOk ? news.plan : 0;  // 0: told again in the next tick
    }
    told += plan != 0 ? 1 : 0;
  }
  last_tick_ = time;
  return count_ - told;
}

}  // namespace tern_host
