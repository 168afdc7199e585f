// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_traffic.hpp"

#include <algorithm>
#include <utility>

#include "host/flight/flight_world.hpp"
#include "host/flight/vectors.hpp"

namespace tern_host {
namespace {

/// How old the boxes around plans may be, ns: what was flown since is still in them.
constexpr std::int64_t kLookAgain = 500000000;

/// Around all points of a track.
tern::Box box_around(const tern::Track& track) {
  tern::Box box{track.position, track.position};
  if (track.piece_count > 0) box.lower = box.upper = along(track.position, 1.0, track.pieces[0].points[0]);
  for (std::int32_t p = 0; p < track.piece_count; ++p) {
    for (const tern::Vec3& offset : track.pieces[p].points) {
      const tern::Vec3 point = along(track.position, 1.0, offset);
      box.lower = {std::min(box.lower.x, point.x), std::min(box.lower.y, point.y), std::min(box.lower.z, point.z)};
      box.upper = {std::max(box.upper.x, point.x), std::max(box.upper.y, point.y), std::max(box.upper.z, point.z)};
    }
  }
  return box;
}

bool is_same(const tern::Neighbour& a, const tern::Neighbour& b) {
  return a.id == b.id && a.incarnation == b.incarnation && a.flies == b.flies && a.may_fly == b.may_fly;
}

}  // namespace

/// The tracks of one member, with more room if they do not fit. Returns how many there are.
std::int32_t SwarmTraffic::read(const tern::Fleet& fleet, std::int32_t index, std::int64_t time) {
  std::int32_t count = 0;
  while (fleet.traffic_of(index, time, tracks_, 2, pieces_.data(), static_cast<std::int32_t>(pieces_.size()), count) ==
         tern::Status::kTrackPiecesFull) {
    pieces_.resize(2 * pieces_.size());
  }
  return count;
}

void SwarmTraffic::look(const tern::Fleet& fleet, std::int32_t index, std::int64_t time) {
  Other& other = others_[static_cast<std::size_t>(index)];
  other.looked = time;
  other.plans[0] = other.plans[1] = Plan{};
  const std::int32_t count = read(fleet, index, time);
  for (std::int32_t k = 0; k < count; ++k) {
    other.plans[k] = {tracks_[k].kind, tracks_[k].piece_count, box_around(tracks_[k])};
  }
}

/// Looks at what is new. Returns how many plans there are.
int SwarmTraffic::ask(const tern::Fleet& fleet, std::int64_t time) {
  others_.resize(static_cast<std::size_t>(fleet.neighbours()));
  int count = 0;
  for (std::size_t k = 0; k < others_.size(); ++k) {
    const tern::Neighbour now = fleet.neighbour(static_cast<std::int32_t>(k));
    const bool is_new = !is_same(now, others_[k].neighbour) || time - others_[k].looked > kLookAgain;
    others_[k].neighbour = now;
    if (is_new) look(fleet, static_cast<std::int32_t>(k), time);
    count += (now.flies != 0 ? 1 : 0) + (now.may_fly != 0 ? 1 : 0);
  }
  return count;
}

/// What the flight is to know, by id: an even one for the plan that a member flies, the next one for the plan that it
/// announced.
std::map<std::uint32_t, SwarmTraffic::Told> SwarmTraffic::choose(const tern::Vec3& place) const {
  std::vector<std::pair<double, std::int32_t>> order;
  for (std::size_t k = 0; k < others_.size(); ++k) {
    for (std::size_t which = 0; which < 2; ++which) {
      const Plan& plan = others_[k].plans[which];
      if (plan.number != 0) order.emplace_back(distance_to(plan.around, place), static_cast<int>(2 * k + which));
    }
  }
  std::sort(order.begin(), order.end());
  std::map<std::uint32_t, Told> chosen;
  std::int32_t pieces = 0;
  for (const auto& [distance, k] : order) {
    const Other& other = others_[static_cast<std::size_t>(k / 2)];
    const Plan& plan = other.plans[k % 2];
    pieces += plan.pieces;
    if (chosen.size() == room_ || pieces > tern::kMaxTrackPieces) break;
    const std::uint64_t number = (std::uint64_t{other.neighbour.incarnation} << 32) + plan.number + 1;
    chosen[2u * other.neighbour.id + (k % 2 != 0 ? 1u : 0u)] = {k / 2, k % 2, number};
  }
  return chosen;
}

/// True if the flight took the plan.
bool SwarmTraffic::update(const tern::Fleet& fleet, tern::Flight& flight, std::uint32_t id, const Told& news,
                          std::int64_t time) {
  read(fleet, news.index, time);
  tern::Track track = tracks_[news.which];
  track.id = id;
  // A place at rest is measured now. A flight takes nothing from more than a tick after its last one, which is where a
  // late tick begins.
  if (track.piece_count == 0) track.measured = std::min(track.measured, last_tick_ + tick_);
  return flight.update_track(track) == tern::Status::kOk;
}

int SwarmTraffic::tell(const tern::Fleet& fleet, tern::Flight& flight, const tern::Vec3& place, std::int64_t time) {
  const int count = ask(fleet, time);
  const std::map<std::uint32_t, Told> chosen = choose(place);
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
      plan = update(fleet, flight, id, news, time) ? news.plan : 0;  // 0: told again in the next tick
    }
    told += plan != 0 ? 1 : 0;
  }
  last_tick_ = time;
  return count - told;
}

}  // namespace tern_host
