// Techmap: a product of a value with itself is folded: bit i alone weighs 2^(2i), bits i < j together 2^(i+j+1). Half the
// dots of a product of two values, which Yosys would make of it.
(* techmap_celltype = "$mul" *)
module wrinkle_map_square (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;

  // Which wire each bit is.
  parameter _TECHMAP_BITS_CONNMAP_ = 0;
  parameter [A_WIDTH*_TECHMAP_BITS_CONNMAP_-1:0] _TECHMAP_CONNMAP_A_ = 0;
  parameter [B_WIDTH*_TECHMAP_BITS_CONNMAP_-1:0] _TECHMAP_CONNMAP_B_ = 0;
  wire _TECHMAP_FAIL_ = A_SIGNED || B_SIGNED || A_WIDTH != B_WIDTH || _TECHMAP_CONNMAP_A_ != _TECHMAP_CONNMAP_B_;

  wire [(A_WIDTH+1)*Y_WIDTH-1:0] sum;
  genvar i;
  generate
    assign sum[0 +: Y_WIDTH] = {Y_WIDTH{1'b0}};
    for (i = 0; i < A_WIDTH; i = i + 1) begin : rows
      wire [A_WIDTH-1:0] later = (A & {A_WIDTH{A[i]}}) >> (i + 1);
      wire [Y_WIDTH+1:0] dots = {later, 1'b0, A[i]};
      assign sum[(i+1)*Y_WIDTH +: Y_WIDTH] = sum[i*Y_WIDTH +: Y_WIDTH] + (dots[Y_WIDTH-1:0] << (2 * i));
    end
    assign Y = sum[A_WIDTH*Y_WIDTH +: Y_WIDTH];
  endgenerate
endmodule
