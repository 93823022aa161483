// The part of OpenImageIO that the program uses, in a module that is loaded when it is first needed: Debian's library
// brings some 250 others, and to load them takes longer than most commands do.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::oiio {

// What a file says of its image before any pixel is read.
struct Header {
  int width = 0, height = 0, depth = 1;  // of the pixels that are stored
  int x = 0, y = 0;                      // of the stored pixels within the full window
  int full_width = 0, full_height = 0;
  int alpha_channel = -1, z_channel = -1;
  bool is_deep = false;
  std::vector<std::string> channels;
};

class Input {
 public:
  virtual ~Input() = default;
  virtual const Header& header() const = 0;
  virtual std::string_view format() const = 0;
  // The first channels of all pixels, interleaved, as floats; closes the file. Empty, or what is wrong.
  virtual std::string read(int channels, float* pixels) = 0;
};

// Pixels where they are: row-major, top row first, channels interleaved.
struct View {
  int width, height, channels;
  float* data;
};

class Library {
 public:
  virtual ~Library() = default;

  // An image file, or the bytes of one, whose name has the ending of its format; alpha and codes as they are. Null
  // where it is no image that is known: `error` says why.
  virtual std::unique_ptr<Input> open(const std::string& path, std::string& error) const = 0;
  virtual std::unique_ptr<Input> open(std::string_view bytes, const std::string& name, std::string& error) const = 0;
  virtual bool writes(const std::string& path) const = 0;
  // Writes floats, or bytes of [0, 1]. Empty, or what is wrong.
  virtual std::string write(const std::string& path, const View& image, const std::vector<std::string>& channels,
                            bool as_floats) const = 0;

  virtual void fill(const View& image, float value) const = 0;
  virtual void paste(const View& onto, const View& image, int x, int y) const = 0;
  // A square of `side` pixels at (x, y), each pixel repeated so that it fills `out`.
  virtual void magnify(const View& image, int x, int y, int side, const View& out) const = 0;
  // The outline of a box; both corners are part of it.
  virtual void draw_box(const View& image, int x0, int y0, int x1, int y1, std::array<float, 3> colour) const = 0;

  virtual std::size_t edit_distance(std::string_view a, std::string_view b) const = 0;
  virtual std::string base64(std::string_view bytes) const = 0;
};

// Loads the module at the first call.
const Library& library();

}  // namespace wrinkle::oiio
