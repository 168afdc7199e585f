// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_offboard start EAST NORTH UP MAP [blind]: flies to a point of the local frame, and streams setpoints at 50 Hz.
// The flight begins when the armed vehicle is switched to offboard. blind: it needs no range sensors. tern_offboard
// stop: comes to rest and ends the stream; PX4 then does what COM_OBL_RC_ACT says.
#include <px4_platform_common/px4_config.h>
#include <px4_platform_common/tasks.h>
#include <px4_platform_common/time.h>
#include <stdlib.h>

#include "flight.hpp"

namespace {

using tern_offboard::Offboard;
using tern_offboard::RangeSensors;
using tern_offboard::Seen;
using tern_offboard::Topics;

constexpr int kStackBytes = 12288;  // Tern takes at most 7,680 of them; the rest is PX4's calls

constexpr size_t kPathBytes = 128;

tern::Vec3 goal;
char map_path[kPathBytes];
bool is_blind = false;
volatile bool should_exit = false;
volatile bool running = false;

void stream(const Seen& seen, Topics& topics, RangeSensors& sensors) {
  Offboard offboard(seen, goal, is_blind);
  hrt_abstime next = hrt_absolute_time();
  while (!offboard.is_over()) {
    if (should_exit) offboard.stop();
    offboard.tick(topics.look(), topics, sensors);
    next += tern_offboard::kPeriod;
    const hrt_abstime now = hrt_absolute_time();
    if (next > now) {
      px4_usleep(static_cast<unsigned>(next - now));
    } else {
      next = now;  // late: no burst
    }
  }
}

int run(int, char*[]) {
  static RangeSensors sensors;  // too large for the stack
  uint32_t faults = 0;
  Topics topics;
  const Seen seen = topics.look();
  if (tern::self_test(tern::kConfigurationHash, &faults) != tern::Status::kOk) {
    PX4_ERR("self-test failed, faults 0x%x", static_cast<unsigned>(faults));
  } else if (!seen.valid) {
    PX4_ERR("no valid estimate of position, velocity and heading");
  } else if (seen.offboard) {
    PX4_ERR("in offboard already: switch to another mode first");
  } else if (tern_offboard::prepare(map_path, seen.here, goal, seen.now)) {
    PX4_INFO("ready: switch to offboard");
    stream(seen, topics, sensors);
  }
  running = false;
  return 0;
}

bool read_number(const char* word, double& number) {
  char* end = nullptr;
  number = strtod(word, &end);
  return end != word && *end == '\0' && fabs(number) < 1e6;  // false for NaN
}

int start(int argc, char* argv[]) {
  if (running) {
    PX4_ERR("running: tern_offboard stop first");
    return 1;
  }
  tern::Vec3 to{};
  const bool has_goal =
      argc > 5 && read_number(argv[2], to.x) && read_number(argv[3], to.y) && read_number(argv[4], to.z);
  const bool wants_blind = argc == 7 && strcmp(argv[6], "blind") == 0;
  if (!has_goal || (argc > 6 && !wants_blind) || strlen(argv[5]) >= kPathBytes) {
    PX4_ERR("start takes EAST NORTH UP, in metres, the path of a map and, to fly without range sensors, blind");
    return 1;
  }
  goal = to;
  strcpy(map_path, argv[5]);
  is_blind = wants_blind;
  should_exit = false;
  running = true;
  // Below everything that flies: a plan may take long.
  const int task =
      px4_task_spawn_cmd("tern_offboard", SCHED_DEFAULT, SCHED_PRIORITY_DEFAULT - 20, kStackBytes, run, nullptr);
  if (task < 0) running = false;
  return task < 0 ? 1 : 0;
}

}  // namespace

extern "C" __EXPORT int tern_offboard_main(int argc, char* argv[]) {
  if (argc > 1 && strcmp(argv[1], "start") == 0) return start(argc, argv);
  if (argc > 1 && strcmp(argv[1], "stop") == 0) {
    should_exit = true;
    return 0;
  }
  PX4_INFO("tern_offboard start EAST NORTH UP MAP [blind] (m, local frame) | stop; %s",
           running ? "running" : "not running");
  return 1;
}
