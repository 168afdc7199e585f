// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of flights: every call of a RollingMap and a Flight, with its frames, as bytes in a buffer of yours, to be
// flown again elsewhere. Each tick leaves a hash of its commands, so that `tern replay` finds the first tick that
// differs. docs/record.md has the format.
#ifndef TERN_FLIGHT_RECORD_HPP
#define TERN_FLIGHT_RECORD_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/flight.hpp"
#include "tern/map.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern {

/// One tick of this many is recorded with its whole command, the others only with its hash.
constexpr uint64_t kWholeCommandTicks = 64;

/// Room that is enough for begin() and close(), bytes.
constexpr size_t kFlightRecordBytes = 56;
/// Room that a tick needs, bytes. All ticks but one of kWholeCommandTicks take 24 bytes.
constexpr size_t kTickRecordBytes = 168;
/// Room that is enough for a frame with such a view, bytes; 0 if it has no pixels, or more than kMaxPixels.
size_t frame_record_bytes(const DepthView& view) noexcept;
/// Room that is enough for a scan of so many points or beams, bytes.
size_t scan_record_bytes(size_t count) noexcept;

/// Writes the record of one flight. Make every call of the map and the flight as always, then tell the recorder of it,
/// with the same arguments and its answer:
///
///     recorder.frame(view, pose, t, map.begin_frame(view, pose, t));
///     recorder.tick(flight, t, report, flight.tick(t, report));
///
/// A refused call changed nothing, so it is not recorded. Nor are snapshots, which change neither the map nor the
/// flight. Each call answers kOk; kRecordFull if the room does not suffice; or kInvalidArgument before begin(), for a
/// null pointer, or for a count out of range. After kRecordFull all calls but close() answer the same, because a flight
/// with a gap cannot be flown again; what was recorded before stays good.
///
/// A call takes time in proportion to its bytes. Plain data: copies go on from the same place, so use one of them.
class FlightRecorder {
 public:
  /// Begins a record in `room` bytes of yours.
  Status begin(uint8_t* bytes, size_t room) noexcept;

  // The map: RollingMap::bind() comes first.
  Status bind(const MapSpec& spec, Status answer) noexcept;
  Status assume_free(const Vec3& center, double radius, Status answer) noexcept;
  Status assume_column(const Cylinder& column, Status answer) noexcept;
  Status mark_box(const Box& world, Status answer) noexcept;
  Status mark_cylinder(const Cylinder& world, Status answer) noexcept;
  Status mark_points(const Vec3* world, size_t count, Status answer) noexcept;
  Status frame(const DepthView& view, const Pose& pose, int64_t t, Status answer) noexcept;
  Status scan(const Vec3* points, size_t count, const Vec3& origin, int64_t t, Status answer) noexcept;
  Status scan(const Beams& beams, const Vec3& origin, int64_t t, Status answer) noexcept;
  Status follow(const Vec3& center, Status answer) noexcept;
  Status step(uint32_t work, Status answer) noexcept;

  // The flight.
  Status start(const FlightSpec& spec, const Vec3& position, int64_t t, Status answer) noexcept;
  Status set_goal(const Vec3& goal, Status answer) noexcept;
  Status set_mission(const Via* points, int32_t count, ViaPolicy policy, Status answer) noexcept;
  Status land(const Vec3& place, double ground, double speed, Status answer) noexcept;
  Status set_yaw(const FlightYaw& yaw, Status answer) noexcept;
  Status stop(Status answer) noexcept;
  Status note_position(const Vec3& position, int64_t t, Status answer) noexcept;
  Status set_clock(int64_t t, Status answer) noexcept;
  Status update_track(const Track& track, Status answer) noexcept;
  Status forget_track(uint32_t id, Status answer) noexcept;
  Status answer(uint32_t number, bool may_fly, Status answer) noexcept;
  Status set_clearance(int64_t clearance, Status answer) noexcept;
  /// Records a tick, with command(t) and yaw(t) of the flight as they are after it.
  Status tick(const Flight& flight, int64_t t, const FlightReport& report, Status answer) noexcept;

  /// Makes the bytes so far a whole record; `used` gets their number. Calls may go on, and the next close() makes a
  /// longer one: close now and then, and a crash costs the last part alone. kOk, or kInvalidArgument before begin() or
  /// for a null pointer.
  Status close(size_t* used) noexcept;

  // To stream a record through a small buffer: save pending() bytes, clear(), and go on. The record is all that was
  // saved, one after the other, and at its end the bytes of close().

  /// Bytes in the buffer, without those of close().
  size_t pending() const noexcept;
  /// Empties the buffer.
  void clear() noexcept;

 private:
  class Event;

  uint8_t* bytes_ = nullptr;
  size_t room_ = 0;        // words
  size_t used_ = 0;        // words in the buffer
  uint64_t total_ = 0;     // words of the record
  uint64_t checksum_ = 0;  // of all words of the record
  uint64_t ticks_ = 0;
  Status status_ = Status::kInvalidArgument;
};

}  // namespace tern

#endif
