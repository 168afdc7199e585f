// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_record.hpp"

#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/nanoseconds.hpp"
#include "host/swarm/swarm_intruders.hpp"
#include "host/things/thing_record.hpp"
#include "tern/self_test.hpp"

namespace tern_host {
namespace {

constexpr const char* kFormat = "tern-swarm/2";
constexpr std::uint64_t kFnvBegin = 0xCBF29CE484222325u;

void hash_bytes(const void* bytes, std::size_t size, std::uint64_t& hash) {
  for (std::size_t k = 0; k < size; ++k) hash = (hash ^ static_cast<const unsigned char*>(bytes)[k]) * 0x100000001B3u;
}

/// Calls `visit(name, value)` for each setting that a vehicle's behaviour depends on.
template <typename Settings, typename Visit>
void visit_settings(Settings& settings, Visit visit) {
  visit("seed", settings.seed);
  visit("tick_hz", settings.tick_hz);
  visit("late", settings.late);
  visit("send_hz", settings.send_hz);
  visit("packet_bytes", settings.packet_bytes);
  visit("clock_error", settings.clock_error);
  visit("restarts", settings.restarts);
  visit("clearance", settings.clearance);
  visit("delay_max", settings.links.delay_max);
  visit("discover", settings.discover);
  visit("range", settings.range);
  visit("tracking_margin", settings.tracking_margin);
  visit("work_per_tick", settings.work_per_tick);
  visit("fleet_work", settings.fleet_work);
}

/// Brings what was recorded.
class ReplayedCarrier : public Carrier {
 public:
  explicit ReplayedCarrier(const SwarmRecord& record) : record_(record) {}
  void begin(const SwarmRecord::Tick& tick) {
    tick_ = &tick;
    hash = kFnvBegin;
  }
  void send(int, const Packet& packet, std::int64_t) override { hash_bytes(packet.data(), packet.size(), hash); }
  std::vector<Packet> receive(int, std::int64_t) override {
    std::vector<Packet> packets;
    for (const std::uint32_t number : tick_->heard) packets.push_back(record_.packets.at(number));
    return packets;
  }
  std::uint64_t hash = kFnvBegin;

 private:
  const SwarmRecord& record_;
  const SwarmRecord::Tick* tick_ = nullptr;
};

}  // namespace

std::uint64_t SwarmRecord::hash() const {
  std::uint64_t all = kFnvBegin;
  for (const Vehicle& vehicle : vehicles) {
    for (const Tick& tick : vehicle.ticks) hash_bytes(&tick.hash, sizeof tick.hash, all);
  }
  return all;
}

void RecordingCarrier::send(int from, const Packet& packet, std::int64_t now) {
  hash_bytes(packet.data(), packet.size(), record_.vehicles[static_cast<std::size_t>(from)].ticks.back().hash);
  inner_.send(from, packet, now);
}

std::vector<Packet> RecordingCarrier::receive(int to, std::int64_t now) {
  std::vector<Packet> packets = inner_.receive(to, now);
  SwarmRecord::Tick tick{now, {}, kFnvBegin};
  for (const Packet& packet : packets) {
    const auto [at, is_new] = numbers_.try_emplace(packet, static_cast<std::uint32_t>(record_.packets.size()));
    if (is_new) record_.packets.push_back(packet);
    tick.heard.push_back(at->second);
  }
  record_.vehicles[static_cast<std::size_t>(to)].ticks.push_back(std::move(tick));
  return packets;
}

void RecordingCarrier::end_tick(int vehicle, const tern::Vec3& position) {
  hash_bytes(&position, sizeof position, record_.vehicles[static_cast<std::size_t>(vehicle)].ticks.back().hash);
}

std::string write_swarm_record(const SwarmRecord& record) {
  nlohmann::json settings;
  visit_settings(record.settings, [&](const char* name, const auto& value) { settings[name] = value; });
  nlohmann::json packets = nlohmann::json::array();
  for (const Packet& packet : record.packets) packets.push_back(nlohmann::json::binary(packet.bytes()));
  nlohmann::json vehicles = nlohmann::json::array();
  for (const SwarmRecord::Vehicle& vehicle : record.vehicles) {
    nlohmann::json ticks = nlohmann::json::array();
    for (const SwarmRecord::Tick& tick : vehicle.ticks)
      ticks.push_back(nlohmann::json::array({tick.now, tick.hash, tick.heard}));
    vehicles.push_back({{"clock_offset", vehicle.clock_offset}, {"ticks", ticks}});
  }
  nlohmann::json all{{"configuration", tern::kConfigurationHash},
                     {"format", kFormat},
                     {"packets", packets},
                     {"settings", settings},
                     {"vehicles", vehicles},
                     {"world", record.world}};
  if (!record.intruders.empty()) all["intruders"] = lines_of(record.intruders);
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(all);
  return {bytes.begin(), bytes.end()};
}

bool is_swarm_record(const std::string& bytes) {
  // A map whose keys are in order begins with this one; what follows its two lengths is its value.
  const std::string key = "configuration";
  return bytes.size() > 1 + key.size() && bytes.compare(2, key.size(), key) == 0;
}

SwarmRecord read_swarm_record(const std::string& bytes) {
  SwarmRecord record;
  try {
    const nlohmann::json all = nlohmann::json::from_cbor(bytes);
    if (all.at("format") != kFormat) throw std::runtime_error("it has another format");
    if (all.at("configuration") != tern::kConfigurationHash) {
      throw std::runtime_error("it is of a library with other capacities");
    }
    record.world = all.at("world");
    for (const std::string line : all.value("intruders", nlohmann::json::array())) {
      record.intruders.push_back(read_thing(split_words(line, false), {"intruders"}));
    }
    visit_settings(record.settings, [&](const char* name, auto& value) { all.at("settings").at(name).get_to(value); });
    for (const nlohmann::json& packet : all.at("packets")) record.packets.emplace_back(packet.get_binary());
    for (const nlohmann::json& one : all.at("vehicles")) {
      record.vehicles.push_back({one.at("clock_offset"), {}});
      for (const nlohmann::json& tick : one.at("ticks")) {
        record.vehicles.back().ticks.push_back({tick.at(0), tick.at(2), tick.at(1)});
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("it is no record of a swarm: ") + error.what());
  }
  return record;
}

std::string replay_swarm(const SwarmRecord& record) {
  SwarmWorld world = swarm_world(record.world);
  world.intruders = record.intruders;
  if (record.vehicles.size() != world.tasks.size()) throw std::runtime_error("it has another number of vehicles");
  ReplayedCarrier carrier(record);
  for (std::size_t k = 0; k < record.vehicles.size(); ++k) {
    SwarmVehicle vehicle(world, record.settings, static_cast<int>(k), record.vehicles[k].clock_offset);
    for (const SwarmRecord::Tick& tick : record.vehicles[k].ticks) {
      carrier.begin(tick);
      vehicle.tick(tick.now, carrier);
      const tern::Vec3 position = vehicle.at(tick.now).position;
      hash_bytes(&position, sizeof position, carrier.hash);
      if (carrier.hash == tick.hash) continue;
      char text[100];
      std::snprintf(text, sizeof text, "vehicle %zu differs from %.3f s on", k, seconds_of(tick.now));
      return text;
    }
  }
  return "";
}

}  // namespace tern_host
