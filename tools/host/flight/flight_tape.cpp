// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_tape.hpp"

namespace tern_host {
namespace {

/// For ticks, and the specs, missions and fences of a flight.
constexpr std::size_t kRoomBesidesFrame = 64 * 1024;

}  // namespace

FlightTape::FlightTape(std::string* out, std::size_t frame_bytes) : out_(out) {
  if (out == nullptr) return;
  buffer_.resize(frame_bytes + kRoomBesidesFrame);
  out->clear();
  recorder_.begin(buffer_.data(), buffer_.size());
}

void FlightTape::note_position(tern::Flight& flight, const tern::Vec3& position, std::int64_t t) {
  recorder_.note_position(position, t, flight.note_position(position, t));
}

tern::Status FlightTape::update_track(tern::Flight& flight, const tern::Track& track) {
  const tern::Status answer = flight.update_track(track);
  recorder_.update_track(track, answer);
  return answer;
}

void FlightTape::forget_track(tern::Flight& flight, std::uint32_t id) {
  recorder_.forget_track(id, flight.forget_track(id));
}

void FlightTape::tick(const tern::Flight& flight, std::int64_t t, const tern::FlightReport& report,
                      tern::Status answer) {
  recorder_.tick(flight, t, report, answer);
  save();
}

void FlightTape::save() {
  if (out_ == nullptr) return;
  out_->append(reinterpret_cast<const char*>(buffer_.data()), recorder_.pending());
  recorder_.clear();
}

void FlightTape::finish() {
  std::size_t used = 0;
  if (out_ == nullptr || recorder_.close(&used) != tern::Status::kOk) return;
  out_->append(reinterpret_cast<const char*>(buffer_.data()), used);
}

}  // namespace tern_host
