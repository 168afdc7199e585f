// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long inflation takes: whole maps, and what a small change costs on a large one. Every repetition starts from the
// same bits, restored outside the time that counts.
#include "tern/grid.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "host/grid_layout.hpp"
#include "host/scenario.hpp"

namespace {

using tern::Box;
using tern::Grid;
using tern::GridSpec;
using tern::Vec3;

constexpr int kRepetitions = 60;
constexpr std::size_t kFramePoints = 10000;
constexpr double kFrameRange = 12.0;  // metres

/// A grid with its storage, which can go back to what it was when it was kept.
class World {
 public:
  explicit World(const GridSpec& spec) : words_(tern::grid_words(spec.dims)) {
    grid.bind(spec, words_.data(), words_.size());
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void keep() {
    kept_ = words_;
    kept_grid_ = grid;
  }
  void restore() {
    std::copy(kept_.begin(), kept_.end(), words_.begin());
    grid = kept_grid_;
  }

  Grid grid;

 private:
  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> kept_;
  Grid kept_grid_;
};

GridSpec box_spec(tern::Voxel dims, double cell, double radius) {
  return {{0.0, 0.0, 0.0}, cell, dims, {{0.0, 0.0, 0.0}, {dims.x * cell, dims.y * cell, dims.z * cell}}, radius, 0.0};
}

/// Cuboids of 1 to 2 m from the floor up until they fill that part of the ground.
void grow_forest(Grid& grid, double density) {
  std::mt19937 random(7);  // its numbers, unlike the distributions', are the same everywhere
  const auto real = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  const Box& boundary = grid.spec().boundary;
  const double ground = boundary.upper.x * boundary.upper.y;
  for (double filled = 0.0; filled < density * ground;) {
    const Vec3 size{real(1.0, 2.0), real(1.0, 2.0), real(0.3, 1.0) * boundary.upper.z};
    const Vec3 low{real(0.0, boundary.upper.x - size.x), real(0.0, boundary.upper.y - size.y), 0.0};
    grid.mark_box({low, {low.x + size.x, low.y + size.y, size.z}});
    filled += size.x * size.y;
  }
}

/// What a depth camera of 90 by 70 degrees sees from `eye` along x: of rays that end within its range, the first
/// kFramePoints where they meet an obstacle.
std::vector<Vec3> depth_frame(const Grid& scene, const Vec3& eye) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < 16 * kFramePoints && points.size() < kFramePoints; ++k) {
    // Two irrational steps cover the image evenly however many rays it takes.
    const double across = std::fmod(0.7548776662466927 * static_cast<double>(k), 1.0);
    const double down = std::fmod(0.5698402909980532 * static_cast<double>(k), 1.0);
    const Vec3 ray{1.0, 2.0 * across - 1.0, 1.4 * down - 0.7};
    const double norm = std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
    for (double t = 0.0; t < kFrameRange; t += 0.25 * scene.spec().cell) {
      const Vec3 point{eye.x + t / norm * ray.x, eye.y + t / norm * ray.y, eye.z + t / norm * ray.z};
      if (!scene.obstacle(scene.voxel_of(point))) continue;
      points.push_back(point);
      break;
    }
  }
  return points;
}

/// Prints rows and keeps them as CSV.
class Table {
 public:
  /// A row: the times of `change(world.grid)`, the world as it was kept before each.
  template <typename Change>
  void measure(const std::string& map, const std::string& what, World& world, Change change) {
    std::vector<double> times;
    for (int k = 0; k < kRepetitions; ++k) {
      world.restore();
      const auto before = std::chrono::steady_clock::now();
      change(world.grid);
      times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
    }
    std::sort(times.begin(), times.end());
    char line[160];
    std::snprintf(line, sizeof line, "%s,%s,%.1f,%.1f,%.1f\n", map.c_str(), what.c_str(), times.front(),
                  times[times.size() / 2], times.back());
    std::fputs(line, stdout);
    csv_ += line;
  }
  const std::string& csv() const { return csv_; }

 private:
  std::string csv_ = "map,change,least_us,median_us,max_us\n";
};

void inflate(Grid& grid) {
  grid.inflate();
}

void measure_map(Table& table, int map) {
  const std::string name = "map" + std::to_string(map);
  const tern_host::Scenario scenario = tern_host::read_scenario(std::string(TERN_MAPS_DIR) + "/" + name + ".txt");
  World world(tern_host::lay_out_grid(scenario));
  for (const tern_host::Block& block : scenario.blocks) world.grid.mark_box(block.box);
  world.keep();
  table.measure(name, "all", world, inflate);
}

void measure_forest(Table& table, const std::string& name, const GridSpec& spec, double density) {
  World world(spec);
  grow_forest(world.grid, density);
  world.keep();
  table.measure(name, "all", world, inflate);
}

/// Small changes of a forest.
void measure_boxes(Table& table, const std::string& name, const GridSpec& spec) {
  const Box box{{8.0, 15.0, 1.0}, {10.0, 17.0, 3.0}};
  World world(spec);
  grow_forest(world.grid, 0.1);
  world.grid.clear_box(box);
  world.grid.inflate();
  world.keep();
  table.measure(name, "nothing", world, inflate);
  table.measure(name, "mark a box of 20 x 20 x 20", world, [&box](Grid& grid) {
    grid.mark_box(box);
    grid.inflate();
  });
  world.grid.mark_box(box);
  world.grid.inflate();
  world.keep();
  table.measure(name, "clear a box of 20 x 20 x 20", world, [&box](Grid& grid) {
    grid.clear_box(box);
    grid.inflate();
  });
}

/// A frame of a forest with its floor, for a map that knows nothing of it, and once more.
void measure_frames(Table& table, const std::string& name, const GridSpec& spec) {
  World scene(spec);
  grow_forest(scene.grid, 0.1);
  scene.grid.mark_box({spec.boundary.lower, {spec.boundary.upper.x, spec.boundary.upper.y, spec.cell}});
  const std::vector<Vec3> frame = depth_frame(scene.grid, {5.0, 0.5 * spec.boundary.upper.y, 2.0});
  const auto take_frame = [&frame](Grid& grid) {
    grid.mark_points(frame.data(), frame.size());
    grid.inflate();
  };
  World world(spec);
  world.grid.inflate();
  world.keep();
  table.measure(name, "a frame of 10000 new points", world, take_frame);
  take_frame(world.grid);
  world.keep();
  table.measure(name, "a frame of 10000 known points", world, take_frame);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times of inflation, of whole maps and after small changes.");
  std::string csv_file;
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
  Table table;
  for (int map = 1; map <= 6; ++map) measure_map(table, map);
  const GridSpec room = box_spec({200, 200, 40}, 0.1, 0.25);
  const GridSpec hall = box_spec({512, 512, 128}, 0.1, 0.25);
  measure_forest(table, "200x200x40 at 10 %", room, 0.1);
  measure_forest(table, "200x200x40 at 30 %", room, 0.3);
  measure_forest(table, "512x512x128 at 10 %", hall, 0.1);
  measure_boxes(table, "200x200x40 at 10 %", room);
  measure_boxes(table, "512x512x128 at 10 %", hall);
  measure_frames(table, "200x200x40", room);
  measure_frames(table, "512x512x128", hall);
  if (!csv_file.empty()) tern_host::write_file(csv_file, table.csv());
  return 0;
}
