// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight through a small world of pillars that is the same on every target: no file, no heap and no libm. Its frames
// come from a camera, or from a recording of them. The hash is over every command.
#ifndef TERN_TESTS_GOLDEN_FLIGHT_RUN_HPP
#define TERN_TESTS_GOLDEN_FLIGHT_RUN_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tern/flight.hpp"
#include "tern/flight_record.hpp"

namespace tern_golden {

/// What is flown.
struct FlightSetting {
  double cell;
  tern::Voxel window;
  std::int32_t width, height;  ///< pixels; 90 degrees wide
  double range;
  std::int64_t tick;  ///< nanoseconds
  std::uint32_t work_per_tick, plan_work;
  double v, a;
};

/// A microcontroller's, and a companion computer's.
constexpr FlightSetting kSmallFlight{0.25, {128, 64, 16}, 80, 60, 6.0, 20000000, 1500, 18000, 2.5, 4.0};
constexpr FlightSetting kFullFlight{0.2, {256, 150, 20}, 160, 120, 10.0, 10000000, 4000, 16000, 5.0, 6.0};

constexpr std::int32_t kMostPixels = 160 * 120;

/// A depth image in millimetres.
struct FlightFrame {
  tern::Pose pose;
  std::uint16_t depths[kMostPixels];
};

/// Which way the camera looks: a unit vector.
struct Heading {
  double c = 1.0;
  double s = 0.0;
};

constexpr int kPillars = 7;
/// The pillar that appears before the vehicle, the last one.
constexpr int kIntruder = kPillars - 1;
constexpr int kIntrusion = 150;   ///< the tick
constexpr int kTicks = 700;       ///< of a flight
constexpr int kSecondGoal = 580;  ///< the tick of a goal that nothing leads to
constexpr double kEyeHeight = 1.5;
constexpr double kRadius = 0.35;

/// Pillars with square bases on a floor, between walls.
struct PillarWorld {
  tern::Box boxes[kPillars];
  double floor = 0.0;

  PillarWorld() {
    std::uint32_t seed = 12345u;
    const auto next = [&seed] {
      seed = seed * 1664525u + 1013904223u;
      return static_cast<double>(seed >> 8) / 16777216.0;
    };
    for (tern::Box& box : boxes) {
      const double x = 3.5 + 10.0 * next();
      const double y = -3.5 + 7.0 * next();
      const double half = 0.15 + 0.15 * next();
      box = {{x - half, y - half, 0.0}, {x + half, y + half, 5.0}};
    }
    boxes[kIntruder] = {{-100.0, -100.0, 0.0}, {-99.0, -99.0, 1.0}};
  }

  /// Depth at which a ray with this direction meets something, at most `most`.
  double hit(const tern::Vec3& from, const tern::Vec3& along, double most) const {
    double best = most;
    if (along.z < 0.0 && -from.z / along.z < best) best = -from.z / along.z;
    for (const tern::Box& box : boxes) {
      double enter = 0.0;
      double leave = best;
      cut(from.x, along.x, box.lower.x, box.upper.x, enter, leave);
      cut(from.y, along.y, box.lower.y, box.upper.y, enter, leave);
      cut(from.z, along.z, box.lower.z, box.upper.z, enter, leave);
      if (enter < leave && enter > 0.0) best = enter;
    }
    return best;
  }

 private:
  static void cut(double from, double along, double lower, double upper, double& enter, double& leave) {
    const bool still = !(along < 0.0) && !(along > 0.0);
    if (still && (from < lower || from > upper)) leave = -1.0;
    if (still) return;
    const double a = (lower - from) / along;
    const double b = (upper - from) / along;
    const double first = a < b ? a : b;
    const double last = a < b ? b : a;
    if (first > enter) enter = first;
    if (last < leave) leave = last;
  }
};

/// Of a level camera: the turn by the heading after the turn from the camera's axes to ahead, left, up.
inline tern::Pose pose_of(const tern::Vec3& eye, const Heading& h) {
  const double w = __builtin_sqrt(0.5 * (1.0 + h.c));
  const double z = w > 1e-6 ? 0.5 * h.s / w : 1.0;
  return {eye, {0.5 * (w + z), -0.5 * (w + z), 0.5 * (w - z), 0.5 * (z - w)}};
}

/// Sees the world from where the vehicle is.
struct PillarCamera {
  PillarWorld world;

  void take(int, const FlightSetting& s, const tern::Vec3& eye, const Heading& h, FlightFrame& frame) const {
    const double focal = 0.5 * s.width;
    for (std::int32_t v = 0; v < s.height; ++v) {
      for (std::int32_t u = 0; u < s.width; ++u) {
        const double right = (u - 0.5 * (s.width - 1)) / focal;
        const double down = (v - 0.5 * (s.height - 1)) / focal;
        const double depth = world.hit(eye, {h.c + right * h.s, h.s - right * h.c, -down}, 50.0);
        frame.depths[v * s.width + u] = static_cast<std::uint16_t>(depth * 1000.0);
      }
    }
    frame.pose = pose_of(eye, h);
  }
};

/// Memory of a flight; too large for a stack.
template <std::size_t kMapWords, std::size_t kFlightWords>
struct FlightMemory {
  std::uint64_t map[kMapWords];
  std::uint64_t flight[kFlightWords];
  tern::Workspace workspace;
  FlightFrame frame;
};

struct FlightTotals {
  tern::Status started = tern::Status::kOk;
  std::uint64_t hash = 0xCBF29CE484222325u;
  std::uint32_t committed = 0;
  std::uint32_t most_work = 0;
  int arrived = -1;    ///< the tick
  int threatened = 0;  ///< ticks
};

inline std::uint64_t hash_command(std::uint64_t hash, const tern::Command& command) {
  unsigned char bytes[sizeof command];
  std::memcpy(bytes, &command, sizeof command);
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001B3u;
  return hash;
}

/// Turns towards a point by at most `sine` a tick.
inline void turn(Heading& h, const tern::Command& command, double sine) {
  const double x = command.look_at.x - command.sample.position.x;
  const double y = command.look_at.y - command.sample.position.y;
  const double size = __builtin_sqrt(x * x + y * y);
  if (!(size > 0.4)) return;
  const Heading to{x / size, y / size};
  const double cross = h.c * to.s - h.s * to.c;
  const double along = h.c * to.c + h.s * to.s;
  if (along > 0.0 && cross < sine && cross > -sine) {
    h = to;
    return;
  }
  const double s = cross < 0.0 ? -sine : sine;
  const double c = __builtin_sqrt(1.0 - s * s);
  h = {h.c * c - h.s * s, h.s * c + h.c * s};
  const double norm = __builtin_sqrt(h.c * h.c + h.s * h.s);
  h = {h.c / norm, h.s / norm};
}

inline tern::MapSpec map_spec_of(const FlightSetting& s) {
  const tern::Vec3 origin{-0.5 * s.window.x * s.cell, -0.5 * s.window.y * s.cell, -2.0 * s.cell};
  tern::MapSpec spec = tern::map_spec(origin, s.cell, s.window, kRadius);
  spec.range = s.range;
  spec.depth_margin = 0.02;
  spec.pose_margin = 0.0;
  spec.pixels = s.width * s.height;
  spec.slack = 8;
  return spec;
}

inline tern::FlightSpec flight_spec_of(const FlightSetting& s) {
  tern::Limits limits{{s.v, s.v, 2.0}, {s.a, s.a, 4.0}};
  limits.v_horizontal = s.v;
  limits.a_horizontal = s.a;
  tern::FlightSpec spec = tern::flight_spec(limits);
  spec.tick = s.tick;
  spec.work_per_tick = s.work_per_tick;
  spec.plan_work = s.plan_work;
  spec.horizon = 0.8 * s.range;
  spec.near = 2.5;  // a vehicle that flies its fastest towards where the pillar appears
  return spec;
}

inline tern::DepthView view_of(const FlightSetting& s, const std::uint16_t* depths) {
  const double focal = 0.5 * s.width;
  return {depths, nullptr, s.width, s.height, s.width, focal, focal, 0.5 * (s.width - 1), 0.5 * (s.height - 1),
          0.001,  0.1,     59.0,    0.0};
}

/// How long to fly, and who writes it down, if anybody.
struct FlightExtent {
  int ticks = kTicks;
  tern::FlightRecorder* recorder = nullptr;
};

/// Flies. `camera` gives the frames, `see(mode, report before, report, counts)` looks at each tick, and `count()` is
/// what ticks are measured with.
template <typename Memory, typename Camera, typename Count, typename See>
FlightTotals fly(const FlightSetting& s, Memory& memory, Camera& camera, PillarWorld& world, Count count, See see,
                 const FlightExtent& extent = {}) {
  FlightTotals totals;
  // Whatever a recorder is told before its begin() goes nowhere.
  tern::FlightRecorder nobody;
  tern::FlightRecorder& record = extent.recorder != nullptr ? *extent.recorder : nobody;
  tern::RollingMap map;
  tern::Planner planner(&memory.workspace, sizeof memory.workspace);
  tern::Flight flight;
  const tern::Vec3 start{0.0, 0.0, kEyeHeight};
  totals.started = map.bind(map_spec_of(s), memory.map, sizeof memory.map / sizeof memory.map[0]);
  record.bind(map_spec_of(s), totals.started);
  if (totals.started != tern::Status::kOk) return totals;
  record.assume_free(start, kRadius + 6.0 * s.cell, map.assume_free(start, kRadius + 6.0 * s.cell));
  totals.started = flight.start(flight_spec_of(s), map, planner, memory.flight,
                                sizeof memory.flight / sizeof memory.flight[0], start, 0);
  record.start(flight_spec_of(s), start, 0, totals.started);
  if (totals.started != tern::Status::kOk) return totals;
  const tern::Vec3 goal{15.0, 1.0, kEyeHeight};
  record.set_goal(goal, flight.set_goal(goal));
  Heading heading;
  tern::FlightReport before{};
  for (int k = 0; k < extent.ticks; ++k) {
    const std::int64_t t = k * s.tick;
    const tern::Sample now = flight.command(t).sample;
    if (k == kIntrusion) {
      const tern::Vec3 p{now.position.x + 0.8 * now.velocity.x, now.position.y + 0.8 * now.velocity.y, 0.0};
      world.boxes[kIntruder] = {{p.x - 0.2, p.y - 0.2, 0.0}, {p.x + 0.2, p.y + 0.2, 5.0}};
    }
    const tern::Vec3 below{0.0, 0.0, -40.0};
    if (k == kSecondGoal) record.set_goal(below, flight.set_goal(below));
    if (k % 3 == 0 && !map.busy()) {
      camera.take(k, s, now.position, heading, memory.frame);
      const tern::DepthView view = view_of(s, memory.frame.depths);
      record.frame(view, memory.frame.pose, t, map.begin_frame(view, memory.frame.pose, t));
    }
    tern::FlightReport report{};
    const std::uint64_t begun = count();
    const tern::Status ticked = flight.tick(t, report);
    const std::uint64_t counted = count() - begun;
    record.tick(flight, t, report, ticked);
    const tern::Command command = flight.command(t);
    see(before, report, counted);
    turn(heading, command, 2.5e-9 * static_cast<double>(s.tick));
    totals.hash = hash_command(totals.hash, command);
    totals.committed = report.committed;
    if (report.work > totals.most_work) totals.most_work = report.work;
    if (totals.arrived < 0 && report.reason == tern::FlightReason::kArrived) totals.arrived = k;
    totals.threatened += report.mode == tern::FlightMode::kThreat ? 1 : 0;
    before = report;
  }
  return totals;
}

}  // namespace tern_golden

#endif
