// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an Onboard does at each tick, and what it hands out.
#include <algorithm>
#include <cmath>

#include "tern_onboard/onboard.hpp"

namespace tern_onboard {
namespace {

constexpr int kNobody = Notices::kNoSubject;
constexpr std::int64_t kMostTicks = 2;     // that are caught up; more are skipped
constexpr std::int64_t kBack = 100000000;  // ns: a clock that goes back further was set

}  // namespace

void Onboard::tick(std::int64_t now) {
  const std::lock_guard lock(mutex_);
  watch_poses(now);
  if (status_.state != State::kFlying) return;
  if (now < time_ - kBack) set_back(now);
  const std::int64_t due = (now - time_) / spec_.tick;
  if (due > kMostTicks) {
    const std::int64_t skipped = due - kMostTicks;
    time_ += skipped * spec_.tick;
    status_.ticks_skipped += static_cast<std::uint64_t>(skipped);
    notices_.bad(Fault::kTicksSkipped, kNobody, now,
                 "ticks are skipped: the computer is too slow, or busy. Plans come late. Lower work_per_tick or "
                 "tick_rate, or give the program a higher priority");
  } else {
    notices_.good(Fault::kTicksSkipped, Fault::kTicksSkipped, kNobody, now, "ticks are in time again");
  }
  while (status_.state == State::kFlying && time_ + spec_.tick <= now) {
    time_ += spec_.tick;
    one_tick(now);
  }
  std::int64_t newest = 0;
  for (int k = 0; k < sensors_.count(); ++k) newest = std::max(newest, sensors_.state(k).last_stamp);
  latency_.ticked(newest, status_.report.committed, status_.report.mode == tern::FlightMode::kRest, now);
}

void Onboard::sent(std::int64_t now) {
  const std::lock_guard lock(mutex_);
  latency_.sent(now);
}

FrameAges Onboard::frame_ages() const {
  const std::lock_guard lock(mutex_);
  return latency_.ages();
}

void Onboard::one_tick(std::int64_t now) {
  if (!map_.busy()) {
    for (Sighting& seen : sensors_.enter(map_, recording_.recorder(), poses_, time_, notices_)) {
      seen.position = plus(seen.position, poses_.offset());
      add_locked(seen, now);
    }
  }
  things_.tell(flight_, recording_.recorder(), poses_.offset(), time_, notices_);
  mark_known();
  const tern::FlightReport before = status_.report;
  record_tick(flight_.tick(time_, status_.report));
  ++status_.ticks;
  keep_corridor(before);
  watch_progress();
  flown_[flown_count_++ % flown_.size()] = {time_, flight_.command(time_).sample.position};
}

void Onboard::record_tick(tern::Status answer) {
  if (recording_.recorder().tick(flight_, time_, status_.report, answer) != tern::Status::kRecordFull) return;
  recording_.end();
  notices_.say(
      "the record of this flight ends here: it was not saved for so long that its room is full. Save it more "
      "often; a ROS node does so at display_rate");
}

void Onboard::watch_progress() {
  if (wish_.points().empty()) return;
  const tern::Vec3 here = plus(flight_.command(time_).sample.position, poses_.offset());
  const double away = length(minus(wish_.points().back().position, here));
  const char* const text = progress_.note(status_.report, away, time_);
  if (text == nullptr) return;
  notices_.say(
      std::string(text) + " (" + describe(status_) + "); " + narrowest_way_text(settings_.map) + ". " + kNarrowerWays,
      true);
}

void Onboard::set_back(std::int64_t now) {
  recording_.recorder().set_clock(now, flight_.set_clock(now));
  time_ = now - spec_.tick;
  poses_.clear();
  pose_stamp_ = now;
  sensors_.restart();
  things_.set_clock(now);
  flown_count_ = 0;
  progress_.restart();
  notices_.bad(Fault::kClockBack, kNobody, now,
               "the clock went back: the flight goes on with the command that was due");
}

void Onboard::watch_poses(std::int64_t now) {
  if (status_.state == State::kNoPose) return;
  const bool lost = 1e-9 * static_cast<double>(now - pose_stamp_) > settings_.watch.pose_age;
  const bool flies = status_.state == State::kFlying;
  if (lost && !pose_lost_) {
    notices_.bad(Fault::kPoseLost, kNobody, now,
                 flies ? "no poses come: the vehicle brakes until there are some" : "no poses come");
    if (flies) recording_.recorder().stop(flight_.stop());
    if (status_.state == State::kReady) status_.state = State::kNoPose;
  }
  if (!lost) notices_.good(Fault::kPoseLost, Fault::kPoseLost, kNobody, now, "poses come again");
  if (!lost && pose_lost_ && flies) send_wish();
  pose_lost_ = lost;
}

/// Where the vehicle was told to be at a time: between ticks on a straight line, which is off by less than a
/// millimetre.
tern::Vec3 Onboard::commanded(std::int64_t t) const {
  const std::size_t count = std::min(flown_count_, flown_.size());
  for (std::size_t back = 1; back < count; ++back) {
    const Flown& later = flown_[(flown_count_ - back) % flown_.size()];
    const Flown& earlier = flown_[(flown_count_ - back - 1) % flown_.size()];
    if (t > later.time) break;
    if (t < earlier.time) continue;
    const double share = static_cast<double>(t - earlier.time) / static_cast<double>(later.time - earlier.time);
    return plus(earlier.position, times(minus(later.position, earlier.position), share));
  }
  return flight_.command(t).sample.position;
}

void Onboard::watch_stray(const StampedPose& pose, std::int64_t now) {
  if (status_.state != State::kFlying) return;
  const tern::Vec3& position = pose.pose.position;
  if (settings_.watch.slow_when_straying) {
    recording_.recorder().note_position(position, pose.stamp, flight_.note_position(position, pose.stamp));
  }
  status_.stray = length(minus(position, commanded(pose.stamp)));
  status_.stray_max = std::max(status_.stray_max, status_.stray);
  if (status_.stray > settings_.watch.stray) {
    return lose(
        Fault::kLost, now,
        "the vehicle is " + metres(status_.stray) +
            " off the command, more than stray: the flight ends, and the setpoint stays where the vehicle is. Is "
            "it in the mode that follows setpoints? Is speed within what the autopilot can do?");
  }
  if (status_.stray > settings_.map.tracking_margin) {
    notices_.bad(Fault::kStrayed, kNobody, now,
                 "the vehicle is " + metres(status_.stray) +
                     " off the command, more than tracking_margin: plans may come "
                     "too near to things. Lower speed and acceleration, or raise tracking_margin");
  } else {
    notices_.good(Fault::kStrayed, Fault::kStrayed, kNobody, now, "the vehicle is within tracking_margin again");
  }
}

/// At rest where the vehicle is; not valid without a pose.
Setpoint Onboard::setpoint_here() const {
  Setpoint setpoint{};
  const StampedPose* newest = poses_.newest();
  if (newest == nullptr) return setpoint;
  setpoint.valid = true;
  setpoint.position = setpoint.look_at = newest->pose.position;
  setpoint.yaw = heading_of(newest->pose.quaternion);
  return setpoint;
}

/// From now on, the setpoint without a flight is where the vehicle is.
void Onboard::hold_here() {
  hold_ = setpoint_here();
}

void Onboard::lose(Fault fault, std::int64_t now, const std::string& text) {
  notices_.bad(fault, kNobody, now, text);
  wish_.clear();
  poses_.rebase();
  status_.state = State::kLost;
  hold_here();
}

std::int64_t Onboard::next_tick(std::int64_t now) const {
  const std::lock_guard lock(mutex_);
  return status_.state == State::kFlying && now >= time_ - kBack ? time_ + spec_.tick : now + spec_.tick;
}

Setpoint Onboard::setpoint(std::int64_t now) const {
  const std::lock_guard lock(mutex_);
  if (status_.state == State::kFlying) {
    const tern::Command command = flight_.command(now);
    const tern::YawSample yaw = flight_.yaw(now);
    const tern::Vec3& offset = poses_.offset();
    return {now,
            true,
            plus(command.sample.position, offset),
            command.sample.velocity,
            command.sample.acceleration,
            command.sample.jerk,
            yaw.angle,
            yaw.yaw.rate,
            plus(command.look_at, offset)};
  }
  Setpoint setpoint = hold_.valid ? hold_ : setpoint_here();
  setpoint.time = now;
  return setpoint;
}

Status Onboard::status(std::int64_t now) const {
  const std::lock_guard lock(mutex_);
  Status status = status_;
  const StampedPose* newest = poses_.newest();
  status.pose_age = newest == nullptr ? -1 : std::max<std::int64_t>(0, now - newest->stamp);
  status.faults = notices_.counts();
  status.things = things_.count();
  for (int k = 0; k < sensors_.count(); ++k) status.sensors.push_back(sensors_.state(k));
  return status;
}

std::vector<tern::Vec3> Onboard::plan_points(std::int64_t now, std::int64_t step, std::size_t most) const {
  const std::lock_guard lock(mutex_);
  std::vector<tern::Vec3> points;
  if (status_.state != State::kFlying) return points;
  const tern::Vec3 end = plus(flight_.rest_position(), poses_.offset());
  for (std::size_t k = 0; k < most; ++k) {
    points.push_back(plus(flight_.command(now + static_cast<std::int64_t>(k) * step).sample.position, poses_.offset()));
    if (length(minus(points.back(), end)) < 1e-3) break;
  }
  return points;
}

bool Onboard::obstacles(std::vector<tern::Vec3>& centres) const {
  const std::lock_guard lock(mutex_);
  centres.clear();
  if (status_.state != State::kFlying || map_.busy()) return false;
  const tern::Grid& grid = map_.route();
  const tern::GridSpec& spec = grid.spec();
  const tern::Vec3 first =
      plus(plus(spec.origin, poses_.offset()), {0.5 * spec.cell, 0.5 * spec.cell, 0.5 * spec.cell});
  for (std::int32_t z = 0; z < spec.dims.z; ++z) {
    for (std::int32_t y = 0; y < spec.dims.y; ++y) {
      const std::uint64_t* row = grid.obstacle_row(y, z);
      for (std::int32_t x = 0; x < spec.dims.x; ++x) {
        if (((row[x / 64] >> (x % 64)) & 1u) == 0) continue;
        centres.push_back(plus(first, {spec.cell * x, spec.cell * y, spec.cell * z}));
      }
    }
  }
  return true;
}

/// The planner has a plan's corridor until it begins the next one, in the frame of the window that it began with.
void Onboard::keep_corridor(const tern::FlightReport& before) {
  if (status_.report.asked != before.asked) plan_origin_ = map_.route().spec().origin;
  if (status_.report.committed == before.committed || planner_.corridor() == nullptr) return;
  corridor_ = *planner_.corridor();
  corridor_origin_ = plan_origin_;
}

std::vector<std::vector<tern::Halfspace>> Onboard::corridor() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::vector<tern::Halfspace>> polyhedra;
  if (status_.state != State::kFlying) return polyhedra;
  const tern::Vec3 origin = plus(corridor_origin_, poses_.offset());
  for (int k = 0; k < corridor_.count; ++k) {
    const tern::Polyhedron& polyhedron = corridor_.polyhedra[k];
    polyhedra.emplace_back(polyhedron.planes, polyhedron.planes + polyhedron.count);
    for (tern::Halfspace& plane : polyhedra.back()) {
      plane.offset += plane.normal.x * origin.x + plane.normal.y * origin.y + plane.normal.z * origin.z;
    }
  }
  return polyhedra;
}

}  // namespace tern_onboard
