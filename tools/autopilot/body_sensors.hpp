// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sensors of a simulated vehicle, which send what they see to a companion's depth socket.
#ifndef TERN_AUTOPILOT_BODY_SENSORS_HPP
#define TERN_AUTOPILOT_BODY_SENSORS_HPP

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "depth_format.h"
#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"

namespace tern_autopilot {

class BodySensors {
 public:
  /// `kinds`: "camera", "cameras" (one to the left and one to the right), "lidar", or "both". `began`: the companion's
  /// clock at the flight's time 0. Throws std::runtime_error if the socket does not answer.
  BodySensors(const tern_host::FlightWorld& world, const std::string& kinds, const std::string& socket,
              std::int64_t began);
  ~BodySensors();
  BodySensors(const BodySensors&) = delete;
  BodySensors& operator=(const BodySensors&) = delete;

  /// Takes the frames that are due. `time`: of the flight, nanoseconds.
  void take(const tern::Pose& body, std::int64_t time, tern_host::Noise& noise);
  /// Sends those whose latency is over.
  void deliver(std::int64_t time);

 private:
  struct Unit {
    tern_depth_header header;
    double period, due;
  };
  struct Frame {
    std::int64_t taken;
    tern_depth_header header;
    std::vector<float> numbers;
  };

  void add_camera(double turned);
  void add_lidar();
  std::vector<float> scan(const tern::Pose& body, std::int64_t time, tern_host::Noise& noise) const;

  const tern_host::FlightWorld& world_;
  tern::DepthView lens_;
  std::int64_t began_;
  int socket_;
  std::vector<Unit> units_;
  std::deque<Frame> frames_;
};

}  // namespace tern_autopilot

#endif
