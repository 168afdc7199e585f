// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The table of parameters: one for ROS 1, ROS 2 and programs of yours.
#ifndef TERN_ONBOARD_PARAMETERS_HPP
#define TERN_ONBOARD_PARAMETERS_HPP

#include <string>
#include <vector>

#include "tern_onboard/settings.hpp"

namespace tern_onboard {

/// A parameter that is a number. One that switches something is 0 or 1, one that counts something is whole.
template <typename Of>
struct Parameter {
  const char* name;
  const char* unit;    ///< "" for a plain number
  double least, most;  ///< what is allowed, ends included
  bool whole;          ///< only whole numbers are allowed
  double (*get)(const Of&);
  void (*put)(Of&, double);
  const char* meaning;  ///< one line
};

/// A parameter that is a word.
struct WordParameter {
  const char* name;
  std::vector<std::string> allowed;
  std::string& (*of)(Settings&);
  const char* meaning;  ///< one line
};

/// All numbers of Settings, and those of each sensor.
const std::vector<Parameter<Settings>>& parameters();
const std::vector<Parameter<SensorSettings>>& sensor_parameters();
/// All words of Settings.
const std::vector<WordParameter>& word_parameters();

/// What FlySettings::yaw may be, as tern::FlightYawMode has them.
const std::vector<std::string>& yaw_words();
/// The names of classes, as tern::TrackClass has them.
const std::vector<std::string>& class_words();

/// Sets the parameter of that name. Empty; or what is wrong, with the name, the value and what is allowed. Nothing is
/// set then. `prefix` goes before the name in that text: a sensor's name.
std::string set_parameter(Settings& settings, const std::string& name, double value);
std::string set_parameter(SensorSettings& settings, const std::string& name, double value,
                          const std::string& prefix = "");
std::string set_word(Settings& settings, const std::string& name, const std::string& word);

/// The same from text, as a command line or a file has it: "cell", "0.2".
std::string set_parameter_text(Settings& settings, const std::string& name, const std::string& text);

/// What is wrong with settings that are each in their range, but do not fit together; empty if they do.
std::string settings_fault(const Settings& settings);

/// All parameters as a table in Markdown, for documentation and --help.
std::string parameter_table();

}  // namespace tern_onboard

#endif
