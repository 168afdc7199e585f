// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of things that move (docs/formats.md).
#ifndef TERN_VERIFY_TRACK_RECORDS_HPP
#define TERN_VERIFY_TRACK_RECORDS_HPP

#include <vector>

#include "verify/records.hpp"
#include "verify/tracks.hpp"

namespace tern_verify {

/// True for `track`, `track_piece`, and `keepout` with `during`. Throws InputError where the times are wrong.
bool is_track_record(const Record& record);

/// Adds the thing, or the piece of the last thing of that name. A keepout's name is its number among the file's
/// `keepout` records, counted from 1: `keepouts`. Throws InputError.
void add_track_record(const Record& record, std::size_t keepouts, std::vector<Thing>& things);

}  // namespace tern_verify

#endif
