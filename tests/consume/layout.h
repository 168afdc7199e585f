/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Where each field of the C interface lies: TERN_LAYOUT(FIELD) calls FIELD(type, field) for every one. Compiled as C
 * and as C++ it must give the same numbers. */
#ifndef TERN_TESTS_CONSUME_LAYOUT_H
#define TERN_TESTS_CONSUME_LAYOUT_H

#include "tern/tern_corridor.h"
#include "tern/tern_far_way.h"
#include "tern/tern_fleet.h"
#include "tern/tern_flight.h"
#include "tern/tern_yaw.h"
#include "tern_stacks/stacks.h"

#define TERN_LAYOUT(FIELD)  \
  TERN_LAYOUT_IN(FIELD)     \
  TERN_LAYOUT_OUT(FIELD)    \
  TERN_LAYOUT_MAP(FIELD)    \
  TERN_LAYOUT_FLIGHT(FIELD) \
  TERN_LAYOUT_YAW(FIELD) TERN_LAYOUT_EXPORT(FIELD) TERN_LAYOUT_CORRIDOR(FIELD) TERN_LAYOUT_FLEET(FIELD)

/* clang-format off */
#define TERN_LAYOUT_IN(FIELD)                                                                                        \
  FIELD(tern_vec3, x) FIELD(tern_vec3, y) FIELD(tern_vec3, z)                                                        \
  FIELD(tern_voxel, x) FIELD(tern_voxel, y) FIELD(tern_voxel, z)                                                     \
  FIELD(tern_box, lower) FIELD(tern_box, upper)                                                                      \
  FIELD(tern_grid_spec, origin) FIELD(tern_grid_spec, cell) FIELD(tern_grid_spec, dims)                              \
  FIELD(tern_grid_spec, boundary) FIELD(tern_grid_spec, radius)                                                      \
  FIELD(tern_state, position) FIELD(tern_state, velocity) FIELD(tern_state, acceleration)                            \
  FIELD(tern_state, jerk) FIELD(tern_limits, j_max) FIELD(tern_limits, j_horizontal)                                 \
  FIELD(tern_limits, thrust_max) FIELD(tern_limits, thrust_min) FIELD(tern_limits, tilt_tangent)                     \
  FIELD(tern_limits, rate_max)                                                                                       \
  FIELD(tern_limits, v_max) FIELD(tern_limits, a_max) FIELD(tern_limits, v_min) FIELD(tern_limits, a_min)            \
  FIELD(tern_limits, v_horizontal) FIELD(tern_limits, a_horizontal)                                                  \
  FIELD(tern_budget, search) FIELD(tern_budget, shortcut) FIELD(tern_budget, corridor)                               \
  FIELD(tern_budget, trajectory)                                                                                     \
  FIELD(tern_halfspace, normal) FIELD(tern_halfspace, offset)                                                        \
  FIELD(tern_fence, planes) FIELD(tern_fence, count) FIELD(tern_fence, kind) FIELD(tern_fence, from) FIELD(tern_fence, until) FIELD(tern_fence, clock_error)                                        \
  FIELD(tern_track_piece, duration) FIELD(tern_track_piece, points)                                                  \
  FIELD(tern_track, measured) FIELD(tern_track, until) FIELD(tern_track, position) FIELD(tern_track, velocity)       \
  FIELD(tern_track, pieces) FIELD(tern_track, piece_count) FIELD(tern_track, id) FIELD(tern_track, kind)             \
  FIELD(tern_track, shape) FIELD(tern_track, end) FIELD(tern_track, radius) FIELD(tern_track, half)                  \
  FIELD(tern_track, error) FIELD(tern_track, error_speed) FIELD(tern_track, error_growth) FIELD(tern_track, reach)   \
  FIELD(tern_request, tracks) FIELD(tern_request, track_count) FIELD(tern_request, rest_clear)                       \
  FIELD(tern_via, position) FIELD(tern_via, tolerance) FIELD(tern_via, stop) FIELD(tern_via, has_velocity)           \
  FIELD(tern_via, velocity) FIELD(tern_via, dwell) FIELD(tern_request, vias) FIELD(tern_request, via_count)                                 \
  FIELD(tern_request, start) FIELD(tern_request, goal) FIELD(tern_request, limits) FIELD(tern_request, budget)       \
  FIELD(tern_request, begin) FIELD(tern_request, search) FIELD(tern_request, goal_mode)                           \
  FIELD(tern_request, fences) FIELD(tern_request, fence_count) FIELD(tern_request, previous)                         \
  FIELD(tern_request, time_weight) FIELD(tern_request, previous_time)                                                \
  FIELD(tern_yaw, cosine) FIELD(tern_yaw, sine) FIELD(tern_yaw, rate)

#define TERN_LAYOUT_FLEET(FIELD)                                                                                     \
  FIELD(tern_fleet_spec, id) FIELD(tern_fleet_spec, incarnation) FIELD(tern_fleet_spec, priority)                    \
  FIELD(tern_fleet_spec, radius) FIELD(tern_fleet_spec, clock_error) FIELD(tern_fleet_spec, tick)                    \
  FIELD(tern_fleet_spec, speed) FIELD(tern_fleet_spec, range) FIELD(tern_fleet_range, join)                          \
  FIELD(tern_fleet_range, heard) FIELD(tern_fleet_range, speed) FIELD(tern_fleet_range, within)                      \
  FIELD(tern_fleet_range, lease) FIELD(tern_fleet_report, announcement) FIELD(tern_fleet_report, blocked)             \
  FIELD(tern_fleet_report, blocked_by) FIELD(tern_fleet_report, cleared) FIELD(tern_neighbour, id)                   \
  FIELD(tern_neighbour, incarnation) FIELD(tern_neighbour, heard) FIELD(tern_neighbour, priority)                    \
  FIELD(tern_neighbour, has_right_of_way) FIELD(tern_neighbour, has_left) FIELD(tern_neighbour, ready) \
  FIELD(tern_neighbour, flies) FIELD(tern_neighbour, may_fly)

#define TERN_LAYOUT_OUT(FIELD)                                                                                       \
  FIELD(tern_segment, duration) FIELD(tern_segment, points) FIELD(tern_segment, polyhedron)                          \
  FIELD(tern_trajectory, begin) FIELD(tern_trajectory, count) FIELD(tern_trajectory, origin) FIELD(tern_trajectory, segments)                      \
  FIELD(tern_sample, position) FIELD(tern_sample, velocity) FIELD(tern_sample, acceleration)                         \
  FIELD(tern_sample, jerk) FIELD(tern_sample, snap)                                                                  \
  FIELD(tern_flat_state, thrust) FIELD(tern_flat_state, attitude) FIELD(tern_flat_state, quaternion)                 \
  FIELD(tern_flat_state, body_rates) FIELD(tern_flat_state, singularity)                                             \
  FIELD(tern_stage_report, work) FIELD(tern_stage_report, bound) FIELD(tern_stage_report, ticks)                     \
  FIELD(tern_proof_report, until) FIELD(tern_proof_report, finding) FIELD(tern_proof_report, segment)                \
  FIELD(tern_via_passage, time) FIELD(tern_via_passage, distance) FIELD(tern_report, via) FIELD(tern_report, vias)    \
  FIELD(tern_proof_report, via) FIELD(tern_proof_report, fence) FIELD(tern_proof_report, derivative)                 \
  FIELD(tern_proof_report, axis) FIELD(tern_proof_report, voxel) FIELD(tern_proof_report, excess)                    \
  FIELD(tern_proof_report, track) FIELD(tern_report, track) FIELD(tern_report, conflict)                             \
  FIELD(tern_report, rest_clear_until) FIELD(tern_report, waits) FIELD(tern_report, goal_free)                                                    \
  FIELD(tern_proof_report, work)                                                                                     \
  FIELD(tern_high_water, nodes) FIELD(tern_high_water, open) FIELD(tern_high_water, jump_points)                     \
  FIELD(tern_high_water, segments) FIELD(tern_high_water, planes) FIELD(tern_high_water, local_boxes)                \
  FIELD(tern_high_water, active) FIELD(tern_high_water, qp_iterations) FIELD(tern_high_water, qp_solves)             \
  FIELD(tern_high_water, separations) FIELD(tern_high_water, flood_words) FIELD(tern_diagnostics, seed)              \
  FIELD(tern_report, status) FIELD(tern_report, stage) FIELD(tern_report, field) FIELD(tern_report, raw_occupied)    \
  FIELD(tern_report, has_nearest_free) FIELD(tern_report, quality)                  \
  FIELD(tern_report, optimiser) FIELD(tern_report, entered) FIELD(tern_report, nearest_free)                         \
  FIELD(tern_report, fence) FIELD(tern_report, check) FIELD(tern_report, finer_cell)                                 \
  FIELD(tern_report, has_reachable) FIELD(tern_report, goal_missed) FIELD(tern_report, reachable)                    \
  FIELD(tern_report, diagnostics) FIELD(tern_diagnostics, stages) FIELD(tern_diagnostics, timing_known)              \
  FIELD(tern_diagnostics, high_water) FIELD(tern_diagnostics, detours) FIELD(tern_diagnostics, search_bound)         \
  FIELD(tern_diagnostics, search_used)

#define TERN_LAYOUT_FLIGHT(FIELD)                                                                                    \
  FIELD(tern_unseen_voxel, center) FIELD(tern_unseen_voxel, views) FIELD(tern_unseen_voxel, directions)                \
  FIELD(tern_flight_refusal, field) FIELD(tern_flight_refusal, fence)                                                  \
  FIELD(tern_flight_refusal, blocked_by) FIELD(tern_flight_refusal, blocked_at)                                        \
  FIELD(tern_flight_refusal, distance) FIELD(tern_flight_refusal, needed)                                              \
  FIELD(tern_flight_spec, limits) FIELD(tern_flight_spec, time_weight)                                               \
  FIELD(tern_flight_spec, tick)                                                                                      \
  FIELD(tern_flight_spec, work_per_tick) FIELD(tern_flight_spec, plan_work) FIELD(tern_flight_spec, horizon)         \
  FIELD(tern_flight_spec, near) FIELD(tern_flight_spec, yaw_rate)                                                      \
  FIELD(tern_flight_spec, fences) FIELD(tern_flight_spec, fence_count) FIELD(tern_flight_spec, stale_after) FIELD(tern_flight_spec, sensor) FIELD(tern_flight_spec, clearance) \
  FIELD(tern_flight_report, mode) FIELD(tern_flight_report, reason) FIELD(tern_flight_report, plan)                  \
  FIELD(tern_flight_report, asked) FIELD(tern_flight_report, committed) FIELD(tern_flight_report, dropped)           \
  FIELD(tern_flight_report, failed) FIELD(tern_flight_report, work) FIELD(tern_flight_report, contact_time)          \
  FIELD(tern_flight_report, contact_speed) FIELD(tern_flight_report, leg) FIELD(tern_flight_report, passed)          \
  FIELD(tern_flight_report, skipped) FIELD(tern_flight_report, waits_for_nose)                                       \
  FIELD(tern_flight_report, map_stale) FIELD(tern_flight_report, frame_age)                                          \
  FIELD(tern_flight_report, blocked_by) FIELD(tern_flight_report, blocked_at)                                         \
  FIELD(tern_flight_report, blocked_fence) FIELD(tern_flight_report, stray) FIELD(tern_flight_report, speed_share)    \
  FIELD(tern_flight_yaw, mode) FIELD(tern_flight_yaw, acceleration_max) FIELD(tern_flight_yaw, field_of_view)        \
  FIELD(tern_flight_yaw, start) FIELD(tern_flight_yaw, heading) FIELD(tern_flight_yaw, point)                        \
  FIELD(tern_flight_yaw, headings) FIELD(tern_flight_yaw, heading_count)                                             \
  FIELD(tern_command, sample) FIELD(tern_command, look_at)

#define TERN_LAYOUT_YAW(FIELD)                                                                                       \
  FIELD(tern_heading, cosine) FIELD(tern_heading, sine) FIELD(tern_timed_heading, time)                              \
  FIELD(tern_timed_heading, heading) FIELD(tern_yaw_request, mode) FIELD(tern_yaw_request, rate_max)                 \
  FIELD(tern_yaw_request, acceleration_max) FIELD(tern_yaw_request, start) FIELD(tern_yaw_request, start_rate)       \
  FIELD(tern_yaw_request, start_acceleration) FIELD(tern_yaw_request, heading) FIELD(tern_yaw_request, point)        \
  FIELD(tern_yaw_request, timed) FIELD(tern_yaw_request, timed_count) FIELD(tern_yaw_request, least_speed)           \
  FIELD(tern_yaw_request, least_distance) FIELD(tern_yaw_sample, yaw) FIELD(tern_yaw_sample, acceleration)           \
  FIELD(tern_yaw_sample, angle) FIELD(tern_yaw_plan, count) FIELD(tern_yaw_plan, lead)                               \
  FIELD(tern_yaw_plan, polynomial) FIELD(tern_yaw_plan, step) FIELD(tern_yaw_plan, points)

#define TERN_LAYOUT_EXPORT(FIELD)                                                                                    \
  FIELD(tern_setpoint, position) FIELD(tern_setpoint, velocity) FIELD(tern_setpoint, acceleration)                   \
  FIELD(tern_setpoint, jerk) FIELD(tern_setpoint, yaw) FIELD(tern_setpoint, yaw_rate)                                \
  FIELD(tern_export_error, position) FIELD(tern_export_error, velocity) FIELD(tern_export_error, acceleration)       \
  FIELD(tern_export_error, jerk) FIELD(tern_export_error, yaw) FIELD(tern_export_error, yaw_rate)                    \
  FIELD(tern_mavlink_header, system) FIELD(tern_mavlink_header, component)                                           \
  FIELD(tern_mavlink_header, target_system) FIELD(tern_mavlink_header, target_component)                             \
  FIELD(tern_mavlink_header, sequence) FIELD(tern_mavlink_header, time_boot_ms)                                      \
  FIELD(tern_crazyflie_piece, p) FIELD(tern_crazyflie_piece, duration)                                               \
  FIELD(tern_px4_parameters, mpc_xy_vel_max) FIELD(tern_px4_parameters, mpc_z_vel_max_up)                            \
  FIELD(tern_px4_parameters, mpc_z_vel_max_dn) FIELD(tern_px4_parameters, mpc_acc_hor)                               \
  FIELD(tern_px4_parameters, mpc_acc_up_max) FIELD(tern_px4_parameters, mpc_acc_down_max)                            \
  FIELD(tern_px4_parameters, mpc_jerk_auto) FIELD(tern_ardupilot_parameters, wpnav_speed_m_s)                        \
  FIELD(tern_ardupilot_parameters, wpnav_speed_up_m_s) FIELD(tern_ardupilot_parameters, wpnav_speed_dn_m_s)          \
  FIELD(tern_ardupilot_parameters, wpnav_accel_m_s2) FIELD(tern_ardupilot_parameters, wpnav_accel_z_m_s2)            \
  FIELD(tern_ardupilot_parameters, psc_jerk_xy_m_s3) FIELD(tern_ardupilot_parameters, psc_jerk_z_m_s3)               \
  FIELD(tern_px4_parameters, mpc_tiltmax_air) FIELD(tern_px4_parameters, mpc_thr_hover)                              \
  FIELD(tern_px4_parameters, mpc_thr_min) FIELD(tern_px4_parameters, mpc_thr_max)                                    \
  FIELD(tern_px4_parameters, mc_rollrate_max) FIELD(tern_px4_parameters, mc_pitchrate_max)                           \
  FIELD(tern_ardupilot_parameters, angle_max_deg) FIELD(tern_ardupilot_parameters, mot_thst_hover)                   \
  FIELD(tern_ardupilot_parameters, atc_rate_r_max_deg) FIELD(tern_ardupilot_parameters, atc_rate_p_max_deg)          \
  FIELD(tern_crazyflie_parameters, x_vel_max) FIELD(tern_crazyflie_parameters, y_vel_max)                            \
  FIELD(tern_crazyflie_parameters, z_vel_max) FIELD(tern_crazyflie_parameters, r_limit)                              \
  FIELD(tern_crazyflie_parameters, p_limit) FIELD(tern_crazyflie_parameters, thrust_base)                            \
  FIELD(tern_crazyflie_parameters, thrust_min)

#define TERN_LAYOUT_MAP(FIELD)                                                                                       \
  FIELD(tern_map_spec, origin) FIELD(tern_map_spec, cell) FIELD(tern_map_spec, dims) FIELD(tern_map_spec, radius)    \
  FIELD(tern_map_spec, range) FIELD(tern_map_spec, depth_margin) FIELD(tern_map_spec, depth_margin_square)           \
  FIELD(tern_map_spec, pose_margin) FIELD(tern_map_spec, angle_margin) FIELD(tern_map_spec, scan_pixel)              \
  FIELD(tern_map_spec, hits) FIELD(tern_map_spec, misses) FIELD(tern_map_spec, support) FIELD(tern_map_spec, age) FIELD(tern_map_spec, slack)      \
  FIELD(tern_map_spec, pixels) FIELD(tern_map_spec, prior) FIELD(tern_map_spec, prior_count)                         \
  FIELD(tern_far_way_spec, ahead) FIELD(tern_far_way_spec, patience) FIELD(tern_pose, position) FIELD(tern_pose, quaternion)                                                            \
  FIELD(tern_depth_view, z16) FIELD(tern_depth_view, z32) FIELD(tern_depth_view, width)                              \
  FIELD(tern_depth_view, height) FIELD(tern_depth_view, stride) FIELD(tern_depth_view, fx)                           \
  FIELD(tern_depth_view, fy) FIELD(tern_depth_view, cx) FIELD(tern_depth_view, cy) FIELD(tern_depth_view, scale)     \
  FIELD(tern_depth_view, min) FIELD(tern_depth_view, max) FIELD(tern_depth_view, no_return)                         \
  FIELD(tern_beams, directions) FIELD(tern_beams, ranges) FIELD(tern_beams, count) FIELD(tern_beams, min) FIELD(tern_beams, max)

#define TERN_LAYOUT_CORRIDOR(FIELD)                                                                                  \
  FIELD(tern_polyhedron, count) FIELD(tern_polyhedron, planes)                                                       \
  FIELD(tern_polyhedron, from) FIELD(tern_polyhedron, to)

/* A field's place and size, and the size of the type that it is in. */
typedef struct { const char* type; const char* field; size_t offset, size, whole; } layout_entry;
#define TERN_LAYOUT_ENTRY(type, field) {#type, #field, offsetof(type, field), sizeof(((type*)0)->field), sizeof(type)},
/* clang-format on */

#endif
