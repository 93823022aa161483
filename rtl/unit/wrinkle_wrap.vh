// One texel coordinate brought into a level of 2^size_log2 texels: repeat keeps the low bits, clamp limits, mirror inverts
// the low bits in every other period. A function, since a simulator calls it only in the clocks that take its result.
function [11:0] wrapped;
  input [INDEX_BITS-1:0] index;
  input [3:0]            size_log2;  // 0 to 12
  input [1:0]            mode;       // 0 repeat, 1 clamp, 2 mirror
  reg [12:0] period;
  reg [11:0] mask, low;
  reg        odd, minus, over;
  begin
    period  = 13'd1 << size_log2;
    mask    = ~(12'hfff << size_log2);
    low     = index[11:0] & mask;
    odd     = |(index[12:0] & period);
    minus   = index[INDEX_BITS-1];
    over    = |(index[INDEX_BITS-2:0] & ~{{(INDEX_BITS - 13){1'b0}}, mask});
    wrapped = mode == 2'd1 ? (minus ? 12'd0 : over ? mask : low) : mode == 2'd2 && odd ? ~low & mask : low;
  end
endfunction
