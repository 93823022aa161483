// What is generated and checked in is what the tables give.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "golden/config/verilog.h"

namespace wrinkle {
namespace {

TEST(Generated, VerilogConfigIsUpToDate) {
  std::ostringstream text;
  text << std::ifstream(WRINKLE_SOURCE_DIR "/rtl/wrinkle_config.vh").rdbuf();
  EXPECT_TRUE(text.str() == verilog_config()) << "rtl/wrinkle_config.vh is stale: run ./wrinkle generate";
}

}  // namespace
}  // namespace wrinkle
