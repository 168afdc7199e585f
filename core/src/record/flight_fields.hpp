// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of each structure that a flight's record holds, as fields.hpp lists them for plans. Arrays and their
// counts are not in these lists; they are written and read separately.
#ifndef TERN_RECORD_FLIGHT_FIELDS_HPP
#define TERN_RECORD_FLIGHT_FIELDS_HPP

#include <cstddef>
#include <cstdint>

#include "record/fields.hpp"
#include "record/words.hpp"
#include "tern/flight.hpp"
#include "tern/map.hpp"

namespace tern {

/// The kind of a call. The first word of an event holds the kind, the call's answer and the number of words that
/// follow.
enum class FlightEventKind : std::uint8_t {
  kBind = 1,
  kAssumeFree,
  kMarkBox,
  kMarkCylinder,
  kMarkPoints,
  kFrame,
  kScan,
  kFollow,
  kStep,
  kStart,
  kGoal,
  kMission,
  kYaw,
  kStop,
  kTick,
  kClock,
  kBeams,
  kPosition,
  kAssumeColumn,
  kLand,
  kTrack,
  kForgetTrack,
  kAnswer,
  kClearance,
};
constexpr int kFlightEventKinds = static_cast<int>(FlightEventKind::kClearance);
constexpr unsigned kAnswerShift = 8;
constexpr unsigned kEventLengthShift = 16;

/// Words at a record's end: the number of all words, and the checksum.
constexpr std::size_t kTrailerWords = 2;

template <typename Words, typename Spec>
void list_map_spec(Words& words, Spec& spec) {
  words(spec.origin);
  words(spec.cell);
  words(spec.dims.x);
  words(spec.dims.y);
  words(spec.dims.z);
  words(spec.radius);
  words(spec.tracking_margin);
  words(spec.range);
  words(spec.depth_margin);
  words(spec.depth_margin_square);
  words(spec.pose_margin);
  words(spec.angle_margin);
  words(spec.scan_pixel);
  words(spec.hits);
  words(spec.misses);
  words(spec.support);
  words(spec.age);
  words(spec.slack);
  words(spec.pixels);
}

template <typename Words, typename AnyBox>
void list_box(Words& words, AnyBox& box) {
  words(box.lower);
  words(box.upper);
}

template <typename Words, typename AnyCylinder>
void list_cylinder(Words& words, AnyCylinder& cylinder) {
  words(cylinder.base);
  words(cylinder.radius);
  words(cylinder.height);
}

template <typename Words, typename AnyPose>
void list_pose(Words& words, AnyPose& pose) {
  words(pose.position);
  for (auto& part : pose.quaternion) words(part);
}

template <typename Words, typename View>
void list_view(Words& words, View& view) {
  words(view.width);
  words(view.height);
  words(view.fx);
  words(view.fy);
  words(view.cx);
  words(view.cy);
  words(view.scale);
  words(view.min);
  words(view.max);
  words(view.no_return);
}
/// The time, the pose, the view, and which kind of numbers follows.
constexpr std::size_t kFrameFields = 1 + 7 + 10 + 1;

template <typename Words, typename Spec>
void list_flight_spec(Words& words, Spec& spec) {
  list_limits(words, spec.limits);
  words(spec.time_weight);
  words(spec.tick);
  words(spec.work_per_tick);
  words(spec.plan_work);
  words(spec.horizon);
  words(spec.near);
  words(spec.yaw_rate);
  words(spec.stale_after);
  words(spec.sensor.horizontal);
  words(spec.sensor.vertical);
  words(spec.sensor.pitch_min);
  words(spec.sensor.pitch_max);
  words(spec.sensor.nearest);
  words(spec.sensor.offset);
  words(spec.sensor.raised);
  words(spec.clearance);
}

template <typename Words, typename AnyHeading>
void list_heading(Words& words, AnyHeading& heading) {
  words(heading.cosine);
  words(heading.sine);
}

template <typename Words, typename Yaw>
void list_flight_yaw(Words& words, Yaw& yaw) {
  words(yaw.mode);
  words(yaw.acceleration_max);
  words(yaw.field_of_view);
  list_heading(words, yaw.start);
  list_heading(words, yaw.heading);
  words(yaw.point);
}

template <typename Words, typename AnyCommand>
void list_command(Words& words, AnyCommand& command) {
  words(command.sample.position);
  words(command.sample.velocity);
  words(command.sample.acceleration);
  words(command.sample.jerk);
  words(command.sample.snap);
  words(command.look_at);
}
constexpr std::size_t kCommandFields = 18;

template <typename Words, typename Sample>
void list_yaw_sample(Words& words, Sample& sample) {
  words(sample.yaw.cosine);
  words(sample.yaw.sine);
  words(sample.yaw.rate);
  words(sample.acceleration);
  words(sample.angle);
}

/// The fields that hold decisions. Those of a blockage are left out: they are for people, and another version may find
/// a better blockage to name. So are those that follow from measured positions, which the record has.
template <typename Words, typename Report>
void list_flight_report(Words& words, Report& report) {
  words(report.mode);
  words(report.reason);
  words(report.plan);
  words(report.asked);
  words(report.committed);
  words(report.dropped);
  words(report.failed);
  words(report.work);
  words(report.contact_time);
  words(report.contact_speed);
  words(report.leg);
  words(report.passed);
  words(report.skipped);
  words(report.waits_for_nose);
  words(report.map_stale);
  words(report.frame_age);
}

/// The hash that a tick leaves: FNV-1a, word by word, over the command, the yaw and the report.
class TickHash : public FieldWriter<TickHash> {
 public:
  TickHash(const Command& command, const YawSample& yaw, const FlightReport& report) {
    list_command(*this, command);
    list_yaw_sample(*this, yaw);
    list_flight_report(*this, report);
  }
  void word(std::uint64_t bits) { value_ = (value_ ^ bits) * 0x100'0000'01B3u; }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF2'9CE4'8422'2325u;
};

}  // namespace tern

#endif
