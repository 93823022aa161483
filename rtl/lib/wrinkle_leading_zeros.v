`default_nettype none
// Number of zeros above the leading one; BITS when there is none. BITS at most 31. Combinational.
module wrinkle_leading_zeros #(
  parameter BITS = 11
) (
  input  wire [BITS-1:0] value_i,
  output wire [4:0]      count_o
);
  // Scalars, not bits of count_o, so that no loop seems to go through that vector.
  wire [31:0] v16 = {value_i, {(32 - BITS){1'b1}}};
  wire        n16 = ~|v16[31:16];
  wire [31:0] v8  = n16 ? v16 << 16 : v16;
  wire        n8  = ~|v8[31:24];
  wire [31:0] v4  = n8 ? v8 << 8 : v8;
  wire        n4  = ~|v4[31:28];
  wire [31:0] v2  = n4 ? v4 << 4 : v4;
  wire        n2  = ~|v2[31:30];
  wire        n1  = ~(n2 ? v2[29] : v2[31]);
  wire unused_low = &{1'b0, v2};

  assign count_o = {n16, n8, n4, n2, n1};
endmodule
`default_nettype wire
