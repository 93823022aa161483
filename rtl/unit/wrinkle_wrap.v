`default_nettype none
// One texel coordinate brought into a level of 2^size_log2 texels: repeat keeps the low bits, clamp limits, mirror
// inverts the low bits in every other period. Combinational.
module wrinkle_wrap #(
  parameter INDEX_BITS = 17
) (
  input  wire signed [INDEX_BITS-1:0] index_i,
  input  wire [3:0]                   size_log2_i,  // 0 to 12
  input  wire [1:0]                   mode_i,       // 0 repeat, 1 clamp, 2 mirror
  output wire [11:0]                  texel_o
);
  wire [12:0] period = 13'd1 << size_log2_i;
  wire [12:0] below  = period - 13'd1;
  wire [11:0] mask   = below[11:0];
  wire [11:0] low    = index_i[11:0] & mask;
  wire        odd    = |(index_i[12:0] & period);
  wire        minus  = index_i[INDEX_BITS-1];
  wire        over   = |(index_i[INDEX_BITS-2:0] & ~{{(INDEX_BITS - 13){1'b0}}, mask});
  wire unused_carry = below[12];

  assign texel_o = mode_i == 2'd1 ? (minus ? 12'd0 : over ? mask : low) :
                   mode_i == 2'd2 && odd ? ~low & mask : low;
endmodule
`default_nettype wire
