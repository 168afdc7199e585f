// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CLI_SUMMARY_HPP
#define TERN_CLI_SUMMARY_HPP

#include <string>
#include <vector>

#include "host/session.hpp"

namespace tern_cli {

/// A plan for a person to read: some lines of figures.
std::string plan_summary(const tern_host::PlanResult& result);

/// Status, meaning and detail where there is no plan.
std::string failure_summary(const tern_host::PlanResult& result);

/// Why there is no yaw plan beside a plan, and what to change.
std::string yaw_failure(const tern_host::PlanResult& result);

/// The table's two header lines, and one row a scenario.
std::string table_header();
std::string table_row(const std::string& name, const tern_host::PlanResult& result);

}  // namespace tern_cli

#endif
