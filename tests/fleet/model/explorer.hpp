// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All that can happen to a few vehicles, breadth first: every order of announcing, withdrawing, restarting, the clocks'
// ticks and the arrival of messages. A message that was sent once may arrive at any time, any number of times, or
// never: that is loss, delay, repetition and reordering at once. The vehicles are tern::Fleet as it flies. Equal
// objects are kept once, and what a step makes of one is computed once, so a state of the world is a few numbers.
#ifndef TERN_TESTS_FLEET_MODEL_EXPLORER_HPP
#define TERN_TESTS_FLEET_MODEL_EXPLORER_HPP

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "fleet/fleet_access.hpp"
#include "fleet/model/padding.hpp"
#include "fleet/model/setting.hpp"
#include "fleet/plans.hpp"
#include "fleet/slices.hpp"
#include "tern/fleet.hpp"

namespace tern_model {

/// Numbers for values, in the order in which they came.
template <typename Value, typename Hash = std::hash<Value>>
class Numbers {
 public:
  std::uint32_t of(const Value& value) {
    const auto [at, is_new] = index_.try_emplace(value, static_cast<std::uint32_t>(values_.size()));
    if (is_new) values_.push_back(&at->first);
    return at->second;
  }
  const Value& value(std::uint32_t number) const { return *values_[number]; }
  std::size_t count() const { return values_.size(); }

 private:
  std::unordered_map<Value, std::uint32_t, Hash> index_;
  std::vector<const Value*> values_;
};

/// In slices, kProve does a piece of a proof, kFinish all of it, and the others nothing of it.
enum class Act : std::uint8_t { kAnnounce, kWithdraw, kRestart, kLeave, kHear, kWait, kProve, kFinish };

/// The vehicles, whose steps are computed once each.
class Vehicles {
 public:
  explicit Vehicles(const Setting& setting) : setting_(setting) {}

  /// A fleet without what decides nothing of what is checked here: a proof that is over, when something was heard,
  /// which unneeded plan is replaced first, and bytes that nobody reads.
  std::uint32_t keep(const tern::Fleet& fleet) {
    auto copy = std::make_unique<tern::Fleet>(fleet);
    tern::FleetMemory& memory = *tern::memory_of(*copy);
    without_proof(memory.job);
    for (tern::OwnPlan& own : memory.own) without_padding(own.name);
    for (int k = 0; k < tern::kMaxBeacons; ++k) without_padding(memory.beacons.of[k], k < memory.beacons.count);
    for (tern::Peer& peer : memory.peers) {
      peer.heard = 0;
      peer.packets = 0;
      if (memory.announcement != tern::Announcement::kProving) peer.proven = 0;
      for (std::uint32_t& packet : peer.last_packet) packet = 0;
      without_padding(peer.link);
      without_padding(peer.state);
      for (tern::PlanName& name : peer.names) without_padding(name);
      clean(peer.arriving);
      for (auto& plan : peer.plans) clean(plan);
    }
    return fleets_.of(packed(*copy));
  }
  void load(std::uint32_t number, tern::Fleet& fleet) const {
    std::memset(static_cast<void*>(&fleet), 0, sizeof fleet);
    const std::string& bytes = fleets_.value(number);
    for (std::size_t k = 0; k < bytes.size(); k += 10) {
      std::uint16_t at = 0;
      std::memcpy(&at, bytes.data() + k, 2);
      std::memcpy(reinterpret_cast<char*>(&fleet) + 8 * at, bytes.data() + k + 2, 8);
    }
  }

  struct After {
    std::uint32_t fleet = 0;
    std::vector<std::uint32_t> said;  ///< numbers of messages
    bool done = false;                ///< false: the step was refused
  };

  /// A step of vehicle `v`, and what it says after it.
  const After& step(int v, std::uint32_t fleet, int clock, Act act, std::uint32_t what) {
    const std::uint64_t key = static_cast<std::uint64_t>(fleet) << 36 | static_cast<std::uint64_t>(what) << 16 |
                              static_cast<std::uint64_t>(clock) << 6 | static_cast<std::uint64_t>(act) << 2 |
                              static_cast<std::uint64_t>(v);
    const auto known = after_.find(key);
    if (known != after_.end()) return known->second;
    load(fleet, scratch_);
    After after;
    after.done = act_on(v, kTick * clock, act, what);
    advance(kTick * clock, act);
    if (setting_.range.join <= 0.0) tern::memory_of(scratch_)->stamp = 0;  // else it says when to promise anew
    after.said = said(scratch_);
    after.fleet = keep(scratch_);
    return after_.emplace(key, after).first->second;
  }

  /// What the vehicle says, as messages: all in one, or state and plans apart.
  std::vector<std::uint32_t> said(tern::Fleet& fleet) {
    std::vector<std::uint32_t> numbers;
    std::string all;
    std::uint8_t packet[1000];
    while (const std::int32_t size = fleet.write(packet, sizeof packet)) {
      std::string message(1, static_cast<char>(size & 255));
      message += static_cast<char>(size >> 8);
      message.append(reinterpret_cast<const char*>(packet), static_cast<std::size_t>(size));
      if (setting_.in_pieces) numbers.push_back(messages_.of(message));
      all += message;
    }
    if (!setting_.in_pieces) numbers.push_back(messages_.of(all));
    return numbers;
  }

  int sender(std::uint32_t message) const { return static_cast<std::uint8_t>(messages_.value(message)[3]) - 1; }
  const tern::Trajectory& flown(std::uint32_t fleet) {
    load(fleet, scratch_);
    return *scratch_.flown();
  }
  std::uint32_t flown_number(std::uint32_t fleet) {
    const auto [at, is_new] = flown_of_.try_emplace(fleet, 0);
    if (is_new) {
      const tern::Trajectory& plan = flown(fleet);
      at->second = trajectories_.of(std::string(reinterpret_cast<const char*>(&plan), sizeof plan));
    }
    return at->second;
  }
  tern::Trajectory trajectory(std::uint32_t number) const {
    tern::Trajectory plan{};
    std::memcpy(static_cast<void*>(&plan), trajectories_.value(number).data(), sizeof plan);
    return plan;
  }
  tern::FleetSpec spec(int v, std::uint32_t incarnation) const {
    tern::FleetSpec spec;
    spec.id = static_cast<std::uint16_t>(v + 1);
    spec.incarnation = incarnation;
    spec.priority = setting_.priorities[static_cast<std::size_t>(v)];
    spec.radius = 0.5;
    spec.clock_error = setting_.skew * kTick;
    spec.tick = 1;  // takeovers are on time, as all happens at whole ticks
    spec.range = setting_.range;
    return spec;
  }
  std::size_t count() const { return fleets_.count(); }

 private:
  template <std::int32_t Bytes>
  static void clean(tern::Assembly<Bytes>& assembly) {
    std::memset(assembly.bytes + assembly.size, 0, static_cast<std::size_t>(Bytes - assembly.size));
  }
  /// The words that are not zero, behind their places.
  static std::string packed(const tern::Fleet& fleet) {
    std::string bytes;
    static_assert(sizeof(tern::Fleet) / 8 < 65536, "places have 16 bits");
    for (std::size_t k = 0; k < sizeof fleet / 8; ++k) {
      std::uint64_t word = 0;
      std::memcpy(&word, reinterpret_cast<const char*>(&fleet) + 8 * k, 8);
      if (word == 0) continue;
      const auto at = static_cast<std::uint16_t>(k);
      bytes.append(reinterpret_cast<const char*>(&at), 2);
      bytes.append(reinterpret_cast<const char*>(&word), 8);
    }
    return bytes;
  }
  void advance(std::int64_t now, Act act) {
    if (setting_.in_slices && act == Act::kProve) return tern_test::advance_a_piece(scratch_, now);
    tern::Work work(setting_.in_slices && act != Act::kFinish ? 0 : 1u << 30);
    scratch_.advance(now, work);
  }
  bool act_on(int v, std::int64_t now, Act act, std::uint32_t what) {
    switch (act) {
      case Act::kAnnounce:
        return announce(v, now, what);
      case Act::kWithdraw:
        scratch_.withdraw(now);
        return true;
      case Act::kRestart:
        return restart(v, now, what);
      case Act::kLeave:
        scratch_.leave(now);
        return true;
      case Act::kHear:
        hear(what, now);
        return true;
      case Act::kWait:
      case Act::kProve:
      case Act::kFinish:
        return true;
    }
    return false;
  }
  /// Two ticks ahead, straight to a target, from where the vehicle is at rest by then.
  bool announce(int v, std::int64_t now, std::uint32_t what) {
    const tern::Trajectory& flown = *scratch_.flown();
    const std::int64_t end = flown.begin + static_cast<std::int64_t>(1e9 * tern::duration(flown));
    const std::int64_t takeover = std::max(now + 2 * kTick, end);
    const tern::Vec3 from = tern::evaluate(flown, 1e9).position;
    const std::vector<tern::Vec3>& targets = setting_.targets[static_cast<std::size_t>(v)];
    const tern::Vec3 to = what < targets.size() ? targets[what] : from;
    const double way = tern_test::between(from, to);
    const double seconds =
        setting_.range.join > 0.0 ? std::max(1.0, std::ceil(kPeak * way / setting_.range.speed)) : setting_.seconds;
    const tern::Trajectory plan = tern_test::straight(from, to, takeover, seconds);
    return scratch_.announce(plan, takeover, now) == tern::Status::kOk;
  }
  /// `what`: twice the incarnation, and 1 more for a higher priority.
  bool restart(int v, std::int64_t now, std::uint32_t what) {
    const tern::Trajectory flown = *scratch_.flown();
    tern::FleetSpec again = spec(v, what / 2);
    if (what % 2 == 1) again.priority = 9;
    const tern::Beacons heard = tern::memory_of(scratch_)->beacons;
    scratch_.begin(again, flown, now);
    hear_at_once(heard);
    for (int other = 0; setting_.range.join <= 0.0 && other < setting_.vehicles; ++other) {
      if (other != v) scratch_.add(static_cast<std::uint16_t>(other + 1), now);
    }
    return true;
  }
  /// What was heard before is heard again, before anything else happens: so little time is enough for a restart.
  void hear_at_once(const tern::Beacons& heard) {
    tern::FleetMemory& memory = *tern::memory_of(scratch_);
    memory.beacons.begun = heard.begun;
    memory.beacons.count = heard.count;
    for (int k = 0; k < heard.count; ++k) {
      memory.beacons.of[k] = heard.of[k];
      memory.beacons.of[k].is_member = false;
      for (int p = 0; p < memory.peer_count; ++p)
        memory.beacons.of[k].is_member |= memory.peers[p].id == heard.of[k].id;
    }
  }
  void hear(std::uint32_t message, std::int64_t now) {
    const std::string& bytes = messages_.value(message);
    for (std::size_t k = 0; k < bytes.size();) {
      const int size = static_cast<std::uint8_t>(bytes[k]) + 256 * static_cast<std::uint8_t>(bytes[k + 1]);
      scratch_.receive(reinterpret_cast<const std::uint8_t*>(bytes.data()) + k + 2, size, now);
      k += static_cast<std::size_t>(size) + 2;
    }
  }

  const Setting& setting_;
  Numbers<std::string> fleets_;
  Numbers<std::string> messages_;
  Numbers<std::string> trajectories_;
  std::unordered_map<std::uint32_t, std::uint32_t> flown_of_;
  std::unordered_map<std::uint64_t, After> after_;
  tern::Fleet scratch_;
};

}  // namespace tern_model

#endif
