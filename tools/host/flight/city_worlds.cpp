// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/city_worlds.hpp"

#include "host/text_records.hpp"

namespace tern_host {
namespace {

constexpr double kBlock = 60.0;
constexpr double kStreet = 20.0;
constexpr double kPitch = kBlock + kStreet;
constexpr double kWall = 10.0;     ///< what closes a street is so thick
constexpr double kCeiling = 16.0;  ///< of the flight; all roofs are higher
constexpr double kClosed = 0.1;    ///< part of the streets, from crossing to crossing

struct City {
  int columns, rows;  ///< of blocks
  int street;         ///< the one along x that the flight begins and ends in
  int bottom;         ///< the court's: the column of blocks between which it closes the streets
  int depth, half;    ///< of the court, in columns, and in streets to either side
};

std::string block(double x, double y, double length, double width) {
  return record_line("block", {x, y, 0.0, x + length, y + width, kCeiling});
}

/// Closes a street along x where it passes a column of blocks, or one along y where it passes a row.
std::string close_along_x(int street, int column) {
  return block(kStreet + kPitch * column, kPitch * street, kWall, kStreet);
}
std::string close_along_y(int street, int row) {
  return block(kPitch * street, kStreet + kPitch * row, kStreet, kWall);
}

/// Three sides of a rectangle of streets, open towards the start.
std::string court(const City& city) {
  std::string text;
  const int lowest = city.street - city.half;
  const int highest = city.street + city.half;
  for (int street = lowest; street <= highest; ++street) text += close_along_x(street, city.bottom);
  for (int street = city.bottom - city.depth; street <= city.bottom; ++street) {
    text += close_along_y(street, lowest - 1) + close_along_y(street, highest);
  }
  return text;
}

/// Streets that are closed by chance, none of them near the start or the goal.
std::string closed_streets(const City& city, Noise& random) {
  std::string text;
  for (int column = 2; column + 2 < city.columns; ++column) {
    for (int row = 0; row < city.rows; ++row) {
      if (random.chance(kClosed)) text += close_along_x(row, column);
      if (random.chance(kClosed)) text += close_along_y(column, row);
    }
  }
  return text;
}

}  // namespace

std::string city_text(Noise& random) {
  City city{12 + random.below(25), 9, 3 + random.below(4), 0, 1 + random.below(4), 1 + random.below(2)};
  city.bottom = 5 + random.below(city.columns - 8);
  const double length = kPitch * city.columns + kStreet;
  const double width = kPitch * city.rows + kStreet;
  const double y = kPitch * city.street + 0.5 * kStreet;
  std::string text = record_line("boundary", {0.0, 0.0, 0.0, length, width, kCeiling});
  for (int column = 0; column < city.columns; ++column) {
    for (int row = 0; row < city.rows; ++row) {
      text += block(kStreet + kPitch * column, kStreet + kPitch * row, kBlock, kBlock);
    }
  }
  return text + court(city) + closed_streets(city, random) + record_line("start", {0.5 * kStreet, y, 4.0}) +
         record_line("goal", {length - 0.5 * kStreet, y, 4.0}) +
         "cell 0.5\nwindow 128 128 18\nbody_radius 0.4\ntime_limit 1500\nfar_cell 4\n";
}

}  // namespace tern_host
