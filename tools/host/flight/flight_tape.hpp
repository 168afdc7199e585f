// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The record of a simulated flight, streamed through a small buffer as firmware would.
#ifndef TERN_HOST_FLIGHT_FLIGHT_TAPE_HPP
#define TERN_HOST_FLIGHT_FLIGHT_TAPE_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tern/flight_record.hpp"

namespace tern_host {

class FlightTape {
 public:
  /// Records to `out`, or nothing where that is null. `frame_bytes`: room for the largest frame.
  FlightTape(std::string* out, std::size_t frame_bytes);

  tern::FlightRecorder& recorder() { return recorder_; }
  /// Tells the flight where the vehicle is, and records that.
  void note_position(tern::Flight& flight, const tern::Vec3& position, std::int64_t t);
  /// Tells the flight of a thing that moves, or that it is gone, and records that.
  tern::Status update_track(tern::Flight& flight, const tern::Track& track);
  void forget_track(tern::Flight& flight, std::uint32_t id);
  /// Records a tick, and saves: between two frames at most, because the buffer has room for one.
  void tick(const tern::Flight& flight, std::int64_t t, const tern::FlightReport& report, tern::Status answer);
  void finish();

 private:
  void save();

  std::string* out_;
  std::vector<std::uint8_t> buffer_;
  tern::FlightRecorder recorder_;
};

}  // namespace tern_host

#endif
