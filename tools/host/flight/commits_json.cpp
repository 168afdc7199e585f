// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/commits_json.hpp"

#include <cmath>

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;

Json json(const tern::Vec3& v) {
  return {v.x, v.y, v.z};
}

Json json(const tern::Box& box) {
  return {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z};
}

Json segments_json(const tern::Trajectory& plan) {
  Json segments = Json::array();
  for (int s = 0; s < plan.count; ++s) {
    Json points = Json::array();
    for (const tern::Vec3& point : plan.segments[s].points) points.push_back(json(point));
    segments.push_back({{"duration", plan.segments[s].duration}, {"relative_points", points}});
  }
  return segments;
}

}  // namespace

Json commits_json(const FlightResult& result) {
  Json commits = Json::array();
  for (const FlightCommit& commit : result.commits) {
    commits.push_back({{"time_ns", commit.time}, {"begin_ns", commit.begin}});
    if (commit.withdrawn != kNotWithdrawn) commits.back()["withdrawn_ns"] = commit.withdrawn;
    commits.back().update({{"evades", commit.evades},
                           {"leaves", commit.leaves},
                           {"origin", json(commit.flown.origin)},
                           {"segments", segments_json(commit.flown)}});
  }
  return commits;
}

Json track_json(const FlightWorld& world, const FlightResult& result) {
  Json commanded = Json::array(), believed = Json::array(), real = Json::array();
  for (const TrackPoint& point : result.track) {
    commanded.push_back(json(point.commanded));
    believed.push_back(json(point.believed));
    real.push_back(json(point.position));
  }
  return {{"tick_ns", std::llround(1e9 / world.settings.tick_hz)},
          {"commanded", commanded},
          {"believed", believed},
          {"true", real}};
}

Json true_world_json(const FlightWorld& world) {
  Json blocks = Json::array();
  for (const tern::Box& block : world.blocks) blocks.push_back(json(block));
  Json cylinders = Json::array();
  for (const Cylinder& c : world.cylinders) cylinders.push_back({c.x, c.y, c.bottom, c.top, c.radius});
  Json fences = Json::array();
  for (const FenceRecord& fence : world.fences) fences.push_back(fence_json(fence));
  return {{"boundary", json(world.boundary)}, {"blocks", blocks}, {"cylinders", cylinders}, {"fences", fences}};
}

}  // namespace tern_host
