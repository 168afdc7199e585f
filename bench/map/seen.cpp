// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free means seen, over as many random frames and scans as you like (as in the tests); and how much of what ray casting
// calls free a frame saw whole.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "map/ray_cast.hpp"
#include "map/scene.hpp"
#include "support/seen_reference.hpp"
#include "support/seen_scan.hpp"

namespace {

using tern::MapSpec;
using tern::Vec3;
using tern_bench::Window;
using tern_test::SeenCounts;

class Output {
 public:
  void line(const std::string& text) {
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
    text_ += text + "\n";
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void frame_row(Output& out, std::uint64_t seed, const SeenCounts& c) {
  out.line("| " + std::to_string(seed) + " | " + std::to_string(c.frames) + " | " + std::to_string(c.shown) + " | " +
           std::to_string(c.wrong) + " | " + std::to_string(c.could_be) + " | " + std::to_string(c.hits) + " | " +
           std::to_string(c.missed) + " |");
}

void scan_row(Output& out, std::uint64_t seed, const SeenCounts& c) {
  out.line("| " + std::to_string(seed) + " | " + std::to_string(c.frames) + " | " + std::to_string(c.shown) + " | " +
           std::to_string(c.could_be) + " | " + std::to_string(c.wrong) + " | " + std::to_string(c.hits) + " | " +
           std::to_string(c.missed) + " |");
}

/// Frames into empty maps, on the way through the forest.
void cast_row(Output& out, tern_bench::Forest& forest, const Window& window, int width, int height, bool margins) {
  MapSpec spec = tern_bench::spec_of(window, width * height, 0.0);
  if (!margins) spec.depth_margin = spec.pose_margin = 0.0;
  std::vector<std::uint16_t> z(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const tern::DepthView view = tern_bench::camera(z.data(), width, height);
  long long cast = 0, both = 0, seen = 0;
  for (int k = 0; k < 20; ++k) {
    const Vec3 eye{0.3 * k, 0.0, 1.5};
    forest.look_from(eye, 12.0);
    tern_bench::render(forest, view, z.data());
    tern_test::OwnedMap owned(spec);
    owned.map.begin_frame(view, tern_bench::looking_ahead(eye), 0);
    tern_test::finish(owned.map);
    tern_bench::RayCast rays(spec);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const double depth = 0.001 * z[static_cast<std::size_t>(v * width + u)];
        const Vec3 ray{1.0, -(u - view.cx) / view.fx, -(v - view.cy) / view.fy};
        rays.pass(eye, ray, depth < spec.range ? depth : spec.range);
      }
    }
    tern_test::for_each_voxel(spec.dims, [&](const tern::Voxel& voxel) {
      const bool by_rays = rays.free(voxel), whole = owned.map.seen(voxel);
      cast += by_rays ? 1 : 0;
      seen += whole ? 1 : 0;
      both += by_rays && whole ? 1 : 0;
    });
  }
  char line[200];
  std::snprintf(line, sizeof line, "| %s, %.0f m | %dx%d | %s | %lld | %lld | %.1f %% |", window.name, window.range,
                width, height, margins ? "0.05 m" : "none", cast / 20, seen / 20,
                100.0 * static_cast<double>(both) / static_cast<double>(cast));
  out.line(line);
}

void cast_table(Output& out) {
  tern_bench::Forest forest;
  out.line("| window, range | image | margins | free by rays | seen whole | of the rays' voxels seen whole |");
  out.line("| --- | --- | --- | --- | --- | --- |");
  const Window windows[] = {{"200x200x40 at 0.2 m", {200, 200, 40}, 0.2, 10.0},
                            {"100x100x40 at 0.1 m", {100, 100, 40}, 0.1, 5.0},
                            {"200x200x40 at 0.1 m", {200, 200, 40}, 0.1, 10.0}};
  for (const Window& window : windows) {
    for (const int width : {160, 320, 640}) {
      for (const bool margins : {false, true}) cast_row(out, forest, window, width, width * 3 / 4, margins);
    }
  }
}

/// A random depth in one pixel of a hundred.
void spoil(tern_test::Random& random, std::vector<std::uint16_t>& z, double range) {
  for (std::uint16_t& number : z) {
    if (random.chance(0.01)) number = static_cast<std::uint16_t>(1000.0 * random.real(0.2, range));
  }
}

/// The same flight with clean images and with spoilt ones: voxels that only the spoilt ones block, and what is left of
/// the voxels that are free in the safe grid.
void outlier_row(Output& out, tern_bench::Forest& forest, std::int32_t hits, std::int32_t support) {
  const Window window{"", {200, 200, 40}, 0.2, 10.0};
  MapSpec spec = tern_bench::spec_of(window, 320 * 240, 0.0);
  spec.hits = hits;
  spec.support = support;
  tern_test::OwnedMap clean(spec), spoilt(spec);
  std::vector<std::uint16_t> z(320 * 240);
  const tern::DepthView view = tern_bench::camera(z.data(), 320, 240);
  tern_test::Random random(5);
  for (int k = 0; k < 30; ++k) {
    const Vec3 eye{0.1 * k, 0.0, 1.5};
    forest.look_from(eye, 12.0);
    tern_bench::render(forest, view, z.data());
    clean.map.begin_frame(view, tern_bench::looking_ahead(eye), 0);
    tern_test::finish(clean.map);
    spoil(random, z, spec.range);
    spoilt.map.begin_frame(view, tern_bench::looking_ahead(eye), 0);
    tern_test::finish(spoilt.map);
  }
  long long wrong = 0, free = 0, left = 0;
  tern_test::for_each_voxel(spec.dims, [&](const tern::Voxel& v) {
    wrong += spoilt.map.route().obstacle(v) && !clean.map.route().obstacle(v) ? 1 : 0;
    free += clean.map.safe().free(v) ? 1 : 0;
    left += clean.map.safe().free(v) && spoilt.map.safe().free(v) ? 1 : 0;
  });
  char line[160];
  std::snprintf(line, sizeof line, "| %d | %d | %lld | %.1f %% |", hits, support, wrong,
                100.0 * static_cast<double>(left) / static_cast<double>(free));
  out.line(line);
}

void outlier_table(Output& out) {
  tern_bench::Forest forest;
  out.line("| hits | support | voxels blocked wrongly | of the free voxels still free |");
  out.line("| --- | --- | --- | --- |");
  for (const std::int32_t hits : {1, 2, 4}) {
    for (const std::int32_t support : {0, 1, 2}) outlier_row(out, forest, hits, support);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Free means seen: random frames and scans against a slow reference, against ray casting, and with outliers.");
  int frames = 2000, scans = 200;
  std::uint64_t seed = 1;
  std::string file;
  app.add_option("--frames", frames, "Random depth frames")->capture_default_str();
  app.add_option("--scans", scans, "Random scans")->capture_default_str();
  app.add_option("--seed", seed, "Seed of both")->capture_default_str();
  app.add_option("--out", file, "Write the tables to a file as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
  Output out;
  SeenCounts of_frames, of_scans;
  tern_test::Random random(seed);
  for (int k = 0; k < frames; ++k) of_frames.add(check_frame(random, tern_test::random_spec(random)));
  for (int k = 0; k < scans; ++k) of_scans.add(check_scan(random, tern_test::random_scan_spec(random)));
  out.line("| seed | frames | voxels called seen | of them not wholly seen | wholly seen | hits | of them lost |");
  out.line("| --- | --- | --- | --- | --- | --- | --- |");
  frame_row(out, seed, of_frames);
  out.line("");
  out.line(
      "| seed | scans | voxels called seen | voxels that hold a thing | of them called seen | hits | of them lost |");
  out.line("| --- | --- | --- | --- | --- | --- | --- |");
  scan_row(out, seed, of_scans);
  out.line("");
  cast_table(out);
  out.line("");
  outlier_table(out);
  if (!file.empty()) tern_host::write_file(file, out.text());
  const bool right = of_frames.wrong + of_frames.missed + of_frames.refused == 0 &&
                     of_scans.wrong + of_scans.missed + of_scans.refused == 0;
  return right ? 0 : 1;
}
