// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hand-made log of a flight: 8 m along x between two trees, from rest to rest, and a commit that goes on along it.
#ifndef TERN_TESTS_VERIFY_STRAIGHT_FLIGHT_HPP
#define TERN_TESTS_VERIFY_STRAIGHT_FLIGHT_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "verify/flight.hpp"

namespace tern_verify {

using Json = nlohmann::json;

inline Json commit(double time) {
  Json points = Json::array();
  for (int i = 0; i < 8; ++i) points.push_back({i < 4 ? 0.0 : 8.0, 0.0, 0.0});
  return {{"time_ns", static_cast<long>(1e9 * time)},
          {"begin_ns", 0},
          {"evades", false},
          {"leaves", false},
          {"origin", {1.0, 3.0, 1.0}},
          {"segments", {{{"duration", 8.75}, {"relative_points", points}}}}};
}

/// From (1, 3, 1) to (9, 3, 1), four ticks a second.
inline Json track() {
  Json points = Json::array();
  for (int tick = 0; tick <= 35; ++tick) {
    const double u = tick / 35.0;
    points.push_back({1.0 + 8.0 * u * u * u * u * (35.0 - u * (84.0 - u * (70.0 - u * 20.0))), 3.0, 1.0});
  }
  Json track = {{"tick_ns", 250000000}, {"commanded", points}, {"believed", points}, {"true", points}};
  track["believed"][20][2] = 1.125;           // as far as the margin allows
  track["true"][18] = {5.0, 3.2421875, 1.0};  // 7.8125 mm off the tree
  return track;
}

inline Json log() {
  return {{"format", "tern-flight/1"},
          {"status", "reached"},
          {"world", "P25:7"},
          {"start", {1.0, 3.0, 1.0}},
          {"goal", {9.0, 3.0, 1.0}},
          {"mission", {{{"position", {9.0, 3.0, 1.0}}}}},
          {"settings",
           {{"body_radius", 0.25},
            {"tracking_margin", 0.125},
            {"pose_margin", 0.125},
            {"cell", 0.2},
            {"v_max", 2.0},
            {"a_max", 2.0},
            {"j_max", 0.0},
            {"thrust_max", 0.0},
            {"thrust_min", 0.0},
            {"tilt_tangent", 0.0},
            {"rate_max", 0.0},
            {"tick_hz", 4.0},
            {"tracking", "bounded"}}},
          {"time_s", 8.75},
          {"tracking_error", {{"max", 0.125}}},
          {"min_clearance", 0.2578125},
          {"plans", {{"committed", 2}}},
          {"true_world",
           {{"boundary", {0.0, 0.0, 0.0, 10.0, 6.0, 3.0}},
            {"blocks", {{4.0, 0.0, 0.0, 5.0, 2.0, 3.0}}},
            {"cylinders", {{5.0, 4.0, 0.0, 3.0, 0.5}}},
            {"fences", Json::array()}}},
          {"commits", {commit(0.0), commit(1.0)}},
          {"track", track()}};
}

inline Claims claims_of(const Json& json) {
  return prove(parse_flight(json.dump(), "log"));
}

inline Verdict verdict_of(const Claims& claims, const std::string& what) {
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const Claim& claim) { return claim.what == what; });
  EXPECT_NE(found, claims.end()) << what;
  return found == claims.end() ? Verdict::kOpen : found->verdict();
}

}  // namespace tern_verify

#endif
