// The Verilog's half of the tables: rtl/wrinkle_config.vh.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle {

// The whole file. It is checked in, so that the Verilog can be read and used without this program; a test makes it
// again.
std::string verilog_config();

// A name or an expression of the tables as the Verilog writes it: in capitals.
std::string verilog_text(std::string_view expression);

}  // namespace wrinkle
