// The tables of linear segments in Verilog, every one that a legal configuration has, against those of the golden
// model at every input.
//   tables --wrapper FILE    writes the module that holds them all
//   tables                   compares; built with that module, Verilated, and TABLES_MODEL defined
// Exit 1 at any difference.
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "golden/config/config.h"
#include "golden/pixel/compact_geometry.h"
#include "golden/pixel/compact_rsqrt.h"
#include "golden/pixel/reciprocal.h"
#include "golden/pixel/rsqrt.h"
#ifdef TABLES_MODEL
#include <verilated.h>

#include <memory>

#include "Vtables.h"
#endif

namespace wrinkle {
namespace {

struct Table {
  std::string name, module, parameters, input, other_ports;
  int input_bits, output_bits;
  std::function<bool(std::int64_t)> takes;          // whether an input is one that the unit handles
  std::function<std::int64_t(std::int64_t)> value;  // of golden
};

std::string text(const char* format, auto... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

Table reciprocal_of(int q, int r) {
  const ReciprocalGeometry g{q, r};
  return {text("reciprocal, Q %d, R %d", q, r),
          "wrinkle_reciprocal",
          text(".INPUT_BITS(%d), .OUTPUT_BITS(%d)", q, r),
          "m_i",
          "",
          q,
          r + 1,
          [q](std::int64_t m) { return m >> (q - 1) == 1; },
          [g, table = reciprocal_table(g)](std::int64_t m) { return reciprocal(g, table, m); }};
}

Table rsqrt_of(int f) {
  const RsqrtGeometry g = rsqrt_geometry(f);
  return {text("rsqrt, F %d", f),
          "wrinkle_rsqrt",
          text(".INPUT_BITS(%d), .OUTPUT_BITS(%d), .SEGMENT_BITS(%d), .GUARD_BITS(%d)", g.input_bits, g.output_bits,
               g.segment_bits, g.guard_bits),
          "t_i",
          "",
          g.input_bits,
          g.output_bits + 1,
          [g](std::int64_t t) { return t >> (g.input_bits - 2) != 0; },
          [g, table = rsqrt_table(g)](std::int64_t t) { return rsqrt(g, table, t); }};
}

Table compact_rsqrt_of(int f) {
  const CompactRsqrtGeometry g = compact_rsqrt_geometry(f);
  return {text("compact rsqrt, F %d", f),
          "wrinkle_compact_rsqrt",
          text(".INPUT_BITS(%d), .OUTPUT_BITS(%d), .SEGMENT_BITS(%d), .GUARD_BITS(%d), .BIAS(%d), .DROPPED_COLUMNS(%d)",
               g.input_bits, g.output_bits, g.segment_bits, g.guard_bits, g.bias, g.dropped_columns),
          "t_i",
          ".halve_i(1'b0), ",
          g.input_bits,
          g.output_bits + 1,
          [g](std::int64_t t) { return t >> (g.input_bits - 2) != 0; },
          [g, table = compact_rsqrt_table(g)](std::int64_t t) { return compact_rsqrt(g, table, t); }};
}

// Q and R of every configuration with `perspective`, and F of every one.
std::vector<Table> tables() {
  std::vector<Table> all;
  Config config;
  config.perspective = 1;
  for (config.q_bits = 8; config.q_bits <= 24; ++config.q_bits)
    for (config.reciprocal_bits = 8; config.reciprocal_bits <= 20; ++config.reciprocal_bits)
      if (check(config).key.empty()) all.push_back(reciprocal_of(config.q_bits, config.reciprocal_bits));
  for (int f = 6; f <= 16; ++f) {
    all.push_back(rsqrt_of(f));
    all.push_back(compact_rsqrt_of(f));
  }
  return all;
}

[[maybe_unused]] int write_wrapper(const char* path) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return 1;
  const std::vector<Table> all = tables();
  std::fprintf(file, "module tables (input wire clk, input wire [31:0] x_i, output wire [%zu:0] r_o);\n",
               32 * all.size() - 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Table& t = all[i];
    std::fprintf(file, "  assign r_o[%zu +: %d] = %d'd0;\n", 32 * i + static_cast<std::size_t>(t.output_bits),
                 32 - t.output_bits, 32 - t.output_bits);
    std::fprintf(file, "  %s #(%s) table%zu (.clk(clk), .advance_i(1'b1), .%s(x_i[%d:0]), %s.r_o(r_o[%zu +: %d]));\n",
                 t.module.c_str(), t.parameters.c_str(), i, t.input.c_str(), t.input_bits - 1, t.other_ports.c_str(),
                 32 * i, t.output_bits);
  }
  std::fprintf(file, "endmodule\n");
  return std::fclose(file);
}

#ifdef TABLES_MODEL
// Each unit takes the low bits of a counter, an input a clock; its latency is 2.
int compare() {
  constexpr std::int64_t kLatency = 2;
  const std::vector<Table> all = tables();
  const auto model = std::make_unique<Vtables>();
  std::vector<std::int64_t> differences(all.size());
  int widest = 0;
  for (const Table& table : all) widest = std::max(widest, table.input_bits);
  for (std::int64_t x = 0; x < (std::int64_t{1} << widest) + kLatency; ++x) {
    model->clk = 0;
    model->x_i = static_cast<std::uint32_t>(x);
    model->eval();
    model->clk = 1;
    model->eval();
    const std::int64_t before = x - kLatency + 1;
    for (std::size_t i = 0; before >= 0 && i < all.size(); ++i) {
      if (before >> all[i].input_bits != 0 || !all[i].takes(before)) continue;
      const std::int64_t golden = all[i].value(before), rtl = model->r_o[i];
      if (golden != rtl && differences[i]++ == 0)
        std::printf("%s: of %lld golden has %lld and rtl %lld\n", all[i].name.c_str(), static_cast<long long>(before),
                    static_cast<long long>(golden), static_cast<long long>(rtl));
    }
  }
  model->final();
  int wrong = 0;
  for (const std::int64_t count : differences) wrong += count != 0;
  std::printf("%zu tables, every input: %d differ\n", all.size(), wrong);
  return wrong != 0;
}
#endif

}  // namespace
}  // namespace wrinkle

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--wrapper") return wrinkle::write_wrapper(argv[2]);
#ifdef TABLES_MODEL
  return wrinkle::compare();
#else
  return 2;
#endif
}
