#include "sim/report/baseline.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/input_error.h"
#include "sim/picture.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

bool is_worse(const std::string& name, double kept, double measured) {
  if (name.ends_with("_db")) return measured < kept - kWorseDecibels;
  return measured > kept * (1 + kWorseShare) + 1e-9;
}

}  // namespace

std::filesystem::path baseline_path(const std::string& name) {
  return std::filesystem::path(WRINKLE_SOURCE_DIR) / "tests" / "baselines" / (name + ".json");
}

bool check_baseline(const std::filesystem::path& file, const FiguresByName& measured) {
  const std::string text = read_text(file);
  if (text.empty()) throw InputError(Place{file.string()}, "no baseline");
  const auto kept = nlohmann::json::parse(text).at("figures").get<FiguresByName>();
  bool good = true;
  const auto complain = [&](const std::string& message) {
    fmt::print("{}\n", message);
    good = false;
  };
  for (const auto& [name, value] : kept) {
    const auto found = measured.find(name);
    if (found == measured.end()) {
      complain(fmt::format("{}: kept as {:.6g}, not measured", name, value));
    } else if (is_worse(name, value, found->second)) {
      complain(fmt::format("{}: {:.6g} was {:.6g}", name, found->second, value));
    }
  }
  for (const auto& [name, value] : measured) {
    if (!kept.contains(name)) complain(fmt::format("{}: {:.6g} has no baseline", name, value));
  }
  fmt::print("{} figures against {}: {}\n", kept.size(), file.string(), good ? "none worse" : "WORSE");
  return good;
}

void write_baseline(const std::filesystem::path& file, const FiguresByName& measured) {
  write_text(file, nlohmann::json{{"figures", measured}}.dump(1) + "\n");
}

}  // namespace wrinkle
