// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rolling map through C: the same map as through C++, and an answer to every call that comes too early.
#include <gtest/gtest.h>

#include <cmath>

#include "support/owned_map.hpp"
#include "tern/tern_map.h"

namespace {

constexpr std::uint8_t kOk = 0;
constexpr auto kInvalid = static_cast<std::uint8_t>(tern::Status::kInvalidArgument);
constexpr auto kRunning = static_cast<std::uint8_t>(tern::Status::kRunning);

tern_map_spec small_spec() {
  tern_map_spec spec;
  const tern_vec3 origin{0.0, 0.0, 0.0};
  tern_map_spec_init(&spec, &origin, 0.1, {70, 20, 20}, 0.2);
  spec.pixels = 4096;
  spec.scan_pixel = 0.2;
  return spec;
}

void finish(tern_map& map) {
  while (tern_map_step(&map, 100) == kRunning) {
  }
}

TEST(MapC, EqualsTheMapInCpp) {
  const tern_map_spec spec = small_spec();
  std::vector<std::uint64_t> words(tern_map_words(&spec));
  tern_map map{};
  std::uint8_t field = 99;
  ASSERT_EQ(tern_map_bind(&map, &spec, words.data(), words.size(), &field), kOk);
  EXPECT_EQ(field, 0);
  tern_test::OwnedMap owned(spec);
  tern_test::Image image(41, 41, 20.0);
  for (float& z : image.z) z = 2.05f;
  const tern_pose pose{{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}};
  const tern_vec3 point{1.5, 1.2, 0.7};
  const tern_box box{point, {1.7, 1.9, 0.9}};
  const tern_cylinder trunk{{1.9, 0.6, 0.0}, 0.15, 1.0};

  ASSERT_EQ(tern_map_assume_free(&map, &pose.position, 0.5), kOk);
  ASSERT_EQ(tern_map_assume_column(&map, &trunk), kOk);
  ASSERT_EQ(tern_map_mark_box(&map, &box), kOk);
  ASSERT_EQ(tern_map_mark_cylinder(&map, &trunk), kOk);
  ASSERT_EQ(tern_map_mark_points(&map, &point, 1), kOk);
  EXPECT_EQ(tern_map_busy(&map), 0);
  ASSERT_EQ(tern_map_begin_frame(&map, &image.view, &pose, 5), kRunning);
  EXPECT_EQ(tern_map_busy(&map), 1);
  finish(map);
  EXPECT_EQ(tern_map_busy(&map), 0);
  ASSERT_EQ(tern_map_begin_scan(&map, &point, 1, &pose.position, 6), kRunning);
  finish(map);
  const float ranges[] = {INFINITY, 0.7f};
  const tern_vec3 ways[] = {{1.0, 0.1, 0.2}, {0.0, 0.0, -1.0}};
  const tern_beams beams{ways, ranges, 2, 0.1, 50.0};
  EXPECT_EQ(tern_map_begin_beams(&map, &beams, &pose.position, 5 - tern::kMaxFrameDelay),
            static_cast<uint8_t>(tern::Status::kClockBehind));
  ASSERT_EQ(tern_map_forget_time(&map), kOk);
  ASSERT_EQ(tern_map_begin_beams(&map, &beams, &pose.position, 4), kRunning);
  finish(map);
  ASSERT_EQ(tern_map_follow(&map, &box.upper), kRunning);
  finish(map);

  ASSERT_EQ(owned.map.assume_free(pose.position, 0.5), tern::Status::kOk);
  ASSERT_EQ(owned.map.assume_column(trunk), tern::Status::kOk);
  ASSERT_EQ(owned.map.mark_box(box), tern::Status::kOk);
  ASSERT_EQ(owned.map.mark_cylinder(trunk), tern::Status::kOk);
  ASSERT_EQ(owned.map.mark_points(&point, 1), tern::Status::kOk);
  ASSERT_EQ(owned.map.begin_frame(image.view, pose, 5), tern::Status::kRunning);
  tern_test::finish(owned.map);
  ASSERT_EQ(owned.map.begin_scan(&point, 1, pose.position, 6), tern::Status::kRunning);
  tern_test::finish(owned.map);
  ASSERT_EQ(owned.map.begin_scan(beams, pose.position, 7), tern::Status::kRunning);
  tern_test::finish(owned.map);
  ASSERT_EQ(owned.map.follow(box.upper), tern::Status::kRunning);
  tern_test::finish(owned.map);

  for (int x = 0; x < 70; ++x) {
    EXPECT_EQ(tern_map_seen(&map, {x, 10, 10}) != 0, owned.map.seen({x, 10, 10})) << x;
  }
  tern_grid route{};
  tern_grid safe{};
  ASSERT_EQ(tern_map_route(&map, &route), kOk);
  ASSERT_EQ(tern_map_safe(&map, &safe), kOk);
  // Both are grids that the C interface takes.
  EXPECT_EQ(tern_grid_inflate(&route), kOk);
  EXPECT_EQ(tern_grid_inflate(&safe), kOk);
  EXPECT_GT(tern_map_revision(&map), 0u);
  tern_grid snapshot{};
  std::vector<std::uint64_t> copy(tern_grid_words(spec.dims));
  EXPECT_EQ(tern_map_snapshot(&map, &snapshot, copy.data(), copy.size() - 1), kInvalid);
  EXPECT_EQ(tern_map_snapshot(&map, nullptr, copy.data(), copy.size()), kInvalid);
  for (int k = 0; k < 2; ++k) {
    ASSERT_EQ(tern_map_snapshot(&map, &snapshot, copy.data(), copy.size()), kOk);
    EXPECT_EQ(tern_grid_inflate(&snapshot), kOk);
  }
  ASSERT_EQ(tern_map_begin_snapshot(&map, &snapshot, copy.data(), copy.size()), kRunning);
  EXPECT_EQ(tern_map_begin_snapshot(&map, &snapshot, copy.data(), copy.size()), kInvalid);
  EXPECT_EQ(tern_map_step(&map, 1u << 20), kOk);
  EXPECT_EQ(tern_grid_inflate(&snapshot), kOk);
}

TEST(MapC, NullPointersHaveAnswers) {
  const tern_map_spec spec = small_spec();
  std::vector<std::uint64_t> words(tern_map_words(&spec));
  tern_map map{};
  ASSERT_EQ(tern_map_bind(&map, &spec, words.data(), words.size(), nullptr), kOk);
  const tern_vec3 point{1.0, 1.0, 1.0};
  const tern_pose pose{point, {1.0, 0.0, 0.0, 0.0}};
  const tern_depth_view view{};
  EXPECT_EQ(tern_map_begin_frame(&map, nullptr, &pose, 0), kInvalid);
  EXPECT_EQ(tern_map_begin_frame(&map, &view, nullptr, 0), kInvalid);
  EXPECT_EQ(tern_map_begin_scan(&map, &point, 1, nullptr, 0), kInvalid);
  const tern_beams beams{nullptr, nullptr, 0, 0.0, 1.0};
  EXPECT_EQ(tern_map_begin_beams(&map, nullptr, &point, 0), kInvalid);
  EXPECT_EQ(tern_map_begin_beams(&map, &beams, nullptr, 0), kInvalid);
  EXPECT_EQ(tern_map_follow(&map, nullptr), kInvalid);
  EXPECT_EQ(tern_map_assume_free(&map, nullptr, 1.0), kInvalid);
  EXPECT_EQ(tern_map_assume_column(&map, nullptr), kInvalid);
  EXPECT_EQ(tern_map_mark_box(&map, nullptr), kInvalid);
  EXPECT_EQ(tern_map_mark_cylinder(&map, nullptr), kInvalid);
  EXPECT_EQ(tern_map_route(&map, nullptr), kInvalid);
  EXPECT_EQ(tern_map_safe(&map, nullptr), kInvalid);
  EXPECT_EQ(tern_map_begin_snapshot(&map, nullptr, nullptr, 0), kInvalid);
  tern_map_spec kept = spec;
  tern_map_spec_init(&kept, nullptr, 0.5, {1, 1, 1}, 0.2);
  EXPECT_EQ(kept.cell, spec.cell);
  tern_map_spec_init(nullptr, &point, 0.5, {1, 1, 1}, 0.2);
}

TEST(MapC, ACppMapThatIsNotBoundHasAnswers) {
  tern::RollingMap map;
  tern::Box added{};
  EXPECT_EQ(map.learned(), 0u);
  EXPECT_EQ(map.seen_rows(), nullptr);
  EXPECT_EQ(map.frame_work(10, 10), 0u);
  EXPECT_FALSE(map.take_added(added));
  tern_test::OwnedMap owned(small_spec());
  EXPECT_EQ(owned.map.frame_work(0, 10), 0u);
  EXPECT_EQ(owned.map.frame_work(10, 0), 0u);
  EXPECT_GT(owned.map.frame_work(10, 10), 0u);
  EXPECT_FALSE(owned.map.seen({70, 0, 0}));
}

TEST(MapC, AnswersWithoutAMap) {
  tern_map map{};
  tern_grid grid{};
  const tern_vec3 point{};
  const tern_box box{};
  const tern_pose pose{};
  const tern_depth_view view{};
  const tern_cylinder trunk{};
  const tern_map_spec spec = small_spec();
  for (tern_map* none : {&map, static_cast<tern_map*>(nullptr)}) {
    EXPECT_EQ(tern_map_begin_frame(none, &view, &pose, 0), kInvalid);
    EXPECT_EQ(tern_map_begin_scan(none, &point, 1, &point, 0), kInvalid);
    const tern_beams beams{nullptr, nullptr, 0, 0.0, 1.0};
    EXPECT_EQ(tern_map_begin_beams(none, &beams, &point, 0), kInvalid);
    EXPECT_EQ(tern_map_follow(none, &point), kInvalid);
    EXPECT_EQ(tern_map_step(none, 1), kInvalid);
    EXPECT_EQ(tern_map_busy(none), 0);
    EXPECT_EQ(tern_map_assume_free(none, &point, 1.0), kInvalid);
    EXPECT_EQ(tern_map_mark_box(none, &box), kInvalid);
    EXPECT_EQ(tern_map_mark_cylinder(none, &trunk), kInvalid);
    EXPECT_EQ(tern_map_mark_points(none, &point, 1), kInvalid);
    EXPECT_EQ(tern_map_route(none, &grid), kInvalid);
    EXPECT_EQ(tern_map_safe(none, &grid), kInvalid);
    EXPECT_EQ(tern_map_snapshot(none, &grid, nullptr, 0), kInvalid);
    EXPECT_EQ(tern_map_begin_snapshot(none, &grid, nullptr, 0), kInvalid);
    EXPECT_EQ(tern_map_seen(none, {0, 0, 0}), 0);
    EXPECT_EQ(tern_map_revision(none), 0u);
  }
  EXPECT_EQ(tern_map_words(nullptr), 0u);
  EXPECT_EQ(tern_map_bind(nullptr, &spec, nullptr, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_map_bind(&map, nullptr, nullptr, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_map_bind(&map, &spec, nullptr, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_map_step(&map, 1), kInvalid);
  tern_map_spec_init(nullptr, &point, 0.1, {1, 1, 1}, 0.0);
}

}  // namespace
