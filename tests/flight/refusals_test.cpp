// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What no flight begins with, and the field that the refusal names. Malformed fences get the same answers from flights,
// plans and proofs.
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <vector>

#include "support/flight_room.hpp"
#include "support/numbers.hpp"
#include "support/world.hpp"
#include "tern/proof.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::kInfinity;
using tern_test::kNan;
using tern_test::OwnedMap;

struct Answer {
  Status status;
  Field field;
  std::int32_t fence;
};

bool operator==(const Answer& a, const Answer& b) {
  return a.status == b.status && a.field == b.field && a.fence == b.fence;
}

std::ostream& operator<<(std::ostream& out, const Answer& answer) {
  return out << status_name(answer.status) << ", " << field_name(answer.field) << ", fence " << answer.fence;
}

constexpr Answer kStarts{Status::kOk, Field::kNone, kNoFence};

Answer invalid(Field field) {
  return {Status::kInvalidArgument, field, kNoFence};
}

/// A flight that began; each call begins it anew.
struct Starting : FlightRoom {
  Answer begin(const RollingMap& on) {
    FlightRefusal refusal{Field::kCell, 7};
    const Status status = flight.start(how, on, planner, given, count, position, 0, &refusal);
    EXPECT_EQ(flight.set_goal(start), status == Status::kOk ? Status::kOk : Status::kInvalidArgument);
    return {status, refusal.field, refusal.fence};
  }
  Answer begin() { return begin(map()); }

  FlightSpec how = FlightRoom::spec;
  Vec3 position = FlightRoom::start;
  std::uint64_t* given = words.data();
  std::size_t count = words.size();
};

/// The answer to a start of which one thing is changed.
template <class Change>
Answer answer_to(Change change) {
  Starting starting;
  change(starting);
  return starting.begin();
}

TEST(FlightRefusals, NameTheFieldOfTheSpec) {
  EXPECT_EQ(answer_to([](Starting&) {}), kStarts);
  EXPECT_EQ(answer_to([](Starting& s) { s.how.tick = 0; }), invalid(Field::kTick));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.tick = std::int64_t{1} << 50; }), invalid(Field::kTick));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.work_per_tick = 255; }), invalid(Field::kWork));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.plan_work = 0; }), invalid(Field::kWork));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.near = -1.0; }), invalid(Field::kNear));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.yaw_rate = 5e-4; }), invalid(Field::kYawRate));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.yaw_rate = -1.0; }), invalid(Field::kYawRate));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.stale_after = -1; }), invalid(Field::kStaleAfter));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.horizon = 0.0; }), invalid(Field::kHorizon));
}

TEST(FlightRefusals, SensorsThatSeeNothingOrCannotBe) {
  const auto with = [](auto change) { return answer_to([change](Starting& s) { change(s.how.sensor); }); };
  const Answer refused = invalid(Field::kSensor);
  EXPECT_EQ(with([](FlightSensor& s) { s.horizontal = 2.0 * M_PI; }), kStarts);
  EXPECT_EQ(with([](FlightSensor& s) { s.horizontal = 6.29; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.horizontal = 0.0; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.vertical = 3.0; }), kStarts);
  EXPECT_EQ(with([](FlightSensor& s) { s.vertical = 3.01; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.vertical = 0.0; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.pitch_max = -0.1; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.pitch_max = 1.51; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.raised = -1.51; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.pitch_min = -1.5; }), kStarts);
  EXPECT_EQ(with([](FlightSensor& s) { s.pitch_min = -1.51; }), refused);
  EXPECT_EQ(with([](FlightSensor& s) { s.nearest = -0.1; }), refused);
}

/// The window is 32 m long. Plans that lead half of that ahead, or further, would leave it before it can follow.
TEST(FlightRefusals, HorizonsOfHalfTheWindow) {
  EXPECT_EQ(answer_to([](Starting& s) { s.how.horizon = 15.9; }), kStarts);
  for (const double horizon : {16.0, 17.0, 1e9}) {
    EXPECT_EQ(answer_to([horizon](Starting& s) { s.how.horizon = horizon; }), invalid(Field::kHorizon)) << horizon;
  }
}

TEST(FlightRefusals, NameTheFieldThatIsNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    const auto refused = [](Field field) { return Answer{Status::kNonFiniteInput, field, kNoFence}; };
    EXPECT_EQ(answer_to([bad](Starting& s) { s.position.x = bad; }), refused(Field::kStartPosition));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.horizon = bad; }), refused(Field::kHorizon));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.near = bad; }), refused(Field::kNear));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.yaw_rate = bad; }), refused(Field::kYawRate));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.sensor.vertical = bad; }), refused(Field::kSensor));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.sensor.pitch_min = bad; }), refused(Field::kSensor));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.sensor.offset.z = bad; }), refused(Field::kSensor));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.time_weight = bad; }), refused(Field::kTimeWeight));
    EXPECT_EQ(answer_to([bad](Starting& s) { s.how.limits.a_horizontal = bad; }), refused(Field::kAHorizontal));
  }
}

TEST(FlightRefusals, NameTheLimit) {
  const auto refused = [](Field field) { return Answer{Status::kLimitsInvalid, field, kNoFence}; };
  EXPECT_EQ(answer_to([](Starting& s) { s.how.limits.v_max.x = 0.0; }), refused(Field::kVMax));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.limits.a_min.z = 1.0; }), refused(Field::kAMin));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.limits.j_max.x = -1.0; }), refused(Field::kJMax));
  EXPECT_EQ(answer_to([](Starting& s) { s.how.time_weight = 0.0; }), refused(Field::kTimeWeight));
}

TEST(FlightRefusals, NameTheMapAndTheWords) {
  Starting starting;
  EXPECT_EQ(starting.begin(RollingMap{}), invalid(Field::kMap));
  MapSpec point = FlightRoom::map_spec();
  point.radius = 0.0;
  OwnedMap bare(point);
  ASSERT_EQ(bare.map.assume_free(starting.position, 40.0), Status::kOk);
  EXPECT_EQ(starting.begin(bare.map), invalid(Field::kRadius));
  --starting.count;
  EXPECT_EQ(starting.begin(), invalid(Field::kStorage));
  ++starting.count;
  starting.given = nullptr;
  EXPECT_EQ(starting.begin(), invalid(Field::kStorage));
  starting.given = starting.words.data();
  ASSERT_EQ(starting.map().follow({0.0, 8.0, 1.0}), Status::kRunning);
  EXPECT_EQ(starting.begin(), invalid(Field::kMap));
  while (starting.map().step(100000) == Status::kRunning) {
  }
  EXPECT_EQ(starting.begin(), kStarts);
}

TEST(FlightRefusals, NameTheStart) {
  Starting starting;
  const Answer occupied{Status::kStartOccupied, Field::kStartPosition, kNoFence};
  starting.position = {1e6, 0.0, 0.0};
  EXPECT_EQ(starting.begin(), occupied);
  starting.position = starting.start;
  starting.mark({{0.5, 0.0, 1.0}, {0.75, 0.25, 1.25}});
  EXPECT_EQ(starting.begin(), occupied);
}

TEST(FlightRefusals, NameTheFenceThatTheStartBreaks) {
  Starting starting;
  Halfspace all[kBoxPlanes];
  box_planes({{-16.0, -16.0, -2.0}, {16.0, 16.0, 4.0}}, all);
  const Halfspace elsewhere{{-1.0, 0.0, 0.0}, -5.0};  // x >= 5
  const Halfspace around{{0.0, 0.0, -1.0}, -1.5};     // z >= 1.5, and the vehicle is at 1.125 with a radius of 0.5
  const Fence fences[] = {{all, 6, FenceKind::kKeepIn}, {&elsewhere, 1, FenceKind::kKeepIn}};
  starting.how.fences = fences;
  starting.how.fence_count = 2;
  EXPECT_EQ(starting.begin(), (Answer{Status::kStartFenced, Field::kStartPosition, 1}));
  const Fence out[] = {{&around, 1, FenceKind::kKeepOut}};
  starting.how.fences = out;
  starting.how.fence_count = 1;
  EXPECT_EQ(starting.begin(), (Answer{Status::kStartFenced, Field::kStartPosition, 0}));
  starting.how.fences = fences;
  EXPECT_EQ(starting.begin(), kStarts);
}

/// More fences and half-spaces than fit, all well formed: keep-ins around the origin.
struct Malformed {
  Malformed() {
    Halfspace box[kBoxPlanes];
    box_planes({{-3.0, -3.0, -3.0}, {3.0, 3.0, 3.0}}, box);
    for (std::size_t p = 0; p < planes.size(); ++p) planes[p] = box[p % kBoxPlanes];
    for (Fence& fence : fences) fence = {planes.data(), 1, FenceKind::kKeepIn};
  }

  std::vector<Halfspace> planes = std::vector<Halfspace>(kMaxFencePlanes + 1);
  std::vector<Fence> fences = std::vector<Fence>(kMaxFences + 1);
  const Fence* list = fences.data();
  std::int32_t count = 2;
};

Answer of_flight(const Malformed& given) {
  Starting starting;
  starting.how.fences = given.list;
  starting.how.fence_count = given.count;
  return starting.begin();
}

Answer of_plan(const Malformed& given) {
  tern_test::World world({40, 40, 20}, 0.1, 0.2, {-2.0, -2.0, -1.0});
  world.from({0.5, 2.0, 1.0}).to({3.5, 2.0, 1.0});
  world.request.fences = given.list;
  world.request.fence_count = given.count;
  const Status status = world.plan();
  return {status, world.report.field, world.report.fence};
}

Answer of_proof(const Malformed& given) {
  const FlightRoom room;
  ProofGrounds grounds;
  grounds.fences = given.list;
  grounds.fence_count = given.count;
  Trajectory still{};
  still.count = 1;
  still.segments[0].duration = 1.0;
  Proof proof;
  const Status begun = proof.begin(room.owned.map.safe(), still, 0.0, nullptr, Beyond::kEmpty, grounds);
  if (begun == Status::kRunning) return {proof.step(kProofPieces), Field::kNone, proof.report().fence};
  EXPECT_EQ(proof.report().finding, Finding::kMalformed);
  EXPECT_EQ(proof.report().until, 0.0);
  return {begun, Field::kFences, proof.report().fence};
}

template <class Change>
void expect_everywhere(const Answer& wanted, Change change) {
  Malformed given;
  change(given);
  EXPECT_EQ(of_flight(given), wanted) << "flight";
  EXPECT_EQ(of_plan(given), wanted) << "plan";
  EXPECT_EQ(of_proof(given), wanted) << "proof";
}

Answer fences(Status status, std::int32_t fence) {
  return {status, Field::kFences, fence};
}

TEST(FlightRefusals, FencesThatAreWellFormed) {
  expect_everywhere(kStarts, [](Malformed&) {});
  expect_everywhere(kStarts, [](Malformed& m) { m.count = kMaxFences; });
  expect_everywhere(kStarts, [](Malformed& m) { m.count = 0; });
  expect_everywhere(kStarts, [](Malformed& m) {
    m.list = nullptr;
    m.count = 0;
  });
}

TEST(FlightRefusals, ListsOfFencesThatAreNone) {
  expect_everywhere(fences(Status::kInvalidArgument, kNoFence), [](Malformed& m) { m.list = nullptr; });
  for (const std::int32_t count : {-1, std::numeric_limits<std::int32_t>::min()}) {
    expect_everywhere(fences(Status::kInvalidArgument, kNoFence), [count](Malformed& m) { m.count = count; });
  }
  expect_everywhere(fences(Status::kFencesFull, kNoFence), [](Malformed& m) { m.count = kMaxFences + 1; });
  expect_everywhere(fences(Status::kFencesFull, kNoFence),
                    [](Malformed& m) { m.count = std::numeric_limits<std::int32_t>::max(); });
}

TEST(FlightRefusals, FencesThatAreNone) {
  const Answer wrong = fences(Status::kInvalidArgument, 1);
  expect_everywhere(wrong, [](Malformed& m) { m.fences[1].planes = nullptr; });
  expect_everywhere(wrong, [](Malformed& m) { m.fences[1].count = 0; });
  expect_everywhere(wrong, [](Malformed& m) { m.fences[1].count = -3; });
  expect_everywhere(wrong, [](Malformed& m) { m.fences[1].kind = static_cast<FenceKind>(9); });
  expect_everywhere(fences(Status::kFencePlanesFull, 0), [](Malformed& m) { m.fences[0].count = kMaxFencePlanes + 1; });
  expect_everywhere(fences(Status::kFencePlanesFull, 1), [](Malformed& m) { m.fences[1].count = kMaxFencePlanes; });
}

TEST(FlightRefusals, HalfSpacesThatAreNone) {
  const auto with = [](const Halfspace& plane) {
    return [plane](Malformed& m) {
      m.planes[2] = plane;
      m.fences[1].planes = m.planes.data() + 2;
    };
  };
  for (const Vec3& normal : {Vec3{0.0, 0.0, 0.0}, Vec3{1e7, 0.0, 0.0}, Vec3{0.0, 1e-7, 0.0}, Vec3{1e300, 0.0, 0.0}}) {
    expect_everywhere(fences(Status::kInvalidArgument, 1), with({normal, 3.0}));
  }
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    expect_everywhere(fences(Status::kNonFiniteInput, 1), with({{bad, 0.0, 0.0}, 3.0}));
    expect_everywhere(fences(Status::kNonFiniteInput, 1), with({{0.0, 0.0, bad}, 3.0}));
    expect_everywhere(fences(Status::kNonFiniteInput, 1), with({{1.0, 0.0, 0.0}, bad}));
  }
  expect_everywhere(fences(Status::kNonFiniteInput, 1), with({{1e-5, 0.0, 0.0}, 1e305}));  // 1e310 m away
}

TEST(FlightRefusals, FencesWithoutAPoint) {
  for (const FenceKind kind : {FenceKind::kKeepIn, FenceKind::kKeepOut}) {
    expect_everywhere(fences(Status::kFenceEmpty, 1), [kind](Malformed& m) {
      for (std::size_t p = 0; p < kBoxPlanes; ++p) {
        const Halfspace& h = m.planes[p];
        m.planes[kBoxPlanes + p] = {{-h.normal.x, -h.normal.y, -h.normal.z}, -h.offset};
      }
      m.fences[1] = {m.planes.data() + kBoxPlanes, kBoxPlanes, kind};
    });
  }
  expect_everywhere(fences(Status::kFenceEmpty, 1), [](Malformed& m) {  // x <= 3, but for the other one
    m.planes[1] = {{-1.0, 0.0, 0.0}, -4.0};
    m.fences[1].planes = m.planes.data() + 1;
  });
}

}  // namespace
