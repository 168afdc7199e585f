// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_offboard start EAST NORTH UP: plans from where the vehicle hovers to a point of the local frame, and streams the
// plan at 50 Hz. The flight begins when the armed vehicle is switched to offboard. tern_offboard stop: comes to rest
// and ends the stream; PX4 then does what COM_OBL_RC_ACT says.
#include <px4_platform_common/px4_config.h>
#include <px4_platform_common/tasks.h>
#include <px4_platform_common/time.h>
#include <stdlib.h>

#include "flight.hpp"

namespace {

using tern_offboard::Flight;
using tern_offboard::Seen;
using tern_offboard::Topics;

constexpr int kStackBytes = 12288;  // Tern takes at most 7,680 of them; the rest is PX4's calls

tern::Vec3 goal;
volatile bool should_exit = false;
volatile bool running = false;

void stream(const Seen& seen, Topics& topics) {
  Flight flight(seen);
  hrt_abstime next = hrt_absolute_time();
  while (!flight.is_over()) {
    if (should_exit) flight.stop();
    flight.tick(topics.look(), topics);
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
  uint32_t faults = 0;
  Topics topics;
  const Seen seen = topics.look();
  if (tern::self_test(tern::kConfigurationHash, &faults) != tern::Status::kOk) {
    PX4_ERR("self-test failed, faults 0x%x", static_cast<unsigned>(faults));
  } else if (!seen.valid) {
    PX4_ERR("no valid estimate of position, velocity and heading");
  } else if (seen.offboard) {
    PX4_ERR("in offboard already: switch to another mode first");
  } else if (make_plan(seen.here, goal)) {
    PX4_INFO("plan of %d ms; switch to offboard", static_cast<int>(1000.0 * tern::duration(tern_offboard::the_plan())));
    stream(seen, topics);
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
  if (argc != 5 || !read_number(argv[2], to.x) || !read_number(argv[3], to.y) || !read_number(argv[4], to.z)) {
    PX4_ERR("start takes three numbers: EAST NORTH UP, in metres");
    return 1;
  }
  goal = to;
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
  PX4_INFO("tern_offboard start EAST NORTH UP (m, local frame) | stop; %s", running ? "running" : "not running");
  return 1;
}
