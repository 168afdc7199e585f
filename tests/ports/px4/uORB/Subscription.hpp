// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header.
#pragma once

#include <uORB/uORB.h>

namespace uORB {

class Subscription {
 public:
  explicit Subscription(const orb_metadata* topic) : topic_(topic) {}
  bool copy(void* message) { return orb_copy(topic_, message); }

 private:
  const orb_metadata* topic_;
};

}  // namespace uORB
