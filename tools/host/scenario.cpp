// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/scenario.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "host/scenario_records.hpp"

namespace tern_host {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::vector<std::string> split(const std::string& text, bool commas) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text) {
    if (!is_blank(c) && !(commas && c == ',')) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(word);
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

void check_line(const std::string& line, const Place& place) {
  if (line.size() > kMaxLineBytes) {
    throw ScenarioError(place, "the line is longer than " + std::to_string(kMaxLineBytes) + " bytes");
  }
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && !is_blank(c)) || byte == 0x7F) {
      throw ScenarioError(place, "not a text file: byte " + std::to_string(byte));
    }
  }
}

void parse_line(const std::string& line, const Place& place, ScenarioBuilder& builder) {
  check_line(line, place);
  const std::vector<std::string> words = split(line.substr(0, line.find('#')), false);
  if (!words.empty()) builder.add(words, place);
}

void parse_override(const std::string& option, ScenarioBuilder& builder) {
  const Place place{"--set " + option.substr(0, 80), 0};
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos || equals == 0) throw ScenarioError(place, "expected key=value");
  builder.override_setting(option.substr(0, equals), split(option.substr(equals + 1), true), place);
}

std::string read_file(const std::string& path) {
  const Place place{path, 0};
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  if (file == nullptr) throw ScenarioError(place, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text;
  char buffer[65536];
  std::size_t got = 0;
  while ((got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0) {
    text.append(buffer, got);
    if (text.size() > kMaxScenarioBytes) {
      throw ScenarioError(place, "larger than " + std::to_string(kMaxScenarioBytes) + " bytes");
    }
  }
  if (std::ferror(file.get()) != 0) throw ScenarioError(place, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

}  // namespace

Scenario parse_scenario(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
  if (text.size() > kMaxScenarioBytes) {
    throw ScenarioError({name, 0}, "larger than " + std::to_string(kMaxScenarioBytes) + " bytes");
  }
  ScenarioBuilder builder(name);
  Place place{name, 1};
  for (std::size_t begin = 0; begin < text.size(); ++place.line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    parse_line(text.substr(begin, end - begin), place, builder);
    begin = end + 1;
  }
  for (const std::string& option : overrides) parse_override(option, builder);
  return builder.finish({name, std::max(1, place.line - 1)});
}

Scenario read_scenario(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_scenario(read_file(path), path, overrides);
}

}  // namespace tern_host
