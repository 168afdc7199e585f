// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What port/companion makes of an autopilot's messages, what it asks for, and when it counts as ready.
#include "companion/autopilot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "companion/engagement.hpp"

namespace tern_companion {
namespace {

constexpr double kClose = 1e-6;
const float kHalf = std::sqrt(0.5f);

/// An autopilot's side of the link, written by hand.
class CompanionAutopilot : public testing::Test {
 protected:
  template <class Message>
  bool hear(const Message& message, std::uint8_t component = kAutopilotComponent) {
    Sender sender{1, component, 0};
    FrameReader reader;
    const std::vector<std::uint8_t> bytes = pack(sender, message);
    reader.feed(bytes.data(), bytes.size());
    Frame frame;
    return reader.next(frame) && autopilot_.read(frame, now_);
  }
  void hear_heartbeat(std::uint8_t autopilot = kPx4, std::uint32_t mode = 6u << 16, std::uint8_t base = 129,
                      std::uint8_t state = kStateActive) {
    EXPECT_TRUE(hear(Heartbeat{mode, 2, autopilot, base, state, 3}));
  }
  /// The autopilot's clock is 2 s behind.
  void hear_time() {
    for (int k = 0; k < 3; ++k) hear(TimeSync{now_ - 2 * kSecond, now_, 1, kCompanionComponent});
  }
  /// What it has sent of a kind since the last call.
  template <class Message>
  std::vector<Message> sent() {
    FrameReader reader;
    for (const auto& bytes : sent_) reader.feed(bytes.data(), bytes.size());
    std::vector<Message> found;
    Frame frame;
    while (reader.next(frame)) {
      if (frame.id == Message::kId) found.push_back(parse<Message>(frame));
    }
    sent_.clear();
    return found;
  }
  const AutopilotState& state() const { return autopilot_.state(); }

  std::int64_t now_ = 10 * kSecond;
  std::vector<std::vector<std::uint8_t>> sent_;
  std::vector<std::string> said_;
  std::vector<AutopilotState> poses_;
  Autopilot autopilot_{0, [this](const auto& bytes) { sent_.push_back(bytes); },
                       [this](const auto& text) { said_.push_back(text); },
                       [this](const AutopilotState& at) { poses_.push_back(at); }};
};

TEST_F(CompanionAutopilot, KnowsModesArmingAndFlightOfBoth) {
  EXPECT_FALSE(hear(Heartbeat{0, kGroundStation, kInvalidAutopilot, 0, 0, 3}));
  EXPECT_FALSE(hear(Heartbeat{0, 2, kPx4, 129, kStateActive, 3}, kCompanionComponent));
  EXPECT_EQ(state().rules, nullptr);
  hear_heartbeat();
  EXPECT_STREQ(state().rules->name, "PX4");
  EXPECT_TRUE(state().armed && state().in_mode && !state().in_air) << "PX4 says so in EXTENDED_SYS_STATE";
  hear(ExtendedSysState{0, kLandedInAir});
  EXPECT_TRUE(state().in_air);
  hear_heartbeat(kPx4, 4u << 16 | 3u << 24, 1);
  EXPECT_FALSE(state().armed || state().in_mode);
  hear_heartbeat(kArdupilot, 4);
  EXPECT_TRUE(state().armed && state().in_mode && state().in_air);
  hear_heartbeat(kArdupilot, 4, 129, kStateStandby);
  EXPECT_FALSE(state().in_air);
  hear_heartbeat(kArdupilot, 5);
  EXPECT_FALSE(state().in_mode);
}

/// Its clock is 2 s behind the companion's, and its receiver has Unix times.
TEST_F(CompanionAutopilot, TellsTheUnixTime) {
  hear_heartbeat();
  hear_time();
  EXPECT_FALSE(autopilot_.unix_time(now_).has_value());
  hear(SystemTime{0, 8000});
  EXPECT_FALSE(autopilot_.unix_time(now_).has_value()) << "without a fix";
  hear(SystemTime{1700000000000000, 8000});  // now
  ASSERT_TRUE(autopilot_.unix_time(now_).has_value());
  EXPECT_EQ(*autopilot_.unix_time(now_), 1700000000000000000);
  EXPECT_EQ(*autopilot_.unix_time(now_ + kSecond), 1700000001000000000);
  hear(SystemTime{0, 100});  // it was restarted
  EXPECT_FALSE(autopilot_.unix_time(now_).has_value());
}

TEST_F(CompanionAutopilot, AsksForEachMessageUntilItIsAnswered) {
  hear_heartbeat();
  std::vector<float> asked;
  for (int k = 0; k < 40; ++k, now_ += kSecond / 10) {
    autopilot_.tick(now_);
    for (const CommandLong& command : sent<CommandLong>()) {
      EXPECT_EQ(command.command, kSetMessageInterval);
      EXPECT_EQ(command.target_system, 1);
      asked.push_back(command.params[0]);
      // The first request is lost, and the second one refused.
      if (asked.size() > 1)
        hear(CommandAck{kSetMessageInterval, asked.size() == 2 ? kDenied : kAccepted, 0, 0, 1, 191});
    }
  }
  EXPECT_EQ(asked, (std::vector<float>{331, 331, 245, 49}));
  EXPECT_EQ(said_.back(), "the autopilot refuses to send message 331");
}

TEST_F(CompanionAutopilot, SaysThatItIsThereOnceASecond) {
  int beats = 0;
  for (int k = 0; k < 100; ++k, now_ += kSecond / 20) {
    autopilot_.tick(now_);
    for (const Heartbeat& beat : sent<Heartbeat>()) {
      EXPECT_EQ(beat.type, kOnboardController);
      EXPECT_EQ(beat.autopilot, kInvalidAutopilot);
      ++beats;
    }
  }
  EXPECT_EQ(beats, 5);
}

TEST_F(CompanionAutopilot, OdometryIsTurnedAndStamped) {
  hear_heartbeat();
  // North 1, east 2, up 3; the nose to the east: in east-north-up, no turn.
  Odometry odometry{};
  odometry.time_usec = 7000000;
  odometry.position = {1, 2, -3};
  odometry.q = {kHalf, 0, 0, kHalf};
  odometry.velocity = {4, 5, -6};
  odometry.frame_id = odometry.child_frame_id = kLocalNed;
  hear(odometry);
  EXPECT_TRUE(poses_.empty()) << "before the clocks are known";
  hear_time();
  hear(odometry);
  ASSERT_EQ(poses_.size(), 1u);
  const tern_onboard::StampedPose& pose = poses_[0].pose;
  EXPECT_EQ(pose.stamp, 9 * kSecond);
  EXPECT_EQ(pose.pose.position.x, 2.0);
  EXPECT_EQ(pose.pose.position.y, 1.0);
  EXPECT_EQ(pose.pose.position.z, 3.0);
  EXPECT_NEAR(pose.pose.quaternion[0], 1.0, kClose);
  EXPECT_EQ(poses_[0].velocity.x, 5.0);
  EXPECT_EQ(poses_[0].velocity.z, 6.0);
  odometry.child_frame_id = kBodyFrd;  // ahead 4, right 5, down -6
  hear(odometry);
  EXPECT_NEAR(poses_[1].velocity.x, 4.0, kClose);
  EXPECT_NEAR(poses_[1].velocity.y, -5.0, kClose);
  EXPECT_NEAR(poses_[1].velocity.z, 6.0, kClose);
  odometry.frame_id = 20;
  hear(odometry);
  EXPECT_EQ(poses_.size(), 2u) << "of another frame";
}

TEST_F(CompanionAutopilot, PositionsAreCarriedToTheAttitudesTime) {
  hear_heartbeat(kArdupilot, 4);
  hear_time();
  hear(AttitudeQuaternion{7000, {1, 0, 0, 0}, {}, {}});
  EXPECT_TRUE(poses_.empty()) << "there is no position yet";
  hear(LocalPositionNed{7000, {1, 2, -3}, {10, 0, 0}});
  hear(AttitudeQuaternion{7020, {1, 0, 0, 0}, {}, {}});
  ASSERT_EQ(poses_.size(), 1u);
  EXPECT_EQ(poses_[0].pose.stamp, 9 * kSecond + kSecond / 50);
  EXPECT_NEAR(poses_[0].pose.pose.position.y, 1.2, kClose);
  EXPECT_NEAR(tern_onboard::heading_of(poses_[0].pose.pose.quaternion), 1.5707963, kClose) << "north is a quarter turn";
  hear(AttitudeQuaternion{7400, {1, 0, 0, 0}, {}, {}});
  EXPECT_EQ(poses_.size(), 1u) << "too far from the position's time";
}

TEST_F(CompanionAutopilot, CountsResetsAndRestarts) {
  hear_heartbeat();
  hear_time();
  Odometry odometry{};
  odometry.frame_id = kLocalNed;
  odometry.q = {1, 0, 0, 0};
  const auto resets_after = [&](std::uint8_t counter, std::uint64_t time_usec) {
    odometry.reset_counter = counter;
    odometry.time_usec = time_usec;
    hear(odometry);
    return state().resets;
  };
  EXPECT_EQ(resets_after(7, 7000000), 0u) << "the first number means nothing";
  EXPECT_EQ(resets_after(7, 7020000), 0u);
  EXPECT_EQ(resets_after(8, 7040000), 1u);
  EXPECT_EQ(resets_after(0, 100000), 2u) << "it was restarted";
  EXPECT_FALSE(autopilot_.clock().known());
  EXPECT_EQ(said_.back(), "the autopilot was restarted");
}

TEST_F(CompanionAutopilot, AnswersRequestsOfTheTime) {
  hear_heartbeat();
  hear(TimeSync{0, 4321, 0, 0});
  autopilot_.answer_time(now_);
  const std::vector<TimeSync> answers = sent<TimeSync>();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].ts1, 4321);
  EXPECT_EQ(answers[0].tc1, now_);
}

TEST(CompanionEngagement, NamesTheFirstThingThatIsMissing) {
  Facts f;
  const auto expect = [&f](Phase phase) { EXPECT_EQ(phase_of(f), phase) << phase_text(phase); };
  expect(Phase::kNoAutopilot);
  f.heartbeat = f.was_heard = true;
  expect(Phase::kNoTime);
  f.time = true;
  expect(Phase::kNoPose);
  f.pose = true;
  expect(Phase::kNoFrames);
  f.frames = true;
  expect(Phase::kDisarmed);
  f.armed = true;
  expect(Phase::kOnGround);
  f.in_air = true;
  expect(Phase::kOtherMode);
  f.in_mode = true;
  expect(Phase::kSettling);
  f.rests = true;
  expect(Phase::kNoGoal);
  f.has_goal = true;
  expect(Phase::kSettling);
  f.begun = true;
  expect(Phase::kFlying);
}

TEST(CompanionEngagement, InFlightTheVehicleIsBroughtToRestOrGivenBack) {
  Facts flying;
  flying.heartbeat = flying.was_heard = flying.time = flying.pose = flying.frames = true;
  flying.armed = flying.in_air = flying.in_mode = flying.has_goal = flying.begun = true;
  const auto with = [&flying](bool Facts::*fact, bool value) {
    Facts f = flying;
    f.*fact = value;
    return phase_of(f);
  };
  EXPECT_EQ(with(&Facts::heartbeat, false), Phase::kLinkLost);
  EXPECT_EQ(with(&Facts::ending, true), Phase::kEnding);
  EXPECT_EQ(with(&Facts::lost, true), Phase::kGivenUp);
  EXPECT_EQ(with(&Facts::frames, false), Phase::kFlying) << "the flight comes to rest by itself";
  EXPECT_EQ(with(&Facts::pose, false), Phase::kFlying) << "likewise";
  EXPECT_EQ(with(&Facts::in_mode, false), Phase::kOtherMode);
  EXPECT_EQ(with(&Facts::armed, false), Phase::kDisarmed);
  EXPECT_EQ(with(&Facts::in_air, false), Phase::kOnGround);
}

}  // namespace
}  // namespace tern_companion
