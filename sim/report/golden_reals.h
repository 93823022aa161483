// Golden's values as real numbers, in the columns of the float64 twins.
#pragma once

#include <vector>

#include "golden/exact/pipeline.h"
#include "golden/pixel/pixel.h"

namespace wrinkle {

class GoldenReals {
 public:
  explicit GoldenReals(const Shape& config);

  // Fragments [first, first + count) of a batch. Vectors that are normalized after the dot products are their mantissas
  // times their scales; full scale of colours is 1.
  template <class Int>
  void read(const Batch<Int>& from, std::size_t first, const exact::DrawContext& draw, int count,
            exact::Fragments& to) const;

 private:
  // One element of a value, and where it goes.
  struct Element {
    exact::Numbers* (*target)(exact::Fragments&, std::size_t element);
    std::size_t target_element, value, element;
    double lsb;
    double factor = 1;  // applied after lsb, which is a power of two
    int scale = -1;     // index of the value that holds the scales of N, L and H; -1: none
    std::size_t scale_element = 0;
    double scale_lsb = 1;
    bool textured_only = false;  // else what fragment.def has is left
  };

  void add(const Shape& config, const Value& value, std::size_t index);

  std::vector<Value> values_;
  std::vector<Element> elements_;
  bool grey_;
};

}  // namespace wrinkle
