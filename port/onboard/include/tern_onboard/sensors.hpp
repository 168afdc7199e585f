// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frames of several sensors: what each one is, and the queue from which the map takes them.
#ifndef TERN_ONBOARD_SENSORS_HPP
#define TERN_ONBOARD_SENSORS_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tern/flight_record.hpp"
#include "tern/map.hpp"
#include "tern_onboard/detector.hpp"
#include "tern_onboard/notices.hpp"
#include "tern_onboard/poses.hpp"
#include "tern_onboard/settings.hpp"

namespace tern_onboard {

enum class SensorKind : std::uint8_t {
  kDepth = 0,  ///< depth images without lens distortion
  kPoints,     ///< scans as points, corrected for motion, from one origin
};

/// The lens of a depth camera, pixels: a ray through pixel (u, v) has the direction ((u - cx) / fx, (v - cy) / fy, 1).
struct Lens {
  std::int32_t width = 0, height = 0;
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
};

struct SensorSpec {
  std::string name;  ///< in notices and diagnostics
  SensorKind kind = SensorKind::kDepth;
  SensorSettings settings;
};

/// A depth image of yours, copied when it is taken. Depth is along the optical axis. NaN, what is below
/// SensorSettings::least, not below SensorSettings::most or, in 16 bits, 65535 is no measurement. What 0 and +infinity
/// say is SensorSettings::no_return.
struct DepthImage {
  std::int64_t stamp;  ///< nanoseconds: the middle of the exposure, on the clock of Onboard::tick() but for time_offset
  const void* data;
  std::size_t bytes;  ///< of data
  std::int32_t width, height;
  std::size_t row_bytes;
  bool metres;      ///< true: 32-bit floats in metres (32FC1); false: 16-bit integers in millimetres (16UC1)
  bool big_endian;  ///< of 16-bit numbers; floats are little-endian
};

/// Points of yours in the sensor's axes, copied when they are taken: 32-bit floats, little-endian, metres. A point that
/// is not finite is a beam that is missing. One nearer than SensorSettings::least is a beam that knows nothing.
/// Nothing within the map's range is in the way of a point beyond it.
struct PointScan {
  std::int64_t stamp;
  const void* data;
  std::size_t bytes;
  std::size_t width, height;  ///< points in a row, and rows
  std::size_t row_bytes, point_bytes;
  std::size_t x, y, z;  ///< offsets in a point, bytes
};

/// All points of the scan lie in its bytes, and there is one at least.
bool scan_is_whole(const PointScan& scan);

/// What became of a sensor's frames.
struct SensorState {
  std::string name;
  std::uint64_t taken = 0;      ///< entered into the map
  std::int64_t last_stamp = 0;  ///< of the newest one that was entered; 0: none
  bool lens_known = false, mounting_known = false;
};

/// The sensors, each with room for one frame that waits: a newer one takes its place. The sensor of which the map has
/// heard nothing for the longest time is first, so sensors take turns however fast each is. A frame waits until there
/// are poses around its stamp. Not thread-safe.
class Sensors {
 public:
  /// `pixels`: of MapSpec. Larger images are divided into squares of pixels; each becomes one pixel with the least of
  /// its depths, and no measurement if one of them is none. `detector` gets each frame; it may be null.
  Sensors(const WatchSettings& settings, std::int32_t pixels, Detector* detector = nullptr);

  int add(const SensorSpec& spec);
  int count() const { return static_cast<int>(sensors_.size()); }
  /// The lens must be known before images come. Empty; or why it is refused.
  std::string set_lens(int sensor, const Lens& lens);
  /// The sensor's pose in body axes. A depth camera's own axes are x right, y down, z ahead. Empty, or why not.
  std::string set_mounting(int sensor, const tern::Pose& in_body);
  /// False if the frame is refused.
  bool offer(int sensor, const DepthImage& image, std::int64_t now, Notices& notices);
  bool offer(int sensor, const PointScan& scan, std::int64_t now, Notices& notices);
  /// The stamp of the last frame that was offered and not refused.
  std::int64_t newest(int sensor) const { return sensors_[static_cast<std::size_t>(sensor)].newest; }
  /// Begins to enter a frame, if one can be, and records it. To be called while the map is not busy. What the detector
  /// saw move in it, in the map's frame; their names begin with the sensor's number.
  std::vector<Sighting> enter(tern::RollingMap& map, tern::FlightRecorder& record, const Poses& poses, std::int64_t now,
                              Notices& notices);
  /// Forgets what waits, and all stamps: the clock or the map is a new one.
  void restart();
  const SensorState& state(int sensor) const { return sensors_[static_cast<std::size_t>(sensor)].state; }

 private:
  struct Frame {
    std::int64_t stamp = 0;
    bool waits = false;
    std::int32_t width = 0, height = 0;  // of depths
    std::vector<float> depths;
    std::vector<float> points;  // x, y, z
  };
  struct Sensor {
    SensorSpec spec;
    Lens lens;
    std::int32_t binning = 1;
    tern::Pose in_body{};
    Frame frame;
    std::int64_t newest = 0;  // stamp of the last one that was offered
    std::int64_t heard = 0;   // stamp of the last one that was entered; 0: none since restart()
    bool any = false;
    SensorState state;

    bool is_before(const Sensor& other) const {
      return heard != other.heard ? heard < other.heard : frame.stamp < other.frame.stamp;
    }
  };

  bool stamp_is_good(Sensor& sensor, int index, std::int64_t stamp, std::int64_t now, Notices& notices);
  bool size_is_good(const Sensor& sensor, int index, const DepthImage& image, std::int64_t now, Notices& notices);
  float depth_of(const Sensor& sensor, const DepthImage& image, std::int32_t u, std::int32_t v) const;
  void read(const Sensor& sensor, const DepthImage& image, Frame& frame) const;
  static void read(const PointScan& scan, Frame& frame);
  bool drop_old(int index, std::int64_t now, Notices& notices);
  int next(const Poses& poses, std::int64_t now, Notices& notices, tern::Pose& body);
  tern::Status begin(tern::RollingMap& map, tern::FlightRecorder& record, int index, const tern::Pose& eye, Seen& seen);
  tern::Beams beams_of(const Sensor& sensor, const tern::Pose& eye);
  tern::DepthView view_of(const Sensor& sensor) const;
  std::string called(int index) const { return sensors_[static_cast<std::size_t>(index)].spec.name; }

  WatchSettings settings_;
  std::int32_t pixels_;
  Detector* detector_;
  std::vector<Sensor> sensors_;
  Frame in_work_;  // the map reads it until its job is done
  std::vector<tern::Vec3> directions_;
  std::vector<float> ranges_;
};

}  // namespace tern_onboard

#endif
