# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sources of tern_scenario, from this folder: scenarios, sessions, plan files and the page's data of a plan. The demo for
# browsers compiles them as well, so they may use nlohmann-json and nothing else that has to be installed.
set(tern_scenario_sources
  atomic_file.cpp closed_start.cpp earth_frame.cpp fence_choice.cpp fence_cover.cpp fence_record.cpp figures.cpp finding_text.cpp
  grid_layout.cpp instant.cpp met_text.cpp nearest_fence.cpp nearest_thing.cpp number.cpp occupied_text.cpp plan_file.cpp presence.cpp scenario.cpp scenario_records.cpp session.cpp text_records.cpp track_record.cpp track_sample.cpp
  via_record.cpp
  map/byte_reader.cpp map/cloud_file.cpp map/cloud_table.cpp map/known_space.cpp map/map_files.cpp map/map_warnings.cpp
  map/octomap_file.cpp map/pcd_header.cpp map/ply_header.cpp map/scenario_grid.cpp map/unpack.cpp
  page/plan_run.cpp page/run_json.cpp
  yaw/yaw_units.cpp yaw/yaw_wish.cpp)
list(TRANSFORM tern_scenario_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
