#include "sim/digest/digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "sim/digest/plan.h"
#include "sim/digest/workers.h"
#include "sim/input_error.h"
#include "sim/picture.h"
#include "sim/progress.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::string name_of(const DigestFrame& frame) { return frame.config_name + " " + frame.scene; }

// Lines of frames measured before an interruption, beside the file that is to be written. They are kept as long as
// neither the program nor the Verilog changes.
class PartialFile {
 public:
  PartialFile(const fs::path& file, const std::string& key) : path_(file.string() + ".partial") {
    std::ifstream in(path_);
    std::string text;
    const std::string first = "# sources " + key;
    if (std::getline(in, text) && text == first) {
      // A line that was cut off has no end.
      for (unsigned number = 2; std::getline(in, text) && !in.eof(); ++number)
        kept_.push_back(parse_line(text, path_.string(), number));
    }
    in.close();
    out_.open(path_);
    out_ << first << '\n';
    for (const DigestLine& line : kept_) out_ << text_of(line);
    check();
  }

  const DigestLine* find(const DigestFrame& frame) const {
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& line) { return line.frame == frame; });
    return found == kept_.end() ? nullptr : &*found;
  }

  void add(const DigestLine& line) {
    out_ << text_of(line);
    check();
  }

  void remove() {
    out_.close();
    fs::remove(path_);
  }

  const fs::path& path() const { return path_; }

 private:
  void check() {
    if (!out_.flush()) throw InputError(Place{path_.string()}, "cannot be written");
  }

  fs::path path_;
  std::vector<DigestLine> kept_;
  std::ofstream out_;
};

std::vector<SameConfig> grouped(std::span<const DigestFrame> frames,
                                const std::vector<std::optional<DigestLine>>& lines) {
  std::map<std::string, std::size_t> group_of;
  std::vector<SameConfig> groups;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (lines[i]) continue;
    const auto [at, is_new] = group_of.try_emplace(frames[i].settings, groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(i);
  }
  return groups;
}

void say(const MeasuredFrame& measured) {
  if (measured.note.empty()) return;
  fmt::print(stderr, "{}: {}: {}\n", name_of(measured.line.frame), measured.line.cells[2], measured.note);
}

std::vector<DigestLine> measure_all(std::span<const DigestFrame> frames, const DigestOptions& options) {
  PartialFile partial(options.file, source_key(options.engines));
  std::vector<std::optional<DigestLine>> lines(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (const DigestLine* kept = partial.find(frames[i])) lines[i] = *kept;
  std::size_t done = static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), [](auto& l) { return !!l; }));
  if (done > 0) fmt::print(stderr, "{}: goes on after {} of {} frames\n", partial.path().string(), done, frames.size());
  Progress progress("digest", frames.size());
  progress.at(done);
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  measure_in_processes(frames, grouped(frames, lines), options.engines,
                       options.processes > 0 ? options.processes : cores,
                       [&](std::size_t i, const MeasuredFrame& measured) {
                         lines[i] = measured.line;
                         partial.add(measured.line);
                         progress.clear();
                         say(measured);
                         progress.at(++done, name_of(measured.line.frame));
                       });
  progress.clear();
  std::vector<DigestLine> whole;
  for (const auto& line : lines) whole.push_back(line.value());
  write_text(options.file, text_of(whole));
  partial.remove();
  return whole;
}

// What the file to compare with has and does not; the first column of each line that differs.
struct BaselineComparison {
  std::vector<DigestLine> baseline;
  nlohmann::json differences = nlohmann::json::array();
};

// The place of the first cell that differs, or their number. What one of both did not measure is not compared.
std::size_t first_difference(const DigestLine& before, const DigestLine& now, std::span<const std::string> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool of_rtl = names[i] == "clocks" || names[i] == "rtl";
    if (of_rtl && (before.cells[i] == "-" || now.cells[i] == "-")) continue;
    if (before.cells[i] != now.cells[i]) return i;
  }
  return names.size();
}

void compare(const fs::path& path, std::span<const DigestLine> lines, BaselineComparison& comparison) {
  const std::vector<std::string> names = measured_columns();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const DigestLine &before = comparison.baseline[i], &now = lines[i];
    const std::size_t at = first_difference(before, now, names);
    if (at == names.size()) continue;
    const std::string &column = names[at], &was = before.cells[at], &is = now.cells[at];
    if (comparison.differences.empty())
      fmt::print("{}:{}: {}: {} was {} and is {}\n", path.string(), before.number, name_of(now.frame), column, was, is);
    comparison.differences.push_back({{"line", before.number},
                                      {"config", now.frame.config_name},
                                      {"scene", now.frame.scene},
                                      {"column", column},
                                      {"was", was},
                                      {"is", is}});
  }
}

// A named configuration may have changed since; what is compared is that of the baseline.
void note_other_configs(const fs::path& path, std::span<const DigestLine> baseline) {
  std::map<std::string, std::string> settings;
  for (const DigestLine& line : baseline) settings[line.frame.config_name] = line.frame.settings;
  for (const DigestFrame& frame : planned_frames()) {
    if (frame.scene.starts_with("random:")) continue;
    const auto found = settings.find(frame.config_name);
    if (found != settings.end() && found->second == frame.settings) continue;
    const char* what = found == settings.end() ? "is not in" : "has other settings in";
    fmt::print(stderr, "note: the configuration {} {} {}\n", frame.config_name, what, path.string());
    settings[frame.config_name] = frame.settings;
  }
}

nlohmann::json to_json(const DigestLine& line) {
  nlohmann::json object{
      {"config", line.frame.config_name}, {"scene", line.frame.scene}, {"settings", line.frame.settings}};
  const std::vector<std::string> names = measured_columns();
  for (std::size_t i = 0; i < names.size(); ++i) object[names[i]] = line.cells[i];
  return object;
}

void check_files(const DigestOptions& options) {
  std::error_code none;
  if (!options.against.empty() && fs::equivalent(options.file, options.against, none))
    throw InputError(Place{"--digest"}, options.file.string(), "another file than --against names");
}

}  // namespace

bool verify_digest(const DigestOptions& options, nlohmann::json& object) {
  check_files(options);
  BaselineComparison comparison;
  std::vector<DigestFrame> frames;
  const auto is_chosen = [&](const DigestFrame& frame) {
    return is_among(options.configs, frame.config_name) && is_among(options.scenes, frame.scene);
  };
  if (options.against.empty()) {
    frames = planned_frames();
    std::erase_if(frames, [&](const DigestFrame& frame) { return !is_chosen(frame); });
  } else {
    comparison.baseline = read_digest(options.against);
    if (options.configs.empty()) note_other_configs(options.against, comparison.baseline);
    std::erase_if(comparison.baseline, [&](const DigestLine& line) { return !is_chosen(line.frame); });
    for (const DigestLine& line : comparison.baseline) {
      config_of(line.frame.settings, options.against.string(), line.number);
      frames.push_back(line.frame);
    }
  }
  if (frames.empty()) throw InputError(Place{"--digest"}, "no frame of these configurations and scenes");
  const std::vector<DigestLine> lines = measure_all(frames, options);
  bool equal = true;
  for (const DigestLine& line : lines) {
    equal &= line.cells[2] != kRtlDifferent;
    object["lines"].push_back(to_json(line));
  }
  if (!equal) fmt::print("{}: the RTL differs from golden\n", options.file.string());
  if (options.against.empty()) {
    fmt::print("{}: {} frames\n", options.file.string(), lines.size());
    return equal;
  }
  compare(options.against, lines, comparison);
  object["differences"] = comparison.differences;
  fmt::print("{} of {} frames differ from {}\n", comparison.differences.size(), lines.size(), options.against.string());
  return equal && comparison.differences.empty();
}

}  // namespace wrinkle
