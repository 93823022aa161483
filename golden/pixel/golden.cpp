// The golden machine: packets to spans, spans to batches, batches through the stages.
#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include "golden/pixel/lane_bits.h"
#include "golden/pixel/row_engine.h"
#include "golden/pixel/stages.h"

namespace wrinkle {
namespace {

// Gathers the spans of many rows and triangles into batches.
template <class Int>
class BatchBuilder {
 public:
  using Hand = std::function<void(const Batch<Int>&)>;
  BatchBuilder(Lanes lanes, const Context& context, const Hand& hand) : lanes_(lanes), context_(context), hand_(hand) {}

  void add(const TriangleWords& triangle, std::uint32_t packet) {
    rows_.start(triangle);
    bool drawn = false;
    while (rows_.next_row()) {
      drawn = true;
      for (int done = 0; done < rows_.count();) done += add_span(triangle, packet, done);
    }
    if (drawn) spans_->span[static_cast<std::size_t>(spans_->count - 1)].last = true;
  }

  // Hands on the batch. This must be called late, when the next fragment is there or none is left: until then the last
  // fragment of the batch may still turn out to be the last of its packet.
  void flush() {
    if (batch_->count == 0) return;
    run_stages(lanes_, context_, kAllStages, *spans_, *batch_);
    hand_(*batch_);
    batch_->count = 0;
    spans_->count = 0;
  }

 private:
  // As many pixels of the row, from its pixel `done` on, as fit into the batch.
  int add_span(const TriangleWords& triangle, std::uint32_t packet, int done) {
    if (batch_->count == kBatch) flush();
    const std::size_t planes = static_cast<std::size_t>(spans_->count) * spans_->stride;
    Span& span = spans_->span[static_cast<std::size_t>(spans_->count++)];
    span.first = batch_->count;
    span.count = std::min(rows_.count() - done, kBatch - batch_->count);
    span.w = rows_.w() + done;
    span.y = rows_.y();
    span.mirror = triangle.mirror;
    span.last = false;
    span.packet = packet;
    span.lod = triangle.lod;
    Int *value = &spans_->value[planes], *dw = &spans_->dw[planes];
    std::copy_n(rows_.value().data(), spans_->stride, value);
    std::copy_n(rows_.dw().data(), spans_->stride, dw);
    using Unsigned = std::make_unsigned_t<Int>;
    if (done > 0)
      for (std::size_t i = 0; i < spans_->stride; ++i)
        value[i] = static_cast<Int>(static_cast<Unsigned>(value[i]) +
                                    static_cast<Unsigned>(done) * static_cast<Unsigned>(dw[i]));
    batch_->count += span.count;
    return span.count;
  }

  Lanes lanes_;
  const Context& context_;
  const Hand& hand_;
  std::unique_ptr<Batch<Int>> batch_ = std::make_unique<Batch<Int>>(context_.config);
  std::unique_ptr<Spans<Int>> spans_ = std::make_unique<Spans<Int>>(context_.planes.size());
  RowEngine<Int> rows_{context_};
};

}  // namespace

struct Golden::State {
  Lanes lanes;
  const std::vector<Texture>& textures;
  Context context;
  std::map<std::tuple<int, int, int>, std::shared_ptr<const BoundTexture>> bound;

  // The texture that a draw names, which must be as the draw says.
  const Texture& named_texture(const DrawWords& draw) const {
    const auto index = static_cast<std::size_t>(draw.texture);
    if (index >= textures.size()) throw std::invalid_argument("a draw packet names a texture that is not there");
    const Texture& texture = textures[index];
    if (draw.log2_width != texture.log2_width || draw.log2_height != texture.log2_height ||
        draw.max_level > texture.max_level())
      throw std::invalid_argument("a draw packet has another size or more levels than its texture");
    return texture;
  }

  // The private copy of a texture for the wrap modes of a draw, made when first met.
  std::shared_ptr<const BoundTexture> texture_of(const DrawWords& draw) {
    if (!draw.textured || !context.config.textured) return nullptr;
    const Texture& texture = named_texture(draw);
    auto& copy = bound[{draw.texture, draw.wrap_u, draw.wrap_v}];
    if (copy == nullptr)
      copy = std::make_shared<BoundTexture>(bind_texture(
          texture, context.config.bump_components, static_cast<Wrap>(draw.wrap_u), static_cast<Wrap>(draw.wrap_v)));
    return copy;
  }

  template <class Int>
  void draw(std::span<const std::uint64_t> words, const std::function<void(const Batch<Int>&)>& hand) {
    BatchBuilder<Int> builder(lanes, context, hand);
    TriangleWords triangle(context.config);
    const auto triangle_words = static_cast<std::size_t>(triangle_word_count(context.config));
    const auto draw_words = static_cast<std::size_t>(context.config.draw_words);
    std::uint32_t packet = 0;
    while (!words.empty()) {
      const bool is_triangle = (words[0] & 15) == kOpcodeTriangle;
      const std::size_t size = is_triangle ? triangle_words : draw_words;
      if (words.size() < size) throw std::invalid_argument("the last packet is cut short");
      if (is_triangle) {
        decode(context.config, words.first(size), triangle);
        builder.add(triangle, packet++);
      } else {
        builder.flush();
        const DrawWords state = decode_draw(context.config, words.first(size));
        set_draw(context, state, texture_of(state));
      }
      words = words.subspan(size);
    }
    builder.flush();
  }
};

Golden::Golden(const Shape& config, const std::vector<Texture>& textures, Lanes lanes)
    : state_(new State{lanes, textures, make_context(config), {}}) {}
Golden::~Golden() = default;
Golden::Golden(Golden&&) noexcept = default;
Golden& Golden::operator=(Golden&&) noexcept = default;

void Golden::draw(std::span<const std::uint64_t> words, const Sink& sink) {
  if (state_->lanes == Lanes::kSimd && lane_bits(state_->context.config) == 32)
    state_->draw<std::int32_t>(words, sink.narrow);
  else
    state_->draw<std::int64_t>(words, sink.wide);
}

}  // namespace wrinkle
