// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/tools.md: the command line's parts in a program of one's own. Run it in the folder of the checkout.
#include "host/session.hpp"

#include "host/atomic_file.hpp"
#include "host/plan_file.hpp"

int main() {
  tern_host::Session session;
  const tern_host::Scenario scenario = tern_host::read_scenario("bench/maps/map3.txt", {"radius=0.2"});
  const tern_host::PlanResult result = session.plan(scenario);
  if (result.ok()) tern_host::write_file("plan.json", tern_host::plan_json(result));
  return result.ok() ? 0 : 1;
}
