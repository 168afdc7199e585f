// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/map_files.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>

#include "host/map/cloud_file.hpp"
#include "host/map/known_space.hpp"
#include "host/map/octomap_file.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

std::string beside(const std::string& scenario, const std::string& file) {
  return (std::filesystem::path(scenario).parent_path() / file).string();
}

/// The boundary, and as far around it as an obstacle can matter.
Box reach_of(const Scenario& scenario) {
  const double margin = scenario.clearance() + 2.0 * scenario.resolution;
  const Box& b = scenario.boundary;
  return {{b.lower.x - margin, b.lower.y - margin, b.lower.z - margin},
          {b.upper.x + margin, b.upper.y + margin, b.upper.z + margin}};
}

bool meets(const Box& a, const Box& b) {
  return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y && b.lower.y < a.upper.y &&
         a.lower.z < b.upper.z && b.lower.z < a.upper.z;
}

/// What the files of one scenario add to it.
class Loader {
 public:
  explicit Loader(Scenario& scenario) : scenario_(scenario), reach_(reach_of(scenario)) {}

  void load(const MapFile& file) {
    place_ = file.place;
    const Place source{beside(scenario_.name, file.name), 0};
    const std::string bytes = read_bytes(source.file, kMaxMapBytes);
    if (file.kind == MapFileKind::kOctomap) {
      add(parse_octomap(bytes, source));
    } else {
      add(parse_cloud(bytes, source));
    }
  }

 private:
  void add(const Octomap& map) {
    for (const OctomapLeaf& leaf : map.leaves) {
      if (leaf.occupied) add_block(map.box(leaf));
    }
    scenario_.known.push_back(std::make_shared<const KnownSpace>(map, reach_, place_));
  }

  /// Voxels are counted from the boundary's lower corner, as those of the grid.
  void add(const std::vector<Vec3>& points) {
    const Vec3& o = scenario_.boundary.lower;
    const double cell = scenario_.resolution;
    std::set<std::array<std::int64_t, 3>> voxels;
    for (const Vec3& p : points) {
      if (!meets({p, p}, reach_)) continue;
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
    if (!meets(box, reach_)) return;
    if (++count_ > kMaxFileBlocks) {
      throw ScenarioError(place_, "the map files have more than " + std::to_string(kMaxFileBlocks) +
                                      " obstacles within the boundary: make it smaller, or the maps coarser");
    }
    scenario_.blocks.push_back({box, false});
  }

  Scenario& scenario_;
  Box reach_;
  Place place_;
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
  for (const MapFile& file : scenario.map_files) {
    try {
      loader.load(file);
    } catch (const RecordError& error) {
      if (error.place().file == file.place.file) throw;
      throw ScenarioError(file.place, error.what());
    }
  }
}

}  // namespace tern_host
