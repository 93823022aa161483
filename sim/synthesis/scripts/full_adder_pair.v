// Pattern of extract: both outputs of the same three bits are one full adder again.
module full_adder (input A, B, C, output X, Y);
  full_adder_carry carry (.A(A), .B(B), .C(C), .X(X));
  full_adder_sum sum (.A(A), .B(B), .C(C), .Y(Y));
endmodule
