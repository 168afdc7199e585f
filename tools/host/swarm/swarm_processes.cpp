// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_processes.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/swarm/vehicle_process.hpp"

namespace tern_host {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// From the moment at which all are ready to the first tick, ns.
constexpr std::int64_t kHeadStart = 100000000;
struct Child {
  pid_t id = -1;
  int line = -1;  ///< to it and from it
  std::vector<double> positions;

  tern::Vec3 at(std::int64_t t) const {
    const auto last = static_cast<std::int64_t>(positions.size() / 3) - 1;
    const std::int64_t k = std::min(std::max<std::int64_t>(t / kSampleStep, 0), last);
    const std::int64_t next = std::min(k + 1, last);
    const double part = std::min(1.0, static_cast<double>(t - k * kSampleStep) / static_cast<double>(kSampleStep));
    const tern::Vec3 a = place(k);
    const tern::Vec3 b = place(next);
    return along(along(a, -part, a), part, b);
  }
  tern::Vec3 place(std::int64_t k) const {
    const auto i = 3 * static_cast<std::size_t>(k);
    return {positions[i], positions[i + 1], positions[i + 2]};
  }
};

class Processes {
 public:
  Processes(const SwarmWorld& world, const SwarmSettings& settings, SwarmRecord& record)
      : world_(world), settings_(settings), record_(record), children_(world.tasks.size()) {
    record.world = world.name;
    record.intruders = world.intruders;
    record.settings = settings;
    result_.members.resize(children_.size());
  }
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;
  ~Processes() {
    for (const Child& child : children_) {
      if (child.line >= 0) close(child.line);
      if (child.id > 0) waitpid(child.id, nullptr, 0);
    }
  }

  SwarmResult fly() {
    std::vector<LoopbackSocket> sockets;
    for (std::size_t k = 0; k < children_.size(); ++k) sockets.push_back(open_loopback_socket());
    Noise clocks(settings_.seed + 1);
    for (std::size_t k = 0; k < children_.size(); ++k) {
      const double off = clocks.within(-0.5 * settings_.clock_error, 0.5 * settings_.clock_error);
      begin(static_cast<int>(k), 1000000000 + static_cast<std::int64_t>(1e9 * off), sockets);
    }
    for (const LoopbackSocket& socket : sockets) close(socket.descriptor);
    for (Child& child : children_) expect(child, kReady);
    const std::int64_t start = clock_now() + kHeadStart;
    for (const Child& child : children_) put(child.line, &start, sizeof start);
    wait_for_arrivals(start);
    for (const Child& child : children_) put(child.line, &kArrived, 1);
    for (std::size_t k = 0; k < children_.size(); ++k) take_result(k);
    watch();
    result_.hash = record_.hash();
    return result_;
  }

 private:
  void begin(int number, std::int64_t clock_offset, const std::vector<LoopbackSocket>& sockets) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) throw std::runtime_error("no line to a process of the swarm");
    Child& child = children_[static_cast<std::size_t>(number)];
    child.line = ends[0];
    child.id = fork();
    if (child.id < 0) throw std::runtime_error("no process for a vehicle");
    if (child.id > 0) {
      close(ends[1]);
      return;
    }
    for (Child& other : children_) {
      if (other.line >= 0) close(other.line);
    }
    _exit(run(number, clock_offset, sockets, ends[1]));
  }
  /// A process of its own.
  int run(int number, std::int64_t clock_offset, const std::vector<LoopbackSocket>& sockets, int parent) const try {
    VehicleProcess process(world_, settings_, number, clock_offset, sockets);
    put(parent, &kReady, 1);
    std::int64_t start = 0;
    if (get(parent, &start, sizeof start) != sizeof start) return 1;
    process.fly(start, parent);
    const Bytes result = process.result();
    put(parent, result.data(), result.size());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tern: %s\n", error.what());
    return 1;
  }

  void expect(const Child& child, char word) {
    char got = 0;
    if (get(child.line, &got, 1) != 1 || got != word) throw std::runtime_error("a process of the swarm ended early");
  }
  void wait_for_arrivals(std::int64_t start) {
    const std::int64_t end = start + static_cast<std::int64_t>(1e9 * world_.time_limit);
    while (result_.arrived() < static_cast<int>(children_.size()) && clock_now() < end) {
      for (std::size_t k = 0; k < children_.size(); ++k) {
        SwarmMember& member = result_.members[k];
        if (member.arrived >= 0.0 || !has_news(children_[k].line)) continue;
        expect(children_[k], kArrived);
        member.arrived = seconds_of(clock_now() - start) - world_.tasks[k].depart;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    result_.time = seconds_of(clock_now() - start);
  }

  void take_result(std::size_t k) {
    Child& child = children_[k];
    Bytes bytes;
    Bytes part(65536);
    while (const std::size_t got = get(child.line, part.data(), part.size())) {
      bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(got));
    }
    // It may have arrived at the last moment.
    if (!bytes.empty() && bytes.front() == static_cast<std::uint8_t>(kArrived)) bytes.erase(bytes.begin());
    if (bytes.empty()) throw std::runtime_error("a process of the swarm ended early");
    const nlohmann::json all = nlohmann::json::from_cbor(bytes);
    all.at("positions").get_to(child.positions);
    SwarmMember& member = result_.members[k];
    member.commits = all.at("commits");
    member.unasked = all.at("unasked");
    if (member.arrived < 0.0) member.state = "did not arrive";
    result_.disagreed += all.at("disagreed").get<std::uint32_t>();
    result_.most_untold = std::max(result_.most_untold, all.at("untold").get<int>());
    result_.most_fleet_units = std::max(result_.most_fleet_units, all.at("fleet_units").get<std::uint32_t>());
    result_.computed += all.at("computed").get<double>();
    result_.packets += all.at("sent").get<std::uint64_t>();
    result_.lost += all.at("lost").get<std::uint64_t>();
    result_.bytes += all.at("bytes").get<std::uint64_t>();
    const auto& recorded = all.at("record").get_binary();
    append(read_swarm_record({recorded.begin(), recorded.end()}));
  }
  /// The record of one more vehicle, whose packets get new numbers.
  void append(SwarmRecord one) {
    const auto before = static_cast<std::uint32_t>(record_.packets.size());
    record_.packets.insert(record_.packets.end(), one.packets.begin(), one.packets.end());
    for (SwarmRecord::Tick& tick : one.vehicles.at(0).ticks) {
      for (std::uint32_t& number : tick.heard) number += before;
    }
    record_.vehicles.push_back(one.vehicles.at(0));
  }

  void watch() {
    SwarmWatch watch(
        static_cast<int>(children_.size()), world_.body_radius, 1.7320508 * world_.limits.v_max.x,
        [this](int k, std::int64_t t) { return children_[static_cast<std::size_t>(k)].at(t); },
        [this](const tern::Vec3& p) { return swarm_clearance(world_, p); });
    watch_intruders(world_, watch);
    const auto end = static_cast<std::int64_t>(1e9 * result_.time);
    for (std::int64_t t = 0; t < end; t += 10 * kSampleStep) watch.look(t, t + 10 * kSampleStep);
    take_findings(watch, result_);
    for (std::size_t k = 0; k < children_.size(); ++k) {
      const Child& child = children_[k];
      for (std::int64_t t = 1; t < end / kSampleStep; ++t) {
        result_.members[k].length += distance_between(child.at((t - 1) * kSampleStep), child.at(t * kSampleStep));
      }
    }
    const std::vector<ThingMotion> intruders = motions_of(world_.intruders);
    for (std::int64_t t = 0; t < end; t += static_cast<std::int64_t>(1e9 * result_.film_step)) {
      result_.intruder_film.push_back(places_of(intruders, t));
      result_.film.emplace_back();
      for (const Child& child : children_) {
        result_.film.back().emplace_back();
        result_.film.back().back().position = child.at(t);
      }
    }
  }

  const SwarmWorld& world_;
  const SwarmSettings& settings_;
  SwarmRecord& record_;
  std::vector<Child> children_;
  SwarmResult result_;
};

}  // namespace

SwarmResult fly_swarm_in_processes(const SwarmWorld& world, const SwarmSettings& settings, SwarmRecord& record) {
  return Processes(world, settings, record).fly();
}

}  // namespace tern_host
