// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner for the demo: a scenario's text in, a run of the page (docs/page.md) out.
#include <emscripten/emscripten.h>

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "host/page/page.hpp"
#include "host/scenario.hpp"
#include "host/session.hpp"

/// The run as JSON, or `{"error": ...}`. The text stays until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* tern_demo_plan(const char* scenario) {
  static tern_host::Session session;
  static std::string answer;
  try {
    answer = tern_host::plan_run(session.plan(tern_host::parse_scenario(scenario, "demo")));
  } catch (const std::exception& error) {
    answer = nlohmann::json{{"error", error.what()}}.dump();
  }
  return answer.c_str();
}
