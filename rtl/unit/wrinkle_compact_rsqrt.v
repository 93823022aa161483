`default_nettype none
// Reciprocal square root, r = 1/sqrt(t) in u1.RB for t in [1/4, 1), of which T holds the leading SB + 1 bits; halved,
// rounded down, where halve_i is set. A table of 2 * 2^K linear segments, filled by the formula of
// golden/pixel/compact_rsqrt.h, which is not that of `faithful`. Latency 2, or 1 with PIPELINED 2. Does not
// handle t < 1/4.
module wrinkle_compact_rsqrt #(
  parameter INPUT_BITS      = 11,  // SB + 1
  parameter OUTPUT_BITS     = 10,  // RB
  parameter SEGMENT_BITS    = 4,   // K
  parameter GUARD_BITS      = 2,   // of base and slope, below r
  parameter BIAS            = 0,
  parameter DROPPED_COLUMNS = 4,
  parameter PIPELINED       = 1
) (
  input  wire                  clk,
  input  wire                  advance_i,
  input  wire [INPUT_BITS-1:0] t_i,      // u0, at least 1/4
  input  wire                  halve_i,
  output wire [OUTPUT_BITS:0]  r_o       // u1.RB
);
  localparam N          = INPUT_BITS - 2 - SEGMENT_BITS;
  localparam OFFSET     = N > 0 ? N : 1;
  localparam BASE_BITS  = OUTPUT_BITS + GUARD_BITS + 1;
  localparam SLOPE_BITS = OUTPUT_BITS + GUARD_BITS - SEGMENT_BITS;
  localparam ENTRY      = SLOPE_BITS + BASE_BITS;
  localparam ROWS       = 2 << SEGMENT_BITS;

`include "wrinkle_isqrt.vh"

  // 2^(RB+g) / sqrt(t) of the middle of x, rounded to nearest
  function [63:0] root;
    input [63:0] x;
    input integer half;
    root = (isqrt((64'd1 << (2 * (OUTPUT_BITS + GUARD_BITS) + INPUT_BITS + 3 - half)) / ((x << 1) + 64'd1),
                  64'd1 << (OUTPUT_BITS + GUARD_BITS + 2)) + 64'd1) >> 1;
  endfunction

  // Slope and base of segment i
  function [63:0] segment;
    input integer i;
    reg [63:0] width, x0, r0, rm, r1, base, slope, most;
    integer half;
    begin
      half  = i >> SEGMENT_BITS;
      width = 64'd1 << N;
      x0    = (64'd1 << (INPUT_BITS - 2)) + (({32'd0, i} & ((64'd1 << SEGMENT_BITS) - 64'd1)) << N);
      r0    = root(x0, half);
      base  = r0;
      slope = 64'd0;
      if (N > 0) begin
        rm    = root(x0 + (width >> 1), half);
        r1    = root(x0 + width, half);
        slope = r0 - r1;
        base  = r1 + ((slope + (width >> 1)) >> N) - ((r0 + r1 + 64'd2 - (rm << 1)) >> 2)
                + ((64'd1 << GUARD_BITS) >> 1) + BIAS;
      end
      most = (((64'd1 << (BASE_BITS + N)) - 64'd1) - slope * (width - 64'd1)) >> N;
      if (base > most) base = most;
      segment = (slope << BASE_BITS) | base;
    end
  endfunction

  // All segments, that of index 0 in the low bits.
  function [ROWS*ENTRY-1:0] segments;
    input unused;
    reg [63:0] with_unused_top;
    integer i;
    for (i = 0; i < ROWS; i = i + 1) begin
      with_unused_top = segment(i);
      segments[i*ENTRY +: ENTRY] = with_unused_top[ENTRY-1:0];
    end
  endfunction

  localparam [ROWS*ENTRY-1:0] TABLE = segments(1'b0);

  // Both halves of the range keep the same number of bits.
  wire                    half  = t_i[INPUT_BITS-1];
  wire [INPUT_BITS-2:0]   x     = half ? t_i[INPUT_BITS-1:1] : t_i[INPUT_BITS-2:0];
  wire [SEGMENT_BITS:0]   index = {half, x[INPUT_BITS-3 -: SEGMENT_BITS]};
  wire unused_one = &{1'b0, x};

  wire [ENTRY-1:0]  entry0, entry1;
  wire [OFFSET-1:0] dx1;
  wire              halve1;
  wire [OUTPUT_BITS:0] r, r1;

  wrinkle_table #(.INDEX_BITS(SEGMENT_BITS + 1), .ENTRY_BITS(ENTRY), .CONTENT(TABLE)) look_up (
    .index_i(index), .entry_o(entry0));
  wrinkle_delay #(.WIDTH(ENTRY + OFFSET + 1), .RANKS(PIPELINED == 1 ? 1 : 0)) looked_up (
    .clk(clk), .advance_i(advance_i), .data_i({entry0, ~x[OFFSET-1:0], halve_i}),
    .data_o({entry1, dx1, halve1}));

  generate
    if (N > 0) begin : linear
      wrinkle_truncated_segment #(
        .N(N), .BASE_BITS(BASE_BITS), .SLOPE_BITS(SLOPE_BITS), .DROPPED_COLUMNS(DROPPED_COLUMNS),
        .RESULT_BITS(OUTPUT_BITS + 1)
      ) line (
        .base_i(entry1[BASE_BITS-1:0]), .slope_i(entry1[ENTRY-1:BASE_BITS]), .dx_i(dx1), .result_o(r));
    end else begin : direct
      wire unused_slope = &{1'b0, entry1, dx1};
      assign r = entry1[BASE_BITS-1 -: OUTPUT_BITS+1];
    end
  endgenerate

  assign r1 = halve1 ? {1'b0, r[OUTPUT_BITS:1]} : r;
  wrinkle_delay #(.WIDTH(OUTPUT_BITS + 1), .RANKS(1)) interpolated (
    .clk(clk), .advance_i(advance_i), .data_i(r1), .data_o(r_o));
endmodule
`default_nettype wire
