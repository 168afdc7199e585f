// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What frames, scans and slides of a rolling map cost: a vehicle flies at 3 m/s through a forest, with a depth camera
// at 30 Hz or a lidar at 10 Hz, and the window follows it. The sensor's images are made outside the time that counts.
#include "tern/map.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"

namespace {

using tern::MapSpec;
using tern::Pose;
using tern::RollingMap;
using tern::Vec3;
using tern::Voxel;

struct Tree {
  double x, y, radius;
};

/// Trees of radius 0.15 to 0.5 m, one on 25 square metres, on flat ground; the way along y = 0 is free.
std::vector<Tree> forest() {
  std::mt19937 random(11);
  const auto real = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  std::vector<Tree> trees;
  while (trees.size() < 160) {
    const Tree tree{real(-10.0, 60.0), real(-28.0, 28.0), real(0.15, 0.5)};
    if (std::abs(tree.y) > tree.radius + 0.8) trees.push_back(tree);
  }
  return trees;
}

/// Distance along a ray to the nearest tree, the ground or the background.
double cast(const std::vector<Tree>& trees, const Vec3& eye, const Vec3& ray) {
  // Something is behind it all: a sky without returns would leave nothing to do.
  double nearest = ray.z < 0.0 ? -eye.z / ray.z : 40.0;
  const double a = ray.x * ray.x + ray.y * ray.y;
  for (const Tree& tree : trees) {
    const double x = eye.x - tree.x, y = eye.y - tree.y;
    const double b = x * ray.x + y * ray.y;
    const double d = b * b - a * (x * x + y * y - tree.radius * tree.radius);
    if (d <= 0.0 || b >= 0.0) continue;
    const double t = (-b - std::sqrt(d)) / a;
    if (t > 0.0 && t < nearest) nearest = t;
  }
  return nearest;
}

/// A camera that looks along x of the world, 90 degrees wide.
constexpr double kAhead[4] = {0.5, -0.5, 0.5, -0.5};
void render(const std::vector<Tree>& trees, const Vec3& eye, const tern::DepthView& view,
            std::vector<std::uint16_t>& z) {
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      const double depth = cast(trees, eye, {1.0, -(u - view.cx) / view.fx, -(v - view.cy) / view.fy});
      z[static_cast<std::size_t>(v * view.width + u)] = static_cast<std::uint16_t>(std::min(depth * 1000.0, 60000.0));
    }
  }
}

/// A scan of 360 by 59 degrees, in a sequence that covers it evenly; beams without a return reach 60 m.
std::vector<Vec3> scan(const std::vector<Tree>& trees, const Vec3& eye, std::size_t count) {
  std::vector<Vec3> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = 6.283185307179586 * std::fmod(0.7548776662466927 * static_cast<double>(k), 1.0);
    const double tilt =
        (std::fmod(0.5698402909980532 * static_cast<double>(k), 1.0) * 59.0 - 7.0) * 0.017453292519943295;
    const Vec3 ray{std::cos(tilt) * std::cos(turn), std::cos(tilt) * std::sin(turn), std::sin(tilt)};
    const double t = std::min(cast(trees, eye, ray), 60.0);
    points[k] = {eye.x + t * ray.x, eye.y + t * ray.y, eye.z + t * ray.z};
  }
  return points;
}

class Table {
 public:
  void row(const std::string& window, const std::string& what, std::vector<double> times) {
    if (times.empty()) return;
    std::sort(times.begin(), times.end());
    char line[160];
    std::snprintf(line, sizeof line, "%s,%s,%.3f,%.3f,%.3f\n", window.c_str(), what.c_str(), times.front(),
                  times[times.size() / 2], times.back());
    std::fputs(line, stdout);
    csv_ += line;
  }
  const std::string& csv() const { return csv_; }

 private:
  std::string csv_ = "window,job,least_ms,median_ms,max_ms\n";
};

struct Window {
  std::string name;
  Voxel dims;
  double cell, range;
};

/// Milliseconds of processor time: other programs do not count.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

struct Flight {
  explicit Flight(const MapSpec& spec) : words(tern::map_words(spec)) {
    if (map.bind(spec, words.data(), words.size()) != tern::Status::kOk) std::puts("bind refused");
  }
  /// Milliseconds until the job is done.
  double finish(double begin) {
    while (map.step(1u << 20) == tern::Status::kRunning) {
    }
    return now() - begin;
  }
  void follow(const Vec3& center) {
    const double before = now();
    if (map.follow(center) == tern::Status::kRunning) slides.push_back(finish(before));
  }
  std::vector<std::uint64_t> words;
  RollingMap map;
  std::vector<double> slides;
};

MapSpec spec_of(const Window& window) {
  const Vec3 origin{-0.5 * window.dims.x * window.cell, -0.5 * window.dims.y * window.cell, 0.0};
  MapSpec spec = tern::map_spec(origin, window.cell, window.dims, 0.3);
  spec.range = window.range;
  spec.pixels = 640 * 480;
  return spec;
}

/// First frames of an empty map, and frames in flight.
void measure_camera(Table& table, const Window& window, int width, int height) {
  const std::vector<Tree> trees = forest();
  Flight flight(spec_of(window));
  std::vector<std::uint16_t> z(static_cast<std::size_t>(width * height));
  tern::DepthView view{z.data(),           nullptr, width, height, width, 0.5 * width, 0.5 * width, 0.5 * (width - 1),
                       0.5 * (height - 1), 0.001,   0.1,   59.0};
  std::vector<double> frames;
  double first = 0.0;
  for (int k = 0; k < 60; ++k) {
    const Vec3 eye{0.1 * k, 0.0, 1.5};
    render(trees, eye, view, z);
    flight.follow(eye);
    const Pose pose{eye, {kAhead[0], kAhead[1], kAhead[2], kAhead[3]}};
    const double before = now();
    if (flight.map.begin_frame(view, pose, 0) != tern::Status::kRunning) std::puts("frame refused");
    (k == 0 ? first : frames.emplace_back()) = flight.finish(before);
  }
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  table.row(window.name, "first frame " + size, {first});
  table.row(window.name, "frame " + size, frames);
}

void measure_scans(Table& table, const Window& window, std::size_t count, double pixel) {
  const std::vector<Tree> trees = forest();
  MapSpec spec = spec_of(window);
  spec.scan_pixel = pixel;
  Flight flight(spec);
  std::vector<double> scans;
  for (int k = 0; k < 20; ++k) {
    const Vec3 eye{0.3 * k, 0.0, 1.5};
    const std::vector<Vec3> points = scan(trees, eye, count);
    flight.follow(eye);
    const double before = now();
    if (flight.map.begin_scan(points.data(), points.size(), eye, 0) != tern::Status::kRunning)
      std::puts("scan refused");
    scans.push_back(flight.finish(before));
  }
  table.row(window.name, "scan of " + std::to_string(count), scans);
}

/// Slides by one voxel along y and along z, and by a word along x.
void measure_slides(Table& table, const Window& window) {
  for (int a = 0; a < 3; ++a) {
    MapSpec spec = spec_of(window);
    spec.slack = 0;
    Flight flight(spec);
    Vec3 center{0.0, 0.0, 0.5 * window.dims.z * window.cell};
    flight.map.mark_box({{-3.0, -3.0, 0.0}, {3.0, 3.0, 1.0}});
    flight.follow(center);
    flight.slides.clear();
    for (int k = 0; k < 12; ++k) {
      (a == 0 ? center.x : a == 1 ? center.y : center.z) += a == 0 ? 64.0 * window.cell : window.cell;
      flight.follow(center);
    }
    table.row(window.name,
              a == 0   ? "slide along x by 64"
              : a == 1 ? "slide along y by 1"
                       : "slide along z by 1",
              flight.slides);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times of a rolling map: frames, scans and slides.");
  std::string csv_file;
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
  Table table;
  const Window windows[] = {{"200x200x40 at 0.2 m", {200, 200, 40}, 0.2, 10.0},
                            {"100x100x40 at 0.1 m", {100, 100, 40}, 0.1, 5.0}};
  for (const Window& window : windows) {
    const std::size_t words = tern::map_words(spec_of(window));
    std::printf("%s: %zu words\n", window.name.c_str(), words);
    measure_camera(table, window, 160, 120);
    measure_camera(table, window, 320, 240);
    measure_camera(table, window, 640, 480);
    measure_scans(table, window, 20000, 0.04);
    measure_scans(table, window, 100000, 0.02);
    measure_slides(table, window);
  }
  if (!csv_file.empty()) tern_host::write_file(csv_file, table.csv());
  return 0;
}
