// The stages of one batch, run by one of the instances of their source.
#pragma once

#include "golden/pixel/context.h"
#include "golden/pixel/pixel.h"
#include "golden/pixel/spans.h"
#include "golden/stages.h"

namespace wrinkle {

// Runs `stages` over the fragments of the batch. What a stage reads must be there, in the format of values.def.
// kSimd takes either width, where the configuration fits (lane_bits()); the scalar instances take the wide one.
void run_stages(Lanes lanes, const Context& context, unsigned stages, const Spans<std::int32_t>& spans,
                Batch<std::int32_t>& batch);
void run_stages(Lanes lanes, const Context& context, unsigned stages, const Spans<std::int64_t>& spans,
                Batch<std::int64_t>& batch);

// The instances behind run_stages.
void run_simd(const Context& context, unsigned stages, const Spans<std::int32_t>& spans, Batch<std::int32_t>& batch);
void run_simd(const Context& context, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch);
void run_scalar(const Context& context, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch);
void run_checked(const Context& context, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch);

}  // namespace wrinkle
