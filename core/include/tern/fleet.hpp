// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Several vehicles in the same space. Each has a Fleet, which tells the others what its vehicle flies and is about to
// fly, and says when a new plan may be taken over. Of any two vehicles, the plans that they fly are proven clear of
// each other, whatever messages are lost, late, repeated or out of order. docs/fleet.md has the argument.
#ifndef TERN_FLEET_HPP
#define TERN_FLEET_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/work.hpp"

namespace tern {

/// Members by range: vehicles that come near become members by themselves, and those that go far away are none any
/// more. From all others, a vehicle keeps clear whatever they do. docs/fleet.md says what must be true for that.
/// Distances are those on the axis on which they are largest.
struct FleetRange {
  /// m: so near, another vehicle becomes a member; a quarter farther away, it is none any more. At most kMaxNeighbours
  /// do, the nearest ones. 0: members are those of Fleet::add() alone, and nothing else here counts.
  double join = 0.0;
  /// m, above 0: of each vehicle whose body was nearer than that for the whole of the last `within`, a beacon has
  /// arrived that is at most `within` old.
  double heard = 0.0;
  /// m/s, above 0, on each axis: no vehicle of the fleet is ever faster.
  double speed = 0.0;
  /// ns, above 0, at most a minute. After begin(), no plan is taken over that soon.
  int64_t within = 0;
  /// ns, above 0, at most an hour: for how long a vehicle promises a member to ask it and to tell it. Longer than plans
  /// take from their announcement to their rest. After a restart that lost this Fleet, begin() must wait that long.
  int64_t lease = 0;
};

/// A vehicle as a member of a fleet. It stays the same from one Fleet::begin() to the next.
struct FleetSpec {
  /// Who it is. Every vehicle has another number.
  uint16_t id = 0;
  /// Larger each time that Fleet::begin() is called on this vehicle, also after a restart: the seconds of a clock that
  /// never goes back, or a number in permanent memory. At least 1.
  uint32_t incarnation = 0;
  /// The larger one has the right of way; of two equal ones, the smaller id.
  uint8_t priority = 0;
  /// m, above 0, at most 60: its own, with what it may be away from its plan. Two plans are clear of each other if
  /// their distance is at least the sum of both radii.
  double radius = 0.0;
  /// ns, 0 to a second: by how much the clocks of two vehicles may differ.
  int64_t clock_error = 0;
  /// ns, above 0, at most a second: advance() is called at least that often. A plan that is taken over later than that
  /// after its time is dropped instead.
  int64_t tick = 0;
  /// m/s, >= 0: how fast it flies, for traffic() alone.
  double speed = 0.0;
  FleetRange range;
};

/// What became of the last plan that was announced. The numbers are part of the ABI.
enum class Announcement : uint8_t {
  kNone = 0,  ///< no plan was announced, or it was withdrawn
  kProving,   ///< being proven clear of those who have to give way
  kOpen,      ///< the others are told of it, and those who have the right of way are asked
  kTaken,     ///< taken over: it is flown since its takeover
  kDropped,   ///< not taken over and never will be. FleetReport::blocked says why
};

/// Why a plan was dropped. FleetReport::blocked_by says because of whom; 0: of no single vehicle. The numbers are part
/// of the ABI.
enum class FleetBlock : uint8_t {
  kNone = 0,    ///< it was not
  kSilent,      ///< this member was not heard since begin(), or has not heard of it
  kConflict,    ///< the plan is not clear of what this member, which has to give way, may be flying
  kRefused,     ///< this member, which has the right of way, answered that the plan is not clear of its own
  kUnanswered,  ///< the answer of this member, which has the right of way, did not come before the takeover
  kRestarted,   ///< this member was begun or added, or left, in the meantime
  kLate,        ///< advance() was called too late, or had too little work, for the takeover
  kStranger,    ///< by range: not clear of all that this vehicle may do, no promise of which holds until the plan ends
  kUnheard,     ///< by range: nor of vehicles too far away to be heard. It leads too far, or begin() was just now
};

struct FleetReport {
  Announcement announcement = Announcement::kNone;
  FleetBlock blocked = FleetBlock::kNone;
  uint16_t blocked_by = 0;
  /// True if all who were asked agreed: unless a member restarts, the plan will be taken over.
  bool cleared = false;
};

/// What a packet brought. The numbers are part of the ABI.
enum class Heard : uint8_t {
  kNews = 0,      ///< something new, perhaps only a part of a message
  kOld,           ///< nothing new
  kStranger,      ///< from a vehicle that is not a member, or whose members come the other way: by list or by range
  kSelf,          ///< from this vehicle itself, or from another one with its id
  kDamaged,       ///< no packet of a fleet
  kOtherVersion,  ///< from another version of the format
  kTooLong,       ///< a plan with more segments, or a state with more members, than this build has room for
  kClockAhead,    ///< from the future: the clocks differ by more than FleetSpec::clock_error. Nothing was done
};

/// What is known of another member.
struct Neighbour {
  uint16_t id = 0;
  uint32_t incarnation = 0;  ///< 0: it was not heard
  int64_t heard = 0;         ///< when its newest state came, ns
  uint8_t priority = 0;
  bool has_right_of_way = false;
  bool has_left = false;  ///< it said that it flies no more
  bool ready = false;     ///< it knows of this vehicle, and its plan is known: kSilent is not said of it
  uint32_t flies = 0;     ///< number of the plan that it flies; 0: not known
  uint32_t may_fly = 0;   ///< number of the plan that it announced and may take over; 0: none
};

/// Bytes of the smallest packet that write() makes. They suit every link with packets of 27 bytes or more.
constexpr int32_t kFleetPacketBytes = 27;

/// Room that write() needs where members come by range: so much has the packet with this vehicle's place.
constexpr int32_t kFleetBeaconRoom = 59;
/// Vehicles whose places a fleet remembers, where members come by range. Of more, it remembers the nearest ones, and
/// plans end before the others can reach them (FleetBlock::kUnheard).
constexpr int32_t kMaxBeacons = 4 * kMaxNeighbours;

/// Bytes of a Fleet: a little more than what it needs, which the core asserts.
constexpr size_t kFleetBytes = kMaxNeighbours * (static_cast<size_t>(kMaxNeighbours) * 22 + kMaxSegments * 208 + 1024) +
                               kMaxSegments * 720 + kMaxNeighbours * 22 + 4096;

/// One vehicle's part in a fleet: a state machine without clock, input or output. You carry its packets by any link
/// that reaches the others, as often as you like. Large: not for a small stack. Not thread-safe. Before begin(), every
/// call that returns a Status answers kInvalidArgument, and the others do nothing.
class Fleet {
 public:
  /// Begins, or begins anew: with nobody else in the fleet, flying `flown`, which ends at rest and stays there. After a
  /// restart, that is what was flown before, or a rest where that ends. kOk; kInvalidArgument for a spec out of its
  /// ranges, or for a plan that begins after `now`, ends in motion, cannot be sent (docs/fleet.md), or lies in this
  /// Fleet, as that of flown() does: copy it first.
  Status begin(const FleetSpec& spec, const Trajectory& flown, int64_t now) noexcept;
  /// Another vehicle becomes a member. Until each knows of the other, no plan is taken over. kOk, also if it is one
  /// already; kNeighboursFull; kInvalidArgument for the own id, or for one that was removed since begin().
  Status add(uint16_t id, int64_t now) noexcept;
  /// A vehicle is no member any more, because it can be nowhere near, or is known as a track or an obstacle. kOk, or
  /// kInvalidArgument for one that is not a member.
  Status remove(uint16_t id, int64_t now) noexcept;

  /// Announces the plan that is to follow at `takeover`, ns, where the one that is flown passes into it. It ends at
  /// rest. A plan announced before that was not taken over is withdrawn. kOk; kInvalidArgument for a takeover that is
  /// not after `now` or before the plan's beginning, for a plan that ends in motion or cannot be sent, or after
  /// leave(). Then nothing was done.
  Status announce(const Trajectory& plan, int64_t takeover, int64_t now) noexcept;
  /// Drops the plan that is announced, if it was not taken over. The one that is flown goes on.
  void withdraw(int64_t now) noexcept;
  /// The vehicle flies no more after the plan that it flies: it landed, or its radio goes off. From then on, the others
  /// keep clear of the place where that ends, and ask it nothing, once they heard of it. By range, they do so only as
  /// long as its beacons come: go on with write(), or make the place an obstacle for all others.
  void leave(int64_t now) noexcept;

  /// Takes a packet: `size` bytes. Work is bounded by some twenty instructions a byte of a message; for a beacon, also
  /// by a turn through the kMaxBeacons that are remembered.
  Heard receive(const uint8_t* packet, int32_t size, int64_t now) noexcept;
  /// Writes the next packet to send, to all members, of at most `room` bytes. Its size, or 0 at the end of a round, and
  /// if `room` is below kFleetPacketBytes, or kFleetBeaconRoom by range. A round has what the vehicle says of itself,
  /// and its plans as long as a member has not got them. Send a round from time to time, and when something changed.
  int32_t write(uint8_t* packet, int32_t room) noexcept;
  /// Call it every tick. Takes over or drops the plan that is announced, if it is time, and goes on with proofs as long
  /// as work is left. `now` must not go back.
  void advance(int64_t now, Work& work) noexcept;

  FleetReport report() const noexcept;
  /// The plan that is flown, and the one that is announced: null if there is none. Valid until the next call that is
  /// not const.
  const Trajectory* flown() const noexcept;
  const Trajectory* announced() const noexcept;
  /// Members besides this vehicle, and what is known of one: 0 <= index < neighbours().
  int32_t neighbours() const noexcept;
  Neighbour neighbour(int32_t index) const noexcept;
  /// What a plan of this vehicle should keep clear of: for each member whose plan is known, the tube in which it is
  /// now, and that of the plan which it announced and may take over. Track::id is the member's, Track::kind is the
  /// number of the plan: the same plan has the same number each time. Pieces that are over are left out. kOk;
  /// kTracksFull or kTrackPiecesFull if there is not enough room; then `count` is the number of tracks that fit.
  Status traffic(int64_t now, Track* tracks, int32_t room, TrackPiece* pieces, int32_t piece_room,
                 int32_t& count) const noexcept;
  /// traffic() of one member: 0 <= index < neighbours(), or kInvalidArgument. Call it when Neighbour::incarnation,
  /// flies or may_fly has changed.
  Status traffic_of(int32_t index, int64_t now, Track* tracks, int32_t room, TrackPiece* pieces, int32_t piece_room,
                    int32_t& count) const noexcept;

 private:
  friend struct FleetAccess;
  alignas(8) uint64_t memory_[(kFleetBytes + 7) / 8] = {};
};

}  // namespace tern

#endif
