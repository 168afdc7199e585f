// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fleet over a lossy network that is the same on every target: no file, no heap and no libm. Vehicles hop between the
// places of a lattice, whoever stands in the way; a third of the packets is lost, the others come late and out of
// order, clocks differ, and one member begins anew. The hash is over every packet, every answer and where everyone is.
#ifndef TERN_TESTS_GOLDEN_FLEET_RUN_HPP
#define TERN_TESTS_GOLDEN_FLEET_RUN_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tern/fleet.hpp"

namespace tern_golden {

/// What is flown: at most 11 members, and 10 segments of a plan.
struct FleetSetting {
  int members = 4;
  int legs = 3;  ///< segments of a plan
  int ticks = 400;
  int restart = 200;  ///< the tick in which member 1 begins anew
  double join = 0.0;  ///< m: members are those that are so near; 0: each is one of each
};

constexpr int kMostMembers = 11;
/// m: with it, members of the golden fleet by range come and go.
constexpr double kGoldenJoin = 4.5;
constexpr std::uint32_t kFleetWork = 250;  ///< units of proofs a tick
constexpr std::int64_t kFleetTick = 100'000'000;
constexpr std::int64_t kClockError = 10'000'000;
constexpr int kMostDelay = 3;  ///< ticks
constexpr std::int32_t kPacketRoom = 400;
constexpr int kMostPackets = 6;  ///< of a vehicle in a tick

struct SentPacket {
  std::int32_t size;
  std::uint8_t delay[kMostMembers];  ///< ticks until each member gets it; 0: lost
  std::uint8_t bytes[kPacketRoom];
};

/// Too large for a stack.
template <int kMembers>
struct FleetRunMemory {
  tern::Fleet fleets[kMembers];
  tern::Trajectory plan;
  SentPacket air[kMostDelay + 1][kMembers][kMostPackets];
};

struct FleetTotals {
  std::uint64_t hash = 0xCBF29CE484222325u;
  int announced = 0, taken = 0, refused = 0, unanswered = 0, conflicts = 0, strangers = 0;
  std::uint64_t most = 0;  ///< what a vehicle's calls took in a tick
  std::uint64_t sum = 0;   ///< of all ticks of all vehicles
  std::uint32_t most_units = 0;
};

template <int kMembers, typename Count>
class FleetRun {
 public:
  FleetRun(const FleetSetting& setting, FleetRunMemory<kMembers>& memory, Count count)
      : s_(setting), memory_(memory), count_(count) {}

  FleetTotals fly() {
    std::memset(static_cast<void*>(memory_.air), 0, sizeof memory_.air);
    for (int v = 0; v < s_.members; ++v) {
      hop(place(v), place(v), 1, 0);
      begin(v, memory_.plan, 0);
    }
    for (tick_ = 1; tick_ <= s_.ticks; ++tick_) {
      for (int v = 0; v < s_.members; ++v) act(v);
    }
    return totals_;
  }

 private:
  std::uint32_t below(std::uint32_t count) {
    seed_ = seed_ * 1664525u + 1013904223u;
    return static_cast<std::uint32_t>((std::uint64_t{seed_ >> 8} * count) >> 24);
  }
  /// Places 2 m apart.
  static tern::Vec3 place(int number) { return {2.0 * (number % 4), 2.0 * (number / 4 % 4), 1.0}; }
  std::int64_t clock(int v) const { return tick_ * kFleetTick + v * (kClockError / kMostMembers); }

  /// A straight way in so many pieces, with a rest behind each.
  void hop(const tern::Vec3& from, const tern::Vec3& to, int legs, std::int64_t begin) {
    tern::Trajectory& plan = memory_.plan;
    plan.begin = begin;
    plan.origin = from;
    plan.count = legs;
    for (int leg = 0; leg < legs; ++leg) {
      plan.segments[leg].duration = 1.25;
      for (int k = 0; k < tern::kControlPoints; ++k) {
        const double part = static_cast<double>(k < 4 ? leg : leg + 1) / legs;
        plan.segments[leg].points[k] = {part * (to.x - from.x), part * (to.y - from.y), 0.0};
      }
    }
  }
  /// No leg is faster on any axis, and plans rest before promises end.
  tern::FleetRange range() const {
    tern::FleetRange range;
    range.join = s_.join;
    range.heard = 200.0;
    range.speed = 2.1875 * 6.0 / (1.25 * s_.legs);
    range.within = 10 * kFleetTick;
    range.lease = 200 * kFleetTick;
    return range;
  }
  void begin(int v, const tern::Trajectory& flown, std::int64_t now) {
    tern::FleetSpec spec;
    spec.id = static_cast<std::uint16_t>(v + 1);
    spec.incarnation = ++incarnation_[v];
    spec.priority = static_cast<std::uint8_t>(v % 3);
    spec.radius = 0.4;
    spec.clock_error = kClockError;
    spec.tick = kFleetTick;
    spec.speed = 4.0;
    spec.range = range();
    memory_.fleets[v].begin(spec, flown, now);
    for (int other = 0; s_.join <= 0.0 && other < s_.members; ++other) {
      if (other != v) memory_.fleets[v].add(static_cast<std::uint16_t>(other + 1), now);
    }
  }

  void act(int v) {
    tern::Fleet& fleet = memory_.fleets[v];
    const std::int64_t now = clock(v);
    std::uint64_t begun = count_();
    hear(v, now);
    tern::Work work(kFleetWork);
    fleet.advance(now, work);
    note(v, now, kFleetWork - (work.left() ? work.units() : 0));
    if (v == 1 && tick_ == s_.restart) {
      const std::uint64_t before = count_();
      memory_.plan = *fleet.flown();
      begin(v, memory_.plan, now);
      begun += count_() - before;  // it clears all memory, which is no part of a tick
    }
    const tern::Announcement state = fleet.report().announcement;
    const bool waits = state == tern::Announcement::kProving || state == tern::Announcement::kOpen;
    if (!waits && below(4) == 0) announce(v, now);
    speak(v);
    const std::uint64_t took = count_() - begun;
    totals_.sum += took;
    if (took > totals_.most) totals_.most = took;
  }
  void hear(int v, std::int64_t now) {
    for (int ago = kMostDelay; ago > 0; --ago) {
      const int slot = (tick_ + kMostDelay + 1 - ago) % (kMostDelay + 1);
      for (int from = 0; from < s_.members; ++from) {
        for (const SentPacket& packet : memory_.air[slot][from]) {
          if (packet.size > 0 && packet.delay[v] == ago) memory_.fleets[v].receive(packet.bytes, packet.size, now);
        }
      }
    }
  }
  void speak(int v) {
    SentPacket* const mine = memory_.air[tick_ % (kMostDelay + 1)][v];
    for (int k = 0; k < kMostPackets; ++k) {
      mine[k].size = memory_.fleets[v].write(mine[k].bytes, kPacketRoom);
      for (int to = 0; to < s_.members; ++to) {
        mine[k].delay[to] = static_cast<std::uint8_t>(below(3) == 0 || to == v ? 0 : 1 + below(kMostDelay));
      }
      hash(mine[k].bytes, static_cast<std::size_t>(mine[k].size));
      if (mine[k].size == 0) break;
    }
  }
  void announce(int v, std::int64_t now) {
    const tern::Trajectory& flown = *memory_.fleets[v].flown();
    const std::int64_t end = flown.begin + static_cast<std::int64_t>(1e9 * tern::duration(flown));
    const std::int64_t soon = now + 8 * kFleetTick;
    const std::int64_t takeover = end > soon ? end : soon;
    hop(tern::evaluate(flown, tern::duration(flown)).position, place(static_cast<int>(below(16))), s_.legs, takeover);
    if (memory_.fleets[v].announce(memory_.plan, takeover, now) == tern::Status::kOk) ++totals_.announced;
  }
  void note(int v, std::int64_t now, std::uint32_t units) {
    const tern::FleetReport report = memory_.fleets[v].report();
    const tern::Trajectory& flown = *memory_.fleets[v].flown();
    const tern::Vec3 at = tern::evaluate(flown, tern::time_on(flown, now)).position;
    hash(&at, sizeof at);
    const std::uint8_t answer[3] = {static_cast<std::uint8_t>(report.announcement),
                                    static_cast<std::uint8_t>(report.blocked),
                                    static_cast<std::uint8_t>(report.blocked_by)};
    hash(answer, sizeof answer);
    if (units > totals_.most_units) totals_.most_units = units;
    const bool is_new = report.announcement != before_[v];
    before_[v] = report.announcement;
    if (!is_new) return;
    totals_.taken += report.announcement == tern::Announcement::kTaken ? 1 : 0;
    totals_.refused += report.blocked == tern::FleetBlock::kRefused ? 1 : 0;
    totals_.unanswered += report.blocked == tern::FleetBlock::kUnanswered ? 1 : 0;
    totals_.conflicts += report.blocked == tern::FleetBlock::kConflict ? 1 : 0;
    totals_.strangers += report.blocked == tern::FleetBlock::kStranger ? 1 : 0;
  }
  void hash(const void* bytes, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) {
      totals_.hash = (totals_.hash ^ static_cast<const std::uint8_t*>(bytes)[k]) * 0x100000001B3u;
    }
  }

  const FleetSetting& s_;
  FleetRunMemory<kMembers>& memory_;
  Count count_;
  FleetTotals totals_;
  std::uint32_t seed_ = 20261129u;
  std::uint32_t incarnation_[kMembers] = {};
  tern::Announcement before_[kMembers] = {};
  int tick_ = 0;
};

/// Flies. `count()` is what calls are measured with.
template <int kMembers, typename Count>
FleetTotals fly_fleet(const FleetSetting& setting, FleetRunMemory<kMembers>& memory, Count count) {
  return FleetRun<kMembers, Count>(setting, memory, count).fly();
}

}  // namespace tern_golden

#endif
