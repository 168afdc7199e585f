// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What fences of zones were made for: `fences_within`, a record of scenarios and of flight worlds.
#ifndef TERN_HOST_FENCE_COVER_HPP
#define TERN_HOST_FENCE_COVER_HPP

#include "host/text_records.hpp"

namespace tern_host {

/// Zones beyond the box, grown by the clearance, have no fences. World frame, metres.
struct FenceCover {
  tern::Box box{};
  double clearance = 0.0;
  Place place{};
};

/// Of a record with seven numbers. Throws RecordError.
FenceCover read_fence_cover(const Words& words, const Place& place);

/// Throws RecordError where a flight within this boundary that keeps this clearance could meet a zone without fences.
/// `sum`: the names of what makes up the clearance, for the message.
void check_fence_cover(const FenceCover& cover, const tern::Box& boundary, double clearance, const std::string& sum);

}  // namespace tern_host

#endif
