// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tells a flight of the things around it: measurements with errors, late or not at all, as a tracker gives them.
#ifndef TERN_HOST_THINGS_DETECTOR_HPP
#define TERN_HOST_THINGS_DETECTOR_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "host/flight/flight_tape.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "host/nanoseconds.hpp"
#include "host/things/cluster_detector.hpp"
#include "host/things/thing_motion.hpp"
#include "host/things/tracking_watch.hpp"
#include "tern/flight.hpp"

namespace tern_host {

struct DetectorCounts {
  std::uint64_t measured = 0;  ///< measurements that reached the flight
  std::uint64_t left_out = 0;  ///< that did not, because the flight knew kMaxFlightTracks nearer things
  std::size_t most_known = 0;  ///< things at once
};

class Detector {
 public:
  /// Both must outlive the detector. `things` are the motions of `world.things`; their time 0 is `begin` on the
  /// flight's clock, ns. The first of them is track `first_id`.
  Detector(const FlightWorld& world, const std::vector<ThingMotion>& things, std::int64_t begin = 0,
           std::uint32_t first_id = 0);

  /// To be called at every tick: where the vehicle is, and where it believes to be.
  void take(std::int64_t t, const tern::Vec3& place, const tern::Vec3& estimate);
  /// A frame or scan was taken from `eye`: if sensors are the detector, they measure what is due.
  template <typename Frame>
  void see(const Frame& frame, const tern::Vec3& eye, const tern::RollingMap& map);
  /// Tells the flight what has arrived: to be called before every tick that is done. It forgets what is expected to be
  /// out of range, and what was not measured for `thing_memory`. If it knows as many things as it can, the farthest one
  /// makes room for a nearer one.
  void deliver(std::int64_t t, tern::Flight& flight, FlightTape& tape);
  /// What the flight was told last of a thing that it knows; null if it knows it not.
  const tern::Track* known(std::size_t thing) const;
  /// True if `point` is in a thing of which the flight was told by a measurement from about t, ns: in its shape at t,
  /// whose radius and half extents are grown by its error and `room`, m. As RollingMap::explain_hits() has it.
  bool explains(const tern::Vec3& point, std::int64_t t, double room) const;
  /// True if a vehicle at `place` at time t, ns, is nearer than its clearance to the tube of a thing that the flight
  /// knows, or knew lately.
  bool meets(const tern::Vec3& place, std::int64_t t) const;
  const DetectorCounts& counts() const { return counts_; }
  bool uses_clusters() const { return world_.settings.detection_source == "clusters"; }
  TrackingFigures tracking() const { return watch_.figures(); }

 private:
  struct Measurement {
    std::size_t thing;  ///< kNoThing if it is of none
    tern::Track track;
  };
  using Known = std::map<std::uint32_t, Measurement>;
  struct Forgotten {
    std::int64_t when;
    tern::Track track;
  };
  struct Scan {
    std::int64_t taken;
    tern::Vec3 from;  ///< where the vehicle believed to be
    std::vector<Measurement> seen;
  };

  bool sees(const tern::Vec3& eye, const tern::Vec3& place) const;
  double seconds(std::int64_t t) const { return seconds_of(t - begin_); }
  Measurement measure(std::size_t thing, std::int64_t t, const tern::Vec3& pose_error);
  void swap_identities(std::vector<Measurement>& seen);
  void tell(const Scan& scan, std::int64_t t, tern::Flight& flight, FlightTape& tape);
  std::int64_t memory() const { return static_cast<std::int64_t>(1e9 * world_.settings.thing_memory); }
  void forget_lost(const Scan& scan, tern::Flight& flight, FlightTape& tape);
  Known::iterator forget(Known::iterator one, std::int64_t t, tern::Flight& flight, FlightTape& tape);
  bool make_room(const Scan& scan, double far, tern::Flight& flight, FlightTape& tape);

  const FlightWorld& world_;
  const std::vector<ThingMotion>& things_;
  std::int64_t begin_;
  Noise noise_;
  std::vector<std::uint32_t> ids_;
  std::deque<Scan> waiting_;
  Known known_;                      ///< to the flight, by their ids
  std::deque<tern::Track> told_;     ///< lately
  std::deque<Forgotten> forgotten_;  ///< lately
  std::int64_t taken_ = 0;
  DetectorCounts counts_;
  ClusterDetector clusters_;
  TrackingWatch watch_;
};

}  // namespace tern_host

#endif
