// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences as scenarios, flight worlds and logs of flights say them. The reader is the verifier's own.
#ifndef TERN_VERIFY_FENCE_RECORDS_HPP
#define TERN_VERIFY_FENCE_RECORDS_HPP

#include <optional>
#include <string>
#include <vector>

#include "verify/json.hpp"
#include "verify/records.hpp"

namespace tern_verify {

/// `keepin`, `keepout` and both with half-spaces.
bool is_fence(const std::string& key);
/// Takes `during t0 t1` or `during t0 t1 error` off the end of a record.
std::optional<Window> take_window(Record& record);
/// Takes `zone` with a name off the end of a record, before the window. Control characters stay out of terminals.
/// Throws InputError where the name has `during` before a number.
std::string take_zone(Record& record);
/// A record for which is_fence() holds.
Fence fence_from(const Record& record);
/// One of a flight's log.
Fence fence_of(const Json& json);

/// `fences_within`, a box and a clearance: zones farther from the box than that have no fences. Throws InputError where
/// the boundary reaches beyond the box, or more is kept from obstacles than the clearance.
void require_cover(const Record& record, const Box& boundary, const Rational& clearance);

/// A title, and in parentheses the name of what it is of, if it has one.
std::string with_zone(const std::string& title, const std::string& zone);

/// "fence 3 (Old town)": its number, counted from 1, and its name, if it has one.
std::string title_of(const std::vector<Fence>& fences, std::size_t f);

bool same(const Fence& a, const Fence& b);

/// Adds to what the centre keeps from each keep-out.
void keep_distance(const Rational& clearance, std::vector<Fence>& fences);

/// Throws InputError with the place of a fence without a point; fence k comes from record k.
void refuse_empty(const std::vector<Fence>& fences, const std::vector<Record>& records, const Box& boundary);

}  // namespace tern_verify

#endif
