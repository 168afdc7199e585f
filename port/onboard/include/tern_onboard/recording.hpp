// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The records of flights: what a map and a flight were told, so that `tern replay` flies them again, bit for bit.
#ifndef TERN_ONBOARD_RECORDING_HPP
#define TERN_ONBOARD_RECORDING_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tern/flight_record.hpp"

namespace tern_onboard {

/// A part of a flight's record. All parts of a flight, one after the other, are its record, if each one begins where
/// the last kRecordEnd bytes of the one before begin. So the record is whole after each part.
struct RecordPart {
  std::int64_t begun;  ///< when the flight began, nanoseconds of Onboard's clock
  std::vector<std::uint8_t> bytes;
};
constexpr std::size_t kRecordEnd = 16;

/// Room for what is recorded between two calls of take(), bytes: some seconds of images.
constexpr std::size_t kRecordRoom = std::size_t{32} << 20;

/// Not thread-safe.
class Recording {
 public:
  /// From now on, flights are recorded.
  void turn_on(std::size_t room) { buffer_.resize(room); }
  /// A flight is to begin: it gets a record of its own.
  void begin(std::int64_t now);
  /// It was refused: it gets no record.
  void cancel() { recorder_ = {}; }
  /// The room is full: the record ends with what fitted.
  void end();
  /// To be told of each call of the map and the flight. It does nothing before begin().
  tern::FlightRecorder& recorder() { return recorder_; }
  /// What was recorded since the last call.
  std::vector<RecordPart> take();

 private:
  void put_away();

  std::vector<std::uint8_t> buffer_;  // empty: nothing is recorded
  tern::FlightRecorder recorder_;
  std::int64_t begun_ = 0;
  std::vector<RecordPart> parts_;
};

}  // namespace tern_onboard

#endif
