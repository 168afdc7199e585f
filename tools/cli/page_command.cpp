// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/page/page.hpp"
#include "host/text_records.hpp"

namespace tern_cli {
namespace {

struct PageOptions {
  std::vector<std::string> pages;
  std::string out;
};

int join(const PageOptions& options) {
  check_output_paths(options.pages, {options.out});
  std::vector<std::string> runs;
  for (const std::string& page : options.pages) {
    for (const std::string& run : tern_host::runs_of_page(tern_host::read_text(page), page)) runs.push_back(run);
  }
  tern_host::write_file(options.out, tern_host::page_html(runs));
  return kExitOk;
}

}  // namespace

void add_page_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<PageOptions>();
  CLI::App* const command = app.add_subcommand("page", "Join pages of --html into one, side by side");
  command->add_option("PAGE", options->pages, "Pages that --html wrote")->required();
  command->add_option("--out", options->out, "The page to write")->required()->type_name("FILE");
  command->callback([options, &exit_status] { exit_status = join(*options); });
}

}  // namespace tern_cli
