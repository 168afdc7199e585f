// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of flights through C: a null pointer answers invalid_argument and records nothing, and so does a recorder
// that was not begun.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "tern/tern_flight_record.h"

namespace {

constexpr std::uint8_t kOk = 0;
constexpr auto kInvalid = static_cast<std::uint8_t>(tern::Status::kInvalidArgument);
constexpr std::uint8_t kRunning = static_cast<std::uint8_t>(tern::Status::kRunning);
constexpr tern_vec3 kPoint{1.0, 2.0, 3.0};

/// What the calls are given.
struct Arguments {
  Arguments() : map(tern::map_spec({0.0, 0.0, 0.0}, 0.2, {64, 64, 16}, 0.3)) {
    const tern_limits limits{{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}};
    tern_flight_spec_init(&flight_spec, &limits);
    view.z16 = depths;
    view.width = view.height = view.stride = 2;
  }
  const std::uint16_t depths[4] = {1, 2, 3, 4};
  tern_map_spec map;
  tern_box box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  tern_cylinder cylinder{{0.0, 0.0, 0.0}, 0.5, 1.0};
  tern_depth_view view{};
  const float range = 2.0f;
  tern_beams beams{&kPoint, &range, 1, 0.1, 9.0};
  tern_pose pose{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  tern_flight_spec flight_spec{};
  tern_flight_yaw yaw{};
  tern_via via{{1.0, 0.0, 1.0}, 0.1};
  tern_track track{};
  tern_flight flight{};
  tern_flight_report report{};
};

/// Every call that records, with nothing missing but perhaps the recorder: what they answer.
std::vector<std::uint8_t> answers(tern_flight_recorder* r) {
  const Arguments a;
  return {tern_flight_record_bind(r, &a.map, kOk),
          tern_flight_record_assume_free(r, &kPoint, 1.0, kOk),
          tern_flight_record_assume_column(r, &a.cylinder, kOk),
          tern_flight_record_mark_box(r, &a.box, kOk),
          tern_flight_record_mark_cylinder(r, &a.cylinder, kOk),
          tern_flight_record_mark_points(r, &kPoint, 1, kOk),
          tern_flight_record_frame(r, &a.view, &a.pose, 0, kRunning),
          tern_flight_record_scan(r, &kPoint, 1, &kPoint, 0, kRunning),
          tern_flight_record_beams(r, &a.beams, &kPoint, 0, kRunning),
          tern_flight_record_follow(r, &kPoint, kRunning),
          tern_flight_record_step(r, 5, kRunning),
          tern_flight_record_start(r, &a.flight_spec, &kPoint, 0, kOk),
          tern_flight_record_set_goal(r, &kPoint, kOk),
          tern_flight_record_set_mission(r, &a.via, 1, TERN_VIA_SKIP, kOk),
          tern_flight_record_land(r, &kPoint, 0.5, 0.3, kOk),
          tern_flight_record_set_yaw(r, &a.yaw, kOk),
          tern_flight_record_stop(r, kOk),
          tern_flight_record_set_clock(r, 0, kOk),
          tern_flight_record_note_position(r, &kPoint, 0, kOk),
          tern_flight_record_update_track(r, &a.track, kOk),
          tern_flight_record_forget_track(r, 0, kOk),
          tern_flight_record_answer(r, 1, true, kOk),
          tern_flight_record_set_clearance(r, 1, kOk),
          tern_flight_record_tick(r, &a.flight, 0, &a.report, kOk)};
}

class FlightRecordC : public testing::Test {
 protected:
  FlightRecordC() : bytes_(4096) {
    EXPECT_EQ(tern_flight_record_begin(&recorder_, bytes_.data(), bytes_.size()), kOk);
    before_ = tern_flight_record_pending(&recorder_);
  }
  void expect_refused(std::uint8_t answer) {
    EXPECT_EQ(answer, kInvalid);
    EXPECT_EQ(tern_flight_record_pending(&recorder_), before_);
  }

  std::vector<std::uint8_t> bytes_;
  tern_flight_recorder recorder_{};
  Arguments a_;
  std::size_t before_;
};

TEST_F(FlightRecordC, EveryCallRecords) {
  const std::vector<std::uint8_t> all = answers(&recorder_);
  EXPECT_EQ(all, std::vector<std::uint8_t>(all.size(), kOk));
  EXPECT_GT(tern_flight_record_pending(&recorder_), before_ + tern_frame_record_bytes(&a_.view));
}

TEST_F(FlightRecordC, WithoutARecorderNothingIsRecorded) {
  tern_flight_recorder none{};
  for (tern_flight_recorder* const recorder : {static_cast<tern_flight_recorder*>(nullptr), &none}) {
    const std::vector<std::uint8_t> all = answers(recorder);
    EXPECT_EQ(all, std::vector<std::uint8_t>(all.size(), kInvalid));
    EXPECT_EQ(tern_flight_record_pending(recorder), 0u);
    std::size_t used = 77;
    EXPECT_EQ(tern_flight_record_close(recorder, &used), kInvalid);
    EXPECT_EQ(used, 77u);
    tern_flight_record_clear(recorder);
  }
  const tern_flight_recorder zero{};
  EXPECT_EQ(std::memcmp(&none, &zero, sizeof none), 0);
  EXPECT_EQ(tern_flight_record_begin(nullptr, bytes_.data(), bytes_.size()), kInvalid);
}

TEST_F(FlightRecordC, ARecordNeedsRoom) {
  tern_flight_recorder other{};
  EXPECT_EQ(tern_flight_record_begin(&other, nullptr, 4096), kInvalid);
  EXPECT_EQ(tern_flight_record_begin(&other, bytes_.data(), TERN_FLIGHT_RECORD_BYTES - 1),
            static_cast<std::uint8_t>(tern::Status::kRecordFull));
  EXPECT_EQ(tern_flight_record_stop(&other, kOk), kInvalid);  // begin() failed
}

TEST_F(FlightRecordC, EachPointerMustBeThere) {
  tern_flight_recorder* const r = &recorder_;
  expect_refused(tern_flight_record_bind(r, nullptr, kOk));
  expect_refused(tern_flight_record_assume_free(r, nullptr, 1.0, kOk));
  expect_refused(tern_flight_record_assume_column(r, nullptr, kOk));
  expect_refused(tern_flight_record_land(r, nullptr, 0.5, 0.3, kOk));
  expect_refused(tern_flight_record_update_track(r, nullptr, kOk));
  expect_refused(tern_flight_record_mark_box(r, nullptr, kOk));
  expect_refused(tern_flight_record_mark_cylinder(r, nullptr, kOk));
  expect_refused(tern_flight_record_mark_points(r, nullptr, 1, kOk));
  expect_refused(tern_flight_record_frame(r, nullptr, &a_.pose, 0, kRunning));
  expect_refused(tern_flight_record_frame(r, &a_.view, nullptr, 0, kRunning));
  expect_refused(tern_flight_record_scan(r, nullptr, 1, &kPoint, 0, kRunning));
  expect_refused(tern_flight_record_scan(r, &kPoint, 1, nullptr, 0, kRunning));
  expect_refused(tern_flight_record_beams(r, nullptr, &kPoint, 0, kRunning));
  expect_refused(tern_flight_record_beams(r, &a_.beams, nullptr, 0, kRunning));
  expect_refused(tern_flight_record_follow(r, nullptr, kRunning));
  expect_refused(tern_flight_record_start(r, nullptr, &kPoint, 0, kOk));
  expect_refused(tern_flight_record_start(r, &a_.flight_spec, nullptr, 0, kOk));
  expect_refused(tern_flight_record_set_goal(r, nullptr, kOk));
  expect_refused(tern_flight_record_set_mission(r, nullptr, 1, TERN_VIA_SKIP, kOk));
  expect_refused(tern_flight_record_set_yaw(r, nullptr, kOk));
  expect_refused(tern_flight_record_tick(r, nullptr, 0, &a_.report, kOk));
  expect_refused(tern_flight_record_tick(r, &a_.flight, 0, nullptr, kOk));
  expect_refused(tern_flight_record_close(r, nullptr));
  EXPECT_EQ(tern_flight_record_stop(r, kOk), kOk);
}

TEST_F(FlightRecordC, SizesAreThoseOfCpp) {
  EXPECT_EQ(tern_frame_record_bytes(nullptr), 0u);
  EXPECT_EQ(tern_frame_record_bytes(&a_.view), tern::frame_record_bytes(a_.view));
  EXPECT_GT(tern_frame_record_bytes(&a_.view), 0u);
  EXPECT_EQ(tern_scan_record_bytes(7), tern::scan_record_bytes(7));
}

TEST_F(FlightRecordC, AStreamIsClearedAndGoesOn) {
  EXPECT_EQ(tern_flight_record_stop(&recorder_, kOk), kOk);
  EXPECT_EQ(tern_flight_record_pending(&recorder_), before_ + 8);
  tern_flight_record_clear(&recorder_);
  EXPECT_EQ(tern_flight_record_pending(&recorder_), 0u);
  std::size_t used = 0;
  EXPECT_EQ(tern_flight_record_close(&recorder_, &used), kOk);
  EXPECT_EQ(used, 16u);  // the length and the checksum
}

}  // namespace
