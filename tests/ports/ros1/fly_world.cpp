// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ros1_fly_world MEMBER SPOILT JUMP SENSORS CLOCK OUTPUT [record|play BAG]: sets the flight node's parameters, says
// "ready", waits for the node, flies the world or plays the bag to the node, and prints one line of JSON. SENSORS:
// camera, cameras, lidar or both. CLOCK: lockstep or real. OUTPUT: multidof or mavros. Exit status 0 if the goal was
// reached without contact.
//
// ros1_fly_world replay RECORD [BAG]: flies a node's record again, and compares it with the setpoints in a bag.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "ros1/flown_world.hpp"
#include "ros1/outlet.hpp"

int main(int argc, char** argv) {
  if (argc > 2 && argv[1] == std::string("replay")) return tern_test::replay(argv[2], argc > 3 ? argv[3] : "");
  ros::init(argc, argv, "world");
  if (argc != 7 && argc != 9) {
    std::fprintf(stderr, "usage: ros1_fly_world MEMBER SPOILT JUMP SENSORS CLOCK OUTPUT [record|play BAG]\n");
    return 2;
  }
  tern_test::FlownSettings settings;
  settings.spoilt = {std::strtod(argv[2], nullptr), std::strtod(argv[3], nullptr)};
  settings.sensors = argv[4];
  settings.real_time = argv[5] == std::string("real");
  settings.mavros = argv[6] == std::string("mavros");
  tern_test::FlownWorld world(argv[1], settings);
  world.set_parameters();
  std::printf("ready\n");
  std::fflush(stdout);
  if (!world.connect()) {
    std::printf("{\"world\": \"%s\", \"end\": \"not connected\"}\n", argv[1]);
    return 1;
  }
  const std::string bag = argc > 7 ? argv[7] : "";
  if (bag == "record") world.record(argv[8]);
  const tern_test::Flown flown = bag == "play" ? world.play(argv[8]) : world.fly();
  std::printf(
      "{\"world\": \"%s\", \"end\": \"%s\", \"time\": %.2f, \"clearance\": %.4f, \"off\": %.4f, \"agreed\": %.2f, "
      "\"late\": %llu, "
      "\"told\": \"%s\", %s}\n",
      argv[1], flown.end.c_str(), flown.time, flown.clearance, flown.off, flown.agreed,
      static_cast<unsigned long long>(flown.late), world.displays().told().c_str(), world.displays().json().c_str());
  return flown.end == "reached" ? 0 : 1;
}
