`default_nettype none
// What is left of the light at height s above the surface: hard (SELF_SHADOW 1) all where s > 0, else none; smooth (2)
// min(8 s, 1). Combinational.
module wrinkle_shadow_factor #(
  parameter SELF_SHADOW = 1,
  parameter DOT_BITS    = 10  // DF
) (
  input  wire [DOT_BITS:0] source_i,  // s in u1.DF
  input  wire              off_i,     // all of it
  output wire [DOT_BITS:0] factor_o   // u1.DF
);
  wire over = SELF_SHADOW == 1 ? |source_i : |source_i[DOT_BITS:DOT_BITS-3];
  assign factor_o = off_i | over ? {1'b1, {DOT_BITS{1'b0}}} :
                    SELF_SHADOW == 1 ? {(DOT_BITS + 1){1'b0}} : {source_i[DOT_BITS-3:0], 3'b000};
endmodule
`default_nettype wire
