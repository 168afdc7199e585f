// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/companion's messages beside the frames that node-mavlink 2.3 writes for the same numbers, and what a reader does
// with bytes that are no good frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "companion/clock_sync.hpp"
#include "companion/frame.hpp"

namespace tern_companion {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes from_hex(const std::string& text) {
  Bytes bytes;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16)));
  }
  return bytes;
}

std::vector<Frame> read_all(FrameReader& reader, const Bytes& bytes) {
  reader.feed(bytes.data(), bytes.size());
  std::vector<Frame> frames;
  Frame frame;
  while (reader.next(frame)) frames.push_back(frame);
  return frames;
}

/// The message packs to node-mavlink's frame, and parses from it to what packs to the same frame again.
template <class Message>
void expect_frame(const Message& message, std::uint8_t sequence, const std::string& hex) {
  Sender sender{7, 191, sequence};
  EXPECT_EQ(pack(sender, message), from_hex(hex)) << Message::kId;
  FrameReader reader;
  const std::vector<Frame> frames = read_all(reader, from_hex(hex));
  ASSERT_EQ(frames.size(), 1u) << Message::kId;
  EXPECT_EQ(frames[0].id, Message::kId);
  EXPECT_EQ(frames[0].system, 7);
  EXPECT_EQ(frames[0].component, 191);
  EXPECT_EQ(frames[0].sequence, sequence);
  sender.sequence = sequence;
  EXPECT_EQ(pack(sender, parse<Message>(frames[0])), from_hex(hex)) << Message::kId;
}

TEST(CompanionMavlink, FramesAreNodeMavlinks) {
  expect_frame(Heartbeat{393216, 18, 8, 129, 4, 3}, 1, "fd0900000107bf00000000000600120881040337dc");
  expect_frame(SystemTime{1700000000123456, 98765}, 2, "fd0b00000207bf02000040222018240a0600cd810143c1");
  expect_frame(AttitudeQuaternion{1000, {0.5f, -0.5f, 0.25f, 0.75f}, {1, 2, 3}, {}}, 3,
               "fd2000000307bf1f0000e80300000000003f000000bf0000803e0000403f0000803f00000040000040402b72");
  expect_frame(LocalPositionNed{1001, {1.5f, -2.5f, -3.5f}, {0.125f, 0.25f, -0.5f}}, 4,
               "fd1c00000407bf200000e90300000000c03f000020c0000060c00000003e0000803e000000bfba68");
  expect_frame(GpsGlobalOrigin{473977000, -85456000, 488000, 123456789}, 5,
               "fd1000000507bf310000a850401c800be8fa4072070015cd5b072fd1");
  expect_frame(
      SetPositionTarget{20, {1, 2, -3}, {4, 5, 6}, {7, 8, 9}, 1.25f, -0.5f, 3072, 1, 1, 1}, 6,
      "fd3500000607bf540000140000000000803f00000040000040c0000080400000a0400000c0400000e04000000041000010410000a0"
      "3f000000bf000c010101cffa");
  expect_frame(CommandInt{{-1, 1, 0, 0.5f}, 473977418, 85455939, 12.5f, 192, 1, 191, 6, 0, 0}, 7,
               "fd2100000707bf4b0000000080bf0000803f000000000000003f4a52401c43f4170500004841c00001bf06cdf0");
  expect_frame(CommandLong{{331, 20000}, 511, 1, 1, 0}, 8,
               "fd2000000807bf4c00000080a54300409c460000000000000000000000000000000000000000ff01010118e3");
  expect_frame(CommandAck{511, 2, 0, -7, 1, 191}, 9, "fd0a00000907bf4d0000ff010200f9ffffff01bf9df0");
  expect_frame(TimeSync{1234567890123, -5, 1, 191}, 10, "fd1200000a07bf6f0000cb04fb711f010000fbffffffffffffff01bfe16f");
  expect_frame(ExtendedSysState{0, 2}, 11, "fd0200000b07bff50000000274a1");
  StatusText text;
  text.severity = 4;
  const std::string words = "Tern: flies";
  std::copy(words.begin(), words.end(), text.text.begin());
  expect_frame(text, 12, "fd0c00000c07bffd0000045465726e3a20666c6965736028");
}

TEST(CompanionMavlink, OdometryIsNodeMavlinks) {
  Odometry odometry{5000000, {1, 2, 3}, {0.5f, -0.5f, 0.5f, -0.5f}, {4, 5, 6}, {7, 8, 9}, {}, {}, 1, 12, 3, 4, -1};
  odometry.pose_covariance.fill(0.25f);
  odometry.velocity_covariance.fill(0.5f);
  std::string hex =
      "fde900000d07bf4b0100404b4c00000000000000803f00000040000040400000003f000000bf0000003f000000bf000080400000a0400000"
      "c0400000e0400000004100001041";
  for (int k = 0; k < 21; ++k) hex += "0000803e";
  for (int k = 0; k < 21; ++k) hex += "0000003f";
  expect_frame(odometry, 13, hex + "010c0304ffab9c");
}

TEST(CompanionMavlink, ReportsOfOtherAircraftAreNodeMavlinks) {
  AdsbVehicle aircraft{0x4ca123, 473977000, -85456000, 1234567, 27012, 7000, -512, 0x9f, 7000, 1, {}, 3, 2};
  const std::string callsign = "RYR4TW";
  std::copy(callsign.begin(), callsign.end(), aircraft.callsign.begin());
  expect_frame(aircraft, 14,
               "fd2600000e07bff6000023a14c00a850401c800be8fa87d612008469581b00fe9f00581b0152595234545700000003"
               "02b2f4");
  UtmGlobalPosition drone{1700000000123456, 473977000, -85456000, 1234567, 50000, 1,  2, 3,
                          {100, -200, 50},  1500,      2500,      30,      100,   {}, 3, 0x7f};
  for (std::size_t k = 0; k < drone.uas_id.size(); ++k) drone.uas_id[k] = static_cast<std::uint8_t>(k + 1);
  expect_frame(drone, 15,
               "fd4600000f07bf54010040222018240a0600a850401c800be8fa87d6120050c300000100000002000000030000006400"
               "38ff3200dc05c4091e0064000102030405060708090a0b0c0d0e0f101112037f3c91");
  OpenDroneIdBasicId who{0, 0, {0xa0, 0xb1, 0xc2, 0xd3, 0xe4, 0xf5}, 1, 2, {}};
  const std::string serial = "1581F4FEC234";
  std::copy(serial.begin(), serial.end(), who.uas_id.begin());
  expect_frame(who, 16,
               "fd2400001007bf6432000000a0b1c2d3e4f500000000000000000000000000000102313538314634464543323334"
               "1740");
  const OpenDroneIdLocation where{473977000, -85456000,   480.5f, 530.25f, 40.5f, 1800.5f, 9000, 500, -100, 0,
                                  0,         who.address, 2,      0,       10,    4,       3,    3,   2};
  expect_frame(where, 17,
               "fd3b00001107bf653200a850401c800be8fa0040f04300900444000022420010e1442823f4019cff0000a0b1c2d3e4"
               "f5000000000000000000000000000002000a040303021f9e");
}

const Bytes kGood = from_hex("fd0900000107bf00000000000600120881040337dc");

TEST(CompanionMavlink, PortionsOfAnySizeGiveTheSameFrames) {
  for (std::size_t portion = 1; portion < 2 * kGood.size(); ++portion) {
    FrameReader reader;
    Bytes all = kGood;
    all.insert(all.end(), kGood.begin(), kGood.end());
    std::size_t found = 0;
    for (std::size_t at = 0; at < all.size(); at += portion) {
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), at + portion));
      found += read_all(reader, Bytes(all.begin() + static_cast<std::ptrdiff_t>(at), end)).size();
    }
    EXPECT_EQ(found, 2u) << portion;
  }
}

TEST(CompanionMavlink, EveryWrongBitIsSeenAndTheNextFrameIsFound) {
  for (std::size_t bit = 0; bit < 8 * kGood.size(); ++bit) {
    Bytes bytes = kGood;
    bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
    // A longer length takes the next frames for its own: enough follow that one is left.
    for (int k = 0; k < 16; ++k) bytes.insert(bytes.end(), kGood.begin(), kGood.end());
    FrameReader reader;
    const std::vector<Frame> frames = read_all(reader, bytes);
    EXPECT_GE(frames.size(), 3u) << bit;
    EXPECT_LE(frames.size(), 16u) << bit;
    for (const Frame& frame : frames) EXPECT_EQ(parse<Heartbeat>(frame).custom_mode, 393216u) << bit;
  }
}

TEST(CompanionMavlink, NoiseBetweenFramesIsPassedOver) {
  Bytes bytes{0x00, 0xFD, 0x01, 0xFE, 0xFF};
  bytes.insert(bytes.end(), kGood.begin(), kGood.end());
  bytes.insert(bytes.end(), 300, 0x55);
  bytes.insert(bytes.end(), kGood.begin(), kGood.end());
  FrameReader reader;
  EXPECT_EQ(read_all(reader, bytes).size(), 2u);
}

TEST(CompanionMavlink, OtherVersionsSignaturesAndFlagsAreCountedAndNotUsed) {
  FrameReader reader;
  const Bytes of_version_1 = from_hex("fe090107bf0000000600120881040365c3");  // node-mavlink's, with the same numbers
  EXPECT_TRUE(read_all(reader, of_version_1).empty());
  EXPECT_EQ(reader.counts().version_1, 1u);
  Bytes with_signature = from_hex("fd0901000107bf000000000006001208810403d024");
  with_signature.insert(with_signature.end(), 13, 0x5A);
  EXPECT_TRUE(read_all(reader, with_signature).empty());
  EXPECT_EQ(reader.counts().with_signature, 1u);
  EXPECT_TRUE(read_all(reader, from_hex("fd0902000107bf000000000006001208810403e825")).empty())
      << "a flag of later times";
  EXPECT_EQ(reader.counts().frames, 0u);
  EXPECT_GE(reader.counts().bad_checksum, 1u);
  EXPECT_EQ(read_all(reader, kGood).size(), 1u);
}

TEST(CompanionClock, KeepsTheAnswerWithTheShortestWay) {
  ClockSync clock;
  clock.answered(1000, 0, 3000);
  EXPECT_FALSE(clock.known());
  clock.answered(1000000, 998600, 1000200);  // 100 ns each way: the offset is 1500
  clock.answered(2000000, 1990000, 2030000);
  EXPECT_TRUE(clock.known());
  EXPECT_EQ(clock.to_own(5000), 6500);
  EXPECT_EQ(clock.uncertainty(), 100);
  clock.answered(4000000, 0, 3000000);  // before it was asked
  EXPECT_EQ(clock.to_own(5000), 6500);
}

TEST(CompanionClock, ARestartOfTheAutopilotBeginsAnew) {
  ClockSync clock;
  for (std::int64_t k = 1; k < 20; ++k) clock.answered(k * kSecond, k * kSecond - 7000, k * kSecond);
  EXPECT_EQ(clock.restarts(), 0u);
  for (std::int64_t k = 20; k < 24; ++k) clock.answered(k * kSecond, (k - 20) * kSecond, k * kSecond);
  EXPECT_EQ(clock.restarts(), 1u);
  EXPECT_TRUE(clock.known());
  EXPECT_EQ(clock.to_own(kSecond), 21 * kSecond);
}

}  // namespace
}  // namespace tern_companion
