// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/thing_record.hpp"

#include "host/number.hpp"
#include "host/things/thing_motion.hpp"
#include "host/track_record.hpp"
#include "host/word_queue.hpp"

namespace tern_host {
namespace {

Trefoil read_trefoil(WordQueue& queue) {
  Trefoil knot;
  knot.center = queue.vector("its centre");
  knot.scale = queue.vector("its scale");
  knot.slower = queue.above_zero("the seconds of a radian");
  knot.phase = queue.value("its phase");
  knot.ahead = queue.value("the time that it is ahead");
  return knot;
}

Walk read_walk(WordQueue& queue) {
  Walk walk;
  walk.speed = queue.above_zero("the speed of a walk");
  walk.acceleration = queue.above_zero("the acceleration of a walk");
  walk.ahead = queue.size("the time that a walk is ahead");
  walk.is_loop = queue.ahead() == "loop";
  if (walk.is_loop) queue.word("'loop'");
  while (!queue.empty() && queue.ahead() != "claims") {
    const tern::Vec3 place = queue.vector("a point of a walk");
    walk.points.push_back({place, queue.size("the wait at a point")});
  }
  const std::string fault = walk_fault(walk);
  if (!fault.empty()) queue.refuse(fault);
  return walk;
}

Hunt read_hunt(WordQueue& queue) {
  Hunt hunt;
  hunt.start = queue.vector("where it starts");
  hunt.speed = queue.above_zero("the speed of a hunter");
  hunt.acceleration = queue.above_zero("the acceleration of a hunter");
  hunt.sight = queue.size("how far a hunter sees");
  return hunt;
}

void read_motion(WordQueue& queue, Thing& thing) {
  const std::string motion = queue.word("how it moves");
  if (motion == "trefoil") {
    thing.motion = read_trefoil(queue);
  } else if (motion == "walk") {
    thing.motion = read_walk(queue);
  } else if (motion == "hunt") {
    thing.motion = read_hunt(queue);
  } else {
    queue.refuse("a thing moves on a 'trefoil' or a 'walk', or it is on the 'hunt', found " + quote(motion));
  }
}

std::string text(double value) {
  return " " + shortest(value);
}

std::string text(const tern::Vec3& v) {
  return text(v.x) + text(v.y) + text(v.z);
}

std::string text(const Trefoil& knot) {
  return " trefoil" + text(knot.center) + text(knot.scale) + text(knot.slower) + text(knot.phase) + text(knot.ahead);
}

std::string text(const Walk& walk) {
  std::string all = " walk" + text(walk.speed) + text(walk.acceleration) + text(walk.ahead);
  if (walk.is_loop) all += " loop";
  for (const WalkPoint& point : walk.points) all += text(point.place) + text(point.wait);
  return all;
}

std::string text(const Hunt& hunt) {
  return " hunt" + text(hunt.start) + text(hunt.speed) + text(hunt.acceleration) + text(hunt.sight);
}

std::string shape_text(const Thing& thing) {
  if (thing.shape == tern::TrackShape::kBall) return " ball" + text(thing.radius);
  if (thing.shape == tern::TrackShape::kBox) return " box" + text(thing.half);
  return " cylinder" + text(thing.radius) + text(2.0 * thing.half.z);
}

}  // namespace

Thing read_thing(const Words& words, const Place& place) {
  WordQueue queue(words, place);
  Thing thing;
  thing.name = queue.word("its name");
  tern::Track shape;
  read_shape(queue, shape);
  thing.shape = shape.shape;
  thing.radius = shape.radius;
  thing.half = shape.half;
  read_motion(queue, thing);
  if (queue.empty()) return thing;
  const std::string word = queue.word("'claims'");
  if (word != "claims") queue.refuse("after its motion, a thing may have 'claims', found " + quote(word));
  thing.claimed.speed = queue.above_zero("the speed that it claims");
  thing.claimed.acceleration = queue.size("the acceleration that it claims");
  if (!queue.empty()) queue.refuse("a thing ends with what it claims, found " + quote(queue.ahead()));
  return thing;
}

std::string thing_line(const Thing& thing) {
  std::string line = "thing " + thing.name + shape_text(thing);
  line += std::visit([](const auto& motion) { return text(motion); }, thing.motion);
  if (thing.claimed.speed > 0.0) line += " claims" + text(thing.claimed.speed) + text(thing.claimed.acceleration);
  return line + "\n";
}

}  // namespace tern_host
