// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The watch of what frames do to a map must notice a map that calls free what it has not seen, or what was hit.
#include "host/flight/frame_watch.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "host/flight/depth_camera.hpp"
#include "support/watched_room.hpp"

namespace {

using tern_host::DepthFrame;
using tern_host::FlightWorld;
using tern_host::FrameWatch;
using tern_test::says;
using tern_test::WatchedRoom;

/// Frames of a room, entered one after the other into a map that knows nothing, or all; the watch is shown `then` in
/// the place of each.
struct FrameCase {
  bool known = false;
  int frames = 1;
  DepthFrame shown, then;
};

std::string after_frames(WatchedRoom& w, const FrameCase& c) {
  std::uint64_t looked_at = 0;
  std::int64_t t = 0;
  for (int k = 0; k < 20; ++k) {
    FrameWatch watch(w.world, w.map_spec, w.map);
    w.map.bind(w.map_spec, w.map_words.data(), w.map_words.size());
    if (c.known) w.know_all();
    for (int frame = 0; frame < c.frames; ++frame) {
      watch.before(c.shown);
      EXPECT_EQ(w.map.begin_frame(c.shown.view, c.shown.pose, t++), tern::Status::kRunning);
      while (w.map.step(100000) == tern::Status::kRunning) {
      }
      watch.after(c.then);
    }
    looked_at += watch.seen() + watch.hits();
    if (!watch.broken().empty()) return watch.broken();
  }
  EXPECT_GT(looked_at, 0u);
  return "";
}

DepthFrame frame_of(const FlightWorld& world, double farther = 1.0) {
  tern_host::Noise noise(1);
  DepthFrame frame = take_frame(world, world.start, 0.0, 0, noise);
  for (float& depth : frame.depths) depth *= static_cast<float>(farther);
  return frame;
}

TEST(FrameWatch, IsContentWithASoundMap) {
  WatchedRoom w;
  EXPECT_EQ(after_frames(w, {false, 1, frame_of(w.world), frame_of(w.world)}), "");
}

TEST(FrameWatch, NoticesVoxelsThatWereNotSeenWhole) {
  WatchedRoom w;
  EXPECT_TRUE(says(after_frames(w, {false, 1, frame_of(w.world), frame_of(w.world, 0.5)}), "not seen whole"));
}

TEST(FrameWatch, NoticesHitsThatStayFree) {
  WatchedRoom w;
  EXPECT_TRUE(says(after_frames(w, {true, 1, frame_of(w.world, 1.6), frame_of(w.world)}), "was hit and is free"));
}

/// Where several hits make an obstacle, that many frames do, and fewer need not.
TEST(FrameWatch, CountsHits) {
  WatchedRoom w;
  w.map_spec.hits = 3;
  w.map_spec.support = 2;
  EXPECT_EQ(after_frames(w, {true, 3, frame_of(w.world), frame_of(w.world)}), "");
  EXPECT_TRUE(says(after_frames(w, {true, 3, frame_of(w.world, 1.6), frame_of(w.world)}), "was hit and is free"));
}

/// A map that needs more hits than the watch was told.
TEST(FrameWatch, NoticesAVoxelThatNeedsMoreHits) {
  WatchedRoom w;
  tern::MapSpec told = w.map_spec;
  told.hits = 2;
  w.map_spec.hits = 3;
  std::swap(told, w.map_spec);
  FrameWatch watch(w.world, w.map_spec, w.map);
  w.map.bind(told, w.map_words.data(), w.map_words.size());
  w.know_all();
  const DepthFrame frame = frame_of(w.world);
  for (int k = 0; k < 2; ++k) {
    watch.before(frame);
    EXPECT_EQ(w.map.begin_frame(frame.view, frame.pose, k), tern::Status::kRunning);
    while (w.map.step(100000) == tern::Status::kRunning) {
    }
    watch.after(frame);
  }
  EXPECT_TRUE(says(watch.broken(), "was hit and is free"));
}

/// A pixel whose neighbours are all elsewhere hits nothing, and so need not.
TEST(FrameWatch, LeavesLonePixelsOut) {
  WatchedRoom w;
  w.map_spec.support = 1;
  DepthFrame lone = frame_of(w.world);
  for (std::size_t k = 0; k < lone.depths.size(); ++k) {
    lone.depths[k] = static_cast<float>(2.0 + 0.5 * static_cast<double>((k % 2 + 2 * (k / 160 % 2))));
  }
  lone.view.z32 = lone.depths.data();
  FrameWatch watch(w.world, w.map_spec, w.map);
  watch.before(lone);
  watch.after(lone);
  EXPECT_EQ(watch.hits(), 0u);
}

}  // namespace
