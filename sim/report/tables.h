// The numbers of a report as tables of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace wrinkle {

// One line per number: table,row,column,value.
std::string csv_tables(const nlohmann::json& report);
// The same tables as Markdown.
std::string markdown_tables(const nlohmann::json& report);

}  // namespace wrinkle
