// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What detectors and trackers publish of things that move, as sightings: vision_msgs/Detection3DArray and
// autoware_perception_msgs/PredictedObjects. As in inputs.hpp, message types are parameters.
#ifndef TERN_ROS_DETECTIONS_HPP
#define TERN_ROS_DETECTIONS_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "tern_onboard/pose.hpp"
#include "tern_onboard/sighting.hpp"
#include "tern_ros/classes.hpp"
#include "tern_ros/inputs.hpp"

namespace tern_ros {

/// How a message of detections is to be read.
struct DetectionFrame {
  tern::Pose pose{};        ///< of the message's frame in the world's
  std::int64_t stamp = 0;   ///< ns
  double error = 0.0;       ///< m: of that pose, and
  double turn_error = 0.0;  ///< rad: of its attitude, which counts with the distance from it
};

/// Upright bounds of a box of full edges `size` about its centre, turned by a unit quaternion: how far its corners are
/// from the axis, and from the centre up or down. What the sighting's class says is left as it is if the box is empty.
inline void set_size(const double (&quaternion)[4], const tern::Vec3& size, tern_onboard::Sighting& sighting) {
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) return;
  sighting.radius = sighting.half_height = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const tern::Vec3 at{0.5 * size.x, (corner & 1) != 0 ? 0.5 * size.y : -0.5 * size.y,
                        (corner & 2) != 0 ? 0.5 * size.z : -0.5 * size.z};
    const tern::Vec3 turned = tern_onboard::turn(quaternion, at);
    sighting.radius = std::max(sighting.radius, std::hypot(turned.x, turned.y));
    sighting.half_height = std::max(sighting.half_height, std::abs(turned.z));
  }
}

/// The largest deviation of the first three of the six numbers of a geometry_msgs covariance. `otherwise` if all of it
/// is zero, or its first number is -1, which both mean that nothing is known.
template <typename Covariance>
double deviation_of(const Covariance& six, double otherwise) {
  const bool is_empty = std::all_of(six.begin(), six.end(), [](double c) { return c == 0.0; });
  if (is_empty || six[0] == -1.0) return otherwise;
  const double three[9] = {six[0], six[1], six[2], six[6], six[7], six[8], six[12], six[13], six[14]};
  return tern_onboard::largest_deviation(three);
}

/// Where it is in the world, with the errors of the frame. The orientation becomes unit; false if it is none.
inline bool place(const DetectionFrame& frame, const tern::Pose& at, tern::Pose& world,
                  tern_onboard::Sighting& sighting) {
  tern::Pose unit = at;
  if (!tern_onboard::make_unit(unit.quaternion)) return false;
  world = tern_onboard::compose(frame.pose, unit);
  sighting.stamp = frame.stamp;
  sighting.position = world.position;
  sighting.error = frame.error + frame.turn_error * tern_onboard::length(unit.position);
  return true;
}

// Who it is. ROS 2 has Detection3D::id, older versions tracking_id, and the oldest nothing.
template <typename Detection>
auto identity_of(const Detection& detection, int) -> decltype(std::string(detection.id)) {
  return detection.id;
}
template <typename Detection>
auto identity_of(const Detection& detection, int) -> decltype(std::string(detection.tracking_id)) {
  return detection.tracking_id;
}
template <typename Detection>
std::string identity_of(const Detection&, long) {
  return {};
}

// A hypothesis: its class and score are in a part of it in ROS 2, and its own before; a class is a text or a number.
inline std::string label_from(const std::string& label) {
  return label;
}
inline std::string label_from(std::int64_t label) {
  return std::to_string(label);
}
template <typename Hypothesis>
auto label_of(const Hypothesis& h, int) -> decltype(std::string(h.hypothesis.class_id)) {
  return h.hypothesis.class_id;
}
template <typename Hypothesis>
auto label_of(const Hypothesis& h, long) -> decltype(label_from(h.id)) {
  return label_from(h.id);
}
template <typename Hypothesis>
auto score_of(const Hypothesis& h, int) -> decltype(static_cast<double>(h.hypothesis.score)) {
  return h.hypothesis.score;
}
template <typename Hypothesis>
auto score_of(const Hypothesis& h, long) -> decltype(static_cast<double>(h.score)) {
  return h.score;
}

/// A vision_msgs/Detection3D. It has no velocity, and perhaps no name. Nothing if its score is too low, or for the
/// reason in `why`; `label` is its class if that is not known.
template <typename Detection>
std::optional<tern_onboard::Sighting> read_detection(const Detection& detection, const DetectionFrame& frame,
                                                     const DetectionOptions& options, std::string& label,
                                                     std::string& why) {
  tern_onboard::Sighting sighting;
  using Results = std::decay_t<decltype(detection.results)>;
  const typename Results::value_type* best = nullptr;
  for (const auto& result : detection.results) {
    if (best == nullptr || score_of(result, 0) > score_of(*best, 0)) best = &result;
  }
  if (best != nullptr && !(score_of(*best, 0) >= options.least_score)) return {};
  sighting.kind = class_of(options, best == nullptr ? "" : label_of(*best, 0), label);
  const auto& box = detection.bbox;
  const bool has_box = box.size.x > 0.0 && box.size.y > 0.0 && box.size.z > 0.0;
  tern::Pose world{};
  if (!place(frame, pose_of(has_box || best == nullptr ? box.center : best->pose.pose), world, sighting)) {
    why = "a detection is left out whose orientation is no unit quaternion";
    return {};
  }
  set_size(world.quaternion, vector_of(box.size), sighting);
  const std::string id = identity_of(detection, 0);
  if (!id.empty()) sighting.name = "detection " + id;
  sighting.deviation = best == nullptr ? options.deviation : deviation_of(best->pose.covariance, options.deviation);
  return sighting;
}

/// What autoware calls its labels; "" for those that say nothing of a class.
inline std::string autoware_label(std::uint8_t label) {
  static const char* const kLabels[] = {"",           "car",     "truck",      "bus",   "trailer",
                                        "motorcycle", "bicycle", "pedestrian", "animal"};
  return label < sizeof kLabels / sizeof *kLabels ? kLabels[label] : "";
}

/// The size of an autoware_perception_msgs/Shape: a box, a cylinder whose diameter is dimensions.x, or a prism over a
/// footprint around the centre.
template <typename Shape>
void set_shape(const Shape& shape, const double (&quaternion)[4], tern_onboard::Sighting& sighting) {
  constexpr int kCylinder = 1, kPolygon = 2;
  const tern::Vec3 size = vector_of(shape.dimensions);
  if (shape.type != kCylinder && shape.type != kPolygon) return set_size(quaternion, size, sighting);
  double radius = 0.5 * size.x;
  if (shape.type == kPolygon) {
    radius = 0.0;
    for (const auto& point : shape.footprint.points) {
      radius = std::max(radius, std::hypot(static_cast<double>(point.x), static_cast<double>(point.y)));
    }
  }
  if (!(radius > 0.0 && size.z > 0.0)) return;
  sighting.radius = radius;
  sighting.half_height = 0.5 * size.z;
}

/// An autoware_perception_msgs/PredictedObject: where it is and how fast, not its predicted paths. Nothing if it hardly
/// exists, or for the reason in `why`; `label` as for read_detection().
template <typename Object>
std::optional<tern_onboard::Sighting> read_object(const Object& object, const DetectionFrame& frame,
                                                  const DetectionOptions& options, std::string& label,
                                                  std::string& why) {
  tern_onboard::Sighting sighting;
  if (!(static_cast<double>(object.existence_probability) >= options.least_score)) return {};
  using Classes = std::decay_t<decltype(object.classification)>;
  const typename Classes::value_type* best = nullptr;
  for (const auto& one : object.classification) {
    if (best == nullptr || one.probability > best->probability) best = &one;
  }
  sighting.kind = class_of(options, best == nullptr ? "" : autoware_label(best->label), label);
  const auto& pose = object.kinematics.initial_pose_with_covariance;
  const auto& twist = object.kinematics.initial_twist_with_covariance;
  tern::Pose world{};
  if (!place(frame, pose_of(pose.pose), world, sighting)) {
    why = "an object is left out whose orientation is no unit quaternion";
    return {};
  }
  static const char kDigits[] = "0123456789abcdef";
  sighting.name = "object ";
  for (const std::uint8_t byte : object.object_id.uuid) {
    sighting.name += kDigits[byte >> 4];
    sighting.name += kDigits[byte & 15];
  }
  set_shape(object.shape, world.quaternion, sighting);
  sighting.deviation = deviation_of(pose.covariance, options.deviation);
  // The twist is in the object's own axes, x ahead.
  sighting.has_velocity = true;
  sighting.velocity = tern_onboard::turn(world.quaternion, vector_of(twist.twist.linear));
  sighting.speed_deviation = deviation_of(twist.covariance, options.speed_deviation);
  sighting.speed_error = frame.turn_error * tern_onboard::length(sighting.velocity);
  return sighting;
}

}  // namespace tern_ros

#endif
