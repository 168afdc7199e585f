// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vehicles that fly here and there over a bad network, each with a clock of its own, and what they truly fly. Plans are
// single segments of degree 7 from the state at the takeover, also in mid-flight, to a place at rest. Most keep clear
// of the traffic that their vehicle knows of; some take no notice of it.
#ifndef TERN_TESTS_FLEET_SWARM_HPP
#define TERN_TESTS_FLEET_SWARM_HPP

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "fleet/network.hpp"
#include "fleet/plans.hpp"
#include "tern/fleet.hpp"
#include "tern/track_proof.hpp"

namespace tern_test {

struct SwarmSpec {
  LinkSpec link;
  int vehicles = 8;
  std::int32_t room = 1400;      ///< bytes of a packet
  std::int64_t clock_error = 0;  ///< ns between any two clocks
  double careless = 0.2;         ///< share of plans that take no notice of traffic
  double restarts = 0.0;         ///< a vehicle begins anew in a second, probability
  std::uint32_t work = 1000;     ///< units a tick
  bool by_range = false;         ///< they roam far and wide, and only those that are near are members
  bool first_leaves = false;     ///< the one with the right of way over all leaves in the middle
};

class Swarm {
 public:
  static constexpr std::int64_t kStep = kSecond / 100;
  static constexpr int kTickSteps = 10;
  static constexpr double kRadius = 0.4;

  Swarm(const SwarmSpec& spec, std::uint64_t seed)
      : spec_(spec), random_(seed), network_(spec.link, spec.vehicles, random_) {
    for (int v = 0; v < spec.vehicles; ++v) {
      vehicles_.push_back(std::make_unique<Vehicle>());
      Vehicle& vehicle = *vehicles_.back();
      const double share = 6.283185307 * v / spec.vehicles;
      vehicle.off = static_cast<std::int64_t>(random_.real(0.0, 1.0) * static_cast<double>(spec.clock_error));
      const double out = spec.by_range ? 30.0 : 5.0;
      vehicle.flown = resting({out * std::cos(share), out * std::sin(share), 2.0}, 0);
      vehicle.heading = vehicle.flown.origin;
      begin(v, 0);
    }
  }

  /// One step of 10 ms.
  void step() {
    ++step_;
    for (const Packet& packet : network_.arrivals(step_)) {
      Vehicle& vehicle = *vehicles_[static_cast<std::size_t>(packet.to)];
      vehicle.fleet.receive(packet.bytes.data(), static_cast<std::int32_t>(packet.bytes.size()), clock(packet.to));
    }
    for (int v = 0; v < spec_.vehicles; ++v) {
      if (step_ % kTickSteps == v % kTickSteps) tick(v);
    }
  }

  /// The least distance between two vehicles from this step to the next one, less what they should keep; the curves are
  /// followed in steps in which the distance cannot change by more than it is too large.
  double least_gap() const {
    double least = 1e9;
    for (int a = 0; a < spec_.vehicles; ++a) {
      for (int b = 0; b < a; ++b) least = std::min(least, least_gap(a, b));
    }
    return least;
  }
  int taken(int v) const { return vehicles_[static_cast<std::size_t>(v)]->taken; }
  int announced(int v) const { return vehicles_[static_cast<std::size_t>(v)]->announced; }
  int members(int v) const { return vehicles_[static_cast<std::size_t>(v)]->fleet.neighbours(); }
  double seconds() const { return 0.01 * step_; }

 private:
  struct Vehicle {
    tern::Fleet fleet;
    tern::Trajectory flown{};
    tern::Trajectory next{};
    tern::Vec3 heading{};  ///< by range: where it is on its way to
    std::int64_t off = 0;  ///< of its clock
    std::uint32_t incarnation = 0;
    bool waits = false;  ///< a plan is announced
    bool has_left = false;
    int taken = 0;
    int announced = 0;
  };

  std::int64_t clock(int v) const { return step_ * kStep + vehicles_[static_cast<std::size_t>(v)]->off; }

  void begin(int v, std::int64_t now) {
    Vehicle& vehicle = *vehicles_[static_cast<std::size_t>(v)];
    tern::FleetSpec spec;
    spec.id = static_cast<std::uint16_t>(v + 1);
    spec.incarnation = ++vehicle.incarnation;
    spec.priority = static_cast<std::uint8_t>(spec_.restarts > 0.0 ? random_.integer(0, 3) : 0);
    spec.radius = kRadius;
    spec.clock_error = spec_.clock_error;
    spec.tick = kSecond / 5;
    spec.speed = 3.0;
    if (spec_.by_range) spec.range = range();
    EXPECT_EQ(vehicle.fleet.begin(spec, vehicle.flown, now), tern::Status::kOk);
    vehicle.waits = false;
    for (int other = 0; !spec_.by_range && other < spec_.vehicles; ++other) {
      if (other != v) vehicle.fleet.add(static_cast<std::uint16_t>(other + 1), now);
    }
  }

  void tick(int v) {
    Vehicle& vehicle = *vehicles_[static_cast<std::size_t>(v)];
    const std::int64_t now = clock(v);
    if (random_.chance(0.1 * spec_.restarts)) begin(v, now);
    if (spec_.first_leaves && v == 0 && step_ > 1500 && !vehicle.has_left) {
      vehicle.has_left = true;
      vehicle.fleet.leave(now);
    }
    tern::Work work(spec_.work);
    vehicle.fleet.advance(now, work);
    const tern::Announcement state = vehicle.fleet.report().announcement;
    if (vehicle.waits && state == tern::Announcement::kTaken) {
      vehicle.flown = vehicle.next;
      ++vehicle.taken;
    }
    if (state != tern::Announcement::kProving && state != tern::Announcement::kOpen) vehicle.waits = false;
    if (!vehicle.waits && !vehicle.has_left && random_.chance(0.4)) announce(vehicle, now);
    if (vehicle.waits && random_.chance(0.01)) {
      vehicle.fleet.withdraw(now);
      vehicle.waits = false;
    }
    std::uint8_t packet[2000];
    for (int k = 0; k < 40; ++k) {
      const std::int32_t size = vehicle.fleet.write(packet, spec_.room);
      if (size == 0) break;
      network_.send(v, step_, packet, size);
    }
  }

  static constexpr double kTopSpeed = 3.5;
  static tern::FleetRange range() {
    tern::FleetRange range;
    range.join = 26.0;
    range.heard = 200.0;
    range.speed = kTopSpeed;
    range.within = 4 * kSecond;
    range.lease = 8 * kSecond;
    return range;
  }
  /// Anywhere in the middle; or, by range, a few metres from a place towards where the vehicle is on its way to.
  tern::Vec3 target(const tern::Vec3& from, Vehicle& vehicle) {
    if (!spec_.by_range) return {random_.real(-6.0, 6.0), random_.real(-6.0, 6.0), random_.real(0.0, 4.0)};
    tern::Vec3& to = vehicle.heading;
    if (random_.chance(0.05) || between(from, to) < 3.0)
      to = {random_.real(-30.0, 30.0), random_.real(-30.0, 30.0), 2.0};
    const double part = 4.0 / (4.0 + between(from, to));
    return {from.x + part * (to.x - from.x) + random_.real(-1.0, 1.0),
            from.y + part * (to.y - from.y) + random_.real(-1.0, 1.0), random_.real(0.0, 4.0)};
  }

  /// From the state at the takeover to a place at rest.
  tern::Trajectory plan_from(Vehicle& vehicle, std::int64_t takeover) {
    const tern::Trajectory& flown = vehicle.flown;
    const tern::Sample at = tern::evaluate(flown, tern::time_on(flown, takeover));
    tern::Trajectory plan = resting(at.position, takeover);
    const tern::Vec3 to = target(at.position, vehicle);
    const double t = 1.5 + 0.6 * between(at.position, to);
    tern::Segment& segment = plan.segments[0];
    segment.duration = t;
    const auto set = [&](double tern::Vec3::*x) {
      const double first = at.velocity.*x * t / 7.0;
      const double second = 2.0 * first + at.acceleration.*x * t * t / 42.0;
      segment.points[1].*x = first;
      segment.points[2].*x = second;
      segment.points[3].*x = 3.0 * second - 3.0 * first + at.jerk.*x * t * t * t / 210.0;
      for (int k = 4; k < 8; ++k) segment.points[k].*x = to.*x - at.position.*x;
    };
    set(&tern::Vec3::x);
    set(&tern::Vec3::y);
    set(&tern::Vec3::z);
    return plan;
  }

  void announce(Vehicle& vehicle, std::int64_t now) {
    const std::int64_t takeover = now + random_.integer(2, 8 + spec_.link.delay / 5) * kTickSteps * kStep;
    tern::Track tracks[32];
    std::vector<tern::TrackPiece> pieces(64);
    std::int32_t count = 0;
    EXPECT_EQ(vehicle.fleet.traffic(now, tracks, 32, pieces.data(), 64, count), tern::Status::kOk);
    const bool cares = !random_.chance(spec_.careless);
    for (int turn = 0; turn < 6; ++turn) {
      const tern::Trajectory plan = plan_from(vehicle, takeover);
      if (spec_.by_range && is_too_fast(plan)) continue;
      tern::TrackGrounds grounds;
      grounds.tracks = tracks;
      grounds.count = count;
      grounds.radius = kRadius;
      grounds.rest = 20.0;
      if (cares && tern::clear_until(plan, 0.0, grounds) < plan.segments[0].duration + 20.0) continue;
      EXPECT_EQ(vehicle.fleet.announce(plan, takeover, now), tern::Status::kOk);
      vehicle.next = plan;
      vehicle.waits = true;
      ++vehicle.announced;
      return;
    }
  }

  /// On any axis, by samples and with some to spare.
  static bool is_too_fast(const tern::Trajectory& plan) {
    bool is = false;
    for (int k = 0; k <= 50; ++k) {
      const tern::Vec3 v = tern::evaluate(plan, 0.02 * k * plan.segments[0].duration).velocity;
      is = is || std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > 0.98 * kTopSpeed;
    }
    return is;
  }

  double least_gap(int a, int b) const {
    const Vehicle& of = *vehicles_[static_cast<std::size_t>(a)];
    const Vehicle& to = *vehicles_[static_cast<std::size_t>(b)];
    const double speed = 1.0 + largest_speed(of.flown) + largest_speed(to.flown);
    double least = 1e9;
    double s = 0.0;
    while (s < 0.01) {
      const tern::Vec3 p = place(of, s);
      const tern::Vec3 q = place(to, s);
      const double gap = between(p, q) - 2.0 * kRadius;
      least = std::min(least, gap);
      s += std::max(gap, 1e-4) / speed;
    }
    return least;
  }
  tern::Vec3 place(const Vehicle& vehicle, double s) const {
    const auto now = step_ * kStep + vehicle.off + static_cast<std::int64_t>(1e9 * s);
    const tern::Vec3 at = place_at(vehicle.flown, now);
    const tern::Vec3& origin = vehicle.flown.origin;
    return {origin.x + at.x, origin.y + at.y, origin.z + at.z};
  }
  static double largest_speed(const tern::Trajectory& plan) {
    double most = 0.0;
    const tern::Segment& segment = plan.segments[0];
    for (int k = 0; k < 7; ++k) most = std::max(most, between(segment.points[k + 1], segment.points[k]));
    return 7.0 * most / segment.duration;
  }

  SwarmSpec spec_;
  Random random_;
  Network network_;
  std::vector<std::unique_ptr<Vehicle>> vehicles_;
  int step_ = 0;
};

}  // namespace tern_test

#endif
