// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header.
#pragma once

#include <uORB/uORB.h>

namespace uORB {

template <typename T>
class Publication {
 public:
  explicit Publication(const orb_metadata* topic) : topic_(topic) {}
  bool publish(const T& message) { return orb_publish(topic_, &message); }

 private:
  const orb_metadata* topic_;
};

}  // namespace uORB
