#include "sim/report/tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

namespace wrinkle {
namespace {

using nlohmann::json;

struct Table {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
};

// The number or text at a path of keys; empty where it is absent.
std::string cell(const json& from, const std::vector<std::string>& path) {
  const json* at = &from;
  for (const std::string& key : path) {
    if (!at->contains(key)) return {};
    at = &(*at)[key];
  }
  return at->is_number_float() ? fmt::format("{:.6g}", at->get<double>())
         : at->is_string()     ? at->get<std::string>()
                               : at->dump();
}

using Columns = std::vector<std::pair<std::string, std::vector<std::string>>>;

Table table(const std::string& name, const json& rows, const std::string& row_key, const Columns& columns) {
  Table result{name, {}, {}};
  for (const auto& [title, path] : columns) result.columns.push_back(title);
  for (const json& row : rows) {
    auto& cells = result.rows.emplace_back(cell(row, {row_key}), std::vector<std::string>()).second;
    for (const auto& [title, path] : columns) cells.push_back(cell(row, path));
  }
  return result;
}

const Columns& pair_columns() {
  static const Columns columns{
      {"psnr_db", {"psnr_db"}}, {"max", {"max"}}, {"p999", {"p999"}}, {"ssim", {"ssim"}}, {"pixels", {"pixels"}}};
  return columns;
}

// A row for each number or text of an object.
Table value_table(const std::string& name, const json& values) {
  Table result{name, {"value"}, {}};
  for (const auto& [key, value] : values.items()) result.rows.push_back({key, {cell(value, {})}});
  return result;
}

// Fig. 1, 2 and 3 as wholes. `over_fig1` is how much larger each is than Fig. 1, as a share of Fig. 1.
Table whole_figures(const json& figures) {
  json rows = json::array();
  for (const char* name : {"fig1", "fig2", "fig3"}) {
    rows.push_back(figures[name]);
    rows.back()["row"] = name;
    const std::string over = std::string(name) + "_over_fig1";
    rows.back()["over_fig1"] = figures.contains(over) ? figures[over] : json(0.0);
  }
  return table("figures", rows, "row",
               {{"nand2", {"nand2"}},
                {"nand2_given", {"nand2_given"}},
                {"um2", {"um2"}},
                {"flip_flops", {"flip_flops"}},
                {"critical_path_ns", {"critical_path_ns"}},
                {"sum_to_flat", {"deviation"}},
                {"over_fig1", {"over_fig1"}}});
}

// Every choice of every configuration: what the page filters by.
Table choice_table(const json& configs) {
  Columns columns;
  if (!configs.empty()) {
    for (const auto& [key, value] : configs.front()["choices"].items()) columns.push_back({key, {"choices", key}});
  }
  return table("choices", configs, "name", columns);
}

// Each run with the choices and the area of its configuration.
json with_configurations(json runs, const json& configs) {
  for (json& run : runs) {
    for (const json& config : configs) {
      if (config["name"] != run["config"]) continue;
      run["choices"] = config["choices"];
      if (config.contains("area")) run["area"] = config["area"];
    }
  }
  return runs;
}

// A name for each row, for rows that have none of their own.
json named(json rows, const std::function<std::string(const json&)>& name) {
  for (json& row : rows) row["row"] = name(row);
  return rows;
}

std::string text_of(const json& row, const char* key) { return cell(row, {key}); }

// Figs. 5, 6 and 7 against each other, and what the method loses.
void add_paper(const json& paper, std::vector<Table>& all) {
  json pairs = paper["pairs"];
  for (const json& pair : {paper["held"]["pair"], paper["highlight"]["pair"], paper["highlight"]["highlight_pair"]})
    pairs.push_back(pair);
  const auto pair_name = [](const json& row) { return text_of(row, "a") + " against " + text_of(row, "b"); };
  all.push_back(table("pictures", named(std::move(pairs), pair_name), "row", pair_columns()));
  const auto method_name = [](const json& row) {
    return fmt::format("{} {} {}x{}", text_of(row, "method"), text_of(row, "filtering"), text_of(row, "divisions"),
                       text_of(row, "divisions"));
  };
  all.push_back(table("tessellation", named(paper["tessellation"], method_name), "row",
                      {{"triangles", {"triangles"}},
                       {"method_db", {"psnr_method_db"}},
                       {"max_error_method", {"max_error_method"}},
                       {"precision_db", {"psnr_precision_db"}}}));
  all.push_back(table("rotated frame against phong", paper["highlight"]["exact"], "divisions",
                      {{"psnr_db", {"psnr_db"}}, {"psnr_highlight_db", {"psnr_highlight_db"}}}));
  all.push_back(value_table("eq8-11 against eq3-6", paper["warp"]));
}

std::vector<Table> tables(const json& report) {
  std::vector<Table> all;
  const Columns stage{{"nand2", {"nand2"}},
                      {"um2", {"um2"}},
                      {"flip_flops", {"flip_flops"}},
                      {"critical_path_ns", {"critical_path_ns"}},
                      {"given", {"given"}}};
  if (report.contains("figures")) all.push_back(whole_figures(report["figures"]));
  for (const char* figure : {"fig1", "fig2", "fig3"}) {
    if (report.contains("figures")) all.push_back(table(figure, report["figures"][figure]["stages"], "stage", stage));
  }
  all.push_back(table("configurations", with_configurations(report["runs"], report["configs"]), "name",
                      {{"scene", {"scene"}},
                       {"datapath", {"choices", "datapath"}},
                       {"normalizer", {"choices", "normalizer_n"}},
                       {"nand2", {"area", "nand2"}},
                       {"flip_flops", {"area", "flip_flops"}},
                       {"critical_path_ns", {"area", "critical_path_ns"}},
                       {"precision_db", {"error", "precision", "psnr_db"}},
                       {"method_db", {"error", "method", "psnr_db"}},
                       {"p999", {"error", "precision", "p999"}},
                       {"max", {"error", "precision", "max"}},
                       {"ssim", {"error", "precision", "ssim"}}}));
  all.push_back(choice_table(report["configs"]));
  for (const json& run : report["runs"]) {
    all.push_back(table("error of " + run["name"].get<std::string>(), run["error"]["stages"], "stage",
                        {{"ulp_rms", {"ulp", "rms"}},
                         {"ulp_max", {"ulp", "max"}},
                         {"degrees_rms", {"degrees", "rms"}},
                         {"degrees_max", {"degrees", "max"}},
                         {"length_max", {"length", "max"}},
                         {"grey_rms", {"grey", "rms"}},
                         {"grey_max", {"grey", "max"}},
                         {"alone_db", {"psnr_alone_db"}},
                         {"without_db", {"psnr_without_db"}}}));
  }
  if (report.contains("paper")) add_paper(report["paper"], all);
  if (report.contains("speed")) {
    for (const json& run : report["speed"]["runs"])
      all.push_back(table("engines, " + run["name"].get<std::string>(), run["engines"], "engine",
                          {{"pixels_per_cpu_s", {"pixels_per_cpu_s"}}, {"faithful_to", {"faithful_to"}}}));
    all.push_back(table("chips", report["speed"]["chips"], "name",
                        {{"scene", {"scene"}},
                         {"clocks_per_pixel", {"clocks_per_pixel"}},
                         {"period_ns", {"period_ns"}},
                         {"pixels_per_s", {"pixels_per_s"}}}));
  }
  all.push_back(value_table("provenance", report["provenance"]));
  return all;
}

std::string quoted(const std::string& text) {
  return text.find_first_of(",\"") == std::string::npos ? text : fmt::format("\"{}\"", text);
}

}  // namespace

std::string csv_tables(const json& report) {
  std::string text = "table,row,column,value\n";
  for (const Table& t : tables(report)) {
    for (const auto& [row, cells] : t.rows) {
      for (std::size_t i = 0; i < cells.size(); ++i)
        text += fmt::format("{},{},{},{}\n", quoted(t.name), quoted(row), t.columns[i], quoted(cells[i]));
    }
  }
  return text;
}

std::string markdown_tables(const json& report) {
  std::string text = "# Report\n";
  for (const Table& t : tables(report)) {
    text += fmt::format("\n## {}\n\n| | {} |\n|", t.name, fmt::join(t.columns, " | "));
    for (std::size_t i = 0; i <= t.columns.size(); ++i) text += " --- |";
    text += "\n";
    for (const auto& [row, cells] : t.rows) text += fmt::format("| {} | {} |\n", row, fmt::join(cells, " | "));
  }
  return text;
}

}  // namespace wrinkle
