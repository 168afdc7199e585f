// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight node does with its messages, for ROS 1 and ROS 2.
#ifndef TERN_ROS_FLIGHT_TOPICS_HPP
#define TERN_ROS_FLIGHT_TOPICS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tern_onboard/onboard.hpp"
#include "tern_onboard/record_files.hpp"
#include "tern_ros/detections.hpp"
#include "tern_ros/inputs.hpp"
#include "tern_ros/options.hpp"

namespace tern_ros {

/// Finds the pose of a frame in another one, as tf2 knows it. False with the reason in `why`.
using Lookup =
    std::function<bool(const std::string& parent, const std::string& child, tern::Pose& pose, std::string& why)>;
/// Writes to the node's log, as a warning if `bad`.
using Log = std::function<void(bool bad, const std::string& text)>;

/// Gives the detections of one scan names and velocities.
using Tracker = std::function<std::vector<tern_onboard::Sighting>(
    std::int64_t stamp, const std::vector<tern_onboard::Sighting>& detections)>;

/// Its calls come from one thread; Onboard's may come from others.
class FlightTopics {
 public:
  FlightTopics(tern_onboard::Onboard& onboard, Options options, Lookup lookup, Log log)
      : onboard_(onboard),
        options_(std::move(options)),
        lookup_(std::move(lookup)),
        log_(std::move(log)),
        record_(onboard, options_.record) {}
  /// After the last tick.
  ~FlightTopics() { save(); }
  FlightTopics(const FlightTopics&) = delete;
  FlightTopics& operator=(const FlightTopics&) = delete;

  void add_sensor(const std::string& name, tern_onboard::SensorKind kind,
                  const tern_onboard::SensorSettings& settings) {
    onboard_.add_sensor({name, kind, settings});
    sensors_.push_back({name, false, {}});
  }

  template <typename CameraInfo>
  void on_lens(int sensor, const CameraInfo& message) {
    const tern_onboard::Lens lens = lens_of(message);
    Sensor& known = sensors_[static_cast<std::size_t>(sensor)];
    if (same(lens, known.lens)) return;
    known.lens = lens;
    const tern_onboard::Answer answer = onboard_.set_lens(sensor, lens);
    if (!answer.ok) log_(true, answer.text);
  }

  template <typename Image>
  void on_image(int sensor, const Image& message, std::int64_t now) {
    tern_onboard::DepthImage image{};
    find_mounting(sensor, message.header.frame_id);
    if (!read_image(message, image)) {
      return once(name_of(sensor) + " encoding", name_of(sensor) + ": images of encoding \"" + message.encoding +
                                                     "\" are refused: 16UC1 and 32FC1 are read");
    }
    onboard_.add_frame(sensor, image, now);
  }

  template <typename PointCloud2>
  void on_scan(int sensor, const PointCloud2& message, std::int64_t now) {
    tern_onboard::PointScan scan{};
    find_mounting(sensor, message.header.frame_id);
    if (!read_cloud(message, scan)) {
      return once(name_of(sensor) + " fields", name_of(sensor) +
                                                   ": clouds are refused that have no x, y and z of type "
                                                   "FLOAT32, or are big-endian");
    }
    onboard_.add_frame(sensor, scan, now);
  }

  /// nav_msgs/Odometry.
  template <typename Odometry>
  void on_odometry(const Odometry& message, std::int64_t now) {
    if (!in_frame(message.header.frame_id, "odometry")) return;
    if (!message.child_frame_id.empty() && message.child_frame_id != options_.body_frame) {
      return once("child", "odometry is refused: its child frame is \"" + message.child_frame_id +
                               "\", and body_frame is \"" + options_.body_frame + "\"");
    }
    onboard_.add_pose({stamp_of(message.header.stamp), pose_of(message.pose.pose)}, now);
  }
  /// geometry_msgs/PoseStamped.
  template <typename PoseStamped>
  void on_pose(const PoseStamped& message, std::int64_t now) {
    if (!in_frame(message.header.frame_id, "pose")) return;
    onboard_.add_pose({stamp_of(message.header.stamp), pose_of(message.pose)}, now);
  }
  template <typename VehicleOdometry>
  void on_px4_odometry(const VehicleOdometry& message, std::int64_t now) {
    tern_onboard::StampedPose pose{};
    std::uint32_t resets = 0;
    if (!read_px4_odometry(message, pose, resets))
      return once("px4", "odometry is refused: it is not in the NED frame");
    onboard_.add_pose(pose, now, resets);
  }

  /// A cloud of obstacles that are known, in any frame that tf2 knows.
  template <typename PointCloud2>
  void on_known(const PointCloud2& message) {
    tern::Pose pose{};
    std::vector<tern::Vec3> points;
    if (!find_frame(message.header.frame_id, "known obstacles", pose)) return;
    if (!read_points(message, pose, points)) {
      return log_(true,
                  "known obstacles are refused: the cloud is empty, has no x, y and z of type FLOAT32, is "
                  "big-endian, or its sizes do not agree");
    }
    onboard_.add_known_points(points);
  }

  /// From now on, what is seen at one stamp goes through this, which gives it names and velocities.
  void set_tracker(Tracker tracker) { tracker_ = std::move(tracker); }
  /// vision_msgs/Detection3DArray.
  template <typename Detections>
  void on_detections(const Detections& message, std::int64_t now) {
    take_things(message.header, message.detections, now, [](auto&&... args) { return read_detection(args...); });
  }
  /// autoware_perception_msgs/PredictedObjects.
  template <typename Objects>
  void on_objects(const Objects& message, std::int64_t now) {
    take_things(message.header, message.objects, now, [](auto&&... args) { return read_object(args...); });
  }

  template <typename PoseStamped>
  void on_goal(const PoseStamped& message, std::int64_t now) {
    tern::Pose frame{};
    if (!find_frame(message.header.frame_id, "the goal", frame)) return;
    answer(onboard_.set_goal(tern_onboard::compose(frame, pose_of(message.pose)).position, now));
  }
  /// nav_msgs/Path: its poses are passed in order, and the last one is the goal.
  template <typename Path>
  void on_mission(const Path& message, std::int64_t now) {
    tern::Pose frame{};
    if (!find_frame(message.header.frame_id, "the mission", frame)) return;
    std::vector<tern::Via> points;
    for (const auto& stamped : message.poses) {
      tern::Via via{};
      via.position = tern_onboard::compose(frame, pose_of(stamped.pose)).position;
      via.tolerance = options_.via_tolerance;
      points.push_back(via);
    }
    answer(onboard_.set_mission(points, tern::ViaPolicy::kEnd, now));
  }
  void on_stop() { answer(onboard_.stop()); }

  /// Writes what was recorded to the flight's file, if the parameter `record` names a folder.
  void save() {
    const std::string fault = record_.save();
    if (!fault.empty()) log_(true, fault);
  }

  /// Writes what Onboard has to say to the log.
  void say() {
    for (const tern_onboard::Notice& notice : onboard_.take_notices()) log_(notice.bad, notice.text);
  }

 private:
  struct Sensor {
    std::string name;
    bool mounted;
    tern_onboard::Lens lens;
  };

  static bool same(const tern_onboard::Lens& a, const tern_onboard::Lens& b) {
    return a.width == b.width && a.height == b.height && a.fx == b.fx && a.fy == b.fy && a.cx == b.cx && a.cy == b.cy;
  }
  const std::string& name_of(int sensor) const { return sensors_[static_cast<std::size_t>(sensor)].name; }
  void answer(const tern_onboard::Answer& answer) { log_(!answer.ok, answer.text); }
  /// Says it unless it was said before.
  void once(const std::string& key, const std::string& text) {
    if (said_.insert(key).second) log_(true, text);
  }

  template <typename Header, typename List, typename Read>
  void take_things(const Header& header, const List& list, std::int64_t now, Read read) {
    DetectionFrame frame;
    std::vector<tern_onboard::Sighting> seen;
    frame.stamp = stamp_of(header.stamp);
    if (!find_seen_frame(header.frame_id, frame)) return;
    for (const auto& one : list) {
      std::string label, why;
      const auto sighting = read(one, frame, options_.detections, label, why);
      if (!why.empty()) once(why, why);
      if (!label.empty() && sighting) {
        once("label " + label,
             "detections with the label \"" + label + "\" count as other_class: name their class in detection_classes");
      }
      if (sighting) seen.push_back(*sighting);
    }
    if (tracker_) seen = tracker_(frame.stamp, seen);
    for (const tern_onboard::Sighting& sighting : seen) {
      if (!sighting.name.empty()) {
        onboard_.add_sighting(sighting, now);
      } else {
        once("no id", "detections are left out that have no id: set the parameter tracker");
      }
    }
  }
  /// The pose, at the stamp, of a frame in which things were seen: the world's, or one that is fixed to the body.
  bool find_seen_frame(const std::string& name, DetectionFrame& frame) {
    frame.pose = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    if (name == options_.frame) return true;
    const auto known = seen_from_.find(name);
    tern::Pose mounting{};
    std::string why;
    if (known != seen_from_.end()) {
      mounting = known->second;
    } else if (lookup_(options_.body_frame, name, mounting, why)) {
      seen_from_[name] = mounting;
    } else {
      once("detections " + name,
           "detections wait, because tf2 has no \"" + name + "\" in \"" + options_.body_frame + "\": " + why);
      return false;
    }
    tern::Pose body{};
    double late = 0.0;
    if (!onboard_.body_at(frame.stamp, body, late)) {
      once("detections poses", "detections are left out, because there is no pose at their stamps");
      return false;
    }
    const tern_onboard::Settings settings = onboard_.settings();
    frame.pose = tern_onboard::compose(body, mounting);
    frame.error = settings.map.pose_margin + late * settings.fly.speed;
    frame.turn_error = settings.map.angle_margin + late * settings.fly.yaw_rate;
    return true;
  }

  bool in_frame(const std::string& frame, const char* what) {
    if (frame == options_.frame) return true;
    once(what, std::string(what) + " is refused: it is in frame \"" + frame + "\", and frame is \"" + options_.frame +
                   "\". Set the parameter, or transform it first");
    return false;
  }
  /// The pose of a frame in the world's.
  bool find_frame(const std::string& frame, const std::string& what, tern::Pose& pose) {
    pose = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    std::string why;
    if (frame == options_.frame || lookup_(options_.frame, frame, pose, why)) return true;
    log_(true, what + " is refused: it is in frame \"" + frame + "\", and tf2 cannot turn that into \"" +
                   options_.frame + "\": " + why);
    return false;
  }
  /// The sensor's pose in the body, once tf2 knows it. It counts as fixed from then on.
  void find_mounting(int sensor, const std::string& frame) {
    Sensor& known = sensors_[static_cast<std::size_t>(sensor)];
    if (known.mounted) return;
    tern::Pose pose{};
    std::string why;
    if (!lookup_(options_.body_frame, frame, pose, why)) {
      return once(known.name + " tf", known.name + ": frames wait, because tf2 has no \"" + frame + "\" in \"" +
                                          options_.body_frame + "\": " + why);
    }
    const tern_onboard::Answer answer = onboard_.set_mounting(sensor, pose);
    known.mounted = answer.ok;
    if (!answer.ok) once(known.name + " mounting", answer.text);
  }

  tern_onboard::Onboard& onboard_;
  Options options_;
  Lookup lookup_;
  Log log_;
  tern_onboard::RecordFiles record_;
  std::vector<Sensor> sensors_;
  Tracker tracker_;
  std::map<std::string, tern::Pose> seen_from_;  // frames of detections, in the body
  std::set<std::string> said_;
};

}  // namespace tern_ros

#endif
