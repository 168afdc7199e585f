// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/map_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>
#include <utility>

#include "host/map/cloud_file.hpp"
#include "host/map/known_space.hpp"
#include "host/map/map_warnings.hpp"
#include "host/map/octomap_file.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

std::string beside(const std::string& scenario, const std::string& file) {
  return (std::filesystem::path(scenario).parent_path() / file).string();
}

/// Grows a box that holds points; the first one makes it.
void include(const Vec3& p, bool first, Box& box) {
  if (first) box = {p, p};
  box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y), std::min(box.lower.z, p.z)};
  box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y), std::max(box.upper.z, p.z)};
}

Vec3 middle_of(const Box& b) {
  return {0.5 * (b.lower.x + b.upper.x), 0.5 * (b.lower.y + b.upper.y), 0.5 * (b.lower.z + b.upper.z)};
}

/// What the files of one scenario add to it.
class Loader {
 public:
  explicit Loader(Scenario& scenario) : scenario_(scenario), reach_(reach_of(scenario)) {}

  void load(MapFile& file) {
    place_ = file.place;
    points_.clear();
    const Place source{beside(scenario_.name, file.name), 0};
    const std::string bytes = read_bytes(source.file, kMaxMapBytes);
    if (file.kind == MapFileKind::kOctomap) {
      add(parse_octomap(bytes, source), file.content);
    } else {
      add(parse_cloud(bytes, source), file.content);
    }
    warn_of_map_file(file, file.content, points_, scenario_, scenario_.warnings);
  }

 private:
  void add(const Octomap& map, MapContent& content) {
    for (const OctomapLeaf& leaf : map.leaves) {
      const Box box = map.box(leaf);
      const bool within = meets(box, reach_);
      content.free_within = content.free_within || (within && !leaf.occupied);
      if (!leaf.occupied) continue;
      include(box.lower, content.read == 0, content.extent);
      include(box.upper, false, content.extent);
      ++content.read;
      content.outside += within ? 0 : 1;
      points_.push_back(middle_of(box));
      if (within) add_block(box);
    }
    scenario_.known.push_back(std::make_shared<const KnownSpace>(map, reach_, place_));
  }

  /// Voxels are counted from the boundary's lower corner, as those of the grid.
  void add(Cloud&& cloud, MapContent& content) {
    const Vec3& o = scenario_.boundary.lower;
    const double cell = scenario_.resolution;
    content.read = cloud.points.size() + cloud.dropped;
    content.dropped = cloud.dropped;
    content.has_viewpoint = cloud.has_viewpoint;
    points_ = std::move(cloud.points);
    std::set<std::array<std::int64_t, 3>> voxels;
    for (const Vec3& p : points_) {
      include(p, &p == points_.data(), content.extent);
      if (!meets({p, p}, reach_)) {
        ++content.outside;
        continue;
      }
      const auto index = [cell](double x) { return static_cast<std::int64_t>(std::floor(x / cell + 1e-9)); };
      voxels.insert({index(p.z - o.z), index(p.y - o.y), index(p.x - o.x)});
    }
    for (const auto& v : voxels) {
      const auto at = [&](int dx) {
        return Vec3{o.x + cell * static_cast<double>(v[2] + dx), o.y + cell * static_cast<double>(v[1] + dx),
                    o.z + cell * static_cast<double>(v[0] + dx)};
      };
      add_block({at(0), at(1)});
    }
  }

  void add_block(const Box& box) {
    if (++count_ > kMaxFileBlocks) {
      throw ScenarioError(place_, "the map files have more than " + std::to_string(kMaxFileBlocks) +
                                      " obstacles within the boundary: make it smaller, or the maps coarser");
    }
    scenario_.blocks.push_back({box, false});
  }

  Scenario& scenario_;
  Box reach_;
  Place place_;
  std::vector<Vec3> points_;  ///< of the file that is being read
  std::size_t count_ = 0;
};

}  // namespace

std::vector<std::string> input_paths(const Scenario& scenario) {
  std::vector<std::string> paths{scenario.name};
  for (const MapFile& file : scenario.map_files) paths.push_back(beside(scenario.name, file.name));
  return paths;
}

void load_map_files(Scenario& scenario) {
  Loader loader(scenario);
  for (MapFile& file : scenario.map_files) {
    try {
      loader.load(file);
    } catch (const RecordError& error) {
      if (error.place().file == file.place.file) throw;
      throw ScenarioError(file.place, error.what());
    }
  }
}

}  // namespace tern_host
