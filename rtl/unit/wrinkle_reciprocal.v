`default_nettype none
// Reciprocal, r = 2^Q / m in u1.R for m in [2^(Q-1), 2^Q). A table of linear segments, filled by the formula of
// golden/pixel/reciprocal.h, where the error is proven to be at most 2^-R. Latency 2. Does not handle m < 2^(Q-1).
module wrinkle_reciprocal #(
  parameter INPUT_BITS  = 18,  // Q
  parameter OUTPUT_BITS = 18   // R
) (
  input  wire                  clk,
  input  wire                  advance_i,
  input  wire [INPUT_BITS-1:0] m_i,        // u0.Q, at least 1/2
  output wire [OUTPUT_BITS:0]  r_o         // u1.R
);
  localparam HALF_BITS    = (OUTPUT_BITS + 1) / 2;
  localparam SEGMENT_BITS = HALF_BITS < INPUT_BITS - 1 ? HALF_BITS : INPUT_BITS - 1;
  localparam N            = INPUT_BITS - 1 - SEGMENT_BITS;
  localparam GUARD_BITS   = 2;
  localparam BASE_BITS    = OUTPUT_BITS + GUARD_BITS + 2;
  localparam SLOPE_BITS   = OUTPUT_BITS + GUARD_BITS - SEGMENT_BITS + 2;
  localparam ENTRY        = SLOPE_BITS + BASE_BITS;
  localparam ROWS         = 1 << SEGMENT_BITS;

  // 2^(R+g+Q) / (x / 2), rounded to nearest
  function [63:0] root;
    input [63:0] x;
    root = ((64'd1 << (OUTPUT_BITS + GUARD_BITS + INPUT_BITS + 2)) / x + 64'd1) >> 1;
  endfunction

  // Slope and base of segment i: the chord, lowered by half its sagitta, plus half an LSB of r.
  function [63:0] segment;
    input integer i;
    reg [63:0] m0, width, r0, rm, r1, base, slope;
    begin
      width   = 64'd1 << N;
      m0      = (64'd1 << (INPUT_BITS - 1)) + width * i;
      r0      = root(m0 << 1);
      rm      = root((m0 << 1) + width);
      r1      = root((m0 + width) << 1);
      base    = r0 - (N > 0 ? (r0 + r1 + 64'd2 - (rm << 1)) >> 2 : 64'd0) + (64'd1 << (GUARD_BITS - 1));
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

  wire [ENTRY-1:0]           segment_d;
  reg [ENTRY-1:0]            segment_q;
  reg [OUTPUT_BITS:0]        r_q;
  wire [OUTPUT_BITS:0]       r;
  wire [(N > 0 ? N : 1)-1:0] dx;
  wire unused_one = &{1'b0, m_i[INPUT_BITS-1]};

  wrinkle_table #(.INDEX_BITS(SEGMENT_BITS), .ENTRY_BITS(ENTRY), .CONTENT(TABLE)) look_up (
    .index_i(m_i[INPUT_BITS-2:N]), .entry_o(segment_d));
  wrinkle_segment #(
    .BASE_BITS(BASE_BITS), .SLOPE_BITS(SLOPE_BITS), .N(N), .GUARD(GUARD_BITS), .RESULT_BITS(OUTPUT_BITS + 1)
  ) interpolate (
    .base_i(segment_q[BASE_BITS-1:0]), .slope_i(segment_q[BASE_BITS +: SLOPE_BITS]), .dx_i(dx), .result_o(r));

  generate
    if (N > 0) begin : slanted
      reg [N-1:0] dx_q;
      always @(posedge clk) if (advance_i) dx_q <= m_i[N-1:0];
      assign dx = dx_q;
    end else begin : flat
      assign dx = 1'b0;
    end
  endgenerate

  assign r_o = r_q;

  always @(posedge clk)
    if (advance_i) begin
      segment_q <= segment_d;
      r_q       <= r;
    end
endmodule
`default_nettype wire
