// report: measures what is asked for, and writes it as one page, as JSON, CSV and Markdown.
#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/input_error.h"
#include "sim/picture.h"
#include "sim/report/collect.h"
#include "sim/report/tables.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path folder = "out", from;
  ReportOptions measure;
};

void replace(std::string& text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("the page has no " + what);
  text.replace(at, what.size(), with);
}

std::string part(const fs::path& path) {
  std::string text = read_text(path);
  if (text.empty()) throw InputError(Place{path.string()}, "missing or empty");
  return text;
}

// JSON that stands inside a script element may not hold "</script", which would end the element.
std::string embedded(const nlohmann::json& data) {
  std::string text = data.dump();
  for (auto at = text.find("</"); at != std::string::npos; at = text.find("</", at)) text.replace(at, 2, "<\\/");
  return text;
}

// The data as tables: the page offers them to be saved, and they are files of their own.
struct Tables {
  std::string csv, markdown;
};

std::string page(const nlohmann::json& data, const Tables& tables) {
  const fs::path folder = fs::path(WRINKLE_SOURCE_DIR) / "sim" / "report" / "page";
  std::string text = part(folder / "page.html");
  replace(text, "@STYLE@", part(folder / "page.css"));
  replace(text, "@PICTURES@", part(folder / "pictures.js"));
  replace(text, "@SCRIPT@", part(folder / "page.js"));
  replace(text, "@CHART@", part("/usr/share/javascript/chart.js/chart.min.js"));  // Debian's libjs-chart.js
  replace(text, "@DATA@", embedded(data));
  replace(text, "@TEXTS@", embedded({{"csv", tables.csv}, {"markdown", tables.markdown}}));
  return text;
}

nlohmann::json read_json(const fs::path& path) {
  const std::string text = part(path);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(Place{path.string()}, error.what(), "what an earlier report wrote");
  }
}

int report(const Options& options) {
  const nlohmann::json data = options.from.empty() ? collect(options.measure) : read_json(options.from);
  const Tables tables{csv_tables(data), markdown_tables(data)};
  write_text(options.folder / "report.html", page(data, tables));
  write_text(options.folder / "report.json", data.dump(1) + "\n");
  write_text(options.folder / "report.csv", tables.csv);
  write_text(options.folder / "report.md", tables.markdown);
  fmt::print("{}\n", (options.folder / "report.html").string());
  return kExitEqual;
}

}  // namespace

void add_report(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "One page of everything measured: area, error, pictures, speed");
  command->add_option("-o,--output", options->folder, "Folder for report.html, .json, .csv and .md")
      ->capture_default_str();
  command->add_option("--configs", options->measure.configs, "Configurations to measure; else all named ones")
      ->delimiter(',');
  command
      ->add_option("--scenes", options->measure.scenes,
                   "Scenes to measure and draw, by name or file; else those of the paper")
      ->delimiter(',');
  command->add_flag("--rtl", options->measure.rtl, "Also pictures by the RTL");
  command->add_flag("--no-area", options->measure.no_area, "Leave out what needs synthesis");
  command->add_flag("--no-speed", options->measure.no_speed, "Leave out timings");
  command->add_flag("--no-paper", options->measure.no_paper, "Leave out Figs. 5, 6 and 7 against each other");
  command->add_option("--from", options->from, "Make the page from the report.json of an earlier run");
  command->callback([options, &run] { run = [options] { return report(*options); }; });
}

}  // namespace wrinkle
