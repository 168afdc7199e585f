// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map files of the tests.
#ifndef TERN_TESTS_SUPPORT_MAP_BYTES_HPP
#define TERN_TESTS_SUPPORT_MAP_BYTES_HPP

#include <string>

#include "host/map/map_files.hpp"

namespace tern_test {

const std::string kMapFolder = std::string(TERN_SOURCE_DIR) + "/tests/support/maps/";

inline std::string bytes_of(const std::string& name) {
  return tern_host::read_bytes(kMapFolder + name, 1 << 20);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace tern_test

#endif
