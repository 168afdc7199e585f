// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tern_onboard {
namespace {

/// How far what a frame shows at this distance may be from where it was, m.
double error_at(const tern::MapSpec& spec, double distance) {
  return spec.pose_margin + spec.angle_margin * distance + spec.depth_margin +
         spec.depth_margin_square * distance * distance;
}

}  // namespace

bool scan_is_whole(const PointScan& scan) {
  const std::size_t last = std::max(scan.x, std::max(scan.y, scan.z)) + sizeof(float);
  if (scan.data == nullptr || scan.width == 0 || scan.height == 0 || last > scan.point_bytes) return false;
  if (scan.point_bytes > scan.bytes / scan.width || scan.width * scan.point_bytes > scan.row_bytes) return false;
  return scan.row_bytes <= scan.bytes / scan.height;
}

Sensors::Sensors(const WatchSettings& settings, std::int32_t pixels, Detector* detector)
    : settings_(settings), pixels_(pixels), detector_(detector) {}

int Sensors::add(const SensorSpec& spec) {
  Sensor sensor;
  sensor.spec = spec;
  sensor.state.name = spec.name;
  sensors_.push_back(std::move(sensor));
  return count() - 1;
}

std::string Sensors::set_lens(int index, const Lens& lens) {
  Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  const bool finite =
      std::isfinite(lens.fx) && std::isfinite(lens.fy) && std::isfinite(lens.cx) && std::isfinite(lens.cy);
  if (!finite || !(lens.fx > 0.0) || !(lens.fy > 0.0) || lens.width < 1 || lens.height < 1) {
    return called(index) +
           ": the lens is refused: width, height, fx and fy must be above 0, and all numbers finite. Is "
           "the camera calibrated?";
  }
  sensor.lens = lens;
  sensor.state.lens_known = true;
  sensor.binning = 1;
  while ((lens.width / sensor.binning) * (lens.height / sensor.binning) > pixels_) ++sensor.binning;
  return {};
}

std::string Sensors::set_mounting(int index, const tern::Pose& in_body) {
  tern::Pose pose = in_body;
  if (!is_finite(pose.position) || !make_unit(pose.quaternion)) {
    return called(index) + ": the mounting is refused: its position is not finite, or its quaternion has not norm 1";
  }
  Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  sensor.in_body = pose;
  sensor.state.mounting_known = true;
  return {};
}

bool Sensors::offer(int index, const DepthImage& image, std::int64_t now, Notices& notices) {
  Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  const std::int64_t stamp = image.stamp + std::llround(1e9 * sensor.spec.settings.time_offset);
  if (!size_is_good(sensor, index, image, now, notices)) return false;
  if (!stamp_is_good(sensor, index, stamp, now, notices)) return false;
  read(sensor, image, sensor.frame);
  sensor.frame.stamp = stamp;
  return true;
}

bool Sensors::offer(int index, const PointScan& scan, std::int64_t now, Notices& notices) {
  Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  const std::int64_t stamp = scan.stamp + std::llround(1e9 * sensor.spec.settings.time_offset);
  if (!scan_is_whole(scan)) {
    notices.bad(Fault::kFrameInvalid, index, now,
                called(index) + ": a scan is refused: it is empty, or its sizes do not agree with its bytes");
    return false;
  }
  if (!sensor.state.mounting_known) {
    notices.bad(Fault::kFrameUnready, index, now, called(index) + ": scans wait: its mounting is not known yet");
    return false;
  }
  if (!stamp_is_good(sensor, index, stamp, now, notices)) return false;
  read(scan, sensor.frame);
  sensor.frame.stamp = stamp;
  return true;
}

bool Sensors::size_is_good(const Sensor& sensor, int index, const DepthImage& image, std::int64_t now,
                           Notices& notices) {
  const auto refuse = [&](Fault fault, const std::string& text) {
    notices.bad(fault, index, now, called(index) + ": " + text);
    return false;
  };
  if (!sensor.state.lens_known || !sensor.state.mounting_known) {
    return refuse(Fault::kFrameUnready, std::string("images wait: its ") +
                                            (sensor.state.lens_known ? "mounting" : "lens") + " is not known yet");
  }
  if (image.width != sensor.lens.width || image.height != sensor.lens.height) {
    return refuse(Fault::kFrameInvalid, "an image of " + std::to_string(image.width) + " x " +
                                            std::to_string(image.height) + " pixels is refused: the lens is for " +
                                            std::to_string(sensor.lens.width) + " x " +
                                            std::to_string(sensor.lens.height));
  }
  const std::size_t row = static_cast<std::size_t>(image.width) * (image.metres ? 4 : 2);
  const std::size_t rows = static_cast<std::size_t>(image.height);
  if (image.data == nullptr || image.row_bytes < row || image.row_bytes > image.bytes / rows ||
      (image.metres && image.big_endian)) {
    return refuse(Fault::kFrameInvalid,
                  "an image is refused: it is empty, its sizes do not agree with its bytes, or "
                  "its floats are big-endian");
  }
  return true;
}

/// If it is, the sensor's frame waits with this stamp.
bool Sensors::stamp_is_good(Sensor& sensor, int index, std::int64_t stamp, std::int64_t now, Notices& notices) {
  const auto refuse = [&](Fault fault, const std::string& text) {
    notices.bad(fault, index, now, called(index) + ": " + text);
    return false;
  };
  if (stamp > now + kStampAhead) {
    return refuse(Fault::kFrameAhead, "frames are refused: their stamps are " + milliseconds(stamp - now) +
                                          " ahead of the clock. Synchronise the clocks, or set time_offset");
  }
  if (now - stamp > std::llround(1e9 * settings_.frame_age)) {
    return refuse(Fault::kFrameOld,
                  "frames are refused: their stamps are " + milliseconds(now - stamp) +
                      " behind the clock, and frame_age is less. Synchronise the clocks, or find what "
                      "delays them");
  }
  if (sensor.any && stamp == sensor.newest) {
    return refuse(Fault::kFrameRepeated, "a frame is left out: it has the stamp of the last one");
  }
  if (sensor.any && stamp < sensor.newest) {
    return refuse(Fault::kFrameBackward, "a frame is left out: its stamp is before the last one's");
  }
  if (sensor.frame.waits) notices.count(Fault::kFrameReplaced);
  sensor.any = sensor.frame.waits = true;
  sensor.newest = stamp;
  return true;
}

/// Takes a frame that waited too long out of the queue.
bool Sensors::drop_old(int index, std::int64_t now, Notices& notices) {
  Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  if (now - sensor.frame.stamp <= std::llround(1e9 * settings_.frame_age)) return false;
  sensor.frame.waits = false;
  notices.bad(Fault::kFrameNoPose, index, now,
              called(index) + ": a frame is left out: no pose with its stamp or a later one came within frame_age");
  return true;
}

/// The sensor whose turn it is of those with a frame that can be entered, and the body's pose then; -1 if there is
/// none.
int Sensors::next(const Poses& poses, std::int64_t now, Notices& notices, tern::Pose& body) {
  int best = -1;
  for (int k = 0; k < count(); ++k) {
    Frame& frame = sensors_[static_cast<std::size_t>(k)].frame;
    if (!frame.waits || drop_old(k, now, notices)) continue;
    tern::Pose pose{};
    const PoseAt found = poses.at(frame.stamp, pose);
    if (found == PoseAt::kGone || found == PoseAt::kGap) {
      frame.waits = false;
      notices.bad(Fault::kFrameNoPose, k, now,
                  called(k) + (found == PoseAt::kGap
                                   ? ": a frame is left out: the poses around its stamp are further apart than pose_gap"
                                   : ": a frame is left out: it was taken before the first pose"));
    }
    if (found != PoseAt::kKnown) continue;
    if (best >= 0 && !sensors_[static_cast<std::size_t>(k)].is_before(sensors_[static_cast<std::size_t>(best)]))
      continue;
    best = k;
    body = pose;
  }
  return best;
}

std::vector<Sighting> Sensors::enter(tern::RollingMap& map, tern::FlightRecorder& record, const Poses& poses,
                                     std::int64_t now, Notices& notices) {
  tern::Pose body{};
  const int index = next(poses, now, notices, body);
  if (index < 0) return {};
  Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  std::swap(in_work_, sensor.frame);
  in_work_.waits = sensor.frame.waits = false;
  const tern::Pose eye = compose(body, sensor.in_body);
  Seen seen;
  const tern::Status begun = begin(map, record, index, eye, seen);
  if (begun != tern::Status::kRunning) {
    notices.bad(
        Fault::kFrameRefused, index, now,
        called(index) + ": the map refused a frame: " + tern::status_name(begun) + ", " + tern::status_meaning(begun));
    return {};
  }
  ++sensor.state.taken;
  sensor.state.last_stamp = sensor.heard = in_work_.stamp;
  notices.good(Fault::kFrameInvalid, Fault::kFrameRefused, index, now,
               (called(index) + ": frames are good again").c_str());
  if (seen.is_all) {
    notices.good(Fault::kThingsFull, Fault::kThingsFull, index, now,
                 (called(index) + ": all that moves is tracked again").c_str());
  } else {
    notices.bad(Fault::kThingsFull, index, now,
                called(index) +
                    ": more seems to move in a frame than can be tracked, and some is left out. Nothing keeps clear of "
                    "it. Does something that stands lie within free_radius? Are pose_margin, angle_margin and "
                    "depth_margin large enough?");
  }
  for (Sighting& thing : seen.things) {
    thing.name = "sensor " + std::to_string(index) + " " + thing.name;
    thing.error += error_at(map.spec(), length(minus(thing.position, eye.position)));
  }
  return std::move(seen.things);
}

/// The detector compares the frame with the map as it was before.
tern::Status Sensors::begin(tern::RollingMap& map, tern::FlightRecorder& record, int index, const tern::Pose& eye,
                            Seen& seen) {
  const Sensor& sensor = sensors_[static_cast<std::size_t>(index)];
  const std::int64_t t = in_work_.stamp;
  if (sensor.spec.kind == SensorKind::kPoints) {
    const tern::Beams beams = beams_of(sensor, eye);
    if (detector_ != nullptr) seen = detector_->see(index, map, beams, eye.position, t);
    const tern::Status begun = map.begin_scan(beams, eye.position, t);
    record.scan(beams, eye.position, t, begun);
    return begun;
  }
  const tern::DepthView view = view_of(sensor);
  if (detector_ != nullptr) seen = detector_->see(index, map, view, eye, t);
  const tern::Status begun = map.begin_frame(view, eye, t);
  record.frame(view, eye, t, begun);
  return begun;
}

/// Of the scan in work, in the map's axes.
tern::Beams Sensors::beams_of(const Sensor& sensor, const tern::Pose& eye) {
  directions_.clear();
  ranges_.clear();
  for (std::size_t k = 0; k + 2 < in_work_.points.size(); k += 3) {
    const tern::Vec3 point{in_work_.points[k], in_work_.points[k + 1], in_work_.points[k + 2]};
    directions_.push_back(turn(eye.quaternion, point));
    ranges_.push_back(static_cast<float>(length(point)));
  }
  return {directions_.data(), ranges_.data(), ranges_.size(), sensor.spec.settings.least,
          std::numeric_limits<double>::infinity()};
}

/// Of the image in work.
tern::DepthView Sensors::view_of(const Sensor& sensor) const {
  const Lens& lens = sensor.lens;
  const double b = sensor.binning;
  tern::DepthView view{};
  view.z32 = in_work_.depths.data();
  view.width = view.stride = in_work_.width;
  view.height = in_work_.height;
  view.fx = lens.fx / b;
  view.fy = lens.fy / b;
  view.cx = (lens.cx - 0.5 * (b - 1.0)) / b;
  view.cy = (lens.cy - 0.5 * (b - 1.0)) / b;
  view.scale = 1.0;
  view.min = 0.0;
  view.max = std::numeric_limits<float>::max();
  view.no_return = sensor.spec.settings.no_return;
  return view;
}

void Sensors::restart() {
  for (Sensor& sensor : sensors_) {
    sensor.frame.waits = sensor.any = false;
    sensor.heard = 0;
  }
  if (detector_ != nullptr) detector_->restart();
}

}  // namespace tern_onboard
