// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The events of a recorded flight, one after the other. Whoever altered a record may also have made its checksum, so no
// number of it is trusted.
#ifndef TERN_HOST_FLIGHT_FLIGHT_EVENTS_HPP
#define TERN_HOST_FLIGHT_FLIGHT_EVENTS_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "record/flight_fields.hpp"
#include "record/words.hpp"
#include "tern/map.hpp"
#include "tern/status.hpp"

namespace tern_host {

/// "tick", for messages.
const char* event_name(tern::FlightEventKind kind);

/// One event: its head, and a reader of what follows.
struct FlightEvent {
  tern::FlightEventKind kind = tern::FlightEventKind::kTick;
  tern::Status answer = tern::Status::kOk;
  tern::WordReader words{nullptr, 0};
};

/// Room for the pixels of an image.
struct DepthPixels {
  std::vector<std::uint16_t> whole;
  std::vector<std::uint32_t> bits;
  std::vector<float> floats;
};

class FlightEvents {
 public:
  /// Throws std::runtime_error for bytes that are no record of a flight. They must outlive this.
  explicit FlightEvents(const std::string& bytes);

  std::uint64_t configuration() const { return configuration_; }
  /// False at the end. Throws std::runtime_error for an event that is none.
  bool next(FlightEvent& event);
  /// Throws unless all words of the last event were read, and no more.
  void require_end(const FlightEvent& event) const;
  /// A count of the last event of at most `most`. Throws where it is more.
  std::size_t count(FlightEvent& event, std::size_t most) const;
  /// What the last event goes on with: a number of points and each one, or the beams of a scan, which are put into
  /// `directions` and `ranges`. Throws where there are more points than words.
  std::vector<tern::Vec3> points(FlightEvent& event) const;
  tern::Beams beams(FlightEvent& event, std::vector<tern::Vec3>& directions, std::vector<float>& ranges) const;
  /// An image, whose pixels are put into `pixels`. Throws where this build cannot read it.
  tern::DepthView view(FlightEvent& event, DepthPixels& pixels) const;
  /// Throws: the last event has something that no recorder writes.
  [[noreturn]] void refuse(const FlightEvent& event, const std::string& what) const;

 private:
  const std::uint8_t* content_ = nullptr;
  std::size_t size_ = 0;  ///< words
  std::size_t at_ = 0;
  std::size_t number_ = 0;  ///< of events so far
  std::uint64_t configuration_ = 0;
};

}  // namespace tern_host

#endif
