// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/companion's socket for depth: good frames, senders of other versions, and bytes that are no frame.
#include "companion/depth_socket.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "depth_sender.h"
#include "support/own_folder.hpp"

namespace tern_companion {
namespace {

struct Taken {
  tern_depth_header header;
  std::vector<std::uint8_t> payload;
};

class CompanionDepth : public testing::Test {
 protected:
  tern_depth_header header() const { return tern_depth_camera(TERN_DEPTH_MILLIMETRES, 4, 3, 2, 2, 1.5, 1); }
  /// Sends these bytes on a connection of their own, and says whether it is still open then.
  bool send(const std::vector<std::uint8_t>& bytes) {
    const int connection = tern_depth_connect(path_.c_str());
    EXPECT_GE(connection, 0);
    EXPECT_EQ(::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
    socket_.read();
    char byte;
    const bool is_open = recv(connection, &byte, 1, MSG_DONTWAIT) < 0;
    tern_depth_close(connection);
    return is_open;
  }
  std::vector<std::uint8_t> frame(const tern_depth_header& h) const {
    std::vector<std::uint8_t> bytes(sizeof h + h.payload_bytes, 7);
    std::memcpy(bytes.data(), &h, sizeof h);
    return bytes;
  }
  void expect_refused(const tern_depth_header& h, const std::string& words) {
    EXPECT_FALSE(send(frame(h)));
    EXPECT_NE(said_.back().find(words), std::string::npos) << said_.back();
    EXPECT_TRUE(taken_.empty());
  }

  std::string path_ = tern_test::own_folder() + "depth";
  std::vector<Taken> taken_;
  std::vector<std::string> said_;
  DepthSocket socket_{path_,
                      [this](const tern_depth_header& h, const std::uint8_t* payload) {
                        taken_.push_back({h, {payload, payload + h.payload_bytes}});
                      },
                      [this](const std::string& text) { said_.push_back(text); }};
};

TEST_F(CompanionDepth, TakesWhatTheSenderInCSends) {
  const int connection = tern_depth_connect(path_.c_str());
  ASSERT_GE(connection, 0);
  tern_depth_header h = header();
  std::vector<std::uint16_t> image(12, 1234);
  for (int k = 0; k < 3; ++k) {
    h.stamp_ns = k;
    ASSERT_EQ(tern_depth_send(connection, &h, image.data()), 0);
  }
  socket_.read();
  ASSERT_EQ(taken_.size(), 3u);
  EXPECT_EQ(taken_[2].header.stamp_ns, 2);
  EXPECT_EQ(std::memcmp(taken_[2].payload.data(), image.data(), 24), 0);
  tern_depth_close(connection);
  socket_.read();
  EXPECT_EQ(said_.back(), "a sender of depth has gone");
  EXPECT_EQ(socket_.descriptors().size(), 1u);
}

TEST_F(CompanionDepth, TakesFramesThatComeInPieces) {
  const int connection = tern_depth_connect(path_.c_str());
  const std::vector<std::uint8_t> bytes = frame(header());
  for (const std::uint8_t byte : bytes) {
    ASSERT_TRUE(taken_.empty());
    ASSERT_EQ(::send(connection, &byte, 1, 0), 1);
    socket_.read();
  }
  EXPECT_EQ(taken_.size(), 1u);
  tern_depth_close(connection);
}

TEST_F(CompanionDepth, DisconnectsWhoSpeaksAnotherFormat) {
  tern_depth_header h = header();
  h.version = 2;
  expect_refused(h, "version 2 of the format");
  h = header();
  h.header_bytes = 100;
  expect_refused(h, "headers of 100 bytes");
  h = header();
  h.magic = 1;
  expect_refused(h, "no frame begins here");
  h = header();
  h.sensor = 8;
  expect_refused(h, "sensors are 0 to 7");
  h = header();
  h.format = 4;
  expect_refused(h, "format 4");
  h = header();
  h.payload_bytes = 23;
  expect_refused(h, "payload_bytes is 23");
  h = header();
  h.width = 70000;
  h.height = 70000;
  expect_refused(h, "at most 33554432");
  EXPECT_TRUE(send(frame(header()))) << "others are as before";
  EXPECT_EQ(taken_.size(), 1u);
}

TEST_F(CompanionDepth, TakesWhatTheSenderInPythonSends) {
  if (std::string(TERN_TEST_PYTHON).empty()) GTEST_SKIP() << "no Python with numpy";
  const std::string script =
      "import sys; sys.path.insert(0, sys.argv[1]); sys.dont_write_bytecode = True\n"
      "import numpy, depth_sender\n"
      "with depth_sender.DepthSender(sys.argv[2]) as s:\n"
      "    image = numpy.full((3, 4), 2.5, numpy.float32)\n"
      "    s.send(image, 2, 2, 1.5, 1, stamp_ns=42, sensor=3, position=(0.1, 0, 0))\n"
      "    s.send_points(numpy.ones((1, 5, 3), numpy.float32), stamp_ns=43)\n";
  const std::string command = std::string(TERN_TEST_PYTHON) + " -c '" + script + "' " TERN_TEST_SENDERS " " + path_;
  ASSERT_EQ(std::system(command.c_str()), 0);
  socket_.read();
  ASSERT_EQ(taken_.size(), 2u) << said_.back();
  tern_depth_header expected = tern_depth_camera(TERN_DEPTH_METRES, 4, 3, 2, 2, 1.5, 1);
  expected.sensor = 3;
  expected.stamp_ns = 42;
  expected.position[0] = 0.1;
  EXPECT_EQ(std::memcmp(&taken_[0].header, &expected, sizeof expected), 0);
  float depth;
  std::memcpy(&depth, taken_[0].payload.data(), sizeof depth);
  EXPECT_EQ(depth, 2.5f);
  EXPECT_EQ(taken_[1].header.format, TERN_DEPTH_POINTS);
  EXPECT_EQ(taken_[1].header.width, 5u);
}

}  // namespace
}  // namespace tern_companion
