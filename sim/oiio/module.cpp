// The module itself: the only source that includes OpenImageIO. It refers to nothing of the program but the interface.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <utility>

#include "sim/oiio/library.h"

namespace wrinkle::oiio {
namespace {

namespace algo = OIIO::ImageBufAlgo;

std::string error_of(const OIIO::ImageInput* input) {
  std::string text = input != nullptr ? input->geterror() : std::string();
  const std::string global = OIIO::geterror();  // always fetched, or it is printed at exit
  if (text.empty()) text = global;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Header header_of(const OIIO::ImageSpec& spec) {
  Header header;
  header.width = spec.width, header.height = spec.height, header.depth = spec.depth;
  header.x = spec.x - spec.full_x, header.y = spec.y - spec.full_y;
  header.full_width = spec.full_width, header.full_height = spec.full_height;
  header.alpha_channel = spec.alpha_channel, header.z_channel = spec.z_channel;
  header.is_deep = spec.deep;
  header.channels.assign(spec.channelnames.begin(), spec.channelnames.end());
  header.channels.resize(static_cast<std::size_t>(std::max(spec.nchannels, 0)));
  return header;
}

OIIO::ImageSpec hints() {
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;
  hints["oiio:RawColor"] = 1;
  return hints;
}

class OpenInput : public Input {
 public:
  explicit OpenInput(std::unique_ptr<OIIO::ImageInput> input, std::unique_ptr<OIIO::Filesystem::IOMemReader> memory)
      : memory_(std::move(memory)), input_(std::move(input)), header_(header_of(input_->spec())) {}

  const Header& header() const override { return header_; }
  std::string_view format() const override { return input_->format_name(); }
  std::string read(int channels, float* pixels) override {
    if (!input_->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, pixels)) {
      const std::string error = error_of(input_.get());
      return error.empty() ? "no reason is given" : error;
    }
    input_->close();
    error_of(input_.get());
    return {};
  }

 private:
  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory_;
  std::unique_ptr<OIIO::ImageInput> input_;
  Header header_;
};

OIIO::ImageBuf buffer(const View& view) {
  return {OIIO::ImageSpec(view.width, view.height, view.channels, OIIO::TypeDesc::FLOAT), view.data};
}

class OpenImageIo : public Library {
 public:
  std::unique_ptr<Input> open(const std::string& path, std::string& error) const override {
    const OIIO::ImageSpec wishes = hints();
    auto input = OIIO::ImageInput::open(path, &wishes);
    if (!input) error = error_of(nullptr);
    return input ? std::make_unique<OpenInput>(std::move(input), nullptr) : nullptr;
  }

  std::unique_ptr<Input> open(std::string_view bytes, const std::string& name, std::string& error) const override {
    auto memory = std::make_unique<OIIO::Filesystem::IOMemReader>(const_cast<char*>(bytes.data()), bytes.size());
    const OIIO::ImageSpec wishes = hints();
    auto input = OIIO::ImageInput::create(name, false, &wishes, memory.get());
    OIIO::ImageSpec spec;
    if (!input || !input->set_ioproxy(memory.get()) || !input->open(name, spec, wishes)) {
      error = error_of(input.get());
      return nullptr;
    }
    return std::make_unique<OpenInput>(std::move(input), std::move(memory));
  }

  bool writes(const std::string& path) const override {
    const bool known = OIIO::ImageOutput::create(path) != nullptr;
    OIIO::geterror();
    return known;
  }

  std::string write(const std::string& path, const View& image, const std::vector<std::string>& channels,
                    bool as_floats) const override {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) return OIIO::geterror();
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         as_floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.channelnames = channels;
    const bool done =
        output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, image.data) && output->close();
    return done ? std::string() : output->geterror();
  }

  void fill(const View& image, float value) const override {
    OIIO::ImageBuf pixels = buffer(image);
    algo::fill(pixels, std::vector<float>(static_cast<std::size_t>(image.channels), value));
  }
  void paste(const View& onto, const View& image, int x, int y) const override {
    OIIO::ImageBuf pixels = buffer(onto);
    algo::paste(pixels, x, y, 0, 0, buffer(image));
  }
  void magnify(const View& image, int x, int y, int side, const View& out) const override {
    OIIO::ImageBuf pixels = buffer(out);
    algo::resample(pixels, algo::cut(buffer(image), {x, x + side, y, y + side}), /*interpolate=*/false);
  }
  void draw_box(const View& image, int x0, int y0, int x1, int y1, std::array<float, 3> colour) const override {
    OIIO::ImageBuf pixels = buffer(image);
    algo::render_box(pixels, x0, y0, x1, y1, colour);
  }

  std::size_t edit_distance(std::string_view a, std::string_view b) const override {
    return OIIO::Strutil::edit_distance({a.data(), a.size()}, {b.data(), b.size()});
  }
  std::string base64(std::string_view bytes) const override {
    return OIIO::Strutil::base64_encode({bytes.data(), bytes.size()});
  }
};

}  // namespace
}  // namespace wrinkle::oiio

extern "C" const wrinkle::oiio::Library* wrinkle_oiio_library() {
  static const wrinkle::oiio::OpenImageIo library;
  return &library;
}
