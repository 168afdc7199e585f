// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_COMPANION_OPTIONS_HPP
#define TERN_COMPANION_OPTIONS_HPP

#include <string>

#include "companion/companion.hpp"

namespace tern_companion {

/// What the command line says.
struct Options {
  std::string link = "udp:14540";         ///< as open_transport()
  std::string depth = "/run/tern/depth";  ///< path of the socket
  bool lockstep = false;                  ///< the clock is the simulator's
  CompanionSettings companion;
};

/// Reads the command line. True if the program is to go on; otherwise `status` is its exit status, and all has been
/// said. Throws std::runtime_error that says what was wrong.
bool read_options(int argc, char** argv, Options& options, int& status);

}  // namespace tern_companion

#endif
