// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_COMPANION_MISSION_FILE_HPP
#define TERN_COMPANION_MISSION_FILE_HPP

#include <istream>
#include <string>
#include <vector>

#include "tern/via.hpp"

namespace tern_companion {

/// Three numbers "EAST,NORTH,UP", or divided by blanks. False if they are not.
bool read_point(const std::string& text, tern::Vec3& point);

/// Reads a mission: lines `via EAST NORTH UP [TOLERANCE] [stop] [dwell SECONDS]`, in order, and one `goal EAST NORTH
/// UP` at the end; metres in the local frame. `#` begins a comment. Throws std::runtime_error with `name`, the line and
/// what is wrong.
std::vector<tern::Via> read_mission(std::istream& file, const std::string& name);

}  // namespace tern_companion

#endif
