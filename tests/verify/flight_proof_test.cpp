// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The curves of a hand-made flight, and what its vehicle did, spoiled by as little as a proof can tell.
#include <array>
#include <cmath>

#include "straight_flight.hpp"

namespace tern_verify {
namespace {

TEST(FlightProof, ACommitThatTouchesItsMarginsIsProven) {
  const Claims claims = claims_of(log());
  for (const Claim& claim : claims) EXPECT_EQ(claim.verdict(), Verdict::kProven) << line_of(claim);
  EXPECT_EQ(verdict_of(claims, "curve off the world"), Verdict::kProven);
}

TEST(FlightProof, TenNanometresTooNearToATree) {
  Json json = log();
  json["true_world"]["cylinders"][0][4] = 0.50000001;
  json["min_clearance"] = 0.25781249;
  EXPECT_EQ(verdict_of(claims_of(json), "curve off the world"), Verdict::kRefuted);
  // The world stands still: what raised a threat, or hemmed the vehicle in, is not there. So no commit may come near.
  for (Json& commit : json["commits"]) commit["evades"] = commit["leaves"] = true;
  EXPECT_EQ(verdict_of(claims_of(json), "curve off the world"), Verdict::kRefuted);
}

TEST(FlightProof, WallsCount) {
  Json json = log();
  json["true_world"]["boundary"] = {0.0, 0.0, 0.50000001, 10.0, 6.0, 3.0};
  EXPECT_EQ(verdict_of(claims_of(json), "curve off the world"), Verdict::kRefuted);
}

TEST(FlightProof, APlanThatGoesOnElsewhere) {
  Json json = log();
  json["commits"][1]["begin_ns"] = 1;  // of its points, all are a nanosecond late
  EXPECT_EQ(verdict_of(claims_of(json), "takeover velocity"), Verdict::kRefuted);
}

/// Six half-spaces of a box.
Json fence(const char* kind, const std::array<double, 3>& low, const std::array<double, 3>& high) {
  Json planes = Json::array();
  for (std::size_t a = 0; a < 3; ++a) {
    std::array<double, 4> plane{0.0, 0.0, 0.0, high[a]};
    plane[a] = 1.0;
    planes.push_back(plane);
    plane[a] = -2.0;  // of any length
    plane[3] = -2.0 * low[a];
    planes.push_back(plane);
  }
  return {{"kind", kind}, {"half_spaces", planes}};
}

Claim fence_claim(const Json& fence) {
  Json json = log();
  json["true_world"]["fences"] = {fence};
  const Claims claims = claims_of(json);
  const auto found = std::find_if(claims.begin(), claims.end(), [](const Claim& c) { return c.what == "fence 1"; });
  EXPECT_NE(found, claims.end());
  return found == claims.end() ? Claim{} : *found;
}

// The flight goes from (1, 3, 1) to (9, 3, 1), and keeps 0.5 m from keep-outs.
TEST(FlightProof, KeepInsHoldTheCentre) {
  const Claim touching = fence_claim(fence("keep_in", {1.0, 0.0, 0.0}, {9.0, 6.0, 3.0}));
  EXPECT_EQ(touching.verdict(), Verdict::kProven) << line_of(touching);
  EXPECT_EQ(touching.most, 0);
  const Claim left = fence_claim(fence("keep_in", {0.0, 0.0, 0.0}, {8.99999999, 6.0, 3.0}));
  EXPECT_EQ(left.verdict(), Verdict::kRefuted) << line_of(left);
}

TEST(FlightProof, KeepOutsAreLeftAloneByTheRadius) {
  const Claim face = fence_claim(fence("keep_out", {4.0, 3.5, 0.0}, {5.0, 6.0, 3.0}));
  EXPECT_EQ(face.verdict(), Verdict::kProven) << line_of(face);
  EXPECT_EQ(face.most, 0);
  const Claim nearer = fence_claim(fence("keep_out", {4.0, 3.49999999, 0.0}, {5.0, 6.0, 3.0}));
  EXPECT_EQ(nearer.verdict(), Verdict::kRefuted) << line_of(nearer);
  const Claim entered = fence_claim(fence("keep_out", {4.0, 0.0, 0.0}, {5.0, 6.0, 3.0}));
  EXPECT_EQ(entered.verdict(), Verdict::kRefuted) << line_of(entered);
}

TEST(FlightProof, KeepOutsHaveEdgesAndCorners) {
  // An edge 0.3 m above and 0.4 m beside the way, and a corner in front of its end.
  const Claim edge = fence_claim(fence("keep_out", {4.0, 3.4, 1.3000001}, {5.0, 6.0, 3.0}));
  EXPECT_EQ(edge.verdict(), Verdict::kProven) << line_of(edge);
  EXPECT_LT(edge.most, decimal(1, 6));
  const Claim nearer = fence_claim(fence("keep_out", {4.0, 3.4, 1.2999999}, {5.0, 6.0, 3.0}));
  EXPECT_EQ(nearer.verdict(), Verdict::kRefuted) << line_of(nearer);
  const Claim corner = fence_claim(fence("keep_out", {9.3, 3.3, 1.3}, {9.6, 6.0, 3.0}));
  EXPECT_EQ(corner.verdict(), Verdict::kProven) << line_of(corner);
  EXPECT_LT(corner.most, Rational(2) / 100);
}

TEST(FlightProof, ALogWithoutFencesIsRefused) {
  Json json = log();
  json["true_world"].erase("fences");
  EXPECT_THROW(claims_of(json), InputError);
}

TEST(FlightProof, AVehicleThatLeavesItsMargin) {
  Json json = log();
  json["track"]["believed"][20][2] = 1.12500001;
  json["tracking_error"]["max"] = 0.12500001;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: tracking error"), Verdict::kRefuted);
}

TEST(FlightProof, ABodyThatTouchesATree) {
  Json json = log();
  json["track"]["true"][18][1] = 3.25000001;
  json["min_clearance"] = 0.24999999;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: body off the world"), Verdict::kRefuted);
}

TEST(FlightProof, AFlightThatCommittedNothingProvesNothing) {
  Json json = log();
  json["commits"] = Json::array();
  json["plans"]["committed"] = 0;
  EXPECT_EQ(verdict_of(claims_of(json)), Verdict::kOpen);
}

/// The vehicle is near the gate from 3 to 5.5 s or so, and beyond it at 8 s.
TEST(FlightProof, FencesForAWhileCountWhileTheyHold) {
  struct Case {
    double from;
    double until;
    double clock_error;
    Verdict verdict;
  };
  for (const Case& c : {Case{-5.0, 2.0, 0.0, Verdict::kProven}, Case{4.0, 5.0, 0.0, Verdict::kRefuted},
                        Case{8.0, 9.0, 0.0, Verdict::kProven}, Case{8.0, 9.0, 4.0, Verdict::kRefuted}}) {
    Json json = log();
    Json gate = fence("keep_out", {4.0, 0.0, 0.0}, {5.0, 6.0, 3.0});
    gate["from_ns"] = std::llround(1e9 * c.from);
    gate["until_ns"] = std::llround(1e9 * c.until);
    gate["clock_error_s"] = c.clock_error;
    json["true_world"]["fences"] = {gate};
    EXPECT_EQ(verdict_of(claims_of(json), "fence 1 for a while"), c.verdict) << c.from << " " << c.clock_error;
  }
}

TEST(FlightProof, ACommitThatDoesNotEndAtRest) {
  Json json = log();
  json["commits"][1]["segments"][0]["relative_points"][6][0] = 7.999;
  EXPECT_EQ(verdict_of(claims_of(json), "rest velocity"), Verdict::kRefuted);
}

}  // namespace
}  // namespace tern_verify
