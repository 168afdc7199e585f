// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight's record from its beginning to its end, and the events of the flight. record_map.cpp has those of the map.
#include "tern/flight_record.hpp"

#include "base/capacity.hpp"
#include "record/fences.hpp"
#include "record/flight_event.hpp"
#include "record/tracks.hpp"

namespace tern {

static_assert(kFlightRecordBytes == kWordBytes * (kHeadWords + kTrailerWords), "what begin() and close() write");
static_assert(kTickRecordBytes == kWordBytes * (1 + 2 + kCommandFields), "what tick() writes");

Status FlightRecorder::begin(uint8_t* bytes, size_t room) noexcept {
  *this = FlightRecorder{};
  if (bytes == nullptr) return Status::kInvalidArgument;
  if (is_full(room < kFlightRecordBytes)) return Status::kRecordFull;
  bytes_ = bytes;
  room_ = room / kWordBytes;
  checksum_ = kChecksumSeed;
  WordWriter words(bytes, room);
  open_envelope(RecordKind::kFlight, words);
  Event::append(*this, words.count());
  return status_ = Status::kOk;
}

Status FlightRecorder::start(const FlightSpec& spec, const Vec3& position, int64_t t, Status answer) noexcept {
  Event event(*this, FlightEventKind::kStart, answer);
  if (event.is_open() && !fences_fit(spec.fences, spec.fence_count)) return Status::kInvalidArgument;
  event.words()(position);
  event.words()(t);
  list_flight_spec(event.words(), spec);
  if (event.is_open()) write_fences(spec.fences, spec.fence_count, event.words());
  return event.end();
}

Status FlightRecorder::set_goal(const Vec3& goal, Status answer) noexcept {
  Event event(*this, FlightEventKind::kGoal, answer);
  event.words()(goal);
  return event.end();
}

Status FlightRecorder::set_mission(const Via* points, int32_t count, ViaPolicy policy, Status answer) noexcept {
  Event event(*this, FlightEventKind::kMission, answer);
  if (!event.is_open()) return event.end();
  if (!is_count(count, kMaxMissionPoints, points)) return Status::kInvalidArgument;
  event.words()(policy);
  event.words()(count);
  for (int32_t k = 0; k < count; ++k) list_via(event.words(), points[k]);
  return event.end();
}

Status FlightRecorder::land(const Vec3& place, double ground, double speed, Status answer) noexcept {
  Event event(*this, FlightEventKind::kLand, answer);
  event.words()(place);
  event.words()(ground);
  event.words()(speed);
  return event.end();
}

Status FlightRecorder::set_yaw(const FlightYaw& yaw, Status answer) noexcept {
  Event event(*this, FlightEventKind::kYaw, answer);
  if (!event.is_open()) return event.end();
  // Headings that the mode does not read may be anything.
  const int32_t count = yaw.mode == FlightYawMode::kAtPoints ? yaw.heading_count : 0;
  if (!is_count(count, kMaxMissionPoints, yaw.headings)) return Status::kInvalidArgument;
  list_flight_yaw(event.words(), yaw);
  event.words()(count);
  for (int32_t k = 0; k < count; ++k) list_heading(event.words(), yaw.headings[k]);
  return event.end();
}

Status FlightRecorder::stop(Status answer) noexcept {
  return Event(*this, FlightEventKind::kStop, answer).end();
}

Status FlightRecorder::note_position(const Vec3& position, int64_t t, Status answer) noexcept {
  Event event(*this, FlightEventKind::kPosition, answer);
  event.words()(position);
  event.words()(t);
  return event.end();
}

Status FlightRecorder::set_clock(int64_t t, Status answer) noexcept {
  Event event(*this, FlightEventKind::kClock, answer);
  event.words()(t);
  return event.end();
}

Status FlightRecorder::update_track(const Track& track, Status answer) noexcept {
  Event event(*this, FlightEventKind::kTrack, answer);
  if (!event.is_open()) return event.end();
  if (!is_count(track.piece_count, kMaxTrackPieces, track.pieces)) return Status::kInvalidArgument;
  write_track(track, event.words());
  return event.end();
}

Status FlightRecorder::forget_track(uint32_t id, Status answer) noexcept {
  Event event(*this, FlightEventKind::kForgetTrack, answer);
  event.words()(id);
  return event.end();
}

Status FlightRecorder::answer(uint32_t number, bool may_fly, Status answer) noexcept {
  Event event(*this, FlightEventKind::kAnswer, answer);
  event.words()(number);
  event.words()(may_fly);
  return event.end();
}

Status FlightRecorder::set_clearance(int64_t clearance, Status answer) noexcept {
  Event event(*this, FlightEventKind::kClearance, answer);
  event.words()(clearance);
  return event.end();
}

Status FlightRecorder::tick(const Flight& flight, int64_t t, const FlightReport& report, Status answer) noexcept {
  Event event(*this, FlightEventKind::kTick, answer);
  if (!event.is_open()) return event.end();
  const Command command = flight.command(t);
  event.words()(t);
  event.words().word(TickHash(command, flight.yaw(t), report).value());
  if (ticks_ % kWholeCommandTicks == 0) list_command(event.words(), command);
  const Status status = event.end();
  if (status == Status::kOk) ++ticks_;
  return status;
}

Status FlightRecorder::close(size_t* used) noexcept {
  if (bytes_ == nullptr || used == nullptr) return Status::kInvalidArgument;
  std::uint8_t* const end = bytes_ + kWordBytes * used_;
  WordWriter words(end, kWordBytes * kTrailerWords);
  words.word(total_ + kTrailerWords);
  words.word(checksum(end, kWordBytes, checksum_));
  *used = kWordBytes * (used_ + kTrailerWords);
  return Status::kOk;
}

size_t FlightRecorder::pending() const noexcept {
  return kWordBytes * used_;
}

void FlightRecorder::clear() noexcept {
  used_ = 0;
}

}  // namespace tern
