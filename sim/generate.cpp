// generate: writes the checked-in files that are made from the tables.
#include <fmt/format.h>

#include <fstream>

#include "golden/config/tables.h"
#include "golden/config/verilog.h"
#include "sim/command.h"

namespace wrinkle {
namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream file(WRINKLE_SOURCE_DIR "/" + path);
  file << text;
  if (!file.flush()) throw std::runtime_error(path + " cannot be written");
  fmt::print("{}\n", path);
}

}  // namespace

void add_generate(CLI::App& app, Action& run) {
  CLI::App& command = *app.add_subcommand(
      "generate", "For developers: write the checked-in files that are made from golden/config and golden/datapath");
  command.callback([&run] {
    run = [] {
      write("rtl/wrinkle_config.vh", verilog_config());
      write("docs/parameters.md", parameter_page());
      return kExitEqual;
    };
  });
}

}  // namespace wrinkle
