// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <future>
#include <memory>
#include <utility>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/swarm/swarm_intruders.hpp"

namespace tern_host {
namespace {

double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What a vehicle hears and sends in a tick, apart from all others.
class Mailbox : public Carrier {
 public:
  void send(int, const Packet& packet, std::int64_t) override { sent.push_back(packet); }
  std::vector<Packet> receive(int, std::int64_t) override { return std::move(heard); }
  std::vector<Packet> heard, sent;
};

LinkSettings links_of(const SwarmSettings& settings) {
  LinkSettings links = settings.links;
  if (settings.range > 0.0) links.radio = swarm_radio(settings.range) + 1.0;
  return links;
}

class Swarm {
 public:
  Swarm(const SwarmWorld& world, const SwarmSettings& settings, SwarmRecord* record)
      : world_(world),
        settings_(settings),
        links_(links_of(settings), count(), settings.seed),
        watch_(
            count(), world.body_radius, 1.7320508 * world.limits.v_max.x,
            [this](int k, std::int64_t t) { return vehicles_[static_cast<std::size_t>(k)]->at(t).position; },
            [this](const tern::Vec3& p) { return swarm_clearance(world_, p); }),
        intruders_(motions_of(world.intruders)) {
    watch_intruders(world, watch_);
    Noise clocks(settings.seed + 1);
    const double half = 0.5 * settings.clock_error;
    for (int k = 0; k < count(); ++k) {
      const auto offset = static_cast<std::int64_t>(1e9 * clocks.within(-half, half));
      vehicles_.push_back(std::make_unique<SwarmVehicle>(world, settings, k, 1000000000 + offset));
      if (record != nullptr) record->vehicles.push_back({1000000000 + offset, {}});
    }
    result_.members.resize(vehicles_.size());
    boxes_ = std::vector<Mailbox>(vehicles_.size());
    did_.resize(vehicles_.size());
    if (record == nullptr) return;
    record->world = world.name;
    record->intruders = world.intruders;
    record->settings = settings;
    recording_ = std::make_unique<RecordingCarrier>(links_, *record);
  }

  SwarmResult fly(const std::function<void(double, int)>& progress) {
    const double began = processor_time();
    const auto step = static_cast<std::int64_t>(1e9 / settings_.tick_hz);
    const auto end = static_cast<std::int64_t>(1e9 * world_.time_limit);
    std::int64_t film_next = 0;
    for (now_ = 0; now_ < end && result_.arrived() < count(); now_ += step) {
      tick();
      watch_.look(now_, now_ + step);
      note_positions(step);
      if (now_ >= film_next) {
        film();
        film_next += static_cast<std::int64_t>(1e9 * result_.film_step);
      }
      if (progress) progress(seconds_of(now_), result_.arrived());
    }
    result_.computed = processor_time() - began;
    finish();
    return result_;
  }

 private:
  int count() const { return static_cast<int>(world_.tasks.size()); }

  /// All vehicles tick at once: what one sends, the others hear from the next tick on. So the number of threads changes
  /// nothing.
  void tick() {
    Carrier& carrier = recording_ ? static_cast<Carrier&>(*recording_) : links_;
    for (int k = 0; k < count(); ++k) boxes_[static_cast<std::size_t>(k)].heard = carrier.receive(k, now_);
    const int threads = std::min(settings_.threads, count());
    std::vector<std::future<void>> others;
    for (int first = 1; first < threads; ++first) {
      others.push_back(std::async(std::launch::async, [this, first, threads] { tick_some(first, threads); }));
    }
    tick_some(0, threads);
    for (std::future<void>& other : others) other.get();
    for (int k = 0; k < count(); ++k) links_.move(k, vehicles_[static_cast<std::size_t>(k)]->at(now_).position);
    for (int k = 0; k < count(); ++k) {
      std::vector<Packet>& sent = boxes_[static_cast<std::size_t>(k)].sent;
      for (const Packet& packet : sent) carrier.send(k, packet, now_);
      sent.clear();
      if (recording_) recording_->end_tick(k, vehicles_[static_cast<std::size_t>(k)]->at(now_).position);
      note(k, did_[static_cast<std::size_t>(k)]);
    }
  }
  /// Every `step`th vehicle from `first` on.
  void tick_some(int first, int step) {
    for (auto k = static_cast<std::size_t>(first); k < vehicles_.size(); k += static_cast<std::size_t>(step)) {
      did_[k] = vehicles_[k]->tick(now_, boxes_[k]);
    }
  }

  void note(int k, const SwarmTick& did) {
    const SwarmVehicle& vehicle = *vehicles_[static_cast<std::size_t>(k)];
    SwarmMember& member = result_.members[static_cast<std::size_t>(k)];
    member.commits += did.committed ? 1 : 0;
    member.unasked += did.unasked ? 1 : 0;
    result_.disagreed += did.agrees ? 0 : 1;
    result_.most_members = std::max(result_.most_members, did.members);
    result_.member_ticks += static_cast<std::uint64_t>(did.members);
    ++result_.ticks;
    result_.fleet_units += did.fleet_units;
    result_.flight_units += vehicle.report().work;
    result_.most_untold = std::max(result_.most_untold, did.untold);
    result_.most_fleet_units = std::max(result_.most_fleet_units, did.fleet_units);
    const double now = seconds_of(now_);
    const double departed = world_.tasks[static_cast<std::size_t>(k)].depart;
    if (member.arrived < 0.0 && vehicle.has_arrived()) member.arrived = now - departed;
  }

  /// FNV-1a over the positions' bits, and the lengths of the ways.
  void note_positions(std::int64_t step) {
    for (std::size_t k = 0; k < vehicles_.size(); ++k) {
      const tern::Vec3 a = vehicles_[k]->at(now_).position;
      const tern::Vec3 b = vehicles_[k]->at(now_ + step).position;
      result_.members[k].length += distance_between(a, b);
      hash(a);
    }
    for (const tern::Vec3& place : places_of(intruders_, now_)) hash(place);
  }
  void hash(const tern::Vec3& place) {
    for (const double value : {place.x, place.y, place.z}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      result_.hash = (result_.hash ^ bits) * 0x100000001B3u;
    }
  }

  void film() {
    std::vector<tern::Sample> row;
    for (const auto& vehicle : vehicles_) row.push_back(vehicle->at(now_));
    result_.film.push_back(row);
    result_.intruder_film.push_back(places_of(intruders_, now_));
  }

  void finish() {
    result_.time = seconds_of(now_);
    take_findings(watch_, result_);
    result_.packets = links_.sent();
    result_.lost = links_.lost();
    result_.bytes = links_.bytes();
    for (std::size_t k = 0; k < vehicles_.size(); ++k) {
      if (result_.members[k].arrived < 0.0) result_.members[k].state = state_of(*vehicles_[k]);
    }
  }

  static std::string state_of(const SwarmVehicle& vehicle) {
    const tern::FlightReport& report = vehicle.report();
    const tern::FleetReport fleet = vehicle.fleet_report();
    std::string text = tern::flight_mode_name(report.mode);
    text +=
        std::string(", ") + tern::flight_reason_text(report.reason) + ", last plan " + tern::status_name(report.plan);
    if (fleet.blocked != tern::FleetBlock::kNone) {
      text +=
          ", dropped (" + std::to_string(static_cast<int>(fleet.blocked)) + ") by " + std::to_string(fleet.blocked_by);
    }
    return text;
  }

  const SwarmWorld& world_;
  const SwarmSettings& settings_;
  Links links_;
  std::unique_ptr<RecordingCarrier> recording_;
  SwarmWatch watch_;
  std::vector<ThingMotion> intruders_;
  std::vector<std::unique_ptr<SwarmVehicle>> vehicles_;
  std::vector<Mailbox> boxes_;  ///< of each vehicle
  std::vector<SwarmTick> did_;  ///< by each vehicle, in this tick
  SwarmResult result_;
  std::int64_t now_ = 0;
};

}  // namespace

int SwarmResult::arrived() const {
  return static_cast<int>(
      std::count_if(members.begin(), members.end(), [](const SwarmMember& m) { return m.arrived >= 0.0; }));
}

double SwarmResult::last_arrival() const {
  double last = 0.0;
  for (const SwarmMember& member : members) last = std::max(last, member.arrived);
  return last;
}

double SwarmResult::mean_travel() const {
  double sum = 0.0;
  for (const SwarmMember& member : members) sum += std::max(0.0, member.arrived);
  return arrived() > 0 ? sum / arrived() : 0.0;
}

void take_findings(const SwarmWatch& watch, SwarmResult& result) {
  result.contacts = watch.contacts();
  result.touched_at_rest = watch.touched_at_rest();
  result.least_distance = watch.least_distance();
  result.least_clearance = watch.least_clearance();
  result.least_gap = watch.least_gap();
}

SwarmResult fly_swarm(const SwarmWorld& world, const SwarmSettings& settings,
                      const std::function<void(double, int)>& progress, SwarmRecord* record) {
  return std::make_unique<Swarm>(world, settings, record)->fly(progress);
}

}  // namespace tern_host
