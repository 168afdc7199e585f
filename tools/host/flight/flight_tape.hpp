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
  /// Between two frames at most: the buffer has room for one.
  void save();
  void finish();

 private:
  std::string* out_;
  std::vector<std::uint8_t> buffer_;
  tern::FlightRecorder recorder_;
};

}  // namespace tern_host

#endif
