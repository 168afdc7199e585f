// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs against tracks, in a call each.
#ifndef TERN_TESTS_PROVE_TRACK_ANSWERS_HPP
#define TERN_TESTS_PROVE_TRACK_ANSWERS_HPP

#include <gtest/gtest.h>

#include <vector>

#include "support/timed_proof.hpp"
#include "tern/track_proof.hpp"

namespace tern_test {

inline tern::Track ball_at(const tern::Vec3& place, double radius) {
  tern::Track track;
  track.position = place;
  track.radius = radius;
  return track;
}

inline TimedAnswer prove(const tern::Trajectory& plan, const std::vector<tern::Track>& tracks, double radius = 0.5,
                         double rest = 0.0, bool leaves = false, double from = 0.0) {
  tern::TrackGrounds grounds;
  grounds.tracks = tracks.data();
  grounds.count = static_cast<std::int32_t>(tracks.size());
  grounds.radius = radius;
  grounds.rest = rest;
  grounds.leaves = leaves;
  return prove_from(from, plan, grounds);
}

inline tern::Status refused(const tern::Track& track, std::int32_t& which) {
  const tern::Track list[] = {tern::Track{}, track};
  tern::TrackGrounds grounds;
  grounds.tracks = list;
  grounds.count = 2;
  const tern::Trajectory plan = along_x({9.0, 9.0, 9.0});
  tern::TrackProof proof;
  const tern::Status status = proof.begin(plan, 0.0, grounds);
  which = proof.report().track;
  return status;
}

}  // namespace tern_test

#endif
