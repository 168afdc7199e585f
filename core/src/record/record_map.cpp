// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The events of the map in a flight's record.
#include "record/depth_runs.hpp"
#include "record/flight_event.hpp"
#include "tern/flight_record.hpp"

namespace tern {
namespace {

/// The number of pixels of a view, or 0 if it cannot be recorded.
std::size_t pixels(const DepthView& view) {
  const bool has_one = (view.z16 == nullptr) != (view.z32 == nullptr);
  if (!has_one || view.width < 1 || view.height < 1 || view.stride < view.width) return 0;
  const std::int64_t count = std::int64_t{view.width} * view.height;
  return count > kMaxPixels ? 0 : static_cast<std::size_t>(count);
}

/// The index of pixel k in the numbers of a view.
std::size_t place(const DepthView& view, std::size_t k) {
  const auto width = static_cast<std::size_t>(view.width);
  return k / width * static_cast<std::size_t>(view.stride) + k % width;
}

void write_depths(const DepthView& view, std::size_t count, WordWriter& words) {
  if (view.z16 != nullptr) {
    write_runs<std::uint16_t>(
        count, [&view](std::size_t k) { return view.z16[place(view, k)]; }, words);
    return;
  }
  const auto bits = [&view](std::size_t k) {
    std::uint32_t word = 0;
    __builtin_memcpy(&word, view.z32 + place(view, k), sizeof word);
    return word;
  };
  write_runs<std::uint32_t>(count, bits, words);
}

void write_points(const Vec3* points, std::size_t count, WordWriter& words) {
  words.word(count);
  for (std::size_t k = 0; k < count; ++k) words(points[k]);
}

}  // namespace

size_t frame_record_bytes(const DepthView& view) noexcept {
  const std::size_t count = pixels(view);
  if (count == 0) return 0;
  const std::size_t runs =
      view.z16 != nullptr ? most_run_words<std::uint16_t>(count) : most_run_words<std::uint32_t>(count);
  return kWordBytes * (1 + kFrameFields + runs);
}

size_t scan_record_bytes(size_t count) noexcept {
  return kWordBytes * (1 + 1 + 3 + 2 + 1 + 4 * count);
}

Status FlightRecorder::bind(const MapSpec& spec, Status answer) noexcept {
  Event event(*this, FlightEventKind::kBind, answer);
  if (!event.is_open()) return event.end();
  const bool fits = is_count(spec.prior_count, kMaxPriorBoxes, spec.prior) &&
                    is_count(spec.prior_cylinder_count, kMaxPriorBoxes, spec.prior_cylinders);
  if (!fits) return Status::kInvalidArgument;
  list_map_spec(event.words(), spec);
  event.words()(spec.prior_count);
  for (std::int32_t k = 0; k < spec.prior_count; ++k) list_box(event.words(), spec.prior[k]);
  event.words()(spec.prior_cylinder_count);
  for (std::int32_t k = 0; k < spec.prior_cylinder_count; ++k) list_cylinder(event.words(), spec.prior_cylinders[k]);
  return event.end();
}

Status FlightRecorder::assume_free(const Vec3& center, double radius, Status answer) noexcept {
  Event event(*this, FlightEventKind::kAssumeFree, answer);
  event.words()(center);
  event.words()(radius);
  return event.end();
}

Status FlightRecorder::assume_column(const Cylinder& column, Status answer) noexcept {
  Event event(*this, FlightEventKind::kAssumeColumn, answer);
  list_cylinder(event.words(), column);
  return event.end();
}

Status FlightRecorder::mark_box(const Box& world, Status answer) noexcept {
  Event event(*this, FlightEventKind::kMarkBox, answer);
  list_box(event.words(), world);
  return event.end();
}

Status FlightRecorder::mark_cylinder(const Cylinder& world, Status answer) noexcept {
  Event event(*this, FlightEventKind::kMarkCylinder, answer);
  list_cylinder(event.words(), world);
  return event.end();
}

Status FlightRecorder::mark_points(const Vec3* world, size_t count, Status answer) noexcept {
  Event event(*this, FlightEventKind::kMarkPoints, answer);
  if (!event.is_open()) return event.end();
  if (world == nullptr && count > 0) return Status::kInvalidArgument;
  write_points(world, count, event.words());
  return event.end();
}

Status FlightRecorder::frame(const DepthView& view, const Pose& pose, int64_t t, Status answer) noexcept {
  Event event(*this, FlightEventKind::kFrame, answer);
  if (!event.is_open()) return event.end();
  const std::size_t count = pixels(view);
  if (count == 0) return Status::kInvalidArgument;
  event.words()(t);
  list_pose(event.words(), pose);
  list_view(event.words(), view);
  event.words()(view.z16 != nullptr ? 16 : 32);
  write_depths(view, count, event.words());
  return event.end();
}

Status FlightRecorder::scan(const Vec3* points, size_t count, const Vec3& origin, int64_t t, Status answer) noexcept {
  Event event(*this, FlightEventKind::kScan, answer);
  if (!event.is_open()) return event.end();
  if (points == nullptr && count > 0) return Status::kInvalidArgument;
  event.words()(t);
  event.words()(origin);
  write_points(points, count, event.words());
  return event.end();
}

Status FlightRecorder::scan(const Beams& beams, const Vec3& origin, int64_t t, Status answer) noexcept {
  Event event(*this, FlightEventKind::kBeams, answer);
  if (!event.is_open()) return event.end();
  if (beams.count > 0 && (beams.directions == nullptr || beams.ranges == nullptr)) return Status::kInvalidArgument;
  event.words()(t);
  event.words()(origin);
  event.words()(beams.min);
  event.words()(beams.max);
  write_points(beams.directions, beams.count, event.words());
  for (std::size_t k = 0; k < beams.count; ++k) event.words()(static_cast<double>(beams.ranges[k]));
  return event.end();
}

Status FlightRecorder::follow(const Vec3& center, Status answer) noexcept {
  Event event(*this, FlightEventKind::kFollow, answer);
  event.words()(center);
  return event.end();
}

Status FlightRecorder::step(uint32_t work, Status answer) noexcept {
  Event event(*this, FlightEventKind::kStep, answer);
  event.words()(work);
  return event.end();
}

}  // namespace tern
