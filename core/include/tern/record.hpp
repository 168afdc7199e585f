// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records: a planning query as bytes in a buffer of yours, to be planned again elsewhere. A record holds the grid, the
// request and the answer. It is little-endian 64-bit words on every target, with a version and a checksum.
// docs/record.md has the format.
#ifndef TERN_RECORD_HPP
#define TERN_RECORD_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "tern/halfspace.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "tern/via.hpp"

namespace tern {

/// Version of the format that this library writes and reads.
constexpr uint32_t kRecordVersion = 3;

/// Bytes that are enough for a record of any request on a grid of these dimensions; 0 if they are out of range.
size_t plan_record_bytes(const Voxel& dims) noexcept;

/// Writes a record to `bytes`, at most `room` of them; `used` gets their number. `status` and `plan` are what the
/// planner answered; `plan` is read only if the status is kOk. kOk; kRecordFull if the room does not suffice;
/// kInvalidArgument if the grid is not bound, a pointer is null, or the request has a count that is out of range.
/// Unless it answers kOk, `used` stays, and the bytes have no meaning. Takes time in proportion to the grid's words.
Status record_plan(const Grid& grid, const Request& request, Status status, const Trajectory& plan, uint8_t* bytes,
                   size_t room, size_t* used) noexcept;

/// The content of a record without the voxels. 140 KB with the profile companion: too large for most stacks. `request`
/// points into this object, so it cannot be copied.
struct PlanRecord {
  PlanRecord() = default;
  PlanRecord(const PlanRecord&) = delete;
  PlanRecord& operator=(const PlanRecord&) = delete;

  /// configuration_hash() of the library that recorded. If it differs from yours, capacities differ, and a record of a
  /// plan that ran out of one may get another answer.
  uint64_t configuration = 0;
  GridSpec grid{};
  Request request{};
  Status status = Status::kOk;  ///< the answer
  Trajectory plan{};            ///< empty unless the status is kOk

  // The objects that the request points to.
  Fence fences[kMaxFences] = {};
  Halfspace planes[kMaxFencePlanes] = {};
  Via vias[kMaxVias] = {};
  Track tracks[kMaxTracks] = {};
  TrackPiece track_pieces[kMaxTrackPieces] = {};
  Trajectory previous{};
};

/// Reads a record. kOk; kRecordDamaged if the bytes are no record, too few or too many, or do not have the checksum
/// that they were written with; kRecordVersion if another version of the format wrote them; kInvalidArgument for a null
/// pointer. Other answers say that the record needs a capacity that this library does not have: kSegmentsFull,
/// kFencesFull, kFencePlanesFull, kViasFull, kTracksFull or kTrackPiecesFull. Unless the answer is kOk, `record` has no
/// meaning.
Status read_plan_record(const uint8_t* bytes, size_t count, PlanRecord& record) noexcept;

/// Reads a record. Then binds `grid` to words of yours, at least grid_words(record.grid.dims) of them, marks the
/// record's obstacles and inflates. Answers as read_plan_record() and Grid::bind().
Status read_plan_record(const uint8_t* bytes, size_t count, PlanRecord& record, Grid& grid, uint64_t* words,
                        size_t word_count) noexcept;

}  // namespace tern

#endif
