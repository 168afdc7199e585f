// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What frames, scans, slides and snapshots of a rolling map cost: a vehicle flies at 3 m/s through a forest, with a
// depth camera at 30 Hz or a lidar at 10 Hz, and the window follows it. The sensor's images are made beforehand. The
// same flight is flown several times; of each job the least time counts, since other programs can only add to it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "map/scene.hpp"

namespace {

using tern::MapSpec;
using tern::RollingMap;
using tern::Status;
using tern::Vec3;
using tern_bench::Window;

/// Behind the trees, rays end here.
constexpr double kSight = 40.0;

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

/// Milliseconds of processor time: other programs do not count.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// The least time of each job of a flight, in the order in which they were done.
class Times {
 public:
  void begin_flight() { next_ = 0; }
  void add(double milliseconds) {
    if (next_ == least_.size()) least_.push_back(milliseconds);
    least_[next_] = std::min(least_[next_], milliseconds);
    ++next_;
  }
  const std::vector<double>& least() const { return least_; }

 private:
  std::vector<double> least_;
  std::size_t next_ = 0;
};

struct Flight {
  explicit Flight(const MapSpec& spec) : words(tern::map_words(spec)) {
    if (map.bind(spec, words.data(), words.size()) != Status::kOk) std::puts("bind refused");
  }
  /// Does a job that begin() begins.
  template <typename Begin>
  void run(Times& times, Begin begin) {
    const double before = now();
    Status status = begin();
    if (status == Status::kOk) return;
    while (status == Status::kRunning) status = map.step(1u << 20);
    if (status != Status::kOk) std::puts("job refused");
    times.add(now() - before);
  }
  void follow(Times& times, const Vec3& center) {
    run(times, [&] { return map.follow(center); });
  }
  std::vector<std::uint64_t> words;
  RollingMap map;
};

struct Bench {
  int flights;
  tern_bench::Forest forest;
  Table table;

  MapSpec spec(const Window& window) const { return tern_bench::spec_of(window, 640 * 480, 0.0); }

  /// First frames of an empty map, frames in flight, and snapshots.
  void camera(const Window& window, int width, int height) {
    const int count = 60;
    std::vector<std::vector<std::uint16_t>> images(count);
    tern::DepthView view = tern_bench::camera(nullptr, width, height);
    for (int k = 0; k < count; ++k) {
      images[k].resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
      forest.look_from(eye(0.1 * k), kSight);
      tern_bench::render(forest, view, images[k].data());
    }
    Times first, frames, slides, snapshots;
    for (int flown = 0; flown < flights; ++flown) {
      Flight flight(spec(window));
      tern::Grid copy;
      std::vector<std::uint64_t> words(tern::grid_words(window.dims));
      for (Times* times : {&first, &frames, &slides, &snapshots}) times->begin_flight();
      for (int k = 0; k < count; ++k) {
        flight.follow(slides, eye(0.1 * k));
        view.z16 = images[k].data();
        flight.run(k == 0 ? first : frames,
                   [&] { return flight.map.begin_frame(view, tern_bench::looking_ahead(eye(0.1 * k)), 0); });
        flight.run(snapshots, [&] { return flight.map.begin_snapshot(copy, words.data(), words.size()); });
      }
    }
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    table.row(window.name, "first frame " + size, first.least());
    table.row(window.name, "frame " + size, frames.least());
    if (width == 320) table.row(window.name, "snapshot", snapshots.least());
  }

  void scans(const Window& window, std::size_t points, double pixel) {
    const int count = 20;
    std::vector<std::vector<Vec3>> scans(count, std::vector<Vec3>(points));
    for (int k = 0; k < count; ++k) {
      forest.look_from(eye(0.3 * k), kSight);
      tern_bench::scan(forest, eye(0.3 * k), points, scans[k].data());
    }
    MapSpec with_scans = spec(window);
    with_scans.scan_pixel = pixel;
    Times times, slides;
    for (int flown = 0; flown < flights; ++flown) {
      Flight flight(with_scans);
      times.begin_flight();
      slides.begin_flight();
      for (int k = 0; k < count; ++k) {
        flight.follow(slides, eye(0.3 * k));
        flight.run(times, [&] { return flight.map.begin_scan(scans[k].data(), points, eye(0.3 * k), 0); });
      }
    }
    table.row(window.name, "scan of " + std::to_string(points), times.least());
  }

  /// By one voxel along y and along z, and by a word along x.
  void slides(const Window& window) {
    const char* const names[] = {"slide along x by 64", "slide along y by 1", "slide along z by 1"};
    for (int a = 0; a < 3; ++a) {
      MapSpec eager = spec(window);
      eager.slack = 0;
      Times times, unused;
      for (int flown = 0; flown < flights; ++flown) {
        Flight flight(eager);
        Vec3 center{0.0, 0.0, 0.5 * window.dims.z * window.cell};
        flight.map.mark_box({{-3.0, -3.0, 0.0}, {3.0, 3.0, 1.0}});
        flight.follow(unused, center);
        times.begin_flight();
        for (int k = 0; k < 12; ++k) {
          (a == 0 ? center.x : a == 1 ? center.y : center.z) += a == 0 ? 64.0 * window.cell : window.cell;
          flight.follow(times, center);
        }
      }
      table.row(window.name, names[a], times.least());
    }
  }

  static Vec3 eye(double x) { return {x, 0.0, 1.5}; }
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times of a rolling map: frames, scans, slides and snapshots.");
  std::string csv_file;
  int flights = 5;
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  app.add_option("--flights", flights, "Fly so many times, and take each job's least time")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  Bench bench{flights, {}, {}};
  const Window windows[] = {{"200x200x40 at 0.2 m", {200, 200, 40}, 0.2, 10.0},
                            {"100x100x40 at 0.1 m", {100, 100, 40}, 0.1, 5.0},
                            {"64x64x32 at 0.25 m", {64, 64, 32}, 0.25, 6.0}};
  for (const Window& window : windows) {
    std::printf("%s: %zu words\n", window.name, tern::map_words(bench.spec(window)));
    if (window.dims.x == 64) {
      bench.camera(window, 80, 60);
      continue;
    }
    bench.camera(window, 160, 120);
    bench.camera(window, 320, 240);
    bench.camera(window, 640, 480);
    bench.scans(window, 20000, 0.04);
    bench.scans(window, 100000, 0.02);
    bench.slides(window);
  }
  if (!csv_file.empty()) tern_host::write_file(csv_file, bench.table.csv());
  return 0;
}
