// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/indoor_worlds.hpp"

#include <vector>

#include "host/text_records.hpp"

namespace tern_host {
namespace {

std::string block(double x0, double y0, double z0, double x1, double y1, double z1) {
  return record_line("block", {x0, y0, z0, x1, y1, z1});
}

/// One row of shelves, a metre deep: posts, three boards, and goods on most of them.
std::string shelves(double y, Noise& random) {
  constexpr double kFrom = 4.0;
  constexpr double kBay = 2.75;
  constexpr int kBays = 8;
  constexpr double kTo = kFrom + kBay * kBays;
  std::string text;
  for (int k = 0; k <= kBays; ++k) {
    for (const double side : {y, y + 0.92}) {
      const double x = kFrom + kBay * k;
      text += block(x - 0.04, side, 0.0, x + 0.04, side + 0.08, 5.0);
    }
  }
  for (const double board : {1.5, 3.0, 4.5}) text += block(kFrom, y, board, kTo, y + 1.0, board + 0.06);
  for (int k = 0; k < 3 * kBays; ++k) {
    const double floor = k / kBays == 0 ? 0.0 : 1.5 * (k / kBays) + 0.06;
    const double x = kFrom + kBay * (k % kBays) + 0.2;
    const double size[] = {random.within(1.0, 2.3), random.within(0.6, 1.3)};
    if (random.chance(0.7)) text += block(x, y + 0.05, floor, x + size[0], y + 0.95, floor + size[1]);
  }
  return text;
}

/// Four rows of shelves with aisles of 2.6 m: from inside an aisle to the other end of the next one or the one behind
/// that, at another height.
std::string warehouse(Noise& random) {
  constexpr double kFirst = 1.6;
  constexpr double kApart = 3.6;
  std::string text = record_line("boundary", {0.0, 0.0, 0.0, 30.0, 17.6, 6.5});
  for (int row = 0; row < 4; ++row) text += shelves(3.0 + kApart * row, random);
  const int start = random.below(3);
  const int goal = start + 1 + random.below(2);
  text += record_line("start", {random.within(6.0, 10.0), kFirst + kApart * start, 1.5});
  return text + record_line("goal", {random.within(19.0, 25.0), kFirst + kApart * goal, random.within(1.0, 4.5)});
}

/// Stairs between two storeys, 1.8 to 3 m wide and 2.7 m high all the way: up or down.
std::string stairs(Noise& random) {
  constexpr double kHall = 6.0;
  constexpr double kHeadroom = 2.7;
  constexpr double kTread = 0.29;
  constexpr double kRise = 0.1875;
  constexpr int kSteps = 16;
  constexpr double kFloor = kRise * kSteps;
  constexpr double kTop = kFloor + kHeadroom;
  constexpr double kEnd = 2.0 * kHall + kTread * kSteps;
  const double half = random.within(0.9, 1.5);
  std::string text = record_line("boundary", {0.0, -half, 0.0, kEnd, half, kTop}) + "cell 0.1\nwindow 25.6 20 8\n" +
                     block(0.0, -half, kHeadroom, kHall, half, kTop) +
                     block(kEnd - kHall, -half, 0.0, kEnd, half, kFloor);
  for (int k = 0; k < kSteps; ++k) {
    const double x = kHall + kTread * k;
    text += block(x, -half, 0.0, x + kTread, half, kRise * (k + 1));
    if (k + 1 < kSteps) text += block(x, -half, kRise * (k + 1) + kHeadroom, x + kTread, half, kTop);
  }
  const bool up = random.chance(0.5);
  const std::string low = record_line(up ? "start" : "goal", {1.5, 0.0, 1.2});
  return text + low + record_line(up ? "goal" : "start", {kEnd - 1.5, 0.0, kFloor + 1.2});
}

/// Strings of 6 mm, 15 cm apart, with an opening of 2.2 m by 2.2 m.
std::string net(double x, Noise& random) {
  constexpr double kThick = 0.006;
  constexpr double kApart = 0.15;
  constexpr double kOpening = 2.2;
  constexpr double kHalf = 6.0;
  constexpr double kHigh = 4.0;
  const double left = random.within(-4.5, 4.5 - kOpening);
  const double low = random.within(0.6, kHigh - 0.6 - kOpening);
  std::string text;
  for (double y = -kHalf + 0.5 * kApart; y < kHalf; y += kApart) {
    const bool meets = y > left && y < left + kOpening;
    text += block(x, y, 0.0, x + kThick, y + kThick, meets ? low : kHigh);
    if (meets) text += block(x, y, low + kOpening, x + kThick, y + kThick, kHigh);
  }
  for (double z = kApart; z < kHigh; z += kApart) {
    const bool meets = z > low && z < low + kOpening;
    text += block(x, -kHalf, z, x + kThick, meets ? left : kHalf, z + kThick);
    if (meets) text += block(x, left + kOpening, z, x + kThick, kHalf, z + kThick);
  }
  return text;
}

/// Two nets across a hall.
std::string nets(Noise& random) {
  std::string text = record_line("boundary", {0.0, -6.0, 0.0, 24.0, 6.0, 4.0});
  for (const double x : {8.0, 16.0}) text += net(x + random.within(-1.0, 1.0), random);
  text += record_line("start", {1.8, random.within(-3.0, 3.0), 1.5});
  return text + record_line("goal", {22.2, random.within(-3.0, 3.0), 1.5});
}

/// A lap round a room with a block in its middle that reaches the ceiling, and things along the walls.
std::string room_lap(Noise& random) {
  std::string text = record_line("boundary", {0.0, 0.0, 0.0, 10.0, 8.0, 3.0}) +
                     record_line("block", {random.within(3.2, 3.8), 3.0, 0.0, random.within(6.2, 6.8), 5.0, 3.0});
  for (const double wall : {0.0, 7.5}) {
    const double x = random.within(2.6, 6.0);
    text += record_line("block", {x, wall, 0.0, x + random.within(0.6, 1.2), wall + 0.5, random.within(0.6, 2.2)});
  }
  text += "start 1.3 1.3 1.3\n";
  for (const auto& corner : {std::vector<double>{8.7, 1.3}, {8.7, 6.7}, {1.3, 6.7}}) {
    text += record_line("via", {corner[0], corner[1], random.within(1.0, 2.0), 0.3});
  }
  return text + "goal 1.3 1.3 1.3\n";
}

/// A wall with a window of 1.2 to 1.8 m.
std::string window(Noise& random) {
  constexpr double kFront = 8.0;
  constexpr double kBack = 8.3;
  constexpr double kHalf = 6.0;
  constexpr double kHigh = 4.0;
  const double wide = random.within(1.2, 1.8);
  const double high = random.within(1.2, 1.8);
  const double left = random.within(-4.0, 4.0 - wide);
  const double sill = random.within(0.7, kHigh - 0.5 - high);
  std::string text =
      record_line("boundary", {0.0, -kHalf, 0.0, 16.0, kHalf, kHigh}) + block(kFront, -kHalf, 0.0, kBack, left, kHigh) +
      block(kFront, left + wide, 0.0, kBack, kHalf, kHigh) + block(kFront, left, 0.0, kBack, left + wide, sill) +
      block(kFront, left, sill + high, kBack, left + wide, kHigh);
  text += record_line("start", {1.8, random.within(-3.0, 3.0), 1.5});
  return text + record_line("goal", {14.2, random.within(-3.0, 3.0), 1.5});
}

}  // namespace

std::string indoor_text(char family, Noise& random) {
  switch (family) {
    case 'W':
      return warehouse(random);
    case 'N':
      return nets(random);
    case 'U':
      return stairs(random);
    case 'Q':
      return room_lap(random);
    default:
      return window(random);
  }
}

}  // namespace tern_host
