// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long inflation takes: whole maps, and what a small change costs on a large one. Every repetition starts from the
// same bits, restored outside the time that counts.
#include "tern/grid.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

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
  return {{0.0, 0.0, 0.0}, cell, dims, {{0.0, 0.0, 0.0}, {dims.x * cell, dims.y * cell, dims.z * cell}}, radius};
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
  for (int ray_index = 0; ray_index < 16 * kFramePoints && points.size() < kFramePoints; ++ray_index) {
    // Two irrational steps cover the image evenly however many rays it takes.
    const double across = std::fmod(0.7548776662466927 * ray_index, 1.0);
    const double down = std::fmod(0.5698402909980532 * ray_index, 1.0);
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

/// A row whose time is that of `change(grid)`, the world as it was kept before each.
template <typename Change>
void add(const std::string& name, const std::shared_ptr<World>& world, Change change) {
  const auto body = [world, change](benchmark::State& state) {
    for (auto _ : state) {
      world->restore();
      const auto before = std::chrono::steady_clock::now();
      change(world->grid);
      state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), body)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(1)
      ->Repetitions(kRepetitions)
      ->ReportAggregatesOnly(true)
      ->ComputeStatistics("min", [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); })
      ->ComputeStatistics("max", [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); });
}

void inflate(Grid& grid) {
  grid.inflate();
}

void add_map(int map) {
  const std::string name = "map" + std::to_string(map);
  const tern_host::Scenario scenario = tern_host::read_scenario(std::string(TERN_MAPS_DIR) + "/" + name + ".txt");
  const auto world = std::make_shared<World>(tern_host::lay_out_grid(scenario));
  for (const tern_host::Block& block : scenario.blocks) world->grid.mark_box(block.box);
  world->keep();
  add(name + "/full", world, inflate);
}

void add_forest(const std::string& name, tern::Voxel dims, double density) {
  const auto fresh = std::make_shared<World>(box_spec(dims, 0.1, 0.25));
  grow_forest(fresh->grid, density);
  fresh->keep();
  add(name + "/full", fresh, inflate);
}

/// A frame of a forest with its floor.
std::vector<Vec3> forest_frame(const GridSpec& spec) {
  World scene(spec);
  grow_forest(scene.grid, 0.1);
  scene.grid.mark_box({spec.boundary.lower, {spec.boundary.upper.x, spec.boundary.upper.y, spec.cell}});
  return depth_frame(scene.grid, {5.0, 0.5 * spec.boundary.upper.y, 2.0});
}

/// Small changes of a large forest, and a frame of a forest that the map knows nothing of.
void add_changes(const std::string& name, tern::Voxel dims) {
  const GridSpec spec = box_spec(dims, 0.1, 0.25);
  const Box box{{8.0, 15.0, 1.0}, {10.0, 17.0, 3.0}};
  const auto known = std::make_shared<World>(spec);
  grow_forest(known->grid, 0.1);
  known->grid.clear_box(box);
  known->grid.inflate();
  known->keep();
  add(name + "/nothing", known, inflate);
  add(name + "/mark box of 20x20x20", known, [box](Grid& grid) {
    grid.mark_box(box);
    grid.inflate();
  });
  const auto marked = std::make_shared<World>(spec);
  grow_forest(marked->grid, 0.1);
  marked->grid.mark_box(box);
  marked->grid.inflate();
  marked->keep();
  add(name + "/clear box of 20x20x20", marked, [box](Grid& grid) {
    grid.clear_box(box);
    grid.inflate();
  });
  const auto frame = std::make_shared<std::vector<Vec3>>(forest_frame(spec));
  const auto take_frame = [frame](Grid& grid) {
    grid.mark_points(frame->data(), frame->size());
    grid.inflate();
  };
  const auto unknown = std::make_shared<World>(spec);
  unknown->grid.inflate();
  unknown->keep();
  add(name + "/frame of 10,000 new points", unknown, take_frame);
  const auto seen = std::make_shared<World>(spec);
  take_frame(seen->grid);
  seen->keep();
  add(name + "/frame of 10,000 known points", seen, take_frame);
}

}  // namespace

int main(int argc, char** argv) {
  for (int map = 1; map <= 6; ++map) add_map(map);
  add_forest("forest 200x200x40 10 %", {200, 200, 40}, 0.1);
  add_forest("forest 200x200x40 30 %", {200, 200, 40}, 0.3);
  add_forest("forest 512x512x128", {512, 512, 128}, 0.1);
  add_changes("200x200x40", {200, 200, 40});
  add_changes("512x512x128", {512, 512, 128});
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
