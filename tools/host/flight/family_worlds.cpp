// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/family_worlds.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "host/flight/city_worlds.hpp"
#include "host/flight/indoor_worlds.hpp"
#include "host/flight/mission_worlds.hpp"
#include "host/flight/outdoor_worlds.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

const std::string kBodyCamera = "sensor d435\nyaw unseen\n";
constexpr double kPi = 3.14159265358979323846;

struct Trunk {
  double x, y, radius;
};

std::string wall(double x0, double y0, double x1, double y1, double height) {
  return record_line("block", {x0, y0, 0.0, x1, y1, height});
}

/// How many of a Poisson process fall into an area where `mean` are expected.
int poisson(double mean, Noise& random) {
  const double least = std::exp(-mean);
  int count = 0;
  for (double product = random.within(0.0, 1.0); product > least; product *= random.within(0.0, 1.0)) ++count;
  return count;
}

/// A Poisson forest of thin trees over 60 m x 30 m, as in Loquercio et al. 2021; 2 m around both ends are free.
std::string thin_forest(double area_a_tree, Noise& random) {
  constexpr double kLong = 30.0;
  constexpr double kWide = 15.0;
  constexpr double kClear = 2.0;
  std::string text = record_line("boundary", {-33.0, -18.0, 0.0, 33.0, 18.0, 5.0});
  for (int k = poisson(4.0 * kLong * kWide / area_a_tree, random); k > 0; --k) {
    const Trunk t{random.within(-kLong, kLong), random.within(-kWide, kWide), random.within(0.2, 0.4)};
    if (std::hypot(std::abs(t.x) - kLong, t.y) < kClear + t.radius) continue;
    text += record_line("cylinder", {t.x, t.y, 0.0, 5.0, t.radius});
  }
  return text + "start -30 0 1.5\ngoal 30 0 1.5\n";
}

/// SANDO's forest: thick cylinders at least 1.5 m apart, until they cover a part of 100 m x 40 m.
std::string thick_forest(double part, Noise& random) {
  constexpr double kArea = 100.0 * 40.0;
  constexpr double kGap = 1.5;
  constexpr int kTries = 40000;
  std::vector<Trunk> trunks;
  std::string text = record_line("boundary", {-3.0, -23.0, 0.0, 109.0, 23.0, 6.0});
  double covered = 0.0;
  for (int k = 0; k < kTries && covered < part * kArea; ++k) {
    const Trunk t{random.within(3.0, 103.0), random.within(-20.0, 20.0),
                  k < kTries / 2 ? random.within(1.0, 1.5) : 1.0};
    bool fits = std::hypot(t.x, t.y) > t.radius + kGap && std::hypot(t.x - 105.0, t.y) > t.radius + kGap;
    for (const Trunk& other : trunks) {
      fits = fits && std::hypot(t.x - other.x, t.y - other.y) >= t.radius + other.radius + kGap;
    }
    if (!fits) continue;
    trunks.push_back(t);
    covered += kPi * t.radius * t.radius;
    text += record_line("cylinder", {t.x, t.y, 0.0, 6.0, t.radius});
  }
  return text + "start 0 0 2\ngoal 105 0 2\n";
}

/// A corridor that turns left, and behind the corner, where it is seen late, a block that leaves a part of the way.
std::string hidden_corner(Noise& random) {
  constexpr double kWall = 0.3;
  constexpr double kHeight = 4.0;
  const double width = random.within(2.7, 4.2);
  const double inner = random.within(10.0, 14.0);
  const double outer = inner + width;
  const double block = random.within(0.25, 0.4) * width;
  const double behind = width + random.within(0.5, 1.5);
  const bool at_outer = random.chance(0.5);
  const double from = at_outer ? outer - block : inner;
  return record_line("boundary", {-2.0, -1.0, 0.0, 22.0, 21.0, kHeight}) +
         wall(0.0, width, inner, width + kWall, kHeight) + wall(0.0, -kWall, outer, 0.0, kHeight) +
         wall(outer, -kWall, outer + kWall, 20.0, kHeight) + wall(inner - kWall, width, inner, 20.0, kHeight) +
         wall(from, behind, from + block, behind + 0.6, kHeight) + record_line("start", {1.0, 0.5 * width, 1.5}) +
         record_line("goal", {inner + 0.5 * width, 19.0, 1.5});
}

/// Three walls of a room that is open towards the start.
std::string bug_trap(Noise& random) {
  constexpr double kWall = 0.4;
  const double deep = random.within(5.0, 9.0);
  const double half = random.within(2.2, 3.5);
  const double back = 10.0 + deep;
  return record_line("boundary", {-2.0, -12.0, 0.0, 36.0, 12.0, 4.0}) + wall(back, -half, back + kWall, half, 4.0) +
         wall(10.0, -half - kWall, back + kWall, -half, 4.0) + wall(10.0, half, back + kWall, half + kWall, 4.0) +
         "start 0 0 1.5\ngoal 34 0 1.5\n";
}

/// Six rooms with doors of 1.2 m, and furniture.
std::string storey(Noise& random) {
  constexpr double kDoor = 1.2;
  constexpr double kDepth = 15.0;
  constexpr double kHeight = 3.0;
  std::string text = record_line("boundary", {0.0, 0.0, 0.0, 36.0, kDepth, kHeight});
  for (int k = 1; k <= 5; ++k) {
    const double x = 6.0 * k;
    const double door = random.within(1.0, kDepth - 1.0 - kDoor);
    text += wall(x, 0.0, x + 0.2, door, kHeight) + wall(x, door + kDoor, x + 0.2, kDepth, kHeight);
  }
  for (int k = 0; k < 5; ++k) {
    // Away from doors and from both ends.
    const double x = 6.0 * random.below(6) + random.within(1.8, 3.4);
    const double y = random.within(1.0, kDepth - 2.0);
    const bool near_end = (x < 4.0 || x > 32.0) && std::abs(y - 7.5) < 2.5;
    const double size[] = {random.within(0.5, 1.1), random.within(0.5, 1.3), random.within(1.0, 2.6)};
    if (!near_end) text += record_line("block", {x, y, 0.0, x + size[0], y + size[1], size[2]});
  }
  return text + "start 1.5 7.5 1.2\ngoal 34.5 7.5 1.2\n";
}

/// A maze of squares of 3 m with one way between any two of them.
class Maze {
 public:
  explicit Maze(Noise& random) { carve(random); }

  std::string text() const {
    std::string all = record_line("boundary", {0.0, 0.0, 0.0, kSide * kColumns, kSide * kRows, kHeight});
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kColumns; ++x) {
        const double right = kSide * (x + 1);
        const double upper = kSide * (y + 1);
        const Square& square = squares_[number(x, y)];
        if (x + 1 < kColumns && !square.open_right) {
          all += wall(right - kHalf, upper - kSide - kHalf, right + kHalf, upper + kHalf, kHeight);
        }
        if (y + 1 < kRows && !square.open_up) {
          all += wall(right - kSide - kHalf, upper - kHalf, right + kHalf, upper + kHalf, kHeight);
        }
      }
    }
    return all + record_line("start", {0.5 * kSide, 0.5 * kSide, 1.2}) +
           record_line("goal", {kSide * (kColumns - 0.5), kSide * (kRows - 0.5), 1.2}) +
           "window 38.4 20 8\n";  // a way round must not leave it
  }

 private:
  static constexpr int kColumns = 8;
  static constexpr int kRows = 5;
  static constexpr double kSide = 3.0;
  static constexpr double kHalf = 0.1;  // of a wall
  static constexpr double kHeight = 3.0;

  struct Square {
    bool seen = false, open_right = false, open_up = false;
  };

  static std::size_t number(int x, int y) { return static_cast<std::size_t>(y * kColumns + x); }

  bool fresh(int x, int y) const {
    return x >= 0 && y >= 0 && x < kColumns && y < kRows && !squares_[number(x, y)].seen;
  }

  void open(int x, int y, int dx, int dy) {
    if (dx != 0) squares_[number(dx > 0 ? x : x - 1, y)].open_right = true;
    if (dy != 0) squares_[number(x, dy > 0 ? y : y - 1)].open_up = true;
  }

  /// Depth first, with a stack of its own.
  void carve(Noise& random) {
    constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    std::vector<std::array<int, 2>> way{{0, 0}};
    squares_[0].seen = true;
    while (!way.empty()) {
      const int x = way.back()[0];
      const int y = way.back()[1];
      std::vector<int> choices;
      for (int k = 0; k < 4; ++k) {
        if (fresh(x + kSteps[k][0], y + kSteps[k][1])) choices.push_back(k);
      }
      if (choices.empty()) {
        way.pop_back();
        continue;
      }
      const int* const step = kSteps[choices[static_cast<std::size_t>(random.below(static_cast<int>(choices.size())))]];
      open(x, y, step[0], step[1]);
      squares_[number(x + step[0], y + step[1])].seen = true;
      way.push_back({x + step[0], y + step[1]});
    }
  }

  std::array<Square, static_cast<std::size_t>(kColumns) * kRows> squares_{};
};

}  // namespace

std::string obstacles_text(const std::string& family, Noise& random) {
  switch (family[0]) {
    case 'P':
      return thin_forest(std::atof(family.c_str() + 1), random);
    case 'S':
      return thick_forest(0.01 * std::atof(family.c_str() + 1), random);
    case 'C':
      return hidden_corner(random);
    case 'B':
      return bug_trap(random);
    case 'O':
      return storey(random);
    case 'M':
      return Maze(random).text();
    case 'L':
    case 'G':
    case 'I':
    case 'D':
      return mission_text(family[0], random);
    case 'Y':
      return city_text(random);
    case 'W':
    case 'U':
    case 'N':
    case 'Q':
    case 'X':
      return kBodyCamera + indoor_text(family[0], random);
    default:
      return kBodyCamera + outdoor_text(family, random);
  }
}

}  // namespace tern_host
