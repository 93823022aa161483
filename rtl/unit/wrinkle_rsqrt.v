`default_nettype none
// Reciprocal square root, r = 1/sqrt(t) in u1.RB for t in [1/4, 1), of which T holds the leading SB bits.
// A table of 2 * 2^K linear segments, filled by the formula of golden/pixel/rsqrt.h, where the geometry for each F and
// the proof that a vector scaled by r is faithful to F bits are given. Latency 2, or 1 with
// PIPELINED 2. T < 2^(SB-2) stands for itself plus 2^(SB-2): the leading one of the range is not looked at.
module wrinkle_rsqrt #(
  parameter INPUT_BITS  = 10,  // SB
  parameter OUTPUT_BITS = 9,   // RB
  parameter SEGMENT_BITS = 4,  // K
  parameter GUARD_BITS  = 1,   // of base and slope, below r
  parameter PIPELINED   = 1
) (
  input  wire                  clk,
  input  wire                  advance_i,
  input  wire [INPUT_BITS-1:0] t_i,        // u0.SB, at least 1/4
  output wire [OUTPUT_BITS:0]  r_o         // u1.RB
);
  localparam N          = INPUT_BITS - 1 - SEGMENT_BITS;
  localparam BASE_BITS  = OUTPUT_BITS + GUARD_BITS + 2;
  localparam SLOPE_BITS = OUTPUT_BITS + GUARD_BITS - SEGMENT_BITS + 1;
  localparam ENTRY      = SLOPE_BITS + BASE_BITS;
  localparam ROWS       = 2 << SEGMENT_BITS;

`include "wrinkle_isqrt.vh"

  // 2^(RB+g) / sqrt((t + 1/2) 2^-SB), rounded to nearest
  function [63:0] root;
    input [63:0] t;
    root = (isqrt((64'd1 << (2 * (OUTPUT_BITS + GUARD_BITS) + INPUT_BITS + 3)) / ((t << 1) + 64'd1),
                  64'd1 << (OUTPUT_BITS + GUARD_BITS + 2)) + 64'd1) >> 1;
  endfunction

  // Slope and base of segment i: the chord, lowered by half its sagitta, plus half an LSB of r.
  function [63:0] segment;
    input integer i;
    reg [63:0] step, t0, r0, rm, r1, base, slope;
    begin
      step    = 64'd1 << (INPUT_BITS - 2 - SEGMENT_BITS + (i >> SEGMENT_BITS));
      t0      = (64'd1 << (INPUT_BITS - 2 + (i >> SEGMENT_BITS))) +
                step * ({32'd0, i} & ((64'd1 << SEGMENT_BITS) - 64'd1));
      r0      = root(t0);
      rm      = root(t0 + (step >> 1));
      r1      = root(t0 + step);
      base    = r0 - ((r0 + r1 + 64'd2 - (rm << 1)) >> 2) + (64'd1 << (GUARD_BITS - 1));
      slope   = r0 - r1;
      segment = (slope << BASE_BITS) + base;
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

  // Both halves of the range are brought to the same segment width.
  wire                  half  = t_i[INPUT_BITS-1];
  wire [INPUT_BITS-1:0] x     = half ? t_i : {t_i[INPUT_BITS-2:0], 1'b0};
  wire [SEGMENT_BITS:0] index = {half, x[INPUT_BITS-2:N]};
  wire unused_one = &{1'b0, x[INPUT_BITS-1]};

  wire [ENTRY-1:0]     segment0, segment1;
  wire [N-1:0]         dx1;
  wire [OUTPUT_BITS:0] r;

  wrinkle_table #(.INDEX_BITS(SEGMENT_BITS + 1), .ENTRY_BITS(ENTRY), .CONTENT(TABLE)) look_up (
    .index_i(index), .entry_o(segment0));
  wrinkle_delay #(.WIDTH(ENTRY + N), .RANKS(PIPELINED == 1 ? 1 : 0)) rank1 (
    .clk(clk), .advance_i(advance_i), .data_i({segment0, x[N-1:0]}), .data_o({segment1, dx1}));
  wrinkle_segment #(
    .BASE_BITS(BASE_BITS), .SLOPE_BITS(SLOPE_BITS), .N(N), .GUARD(GUARD_BITS), .RESULT_BITS(OUTPUT_BITS + 1)
  ) interpolate (
    .base_i(segment1[BASE_BITS-1:0]), .slope_i(segment1[BASE_BITS +: SLOPE_BITS]), .dx_i(dx1), .result_o(r));
  wrinkle_delay #(.WIDTH(OUTPUT_BITS + 1), .RANKS(1)) rank2 (
    .clk(clk), .advance_i(advance_i), .data_i(r), .data_o(r_o));
endmodule
`default_nettype wire
