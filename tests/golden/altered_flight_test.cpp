// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of flights that are not as they were written: the first difference is named, and what no recorder writes is
// refused with the reason.
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include "golden/recorded_flight.hpp"
#include "host/flight/flight_replay.hpp"
#include "tern/record.hpp"

namespace {

using namespace tern_golden;

std::uint64_t word_at(const std::string& bytes, std::size_t at) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

/// Replaces a word, and gives the record the length and the checksum that belong to it.
std::string forged(std::string bytes, std::size_t at, std::uint64_t word) {
  std::memcpy(&bytes[at], &word, sizeof word);
  const std::uint64_t words = bytes.size() / 8;
  std::memcpy(&bytes[bytes.size() - 16], &words, sizeof words);
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (std::size_t k = 0; k + 8 < bytes.size(); ++k) {
    hash = (hash ^ static_cast<std::uint8_t>(bytes[k])) * 0x100000001B3u;
  }
  std::memcpy(&bytes[bytes.size() - 8], &hash, sizeof hash);
  return bytes;
}

/// Where the event of a kind begins that comes `skipped` after the first one.
std::size_t event(const std::string& bytes, std::uint64_t kind, int skipped = 0) {
  std::size_t at = kHeadBytes;
  while (at + 16 < bytes.size()) {
    const std::uint64_t head = word_at(bytes, at);
    if ((head & 0xFF) == kind && skipped-- == 0) return at;
    at += 8 * (1 + (head >> 16));
  }
  ADD_FAILURE() << "no event of kind " << kind;
  return kHeadBytes;
}
constexpr std::uint64_t kAssume = 2, kFrame = 6, kStart = 10, kGoal = 11, kTick = 15;

void expect_refused(const std::string& bytes, const std::string& reason) {
  try {
    tern_host::replay_flight(bytes);
    FAIL() << "expected: " << reason;
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(FlightRecord, TheFirstTickThatDiffersIsNamed) {
  const std::string& bytes = short_record();
  const std::size_t at = event(bytes, kTick, 37) + 16;
  const tern_host::FlightReplay replayed = tern_host::replay_flight(forged(bytes, at, word_at(bytes, at) ^ 1));
  EXPECT_EQ(replayed.different_ticks, 1);
  EXPECT_EQ(replayed.difference.find("tick 37, 0.740 s after the first, is the first that differs; in tick 64"), 0u)
      << replayed.difference;
}

TEST(FlightRecord, AnotherGoalFliesElsewhere) {
  const std::string& bytes = short_record();
  const double y = -3.0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &y, sizeof bits);
  const tern_host::FlightReplay replayed = tern_host::replay_flight(forged(bytes, event(bytes, kGoal) + 16, bits));
  EXPECT_GT(replayed.different_ticks, 0);
  EXPECT_NE(replayed.difference.find("is the first that differs"), std::string::npos) << replayed.difference;
}

TEST(FlightRecord, AnswersAreCompared) {
  const std::string& bytes = short_record();
  const std::size_t at = event(bytes, kFrame);
  const tern_host::FlightReplay replayed = tern_host::replay_flight(forged(bytes, at, word_at(bytes, at) ^ (1u << 8)));
  EXPECT_NE(replayed.difference.find("frame after tick 0 answered"), std::string::npos) << replayed.difference;
}

TEST(FlightRecord, WhatIsTruncatedOrAlteredIsRefused) {
  const std::string& bytes = short_record();
  for (const std::size_t size : {std::size_t{0}, std::size_t{39}, kHeadBytes, bytes.size() / 2, bytes.size() - 8}) {
    expect_refused(bytes.substr(0, size), "record_damaged");
  }
  expect_refused(bytes + std::string(8, '\0'), "record_damaged");
  for (std::size_t at = 0; at < bytes.size(); at += 1013) {
    std::string altered = bytes;
    altered[at] = static_cast<char>(altered[at] ^ 4);
    expect_refused(altered, at == 8 ? "record_version" : "record_damaged");
  }
  expect_refused(forged(bytes, 8, tern::kRecordVersion - 1), "record_version");
}

TEST(FlightRecord, WhatIsForgedIsRefusedWithTheEvent) {
  const std::string& bytes = short_record();
  const std::size_t frame = event(bytes, kFrame);
  const std::uint64_t head = word_at(bytes, frame);
  const std::size_t runs = frame + 8 * 20;
  expect_refused(forged(bytes, frame, (head & ~std::uint64_t{0xFF}) | 99), "(none) is no kind of event");
  expect_refused(forged(bytes, frame, head | std::uint64_t{1} << 63), "(frame) is longer than the record");
  expect_refused(forged(bytes, frame, head - (std::uint64_t{1} << 16)), "(frame)");
  expect_refused(forged(bytes, frame + 8 * 9, 1u << 30), "has no image that this build can read");
  expect_refused(forged(bytes, frame + 8 * 19, 24), "has no image that this build can read");
  expect_refused(forged(bytes, runs, 0), "has runs that do not fill its image");
  expect_refused(forged(bytes, runs, 0xFFFF), "has runs that do not fill its image");
  const std::size_t start = event(bytes, kStart);
  const std::uint64_t start_words = word_at(bytes, start) >> 16;
  expect_refused(forged(bytes, start + 8 * start_words, 1u << 20), "has a count that is out of range");
  // Two calls that a flight makes once.
  const std::size_t bind = event(bytes, 1);
  const std::string once = bytes.substr(bind, event(bytes, kAssume) - bind);
  std::string twice = bytes;
  twice.insert(bind, once);
  expect_refused(forged(twice, 8, tern::kRecordVersion), "(bind) is a second one");
}

}  // namespace
