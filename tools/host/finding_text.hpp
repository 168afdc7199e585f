// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the check refused a plan for, in words.
#ifndef TERN_HOST_FINDING_TEXT_HPP
#define TERN_HOST_FINDING_TEXT_HPP

#include <string>

#include "host/fence_record.hpp"
#include "host/track_record.hpp"
#include "tern/report.hpp"

namespace tern_host {

/// One clause, for example "velocity of segment 2 on the x axis is beyond its limit by 0.01 m/s". Numbers count from 0,
/// as in the plan file. Empty where the check found nothing. `fences` and `tracks`: of the request, for their names.
std::string describe_finding(const tern::ProofReport& check, const std::vector<FenceRecord>& fences = {},
                             const std::vector<TrackRecord>& tracks = {});

}  // namespace tern_host

#endif
