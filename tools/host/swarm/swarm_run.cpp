// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_run.hpp"

#include <algorithm>
#include <array>

#include "host/number.hpp"
#include "host/page/run_json.hpp"

namespace tern_host {
namespace {

RunJson facts_of(const SwarmWorld& world, const SwarmSettings& settings, const SwarmResult& result) {
  RunJson facts = RunJson::array();
  const auto add = [&](const char* label, const std::string& text) { facts.push_back({label, text}); };
  add("status", std::to_string(result.arrived()) + " of " + std::to_string(result.members.size()) + " arrived");
  add("contacts", std::to_string(result.contacts.size()));
  add("duration", fixed(result.time, 2) + " s");
  add("travel", fixed(result.mean_travel(), 2) + " s in the mean");
  add("least distance",
      fixed(result.least_distance, 3) + " m; bodies touch at " + fixed(2.0 * world.body_radius, 2) + " m");
  add("links", fixed(100.0 * settings.links.loss, 0) + " % lost, delay up to " + fixed(settings.links.delay_max, 2) +
                   " s; " + std::to_string(result.lost) + " of " + std::to_string(result.packets) + " packets lost");
  return facts;
}

/// The first vehicle, with its nose along x.
RunJson motion_of(const SwarmWorld& world, const SwarmResult& result) {
  MotionColumns motion;
  for (const std::vector<tern::Sample>& row : result.film) {
    const tern::FlatState flat = tern::flat_state(row.front(), tern::Yaw{1.0, 0.0, 0.0});
    const double(&q)[4] = flat.quaternion;
    motion.add(row.front(), {q[0], q[1], q[2], q[3]}, swarm_clearance(world, row.front().position));
  }
  return motion.json(result.film_step);
}

RunJson others_of(const SwarmWorld& world, const SwarmResult& result) {
  RunJson list = RunJson::array();
  for (std::size_t k = 1; k < result.members.size(); ++k) {
    RunJson rows = RunJson::array();
    for (const std::vector<tern::Sample>& row : result.film) {
      RunJson place = RunJson::array();
      append_point(place, row[k].position);
      place.push_back(0);
      rows.push_back(place);
    }
    list.push_back(thing_json({"vehicle " + std::to_string(k), false, tern::TrackShape::kBall, world.body_radius,
                               tern::Vec3{}, result.film_step, rows}));
  }
  return list;
}

}  // namespace

std::string swarm_run(const SwarmWorld& world, const SwarmSettings& settings, const SwarmResult& result) {
  const RunJson nothing = RunJson::array();
  RunJson boxes = RunJson::array();
  for (const tern::Box& box : world.blocks) {
    append_point(boxes, box.lower);
    append_point(boxes, box.upper);
  }
  const tern::Limits& limits = world.limits;
  const RunJson run = {{"kind", "swarm"},
                       {"name", world.name},
                       {"facts", facts_of(world, settings, result)},
                       {"boundary", rounded(world.boundary)},
                       {"radius", world.body_radius},
                       {"boxes", boxes},
                       {"keepout", nothing},
                       {"cylinders", nothing},
                       {"fences", nothing},
                       {"start", rounded(world.tasks.front().start)},
                       {"goal", rounded(world.tasks.front().mission.back().position)},
                       {"vias", nothing},
                       {"things", others_of(world, result)},
                       {"blocked", nullptr},
                       {"limits", {{"v", limits.v_max.x}, {"a", limits.a_max.x}, {"j", limits.j_max.x}}},
                       {"motion", motion_of(world, result)}};
  return run.dump();
}

}  // namespace tern_host
