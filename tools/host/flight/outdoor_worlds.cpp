// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Walls and ceilings are out of sight, so that these worlds look open. The ground of hills and slopes is a stair of
// blocks, with steps smaller than a voxel.
#include "host/flight/outdoor_worlds.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "host/text_records.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

constexpr double kAbove = 1.5;  ///< metres from the ground to both ends of a flight

std::string ends(const std::vector<double>& start, const std::vector<double>& goal) {
  return record_line("start", start) + record_line("goal", goal);
}

/// Up or down in empty space, and at most 6 m ahead.
std::string vertical_move(Noise& random) {
  constexpr double kHeights[][2] = {{1.5, 3.0}, {1.5, 5.0}, {4.0, 1.2}};
  const double* const heights = kHeights[random.below(3)];
  const double ahead = random.chance(0.25) ? 0.0 : random.within(0.0, 6.0);
  return record_line("boundary", {-14.0, -14.0, 0.0, 20.0, 14.0, 18.0}) +
         ends({random.within(-0.1, 0.1), random.within(-0.1, 0.1), heights[0]}, {ahead, 0.0, heights[1]});
}

/// From the ground to the ground, or to low roofs, past a few trees.
std::string ground_to_ground(Noise& random) {
  constexpr double kStands = 0.15;  // of the vehicle's centre above what it stands on
  constexpr double kOver = 0.15;    // stated of the ground: three quarters of a voxel
  const double away = random.within(12.0, 25.0);
  const double aside = random.within(-4.0, 4.0);
  const auto roof = [&random] { return random.chance(0.5) ? 0.0 : random.within(0.1, 1.2); };
  const double low = roof();
  const double high = roof();
  std::string text = record_line("boundary", {-14.0, -14.0, 0.0, away + 14.0, 14.0, 14.0});
  if (low > 0.0) text += record_line("block", {-1.5, -1.5, 0.0, 1.5, 1.5, low});
  if (high > 0.0) text += record_line("block", {away - 1.2, aside - 1.2, 0.0, away + 1.2, aside + 1.2, high});
  for (int k = 0; k < 8; ++k) {
    const double x = random.within(3.0, away - 3.0);
    text += record_line("cylinder", {x, random.within(-5.0, 5.0), 0.0, 5.0, random.within(0.15, 0.4)});
  }
  return text + ends({0.0, 0.0, low + kStands}, {away, aside, high + kStands}) +
         record_line("column", {low + kOver, 1.3, 3.0}) + record_line("land", {high + kOver, 0.5});
}

/// A level field under a sky without returns, half the time with a few trees.
std::string open_field(Noise& random) {
  const double away = random.within(40.0, 60.0);
  const double height = random.within(1.5, 3.0);
  std::string text = record_line("boundary", {-14.0, -14.0, 0.0, 74.0, 14.0, 20.0}) + "sensor_far 10\nno_return 10\n" +
                     ends({0.0, 0.0, height}, {away, 0.0, random.within(1.5, 6.0)});
  for (int trees = random.chance(0.5) ? 5 : 0; trees > 0; --trees) {
    const double x = random.within(4.0, away - 4.0);
    text += record_line("cylinder", {x, random.within(-6.0, 6.0), 0.0, 5.0, random.within(0.2, 0.4)});
  }
  return text;
}

/// The ground of hills: three waves that together are nowhere steeper than 30 degrees.
class Hills {
 public:
  explicit Hills(Noise& random) {
    constexpr double kSteepest = 0.57735;
    constexpr double kShare[] = {0.5, 0.3, 0.2};
    for (std::size_t k = 0; k < waves_.size(); ++k) {
      const double turns = kTurn / random.within(10.0, 22.0);
      const double heading = random.within(0.0, kTurn);
      const double high = kSteepest * kShare[k] / turns;
      waves_[k] = {turns * std::cos(heading), turns * std::sin(heading), random.within(0.0, kTurn), high};
      base_ += high;
    }
  }
  double at(double x, double y) const {
    double z = base_ + 0.3;
    for (const Wave& w : waves_) z += w.high * std::sin(w.along_x * x + w.along_y * y + w.phase);
    return z;
  }

 private:
  struct Wave {
    double along_x, along_y, phase, high;
  };
  std::array<Wave, 3> waves_{};
  double base_ = 0.0;
};

/// Columns of one height in a row are one block.
std::string hills(Noise& random) {
  constexpr double kSide = 0.4;
  constexpr double kLayer = 0.1;
  constexpr int kLong = 100;
  constexpr int kWide = 40;
  const Hills ground(random);
  const double goal_y = random.within(-5.0, 5.0);
  std::string text = record_line("boundary", {0.0, -8.0, 0.0, 40.0, 8.0, 18.0}) +
                     ends({2.0, 0.0, ground.at(2.0, 0.0) + kAbove}, {38.0, goal_y, ground.at(38.0, goal_y) + kAbove});
  for (int row = 0; row < kWide; ++row) {
    const double y = -8.0 + kSide * row;
    const auto layers = [&](int k) { return std::lround(ground.at(kSide * (k + 0.5), y + 0.5 * kSide) / kLayer); };
    for (int from = 0, to = 0; from < kLong; from = to) {
      while (to < kLong && layers(to) == layers(from)) ++to;
      const double height = kLayer * static_cast<double>(layers(from));
      text += record_line("block", {kSide * from, y, 0.0, kSide * to, y + kSide, height});
    }
  }
  return text;
}

/// A plane that rises by so many degrees: up, down or across it.
std::string slope(double degrees, Noise& random) {
  constexpr double kStep = 0.2;
  const double rise = std::tan(degrees * kTurn / 360.0);
  const int way = random.below(3);
  const double aside = random.within(-3.0, 3.0);
  const bool across = way == 2;
  const double wide = across ? 16.0 : 26.0;  // along the rise
  const double far = across ? 30.0 : 16.0;   // across it
  const double top = rise * wide + 10.0;
  std::string text = record_line("boundary", across ? std::vector<double>{0.0, -8.0, 0.0, far, 8.0, top}
                                                    : std::vector<double>{0.0, -8.0, 0.0, wide, 8.0, top});
  for (double at = 0.0; at < wide - 0.5 * kStep; at += kStep) {
    const double height = rise * (at + 0.5 * kStep);
    text += across ? record_line("block", {0.0, at - 8.0, 0.0, far, at + kStep - 8.0, height})
                   : record_line("block", {at, -8.0, 0.0, at + kStep, 8.0, height});
  }
  if (across) return text + ends({2.0, 0.0, rise * 8.0 + kAbove}, {far - 2.0, aside, rise * (8.0 + aside) + kAbove});
  const std::vector<double> low{3.0, 0.0, rise * 3.0 + kAbove};
  const std::vector<double> high{wide - 3.0, aside, rise * (wide - 3.0) + kAbove};
  return text + (way == 0 ? ends(low, high) : ends(high, low));
}

/// Three power lines across the way: wires of 12 mm that sag between poles.
std::string power_lines(Noise& random) {
  constexpr double kWire = 0.012;
  constexpr double kPiece = 0.5;
  const double start = random.within(1.5, 6.0);
  const std::vector<double> goal{48.0, random.within(-4.0, 4.0), random.within(1.5, 6.0)};
  std::string text = record_line("boundary", {-10.0, -18.0, 0.0, 58.0, 18.0, 20.0}) + ends({0.0, 0.0, start}, goal);
  for (const double middle : {12.0, 24.0, 36.0}) {
    const double x = middle + random.within(-2.0, 2.0);
    const double pole = random.within(-9.0, -3.0);
    const double lowest = random.within(2.5, 4.5);
    for (const double y : {pole, pole + 12.0}) text += record_line("cylinder", {x, y, 0.0, lowest + 2.5, 0.15});
    for (int wire = 0; wire < 3; ++wire) {
      const double side = x + 0.4 * (wire - 1);
      for (double y = -18.0; y < 17.9; y += kPiece) {
        const double span = std::remainder(y + 0.5 * kPiece - pole - 6.0, 12.0) / 6.0;  // -1 and 1 at the poles
        const double z = lowest + 0.8 * wire + 0.7 * span * span;
        text += record_line("block", {side, y, z, side + kWire, y + kPiece, z + kWire});
      }
    }
  }
  return text;
}

struct LeaningTrunk {
  double x, y, lean_x, lean_y, radius;  ///< `lean`: metres aside for each metre up

  double away_from(double at_x, double at_y, double height) const {
    return std::hypot(x + lean_x * height - at_x, y + lean_y * height - at_y) - radius;
  }
};

/// A forest of trunks that lean by 10 to 35 degrees: piles of short cylinders.
std::string leaning_trunks(Noise& random) {
  constexpr double kPiece = 0.2;
  constexpr double kHigh = 5.0;
  std::string text =
      record_line("boundary", {-14.0, -14.0, 0.0, 54.0, 14.0, 18.0}) + ends({0.0, 0.0, kAbove}, {40.0, 0.0, kAbove});
  for (int k = 0; k < 26; ++k) {
    const double heading = random.within(0.0, kTurn);
    const double lean = random.within(0.18, 0.7);
    const LeaningTrunk t{random.within(2.0, 38.0), random.within(-9.0, 9.0), lean * std::cos(heading),
                         lean * std::sin(heading), random.within(0.12, 0.25)};
    if (t.away_from(0.0, 0.0, kAbove) < 2.0 || t.away_from(40.0, 0.0, kAbove) < 2.0) continue;
    for (double z = 0.0; z < kHigh - 0.5 * kPiece; z += kPiece) {
      text += record_line("cylinder", {t.x + t.lean_x * z, t.y + t.lean_y * z, z, z + kPiece, t.radius});
    }
  }
  return text;
}

}  // namespace

std::string outdoor_text(const std::string& family, Noise& random) {
  switch (family[0]) {
    case 'V':
      return vertical_move(random);
    case 'F':
      return open_field(random);
    case 'K':
      return ground_to_ground(random);
    case 'H':
      return hills(random);
    case 'T':
      return slope(std::atof(family.c_str() + 1), random);
    case 'E':
      return power_lines(random);
    default:
      return leaning_trunks(random);
  }
}

}  // namespace tern_host
