// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "timing/hard_world.hpp"

#include <initializer_list>

namespace tern_timing {
namespace {

constexpr double kNever = 1e9;

/// Where the ray is within [low, high] on one axis.
void cut(double from, double along, double low, double high, double& enter, double& leave) {
  if (!(along < 0.0) && !(along > 0.0)) {
    if (from < low || from > high) leave = -1.0;
    return;
  }
  const double a = (low - from) / along;
  const double b = (high - from) / along;
  const double first = a < b ? a : b;
  const double last = a < b ? b : a;
  if (first > enter) enter = first;
  if (last < leave) leave = last;
}

double meet_pillar(const Ray& ray, const Thing& pillar) {
  const double x = ray.x - pillar.x0;
  const double y = ray.y - pillar.y0;
  const double a = ray.dx * ray.dx + ray.dy * ray.dy;
  const double b = x * ray.dx + y * ray.dy;
  const double c = x * x + y * y - pillar.radius * pillar.radius;
  const double root = b * b - a * c;
  if (!(root > 0.0) || !(b < 0.0)) return kNever;
  return (-b - __builtin_sqrt(root)) / a;
}

double clamped(double x, double low, double high) {
  return x < low ? low : (x > high ? high : x);
}

}  // namespace

double HardWorld::meet(const Ray& ray, const Thing& thing) {
  if (thing.radius > 0.0) return meet_pillar(ray, thing);
  double enter = 0.0;
  double leave = kFar;
  cut(ray.x, ray.dx, thing.x0, thing.x1, enter, leave);
  cut(ray.y, ray.dy, thing.y0, thing.y1, enter, leave);
  return enter > 0.0 && enter < leave ? enter : kNever;
}

/// Low things count only in front of the nearest high one.
HardWorld::Column HardWorld::look(const Ray& ray) const {
  Column column;
  for (int k = 0; k < count_; ++k) {
    const double at = meet(ray, things_[k]);
    if (!(at < kFar)) continue;
    int place = column.count < kMostHits ? column.count : kMostHits - 1;
    if (column.count == kMostHits && at >= column.at[place]) continue;
    for (; place > 0 && at < column.at[place - 1]; --place) {
      column.at[place] = column.at[place - 1];
      column.top[place] = column.top[place - 1];
    }
    column.at[place] = at;
    column.top[place] = things_[k].top;
    if (column.count < kMostHits) ++column.count;
  }
  return column;
}

double HardWorld::Column::depth(double eye, double slope) const {
  double nearest = kFar;
  if (slope < 0.0 && -eye / slope < nearest) nearest = -eye / slope;
  if (slope > 0.0 && (kCeiling - eye) / slope < nearest) nearest = (kCeiling - eye) / slope;
  for (int k = 0; k < count && at[k] < nearest; ++k) {
    if (eye + slope * at[k] <= top[k]) return at[k];
  }
  return nearest;
}

bool HardWorld::empty_around(double x, double y, double reach) const {
  for (int k = 0; k < count_; ++k) {
    const Thing& thing = things_[k];
    const double dx = x - clamped(x, thing.x0, thing.x1);
    const double dy = y - clamped(y, thing.y0, thing.y1);
    const double away = reach + thing.radius;
    if (dx * dx + dy * dy < away * away) return false;
  }
  return true;
}

Storey::Storey() {
  constexpr double kThick = 0.15;
  constexpr double kDoor = 1.2;
  Dice dice(2024);
  add_block(-2.0, -5.2, 16.0, -5.0, kCeiling);
  add_block(-2.0, 5.0, 16.0, 5.2, kCeiling);
  add_block(-2.2, -5.2, -2.0, 5.2, kCeiling);
  add_block(16.0, -5.2, 16.2, 5.2, kCeiling);
  // Two walls across, with a door to each row of rooms; between the rows, a wall with a door in each room.
  for (const double x : {4.0, 10.0}) {
    const double low = dice.in(-4.5, -1.8);
    const double high = dice.in(0.6, 3.3);
    add_block(x, -5.0, x + kThick, low, kCeiling);
    add_block(x, low + kDoor, x + kThick, high, kCeiling);
    add_block(x, high + kDoor, x + kThick, 5.0, kCeiling);
  }
  for (int room = 0; room < 3; ++room) {
    const double begin = -2.0 + 6.0 * room;
    const double door = begin + dice.in(0.6, 4.2);
    add_block(begin, -kThick, door, 0.0, kCeiling);
    add_block(door + kDoor, -kThick, begin + 6.0, 0.0, kCeiling);
  }
  for (int k = 0; k < 200 && count() < 44; ++k) {
    const double x = dice.in(-1.0, 15.0);
    const double y = dice.in(-4.5, 4.5);
    const double size = dice.in(0.15, 0.6);
    const bool aside = (x + 0.5) * (x + 0.5) + (y + 2.5) * (y + 2.5) > 4.0 && empty_around(x, y, size + 1.3);
    if (aside) add_block(x - size, y - size, x + size, y + size, dice.in(0.5, 2.6));
  }
}

Thicket::Thicket() {
  Dice dice(77);
  for (int k = 0; k < 4000 && count() < 42; ++k) {
    const double x = dice.in(2.0, 26.0);
    const double y = dice.in(-7.0, 7.0);
    const double radius = dice.in(0.15, 0.4);
    if (empty_around(x, y, radius + 1.2)) add_pillar(x, y, radius);
  }
}

}  // namespace tern_timing
