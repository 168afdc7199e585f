// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Radio links between vehicles that lose, delay, repeat and reorder packets.
#ifndef TERN_HOST_SWARM_LINKS_HPP
#define TERN_HOST_SWARM_LINKS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "host/flight/noise.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// Between these times, vehicles with an even number hear none with an odd one, and the other way round.
struct Partition {
  double from = 0.0;   ///< s
  double until = 0.0;  ///< s
};

struct LinkSettings {
  double loss = 0.0;       ///< part of the packets that is lost
  double burst = 1.0;      ///< packets in a row that are lost, on average, >= 1
  double delay_min = 0.0;  ///< s
  double delay_max = 0.0;  ///< s; packets with different delays overtake each other
  double repeated = 0.0;   ///< part of the packets that comes twice
  Partition partition;
  int deaf = -1;             ///< this vehicle hears nobody, though it is heard; -1: none
  int silent = -1;           ///< this vehicle is not heard any more from silent_from on; -1: none
  double silent_from = 0.0;  ///< s
  double radio = 0.0;  ///< m, on the axis on which it is most: vehicles farther apart hear nothing; 0: all hear all
};

/// Bytes that do not change: all who hear a packet share them.
class Packet {
 public:
  Packet(std::vector<std::uint8_t> bytes)  // NOLINT(google-explicit-constructor)
      : bytes_(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))) {}
  const std::vector<std::uint8_t>& bytes() const { return *bytes_; }
  const std::uint8_t* data() const { return bytes_->data(); }
  std::size_t size() const { return bytes_->size(); }
  bool operator<(const Packet& other) const { return *bytes_ < *other.bytes_; }

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> bytes_;
};

/// What carries packets between vehicles.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;
  /// Vehicle `from` sends a packet to all others at `now`, ns.
  virtual void send(int from, const Packet& packet, std::int64_t now) = 0;
  /// What arrives at a vehicle up to `now`, in order of arrival.
  virtual std::vector<Packet> receive(int to, std::int64_t now) = 0;
};

/// The links between all pairs. Equal seeds and calls give the same packets on every platform.
class Links : public Carrier {
 public:
  Links(const LinkSettings& settings, int vehicles, std::uint64_t seed);

  void send(int from, const Packet& packet, std::int64_t now) override;
  std::vector<Packet> receive(int to, std::int64_t now) override;

  /// Where a vehicle is from now on.
  void move(int vehicle, const tern::Vec3& place) { places_[static_cast<std::size_t>(vehicle)] = place; }

  std::uint64_t sent() const { return sent_; }    ///< packets to one vehicle each
  std::uint64_t lost() const { return lost_; }    ///< of those
  std::uint64_t bytes() const { return bytes_; }  ///< that were sent, each packet once

 private:
  bool reaches(int from, int to) const;
  bool loses(int from, int to, double now);
  void fly(int to, const Packet& packet, std::int64_t now);

  LinkSettings settings_;
  int vehicles_;
  Noise noise_;
  std::vector<tern::Vec3> places_;
  std::vector<char> in_burst_;  ///< of each link: it loses the next packet, too
  /// By time of arrival and number.
  std::vector<std::map<std::pair<std::int64_t, std::uint64_t>, Packet>> in_the_air_;
  std::uint64_t sent_ = 0, lost_ = 0, bytes_ = 0, number_ = 0;
};

}  // namespace tern_host

#endif
