// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target/realtime.hpp"

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

namespace tern_target {
namespace {

/// Above what a desktop's services use, below a kernel's own threads.
constexpr int kPriority = 80;
/// The part of its running time that a plan rests afterwards: at most 91 % of any second is used.
constexpr double kRest = 0.1;

void note_refusal(Realtime& out, const char* what) {
  if (!out.refused.empty()) out.refused += ", ";
  out.refused += std::string(what) + " (" + std::strerror(errno) + ")";
}

int last_allowed_processor() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return -1;
  int last = -1;
  for (int i = 0; i < CPU_SETSIZE; ++i) {
    if (CPU_ISSET(static_cast<unsigned>(i), &allowed)) last = i;
  }
  return last;
}

bool pin_to(int processor) {
  if (processor < 0 || processor >= CPU_SETSIZE) {
    errno = EINVAL;
    return false;
  }
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(static_cast<unsigned>(processor), &only);
  return sched_setaffinity(0, sizeof only, &only) == 0;
}

}  // namespace

Realtime request_realtime(int processor) {
  Realtime out;
  const int wanted = processor < 0 ? last_allowed_processor() : processor;
  if (pin_to(wanted)) {
    out.processor = wanted;
  } else {
    note_refusal(out, "pinning");
  }
  out.locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  if (!out.locked) note_refusal(out, "mlockall");
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  out.fifo = sched_setscheduler(0, SCHED_FIFO, &parameters) == 0;
  if (!out.fifo) note_refusal(out, "SCHED_FIFO");
  return out;
}

std::string describe(const Realtime& realtime) {
  std::string out = std::string("SCHED_FIFO ") + (realtime.fifo ? "yes" : "no") + ", memory locked " +
                    (realtime.locked ? "yes" : "no") + ", pinned to ";
  out += realtime.processor < 0 ? "no processor" : "processor " + std::to_string(realtime.processor);
  if (!realtime.refused.empty()) out += "; refused: " + realtime.refused;
  return out;
}

void rest_after(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(kRest * seconds));
}

}  // namespace tern_target
