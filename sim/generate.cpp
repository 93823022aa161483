// generate: writes the checked-in files that are made from the tables.
#include <fmt/format.h>

#include <fstream>

#include "golden/config/verilog.h"
#include "sim/command.h"

namespace wrinkle {

void add_generate(CLI::App& app, Run& run) {
  CLI::App& command = *app.add_subcommand(
      "generate", "For developers: write the checked-in files that are made from golden/config and golden/datapath");
  command.callback([&run] {
    run = [] {
      const std::string path = WRINKLE_SOURCE_DIR "/rtl/wrinkle_config.vh";
      std::ofstream file(path);
      file << verilog_config();
      if (!file.flush()) throw std::runtime_error(path + " cannot be written");
      fmt::print("rtl/wrinkle_config.vh\n");
      return kExitEqual;
    };
  });
}

}  // namespace wrinkle
