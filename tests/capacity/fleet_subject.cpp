// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "capacity/subject.hpp"
#include "support/yaw_case.hpp"
#include "tern/fleet.hpp"

namespace tern_capacity {
namespace {

using tern::Status;

/// A member hears of another one, or misses what it says, and knows of its plan, or of none.
class FleetSubject : public Subject {
 public:
  Outcome run() override {
    tern::FleetSpec spec;
    spec.radius = 0.5;
    spec.tick = 1;
    tern::Fleet fleets[2];
    for (int v = 0; v < 2; ++v) {
      spec.id = static_cast<std::uint16_t>(v);
      spec.incarnation = 1;
      fleets[v].begin(spec, tern_test::hover(1.0), 0);
      const Status added = fleets[v].add(static_cast<std::uint16_t>(1 - v), 0);
      if (added != Status::kOk) return {added, "", fleets[v].neighbours() == 0 ? "" : "added though refused"};
    }
    std::uint8_t packet[512];
    while (const std::int32_t size = fleets[0].write(packet, 512)) fleets[1].receive(packet, size, 0);
    tern::Track tracks[2];
    tern::TrackPiece pieces[tern::kMaxSegments + 1];
    std::int32_t count = 0;
    const Status status = fleets[1].traffic(0, tracks, 2, pieces, tern::kMaxSegments + 1, count);
    const bool knows = fleets[1].neighbour(0).incarnation == 1;
    return {status, std::to_string(count), count == 0 || knows ? "" : "a plan of nobody"};
  }
};

}  // namespace

std::unique_ptr<Subject> fleet_subject() {
  return std::make_unique<FleetSubject>();
}

}  // namespace tern_capacity
