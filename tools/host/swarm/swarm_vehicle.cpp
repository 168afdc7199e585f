// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "base/work.hpp"
#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/swarm/swarm_map.hpp"
#include "host/track_record.hpp"

namespace tern_host {
namespace {

using tern::Status;

/// Plans wait no longer than that for answers, ns.
constexpr std::int64_t kMostPatience = 6'000'000'000;
/// The longest that a flight may be told to wait for an answer, s.
constexpr double kLongestWait = 10.0;

/// Metres between what a vehicle flies and what its fleet says, at most: both are the same plan.
constexpr double kAgree = 1e-9;

/// Of members by range, ns: how old the newest beacon of anyone near may be, and for how long promises hold.
constexpr std::int64_t kHeardWithin = 1'000'000'000;
constexpr std::int64_t kLease = 12'000'000'000;

[[noreturn]] void fail(const SwarmWorld& world, int vehicle, const std::string& what, Status status) {
  throw std::runtime_error(world.name + ", vehicle " + std::to_string(vehicle) + ": " + what + ": " +
                           tern::status_name(status));
}

}  // namespace

double swarm_radio(double range) {
  return 3.0 * range;
}

SwarmVehicle::SwarmVehicle(const SwarmWorld& world, const SwarmSettings& settings, int number,
                           std::int64_t clock_offset)
    : world_(world),
      settings_(settings),
      number_(number),
      offset_(clock_offset),
      memory_(new tern::Workspace),
      planner_(memory_.get(), sizeof *memory_),
      fleet_(new tern::Fleet),
      restarts_(settings.seed + 1000 + static_cast<std::uint64_t>(number)) {
  const SwarmTask& task = world.tasks[static_cast<std::size_t>(number)];
  start_map(task);
  spec_ = tern::flight_spec(world.limits);
  spec_.tick = nanoseconds(1.0 / settings.tick_hz);
  spec_.work_per_tick = settings.work_per_tick;
  spec_.plan_work = 10 * settings.work_per_tick;
  spec_.horizon = world.horizon;
  if (sensor_) {
    sensor_->describe(spec_);
  } else {
    spec_.near = 0.0;
    spec_.stale_after = 0;
  }
  patience_ = least_patience();
  spec_.clearance = patience_;
  flight_words_.resize(tern::flight_words(map_.safe().spec().dims));
  const Status begun =
      flight_.start(spec_, map_, planner_, flight_words_.data(), flight_words_.size(), task.start, offset_);
  if (begun != Status::kOk) fail(world, number, "the flight cannot begin", begun);
  const std::uint64_t noise = settings.seed + static_cast<std::uint64_t>(number);
  if (!world.intruders.empty()) intruders_ = std::make_unique<IntruderReports>(world, noise, offset_, spec_.tick);
  traffic_.start(offset_, spec_.tick, std::size_t{tern::kMaxFlightTracks} - world.intruders.size());
  begin_fleet(offset_);
}

/// A map that holds the world, or one that holds what an operator knows around the start.
void SwarmVehicle::start_map(const SwarmTask& task) {
  tern::MapSpec spec = map_spec_of(world_, task, settings_);
  if (settings_.discover > 0.0) {
    sensor_ = std::make_unique<SwarmSensor>(world_, task, settings_.discover, settings_.tracking_margin);
    sensor_->describe(spec);
  }
  map_words_.resize(tern::map_words(spec));
  const Status bound = map_.bind(spec, map_words_.data(), map_words_.size());
  if (bound != Status::kOk) fail(world_, number_, "no map can be made of this world and cell", bound);
  if (sensor_) return sensor_->assume_start(map_);
  map_.assume_free(task.start, 1000.0);
  for (const tern::Box& wall : walls_of(world_)) map_.mark_box(wall);
  for (const tern::Box& block : world_.blocks) map_.mark_box(block);
}

void SwarmVehicle::begin_fleet(std::int64_t time) {
  tern::Trajectory flown{};
  flight_.committed_plan(flown);
  if (flown.begin > time) return;  // until then, what the fleet says is true
  begins_anew_ = pending_ = false;
  if (answered_) flight_.answer(asked_, false);  // what was agreed to does not count in the new incarnation
  forget_question();
  tern::FleetSpec spec;
  spec.id = static_cast<std::uint16_t>(number_);
  spec.incarnation = ++incarnation_;
  spec.priority = world_.tasks[static_cast<std::size_t>(number_)].priority;
  spec.radius = world_.body_radius + settings_.tracking_margin;
  spec.clock_error = nanoseconds(settings_.clock_error);
  spec.tick = std::max(spec_.tick, nanoseconds(settings_.late));
  spec.speed = 1.7320508 * world_.limits.v_max.x;
  if (settings_.range > 0.0) {
    spec.range.join = settings_.range;
    spec.range.heard = swarm_radio(settings_.range);
    spec.range.speed = std::max({world_.limits.v_max.x, world_.limits.v_max.y, world_.limits.v_max.z});
    spec.range.within = kHeardWithin;
    spec.range.lease = kLease;
  }
  const Status begun = fleet_->begin(spec, flown, time);
  if (begun != Status::kOk) fail(world_, number_, "the fleet cannot begin", begun);
  for (int k = 0; settings_.range <= 0.0 && k < static_cast<int>(world_.tasks.size()); ++k) {
    if (k == number_) continue;
    const Status added = fleet_->add(static_cast<std::uint16_t>(k), time);
    if (added != Status::kOk) fail(world_, number_, "a member is refused", added);
  }
}

/// What an exchange takes if nothing is lost, ns; at most what a flight waits.
std::int64_t SwarmVehicle::least_patience() const {
  if (settings_.clearance > 0.0) return nanoseconds(settings_.clearance);
  const double exchange = 2.0 * settings_.links.delay_max + 2.0 / settings_.send_hz + 3.0 / settings_.tick_hz;
  return nanoseconds(std::min(exchange, kLongestWait));
}

/// Plans wait half as long again as the answers to the last ones took, and twice as long if those waited in vain.
void SwarmVehicle::set_patience(std::int64_t patience) {
  patience_ = std::min(std::max(patience, least_patience()), std::max(kMostPatience, least_patience()));
  flight_.set_clearance(patience_);
}

/// Asks the fleet about the plan that the flight proposes.
void SwarmVehicle::announce(std::int64_t time) {
  tern::Trajectory plan{};
  std::int64_t takeover = 0;
  const std::uint32_t question = flight_.proposal(plan, takeover);
  if (question == asked_ || answered_ || pending_ || begins_anew_) return;
  if (asked_ != 0) {
    fleet_->withdraw(time);
    const bool was_late = time + 2 * spec_.tick >= takeover_;
    if (was_late) set_patience(2 * patience_);
  }
  asked_ = question;
  asked_at_ = time;
  if (question == 0) return;
  proposed_ = plan;
  takeover_ = takeover;
  if (fleet_->announce(plan, takeover, time) != Status::kOk) {
    flight_.answer(question, false);
    asked_ = 0;
  }
}

void SwarmVehicle::hear_answer(std::int64_t time) {
  if (asked_ == 0 || answered_) return;
  const tern::FleetReport fleet = fleet_->report();
  if (fleet.announcement == tern::Announcement::kDropped) {
    flight_.answer(asked_, false);
    asked_ = 0;
  } else if (fleet.cleared) {
    answered_ = flight_.answer(asked_, true) == Status::kOk;
    set_patience(patience_ - (patience_ - 3 * (time - asked_at_) / 2) / 4);
    if (!answered_) fleet_->withdraw(time);
    if (!answered_) asked_ = 0;
  }
}

void SwarmVehicle::send(std::int64_t now, Carrier& carrier) {
  // Where answers take long, because much is lost, a vehicle that waits for them sends in every tick.
  const bool hurries =
      2 * patience_ > 3 * least_patience() && fleet_->report().announcement == tern::Announcement::kOpen;
  if (now < next_round_ && !hurries) return;
  next_round_ = now + nanoseconds(1.0 / settings_.send_hz);
  std::vector<std::uint8_t> packet(static_cast<std::size_t>(settings_.packet_bytes));
  for (int k = 0; k < 1000; ++k) {
    const std::int32_t size = fleet_->write(packet.data(), settings_.packet_bytes);
    if (size <= 0) return;
    carrier.send(number_, std::vector<std::uint8_t>(packet.begin(), packet.begin() + size), now);
  }
}

/// The flight follows the plan that the fleet was asked about.
bool SwarmVehicle::follows_proposed() const {
  tern::Trajectory plan{};
  flight_.committed_plan(plan);
  return plan.begin == proposed_.begin && plan.count == proposed_.count &&
         std::memcmp(plan.segments, proposed_.segments,
                     static_cast<std::size_t>(plan.count) * sizeof plan.segments[0]) == 0;
}

bool SwarmVehicle::agrees(std::int64_t time) const {
  if (begins_anew_) return true;
  const tern::Trajectory& told = *fleet_->flown();
  const tern::Vec3 said = evaluate(told, time_on(told, time)).position;
  const tern::Vec3 flown = flight_.command(time).sample.position;
  return distance_between(said, flown) < kAgree;
}

void SwarmVehicle::forget_question() {
  asked_ = 0;
  answered_ = false;
}

/// What the fleet did with the plan that was asked about. A flight commits no plan from its takeover on, so the fleet
/// takes none over that is not committed by then.
void SwarmVehicle::advance_fleet(std::int64_t time, SwarmTick& did) {
  if (asked_ != 0 && time >= takeover_) fleet_->withdraw(time);
  if (pending_ && !follows_proposed()) {  // a threat took it back
    fleet_->withdraw(time);
    pending_ = false;
  }
  tern::Work work{settings_.fleet_work};
  fleet_->advance(time, work);
  did.fleet_units = settings_.fleet_work - std::min(settings_.fleet_work, work.units());
  if (!pending_) return;
  const tern::Announcement now = fleet_->report().announcement;
  const bool is_void = now == tern::Announcement::kDropped || now == tern::Announcement::kNone;
  pending_ = now != tern::Announcement::kTaken && !is_void;
  // Until its takeover, what is void because a member began anew need not be flown.
  if (is_void && (time >= takeover_ || flight_.answer(cleared_, false) != Status::kOk)) begins_anew_ = true;
}

/// Ticks the flight, and tells the fleet what it did.
void SwarmVehicle::advance_flight(std::int64_t time, SwarmTick& did) {
  const std::uint32_t committed = report_.committed;
  const std::uint32_t ended = report_.failed + report_.dropped;
  flight_.tick(time, report_);
  did.committed = report_.committed > committed;
  const bool is_ours = did.committed && answered_ && follows_proposed();
  did.unasked = did.committed && !is_ours;
  if (is_ours) {
    pending_ = true;
    cleared_ = asked_;
    forget_question();
  } else if (did.unasked || (answered_ && report_.failed + report_.dropped > ended)) {
    fleet_->withdraw(time);
    forget_question();
    pending_ = false;
  }
  begins_anew_ = begins_anew_ || did.unasked;
  if (settings_.restarts > 0.0 && restarts_.chance(settings_.restarts / settings_.tick_hz)) begins_anew_ = true;
  if (begins_anew_) begin_fleet(time);
}

SwarmTick SwarmVehicle::tick(std::int64_t now, Carrier& carrier) {
  const std::int64_t time = now + offset_;
  SwarmTick did;
  for (const Packet& packet : carrier.receive(number_, now)) {
    fleet_->receive(packet.data(), static_cast<std::int32_t>(packet.size()), time);
  }
  advance_fleet(time, did);
  did.members = fleet_->neighbours();
  const tern::Vec3 place = flight_.command(time).sample.position;
  did.untold = traffic_.tell(*fleet_, flight_, place, time);
  if (intruders_) intruders_->tell(time, place, flight_);
  hear_answer(time);
  const SwarmTask& task = world_.tasks[static_cast<std::size_t>(number_)];
  if (!has_mission_ && seconds_of(now) >= task.depart) {
    has_mission_ = true;
    flight_.set_mission(task.mission.data(), static_cast<std::int32_t>(task.mission.size()), tern::ViaPolicy::kEnd);
  }
  if (sensor_) sensor_->look(place, time, map_);
  advance_flight(time, did);
  did.agrees = agrees(time);
  announce(time);
  send(now, carrier);
  return did;
}

}  // namespace tern_host
