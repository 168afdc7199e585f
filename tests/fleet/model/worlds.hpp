// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The states of the world that the steps of the vehicles lead to, and what must hold in each of them.
#ifndef TERN_TESTS_FLEET_MODEL_WORLDS_HPP
#define TERN_TESTS_FLEET_MODEL_WORLDS_HPP

#include "fleet/model/explorer.hpp"

namespace tern_model {

class Worlds {
 public:
  explicit Worlds(const Setting& setting) : setting_(setting), vehicles_(setting) {}

  /// All vehicles at rest at their places, each knows of each.
  World start() {
    World world;
    world.sent = sets_.of({});
    for (int v = 0; v < setting_.vehicles; ++v) {
      tern::Fleet fleet;
      // By range, each listened long enough before.
      const std::int64_t begin = -setting_.range.within - kTick;
      fleet.begin(vehicles_.spec(v, 1), tern_test::resting(setting_.places[index(v)], begin), begin);
      for (int other = 0; setting_.range.join <= 0.0 && other < setting_.vehicles; ++other) {
        if (other != v) fleet.add(static_cast<std::uint16_t>(other + 1), 0);
      }
      tern::Work work(1);
      if (setting_.range.join > 0.0) fleet.advance(0, work);
      tell(world, vehicles_.said(fleet));
      world.fleets[index(v)] = vehicles_.keep(fleet);
    }
    const Set first = sets_.value(world.sent);
    const int rounds = setting_.range.join > 0.0 ? 1 : 4;
    for (int round = 0; round < rounds; ++round) deliver_all(world);
    world.sent = sets_.of(setting_.keeps_first ? first : Set{});
    tell(world, newest_of_all(world));
    return world;
  }

  /// The worlds that one step leads to.
  void next(const World& world, std::vector<World>& after) {
    after.clear();
    for (int v = 0; v < setting_.vehicles; ++v) {
      next_of(world, v, after);
    }
    if (setting_.skew == 0) tick_all(world, after);
  }

  /// One step of those that next() knows, at random. Time goes on in a fifth of them, and plans are announced so seldom
  /// that most are decided about before the next one. In slices, most steps are pieces of proofs.
  void stray(World& world, tern_test::Random& random) {
    if (setting_.in_slices && random.chance(1.0 - 0.4 / setting_.vehicles)) {
      act(world, random.integer(0, setting_.vehicles - 1), Act::kProve, 0);
      return;
    }
    next(world, after_);
    if (after_.empty()) return;
    std::size_t k = after_.size() - 1;
    for (int draws = random.chance(0.2) ? 0 : 20; draws > 0; --draws) {
      k = static_cast<std::size_t>(random.integer(0, static_cast<int>(after_.size()) - 1));
      if (after_[k].announced == world.announced || random.chance(0.1)) break;
    }
    world = after_[k];
  }

  /// True if what the vehicles fly, from now on, keeps them apart. Sampled, by arithmetic of the test.
  bool is_safe(const World& world) {
    bool safe = true;
    for (int a = 0; a < setting_.vehicles; ++a) {
      for (int b = 0; b < a; ++b) safe = are_apart(world, a, b) && safe;
    }
    return safe;
  }

  /// If all messages arrive from now on, everyone gets a plan through that is in nobody's way.
  bool is_alive(World world) {
    int clock = 0;
    for (int v = 0; v < setting_.vehicles; ++v) clock = std::max<int>(clock, world.clocks[index(v)]);
    settle_all(world, clock);
    for (int v = 0; v < setting_.vehicles; ++v) {
      const std::uint32_t before = vehicles_.flown_number(world.fleets[index(v)]);
      if (!act(world, v, Act::kAnnounce, 7)) continue;  // beyond the targets: it stays in place; or it has left
      settle_all(world, clock);
      if (vehicles_.flown_number(world.fleets[index(v)]) == before) return false;
    }
    return true;
  }

  std::size_t fleets() const { return vehicles_.count(); }
  std::uint32_t flown(const World& world, int v) { return vehicles_.flown_number(world.fleets[index(v)]); }

 private:
  using Set = std::vector<std::uint32_t>;
  static std::size_t index(int v) { return static_cast<std::size_t>(v); }

  void tell(World& world, const Set& said) {
    for (const std::uint32_t message : said) {
      const std::uint64_t key = static_cast<std::uint64_t>(world.sent) << 32 | message;
      const auto known = told_.find(key);
      if (known != told_.end()) {
        world.sent = known->second;
        continue;
      }
      world.sent = sets_.of(with(sets_.value(world.sent), message));
      told_[key] = world.sent;
    }
  }
  /// In the order in which a vehicle said them; the oldest one of too many is lost.
  Set with(Set set, std::uint32_t message) {
    if (std::find(set.begin(), set.end(), message) != set.end()) return set;
    const int of = vehicles_.sender(message);
    const auto is_its = [&](std::uint32_t other) { return vehicles_.sender(other) == of; };
    if (static_cast<std::size_t>(std::count_if(set.begin(), set.end(), is_its)) == setting_.in_the_air) {
      set.erase(std::find_if(set.begin(), set.end(), is_its));
    }
    const auto behind = [&](std::uint32_t other) { return vehicles_.sender(other) <= of; };
    set.insert(std::find_if(set.rbegin(), set.rend(), behind).base(), message);
    return set;
  }
  bool act(World& world, int v, Act what, std::uint32_t argument) {
    const Vehicles::After& after = vehicles_.step(v, world.fleets[index(v)], world.clocks[index(v)], what, argument);
    if (!after.done) return false;
    world.fleets[index(v)] = after.fleet;
    tell(world, after.said);
    return true;
  }
  void add(const World& world, World next, std::vector<World>& after) {
    if (!(next == world)) after.push_back(next);
  }
  void next_of(const World& world, int v, std::vector<World>& after) {
    const std::size_t i = index(v);
    for (std::uint32_t target = 0; world.announced[i] < setting_.announcements && target < setting_.targets[i].size();
         ++target) {
      World next = world;
      ++next.announced[i];
      if (act(next, v, Act::kAnnounce, target)) add(world, next, after);
    }
    if (world.withdrawn[i] < setting_.withdrawals) {
      World next = world;
      if (act(next, v, Act::kWithdraw, 0) && next.fleets[i] != world.fleets[i]) {
        ++next.withdrawn[i];
        add(world, next, after);
      }
    }
    for (std::uint32_t higher = 0; world.restarts < setting_.restarts && higher < 2; ++higher) {
      World next = world;
      ++next.restarts;
      if (act(next, v, Act::kRestart, 2 * (2u + world.restarts) + higher)) add(world, next, after);
    }
    if (world.departures < setting_.departures) {
      World next = world;
      ++next.departures;
      if (act(next, v, Act::kLeave, 0) && next.fleets[i] != world.fleets[i]) add(world, next, after);
    }
    for (const std::uint32_t message : sets_.value(world.sent)) {
      if (vehicles_.sender(message) == v) continue;
      World next = world;
      if (act(next, v, Act::kHear, message)) add(world, next, after);
    }
    if (setting_.in_slices) {
      World next = world;
      act(next, v, Act::kProve, 0);
      add(world, next, after);
    }
    if (setting_.skew > 0) tick_one(world, v, after);
  }
  void tick_one(const World& world, int v, std::vector<World>& after) {
    int slowest = 255;
    for (int other = 0; other < setting_.vehicles; ++other)
      slowest = std::min<int>(slowest, world.clocks[index(other)]);
    if (world.clocks[index(v)] >= setting_.last_tick || world.clocks[index(v)] - slowest >= setting_.skew) return;
    World next = world;
    ++next.clocks[index(v)];
    act(next, v, Act::kWait, 0);
    add(world, next, after);
  }
  void tick_all(const World& world, std::vector<World>& after) {
    if (world.clocks[0] >= setting_.last_tick) return;
    World next = world;
    tick(next);
    add(world, next, after);
  }
  void tick(World& world) {
    for (int v = 0; v < setting_.vehicles; ++v) {
      ++world.clocks[index(v)];
      act(world, v, Act::kWait, 0);
    }
  }
  /// Everyone hears what everyone says now.
  void deliver_all(World& world) {
    for (const std::uint32_t message : newest_of_all(world)) {
      for (int v = 0; v < setting_.vehicles; ++v) {
        if (vehicles_.sender(message) != v) act(world, v, Act::kHear, message);
      }
    }
    for (int v = 0; setting_.in_slices && v < setting_.vehicles; ++v) act(world, v, Act::kFinish, 0);
  }
  Set newest_of_all(const World& world) {
    Set newest;
    for (int v = 0; v < setting_.vehicles; ++v) {
      tern::Fleet fleet;
      vehicles_.load(world.fleets[index(v)], fleet);
      for (const std::uint32_t message : vehicles_.said(fleet)) newest.push_back(message);
    }
    return newest;
  }
  /// Messages arrive, and clocks go on, until nothing is announced any more.
  void settle_all(World& world, int& clock) {
    for (int v = 0; v < setting_.vehicles; ++v) world.clocks[index(v)] = static_cast<std::uint16_t>(clock);
    for (int turn = 0; turn < 4 + static_cast<int>(setting_.seconds) + setting_.settling; ++turn) {
      for (int round = 0; round < 4; ++round) deliver_all(world);
      tick(world);
      ++clock;
    }
  }

  bool are_apart(const World& world, int a, int b) {
    const std::uint64_t key = static_cast<std::uint64_t>(flown(world, a)) << 42 |
                              static_cast<std::uint64_t>(flown(world, b)) << 20 |
                              static_cast<std::uint64_t>(world.clocks[index(a)]) << 10 | world.clocks[index(b)];
    const auto [at, is_new] = apart_.try_emplace(key, true);
    if (!is_new) return at->second;
    const tern::Trajectory of_a = vehicles_.trajectory(flown(world, a));
    const tern::Trajectory of_b = vehicles_.trajectory(flown(world, b));
    for (int k = 0; k <= 300; ++k) {
      const auto since = static_cast<std::int64_t>(k * (setting_.seconds + 4.0) * 1e9 / 150.0);
      tern::Vec3 of = tern_test::place_at(of_a, world.clocks[index(a)] * kTick + since);
      const tern::Vec3 to = tern_test::place_at(of_b, world.clocks[index(b)] * kTick + since);
      of = {of.x + of_a.origin.x - of_b.origin.x, of.y + of_a.origin.y - of_b.origin.y,
            of.z + of_a.origin.z - of_b.origin.z};
      if (tern_test::between(of, to) < 1.0 - 1e-6) return at->second = false;
    }
    return true;
  }

  const Setting& setting_;
  Vehicles vehicles_;
  struct HashOfSet {
    std::size_t operator()(const Set& set) const {
      std::uint64_t hash = 0;
      for (const std::uint32_t message : set) hash = (hash ^ message) * 0x9E3779B97F4A7C15u;
      return hash ^ hash >> 32;
    }
  };
  Numbers<Set, HashOfSet> sets_;
  std::unordered_map<std::uint64_t, std::uint32_t> told_;
  std::unordered_map<std::uint64_t, bool> apart_;
  std::vector<World> after_;
};

}  // namespace tern_model

#endif
