// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/ros's flight node for ROS 2, over stand-ins for rclcpp and the messages. ROS 2 itself is not in Debian.
#define main tern_node_main
#include "../../port/ros/ros2/src/tern_flight_node.cpp"
#undef main

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "onboard/onboard_lookout.hpp"
#include "ros2/camera_world.hpp"
#include "ros2/message_files.hpp"
#include "ros2/replayed_flight.hpp"
#include "ros_clouds.hpp"

namespace {

using geometry_msgs::msg::PoseStamped;
using rclcpp::bus;
using tern_test::CameraWorld;
using tern_test::kTick;
using tern_test::pose_at;
using tern_test::tick;
using tern_test::told;
using trajectory_msgs::msg::MultiDOFJointTrajectory;

bool log_has(const std::string& text) {
  return std::any_of(bus().log.begin(), bus().log.end(),
                     [&text](const std::string& line) { return line.find(text) != std::string::npos; });
}

long log_count(const std::string& text) {
  return std::count_if(bus().log.begin(), bus().log.end(),
                       [&text](const std::string& line) { return line.find(text) != std::string::npos; });
}

/// A value of the last diagnostics.
std::string diagnosed(const std::string& key) {
  const auto told = std::any_cast<diagnostic_msgs::msg::DiagnosticArray>(bus().last("/diagnostics"));
  for (const auto& value : told.status.at(0).values) {
    if (value.key == key) return value.value;
  }
  return "none";
}

class Ros2 : public testing::Test {
 protected:
  void SetUp() override {
    rclcpp::the_bus() = std::make_unique<rclcpp::Bus>();
    bus().parameters = {{"setpoint_rate", 100.0}, {"tracking_margin", 0.1}, {"radius", 0.3}};
  }
  /// Runs the node, and `script` once it spins.
  static int run(const std::function<void()>& script = [] {}) {
    bool begun = false;
    bus().world = [&] {
      if (!begun) script();
      return !std::exchange(begun, true);
    };
    return tern_node_main(0, nullptr);
  }
};

/// Follows the setpoints until the node says that it is at the goal; answers the least distance from the wall of
/// ros_clouds.hpp.
double fly_exactly(double seconds, PoseStamped& at) {
  double least = 1e9;
  for (int k = 0; k < static_cast<int>(100 * seconds); ++k) {
    tern_ros::set_stamp(at.header.stamp, bus().now());
    bus().deliver("pose", at);
    tick();
    const auto setpoint = std::any_cast<MultiDOFJointTrajectory>(bus().last("command/trajectory"));
    const auto& p = setpoint.points.at(0).transforms.at(0).translation;
    at.pose.position = {p.x, p.y, p.z};
    least = std::min(least, tern_test::distance_from_wall({p.x, p.y, p.z}));
    if (told() == "rest: it is at the goal") return least;
  }
  return -1.0;
}

TEST_F(Ros2, FliesPastAKnownCloud) {
  bus().parameters["cameras"] = std::string();
  bus().parameters["free_radius"] = 40.0;
  bus().parameters["stale_after"] = 0.0;
  bus().parameters["ground"] = 0.0;
  bus().parameters["ceiling"] = 3.5;
  double least = 0.0;
  PoseStamped at = pose_at(-3, 0, 1.5);
  ASSERT_EQ(run([&] {
              bus().deliver("known", tern_test::cloud_of_wall<sensor_msgs::msg::PointCloud2>());
              bus().deliver("pose", at);
              bus().deliver("goal", pose_at(4, 1, 1.5));
              least = fly_exactly(30.0, at);
            }),
            0);
  EXPECT_GT(least, 0.4);
  EXPECT_NEAR(at.pose.position.x, 4.0, 0.02);
  const auto setpoint = std::any_cast<MultiDOFJointTrajectory>(bus().last("command/trajectory"));
  EXPECT_EQ(setpoint.header.frame_id, "map");
  EXPECT_EQ(tern_ros::stamp_of(setpoint.header.stamp), bus().now());
  const auto map = std::any_cast<sensor_msgs::msg::PointCloud2>(bus().last("tern/obstacles"));
  EXPECT_GT(map.width, 100u);
  EXPECT_EQ(map.data.size(), 12u * map.width);
}

/// The last message of a topic, for definitions_test.sh.
template <typename Message>
void write_last(const std::string& type, const std::string& topic) {
  tern_test::write_message(type, std::any_cast<Message>(bus().last(topic)));
}

TEST_F(Ros2, FliesThroughAForestThatItSees) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "tern_ros2_records";
  std::filesystem::remove_all(folder);
  bus().parameters["record"] = folder.string();
  CameraWorld world("P25:20001");
  bool there = false;
  ASSERT_EQ(run([&] {
              for (int k = 0; k < 10; ++k) world.step();
              world.send_goal();
              for (int k = 0; k < 6000 && !there; ++k) {
                world.step();
                there = told() == "rest: it is at the goal";
              }
            }),
            0);
  EXPECT_TRUE(there) << told();
  EXPECT_GT(world.least, world.body());
  const auto markers = std::any_cast<visualization_msgs::msg::MarkerArray>(bus().last("tern/markers"));
  ASSERT_EQ(markers.markers.size(), 4u);
  EXPECT_EQ(markers.markers[1].ns, "corridor");
  EXPECT_GE(markers.markers[1].points.size(), 12u);  // edges of one polyhedron at least
  tern_test::expect_replays(folder / "flight_42.100.record", world);
  write_last<nav_msgs::msg::Odometry>("nav_msgs/Odometry", "odometry");
  write_last<sensor_msgs::msg::CameraInfo>("sensor_msgs/CameraInfo", "camera/camera_info");
  write_last<sensor_msgs::msg::Image>("sensor_msgs/Image", "camera/image");
  write_last<PoseStamped>("geometry_msgs/PoseStamped", "goal");
  write_last<MultiDOFJointTrajectory>("trajectory_msgs/MultiDOFJointTrajectory", "command/trajectory");
  write_last<visualization_msgs::msg::MarkerArray>("visualization_msgs/MarkerArray", "tern/markers");
  write_last<sensor_msgs::msg::PointCloud2>("sensor_msgs/PointCloud2", "tern/obstacles");
  write_last<diagnostic_msgs::msg::DiagnosticArray>("diagnostic_msgs/DiagnosticArray", "/diagnostics");
}

TEST_F(Ros2, SendsToPx4OnlyWhatItsModeAsksFor) {
  bus().parameters["output"] = std::string("px4");
  px4_msgs::msg::VehicleOdometry odometry;
  odometry.pose_frame = px4_msgs::msg::VehicleOdometry::POSE_FRAME_NED;
  odometry.position = {2.0f, 1.0f, -3.0f};  // north, east, down
  odometry.q = {1.0f, 0.0f, 0.0f, 0.0f};    // looks north
  px4_msgs::msg::VehicleStatus status;
  status.arming_state = px4_msgs::msg::VehicleStatus::ARMING_STATE_ARMED;
  const auto step = [&odometry] {
    odometry.timestamp = static_cast<std::uint64_t>(bus().now() / 1000);
    bus().deliver("fmu/out/vehicle_odometry", odometry);
    tick();
  };
  ASSERT_EQ(run([&] {
              for (int k = 0; k < 20; ++k) step();
              EXPECT_GT(bus().count("fmu/in/offboard_control_mode"), 15);
              EXPECT_EQ(bus().count("fmu/in/trajectory_setpoint"), 0);
              bus().deliver("goal", pose_at(5, 2, 3));
              EXPECT_TRUE(log_has("the autopilot does not follow setpoints"));
              status.nav_state = px4_msgs::msg::VehicleStatus::NAVIGATION_STATE_OFFBOARD;
              bus().deliver("fmu/out/vehicle_status", status);
              odometry.position[1] = 1.2f;  // drifts; the setpoint stays where the mode began
              for (int k = 0; k < 20; ++k) step();
              EXPECT_GT(bus().count("fmu/in/trajectory_setpoint"), 15);
              status.nav_state = 4;
              bus().deliver("fmu/out/vehicle_status", status);
              const int sent = bus().count("fmu/in/trajectory_setpoint");
              for (int k = 0; k < 20; ++k) step();
              EXPECT_EQ(bus().count("fmu/in/trajectory_setpoint"), sent);
            }),
            0);
  const auto setpoint = std::any_cast<px4_msgs::msg::TrajectorySetpoint>(bus().last("fmu/in/trajectory_setpoint"));
  EXPECT_EQ(setpoint.position, (std::array<float, 3>{2.0f, 1.0f, -3.0f}));
  EXPECT_NEAR(setpoint.yaw, 0.0f, 1e-6f);
  EXPECT_GT(setpoint.timestamp, 42000000u);
  const auto mode = std::any_cast<px4_msgs::msg::OffboardControlMode>(bus().last("fmu/in/offboard_control_mode"));
  tern_test::write_message("px4_msgs/TrajectorySetpoint", setpoint);
  tern_test::write_message("px4_msgs/OffboardControlMode", mode);
  EXPECT_TRUE(mode.position);
  EXPECT_FALSE(mode.attitude || mode.body_rate);
}

TEST_F(Ros2, SendsToMavrosFromBeforeTheModeOn) {
  bus().parameters["output"] = std::string("mavros");
  mavros_msgs::msg::State state;
  state.armed = true;
  state.mode = "OFFBOARD";
  ASSERT_EQ(run([&] {
              for (int k = 0; k < 10; ++k) {
                bus().deliver("pose", pose_at(1, 2, 3));
                tick();
              }
              EXPECT_GT(bus().count("mavros/setpoint_raw/local"), 5);
              bus().deliver("mavros/state", state);
              bus().deliver("goal", pose_at(3, 2, 3));
              EXPECT_TRUE(log_has("it is taken over at the next tick"));
            }),
            0);
  const auto target = std::any_cast<mavros_msgs::msg::PositionTarget>(bus().last("mavros/setpoint_raw/local"));
  EXPECT_EQ(target.position.y, 2.0);  // east, north, up
  EXPECT_EQ(target.coordinate_frame, 1);
  EXPECT_EQ(target.type_mask, 0);
}

TEST_F(Ros2, AsksForSensorDataBestEffort) {
  bus().parameters["lidars"] = std::string("top");
  ASSERT_EQ(run(), 0);
  for (const char* topic : {"pose", "odometry", "camera/image", "camera/camera_info", "top/points"}) {
    EXPECT_FALSE(bus().reliable.at(topic)) << topic;
  }
  EXPECT_TRUE(bus().reliable.at("goal"));
}

TEST_F(Ros2, SaysOnceWhatDoesNotFit) {
  ASSERT_EQ(run([] {
              sensor_msgs::msg::Image image;
              image.header.frame_id = "nowhere";
              image.encoding = "rgb8";
              for (int k = 0; k < 5; ++k) {
                bus().deliver("camera/image", image);
                bus().deliver("pose", pose_at(0, 0, 1, "odom"));
                tick();
              }
            }),
            0);
  EXPECT_EQ(log_count("camera: frames wait, because tf2 has no \"nowhere\" in \"base_link\""), 1);
  EXPECT_EQ(log_count("camera: images of encoding \"rgb8\" are refused"), 1);
  EXPECT_EQ(log_count("pose is refused: it is in frame \"odom\", and frame is \"map\""), 1);
  EXPECT_EQ(told(), "no pose");
}

TEST_F(Ros2, TurnsGoalsAndMissionsIntoItsFrame) {
  geometry_msgs::msg::Transform moved;
  moved.translation = {10.0, 0.0, 0.0};
  bus().transforms["map odom"] = moved;
  bus().parameters["ceiling"] = 5.0;
  ASSERT_EQ(run([] {
              bus().deliver("pose", pose_at(10, 0, 2));
              bus().deliver("goal", pose_at(2, 0, 2, "elsewhere"));
              EXPECT_TRUE(log_has("tf2 cannot turn that into \"map\""));
              bus().deliver("goal", pose_at(2, 0, 6, "odom"));
              EXPECT_TRUE(log_has("the goal is at a height of 6.00 m, and ceiling is 5.00 m"));
              nav_msgs::msg::Path path;
              path.header.frame_id = "odom";
              bus().deliver("mission", path);
              EXPECT_TRUE(log_has("it has no points"));
              path.poses = {pose_at(0.5, 0, 2), pose_at(1, 0, 2)};
              bus().deliver("mission", path);
              PoseStamped at = pose_at(10, 0, 2);
              EXPECT_GT(fly_exactly(20.0, at), 0.0);
              EXPECT_NEAR(at.pose.position.x, 11.0, 0.02);
              bus().deliver("stop", std_msgs::msg::Empty());
              EXPECT_TRUE(log_has("the vehicle brakes and forgets its goal"));
            }),
            0);
}

/// A person stands at the goal, as a detector on the vehicle sees it; a second after its last report it counts as gone.
TEST_F(Ros2, WaitsForAPersonThatADetectorSees) {
  auto& p = bus().parameters;
  p["cameras"] = std::string();
  p["free_radius"] = 40.0;
  p["stale_after"] = 0.0;
  p["ceiling"] = 2.0;
  p["detections"] = std::string("vision");
  p["thing_memory"] = 1.0;
  geometry_msgs::msg::Transform eye;
  eye.translation = {0.5, 0.0, 0.0};
  bus().transforms["base_link eye"] = eye;
  PoseStamped at = pose_at(0, 0, 1);
  ASSERT_EQ(run([&] {
              bus().deliver("pose", at);
              bus().deliver("goal", pose_at(6, 0, 1));
              for (int k = 0; k < 1000; ++k) {
                vision_msgs::msg::Detection3DArray seen;
                seen.header.frame_id = "eye";
                seen.header.stamp = at.header.stamp;
                seen.detections.resize(2);  // the second one has no id
                seen.detections[0].id = "1";
                for (auto& detection : seen.detections) {
                  detection.bbox.center.position.x = 5.5 - at.pose.position.x;
                  detection.results = {{{"nurse", 0.9}, {}}};
                }
                if (k % 10 == 0) bus().deliver("detections", seen);
                fly_exactly(0.01, at);
              }
              EXPECT_LT(at.pose.position.x, 6.0 - 0.4 - 0.3);
              EXPECT_GE(fly_exactly(20.0, at), 0.0);
            }),
            0);
  EXPECT_NEAR(at.pose.position.x, 6.0, 0.02);
  EXPECT_EQ(log_count("detections are left out that have no id: set the parameter tracker"), 1);
  EXPECT_EQ(log_count("detections with the label \"nurse\" count as other_class"), 1);
}

/// Two people who walk past each other in lanes of their own, seen without ids, are two things.
TEST_F(Ros2, TracksWhatHasNoIds) {
  bus().parameters["detections"] = std::string("vision");
  bus().parameters["tracker"] = true;
  ASSERT_EQ(run([] {
              for (int k = 0; k < 40; ++k) {
                bus().deliver("pose", pose_at(0, 0, 1));
                vision_msgs::msg::Detection3DArray seen;
                seen.header.frame_id = "map";
                tern_ros::set_stamp(seen.header.stamp, bus().now());
                seen.detections.resize(2);
                for (int p = 0; p < 2; ++p) {
                  auto& at = seen.detections[static_cast<std::size_t>((p + k) % 2)].bbox.center.position;
                  at.x = p == 0 ? 20.0 + 0.1 * k : 24.0 - 0.1 * k;
                  at.y = 3.0 * p;
                  at.z = 1.0;
                }
                bus().deliver("detections", seen);
                for (int tenth = 0; tenth < 10; ++tenth) tick();
              }
            }),
            0);
  EXPECT_EQ(log_count("have no id"), 0);
  EXPECT_EQ(diagnosed("things that move"), "2");
}

/// A man walks before the camera.
TEST_F(Ros2, TracksWhatItsCameraSeesMove) {
  constexpr int kWidth = 160, kHeight = 120;
  auto& p = bus().parameters;
  p["clusters"] = std::string("person");
  p["ground"] = 0.0;
  p["free_radius"] = 1.6;
  p["angle_margin"] = 0.005;
  p["depth_margin"] = p["pose_margin"] = 0.02;
  geometry_msgs::msg::Transform mounting;
  mounting.rotation = {-0.5, 0.5, -0.5, 0.5};
  bus().transforms["base_link camera_optical"] = mounting;
  sensor_msgs::msg::CameraInfo info;
  info.width = kWidth;
  info.height = kHeight;
  info.p = {80.0, 0.0, 79.5, 0.0, 0.0, 80.0, 59.5, 0.0, 0.0, 0.0, 1.0, 0.0};
  sensor_msgs::msg::Image image;
  image.header.frame_id = "camera_optical";
  image.encoding = "32FC1";
  image.width = kWidth;
  image.height = kHeight;
  image.step = 4 * kWidth;
  image.data.resize(image.step * kHeight);
  ASSERT_EQ(run([&] {
              bus().deliver("camera/camera_info", info);
              bus().deliver("pose", pose_at(0, 0, 1.5));
              bus().deliver("goal", pose_at(0, 0, 1.5));
              for (int k = 0; k < 200; ++k) {
                bus().deliver("pose", pose_at(0, 0, 1.5));
                for (int pixel = 0; k % 10 == 0 && pixel < kWidth * kHeight; ++pixel) {
                  const tern::Vec3 ray{1.0, (79.5 - pixel % kWidth) / 80.0, (59.5 - pixel / kWidth) / 80.0};
                  const auto depth = static_cast<float>(tern_test::Scene().way({0.0, 0.0, 1.5}, ray, 0.01 * k));
                  std::memcpy(image.data.data() + 4 * pixel, &depth, sizeof depth);
                }
                tern_ros::set_stamp(image.header.stamp, bus().now());
                if (k % 10 == 0) bus().deliver("camera/image", image);
                tick();
              }
            }),
            0);
  EXPECT_TRUE(log_has("what the sensors see move is tracked, as of class person"));
  EXPECT_EQ(diagnosed("things that move"), "1");
}

TEST_F(Ros2, TakesObjectsOfAutoware) {
  bus().parameters["detections"] = std::string("autoware");
  autoware_perception_msgs::msg::PredictedObjects seen;
  seen.header.frame_id = "map";
  seen.objects.resize(3);
  for (std::uint8_t k = 0; k < 3; ++k) {
    seen.objects[k].object_id.uuid[15] = k;
    seen.objects[k].existence_probability = k == 2 ? 0.1f : 0.9f;
    seen.objects[k].kinematics.initial_pose_with_covariance.pose.position.x = 50.0;
  }
  ASSERT_EQ(run([&] {
              bus().deliver("pose", pose_at(0, 0, 1));
              tern_ros::set_stamp(seen.header.stamp, bus().now());
              bus().deliver("detections", seen);
              tick();
            }),
            0);
  EXPECT_EQ(diagnosed("things that move"), "2");
}

TEST_F(Ros2, RefusesParametersByName) {
  bus().parameters["cell"] = -1.0;
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(log_has("parameter cell = -1 m is refused: allowed are from 0.02 to 2 m"));
  bus().parameters["cell"] = std::string("small");
  EXPECT_EQ(run(), 1);
  bus().parameters.erase("cell");
  bus().parameters["output"] = std::string("joystick");
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(log_has("parameter output = \"joystick\" is refused"));
  bus().parameters.erase("output");
  bus().parameters["detections"] = std::string("radar");
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(log_has("parameter detections = \"radar\" is refused"));
  bus().parameters["detections"] = std::string("vision");
  bus().parameters["other_class"] = std::string("boat");
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(log_has("parameter other_class = \"boat\" is refused"));
  bus().parameters.erase("other_class");
  bus().parameters["clusters"] = std::string("person");
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(log_has("parameter clusters is refused together with detections"));
  bus().parameters.erase("detections");
  bus().parameters["clusters"] = std::string("boat");
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(log_has("parameter clusters = \"boat\" is refused: allowed are none, person"));
}

TEST_F(Ros2, FollowsItsLifecycle) {
  bus().parameters["autostart"] = false;
  ASSERT_EQ(run([] {}), 0);
  rclcpp::the_bus() = std::make_unique<rclcpp::Bus>();
  Node node;
  EXPECT_EQ(node.configure().id(), 2);
  bus().deliver("pose", pose_at(0, 0, 1));
  EXPECT_EQ(bus().count("command/trajectory"), 0);
  EXPECT_EQ(node.activate().id(), 3);
  bus().set_clock(bus().now() + 2 * kTick);
  EXPECT_GT(bus().count("command/trajectory"), 0);
  EXPECT_EQ(node.deactivate().id(), 2);
  EXPECT_EQ(node.cleanup().id(), 1);
  EXPECT_EQ(node.configure().id(), 2);
}

}  // namespace
