// Configurations of wrinkle_core for the lint gates, drawn from the list of parameters: one a line, as the settings
// that differ from the defaults. Together they have every value of every choice, both ends of every width, and every
// pair of values of two choices that is legal and is met. The same lines at every run.
#include <algorithm>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <tuple>

#include "golden/config/verilog.h"
#include "golden/config/config.h"

namespace wrinkle {
namespace {

// Two settings at once, as (parameter, value, parameter, value); a single one is a pair with itself.
using Target = std::tuple<std::size_t, int, std::size_t, int>;

bool is_choice(const Parameter& p) { return !p.values.empty(); }

std::set<Target> targets_of(const Config& config) {
  std::set<Target> targets;
  const auto list = parameters();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].scope != Scope::core) continue;
    const int value = config.*list[i].member;
    if (is_choice(list[i]) || value == list[i].minimum || value == list[i].maximum)
      targets.insert({i, value, i, value});
    for (std::size_t k = 0; k < i; ++k)
      if (list[k].scope == Scope::core && is_choice(list[i]) && is_choice(list[k]))
        targets.insert({k, config.*list[k].member, i, value});
  }
  return targets;
}

// A width is at one of its ends, or as it is by default.
Config drawn(std::mt19937& random) {
  Config config;
  do {
    config = {};
    for (const Parameter& p : parameters()) {
      if (p.scope != Scope::core) continue;
      const int ends[] = {p.minimum, p.standard, p.maximum};
      config.*p.member = is_choice(p) ? static_cast<int>(random() % p.values.size()) : ends[random() % 3];
    }
  } while (!check(config).key.empty());
  return config;
}

void print(const Config& config) {
  std::string line;
  for (const Parameter& p : parameters()) {
    if (p.scope != Scope::core || config.*p.member == p.standard) continue;
    line += (line.empty() ? "" : " ") + verilog_text(p.name) + "=" + std::to_string(config.*p.member);
  }
  std::cout << line << '\n';
}

// Of each value that must be met, whether it was; says which was not.
bool all_are_met(const std::set<Target>& met) {
  bool all = true;
  const auto list = parameters();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].scope != Scope::core) continue;
    for (int value = list[i].minimum; value <= list[i].maximum; ++value) {
      if (!is_choice(list[i]) && value != list[i].minimum && value != list[i].maximum) continue;
      if (met.contains({i, value, i, value})) continue;
      std::cerr << "no legal configuration was found with " << list[i].name << " = " << value << '\n';
      all = false;
    }
  }
  return all;
}

// Each line is that of many drawn ones which meets the most that none before it has met.
bool print_all() {
  constexpr int kMostLines = 40, kCandidates = 150;
  std::mt19937 random(1);
  print({});
  std::set<Target> met = targets_of({});
  for (int line = 1; line < kMostLines; ++line) {
    Config best;
    std::set<Target> gain;
    for (int i = 0; i < kCandidates; ++i) {
      const Config config = drawn(random);
      std::set<Target> fresh;
      const std::set<Target> targets = targets_of(config);
      std::set_difference(targets.begin(), targets.end(), met.begin(), met.end(), std::inserter(fresh, fresh.end()));
      if (fresh.size() > gain.size()) best = config, gain = std::move(fresh);
    }
    if (gain.empty()) break;
    print(best);
    met.merge(gain);
  }
  return all_are_met(met);
}

}  // namespace
}  // namespace wrinkle

int main() { return wrinkle::print_all() ? 0 : 1; }
