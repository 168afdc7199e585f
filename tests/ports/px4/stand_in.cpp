// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stand_in.hpp"

#include <cstring>

#include "parameters/param.h"
#include "px4_platform_common/tasks.h"

Px4 px4;

extern "C" int tern_offboard_main(int argc, char* argv[]);

int call(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(&word[0]);
  return tern_offboard_main(static_cast<int>(argv.size()), argv.data());
}

extern "C" {

hrt_abstime hrt_absolute_time() {
  return px4.now += px4.call_time;
}

int px4_usleep(unsigned microseconds) {
  px4.now += microseconds;
  px4.follow();
  if (px4.script) px4.script();
  if (px4.seconds() > 100.0) {  // a script that does not end the module has failed
    px4.status.nav_state = kPosition;
    call({"tern_offboard", "stop"});
  }
  return 0;
}

px4_task_t px4_task_spawn_cmd(const char*, int, int, int stack_size, px4_main_t entry, char* const[]) {
  px4.stack = stack_size;
  entry(0, nullptr);
  return 1;
}

param_t param_find(const char* name) {
  return std::strcmp(name, "MPC_XY_VEL_MAX") == 0 ? 1 : 0;
}

int param_get(param_t param, void* value) {
  if (param == 1) std::memcpy(value, &px4.speed_parameter, sizeof px4.speed_parameter);
  return param == 1 ? 0 : -1;
}

bool orb_publish(const orb_metadata* topic, const void* message) {
  if (std::strcmp(topic->name, "trajectory_setpoint") == 0) {
    px4.setpoints.push_back(*static_cast<const trajectory_setpoint_s*>(message));
  } else {
    px4.modes.push_back(*static_cast<const offboard_control_mode_s*>(message));
  }
  return true;
}

bool orb_copy(const orb_metadata* topic, uint8_t instance, void* message) {
  if (std::strcmp(topic->name, "vehicle_status") == 0) {
    *static_cast<vehicle_status_s*>(message) = px4.status;
  } else if (std::strcmp(topic->name, "vehicle_land_detected") == 0) {
    *static_cast<vehicle_land_detected_s*>(message) = px4.land;
  } else if (std::strcmp(topic->name, "vehicle_attitude") == 0) {
    *static_cast<vehicle_attitude_s*>(message) = px4.attitude();
  } else if (std::strcmp(topic->name, "distance_sensor") == 0) {
    *static_cast<distance_sensor_s*>(message) = px4.distances[instance].message;
  } else if (std::strcmp(topic->name, "obstacle_distance") == 0) {
    *static_cast<obstacle_distance_s*>(message) = px4.ring.message;
  } else {
    if (!px4.is_stale) px4.local.timestamp = px4.now;
    *static_cast<vehicle_local_position_s*>(message) = px4.local;
  }
  return true;
}

unsigned orb_sent(const orb_metadata* topic, uint8_t instance) {
  return std::strcmp(topic->name, "obstacle_distance") == 0 ? px4.ring.sent : px4.distances[instance].sent;
}

}  // extern "C"
