// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a recorder of flights refuses: null pointers, and counts and sizes that cannot be. A call that is refused leaves
// the record as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "record/envelope.hpp"
#include "tern/flight_record.hpp"
#include "tern/record.hpp"

namespace {

using tern::DepthView;
using tern::Status;

constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kHead = tern::kWordBytes * tern::kHeadWords;
constexpr tern::Pose kPose{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};

class FaultyRecord : public testing::Test {
 protected:
  FaultyRecord() : bytes_(std::size_t{1} << 16) {
    EXPECT_EQ(recorder_.begin(bytes_.data(), bytes_.size()), Status::kOk);
    before_ = recorder_.pending();
  }
  /// Refused, with nothing recorded.
  void expect_refused(Status status) {
    EXPECT_EQ(status, Status::kInvalidArgument);
    EXPECT_EQ(recorder_.pending(), before_);
  }
  /// Recorded in so many words besides the event's head.
  void expect_recorded(Status status, std::size_t words) {
    EXPECT_EQ(status, Status::kOk);
    EXPECT_EQ(recorder_.pending(), before_ + tern::kWordBytes * (1 + words));
    before_ = recorder_.pending();
  }
  /// The call itself was refused, so there is nothing to record.
  void expect_passed_over(Status status) {
    EXPECT_EQ(status, Status::kOk);
    EXPECT_EQ(recorder_.pending(), before_);
  }

  std::vector<std::uint8_t> bytes_;
  tern::FlightRecorder recorder_;
  std::size_t before_;
};

TEST_F(FaultyRecord, PriorsMustBeThereAndFit) {
  tern::MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.2, {64, 64, 16}, 0.3);
  const tern::Box box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  const tern::Cylinder cylinder{{1.0, 1.0, 0.0}, 0.5, 2.0};
  const auto bind = [&](const tern::Box* boxes, std::int32_t box_count, const tern::Cylinder* cylinders,
                        std::int32_t cylinder_count) {
    spec.prior = boxes;
    spec.prior_count = box_count;
    spec.prior_cylinders = cylinders;
    spec.prior_cylinder_count = cylinder_count;
    return recorder_.bind(spec, Status::kOk);
  };
  for (const std::int32_t count : {-1, tern::kMaxPriorBoxes + 1, kMost}) {
    expect_refused(bind(&box, count, nullptr, 0));
    expect_refused(bind(nullptr, 0, &cylinder, count));
  }
  expect_refused(bind(nullptr, 1, nullptr, 0));
  expect_refused(bind(&box, 1, nullptr, 1));
  EXPECT_EQ(bind(&box, 1, &cylinder, 1), Status::kOk);
  EXPECT_GT(recorder_.pending(), before_);
}

TEST_F(FaultyRecord, PointsMustBeThere) {
  const tern::Vec3 point{1.0, 2.0, 3.0};
  expect_refused(recorder_.mark_points(nullptr, 1, Status::kOk));
  expect_passed_over(recorder_.mark_points(nullptr, 1, Status::kNonFiniteInput));
  expect_recorded(recorder_.mark_points(nullptr, 0, Status::kOk), 1);
  expect_recorded(recorder_.mark_points(&point, 1, Status::kOk), 1 + 3);
  expect_refused(recorder_.scan(nullptr, 1, point, 0, Status::kRunning));
  expect_passed_over(recorder_.scan(nullptr, 1, point, 0, Status::kNonFiniteInput));
  expect_recorded(recorder_.scan(nullptr, 0, point, 0, Status::kRunning), 1 + 3 + 1);
  expect_recorded(recorder_.scan(&point, 1, point, 0, Status::kRunning), 1 + 3 + 1 + 3);
  const float range = 2.5f;
  expect_refused(recorder_.scan({nullptr, &range, 1, 0.1, 9.0}, point, 0, Status::kRunning));
  expect_refused(recorder_.scan({&point, nullptr, 1, 0.1, 9.0}, point, 0, Status::kRunning));
  expect_passed_over(recorder_.scan({nullptr, nullptr, 1, 0.1, 9.0}, point, 0, Status::kInvalidArgument));
  expect_recorded(recorder_.scan({nullptr, nullptr, 0, 0.1, 9.0}, point, 0, Status::kRunning), 1 + 3 + 2 + 1);
  expect_recorded(recorder_.scan({&point, &range, 1, 0.1, 9.0}, point, 0, Status::kRunning), 1 + 3 + 2 + 1 + 4);
}

/// A picture of 2 x 2 pixels, changed.
template <typename Change>
DepthView view(const std::uint16_t* depths, Change change) {
  DepthView view{};
  view.z16 = depths;
  view.width = view.height = view.stride = 2;
  change(view);
  return view;
}

TEST_F(FaultyRecord, ViewsMustBeViews) {
  const std::uint16_t depths[4] = {1, 2, 3, 4};
  const float floats[4] = {1.0f, 2.0f, 3.0f, 4.0f};
  const auto expect_no_view = [&](auto change) {
    const DepthView none = view(depths, change);
    EXPECT_EQ(tern::frame_record_bytes(none), 0u);
    expect_refused(recorder_.frame(none, kPose, 0, Status::kRunning));
  };
  expect_no_view([](DepthView& v) { v.z16 = nullptr; });
  expect_no_view([&](DepthView& v) { v.z32 = floats; });  // which of the two?
  for (const std::int32_t size : {0, -1, -kMost}) {
    expect_no_view([=](DepthView& v) { v.width = size; });
    expect_no_view([=](DepthView& v) { v.height = size; });
    expect_no_view([=](DepthView& v) { v.stride = size; });
  }
  expect_no_view([](DepthView& v) { v.stride = 1; });
  expect_no_view([](DepthView& v) { v.width = v.stride = tern::kMaxPixels / 2 + 1; });
  expect_no_view([](DepthView& v) { v.width = v.height = v.stride = kMost; });
  const DepthView most = view(depths, [](DepthView& v) { v.width = v.stride = tern::kMaxPixels / 2; });
  EXPECT_GT(tern::frame_record_bytes(most), std::size_t{2} * tern::kMaxPixels);
  const DepthView good = view(depths, [](DepthView&) {});
  EXPECT_EQ(recorder_.frame(good, kPose, 0, Status::kRunning), Status::kOk);
  EXPECT_LE(recorder_.pending(), before_ + tern::frame_record_bytes(good));
}

TEST_F(FaultyRecord, FencesMustBeThereAndFit) {
  const tern::Limits limits{{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}};
  const tern::Halfspace plane{{0.0, 0.0, 1.0}, 3.0};
  const auto start = [&](const tern::Fence* fences, std::int32_t count, Status answer = Status::kOk) {
    tern::FlightSpec spec = tern::flight_spec(limits);
    spec.fences = fences;
    spec.fence_count = count;
    return recorder_.start(spec, {0.0, 0.0, 1.0}, 0, answer);
  };
  const tern::Fence good{&plane, 1, tern::FenceKind::kKeepIn};
  for (const std::int32_t count : {-1, tern::kMaxFences + 1, kMost}) expect_refused(start(&good, count));
  expect_refused(start(nullptr, 1));
  for (const std::int32_t count : {-1, tern::kMaxFencePlanes + 1, kMost}) {
    const tern::Fence bad{&plane, count, tern::FenceKind::kKeepIn};
    expect_refused(start(&bad, 1));
  }
  const tern::Fence empty{nullptr, 1, tern::FenceKind::kKeepIn};
  expect_refused(start(&empty, 1));
  expect_passed_over(start(nullptr, 1, Status::kInvalidArgument));
  EXPECT_EQ(start(&good, 1), Status::kOk);
  EXPECT_GT(recorder_.pending(), before_);
}

TEST_F(FaultyRecord, MissionsMustBeThereAndFit) {
  const tern::Via point{{1.0, 0.0, 1.0}, 0.1};
  const auto set = [this](const tern::Via* points, std::int32_t count) {
    return recorder_.set_mission(points, count, tern::ViaPolicy::kSkip, Status::kOk);
  };
  for (const std::int32_t count : {-1, tern::kMaxMissionPoints + 1, kMost}) expect_refused(set(&point, count));
  expect_refused(set(nullptr, 1));
  EXPECT_EQ(set(&point, 1), Status::kOk);
  EXPECT_GT(recorder_.pending(), before_);
}

/// Headings count where the mode reads them.
TEST_F(FaultyRecord, HeadingsMustBeThereAndFit) {
  const tern::Heading heading{1.0, 0.0};
  const auto set = [&](tern::FlightYawMode mode, const tern::Heading* headings, std::int32_t count,
                       Status answer = Status::kOk) {
    tern::FlightYaw yaw{};
    yaw.mode = mode;
    yaw.headings = headings;
    yaw.heading_count = count;
    return recorder_.set_yaw(yaw, answer);
  };
  constexpr auto kAtPoints = tern::FlightYawMode::kAtPoints;
  for (const std::int32_t count : {-1, tern::kMaxMissionPoints + 1, kMost}) {
    expect_refused(set(kAtPoints, &heading, count));
  }
  expect_refused(set(kAtPoints, nullptr, 1));
  expect_passed_over(set(kAtPoints, nullptr, 1, Status::kInvalidArgument));
  EXPECT_EQ(set(kAtPoints, &heading, 1), Status::kOk);
  const std::size_t with_one = recorder_.pending() - before_;
  before_ = recorder_.pending();
  EXPECT_EQ(set(tern::FlightYawMode::kFixed, nullptr, kMost), Status::kOk);
  EXPECT_EQ(recorder_.pending() - before_, with_one - 2 * tern::kWordBytes);  // without a cosine and a sine
}

TEST(FlightRecordFaults, NothingIsClosedBeforeItBegins) {
  tern::FlightRecorder recorder;
  std::size_t used = 77;
  EXPECT_EQ(recorder.close(&used), Status::kInvalidArgument);
  EXPECT_EQ(used, 77u);
  std::uint8_t bytes[tern::kFlightRecordBytes];
  ASSERT_EQ(recorder.begin(bytes, sizeof bytes), Status::kOk);
  EXPECT_EQ(recorder.close(nullptr), Status::kInvalidArgument);
  ASSERT_EQ(recorder.close(&used), Status::kOk);
  EXPECT_EQ(used, sizeof bytes);
}

/// The shortest record of a flight has a head, a length and a checksum. Without its last word it is none.
TEST(FlightRecordFaults, ARecordWithoutALengthIsDamaged) {
  std::uint8_t bytes[tern::kFlightRecordBytes];
  tern::FlightRecorder recorder;
  ASSERT_EQ(recorder.begin(bytes, sizeof bytes), Status::kOk);
  std::size_t used = 0;
  ASSERT_EQ(recorder.close(&used), Status::kOk);
  ASSERT_EQ(used, kHead + 2 * tern::kWordBytes);
  std::uint64_t configuration = 0;
  EXPECT_EQ(check_envelope(tern::RecordKind::kFlight, bytes, used, configuration), Status::kOk);
  EXPECT_EQ(configuration, tern::kConfigurationHash);
  EXPECT_EQ(check_envelope(tern::RecordKind::kFlight, bytes, used - tern::kWordBytes, configuration),
            Status::kRecordDamaged);
}

TEST(FlightRecordFaults, TheKindIsThatOfARecord) {
  std::uint8_t bytes[tern::kFlightRecordBytes];
  tern::FlightRecorder recorder;
  ASSERT_EQ(recorder.begin(bytes, sizeof bytes), Status::kOk);
  std::size_t used = 0;
  ASSERT_EQ(recorder.close(&used), Status::kOk);
  EXPECT_EQ(tern::record_kind(bytes, used), static_cast<std::uint64_t>(tern::RecordKind::kFlight));
  tern::WordWriter plan(bytes, sizeof bytes);
  open_envelope(tern::RecordKind::kPlan, plan);
  EXPECT_EQ(tern::record_kind(bytes, used), static_cast<std::uint64_t>(tern::RecordKind::kPlan));
  EXPECT_EQ(tern::record_kind(bytes, kHead), 0u);  // too short for any record
  EXPECT_EQ(tern::record_kind(bytes, 0), 0u);
  bytes[0] ^= 1;
  EXPECT_EQ(tern::record_kind(bytes, used), 0u);
}

}  // namespace
