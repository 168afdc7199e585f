// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world.hpp"

#include <px4_platform_common/log.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

namespace tern_offboard {
namespace {

constexpr int kMostNumbers = 9;
constexpr int kLineBytes = 256;
constexpr double kFarthest = 1e6;  // of any number
const char* const kSkipped[] = {"start", "goal", "time_weight", "search", "goal_mode", "yaw"};

/// One record: its name, and its numbers.
struct Record {
  const char* name;
  double numbers[kMostNumbers];
  int count;
};

/// What records have been read.
struct Found {
  bool boundary, resolution, radius, tracking_margin, v_horizontal;
};

bool is_skipped(const char* name) {
  for (const char* skipped : kSkipped) {
    if (strcmp(name, skipped) == 0) return true;
  }
  return false;
}

/// Splits a line. False: a word after the name is no number, or there are too many.
bool split(char* line, Record& record) {
  line[strcspn(line, "#")] = '\0';
  char* rest = nullptr;
  record.name = strtok_r(line, " \t\r\n", &rest);
  record.count = 0;
  if (record.name == nullptr || is_skipped(record.name)) return true;
  for (char* word = strtok_r(nullptr, " \t\r\n", &rest); word != nullptr; word = strtok_r(nullptr, " \t\r\n", &rest)) {
    char* end = nullptr;
    const double number = strtod(word, &end);
    if (record.count == kMostNumbers || *end != '\0' || !(number > -kFarthest && number < kFarthest)) return false;
    record.numbers[record.count++] = number;
  }
  return true;
}

bool read_box(const Record& record, tern::Box& box) {
  const double* n = record.numbers;
  box = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  const bool has_colour = record.count == 9 && strcmp(record.name, "block") == 0;
  return (record.count == 6 || has_colour) && n[0] <= n[3] && n[1] <= n[4] && n[2] <= n[5];
}

bool read_positive(const Record& record, double& value) {
  value = record.numbers[0];
  return record.count == 1 && value > 0.0;
}

bool read_per_axis(const Record& record, tern::Vec3& value) {
  const double* n = record.numbers;
  value = record.count == 1 ? tern::Vec3{n[0], n[0], n[0]} : tern::Vec3{n[0], n[1], n[2]};
  return (record.count == 1 || record.count == 3) && value.x > 0.0 && value.y > 0.0 && value.z > 0.0;
}

/// Null, or what is wrong.
const char* read_record(const Record& record, World& world, Found& found) {
  const char* const name = record.name;
  if (strcmp(name, "boundary") == 0) {
    found.boundary = true;
    return read_box(record, world.boundary) ? nullptr : "takes six numbers, the lower corner first";
  }
  if (strcmp(name, "block") == 0 || strcmp(name, "keepout") == 0) {
    if (world.block_count == kMostBlocks) return "is one too many";
    return read_box(record, world.blocks[world.block_count++]) ? nullptr : "takes six numbers, the lower corner first";
  }
  if (strcmp(name, "resolution") == 0) {
    found.resolution = true;
    return read_positive(record, world.resolution) ? nullptr : "takes one positive number";
  }
  if (strcmp(name, "radius") == 0) {
    found.radius = true;
    return read_positive(record, world.radius) ? nullptr : "takes one positive number";
  }
  if (strcmp(name, "tracking_margin") == 0) {
    found.tracking_margin = true;
    return read_positive(record, world.tracking_margin) ? nullptr : "takes one positive number";
  }
  if (strcmp(name, "v_horizontal") == 0) {
    found.v_horizontal = true;
    return read_positive(record, world.v_horizontal) ? nullptr : "takes one positive number";
  }
  if (strcmp(name, "v_max") == 0)
    return read_per_axis(record, world.v_max) ? nullptr : "takes one positive number, or three";
  if (strcmp(name, "a_max") == 0)
    return read_per_axis(record, world.a_max) ? nullptr : "takes one positive number, or three";
  return "is not read on an autopilot";
}

bool read_lines(FILE* file, const char* path, World& world, Found& found) {
  char line[kLineBytes];
  Record record{};
  for (int number = 1; fgets(line, sizeof line, file) != nullptr; ++number) {
    if (strchr(line, '\n') == nullptr && strlen(line) + 1 == sizeof line) {
      PX4_ERR("%s:%d: the line is too long", path, number);
      return false;
    }
    if (!split(line, record)) {
      PX4_ERR("%s:%d: '%s' has a word that is no number, or too many of them", path, number, record.name);
      return false;
    }
    if (record.name == nullptr || is_skipped(record.name)) continue;
    const char* const fault = read_record(record, world, found);
    if (fault == nullptr) continue;
    PX4_ERR("%s:%d: '%s' %s", path, number, record.name, fault);
    return false;
  }
  return true;
}

}  // namespace

bool read_world(const char* path, World& world) {
  FILE* const file = fopen(path, "r");
  if (file == nullptr) {
    PX4_ERR("%s: cannot be read", path);
    return false;
  }
  world = World{};
  Found found{};
  const bool is_read = read_lines(file, path, world, found);
  fclose(file);
  const bool is_whole =
      found.boundary && found.resolution && found.radius && found.tracking_margin && found.v_horizontal;
  if (is_read && !is_whole) {
    PX4_ERR("%s: boundary, resolution, radius, tracking_margin and v_horizontal must be there", path);
    return false;
  }
  return is_read && is_whole;
}

}  // namespace tern_offboard
