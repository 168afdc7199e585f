// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for uORB: topics have a name and a size. The test defines the functions.
#pragma once

#include <stdint.h>

struct orb_metadata {
  const char* name;
  uint32_t size;
};

#define ORB_ID(topic) (&orb_metadata_of_##topic)
#define ORB_DECLARE(topic) static const orb_metadata orb_metadata_of_##topic = {#topic, sizeof(topic##_s)}

extern "C" bool orb_publish(const orb_metadata* topic, const void* message);
extern "C" bool orb_copy(const orb_metadata* topic, uint8_t instance, void* message);
extern "C" unsigned orb_sent(const orb_metadata* topic, uint8_t instance);  // how many messages were
