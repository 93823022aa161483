// Techmap: every adder and carry unit becomes a ripple of full adders, the smallest there is.
(* techmap_celltype = "$alu" *)
module wrinkle_map_alu (A, B, CI, BI, X, Y, CO);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  input CI, BI;
  output [Y_WIDTH-1:0] X, Y, CO;

  // An operand that is 0 arrives without a bit.
  wire [Y_WIDTH-1:0] a, b_extended;
  generate
    if (A_WIDTH < 1) assign a = {Y_WIDTH{1'b0}};
    else \$pos #(.A_SIGNED(A_SIGNED), .A_WIDTH(A_WIDTH), .Y_WIDTH(Y_WIDTH)) extend_a (.A(A), .Y(a));
    if (B_WIDTH < 1) assign b_extended = {Y_WIDTH{1'b0}};
    else \$pos #(.A_SIGNED(B_SIGNED), .A_WIDTH(B_WIDTH), .Y_WIDTH(Y_WIDTH)) extend_b (.A(B), .Y(b_extended));
  endgenerate
  wire [Y_WIDTH-1:0] b = BI ? ~b_extended : b_extended;
  wire [Y_WIDTH:0] carry;

  assign carry[0] = CI;
  assign CO = carry[Y_WIDTH:1];
  assign X = a ^ b;
  \$fa #(.WIDTH(Y_WIDTH)) adder (.A(a), .B(b), .C(carry[Y_WIDTH-1:0]), .X(carry[Y_WIDTH:1]), .Y(Y));
endmodule

(* techmap_celltype = "$lcu" *)
module wrinkle_map_lcu (P, G, CI, CO);
  parameter WIDTH = 1;
  input [WIDTH-1:0] P, G;
  input CI;
  output [WIDTH-1:0] CO;

  assign CO = G | (P & {CO, CI});
endmodule
