// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Is what an export says still proven, although it is not quite the plan?
#ifndef TERN_HOST_EXPORT_EXPORT_PROOF_HPP
#define TERN_HOST_EXPORT_EXPORT_PROOF_HPP

#include <string>

#include "host/scenario.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern_host {

/// An export may be this far from the plan without a proof of its own, in metres, or this part of the scenario's
/// tracking margin. The rest of the margin is the controller's. Single precision is nearer up to 1,400 m from 0.
/// Beyond, setpoints jump from one float to the next, and nobody should fly them even where they are clear.
constexpr double kExportOff = 1e-4;
constexpr double kExportMarginShare = 0.1;
/// It may exceed a limit by this part of it.
constexpr double kExportExcess = 1e-3;

/// All limits times a factor.
tern::Limits scaled(tern::Limits limits, double factor);

/// What is exported: the plan, a bound on the error and, if the export is a curve of its own, that curve.
struct ExportCase {
  const tern::Trajectory& plan;
  const tern::ExportError& error;
  const tern::Trajectory* curve;
  const tern::Vec3& origin;
};

/// Says how the export is proven in `scenario`, which has the limits and the clearance to keep. Throws
/// std::runtime_error if it is not: with what is wrong and what to do.
std::string prove_export(const Scenario& scenario, const ExportCase& what);

}  // namespace tern_host

#endif
