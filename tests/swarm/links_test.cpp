// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Links that lose, delay, repeat and reorder packets as often as they say.
#include "host/swarm/links.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using tern_host::Links;
using tern_host::LinkSettings;
using tern_host::Packet;

constexpr int kPackets = 20000;
constexpr std::int64_t kStep = 10000000;

Packet packet_of(int number) {
  return std::vector<std::uint8_t>{static_cast<std::uint8_t>(number & 255), static_cast<std::uint8_t>(number >> 8)};
}

int number_of(const Packet& packet) {
  return packet.bytes()[0] + 256 * packet.bytes()[1];
}

/// The numbers of the packets of vehicle 0 as vehicle 1 gets them.
std::vector<int> heard_over(const LinkSettings& settings) {
  Links links(settings, 2, 5);
  std::vector<int> numbers;
  for (int k = 0; k < kPackets; ++k) {
    links.send(0, packet_of(k), k * kStep);
    for (const Packet& packet : links.receive(1, k * kStep)) numbers.push_back(number_of(packet));
  }
  for (const Packet& packet : links.receive(1, INT64_MAX)) numbers.push_back(number_of(packet));
  return numbers;
}

/// How many packets in a row are missing, on average.
double mean_gap(const std::vector<int>& heard) {
  int gaps = 0;
  int missing = 0;
  for (std::size_t k = 1; k < heard.size(); ++k) {
    missing += heard[k] - heard[k - 1] - 1;
    gaps += heard[k] - heard[k - 1] > 1 ? 1 : 0;
  }
  return gaps > 0 ? static_cast<double>(missing) / gaps : 0.0;
}

TEST(Links, LoseTheirPartAloneOrInBursts) {
  LinkSettings settings;
  settings.loss = 0.3;
  const std::vector<int> alone = heard_over(settings);
  EXPECT_NEAR(static_cast<double>(alone.size()) / kPackets, 0.7, 0.015);
  EXPECT_NEAR(mean_gap(alone), 1.0 / 0.7, 0.05);
  settings.burst = 10.0;
  const std::vector<int> bursts = heard_over(settings);
  EXPECT_NEAR(static_cast<double>(bursts.size()) / kPackets, 0.7, 0.04);
  EXPECT_NEAR(mean_gap(bursts), 10.0, 1.0);
  settings.loss = 1.0;
  EXPECT_TRUE(heard_over(settings).empty());
}

TEST(Links, DelayRepeatAndReorder) {
  LinkSettings settings;
  settings.delay_min = 0.1;
  settings.delay_max = 0.2;
  Links links(settings, 2, 5);
  links.send(0, packet_of(7), 0);
  EXPECT_TRUE(links.receive(1, 99999999).empty());
  EXPECT_EQ(links.receive(1, 200000000).size(), 1u);
  EXPECT_TRUE(links.receive(1, 400000000).empty());
  settings.repeated = 0.25;
  const std::vector<int> heard = heard_over(settings);
  EXPECT_NEAR(static_cast<double>(heard.size()) / kPackets, 1.25, 0.02);
  int overtaken = 0;
  for (std::size_t k = 1; k < heard.size(); ++k) overtaken += heard[k] < heard[k - 1] ? 1 : 0;
  EXPECT_GT(overtaken, kPackets / 10);
}

TEST(Links, PartitionsAndBrokenRadios) {
  LinkSettings settings;
  settings.partition = {1.0, 2.0};
  settings.deaf = 2;
  settings.silent = 3;
  settings.silent_from = 0.5;
  Links links(settings, 4, 5);
  const auto hears = [&](int from, int to, std::int64_t t) {
    links.send(from, packet_of(1), t);
    bool heard = false;
    for (int k = 0; k < 4; ++k) heard = !links.receive(k, t).empty() && k == to ? true : heard;
    return heard;
  };
  EXPECT_TRUE(hears(0, 1, 0));
  EXPECT_FALSE(hears(0, 1, 1500000000));
  EXPECT_TRUE(hears(1, 3, 1500000000));
  EXPECT_TRUE(hears(0, 1, 2000000000));
  EXPECT_FALSE(hears(0, 2, 0));
  EXPECT_TRUE(hears(2, 0, 0));
  EXPECT_TRUE(hears(3, 0, 400000000));
  EXPECT_FALSE(hears(3, 0, 500000000));
}

}  // namespace
