// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move in a world's file: docs/formats.md has the words.
#ifndef TERN_HOST_THINGS_THING_RECORD_HPP
#define TERN_HOST_THINGS_THING_RECORD_HPP

#include <string>

#include "host/text_records.hpp"
#include "host/things/thing.hpp"

namespace tern_host {

/// thing NAME SHAPE MOTION [claims SPEED ACCELERATION]. Throws RecordError.
Thing read_thing(const Words& words, const Place& place);

/// The line of a file that reads back to the same thing, bit by bit.
std::string thing_line(const Thing& thing);

}  // namespace tern_host

#endif
