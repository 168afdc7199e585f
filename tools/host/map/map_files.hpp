// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map files of a scenario: OctoMaps and point clouds.
#ifndef TERN_HOST_MAP_MAP_FILES_HPP
#define TERN_HOST_MAP_MAP_FILES_HPP

#include <string>
#include <vector>

#include "host/scenario.hpp"

namespace tern_host {

/// Larger files are refused before they are parsed.
constexpr std::size_t kMaxMapBytes = std::size_t{1024} * 1024 * 1024;
/// Blocks that the files of a scenario make at most.
constexpr std::size_t kMaxFileBlocks = std::size_t{2} * 1024 * 1024;

/// Reads the scenario's map files, whose names are relative to the scenario's own. What is occupied near the boundary
/// becomes blocks: the leaves of an OctoMap, and the voxels of the scenario's resolution that hold a point. What an
/// OctoMap says is free goes into `known`. Throws ScenarioError with the line of the record.
void load_map_files(Scenario& scenario);

/// The scenario's file and its map files.
std::vector<std::string> input_paths(const Scenario& scenario);

}  // namespace tern_host

#endif
