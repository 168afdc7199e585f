// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_events.hpp"

#include <cstring>
#include <stdexcept>

#include "record/depth_runs.hpp"
#include "record/envelope.hpp"

namespace tern_host {
namespace {

constexpr const char* kEventNames[] = {"none",        "bind",         "assume_free",  "mark_box",      "mark_cylinder",
                                       "mark_points", "frame",        "scan",         "follow",        "step",
                                       "start",       "set_goal",     "set_mission",  "set_yaw",       "stop",
                                       "tick",        "set_clock",    "scan",         "note_position", "assume_column",
                                       "land",        "update_track", "forget_track", "answer",        "set_clearance"};

}  // namespace

const char* event_name(tern::FlightEventKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index <= static_cast<std::size_t>(tern::kFlightEventKinds) ? kEventNames[index] : kEventNames[0];
}

FlightEvents::FlightEvents(const std::string& bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const tern::Status status = tern::check_envelope(tern::RecordKind::kFlight, data, bytes.size(), configuration_);
  if (status != tern::Status::kOk) {
    throw std::runtime_error(std::string(tern::status_name(status)) + ": " + tern::status_meaning(status));
  }
  content_ = data + tern::kWordBytes * tern::kHeadWords;
  size_ = bytes.size() / tern::kWordBytes - tern::kHeadWords - tern::kTrailerWords;
}

bool FlightEvents::next(FlightEvent& event) {
  if (at_ == size_) return false;
  tern::WordReader words(content_ + tern::kWordBytes * at_, tern::kWordBytes);
  const std::uint64_t head = words.word();
  const std::uint64_t length = head >> tern::kEventLengthShift;
  ++number_;
  event.kind = static_cast<tern::FlightEventKind>(head & 0xFFu);
  event.answer = static_cast<tern::Status>(head >> tern::kAnswerShift & 0xFFu);
  if ((head & 0xFFu) == 0 || (head & 0xFFu) > static_cast<std::uint64_t>(tern::kFlightEventKinds)) {
    refuse(event, "is no kind of event");
  }
  if (length > size_ - at_ - 1) refuse(event, "is longer than the record");
  const auto count = static_cast<std::size_t>(length);
  event.words = {content_ + tern::kWordBytes * (at_ + 1), tern::kWordBytes * count};
  at_ += 1 + count;
  return true;
}

void FlightEvents::require_end(const FlightEvent& event) const {
  if (event.words.past_end() || event.words.left() > 0) refuse(event, "has another length than what it holds");
}

std::vector<tern::Vec3> FlightEvents::points(FlightEvent& event) const {
  std::vector<tern::Vec3> points(count(event, event.words.left() / 3));
  for (tern::Vec3& point : points) event.words(point);
  return points;
}

tern::Beams FlightEvents::beams(FlightEvent& event, std::vector<tern::Vec3>& directions,
                                std::vector<float>& ranges) const {
  tern::Beams beams{};
  event.words(beams.min);
  event.words(beams.max);
  directions = points(event);
  ranges.resize(directions.size());
  for (float& range : ranges) {
    double number = 0.0;
    event.words(number);
    range = static_cast<float>(number);
  }
  beams.directions = directions.data();
  beams.ranges = ranges.data();
  beams.count = directions.size();
  return beams;
}

tern::DepthView FlightEvents::view(FlightEvent& event, DepthPixels& pixels) const {
  tern::DepthView view{};
  list_view(event.words, view);
  const std::uint64_t bits = event.words.word();
  const std::int64_t count = std::int64_t{view.width} * view.height;
  if (view.width < 1 || view.height < 1 || count > tern::kMaxPixels || (bits != 16 && bits != 32)) {
    refuse(event, "has no image that this build can read");
  }
  view.stride = view.width;
  const auto read = [&](auto& numbers) {
    numbers.resize(static_cast<std::size_t>(count));
    if (!tern::read_runs(event.words, numbers.size(), numbers.data())) {
      refuse(event, "has runs that do not fill its image");
    }
  };
  if (bits == 16) {
    read(pixels.whole);
    view.z16 = pixels.whole.data();
    return view;
  }
  read(pixels.bits);
  pixels.floats.resize(pixels.bits.size());
  std::memcpy(pixels.floats.data(), pixels.bits.data(), pixels.bits.size() * sizeof pixels.bits[0]);
  view.z32 = pixels.floats.data();
  return view;
}

std::size_t FlightEvents::count(FlightEvent& event, std::size_t most) const {
  const std::uint64_t read = event.words.word();
  if (read > most || read > event.words.left()) refuse(event, "has a count that is out of range");
  return static_cast<std::size_t>(read);
}

void FlightEvents::refuse(const FlightEvent& event, const std::string& what) const {
  throw std::runtime_error(std::string(tern::status_name(tern::Status::kRecordDamaged)) + ": event " +
                           std::to_string(number_) + " (" + event_name(event.kind) + ") " + what);
}

}  // namespace tern_host
