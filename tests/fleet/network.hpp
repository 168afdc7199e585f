// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Links that lose, delay, repeat and reorder packets, lose many at a time, or fall apart into islands.
#ifndef TERN_TESTS_FLEET_NETWORK_HPP
#define TERN_TESTS_FLEET_NETWORK_HPP

#include <cstdint>
#include <vector>

#include "support/random.hpp"

namespace tern_test {

struct LinkSpec {
  double loss = 0.0;      ///< 0 .. 1
  int delay = 0;          ///< steps, at most; each packet has its own, so they overtake each other
  double repeats = 0.05;  ///< of packets that come twice
  bool bursts = false;    ///< losses come together: a link is out for a while
  bool islands = false;   ///< half of the time, only vehicles of the same half hear each other
};

struct Packet {
  int to;
  int at;  ///< step in which it arrives
  std::vector<std::uint8_t> bytes;
};

class Network {
 public:
  Network(const LinkSpec& spec, int vehicles, Random& random)
      : spec_(spec), vehicles_(vehicles), random_(random), out_until_(static_cast<std::size_t>(vehicles * vehicles)) {}

  void send(int from, int step, const std::uint8_t* bytes, std::int32_t size) {
    for (int to = 0; to < vehicles_; ++to) {
      if (to == from) continue;
      for (int copies = random_.chance(spec_.repeats) ? 2 : 1; copies > 0; --copies) {
        if (is_lost(from, to, step)) continue;
        const int at = step + 1 + (spec_.delay > 0 ? random_.integer(0, spec_.delay) : 0);
        air_.push_back({to, at, std::vector<std::uint8_t>(bytes, bytes + size)});
      }
    }
  }
  /// The packets that arrive in this step, in any order.
  std::vector<Packet> arrivals(int step) {
    std::vector<Packet> now;
    for (std::size_t k = 0; k < air_.size();) {
      if (air_[k].at > step) {
        ++k;
        continue;
      }
      now.push_back(air_[k]);
      air_[k] = air_.back();
      air_.pop_back();
    }
    return now;
  }

 private:
  bool is_lost(int from, int to, int step) {
    if (spec_.islands && step / 300 % 2 == 1 && from % 2 != to % 2) return true;
    if (!spec_.bursts) return random_.chance(spec_.loss);
    int& until = out_until_[static_cast<std::size_t>(from * vehicles_ + to)];
    if (step >= until && random_.chance(0.02 * spec_.loss)) until = step + random_.integer(10, 200);
    return step < until;
  }

  LinkSpec spec_;
  int vehicles_;
  Random& random_;
  std::vector<int> out_until_;
  std::vector<Packet> air_;
};

}  // namespace tern_test

#endif
