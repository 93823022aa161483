// Figures kept in the repository, and the check that they have not become worse.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace wrinkle {

// A figure of a run by name: `fig1.nand2`, `standard.patch_fig6.precision_db` ...
using FiguresByName = std::map<std::string, double>;

// How much worse a figure may be than the one kept. Areas and times may grow by a share, decibels may fall by a number.
inline constexpr double kWorseShare = 0.005;
inline constexpr double kWorseDecibels = 0.05;

// Prints each figure that is worse than in the file, or that is missing on either side. Returns true when there is
// none. A figure whose name ends in _db is better when it is larger, any other when it is smaller.
bool check_baseline(const std::filesystem::path& file, const FiguresByName& measured);

void write_baseline(const std::filesystem::path& file, const FiguresByName& measured);

// tests/baselines/NAME.json
std::filesystem::path baseline_path(const std::string& name);

}  // namespace wrinkle
