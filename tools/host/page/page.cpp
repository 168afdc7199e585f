// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/page.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/page/page_parts.hpp"

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "tern-page/1";
constexpr const char* kOpening = "<script type=\"application/json\" id=\"data\">";
constexpr const char* kClosing = "</script>";

/// No text within the data may look like markup to the browser: `<` stands in strings alone.
std::string escaped(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? "\\u003c" : std::string(1, c);
  return text;
}

/// The block of data alone.
std::string data_of_page(const std::string& html, const std::string& name) {
  const std::size_t opening = html.find(kOpening);
  if (opening == std::string::npos) throw std::runtime_error(name + ": not a page of Tern");
  const std::size_t begin = opening + std::string(kOpening).size();
  return html.substr(begin, html.find(kClosing, begin) - begin);
}

}  // namespace

void check_page(std::size_t runs) {
  if (!has_three()) {
    throw std::runtime_error("this build has no three.js for pages: install libjs-three, then configure and build");
  }
  if (runs < 1 || runs > kMaxRuns) {
    throw std::runtime_error("a page shows 1 to " + std::to_string(kMaxRuns) + " plans or flights, not " +
                             std::to_string(runs));
  }
}

std::string page_html(const std::vector<std::string>& runs) {
  check_page(runs.size());
  std::string data = std::string("{\"format\":\"") + kFormat + "\",\"runs\":[";
  for (std::size_t i = 0; i < runs.size(); ++i) data += (i == 0 ? "\n" : ",\n") + runs[i];
  data += "\n]}";
  std::string html = page_template();
  return html.replace(html.find(kDataMark), std::string(kDataMark).size(), escaped(data));
}

std::vector<std::string> runs_of_page(const std::string& html, const std::string& name) {
  std::vector<std::string> runs;
  try {
    const Json data = Json::parse(data_of_page(html, name));
    if (data.at("format") != kFormat) throw std::runtime_error(name + ": not a page of this version of Tern");
    for (const Json& run : data.at("runs")) runs.push_back(run.dump());
  } catch (const Json::exception& error) {
    throw std::runtime_error(name + ": not a page of Tern: " + error.what());
  }
  return runs;
}

}  // namespace tern_host
