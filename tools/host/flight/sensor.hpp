// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_SENSOR_HPP
#define TERN_HOST_FLIGHT_SENSOR_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <variant>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_tape.hpp"
#include "host/flight/frame_watch.hpp"
#include "host/flight/lidar.hpp"
#include "host/vehicle/vehicle.hpp"

namespace tern_host {

/// Room that the largest frame takes in a record.
std::size_t frame_bytes(const FlightSettings& settings);

/// The vehicle's camera or lidar, and further cameras. Frames are taken at the sensor's rate, arrive late or not at
/// all, and enter the map when it is ready.
class Sensor {
 public:
  /// All must outlive the sensor. It sees `world`, of which `still_world` was there from the beginning.
  Sensor(const FlightWorld& world, const FlightWorld& still_world, const tern::MapSpec& spec, tern::RollingMap& map,
         Noise& noise, FlightTape& tape, Explains explains);

  using Frame = std::variant<DepthFrame, LidarScan>;

  /// To be called at every tick. `yaw`: where the camera looks, and `pitch`: how far a gimbal pitches it up, rad. What
  /// the sensor has taken, until the next call; null for nothing. Not what further cameras have.
  const Frame* take(std::int64_t t, const Vehicle& vehicle, double yaw, double pitch);
  /// Enters what has arrived, if the map is ready: to be called before every tick that is done.
  void deliver(std::int64_t t);
  const FrameWatch& watch() const { return watch_; }
  /// As FrameWatch::forget_world().
  void forget_world() { watch_.forget_world(); }

 private:
  Frame frame(std::int64_t t, const Vehicle& vehicle, double yaw, double pitch);
  Frame image(std::int64_t t, const Vehicle& vehicle, const SensorMount& mount, double yaw, double pitch);
  std::deque<Frame>* next(std::int64_t t);
  void enter(const DepthFrame& frame);
  void enter(const LidarScan& scan);

  const FlightWorld& world_;
  tern::RollingMap& map_;
  Noise& noise_;
  FlightTape& tape_;
  FrameWatch watch_;
  std::vector<std::deque<Frame>> waiting_;  ///< of the sensor, and of each further camera
  std::size_t turn_ = 0;                    ///< the queue that was looked at last
  Frame entered_;                           ///< in work in the map, or the last one that was
  std::int64_t taken_ = 0;
};

}  // namespace tern_host

#endif
