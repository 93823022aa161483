// What is generated and checked in is what the tables give.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "golden/config/tables.h"
#include "golden/config/values.h"
#include "golden/config/verilog.h"
#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

std::string checked_in(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(WRINKLE_SOURCE_DIR "/" + path).rdbuf();
  return text.str();
}

TEST(Generated, VerilogConfigIsUpToDate) {
  EXPECT_TRUE(checked_in("rtl/wrinkle_config.vh") == verilog_config())
      << "rtl/wrinkle_config.vh is stale: run ./wrinkle generate";
}

TEST(Generated, ParameterPageIsUpToDate) {
  EXPECT_TRUE(checked_in("docs/parameters.md") == parameter_page())
      << "docs/parameters.md is stale: run ./wrinkle generate";
}

// Each vector has a name and a format, and those that are there come first; texels have no more components than fit.
TEST(Generated, DatapathsFit) {
  for_each_datapath({}, [](std::string_view name, const auto& said) {
    const int widths[] = {said.frame_0_width().value, said.frame_1_width().value, said.frame_2_width().value};
    static_assert(std::size(widths) == kMaxFrameVectors);
    for (std::size_t i = 0; i < kMaxFrameVectors; ++i)
      EXPECT_EQ(widths[i] != 0, i < said.frame_names().size()) << name << ", vector " << i;
    EXPECT_LE(said.bump_components().value, kMaxElements) << name;
    EXPECT_EQ(said.bump_name().empty(), said.bump_components().value == 0) << name;
    EXPECT_EQ(said.kPerturbs, said.normal_width().value != 0) << name;
  });
}

}  // namespace
}  // namespace wrinkle
