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
  if (!world.intruders.empty()) {
    add("intruders", std::to_string(world.intruders.size()) + "; touched " +
                         std::to_string(result.touched_at_rest.size()) + " times a vehicle at rest");
  }
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

/// What moves, from a film with a row for each step; `place` gives it in a row.
template <typename Film, typename Place>
RunJson ball_json(const std::string& name, double radius, const Film& film, double step, Place place) {
  RunJson rows = RunJson::array();
  for (const auto& row : film) {
    RunJson shown = RunJson::array();
    append_point(shown, place(row));
    shown.push_back(0);
    rows.push_back(shown);
  }
  return thing_json({name, false, tern::TrackShape::kBall, radius, tern::Vec3{}, step, rows});
}

RunJson others_of(const SwarmWorld& world, const SwarmResult& result) {
  RunJson list = RunJson::array();
  for (std::size_t k = 1; k < result.members.size(); ++k) {
    list.push_back(ball_json("vehicle " + std::to_string(k), world.body_radius, result.film, result.film_step,
                             [k](const auto& row) { return row[k].position; }));
  }
  for (std::size_t k = 0; k < world.intruders.size(); ++k) {
    list.push_back(ball_json(world.intruders[k].name, world.intruders[k].radius, result.intruder_film, result.film_step,
                             [k](const auto& row) { return row[k]; }));
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
