// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Jobs of rolling maps. A vehicle flies through a forest; of each kind of job the most expensive one counts. Some jobs
// are done in one call and counted, others unit by unit, which gives the work and the longest unit.
#include "timing/map_rows.hpp"

#include <cstddef>
#include <cstdint>

#include "baremetal/board.hpp"
#include "map/scene.hpp"

namespace tern_timing {
namespace {

using tern::RollingMap;
using tern::Status;
using tern::Vec3;
using tern_bench::Window;

/// A window, and the sensors that fly in it.
struct MapCase {
  Window window;
  std::int32_t width, height;
  double scan_pixel;  ///< 0: no scans
};

constexpr MapCase kMapCases[] = {{{"map_200x200x40", {200, 200, 40}, 0.2, 10.0}, 320, 240, 0.02},
                                 {{"map_100x100x40", {100, 100, 40}, 0.1, 5.0}, 320, 240, 0.02},
                                 {{"map_64x64x32", {64, 64, 32}, 0.25, 6.0}, 80, 60, 0.0}};
constexpr int kFrames = 6;
constexpr int kScans = 2;
constexpr std::size_t kPoints = 100000;
/// Trees further away are not drawn: nothing looks so far.
constexpr double kSight = 12.0;
constexpr std::int32_t kMostPixels = 6 * 128 * 128;
constexpr std::size_t kMapWords = 1 << 19;

TERN_BOARD_LARGE std::uint64_t words[kMapWords];
TERN_BOARD_LARGE std::uint64_t copy_words[kMapWords / 2];
TERN_BOARD_LARGE std::uint16_t image[kMostPixels];
TERN_BOARD_LARGE Vec3 points[kPoints];
tern_bench::Forest forest;

std::int32_t pixels_of(const MapCase& input) {
  return input.scan_pixel > 0.0 ? kMostPixels : input.width * input.height;
}

/// The most expensive job of a kind.
struct Most {
  std::uint64_t count = 0;
  std::uint32_t work = 0;
};

/// A map in flight, and the longest step(1) of all its jobs.
class Flight {
 public:
  explicit Flight(const MapCase& input) : input_(input) {
    tern::MapSpec spec = spec_of(input.window, pixels_of(input), input.scan_pixel);
    spec.slack = 0;
    ok_ = map_.bind(spec, words, kMapWords) == Status::kOk;
  }

  RollingMap& map() { return map_; }
  bool ok() const { return ok_; }
  std::uint64_t longest() const { return longest_; }

  void finish(Status begun, std::uint64_t before, Most& most) {
    ok_ = ok_ && begun == Status::kRunning && map_.step(~std::uint32_t{0}) == Status::kOk;
    const std::uint64_t count = tern_board::counter() - before;
    if (count > most.count) most.count = count;
  }
  void finish_in_units(Status begun, Most& most) {
    std::uint32_t work = 0;
    Status status = begun;
    while (status == Status::kRunning) {
      const std::uint64_t before = tern_board::counter();
      status = map_.step(1);
      const std::uint64_t count = tern_board::counter() - before;
      if (count > longest_) longest_ = count;
      ++work;
    }
    ok_ = ok_ && status == Status::kOk;
    if (work > most.work) most.work = work;
  }

  Status begin_frame(const Vec3& eye) {
    const tern::DepthView view = tern_bench::camera(image, input_.width, input_.height);
    forest.look_from(eye, kSight);
    render(forest, view, image);
    return map_.begin_frame(view, tern_bench::looking_ahead(eye), 0);
  }
  Status begin_scan(const Vec3& eye) {
    forest.look_from(eye, kSight);
    tern_bench::scan(forest, eye, kPoints, points);
    return map_.begin_scan(points, kPoints, eye, 0);
  }

 private:
  const MapCase& input_;
  RollingMap map_;
  bool ok_ = false;
  std::uint64_t longest_ = 0;
};

void row(const MapCase& input, const char* job, const Most& most, std::uint32_t bound) {
  tern_board::print(input.window.name, ",", job, ",", most.count, ",", most.work, ",", bound, "\n");
}

/// The first frame of an empty map, and frames in flight; every other one unit by unit.
void fly(const MapCase& input, Flight& flight) {
  Most first, frames, copy;
  tern::Grid grid;
  for (int k = 0; k < kFrames; ++k) {
    const Vec3 eye{0.1 * k, 0.0, 1.5};
    const Status begun = flight.begin_frame(eye);
    if (k % 2 == 1) {
      flight.finish_in_units(begun, frames);
    } else {
      flight.finish(begun, tern_board::counter(), k == 0 ? first : frames);
    }
  }
  for (int k = 0; k < 2; ++k) {
    const std::uint64_t before = tern_board::counter();
    const Status begun = flight.map().begin_snapshot(grid, copy_words, kMapWords / 2);
    k == 0 ? flight.finish_in_units(begun, copy) : flight.finish(begun, before, copy);
  }
  const std::uint32_t bound = flight.map().frame_work(input.width, input.height);
  row(input, "first frame", first, bound);
  row(input, "frame", frames, bound);
  row(input, "snapshot", copy, flight.map().scan_work(0));
}

void scan_twice(const MapCase& input, Flight& flight) {
  Most scans;
  for (int k = 0; k < kScans; ++k) {
    const Status begun = flight.begin_scan({0.3 * k, 0.0, 1.5});
    k == 0 ? flight.finish_in_units(begun, scans) : flight.finish(begun, tern_board::counter(), scans);
  }
  row(input, "scan", scans, flight.map().scan_work(kPoints));
}

/// By one voxel along y and along z, and by a word along x: there, then back.
void slide(const MapCase& input, Flight& flight, int a, const char* name) {
  Most slides;
  const tern::Voxel dims = input.window.dims;
  const tern::Grid& route = flight.map().route();
  const Vec3 local = route.center({dims.x / 2, dims.y / 2, dims.z / 2});
  const Vec3 origin = route.spec().origin;
  Vec3 center{origin.x + local.x, origin.y + local.y, origin.z + local.z};
  for (int k = 0; k < 2; ++k) {
    const double by = (a == 0 ? 64.0 : 1.0) * input.window.cell * (k == 0 ? 1.0 : -1.0);
    (a == 0 ? center.x : a == 1 ? center.y : center.z) += by;
    const std::uint64_t before = tern_board::counter();
    const Status begun = flight.map().follow(center);
    k == 0 ? flight.finish_in_units(begun, slides) : flight.finish(begun, before, slides);
  }
  row(input, name, slides, flight.map().scan_work(0));
}

}  // namespace

bool print_map_rows() {
  bool ok = true;
  for (const MapCase& input : kMapCases) {
    if (pixels_of(input) > tern::kMaxPixels) continue;
    Flight flight(input);
    fly(input, flight);
    if (input.scan_pixel > 0.0) scan_twice(input, flight);
    slide(input, flight, 0, "slide x");
    slide(input, flight, 1, "slide y");
    slide(input, flight, 2, "slide z");
    const Most unit{flight.longest(), 1};
    row(input, "map unit", unit, 1);
    ok = ok && flight.ok();
  }
  return ok;
}

}  // namespace tern_timing
