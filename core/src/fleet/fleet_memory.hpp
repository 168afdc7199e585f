// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All that a Fleet remembers. Plain data, with pointers into itself only while a proof runs.
#ifndef TERN_FLEET_FLEET_MEMORY_HPP
#define TERN_FLEET_FLEET_MEMORY_HPP

#include <cstdint>

#include "fleet/peer.hpp"
#include "fleet/range.hpp"
#include "tern/fleet.hpp"
#include "tern/track_proof.hpp"

namespace tern {

/// A plan of this vehicle, and the bytes that tell the others of it.
struct OwnPlan {
  Trajectory plan;
  PlanName name;
  PlanPart whole;
  std::int32_t size;
  std::uint32_t crc;
  std::uint8_t bytes[kMaxPlanBytes];
};

/// What a proof is for: the plan that this vehicle announces, or one that a member asks about. One is done after the
/// other, so whatever was agreed before is known to the next one.
enum class JobKind : std::uint8_t { kNone = 0, kOwn, kJudge };

struct ProofJob {
  JobKind kind = JobKind::kNone;
  bool runs = false;       ///< a proof is under way
  std::int32_t peer = 0;   ///< the member whose plan it is about
  std::int32_t heard = 0;  ///< kOwn, behind the last member: ids of vehicles below this one are done
  int turn = 0;            ///< 0, 1: kOwn: against what the peer flies, against what it was allowed; kJudge: what this
                           ///< vehicle flies, what it announces
  TrackProof proof;
  Track track;
  TrackPiece pieces[kMaxSegments + 1] = {};
};

/// Where the round of packets is.
struct Cursor {
  bool has_beacon;          ///< the beacon was written
  std::int32_t state_part;  ///< next part of the state
  int plan;                 ///< 0: the plan that is announced; 1: the one that is flown; 2: the round is at its end
  std::int32_t plan_part;
};

struct FleetMemory {
  bool has_begun;
  bool has_left;
  FleetSpec spec;
  std::uint32_t counter;  ///< states that were told
  std::int64_t stamp;     ///< when what is to be told changed last
  bool has_changed;       ///< since it was told
  std::uint32_t numbers;  ///< plans that were numbered
  int flown;              ///< which of the own plans; the other one is announced, or free
  Announcement announcement;
  FleetBlock blocked;
  std::uint16_t blocked_by;
  OwnPlan own[2];
  std::int32_t removed_count;  ///< members that were removed
  std::uint16_t removed[kMaxNeighbours];
  std::int32_t peer_count;
  Peer peers[kMaxNeighbours];
  Beacons beacons;
  ProofJob job;
  Cursor cursor;
  std::int32_t state_size;
  std::uint32_t state_crc;
  std::uint8_t state[kMaxStateBytes];
};

inline OwnPlan& next_plan(FleetMemory& fleet) {
  return fleet.own[1 - fleet.flown];
}
inline const OwnPlan& next_plan(const FleetMemory& fleet) {
  return fleet.own[1 - fleet.flown];
}
inline bool is_open(const FleetMemory& fleet) {
  return fleet.announcement == Announcement::kOpen;
}
inline bool is_pending(const FleetMemory& fleet) {
  return is_open(fleet) || fleet.announcement == Announcement::kProving;
}

/// A proof that the plan which is announced is clear alone goes back to this vehicle, if it went past it.
inline void prove_from(ProofJob& job, std::uint16_t id) {
  if (id < job.heard) job.heard = id;
}

/// What the others are told changed.
void touch(FleetMemory& fleet, std::int64_t now) noexcept;
/// The plan that is announced will not be flown.
void drop(FleetMemory& fleet, FleetBlock why, std::uint16_t by, std::int64_t now) noexcept;

/// right_of_way.cpp. The peer has the right of way: it decides alone, and this vehicle asks it.
bool is_asked(const FleetMemory& fleet, const Peer& peer) noexcept;
/// All that a plan of this vehicle needs to know of the peer is known.
bool is_ready(const FleetMemory& fleet, const Peer& peer) noexcept;
/// The peer agreed to the plan that is announced.
bool has_agreed(const FleetMemory& fleet, const Peer& peer) noexcept;
/// Takes over or drops the plan that is announced, if it is time.
void decide(FleetMemory& fleet, std::int64_t now, Work& work) noexcept;

/// jobs.cpp. Goes on with proofs, and does what follows from them.
void work_on_jobs(FleetMemory& fleet, std::int64_t now, Work& work) noexcept;
/// What is known of the peer, or what this vehicle flies, changed: a proof that stands on it begins anew.
void restart_jobs_about(FleetMemory& fleet, std::int32_t peer) noexcept;
/// The plan that is announced is to be proven clear of the peer once more.
void prove_again(FleetMemory& fleet, std::int32_t peer) noexcept;
void restart_jobs(FleetMemory& fleet) noexcept;
/// A member is none any more. Only a proof about it ends: those about all others stay valid.
void take_out_peer(FleetMemory& fleet, std::int32_t peer) noexcept;

}  // namespace tern

#endif
