// Copies of the Verilog that a test changes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>

#include "tb/process.h"

namespace wrinkle {

// A folder of this process with `rtl` in it.
inline std::filesystem::path copy_verilog(const std::string& name) {
  const std::filesystem::path root =
      std::filesystem::path(testing::TempDir()) / ("wrinkle_" + std::to_string(getpid())) / name;
  std::filesystem::remove_all(root);
  std::filesystem::create_directories(root);
  std::filesystem::copy(std::filesystem::path(WRINKLE_SOURCE_DIR) / "rtl", root / "rtl",
                        std::filesystem::copy_options::recursive);
  return root;
}

// Each of the input ports with one of these names, separated by |, gets the inverse of its payload while it is not
// valid; they are counted.
inline std::string inverted(const std::string& instance, const std::string& names, const std::string& valid,
                            int& count) {
  const std::regex port(R"(\.()" + names + R"()_i\(([^()]*)\))");
  count += static_cast<int>(
      std::distance(std::sregex_iterator(instance.begin(), instance.end(), port), std::sregex_iterator()));
  return std::regex_replace(instance, port, ".$1_i(" + valid + " ? $2 : ~$2)");
}

// The same for every stage of the core, and for the texels. Returns how many ports there are.
inline int invert_payloads_that_are_not_valid(const std::filesystem::path& root) {
  const std::regex valid_port(R"(\.in_valid_i\((\w+)\))");
  int count = 0;
  for (const char* name : {"wrinkle_core.v", "wrinkle_config.vh"}) {
    std::istringstream text(read_text(root / "rtl" / name));
    std::ofstream changed(root / "rtl" / name);
    for (std::string statement; std::getline(text, statement, ';');) {
      std::smatch found;
      if (std::regex_search(statement, found, valid_port)) {
        const std::string valid = found[1];
        // N and H of shared units stand a clock before the fragment is valid.
        const bool has_ahead = statement.find(".ahead_i(") != statement.npos;
        const std::string n_valid = has_ahead ? "(" + valid + " | normalize_ahead)" : valid;
        statement = inverted(statement, "n|h", n_valid, count);
        statement = inverted(statement, "texel_[ab][01][01]", "texel_response_valid_i", count);
        statement = inverted(statement, "l|scale|u|v|q|lod|frame|bump|diffuse|specular|decal|carry", valid, count);
      }
      changed << statement << (text.eof() ? "" : ";");
    }
  }
  return count;
}

// The core puts out nothing more once a stage has taken back what it had offered and nobody had taken.
inline void stop_at_an_offer_taken_back(const std::filesystem::path& root) {
  const std::filesystem::path file = root / "rtl" / "wrinkle_core.v";
  std::string text = read_text(file), watch = "  reg taken_back;\n", any = "taken_back";
  for (const std::string stage : {"interpolate", "perspective", "texture", "perturb", "normalize", "light", "output"}) {
    watch += "  reg " + stage + "_waits;\n  always @(posedge clk) " + stage + "_waits <= " + stage + "_valid & ~" +
             stage + "_ready & ~rst;\n";
    any += " | (" + stage + "_waits & ~" + stage + "_valid)";
  }
  watch += "  always @(posedge clk) taken_back <= ~rst & (" + any + ");\n";
  const std::string valid = "assign fragment_valid_o  = output_valid;";
  const std::size_t at = text.find(valid);
  ASSERT_NE(at, text.npos);
  text.replace(at, valid.size(), watch + "  assign fragment_valid_o  = output_valid & ~taken_back;");
  std::ofstream(file) << text;
}

}  // namespace wrinkle
