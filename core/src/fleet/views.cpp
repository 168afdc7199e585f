// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a Fleet says to its own vehicle.
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "fleet/fleet_access.hpp"

namespace tern {
namespace {

/// Room for tracks and pieces, and how much of it is used.
struct Traffic {
  Track* tracks;
  std::int32_t room;
  std::int32_t count;
  TrackPiece* pieces;
  std::int32_t piece_room;
};

/// Leaves out the pieces that are over. Of a plan that is over, a place is left.
void drop_past(std::int64_t now, TrackPiece* pieces, Track& track) {
  std::int32_t over = 0;
  double past = 0.0;
  const double since = 1e-9 * static_cast<double>(now - track.measured);
  while (over < track.piece_count && past + pieces[over].duration < since) past += pieces[over++].duration;
  if (over == track.piece_count) {
    track.position = track.position + pieces[over - 1].points[kDegree];
    track.measured = now;
    track.pieces = nullptr;
    track.piece_count = 0;
    return;
  }
  for (std::int32_t p = over; p < track.piece_count; ++p) pieces[p - over] = pieces[p];
  track.piece_count -= over;
  track.measured += static_cast<std::int64_t>(1e9 * past);
}

Status add_track(const FleetMemory& fleet, const Peer& peer, std::int8_t plan, std::int64_t now, Traffic& traffic) {
  const Assembly<kMaxPlanBytes>& theirs = peer.plans[plan];
  if (is_full(traffic.count >= traffic.room)) return Status::kTracksFull;
  if (is_full(read_piece_count(theirs.bytes, theirs.size) + 1 > traffic.piece_room)) return Status::kTrackPiecesFull;
  Track& track = traffic.tracks[traffic.count];
  read_plan(theirs.bytes, theirs.size, fleet.spec.clock_error, traffic.pieces, track);
  track.kind = peer.names[plan].number;
  track.radius = 1e-3 * peer.state.radius;
  // What the others do not know of this vehicle's plan: its rounded points, and its clock.
  track.error = 2.0 * track.error + 1e-9 * fleet.spec.speed * static_cast<double>(fleet.spec.clock_error);
  drop_past(now, traffic.pieces, track);
  traffic.pieces += track.piece_count;
  traffic.piece_room -= track.piece_count;
  ++traffic.count;
  return Status::kOk;
}

/// The plan besides the one that it flies that it may take over; kNoPlan if there is none.
std::int8_t other_plan(const FleetMemory& fleet, const Peer& peer) {
  if (!is_asked(fleet, peer)) return peer.held;
  return peer.state.open == 0 ? kNoPlan : find_plan(peer, peer.state.open);
}

Status add_tracks(const FleetMemory& fleet, const Peer& peer, std::int64_t now, Traffic& traffic) {
  if (peer.flown == kNoPlan) return Status::kOk;
  const Status status = add_track(fleet, peer, peer.flown, now, traffic);
  const std::int8_t other = other_plan(fleet, peer);
  return status != Status::kOk || other == kNoPlan ? status : add_track(fleet, peer, other, now, traffic);
}

}  // namespace

Status Fleet::traffic(std::int64_t now, Track* tracks, std::int32_t room, TrackPiece* pieces, std::int32_t piece_room,
                      std::int32_t& count) const noexcept {
  const FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr) return Status::kInvalidArgument;
  Traffic traffic{tracks, room, 0, pieces, piece_room};
  Status status = Status::kOk;
  for (std::int32_t p = 0; status == Status::kOk && p < fleet->peer_count; ++p) {
    status = add_tracks(*fleet, fleet->peers[p], now, traffic);
  }
  count = traffic.count;
  return status;
}

Status Fleet::traffic_of(std::int32_t index, std::int64_t now, Track* tracks, std::int32_t room, TrackPiece* pieces,
                         std::int32_t piece_room, std::int32_t& count) const noexcept {
  const FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr || index < 0 || index >= fleet->peer_count) return Status::kInvalidArgument;
  Traffic traffic{tracks, room, 0, pieces, piece_room};
  const Status status = add_tracks(*fleet, fleet->peers[index], now, traffic);
  count = traffic.count;
  return status;
}

FleetReport Fleet::report() const noexcept {
  FleetReport report;
  const FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr) return report;
  report.announcement = fleet->announcement;
  report.blocked = fleet->blocked;
  report.blocked_by = fleet->blocked_by;
  report.cleared = is_open(*fleet);
  for (std::int32_t p = 0; p < fleet->peer_count; ++p) {
    const Peer& peer = fleet->peers[p];
    report.cleared = report.cleared && (!peer.link.binds || !is_asked(*fleet, peer) || has_agreed(*fleet, peer));
  }
  return report;
}

const Trajectory* Fleet::flown() const noexcept {
  const FleetMemory* const fleet = memory_of(*this);
  return fleet == nullptr ? nullptr : &fleet->own[fleet->flown].plan;
}

const Trajectory* Fleet::announced() const noexcept {
  const FleetMemory* const fleet = memory_of(*this);
  return fleet == nullptr || !is_pending(*fleet) ? nullptr : &next_plan(*fleet).plan;
}

std::int32_t Fleet::neighbours() const noexcept {
  const FleetMemory* const fleet = memory_of(*this);
  return fleet == nullptr ? 0 : fleet->peer_count;
}

Neighbour Fleet::neighbour(std::int32_t index) const noexcept {
  Neighbour neighbour;
  const FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr || index < 0 || index >= fleet->peer_count) return neighbour;
  const Peer& peer = fleet->peers[index];
  neighbour.id = peer.id;
  neighbour.incarnation = peer.state.incarnation;
  neighbour.heard = peer.heard;
  neighbour.priority = peer.state.priority;
  neighbour.has_right_of_way = peer.state.incarnation != 0 && is_asked(*fleet, peer);
  neighbour.has_left = peer.state.has_left;
  neighbour.ready = is_ready(*fleet, peer);
  if (peer.flown == kNoPlan) return neighbour;
  neighbour.flies = peer.names[peer.flown].number;
  const std::int8_t other = other_plan(*fleet, peer);
  if (other != kNoPlan) neighbour.may_fly = peer.names[other].number;
  return neighbour;
}

}  // namespace tern
