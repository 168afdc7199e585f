// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through worlds in which ticks take long, there and back, with noise and wrong pixels.
#include "timing/hard_flights.hpp"

#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/flight_ticks.hpp"
#include "timing/hard_world.hpp"

namespace tern_timing {
namespace {

using tern::Status;
using tern::Vec3;
using tern_golden::FlightSetting;

/// Part of a depth that it may be off by, and of the pixels that show anything.
constexpr double kNoise = 0.01;
constexpr double kWrong = 0.01;
/// Between two beams of the lidar, rad, and its rows on either side of the horizon.
constexpr double kBeam = 0.02;
constexpr int kBeams = 314;
constexpr double kScanPixel = 0.045;  ///< rad: the finest for which the camera's pixels suffice
constexpr int kRows = 18;
constexpr std::size_t kPoints = std::size_t{kBeams} * (2 * kRows + 1);
/// How often things that move are measured, ns, and for how long each goes one way before it turns back.
constexpr std::int64_t kMeasured = 100000000;
constexpr std::int64_t kTurns = 4000000000;
/// A vehicle that comes through so few plans has hardly flown.
constexpr std::uint32_t kFewCommits = 10;

TERN_BOARD_LARGE Vec3 points[kPoints];

enum class Sensor { kCamera, kLidar };

struct HardFlight {
  const char* name;
  const HardWorld& world;
  FlightSetting setting;
  Sensor sensor;
  Vec3 start, goal;
  double seconds;
  std::uint32_t things = 0;  ///< that move, between start and goal
};

double disturbed(double depth, double range, Dice& dice) {
  if (dice.unit() < kWrong) return dice.in(0.3, 1.5 * range);
  return depth * dice.in(1.0 - kNoise, 1.0 + kNoise);
}

/// The camera looks along the heading, level.
void take(const HardFlight& flight, const Vec3& eye, const tern_golden::Heading& h, Dice& dice,
          tern_golden::FlightFrame& frame) {
  const FlightSetting& s = flight.setting;
  const double focal = 0.5 * s.width;
  for (std::int32_t u = 0; u < s.width; ++u) {
    const double right = (u - 0.5 * (s.width - 1)) / focal;
    const HardWorld::Column column = flight.world.look({eye.x, eye.y, h.c + right * h.s, h.s - right * h.c});
    for (std::int32_t v = 0; v < s.height; ++v) {
      const double slope = (0.5 * (s.height - 1) - v) / focal;
      const double depth = disturbed(column.depth(eye.z, slope), s.range, dice);
      frame.depths[v * s.width + u] = static_cast<std::uint16_t>(depth * 1000.0);
    }
  }
  frame.pose = tern_golden::pose_of(eye, h);
}

/// All around; no return is wrong. Beams turn by a rotation of their own, for there is no sine here.
void scan(const HardFlight& flight, const Vec3& eye, Dice& dice) {
  const double sine = kBeam - kBeam * kBeam * kBeam / 6.0;
  const double cosine = __builtin_sqrt(1.0 - sine * sine);
  double c = 1.0;
  double s = 0.0;
  Vec3* point = points;
  for (int beam = 0; beam < kBeams; ++beam) {
    const HardWorld::Column column = flight.world.look({eye.x, eye.y, c, s});
    for (int row = -kRows; row <= kRows; ++row) {
      const double slope = row * kBeam;
      const double depth = column.depth(eye.z, slope) * dice.in(1.0 - kNoise, 1.0 + kNoise);
      *point++ = {eye.x + depth * c, eye.y + depth * s, eye.z + depth * slope};
    }
    const double turned = c * cosine - s * sine;
    s = s * cosine + c * sine;
    c = turned;
  }
}

tern::MapSpec map_spec_of(const HardFlight& flight) {
  tern::MapSpec spec = tern_golden::map_spec_of(flight.setting);
  spec.depth_margin += flight.setting.range * kNoise;
  spec.support = 2;
  if (flight.sensor == Sensor::kLidar) spec.scan_pixel = kScanPixel;
  return spec;
}

tern::FlightYaw yaw_of() {
  tern::FlightYaw yaw{};
  yaw.mode = tern::FlightYawMode::kTowardsUnseen;
  yaw.acceleration_max = 10.0;
  yaw.start = {1.0, 0.0};
  return yaw;
}

/// Begins the flight at rest, with the nose planned.
Status begin(const HardFlight& hard, FlightMemory& memory, tern::RollingMap& map, tern::Planner& planner,
             tern::Flight& flight) {
  const FlightSetting& s = hard.setting;
  Status status = map.bind(map_spec_of(hard), memory.map, sizeof memory.map / sizeof memory.map[0]);
  if (status != Status::kOk) return status;
  map.assume_free(hard.start, tern_golden::kRadius + 6.0 * s.cell);
  status = flight.start(tern_golden::flight_spec_of(s), map, planner, memory.flight,
                        sizeof memory.flight / sizeof memory.flight[0], hard.start, 0);
  if (status == Status::kOk) status = flight.set_yaw(yaw_of());
  return status == Status::kOk ? flight.set_goal(hard.goal) : status;
}

/// A frame every third tick, or a scan every tenth, as soon as the map takes it.
void sense(const HardFlight& hard, FlightMemory& memory, tern::RollingMap& map, const tern::Flight& flight,
           std::int64_t t, Dice& dice) {
  const Vec3 eye = flight.command(t).sample.position;
  if (hard.sensor == Sensor::kLidar) {
    scan(hard, eye, dice);
    map.begin_scan(points, kPoints, eye, t);
    return;
  }
  const tern::YawSample yaw = flight.yaw(t);
  take(hard, eye, {yaw.yaw.cosine, yaw.yaw.sine}, dice, memory.frame);
  map.begin_frame(tern_golden::view_of(hard.setting, memory.frame.depths), memory.frame.pose, t);
}

/// Tells the flight of balls that go to and fro across the way, at 0.25 to 1.5 m/s. Each may do 1 m/s^2.
void tell(const HardFlight& hard, std::int64_t t, tern::Flight& flight) {
  Dice dice(4242);
  for (std::uint32_t id = 0; id < hard.things; ++id) {
    const std::int64_t phase = (t + static_cast<std::int64_t>(dice.in(0.0, 4.0) * 1e9)) % (2 * kTurns);
    const double speed = dice.in(0.25, 1.5);
    const Vec3 middle{dice.in(hard.start.x + 3.0, hard.goal.x), dice.in(-6.0, 6.0), dice.in(0.5, 2.5)};
    const double side = 1e-9 * static_cast<double>(phase < kTurns ? phase : 2 * kTurns - phase) - 2.0;
    tern::Track track;
    track.id = id;
    track.measured = t;
    track.position = {middle.x, middle.y + speed * side, middle.z};
    track.velocity = {0.0, phase < kTurns ? speed : -speed, 0.0};
    track.radius = 0.3;
    track.error = 0.05;
    track.error_speed = 0.1;
    track.error_growth = 1.0;
    track.reach = 2.0;
    flight.update_track(track);
  }
}

bool fly(const HardFlight& hard, FlightMemory& memory) {
  const FlightSetting& s = hard.setting;
  tern::RollingMap map;
  tern::Planner planner(&memory.workspace, sizeof memory.workspace);
  tern::Flight flight;
  const Status begun = begin(hard, memory, map, planner, flight);
  tern_golden::TickCosts costs;
  tern::FlightReport before{};
  Dice dice(4711);
  bool back = false;
  std::int64_t due = 0;
  int arrived = 0;
  const std::int64_t end = static_cast<std::int64_t>(hard.seconds * 1e9);
  for (std::int64_t t = 0; t < end && begun == Status::kOk; t += s.tick) {
    if (t >= due && !map.busy()) {
      sense(hard, memory, map, flight, t, dice);
      due = t + (hard.sensor == Sensor::kLidar ? 100000000 : 33000000);
    }
    if (t % kMeasured == 0) tell(hard, t, flight);
    tern::FlightReport report{};
    const std::uint64_t counted = tern_board::counter();
    flight.tick(t, report);
    costs.add(before, report, tern_board::counter() - counted);
    const bool rests = report.mode == tern::FlightMode::kRest && report.reason != tern::FlightReason::kNone;
    if (rests) {
      arrived += report.reason == tern::FlightReason::kArrived ? 1 : 0;
      back = !back;
      flight.set_goal(back ? hard.start : hard.goal);
    }
    before = report;
  }
  tern_board::print("# ", hard.name, ": ", tern::status_name(begun), ", ", hard.world.count(), " things, ",
                    before.asked, " plans asked, ", before.committed, " committed, ", before.dropped, " dropped, ",
                    arrived, " arrivals\n");
  print_ticks(hard.name, costs, s.work_per_tick);
  return before.committed >= kFewCommits;
}

}  // namespace

void print_ticks(const char* name, const tern_golden::TickCosts& costs, std::uint32_t work_per_tick) {
  for (int k = 0; k < tern_golden::kTickKinds; ++k) {
    const tern_golden::TickCosts::Cost& cost = costs.most[k];
    if (cost.count == 0) continue;
    tern_board::print(name, ",", tern_golden::kTickNames[k], ",", cost.count, ",", cost.work, ",", work_per_tick, "\n");
  }
}

bool print_hard_flights(FlightMemory& memory) {
  static const Storey storey;
  static const Thicket thicket;
  FlightSetting full = tern_golden::kFullFlight;
  full.v = 4.0;
  const FlightSetting small = tern_golden::kSmallFlight;
  const Vec3 corner{-0.5, -2.5, 1.3};
  const Vec3 other_corner{14.5, 3.0, 1.3};
  const Vec3 edge{0.0, 0.0, 1.5};
  const Vec3 other_edge{28.0, 0.0, 1.5};
  const HardFlight flights[] = {
      {"flight_storey", storey, full, Sensor::kCamera, corner, other_corner, 20.0},
      {"flight_thicket", thicket, full, Sensor::kCamera, edge, other_edge, 12.0},
      {"flight_lidar", thicket, full, Sensor::kLidar, edge, other_edge, 12.0},
      {"flight_crowd", thicket, full, Sensor::kCamera, edge, other_edge, 12.0, tern::kMaxFlightTracks},
      {"flight_storey_mcu", storey, small, Sensor::kCamera, corner, other_corner, 20.0},
      {"flight_thicket_mcu", thicket, small, Sensor::kCamera, edge, other_edge, 12.0},
  };
  bool flown = true;
  for (const HardFlight& flight : flights) flown = fly(flight, memory) && flown;
  return flown;
}

}  // namespace tern_timing
