// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a fleet to a flight: the plans that others fly or may fly, each told once.
#ifndef TERN_HOST_SWARM_SWARM_TRAFFIC_HPP
#define TERN_HOST_SWARM_SWARM_TRAFFIC_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "tern/fleet.hpp"
#include "tern/flight.hpp"

namespace tern_host {

class SwarmTraffic {
 public:
  /// `begin`: of the flight, ns; `tick`: FlightSpec::tick; `room`: for so many plans at most.
  void start(std::int64_t begin, std::int64_t tick, std::size_t room) {
    last_tick_ = begin;
    tick_ = tick;
    room_ = room;
  }
  /// Before a tick of the flight at `time`, tells it of plans that are new, and of what is gone. Returns how many plans
  /// the flight has no room for: if not all fit, it gets those nearest to `place`.
  int tell(const tern::Fleet& fleet, tern::Flight& flight, const tern::Vec3& place, std::int64_t time);

 private:
  /// One of the two plans of a member.
  struct Plan {
    std::uint32_t number = 0;  ///< 0: none
    std::int32_t pieces = 0;
    tern::Box around{};  ///< all that is left of it, when it was looked at
  };
  /// What was last seen of a member.
  struct Other {
    tern::Neighbour neighbour;
    std::int64_t looked = 0;  ///< when
    Plan plans[2];            ///< that it flies, and that it may fly
  };
  /// A plan that the flight is told of: of which member, which of its two plans, and which plan of which incarnation.
  struct Told {
    std::int32_t index;
    int which;
    std::uint64_t plan;
  };
  int ask(const tern::Fleet& fleet, std::int64_t time);
  void look(const tern::Fleet& fleet, std::int32_t index, std::int64_t time);
  std::int32_t read(const tern::Fleet& fleet, std::int32_t index, std::int64_t time);
  std::map<std::uint32_t, Told> choose(const tern::Vec3& place) const;
  bool update(const tern::Fleet& fleet, tern::Flight& flight, std::uint32_t id, const Told& news, std::int64_t time);

  std::vector<Other> others_;
  tern::Track tracks_[2];
  std::vector<tern::TrackPiece> pieces_ = std::vector<tern::TrackPiece>(64);
  std::int64_t last_tick_ = 0, tick_ = 0;
  std::size_t room_ = 0;
  std::map<std::uint32_t, std::uint64_t> known_;  ///< plans that the flight has, by the track's id
};

}  // namespace tern_host

#endif
