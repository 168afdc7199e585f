// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/thing_record.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/flight/flight_world.hpp"
#include "host/flight/world_family.hpp"
#include "host/things/surface_distance.hpp"
#include "support/random.hpp"
#include "support/world_refusal.hpp"

namespace {

using tern_host::Thing;

Thing thing_of(const std::string& line) {
  return tern_host::read_thing(tern_host::split_words(line, false), {"world.txt", 1});
}

std::string thing_refusal(const std::string& line) {
  try {
    thing_of(line);
  } catch (const tern_host::RecordError& error) {
    return error.reason();
  }
  return "";
}

TEST(ThingRecord, ReadsShapesAndMotions) {
  const Thing cube = thing_of("thing cube box 1 2 3 trefoil 4 5 6 7 8 9 10 11 12");
  EXPECT_EQ(cube.name, "cube");
  EXPECT_EQ(cube.shape, tern::TrackShape::kBox);
  EXPECT_EQ(cube.half.z, 3.0);
  const auto& knot = std::get<tern_host::Trefoil>(cube.motion);
  EXPECT_EQ(knot.center.y, 5.0);
  EXPECT_EQ(knot.scale.z, 9.0);
  EXPECT_EQ(knot.slower, 10.0);
  EXPECT_EQ(knot.phase, 11.0);
  EXPECT_EQ(knot.ahead, 12.0);
  const Thing person = thing_of("thing p cylinder 0.3 1.8 walk 1.5 3 2 loop 0 0 0.9 4 5 0 0.9 0 claims 2 5");
  EXPECT_EQ(person.half.z, 0.9);
  const auto& walk = std::get<tern_host::Walk>(person.motion);
  EXPECT_TRUE(walk.is_loop);
  EXPECT_EQ(walk.ahead, 2.0);
  ASSERT_EQ(walk.points.size(), 2u);
  EXPECT_EQ(walk.points[0].wait, 4.0);
  EXPECT_EQ(walk.points[1].place.x, 5.0);
  EXPECT_EQ(person.claimed.speed, 2.0);
  EXPECT_EQ(person.claimed.acceleration, 5.0);
  const auto hunt = std::get<tern_host::Hunt>(thing_of("thing h ball 0.2 hunt 1 2 3 4 5 6").motion);
  EXPECT_EQ(hunt.start.z, 3.0);
  EXPECT_EQ(hunt.speed, 4.0);
  EXPECT_EQ(hunt.acceleration, 5.0);
  EXPECT_EQ(hunt.sight, 6.0);
}

TEST(ThingRecord, SaysWhatIsWrong) {
  EXPECT_EQ(thing_refusal("thing a cone 1 hunt 1 2 3 4 5 6"),
            "a thing is a 'ball', a 'cylinder' or a 'box', found 'cone'");
  EXPECT_EQ(thing_refusal("thing a ball 1 fly 1 2 3"),
            "a thing moves on a 'trefoil' or a 'walk', or it is on the 'hunt', found 'fly'");
  EXPECT_EQ(thing_refusal("thing a ball 1 hunt 1 2 3"), "'thing' ends where the speed of a hunter is missing");
  EXPECT_EQ(thing_refusal("thing a ball 1 hunt 1 2 3 0 5 6"), "the speed of a hunter must be more than 0");
  EXPECT_EQ(thing_refusal("thing a ball 1 hunt 1 2 3 4 5 6 7"),
            "after its motion, a thing may have 'claims', found '7'");
  EXPECT_EQ(thing_refusal("thing a ball 1 walk 1 1 0"), "a walk needs a point");
  EXPECT_NE(thing_refusal("thing a ball 1 walk 1 1 0 0 0 0 0 0.5 0 0 0").find("too short"), std::string::npos);
}

// Every line of a family's world that begins with `thing` is written as it was read.
TEST(ThingRecord, RoundTripsBitByBit) {
  for (const std::string& family : tern_host::family_names()) {
    for (int seed = 1; seed <= tern_test::scaled(20); ++seed) {
      tern_host::FamilyMember member;
      ASSERT_TRUE(tern_host::parse_member(family + ":" + std::to_string(seed), member));
      tern_host::for_each_record(tern_host::world_text(member), family, [](const auto& words, const auto& place) {
        if (words[0] != "thing") return;
        std::string line = words[0];
        for (std::size_t k = 1; k < words.size(); ++k) line += " " + words[k];
        EXPECT_EQ(tern_host::thing_line(tern_host::read_thing(words, place)), line + "\n");
      });
    }
  }
}

TEST(ThingRecord, ThingsCanBeLeftOut) {
  EXPECT_EQ(tern_host::read_flight_world("T4:0", {}).things.size(), 20u);
  EXPECT_TRUE(tern_host::read_flight_world("T4:0", {"things=0"}).things.empty());
}

TEST(ThingRecord, SurfacesAreSignedDistances) {
  const auto distance = [](const char* shape, const tern::Vec3& point) {
    const Thing thing = thing_of(std::string("thing a ") + shape + " hunt 0 0 0 1 1 1");
    return tern_host::surface_distance(thing, {1.0, 2.0, 3.0}, {1.0 + point.x, 2.0 + point.y, 3.0 + point.z});
  };
  EXPECT_DOUBLE_EQ(distance("ball 0.5", {3.0, 0.0, 4.0}), 4.5);
  EXPECT_DOUBLE_EQ(distance("ball 0.5", {0.0, 0.2, 0.0}), -0.3);
  EXPECT_DOUBLE_EQ(distance("cylinder 1 4", {0.0, 3.0, 1.0}), 2.0);
  EXPECT_DOUBLE_EQ(distance("cylinder 1 4", {4.0, 0.0, 6.0}), 5.0);
  EXPECT_DOUBLE_EQ(distance("cylinder 1 4", {0.5, 0.0, 1.75}), -0.25);
  EXPECT_DOUBLE_EQ(distance("box 1 2 3", {4.0, 6.0, 3.0}), 5.0);
  EXPECT_DOUBLE_EQ(distance("box 1 2 3", {2.0, 4.0, 5.0}), 3.0);
  EXPECT_DOUBLE_EQ(distance("box 1 2 3", {0.25, -1.5, 0.0}), -0.5);
}

}  // namespace
