// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a swarm was told and what it did: for each tick of each vehicle its time, the packets that came, and a hash of
// where it was and of what it sent. A vehicle is a function of its ticks, so a record replays to the same bits.
#ifndef TERN_HOST_SWARM_SWARM_RECORD_HPP
#define TERN_HOST_SWARM_SWARM_RECORD_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/swarm/links.hpp"
#include "host/swarm/swarm_vehicle.hpp"

namespace tern_host {

struct SwarmRecord {
  struct Tick {
    std::int64_t now = 0;              ///< true time, ns
    std::vector<std::uint32_t> heard;  ///< which packets came, in order
    std::uint64_t hash = 0;            ///< FNV-1a of the packets that it sent, and of its position's bits
  };
  struct Vehicle {
    std::int64_t clock_offset = 0;  ///< ns
    std::vector<Tick> ticks;
  };
  std::string world;
  std::vector<Thing> intruders;
  SwarmSettings settings;
  std::vector<Packet> packets;
  std::vector<Vehicle> vehicles;

  /// Over the hashes of all ticks of all vehicles.
  std::uint64_t hash() const;
};

/// Writes down what a carrier brings to vehicles, and hashes what they send.
class RecordingCarrier : public Carrier {
 public:
  RecordingCarrier(Carrier& inner, SwarmRecord& record) : inner_(inner), record_(record) {}
  void send(int from, const Packet& packet, std::int64_t now) override;
  std::vector<Packet> receive(int to, std::int64_t now) override;
  /// The tick that began with receive() is over.
  void end_tick(int vehicle, const tern::Vec3& position);

 private:
  Carrier& inner_;
  SwarmRecord& record_;
  std::map<Packet, std::uint32_t> numbers_;
};

/// True for bytes that begin as a record does.
bool is_swarm_record(const std::string& bytes);
/// Throws std::runtime_error for bytes that are no record.
SwarmRecord read_swarm_record(const std::string& bytes);
std::string write_swarm_record(const SwarmRecord& record);

/// Flies the record again. Empty, or the first tick of the first vehicle that differs.
std::string replay_swarm(const SwarmRecord& record);

}  // namespace tern_host

#endif
