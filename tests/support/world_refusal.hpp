// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why the simulator refuses a world.
#ifndef TERN_TESTS_SUPPORT_WORLD_REFUSAL_HPP
#define TERN_TESTS_SUPPORT_WORLD_REFUSAL_HPP

#include <string>

#include "host/atomic_file.hpp"
#include "host/flight/flight_world.hpp"
#include "host/text_records.hpp"
#include "support/own_folder.hpp"

namespace tern_test {

/// Why a world with these records is refused; empty if it is not.
inline std::string world_refusal(const std::string& records) {
  const std::string path = own_folder() + "refused_world.txt";
  tern_host::write_file(path, records);
  try {
    tern_host::read_flight_world(path, {});
  } catch (const tern_host::RecordError& error) {
    return error.reason();
  }
  return "";
}

}  // namespace tern_test

#endif
