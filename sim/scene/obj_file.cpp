#include "sim/scene/obj_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>

#include "sim/scene/defaults.h"
#include "sim/scene/obj_lines.h"

namespace wrinkle {
namespace {

// Corners are checked against what is known at the end of the file: a face may come before its vertices.
struct LargestReference {
  std::size_t index = 0;
  Place place;
  void see(std::size_t i, const ObjLine& line, std::size_t word) {
    if (i <= index) return;
    index = i;
    place = line.place(word);
  }
  void check(std::size_t size, const char* what) const {
    if (index <= size) return;
    throw InputError(place, "index " + std::to_string(index),
                     "at most " + std::to_string(size) + ", the number of " + what);
  }
};

class ObjParser {
 public:
  void read(const ObjLine& line);
  ObjFile finish(Notes& notes);

 private:
  std::vector<double> numbers(const ObjLine& line, std::size_t least, std::size_t most) const;
  void read_position(const ObjLine& line);
  void read_face(const ObjLine& line);
  ObjCorner read_corner(const ObjLine& line, std::size_t word);
  std::int32_t read_index(const ObjLine& line, std::size_t word, std::string_view text, std::size_t part);
  void read_smoothing(const ObjLine& line);
  void use_material(const ObjLine& line);

  ObjFile obj_;
  PassedOver passed_over_;
  std::array<LargestReference, 3> largest_;
  std::map<std::string, std::int32_t> material_of_;
  ObjFace state_;          // material, smoothing, shape and object of the next face
  std::string name_;       // of the next shape
  bool new_shape_ = true;  // no face since o or g
  bool new_object_ = false;
  std::size_t triangles_ = 0;
};

void ObjParser::read(const ObjLine& line) {
  const std::string& keyword = line.keyword;
  if (keyword == "v") {
    read_position(line);
  } else if (keyword == "vt") {
    const std::vector<double> n = numbers(line, 1, 3);
    obj_.uvs.push_back({n[0], n.size() > 1 ? n[1] : 0});
  } else if (keyword == "vn") {
    const std::vector<double> n = numbers(line, 3, 3);
    obj_.normals.push_back({n[0], n[1], n[2]});
  } else if (keyword == "f" || keyword == "fo") {
    read_face(line);
  } else if (keyword == "g" || keyword == "o") {
    name_ = line.rest(1);
    new_shape_ = true;
    new_object_ = new_object_ || keyword == "o";
  } else if (keyword == "s") {
    read_smoothing(line);
  } else if (keyword == "usemtl") {
    use_material(line);
  } else if (keyword == "mtllib") {
    if (line.values() > 0) obj_.libraries.push_back({line.rest(1), line.place(0)});
    if (line.values() == 0) passed_over_.see("mtllib without a name", line.place(0));
  } else if (keyword == "l" || keyword == "p") {
    passed_over_.see("points and lines are not drawn", line.place(0));
  } else {
    passed_over_.see("the keyword \"" + std::string(line.words[0].text) + "\" is not applied", line.place(0));
  }
}

std::vector<double> ObjParser::numbers(const ObjLine& line, std::size_t least, std::size_t most) const {
  if (line.values() < least || line.values() > most) {
    const std::string range =
        least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
    throw InputError(line.place(0), line.keyword + " with " + std::to_string(line.values()) + " numbers", range);
  }
  std::vector<double> values;
  for (std::size_t i = 1; i <= line.values(); ++i) {
    values.push_back(line.number(i, -kMaximumCoordinate, kMaximumCoordinate));
  }
  return values;
}

// x y z, then a weight, or a colour with or without opacity.
void ObjParser::read_position(const ObjLine& line) {
  const std::vector<double> n = numbers(line, 3, 7);
  obj_.positions.push_back({n[0], n[1], n[2]});
  if (n.size() == 4 && n[3] != 1) passed_over_.see("the weight of a position is not applied", line.place(4));
  if (n.size() == 5) passed_over_.see("two numbers behind a position are not applied", line.place(4));
  if (n.size() == 7 && n[6] != 1) passed_over_.see("the opacity of a position is not applied", line.place(7));
  if (n.size() < 6 && obj_.colours.empty()) return;
  obj_.colours.resize(obj_.positions.size(), Vec3{1, 1, 1});
  if (n.size() >= 6) obj_.colours.back() = {n[3], n[4], n[5]};
}

void ObjParser::read_face(const ObjLine& line) {
  if (line.values() < 3) {
    throw InputError(line.place(0), "a face of " + std::to_string(line.values()) + " corners", "at least 3");
  }
  triangles_ += line.values() - 2;
  if (triangles_ > kMaximumTriangles) {
    throw InputError(line.place(0), "more than " + std::to_string(kMaximumTriangles) + " triangles", "fewer");
  }
  if (new_shape_) {
    state_.shape = static_cast<std::uint32_t>(obj_.shapes.size());
    obj_.shapes.push_back(name_);
    if (new_object_) ++state_.object;
    new_shape_ = new_object_ = false;
  }
  state_.first = static_cast<std::uint32_t>(obj_.corners.size());
  state_.count = static_cast<std::uint32_t>(line.values());
  for (std::size_t i = 1; i <= line.values(); ++i) obj_.corners.push_back(read_corner(line, i));
  obj_.faces.push_back(state_);
}

// position, position/uv, position//normal or position/uv/normal; each counted from 1, or from the end when negative.
ObjCorner ObjParser::read_corner(const ObjLine& line, std::size_t word) {
  std::array<std::int32_t, 3> index{-1, -1, -1};
  std::string_view rest = line.words[word].text;
  for (std::size_t part = 0; part < 3; ++part) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view text = rest.substr(0, slash);
    if (text.empty() && part == 0) break;
    if (!text.empty()) index[part] = read_index(line, word, text, part);
    // A slash with nothing behind it, as in "1/" and "1//", says that there is none.
    if (slash == rest.size()) return {index[0], index[1], index[2]};
    rest.remove_prefix(slash + 1);
  }
  throw InputError(line.place(word), line.quoted(word), "a corner v, v/vt, v//vn or v/vt/vn");
}

std::int32_t ObjParser::read_index(const ObjLine& line, std::size_t word, std::string_view text, std::size_t part) {
  const std::size_t size = part == 0 ? obj_.positions.size() : part == 1 ? obj_.uvs.size() : obj_.normals.size();
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size() || index == 0) {
    throw InputError(line.place(word), line.quoted(word), "a corner of indices counted from 1");
  }
  if (index < 0 && static_cast<std::uint64_t>(-(index + 1)) >= size) {
    throw InputError(line.place(word), "index " + std::to_string(index), "at least -" + std::to_string(size));
  }
  if (index < 0) return static_cast<std::int32_t>(static_cast<std::int64_t>(size) + index);
  largest_[part].see(static_cast<std::size_t>(index), line, word);
  return static_cast<std::int32_t>(std::min<std::int64_t>(index - 1, std::numeric_limits<std::int32_t>::max()));
}

void ObjParser::read_smoothing(const ObjLine& line) {
  const std::string group = line.values() == 0 ? "off" : std::string(line.words[1].text);
  double number = 0;
  if (group == "on" || group == "On" || group == "ON") {
    state_.smoothing = 1;
  } else if (parse_number(group, number) && number >= 0 && number < 4294967296.0) {
    state_.smoothing = static_cast<std::uint32_t>(number);
  } else {
    state_.smoothing = 0;
    const bool off = group == "off" || group == "Off" || group == "OFF" || group == "null";
    if (!off) passed_over_.see("the smoothing group \"" + group + "\" is taken for off", line.place(0));
  }
}

void ObjParser::use_material(const ObjLine& line) {
  const std::string name = line.rest(1);
  if (name.empty()) {
    state_.material = -1;
    return;
  }
  const auto [entry, is_new] = material_of_.try_emplace(name, static_cast<std::int32_t>(obj_.materials.size()));
  if (is_new) obj_.materials.push_back({name, line.place(1)});
  state_.material = entry->second;
}

ObjFile ObjParser::finish(Notes& notes) {
  largest_[0].check(obj_.positions.size(), "positions (v)");
  largest_[1].check(obj_.uvs.size(), "texture coordinates (vt)");
  largest_[2].check(obj_.normals.size(), "normals (vn)");
  if (!obj_.colours.empty()) obj_.colours.resize(obj_.positions.size(), Vec3{1, 1, 1});
  // Some programs write colours as codes of 0 to 255.
  double most = 1;
  for (const Vec3& c : obj_.colours) most = std::max({most, c.x, c.y, c.z});
  for (Vec3& c : obj_.colours) {
    c = (most > 1.5 ? 1.0 / 255 : 1.0) * c;
    c = {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
  }
  passed_over_.add_to(notes);
  return std::move(obj_);
}

}  // namespace

ObjFile parse_obj(const std::string& file, std::string_view text, Notes& notes) {
  ObjParser parser;
  for_each_obj_line(file, text, [&](const ObjLine& line) { parser.read(line); });
  return parser.finish(notes);
}

}  // namespace wrinkle
