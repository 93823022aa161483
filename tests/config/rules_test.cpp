// The tables of golden/config in both languages: what the C++ accepts, derives and has as defaults, the Verilog does
// too, for random settings, legal and not. rtl/wrinkle_config.vh is read as it is checked in, in one elaboration by
// Icarus.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <span>
#include <sstream>

#include "golden/config/config.h"
#include "golden/config/verilog.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr int kSettings = 10000;
// Settings in one elaboration: its time grows with their square.
constexpr std::size_t kInOneBench = 500;

std::string printed(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 65536> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) text.append(buffer.data(), n);
  pclose(pipe);
  return text;
}

std::string include(const std::string& section) {
  return "`define " + section + "\n`include \"wrinkle_config.vh\"\n`undef " + section + "\n";
}

// Half of the settings break nothing but perhaps a rule; of the others a few parameters lie just outside of their
// range.
std::vector<Config> random_settings(int count) {
  std::mt19937_64 random(1);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  std::vector<Config> settings(static_cast<std::size_t>(count));
  for (Config& config : settings) {
    const int changed_in = below(2) == 0 ? 1 : 6;  // one in so many parameters differs from its default
    const bool outside = below(4) == 0;
    for (const Parameter& p : parameters()) {
      if (p.scope != Scope::core || below(changed_in) != 0) continue;
      config.*p.member = p.minimum + below(p.maximum - p.minimum + 1);
      if (outside && below(12) == 0) config.*p.member = below(2) == 0 ? p.minimum - 1 : p.maximum + 1;
    }
  }
  return settings;
}

// The names of the modules by which the Verilog refuses.
std::vector<std::string> faults() {
  std::vector<std::string> names;
  for (const Parameter& p : parameters())
    if (p.scope == Scope::core)
      names.push_back(std::string(p.name) + "_is_not_" + std::to_string(p.minimum) + "_to_" +
                      std::to_string(p.maximum));
  for (const Rule& rule : rules()) names.emplace_back(rule.name);
  return names;
}

template <class Print>
void for_each_number(const Print& print) {
  for (const DerivedValue& value : properties())
    if (value.scope == Scope::core) print(value);
  for (const DerivedValue& value : derived_values())
    if (value.scope == Scope::core) print(value);
}

// One module that says its parameters, its derived values and its faults, and one instance of it for each setting.
// Where a fault is met it is `%m`, the path of the module that says it.
std::string bench(std::span<const Config> settings) {
  std::ostringstream out;
  out << "`default_nettype none\nmodule setting #(\n"
      << include("WRINKLE_SECTION_PARAMETERS") << ") ();\n"
      << include("WRINKLE_SECTION_DERIVED") << include("WRINKLE_SECTION_RULES") << "  initial $display(\"%m";
  for (const Parameter& p : parameters())
    if (p.scope == Scope::core) out << " %0d";
  for_each_number([&](const DerivedValue&) { out << " %0d"; });
  out << '"';
  for (const Parameter& p : parameters())
    if (p.scope == Scope::core) out << ", " << verilog_text(p.name);
  for_each_number([&](const DerivedValue& value) { out << ", " << verilog_text(value.name); });
  out << ");\nendmodule\n";
  for (const std::string& fault : faults())
    out << "module wrinkle_error_" << fault << "; initial $display(\"refused %m\"); endmodule\n";
  out << "module top;\n  setting defaults ();\n";
  const Config standard;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    std::string overrides;
    for (const Parameter& p : parameters()) {
      const int value = settings[i].*p.member;
      if (value == standard.*p.member) continue;
      overrides += (overrides.empty() ? "." : ", .") + verilog_text(p.name) + "(" + std::to_string(value) + ")";
    }
    out << "  setting " << (overrides.empty() ? "" : "#(" + overrides + ") ") << "s" << i << " ();\n";
  }
  out << "endmodule\n";
  return out.str();
}

// What the Verilog said: of every setting whether it was refused, and its numbers.
struct Said {
  std::set<std::string> refused;
  std::map<std::string, std::vector<int>> numbers;
};
Said said_by_the_verilog(std::span<const Config> settings) {
  const fs::path folder = fs::temp_directory_path() / ("wrinkle_rules_" + std::to_string(std::random_device()()));
  fs::create_directories(folder);
  std::ofstream(folder / "bench.v") << bench(settings);
  const std::string in = folder.string();
  const std::string log = printed("iverilog -g2005 -s top -I " WRINKLE_SOURCE_DIR "/rtl -o " + in + "/bench.vvp " + in +
                                  "/bench.v && vvp -n " + in + "/bench.vvp");
  fs::remove_all(folder);
  Said said;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, path;
    words >> word;
    const bool refused = word == "refused";
    path = word;
    if (refused) words >> path;
    if (!path.starts_with("top.")) {
      ADD_FAILURE() << line;
      continue;
    }
    path = path.substr(4, path.find('.', 4) - 4);
    if (refused) said.refused.insert(path);
    for (int number; !refused && words >> number;) said.numbers[path].push_back(number);
  }
  return said;
}

std::vector<int> numbers_of(const Config& config) {
  std::vector<int> numbers;
  for (const Parameter& p : parameters())
    if (p.scope == Scope::core) numbers.push_back(config.*p.member);
  const Shape shape(config);
  for_each_number([&](const DerivedValue& value) { numbers.push_back(shape.*value.member); });
  return numbers;
}

TEST(Rules, BothLanguagesAcceptTheSame) {
  const std::vector<Config> settings = random_settings(kSettings);
  int legal = 0;
  std::map<std::string, int> keys;
  Said said;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (i % kInOneBench == 0) {
      said = said_by_the_verilog(std::span(settings).subspan(i, kInOneBench));
      ASSERT_TRUE(said.numbers.contains("defaults"));
      ASSERT_FALSE(said.refused.contains("defaults"));
      ASSERT_EQ(said.numbers.at("defaults"), numbers_of({})) << "parameters, properties and derived values, as listed";
    }
    const std::string name = "s" + std::to_string(i % kInOneBench);
    const IllegalParameter fault = check(settings[i]);
    ASSERT_EQ(said.refused.contains(name), !fault.key.empty())
        << "the Verilog " << (said.refused.contains(name) ? "refuses" : "accepts")
        << ", the C++ says: " << (fault.key.empty() ? "legal" : fault.message);
    ++keys[fault.key];
    if (!fault.key.empty()) continue;
    ++legal;
    ASSERT_EQ(said.numbers.at(name), numbers_of(settings[i])) << name;
  }
  EXPECT_GT(legal, kSettings / 20);
  for (const Parameter& p : parameters())
    EXPECT_TRUE(p.scope != Scope::core || keys[std::string(p.name)] > 0) << "no setting was refused for " << p.name;
}

// Each rule alone, so that none hides behind another: some setting breaks it and nothing before it.
TEST(Rules, EveryRuleIsMet) {
  // Behind the name of a width a message shows its value.
  const std::regex value(" \\(-?[0-9]+\\)");
  std::set<std::string> messages;
  for (const Config& config : random_settings(4 * kSettings))
    messages.insert(std::regex_replace(check(config).message, value, ""));
  for (const Rule& rule : rules()) {
    const auto says = [&](const std::string& message) { return message.ends_with(rule.message); };
    EXPECT_TRUE(std::any_of(messages.begin(), messages.end(), says)) << rule.name;
  }
}

}  // namespace
}  // namespace wrinkle
