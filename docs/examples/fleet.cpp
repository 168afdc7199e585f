// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/fleet.md: two vehicles cross each other's way, over links that lose every third packet.
#include <cmath>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

static constexpr std::int64_t kTick = 100000000;
static constexpr std::int32_t kPacket = 128;

/// A link that loses every third packet. Yours is a radio.
struct Link {
  std::int32_t receive(std::uint8_t* packet) {
    if (air.empty()) return 0;
    const std::vector<std::uint8_t> next = air.front();
    air.pop_front();
    for (std::size_t k = 0; k < next.size(); ++k) packet[k] = next[k];
    return static_cast<std::int32_t>(next.size());
  }
  void send(const std::uint8_t* packet, std::int32_t size) {
    if (++sent % 3 != 0) other->air.emplace_back(packet, packet + size);
  }
  std::deque<std::vector<std::uint8_t>> air;
  Link* other = nullptr;
  int sent = 0;
};

/// What each vehicle does in every tick.
static void exchange(tern::Fleet& fleet, Link& link, std::int64_t now) {
  std::uint8_t packet[kPacket];
  for (std::int32_t size; (size = link.receive(packet)) > 0;) fleet.receive(packet, size, now);
  tern::Work work(500);
  fleet.advance(now, work);  // decides about the plan that is announced, and goes on with proofs
  for (std::int32_t size; (size = fleet.write(packet, kPacket)) > 0;) link.send(packet, size);
}

/// Plans from where the vehicle will be in half a second, among what the others fly, and announces that.
static bool plan_on(const tern::Grid& grid, tern::Planner& planner, tern::Fleet& fleet, tern::Request request,
                    std::int64_t now) {
  static tern::Track tracks[tern::kMaxTracks];
  static tern::TrackPiece pieces[tern::kMaxTrackPieces];
  static tern::Trajectory plan;
  static tern::Report report;
  request.begin = now + 5 * kTick;
  const tern::Trajectory& flown = *fleet.flown();
  const tern::Sample at = tern::evaluate(flown, tern::time_on(flown, request.begin));
  request.start = {at.position, at.velocity, at.acceleration, at.jerk};
  request.tracks = tracks;
  fleet.traffic(now, tracks, tern::kMaxTracks, pieces, tern::kMaxTrackPieces, request.track_count);
  if (planner.plan(grid, request, plan, report) != tern::Status::kOk) return false;
  return fleet.announce(plan, request.begin, now) == tern::Status::kOk;
}

int main() {
  tern::GridSpec spec{};
  spec.cell = 0.25;
  spec.dims = {48, 40, 16};
  spec.boundary = {{0.0, 0.0, 0.0}, {12.0, 10.0, 4.0}};
  spec.radius = 0.3;
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 1;
  grid.inflate();
  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  tern::Request request;
  request.limits = {{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}};

  const tern::Vec3 places[2] = {{1.0, 5.0, 2.0}, {6.0, 1.0, 2.0}};
  const tern::Vec3 goals[2] = {{11.0, 5.0, 2.0}, {6.0, 9.0, 2.0}};
  std::unique_ptr<tern::Fleet> fleets[2] = {std::make_unique<tern::Fleet>(), std::make_unique<tern::Fleet>()};
  Link links[2];
  for (int v = 0; v < 2; ++v) {
    links[v].other = &links[1 - v];
    tern::FleetSpec member;
    member.id = static_cast<std::uint16_t>(v + 1);
    member.incarnation = 1;  // yours rises with every start
    member.radius = 0.3;
    member.clock_error = 5000000;
    member.tick = kTick;
    member.speed = 3.5;
    tern::Trajectory rest{};
    rest.count = 1;
    rest.origin = places[v];
    rest.segments[0].duration = 1.0;
    if (fleets[v]->begin(member, rest, 0) != tern::Status::kOk) return 1;
    fleets[v]->add(static_cast<std::uint16_t>(2 - v), 0);
  }
  int there = 0;
  for (std::int64_t now = 0; now < 300 * kTick && there < 2; now += kTick) {
    there = 0;
    for (int v = 0; v < 2; ++v) {
      exchange(*fleets[v], links[v], now);
      const tern::Trajectory& flown = *fleets[v]->flown();
      const tern::Vec3 end = tern::evaluate(flown, 1e9).position;
      const bool arrives = std::fabs(end.x - goals[v].x) + std::fabs(end.y - goals[v].y) < 1e-6;
      if (arrives && tern::time_on(flown, now) > tern::duration(flown)) ++there;
      request.goal.position = goals[v];
      if (!arrives && fleets[v]->announced() == nullptr) plan_on(grid, planner, *fleets[v], request, now);
    }
  }
  return there == 2 ? 0 : 1;
}
