// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VIA_RECORD_HPP
#define TERN_HOST_VIA_RECORD_HPP

#include "host/text_records.hpp"
#include "tern/via.hpp"

namespace tern_host {

/// via x y z [tolerance] [[stop] [dwell seconds] | velocity x y z]. A dwell is a stop. Throws RecordError.
tern::Via read_via(const Words& words, const Place& place);

}  // namespace tern_host

#endif
