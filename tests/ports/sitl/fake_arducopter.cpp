// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// fake_arducopter --serial0 udpclient:HOST:PORT --serial1 udpclient:HOST:PORT [others]: a stand-in for ArduPilot's
// simulator as port/ardupilot/fly_sitl sees it. It flies the simulated autopilot in real time, two metres up from the
// beginning, and writes its log as numbers into log.csv: fake_arducopter.py makes a DataFlash log of it.
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <string>

#include "autopilot/companion_flight.hpp"
#include "companion/ned.hpp"
#include "host/flight/flight_recorder.hpp"

namespace {

using namespace tern_companion;

constexpr std::int64_t kStep = 5000000, kLogged = 100000000;  // ns
constexpr std::uint16_t kArm = 400, kTakeOff = 22;
constexpr float kLand = 9.0f, kGuided = 4.0f;

volatile std::sig_atomic_t ended = 0;

std::int64_t monotonic() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000000000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
}

/// A socket that is connected to udpclient:HOST:PORT on this computer.
int client(const std::string& text) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(text.substr(text.rfind(':') + 1))));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
  if (connect(descriptor, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) return -1;
  return descriptor;
}

class Copter {
 public:
  Copter(int script, int companion) : links_{script, companion}, began_(monotonic()), log_(std::fopen("log.csv", "w")) {
    sender_.system = 1;
    sender_.component = kAutopilotComponent;
  }
  ~Copter() { std::fclose(log_); }
  Copter(const Copter&) = delete;
  Copter& operator=(const Copter&) = delete;

  void run() {
    while (ended == 0) {
      const std::int64_t now = monotonic() - began_;
      autopilot_.fly_to(now);
      autopilot_.report();
      if (landing_ != 0 && now > landing_ + 500000000) autopilot_.set_armed(false);
      if (now >= due_) log(now);
      std::array<pollfd, 2> files{{{links_[0], POLLIN, 0}, {links_[1], POLLIN, 0}}};
      poll(files.data(), 2, static_cast<int>(kStep / 1000000));
      for (std::size_t k = 0; k < 2; ++k) {
        if (files[k].revents != 0) take(k);
      }
    }
  }

 private:
  void send(const std::vector<std::uint8_t>& bytes) {
    for (const int link : links_) (void)!::write(link, bytes.data(), bytes.size());
  }

  void take(std::size_t link) {
    std::array<std::uint8_t, 2048> bytes;
    ssize_t got = 0;
    while ((got = recv(links_[link], bytes.data(), bytes.size(), MSG_DONTWAIT)) > 0) {
      if (link == 1) {
        autopilot_.receive(bytes.data(), static_cast<std::size_t>(got));
      } else if (!command(bytes.data(), static_cast<std::size_t>(got))) {
        autopilot_.receive(bytes.data(), static_cast<std::size_t>(got));
      }
    }
  }

  /// What the ground station may ask for beyond what a companion does. False: it is for the simulated autopilot.
  bool command(const std::uint8_t* bytes, std::size_t count) {
    reader_.feed(bytes, count);
    Frame frame;
    if (!reader_.next(frame) || frame.id != CommandLong::kId) return false;
    const auto asked = parse<CommandLong>(frame);
    const bool leaves = asked.command == kDoSetMode && asked.params[1] != kGuided;
    if (asked.command != kArm && asked.command != kTakeOff && !leaves) return false;
    CommandAck ack;
    ack.command = asked.command;
    ack.result = kAccepted;
    if (asked.command == kArm) {
      ack.result = ++arming_ < 2 ? kTemporarilyRejected : kAccepted;  // it is not ready at first
      autopilot_.set_armed(ack.result == kAccepted);
    }
    if (asked.command == kTakeOff) autopilot_.set_in_air(true);
    if (leaves) autopilot_.switch_to_pilot();
    if (leaves && asked.params[1] == kLand) landing_ = monotonic() - began_;
    send(pack(sender_, ack));
    return true;
  }

  void log(std::int64_t now) {
    due_ = now + kLogged;
    const double t = 1e-9 * static_cast<double>(now);
    const tern::Vec3 points[] = {tern::ned_from_enu(autopilot_.target(t).sample.position),
                                 tern::ned_from_enu(autopilot_.vehicle().estimate()),
                                 tern::ned_from_enu(autopilot_.vehicle().position())};
    std::fprintf(log_, "%lld %d", static_cast<long long>(now / 1000), autopilot_.follows() ? 4 : 17);
    for (const tern::Vec3& p : points) std::fprintf(log_, " %.4f %.4f %.4f", p.x, p.y, p.z);
    std::fprintf(log_, "\n");
  }

  static tern_host::VehicleSettings vehicle() {
    const auto words = tern_autopilot::companion_world_settings();
    auto settings = tern_host::vehicle_settings_of(tern_host::read_flight_world("P49@2:3", words).settings);
    settings.kind = "px4";
    settings.pose_margin = 0.0;
    settings.tick = 1e-9 * static_cast<double>(kStep);
    return settings;
  }

  std::array<int, 2> links_;  // the script's, the companion's
  std::int64_t began_, due_ = 0, landing_ = 0;
  std::FILE* log_;
  Sender sender_;
  FrameReader reader_;
  int arming_ = 0;
  tern_autopilot::SimulatedAutopilot autopilot_{
      {false, 1.0, 0.3, 1}, vehicle(), {0.0, 0.0, 2.0}, 0.0, [this](const auto& bytes) { send(bytes); }};
};

}  // namespace

int main(int argc, char** argv) {
  std::string script, companion;
  for (int k = 1; k + 1 < argc; ++k) {
    if (std::string(argv[k]) == "--serial0") script = argv[k + 1];
    if (std::string(argv[k]) == "--serial1") companion = argv[k + 1];
  }
  if (script.empty() || companion.empty()) return 2;
  std::signal(SIGTERM, [](int) { ended = 1; });
  Copter(client(script), client(companion)).run();
  return 0;
}
