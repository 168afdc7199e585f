// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one vehicle of a swarm does in its process, and how it talks with the process that began it.
#ifndef TERN_HOST_SWARM_VEHICLE_PROCESS_HPP
#define TERN_HOST_SWARM_VEHICLE_PROCESS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/swarm/socket_carrier.hpp"
#include "host/swarm/swarm_record.hpp"

namespace tern_host {

/// Positions are kept for each millisecond, ns. In between, a vehicle is as good as on a straight line: at 20 m/s^2, it
/// is 2.5 um off.
constexpr std::int64_t kSampleStep = 1000000;
/// What a process says before its result.
constexpr char kReady = 'R';
constexpr char kArrived = 'A';

/// Of the steady clock, which all processes share, ns.
std::int64_t clock_now();
/// Writes all bytes to a socket. Throws std::runtime_error if nobody reads them.
void put(int descriptor, const void* bytes, std::size_t size);
/// Up to `size` bytes; fewer at the end.
std::size_t get(int descriptor, void* bytes, std::size_t size);
bool has_news(int descriptor);

class VehicleProcess {
 public:
  VehicleProcess(const SwarmWorld& world, const SwarmSettings& settings, int number, std::int64_t clock_offset,
                 const std::vector<LoopbackSocket>& sockets);
  /// Flies from `start` on, by the steady clock, until the parent says that it is over.
  void fly(std::int64_t start, int parent);
  /// CBOR: the record of this vehicle, its positions, and what it counted.
  std::vector<std::uint8_t> result() const;

 private:
  void keep_positions(std::int64_t now);
  void note(const SwarmTick& did);

  const SwarmSettings& settings_;
  int number_;
  SwarmVehicle vehicle_;
  SocketCarrier sockets_;
  SwarmRecord record_;
  RecordingCarrier carrier_;
  bool has_arrived_ = false;
  std::int64_t sampled_ = 0;
  std::vector<double> positions_;
  std::uint32_t commits_ = 0, unasked_ = 0, disagreed_ = 0, fleet_units_ = 0;
  int untold_ = 0;
  double computed_ = 0.0;  ///< s of processor time
};

}  // namespace tern_host

#endif
