// Techmap: a full adder as two cells, one for each output, so that opt_clean takes away what nothing reads.
(* techmap_celltype = "full_adder" *)
module wrinkle_map_full_adder_outputs (A, B, C, X, Y);
  input A, B, C;
  output X, Y;

  full_adder_carry carry (.A(A), .B(B), .C(C), .X(X));
  full_adder_sum sum (.A(A), .B(B), .C(C), .Y(Y));
endmodule
