// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/vehicle_process.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

namespace tern_host {

std::int64_t clock_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void put(int descriptor, const void* bytes, std::size_t size) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t put = ::send(descriptor, static_cast<const char*>(bytes) + done, size - done, MSG_NOSIGNAL);
    if (put < 0 && errno != EINTR) throw std::runtime_error("a process of the swarm is gone");
    if (put > 0) done += static_cast<std::size_t>(put);
  }
}

/// Up to `size` bytes; fewer at the end.
std::size_t get(int descriptor, void* bytes, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = read(descriptor, static_cast<char*>(bytes) + done, size - done);
    if (got == 0 || (got < 0 && errno != EINTR)) break;
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  return done;
}

bool has_news(int descriptor) {
  pollfd one{descriptor, POLLIN, 0};
  return poll(&one, 1, 0) > 0;
}

VehicleProcess::VehicleProcess(const SwarmWorld& world, const SwarmSettings& settings, int number,
                               std::int64_t clock_offset, const std::vector<LoopbackSocket>& sockets)
    : settings_(settings),
      number_(number),
      vehicle_(world, settings, number, clock_offset),
      sockets_(settings.links, sockets, settings.seed + static_cast<std::uint64_t>(number)),
      carrier_(sockets_, record_) {
  record_.vehicles.resize(static_cast<std::size_t>(number) + 1);
  record_.vehicles.back().clock_offset = clock_offset;
}

void VehicleProcess::fly(std::int64_t start, int parent) {
  const auto step = static_cast<std::int64_t>(1e9 / settings_.tick_hz);
  for (std::int64_t due = 0; !has_news(parent);) {
    std::this_thread::sleep_for(std::chrono::nanoseconds(start + due - clock_now()));
    const std::int64_t now = clock_now() - start;
    keep_positions(now);
    const SwarmTick did = vehicle_.tick(now, carrier_);
    carrier_.end_tick(number_, vehicle_.at(now).position);
    note(did);
    if (!has_arrived_ && vehicle_.has_arrived()) {
      has_arrived_ = true;
      put(parent, &kArrived, 1);
    }
    due = std::max(due + step, now);
  }
  computed_ = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<std::uint8_t> VehicleProcess::result() const {
  SwarmRecord record = record_;
  record.vehicles = {record_.vehicles.back()};
  const std::string recorded = write_swarm_record(record);
  return nlohmann::json::to_cbor({{"record", nlohmann::json::binary({recorded.begin(), recorded.end()})},
                                  {"positions", positions_},
                                  {"commits", commits_},
                                  {"unasked", unasked_},
                                  {"disagreed", disagreed_},
                                  {"untold", untold_},
                                  {"fleet_units", fleet_units_},
                                  {"computed", computed_},
                                  {"sent", sockets_.air().sent()},
                                  {"lost", sockets_.air().lost()},
                                  {"bytes", sockets_.air().bytes()}});
}

/// Where it was up to now: ticks do not change what is over.
void VehicleProcess::keep_positions(std::int64_t now) {
  for (; sampled_ < now; sampled_ += kSampleStep) {
    const tern::Vec3 place = vehicle_.at(sampled_).position;
    positions_.insert(positions_.end(), {place.x, place.y, place.z});
  }
}

void VehicleProcess::note(const SwarmTick& did) {
  commits_ += did.committed ? 1 : 0;
  unasked_ += did.unasked ? 1 : 0;
  disagreed_ += did.agrees ? 0 : 1;
  untold_ = std::max(untold_, did.untold);
  fleet_units_ = std::max(fleet_units_, did.fleet_units);
}

}  // namespace tern_host
