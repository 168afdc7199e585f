// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenario files: a map, a query and the limits. The format is in docs/formats.md.
#ifndef TERN_HOST_SCENARIO_HPP
#define TERN_HOST_SCENARIO_HPP

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/earth_frame.hpp"
#include "host/fence_cover.hpp"
#include "host/fence_record.hpp"
#include "host/text_records.hpp"
#include "host/track_record.hpp"
#include "host/yaw/yaw_wish.hpp"
#include "tern/request.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

constexpr std::size_t kMaxStrips = 200000;

/// What is wrong with a scenario and where.
using ScenarioError = RecordError;

/// A solid cuboid; world frame, metres.
struct Block {
  tern::Box box;
  bool keepout;  ///< a geofence rather than matter; the planner treats both alike
};

class KnownSpace;

enum class MapFileKind { kOctomap, kCloud };

/// What was in a map file: a cloud's points, or an OctoMap's occupied leaves.
struct MapContent {
  std::size_t read = 0;        ///< all of them
  std::size_t dropped = 0;     ///< points with a coordinate that is not finite
  std::size_t outside = 0;     ///< too far beyond the boundary to matter
  tern::Box extent{};          ///< of all that are finite
  bool free_within = false;    ///< the OctoMap says of something in the boundary that it is free
  bool has_viewpoint = false;  ///< of a PCD file, which the points are not moved by
};

/// A file with a part of the map; its name is relative to the scenario's folder.
struct MapFile {
  MapFileKind kind;
  std::string name;
  Place place;
  MapContent content{};  ///< once it is read
};

/// What is made of space that no OctoMap shows: free, or solid.
enum class Unknown { kFree, kSolid };

/// World frame, metres, seconds.
struct Scenario {
  std::string name;  ///< the file's name as given
  EarthFrame earth;  ///< where on the earth the world frame is, if the file says so
  tern::Box boundary{};
  std::vector<Block> blocks;
  std::vector<std::string> keepouts;  ///< names of the blocks that are keepouts, in their order
  std::vector<FenceRecord> fences;
  std::optional<FenceCover> fences_within;  ///< what the fences were made for, if the file says so
  std::vector<FenceRecord> marked;          ///< keep-outs that are in the grid, as all voxels that they reach into
  std::vector<TrackRecord> tracks;
  double start_time = 0.0;  ///< when the plan begins
  double rest_clear = 0.0;  ///< for how long the plan's end must be clear of the tracks
  std::vector<MapFile> map_files;
  Unknown unknown = Unknown::kFree;
  std::vector<std::string> warnings;  ///< parts of the map that add nothing to it, each with its place
  std::vector<std::shared_ptr<const KnownSpace>> known;  ///< what the OctoMaps say is free, once they are read
  tern::State start{};
  tern::State goal{};
  std::vector<tern::Via> vias;
  tern::Limits limits{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};  ///< lower limits as given: 0 for the upper one's opposite
  double time_weight = tern::kDefaultTimeWeight;
  tern::SearchMode search = tern::SearchMode::kFast;
  tern::GoalMode goal_mode = tern::GoalMode::kExact;
  bool has_yaw = false;  ///< false: the flight has no yaw plan
  YawWish yaw;
  double resolution = 0.1;
  double radius = 0.25;
  double tracking_margin = 0.0;
  Place boundary_place;    ///< for errors that show only once the grid is laid out
  Place resolution_place;  ///< empty file name where the default holds

  /// The distance kept from obstacles, as tern::GridSpec::clearance().
  double clearance() const { return radius + tracking_margin; }
  /// True if there are things that move, or fences for a while.
  bool depends_on_time() const;
};

constexpr std::size_t kMaxMapFiles = 64;

/// One kind of limit, written out: lower < 0 < upper; horizontal 0 where there is none.
struct LimitRange {
  tern::Vec3 lower;
  tern::Vec3 upper;
  double horizontal;
};
LimitRange velocity_range(const tern::Limits& limits);
LimitRange acceleration_range(const tern::Limits& limits);
/// Infinite where an axis has no limit.
LimitRange jerk_range(const tern::Limits& limits);
bool limits_jerk(const tern::Limits& limits);

/// Must a scenario say where a flight starts and ends? A map alone needs neither.
enum class Ends { kRequired, kOptional };

/// Parses a whole scenario. `overrides` are "key=value" with the value's numbers separated by commas or blanks; they
/// replace records of the text, or stand for missing ones. Map files are not read. Throws ScenarioError.
Scenario parse_scenario(const std::string& text, const std::string& name,
                        const std::vector<std::string>& overrides = {}, Ends ends = Ends::kRequired);

/// Reads and parses a file of at most kMaxTextBytes, and the files of maps and plans that it names. Throws
/// ScenarioError.
Scenario read_scenario(const std::string& path, const std::vector<std::string>& overrides = {},
                       Ends ends = Ends::kRequired);

}  // namespace tern_host

#endif
