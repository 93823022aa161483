// floor(sqrt(x)) where that is at most `above`, by Newton's iteration, which comes down to it from there. A constant
// function, included by the modules that fill a table with roots.
function [63:0] isqrt;
  input [63:0] x, above;
  reg [63:0] next;
  begin
    isqrt = above;
    next  = (above + x / above) >> 1;
    while (next < isqrt) begin
      isqrt = next;
      next  = (next + x / next) >> 1;
    end
  end
endfunction
