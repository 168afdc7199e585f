// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_AUTOPILOT_COMPANION_PROCESS_HPP
#define TERN_AUTOPILOT_COMPANION_PROCESS_HPP

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tern_autopilot {

/// A companion program that runs beside this one, with a UDP socket to talk to it.
class CompanionProcess {
 public:
  /// Starts the program with a port and a depth socket of its own, and waits until it listens. Throws
  /// std::runtime_error with what it said if it ends instead.
  CompanionProcess(const std::string& program, const std::vector<std::string>& arguments);
  ~CompanionProcess();
  CompanionProcess(const CompanionProcess&) = delete;
  CompanionProcess& operator=(const CompanionProcess&) = delete;

  const std::string& depth_path() const { return depth_path_; }
  void send(const std::vector<std::uint8_t>& bytes);
  /// Waits for a datagram, at most so many milliseconds. Empty if none came, or if the program has ended.
  std::vector<std::uint8_t> receive(int milliseconds);
  void interrupt();
  /// Ends it at once, as a crash would.
  void crash();
  bool has_ended();
  /// Waits for its end. Its exit status; -1 for a signal.
  int wait();
  /// Throws std::runtime_error with what it said if it ends before it says this line.
  void wait_until_it_says(const std::string& line);
  /// What it has said so far.
  const std::string& said();

 private:
  void read_output(int milliseconds);

  std::string folder_, depth_path_, said_;
  int socket_ = -1, output_ = -1, status_ = 0;
  std::uint16_t port_ = 0;
  pid_t process_ = -1;  // -1: it has ended
};

}  // namespace tern_autopilot

#endif
