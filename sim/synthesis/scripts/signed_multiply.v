// Techmap: a signed product as rows of single dots, the sign extension folded into a constant [Baugh and Wooley, IEEE
// Trans. Computers C-22, 1973]. Yosys's own rows repeat the sign up to the full width of the product.
(* techmap_celltype = "$mul" *)
module wrinkle_map_mul (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;

  parameter _TECHMAP_CONSTMSK_A_ = 0;
  parameter _TECHMAP_CONSTMSK_B_ = 0;
  wire _TECHMAP_FAIL_ = !(A_SIGNED && B_SIGNED) || A_WIDTH < 2 || B_WIDTH < 2 ||
                        &_TECHMAP_CONSTMSK_A_[A_WIDTH-1:0] || &_TECHMAP_CONSTMSK_B_[B_WIDTH-1:0];

  // The dots that hold exactly one of the two signs count negative: they are inverted, and the constant mends it.
  localparam [Y_WIDTH+A_WIDTH+B_WIDTH-1:0] ONE = 1;
  localparam [Y_WIDTH-1:0] MEND = (ONE << (A_WIDTH + B_WIDTH - 1)) + (ONE << (A_WIDTH - 1)) + (ONE << (B_WIDTH - 1));
  localparam [A_WIDTH-1:0] SIGN = 1 << (A_WIDTH - 1);

  wire [(B_WIDTH+1)*Y_WIDTH-1:0] sum;
  genvar i;
  generate
    assign sum[0 +: Y_WIDTH] = MEND;
    for (i = 0; i < B_WIDTH; i = i + 1) begin : rows
      wire [A_WIDTH-1:0] dots = (A & {A_WIDTH{B[i]}}) ^ (i == B_WIDTH - 1 ? ~SIGN : SIGN);
      assign sum[(i+1)*Y_WIDTH +: Y_WIDTH] = sum[i*Y_WIDTH +: Y_WIDTH] + (dots << i);
    end
    assign Y = sum[B_WIDTH*Y_WIDTH +: Y_WIDTH];
  endgenerate
endmodule
