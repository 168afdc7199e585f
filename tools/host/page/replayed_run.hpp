// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PAGE_REPLAYED_RUN_HPP
#define TERN_HOST_PAGE_REPLAYED_RUN_HPP

#include <string>

namespace tern_host {

/// A recorded flight (docs/record.md) as a run (page.hpp), flown again twice. The world is not in a record: the page
/// shows what the map learned of it. The vehicle is where it was told to be. Throws as replay_flight().
std::string replayed_run(const std::string& name, const std::string& bytes);

}  // namespace tern_host

#endif
