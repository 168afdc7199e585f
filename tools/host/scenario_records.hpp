// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The records of a scenario, one at a time: what the scenario parser does with a line once it is split into words.
#ifndef TERN_HOST_SCENARIO_RECORDS_HPP
#define TERN_HOST_SCENARIO_RECORDS_HPP

#include <string>
#include <vector>

#include "host/map/map_warnings.hpp"
#include "host/scenario.hpp"

namespace tern_host {

/// Gathers records into a scenario and knows which were given. Every member function throws ScenarioError.
class ScenarioBuilder {
 public:
  explicit ScenarioBuilder(const std::string& name);
  ScenarioBuilder(const ScenarioBuilder&) = delete;
  ScenarioBuilder& operator=(const ScenarioBuilder&) = delete;

  /// One record: its keyword and what follows.
  void add(const std::vector<std::string>& words, const Place& place);

  /// A setting that replaces the record of that name.
  void override_setting(const std::string& key, const std::vector<std::string>& values, const Place& place);

  /// Checks what only the whole scenario shows; `end` is the place to name where something is missing.
  Scenario finish(const Place& end, Ends ends);

 private:
  enum class Shape { kScalar, kVector, kLimit };
  struct Setting {
    const char* key;
    Shape shape;
    double* scalar;
    tern::Vec3* vector;
    bool required;
    bool given;
    Place place;  // of the record that set it, where given
  };

  /// A setting that is one of two words, with the numbers 0 and 1.
  struct Choice {
    const char* key;
    const char* words[2];
    int chosen;
    bool given;
    Place place;
  };

  Setting* find(const std::string& key);
  Choice* find_choice(const std::string& key);
  void add_boundary(const std::vector<std::string>& words, const Place& place);
  static void choose(Choice& choice, const std::vector<std::string>& words, const Place& place);
  void set_yaw(const std::vector<std::string>& words, const Place& place);
  void add_map_file(const std::vector<std::string>& words, const Place& place);
  void add_via(const std::vector<std::string>& words, const Place& place);
  void add_fence_cover(const std::vector<std::string>& words, const Place& place);
  void add_block(const std::vector<std::string>& words, const Place& place);
  void add_fence_record(const std::vector<std::string>& words, const Place& place);
  static void assign(Setting& setting, const std::vector<double>& values, const Place& place);
  void check_ranges() const;
  void check_unknown() const;
  void check_yaw() const;

  Scenario scenario_;
  bool has_boundary_ = false;
  std::size_t keepouts_ = 0;  // records so far
  Place yaw_place_;
  std::vector<BoxRecord> boxes_;
  std::vector<Setting> settings_;
  Choice choices_[3];
};

}  // namespace tern_host

#endif
