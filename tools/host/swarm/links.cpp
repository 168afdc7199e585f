// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/links.hpp"

#include <algorithm>
#include <cmath>

#include "host/nanoseconds.hpp"

namespace tern_host {

Links::Links(const LinkSettings& settings, int vehicles, std::uint64_t seed)
    : settings_(settings),
      vehicles_(vehicles),
      noise_(seed),
      places_(static_cast<std::size_t>(vehicles)),
      in_burst_(static_cast<std::size_t>(vehicles) * static_cast<std::size_t>(vehicles)),
      in_the_air_(static_cast<std::size_t>(vehicles)) {}

bool Links::reaches(int from, int to) const {
  if (settings_.radio <= 0.0) return true;
  const tern::Vec3& a = places_[static_cast<std::size_t>(from)];
  const tern::Vec3& b = places_[static_cast<std::size_t>(to)];
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) <= settings_.radio;
}

/// A chain of two states: bursts of the mean length, so far apart that the part that is lost is `loss`. Packets that
/// are lost each by itself come in bursts of 1 / (1 - loss) on average: bursts are never shorter.
bool Links::loses(int from, int to, double now) {
  if (from == settings_.silent && now >= settings_.silent_from) return true;
  if (to == settings_.deaf) return true;
  if (now >= settings_.partition.from && now < settings_.partition.until && (from - to) % 2 != 0) return true;
  if (settings_.loss >= 1.0) return true;
  char& in_burst = in_burst_[static_cast<std::size_t>(from * vehicles_ + to)];
  const double ends = std::min(1.0 / settings_.burst, 1.0 - settings_.loss);
  const double begins = ends * settings_.loss / (1.0 - settings_.loss);
  in_burst = noise_.chance(in_burst != 0 ? 1.0 - ends : begins) ? 1 : 0;
  return in_burst != 0;
}

void Links::fly(int to, const Packet& packet, std::int64_t now) {
  const double delay = noise_.within(settings_.delay_min, settings_.delay_max);
  in_the_air_[static_cast<std::size_t>(to)].emplace(
      std::make_pair(now + static_cast<std::int64_t>(1e9 * delay), number_++), packet);
}

void Links::send(int from, const Packet& packet, std::int64_t now) {
  bytes_ += packet.size();
  for (int to = 0; to < vehicles_; ++to) {
    if (to == from || !reaches(from, to)) continue;
    ++sent_;
    if (loses(from, to, seconds_of(now))) {
      ++lost_;
      continue;
    }
    fly(to, packet, now);
    if (noise_.chance(settings_.repeated)) fly(to, packet, now);
  }
}

std::vector<Packet> Links::receive(int to, std::int64_t now) {
  auto& waiting = in_the_air_[static_cast<std::size_t>(to)];
  std::vector<Packet> arrived;
  while (!waiting.empty() && waiting.begin()->first.first <= now) {
    arrived.push_back(std::move(waiting.begin()->second));
    waiting.erase(waiting.begin());
  }
  return arrived;
}

}  // namespace tern_host
