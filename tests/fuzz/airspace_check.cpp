// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "airspace/airspace_file.hpp"
#include "fuzz/fuzz_checks.hpp"
#include "host/text_records.hpp"

namespace tern_fuzz {
namespace {

std::string wrong_with(const tern_host::Airspace& airspace) {
  for (const tern_host::AirspaceEntry& entry : airspace.entries) {
    if (entry.left_out.empty() == entry.fit.fences.empty()) return "a zone has neither fences nor a reason, or both";
    if (!(std::isfinite(entry.fit.off) && std::isfinite(entry.fit.height_off))) return "an error is not finite";
    for (const tern_host::FittedFence& fence : entry.fit.fences) {
      if (fence.planes.empty()) return "a fence without half-spaces";
      for (const tern::Halfspace& h : fence.planes) {
        const double square = h.normal.x * h.normal.x + h.normal.y * h.normal.y + h.normal.z * h.normal.z;
        if (!(std::fabs(square - 1.0) < 1e-9) || !std::isfinite(h.offset)) return "a half-space is none";
      }
    }
  }
  return tern_host::fences_text(airspace).empty() || tern_host::airspace_svg(airspace).empty() ? "nothing is written"
                                                                                               : "";
}

}  // namespace

std::string check_airspace(const std::uint8_t* data, std::size_t size) {
  try {
    const tern_host::AirspaceFile file = tern_host::parse_airspace(std::string(data, data + size), "fuzz.json");
    return wrong_with(tern_host::make_airspace({file}, tern_test::lake_settings()));
  } catch (const tern_host::RecordError& error) {
    return error.place().file != "fuzz.json" || error.reason().empty() ? "an error without file or reason" : "";
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()).empty() ? "an error without a reason" : "";
  }
}

}  // namespace tern_fuzz
