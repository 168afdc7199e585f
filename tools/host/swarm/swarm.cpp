// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <memory>

#include "host/flight/vectors.hpp"

namespace tern_host {
namespace {

double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

class Swarm {
 public:
  Swarm(const SwarmWorld& world, const SwarmSettings& settings, SwarmRecord* record)
      : world_(world),
        settings_(settings),
        links_(settings.links, count(), settings.seed),
        watch_(
            count(), world.body_radius, 1.7320508 * world.limits.v_max.x,
            [this](int k, std::int64_t t) { return vehicles_[static_cast<std::size_t>(k)]->at(t).position; },
            [this](const tern::Vec3& p) { return swarm_clearance(world_, p); }) {
    Noise clocks(settings.seed + 1);
    const double half = 0.5 * settings.clock_error;
    for (int k = 0; k < count(); ++k) {
      const auto offset = static_cast<std::int64_t>(1e9 * clocks.within(-half, half));
      vehicles_.push_back(std::make_unique<SwarmVehicle>(world, settings, k, 1000000000 + offset));
      if (record != nullptr) record->vehicles.push_back({1000000000 + offset, {}});
    }
    result_.members.resize(vehicles_.size());
    if (record == nullptr) return;
    record->world = world.name;
    record->settings = settings;
    recording_ = std::make_unique<RecordingCarrier>(links_, *record);
  }

  SwarmResult fly(const std::function<void(double, int)>& progress) {
    const double began = processor_time();
    const auto step = static_cast<std::int64_t>(1e9 / settings_.tick_hz);
    const auto end = static_cast<std::int64_t>(1e9 * world_.time_limit);
    std::int64_t film_next = 0;
    for (now_ = 0; now_ < end && result_.arrived() < count(); now_ += step) {
      for (int k = 0; k < count(); ++k) tick(k);
      watch_.look(now_, now_ + step);
      note_positions(step);
      if (now_ >= film_next) {
        film();
        film_next += static_cast<std::int64_t>(1e9 * result_.film_step);
      }
      if (progress) progress(1e-9 * static_cast<double>(now_), result_.arrived());
    }
    result_.computed = processor_time() - began;
    finish();
    return result_;
  }

 private:
  int count() const { return static_cast<int>(world_.tasks.size()); }

  void tick(int k) {
    SwarmVehicle& vehicle = *vehicles_[static_cast<std::size_t>(k)];
    SwarmMember& member = result_.members[static_cast<std::size_t>(k)];
    const SwarmTick did = recording_ ? vehicle.tick(now_, *recording_) : vehicle.tick(now_, links_);
    if (recording_) recording_->end_tick(k, vehicle.at(now_).position);
    member.commits += did.committed ? 1 : 0;
    member.unasked += did.unasked ? 1 : 0;
    result_.disagreed += did.agrees ? 0 : 1;
    result_.most_untold = std::max(result_.most_untold, did.untold);
    result_.most_fleet_units = std::max(result_.most_fleet_units, did.fleet_units);
    const double now = 1e-9 * static_cast<double>(now_);
    const double departed = world_.tasks[static_cast<std::size_t>(k)].depart;
    if (member.arrived < 0.0 && vehicle.has_arrived()) member.arrived = now - departed;
  }

  /// FNV-1a over the positions' bits, and the lengths of the ways.
  void note_positions(std::int64_t step) {
    for (std::size_t k = 0; k < vehicles_.size(); ++k) {
      const tern::Vec3 a = vehicles_[k]->at(now_).position;
      const tern::Vec3 b = vehicles_[k]->at(now_ + step).position;
      result_.members[k].length += distance_between(a, b);
      for (const double value : {a.x, a.y, a.z}) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        result_.hash = (result_.hash ^ bits) * 0x100000001B3u;
      }
    }
  }

  void film() {
    std::vector<tern::Sample> row;
    for (const auto& vehicle : vehicles_) row.push_back(vehicle->at(now_));
    result_.film.push_back(row);
  }

  void finish() {
    result_.time = 1e-9 * static_cast<double>(now_);
    result_.contacts = watch_.contacts();
    result_.least_distance = watch_.least_distance();
    result_.least_clearance = watch_.least_clearance();
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
  std::vector<std::unique_ptr<SwarmVehicle>> vehicles_;
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

SwarmResult fly_swarm(const SwarmWorld& world, const SwarmSettings& settings,
                      const std::function<void(double, int)>& progress, SwarmRecord* record) {
  return std::make_unique<Swarm>(world, settings, record)->fly(progress);
}

}  // namespace tern_host
