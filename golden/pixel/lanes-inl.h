// Lanes: the integers that the stages compute with. The stages are templates over one of these classes and name every
// operation through it, so that one source is the scalar model, the checked one and, target by target, the SIMD one.
//
//   add sub mul shl sar ...     exact: the result must fit the lane, which CheckedLanes verifies
//   mul_half                    the same, for operands of half a lane: a signed, b at least 0 and below 2^(lane/2 - 1)
//   dot                         of two triples whose elements are halves of a lane, signed
//   weigh_fields<k>             p (2^n - w) + q w, w at most 2^n and given as weights(w, n); p and q are fields k of
//                               `width` bits, 15 at most, of words that hold three
//   weigh16                     the same, p and q the operands themselves, of 16 bits, unsigned
//   weigh_twice16               f (2^m - w) + g w, for f and g as of weigh16, n + m at most 14
//   add_modular mul_modular     modulo 2^lane, for accumulators kept left-aligned
//
// `n` of a shift is the same for all lanes; shl_each and sar_each take one count a lane.
#if defined(GOLDEN_PIXEL_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_LANES_INL_H_
#undef GOLDEN_PIXEL_LANES_INL_H_
#else
#define GOLDEN_PIXEL_LANES_INL_H_
#endif

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// One fragment at a time in plain 64-bit integers. With kIsChecked, every exact result must fit `bits`.
template <bool kIsChecked>
struct ScalarLanes {
  using Int = std::int64_t;
  using V = std::int64_t;
  using M = bool;
  static constexpr int kBits = 64;
  int bits = 64;

  static constexpr int size() { return 1; }
  V checked(V v) const {
    if constexpr (kIsChecked) {
      if (v >> (bits - 1) != v >> 63) throw std::logic_error("an operation leaves the lane");
    }
    return v;
  }

  V set(Int x) const { return x; }
  V iota() const { return 0; }
  V load(const Int* p) const { return *p; }
  void store(V v, Int* p) const { *p = v; }

  V add(V a, V b) const { return checked(a + b); }
  V sub(V a, V b) const { return checked(a - b); }
  V mul(V a, V b) const { return checked(a * b); }
  V mul_half(V a, V b) const {
    if constexpr (kIsChecked) {
      const int half = bits / 2 - 1;
      if (a >> half != a >> 63 || b >> half != 0) throw std::logic_error("an operand leaves its half of the lane");
    }
    return checked(a * b);
  }
  V dot(V ax, V ay, V az, V bx, V by, V bz) const {
    const V x = checked(signed_half(ax) * signed_half(bx)), y = checked(signed_half(ay) * signed_half(by));
    return add(add(x, y), checked(signed_half(az) * signed_half(bz)));
  }
  V weights(V w, int) const { return w; }
  template <int k>
  V weigh_fields(V p, V q, int width, V w, int n) const {
    const V mask = (V{1} << width) - 1;
    p = (p >> (k * width)) & mask, q = (q >> (k * width)) & mask;
    return add(shl(unsigned_below(p, 15), n), mul(unsigned_below(q, 15) - p, w));
  }
  V weigh16(V p, V q, V w, int n) const {
    return add(shl(unsigned_below(p, 16), n), mul(unsigned_below(q, 16) - p, w));
  }
  // p and q by u, r and s by t, then the two by w.
  struct TwoWeights {
    V u, t, w;
  };
  TwoWeights two_weights(V u, V t, int, V w, int) const { return {u, t, w}; }
  V weigh_twice16(V p, V q, V r, V s, const TwoWeights& weights, int n, int m) const {
    const V f = weigh16(p, q, weights.u, n), g = weigh16(r, s, weights.t, n);
    return add(shl(f, m), mul(sub(g, f), weights.w));
  }
  V add_modular(V a, V b) const { return wrap(unsigned_of(a) + unsigned_of(b)); }
  V mul_modular(V a, V b) const { return wrap(unsigned_of(a) * unsigned_of(b)); }
  V shl_modular(V a, int n) const { return wrap(unsigned_of(a) << n); }
  V sar_modular(V a, int n) const { return a >> n; }
  V shr_modular(V a, int n) const { return wrap(unsigned_of(a) >> n); }
  V shl(V a, int n) const { return checked(wrap(unsigned_of(a) << n)); }
  V sar(V a, int n) const { return a >> n; }
  V shl_each(V a, V n) const { return checked(wrap(unsigned_of(a) << n)); }
  V sar_each(V a, V n) const { return a >> n; }
  V min(V a, V b) const { return std::min(a, b); }
  V max(V a, V b) const { return std::max(a, b); }
  V abs(V a) const { return checked(a < 0 ? -a : a); }
  V and_(V a, V b) const { return a & b; }
  V or_(V a, V b) const { return a | b; }
  V xor_(V a, V b) const { return a ^ b; }
  M less(V a, V b) const { return a < b; }
  M equal(V a, V b) const { return a == b; }
  V select(M m, V yes, V no) const { return m ? yes : no; }

  // floor(log2(v)) of v in [1, 2^24); anything for 0.
  V floor_log2(V v) const { return static_cast<V>(std::bit_width(static_cast<std::uint64_t>(v))) - 1; }
  V lookup(const Int* table, V index) const { return table[index]; }
  V lookup32(const Int* table, V index) const { return table[index]; }
  V lookup16(const Int* table, V index) const { return table[index]; }
  // Words 0, 1, 2, 3 of every lane's four.
  std::array<V, 4> load_fours(const std::uint32_t* p) const { return {p[0], p[1], p[2], p[3]}; }

 private:
  V signed_half(V v) const {
    if constexpr (kIsChecked) {
      if (v >> (bits / 2 - 1) != v >> 63) throw std::logic_error("an operand leaves its half of the lane");
    }
    return v;
  }
  static V unsigned_below(V v, int half_bits) {
    if constexpr (kIsChecked) {
      if (v >> half_bits != 0) throw std::logic_error("an operand leaves its half of the lane");
    }
    return v;
  }
  static std::uint64_t unsigned_of(V v) { return static_cast<std::uint64_t>(v); }
  static V wrap(std::uint64_t v) { return static_cast<V>(v); }
};

// As many lanes as the target has. T is std::int32_t or std::int64_t.
template <class T>
struct SimdLanes {
  using Int = T;
  using D = hn::ScalableTag<T>;
  using U = hn::RebindToUnsigned<D>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  static constexpr int kBits = 8 * sizeof(T);
  // Where each lane can have its own count, a hoisted vector of counts is cheaper than a count in another register.
  static constexpr bool kShiftsEach =
      HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL || (HWY_TARGET == HWY_AVX2 && sizeof(T) == 4);

  static constexpr bool kHasPairs = HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && sizeof(T) == 4;

  static int size() { return static_cast<int>(hn::Lanes(D())); }

  HWY_INLINE V set(Int x) const { return hn::Set(D(), x); }
  HWY_INLINE V iota() const { return hn::Iota(D(), T{0}); }
  HWY_INLINE V load(const Int* p) const { return hn::LoadU(D(), p); }
  HWY_INLINE void store(V v, Int* p) const { hn::StoreU(v, D(), p); }

  HWY_INLINE V add(V a, V b) const { return hn::Add(a, b); }
  HWY_INLINE V sub(V a, V b) const { return hn::Sub(a, b); }
  HWY_INLINE V mul(V a, V b) const { return hn::Mul(a, b); }
  HWY_INLINE V mul_half(V a, V b) const {
    // One multiplication of 16-bit pairs, or of 32-bit even lanes, where a full one takes two or three. The high half
    // of b is 0, so that of a adds nothing.
    if constexpr (kHasPairs) return sum_of_pairs(a, b);
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kBits == 64) {
      const hn::Repartition<std::int32_t, D> halves;
      return hn::MulEven(hn::BitCast(halves, a), hn::BitCast(halves, b));
    }
#endif
    return hn::Mul(a, b);
  }
  // Products of 16-bit pairs sum two by two: the pair (p, q) with the pair (2^n - w, w). 16 bits become signed by
  // taking 2^15 off both, which takes 2^(15+n) off the result.
  HWY_INLINE V dot(V ax, V ay, V az, V bx, V by, V bz) const {
    if constexpr (kHasPairs) {
      const V low = set(0xffff);
      return hn::Add(sum_of_pairs(pair(hn::And(ax, low), ay), pair(hn::And(bx, low), by)),
                     sum_of_pairs(hn::And(az, low), bz));
    }
    return hn::Add(hn::Add(mul_half(ax, bx), mul_half(ay, by)), mul_half(az, bz));
  }
  HWY_INLINE V weights(V w, int n) const { return kHasPairs ? pair(hn::Sub(set(T{1} << n), w), w) : w; }
  template <int k>
  HWY_INLINE V weigh_fields(V p, V q, int width, V w, int n) const {
    const T mask = (T{1} << width) - 1;
    if constexpr (kHasPairs) {
      // Nothing lies above field 2; fields 0 and 1 of q get to the high half in one shift.
      if constexpr (k == 2) return sum_of_pairs(pair(sar(p, 2 * width), sar(q, 2 * width)), w);
      const V left = hn::And(k == 0 ? p : sar(p, width), set(mask));
      const V right = k == 0 ? hn::ShiftLeft<16>(q) : shl(q, 16 - width);
      return sum_of_pairs(hn::OrAnd(left, right, set(mask << 16)), w);
    }
    const V left = hn::And(sar(p, k * width), set(mask)), right = hn::And(sar(q, k * width), set(mask));
    return hn::Add(shl(left, n), mul_half(hn::Sub(right, left), w));
  }
  HWY_INLINE V weigh16(V p, V q, V w, int n) const {
    if constexpr (kHasPairs) return hn::Add(sum_of_pairs(signed_pair(p, q), w), set(T{0x8000} << n));
    return hn::Add(shl(p, n), kBits == 64 ? mul_half(hn::Sub(q, p), w) : mul(hn::Sub(q, p), w));
  }
  // With pairs, w goes into u and t, both halves of a pair at once.
  struct TwoWeights {
    V u, t, w;
  };
  HWY_INLINE TwoWeights two_weights(V u, V t, int n, V w, int m) const {
    if constexpr (!kHasPairs) return {u, t, w};
    return {hn::Mul(weights(u, n), hn::Sub(set(T{1} << m), w)), hn::Mul(weights(t, n), w), w};
  }
  HWY_INLINE V weigh_twice16(V p, V q, V r, V s, const TwoWeights& weights, int n, int m) const {
    if constexpr (kHasPairs) {
      const V f = sum_of_pairs(signed_pair(p, q), weights.u), g = sum_of_pairs(signed_pair(r, s), weights.t);
      return hn::Add(hn::Add(f, g), set(T{0x8000} << (n + m)));
    }
    const V f = weigh16(p, q, weights.u, n), g = weigh16(r, s, weights.t, n);
    return hn::Add(shl(f, m), mul(hn::Sub(g, f), weights.w));
  }
  HWY_INLINE V add_modular(V a, V b) const { return hn::Add(a, b); }
  HWY_INLINE V mul_modular(V a, V b) const { return hn::Mul(a, b); }
  HWY_INLINE V shl_modular(V a, int n) const { return shl(a, n); }
  HWY_INLINE V sar_modular(V a, int n) const { return sar(a, n); }
  HWY_INLINE V shr_modular(V a, int n) const { return hn::BitCast(D(), hn::ShiftRightSame(hn::BitCast(U(), a), n)); }
  HWY_INLINE V shl(V a, int n) const {
    if constexpr (kShiftsEach) return hn::Shl(a, set(static_cast<T>(n)));
    return hn::ShiftLeftSame(a, n);
  }
  HWY_INLINE V sar(V a, int n) const {
    if constexpr (kShiftsEach) return hn::Shr(a, set(static_cast<T>(n)));
    return hn::ShiftRightSame(a, n);
  }
  HWY_INLINE V shl_each(V a, V n) const { return hn::Shl(a, n); }
  HWY_INLINE V sar_each(V a, V n) const { return hn::Shr(a, n); }
  HWY_INLINE V min(V a, V b) const { return hn::Min(a, b); }
  HWY_INLINE V max(V a, V b) const { return hn::Max(a, b); }
  HWY_INLINE V abs(V a) const {
    if constexpr (kBits == 32) return hn::Abs(a);
    return hn::Max(a, hn::Neg(a));
  }
  HWY_INLINE V and_(V a, V b) const { return hn::And(a, b); }
  HWY_INLINE V or_(V a, V b) const { return hn::Or(a, b); }
  HWY_INLINE V xor_(V a, V b) const { return hn::Xor(a, b); }
  HWY_INLINE M less(V a, V b) const { return hn::Lt(a, b); }
  HWY_INLINE M equal(V a, V b) const { return hn::Eq(a, b); }
  HWY_INLINE V select(M m, V yes, V no) const { return hn::IfThenElse(m, yes, no); }

  // The exponent of the value as a float: exact, because a float has 24 bits.
  HWY_INLINE V floor_log2(V v) const {
    if constexpr (sizeof(T) == 4) {
      const hn::RebindToFloat<D> f;
      return hn::Sub(hn::ShiftRight<23>(hn::BitCast(D(), hn::ConvertTo(f, v))), set(127));
    } else {
      // 2^52 + v - 2^52, by writing v into the fraction of 2^52.
      const hn::RebindToFloat<D> f;
      const V magic = set(std::int64_t{0x433} << 52);
      const auto real = hn::Sub(hn::BitCast(f, hn::Or(v, magic)), hn::BitCast(f, magic));
      return hn::Sub(hn::ShiftRight<52>(hn::BitCast(D(), real)), set(1023));
    }
  }
  HWY_INLINE V lookup(const Int* table, V index) const { return hn::GatherIndex(D(), table, index); }
  // Tables of 16 and 32 entries, held in registers where those have as many lanes.
  HWY_INLINE V lookup16(const Int* table, V index) const {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    if constexpr (sizeof(T) == 4) return hn::TableLookupLanes(load(table), hn::IndicesFromVec(D(), index));
#endif
    return hn::GatherIndex(D(), table, index);
  }
  HWY_INLINE V lookup32(const Int* table, V index) const {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    if constexpr (sizeof(T) == 4) return V{_mm512_permutex2var_epi32(load(table).raw, index.raw, load(table + 16).raw)};
#endif
    return lookup(table, index);
  }
  struct Fours {
    V v[4];
    HWY_INLINE V operator[](int i) const { return v[i]; }
  };
  HWY_INLINE Fours load_fours(const std::uint32_t* p) const {
#if HWY_TARGET == HWY_SCALAR
    return {
        {set(static_cast<T>(p[0])), set(static_cast<T>(p[1])), set(static_cast<T>(p[2])), set(static_cast<T>(p[3]))}};
#else
    const D d;
    const T* words = reinterpret_cast<const T*>(p);
    const auto at = [&](int i) HWY_ATTR { return load(words + i * size()); };
    if constexpr (sizeof(T) == 4) {
      const V even0 = hn::ConcatEven(d, at(1), at(0)), even1 = hn::ConcatEven(d, at(3), at(2));
      const V odd0 = hn::ConcatOdd(d, at(1), at(0)), odd1 = hn::ConcatOdd(d, at(3), at(2));
      return {{hn::ConcatEven(d, even1, even0), hn::ConcatEven(d, odd1, odd0), hn::ConcatOdd(d, even1, even0),
               hn::ConcatOdd(d, odd1, odd0)}};
    } else {
      const V left = hn::ConcatEven(d, at(1), at(0)), right = hn::ConcatOdd(d, at(1), at(0));
      const V low = set(0xffffffff);
      return {{hn::And(left, low), shr_modular(left, 32), hn::And(right, low), shr_modular(right, 32)}};
    }
#endif
  }

 private:
  HWY_INLINE static V pair(V low, V high) { return hn::Or(low, hn::ShiftLeft<16>(high)); }
  HWY_INLINE V signed_pair(V p, V q) const { return hn::Xor(pair(p, q), set(static_cast<T>(0x80008000))); }
  // a.low * b.low + a.high * b.high of signed 16-bit halves; only where kHasPairs.
  HWY_INLINE V sum_of_pairs(V a, V b) const {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kHasPairs) {
      const hn::Repartition<std::int16_t, D> halves;
      auto none = hn::Zero(D());
      return hn::ReorderWidenMulAccumulate(D(), hn::BitCast(halves, a), hn::BitCast(halves, b), none, none);
    }
#endif
    return hn::Mul(a, b);
  }
};

// (x + 2^(n-1)) >> n; x << -n for n <= 0.
template <class L>
HWY_INLINE typename L::V round_half_up(const L& l, typename L::V x, int n) {
  if (n <= 0) return l.shl(x, -n);
  return l.sar(l.add(x, l.set(typename L::Int{1} << (n - 1))), n);
}

// The same with n >= 1, one n a lane.
template <class L>
HWY_INLINE typename L::V round_half_up_each(const L& l, typename L::V x, typename L::V n) {
  const auto one = l.set(1);
  return l.sar(l.add(l.sar_each(x, l.sub(n, one)), one), 1);
}

template <class L>
HWY_INLINE typename L::V saturate(const L& l, typename L::V x, typename L::Int low, typename L::Int high) {
  return l.min(l.max(x, l.set(low)), l.set(high));
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_LANES_INL_H_
