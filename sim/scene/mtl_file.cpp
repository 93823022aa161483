#include "sim/scene/mtl_file.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "sim/scene/obj_lines.h"

namespace wrinkle {
namespace {

bool is_off(const std::string& word) { return word == "off" || word == "0"; }

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// The options of a map, which may stand on either side of its name, and the name, which may hold blanks.
class MapReader {
 public:
  MapReader(const ObjLine& line, PassedOver& passed_over) : line_(line), passed_over_(passed_over) {}

  // Nothing where the line has no name.
  std::optional<MtlMap> read() {
    std::size_t first = 0, last = 0;
    for (std::size_t word = 1; word < line_.words.size();) {
      const std::size_t arguments = read_option(word);
      if (arguments == 0) {
        if (first == 0) first = word;
        last = word;
        ++word;
      } else {
        word += arguments;
      }
    }
    if (first == 0) return std::nullopt;
    map_.name = line_.text(first, last);
    map_.place = line_.place(first);
    return map_;
  }

 private:
  // How many words the option at `word` takes with itself; 0 where there is none.
  std::size_t read_option(std::size_t word) {
    const std::string option = lower_case(line_.words[word].text.substr(0, 16));
    if (option == "-bm") return map_.multiplier = number(word, word + 1), 2;
    if (option == "-mm") {
      map_.base = number(word, word + 1);
      if (!is_number(word + 2)) return 2;
      return map_.gain = number(word, word + 2), 3;
    }
    if (option == "-o") return read_pair(word, map_.offset, 0);
    if (option == "-s") return read_pair(word, map_.scale, 1);
    if (option == "-t") return pass_over_numbers(word, 3, 0);
    if (option == "-boost") return pass_over_numbers(word, 1, 0);
    if (option == "-texres") return pass_over_numbers(word, 1, -1);
    if (option == "-clamp") return map_.clamp = !is_off(argument(word)), 2;
    if (option == "-blendu" || option == "-blendv") return pass_over_unless(word, {"on", "1"});
    if (option == "-cc") return pass_over_unless(word, {"off", "0"});
    if (option == "-type" || option == "-colorspace") return pass_over_unless(word, {"linear"});
    if (option == "-imfchan") return map_.channel = argument(word).front(), 2;
    return 0;
  }

  bool is_number(std::size_t word) const {
    double value = 0;
    return word < line_.words.size() && parse_number(line_.words[word].text, value);
  }
  double number(std::size_t option, std::size_t word) const {
    if (word >= line_.words.size()) {
      const std::string name(line_.words[option].text);
      throw InputError(line_.place(option), name + " at the end of the line", name + " and a number");
    }
    return line_.number(word, -1e4, 1e4);
  }
  std::string argument(std::size_t option) const {
    if (option + 1 < line_.words.size()) return lower_case(line_.words[option + 1].text.substr(0, 64));
    const std::string name(line_.words[option].text);
    throw InputError(line_.place(option), name + " at the end of the line", name + " and a word");
  }

  // One to three numbers, for u, v and w; `standard` for those that are left out.
  std::size_t read_pair(std::size_t word, Vec2& pair, double standard) {
    pair = {number(word, word + 1), standard};
    if (!is_number(word + 2)) return 2;
    pair.y = number(word, word + 2);
    return is_number(word + 3) ? 4 : 3;
  }
  std::size_t pass_over_numbers(std::size_t word, std::size_t most, double no_effect) {
    std::size_t count = 1;
    bool effect = number(word, word + 1) != no_effect;
    for (; count < most && is_number(word + count + 1); ++count) {
      effect = effect || number(word, word + count + 1) != no_effect;
    }
    if (effect) note(word);
    return count + 1;
  }
  std::size_t pass_over_unless(std::size_t word, const std::vector<std::string>& no_effect) {
    if (std::ranges::count(no_effect, argument(word)) == 0) note(word);
    return 2;
  }
  void note(std::size_t word) {
    passed_over_.see("the option " + std::string(line_.words[word].text) + " is not applied", line_.place(word));
  }

  const ObjLine& line_;
  PassedOver& passed_over_;
  MtlMap map_;
};

class MtlParser {
 public:
  explicit MtlParser(std::string file) : file_(std::move(file)) {}

  void read(const ObjLine& line) {
    const std::string& keyword = line.keyword;
    if (keyword == "newmtl") {
      begin(line);
    } else if (materials_.empty()) {
      passed_over_.see(shown(line) + " before the first newmtl is not applied", line.place(0));
    } else if (line.values() == 0) {
      empty_.push_back("line " + std::to_string(line.words[0].line) + " \"" + std::string(line.words[0].text) + "\"");
    } else if (keyword == "ka") {
      read_colour(line, materials_.back().ambient);
    } else if (keyword == "kd") {
      read_colour(line, materials_.back().diffuse);
    } else if (keyword == "ks") {
      read_colour(line, materials_.back().specular);
    } else if (keyword == "ns") {
      if (line.values() != 1) throw InputError(line.place(0), "Ns without one number", "a number");
      materials_.back().exponent = line.number(1, 0, 1e6);
    } else if (keyword == "map_kd") {
      read_map(line, materials_.back().colour_map);
    } else if (keyword == "map_ks") {
      read_map(line, materials_.back().gloss_map);
    } else if (keyword == "bump" || keyword == "map_bump") {
      read_map(line, materials_.back().bump_map);
    } else if (keyword == "norm" || keyword == "map_norm" || keyword == "map_kn") {
      read_map(line, materials_.back().normal_map);
    } else {
      pass_over(line);
    }
  }

  std::vector<MtlMaterial> finish(Notes& notes) {
    if (!empty_.empty()) {
      std::string list;
      const std::size_t shown = std::min<std::size_t>(empty_.size(), 12);
      for (std::size_t i = 0; i < shown; ++i) list += (i > 0 ? ", " : "") + empty_[i];
      if (empty_.size() > shown) list += " and " + std::to_string(empty_.size() - shown) + " more";
      notes.push_back(file_ + ": keywords without values are passed over: " + list);
    }
    passed_over_.add_to(notes);
    return std::move(materials_);
  }

 private:
  static std::string shown(const ObjLine& line) { return "the keyword " + line.quoted(0); }

  void begin(const ObjLine& line) {
    const std::string name = line.rest(1);
    if (std::ranges::any_of(materials_, [&](const MtlMaterial& m) { return m.name == name; })) {
      passed_over_.see("material \"" + name + "\" is there already; the first is taken", line.place(0));
    }
    materials_.push_back({name, line.place(0), {}, {}, {}, {}, {}, {}, {}, {}});
  }

  // Three numbers, or one for a grey. Spectra and CIE colours are noted.
  void read_colour(const ObjLine& line, std::optional<Vec3>& colour) {
    double first = 0;
    const std::string word = lower_case(line.words[1].text.substr(0, 16));
    if (word == "spectral" || word == "xyz") {
      passed_over_.see(line.keyword + " " + word + " is not applied", line.place(1));
      return;
    }
    if (line.values() != 1 && line.values() != 3) {
      throw InputError(line.place(0),
                       std::string(line.words[0].text) + " with " + std::to_string(line.values()) + " words",
                       "3 numbers, or one for a grey");
    }
    first = component(line, 1);
    colour = line.values() == 1 ? Vec3{first, first, first} : Vec3{first, component(line, 2), component(line, 3)};
  }
  double component(const ObjLine& line, std::size_t word) {
    const double value = line.number(word, 0, 1e6);
    if (value > 1) passed_over_.see(std::string(line.words[0].text) + " over 1 is taken for 1", line.place(word));
    return std::min(value, 1.0);
  }

  void read_map(const ObjLine& line, std::optional<MtlMap>& map) {
    const std::optional<MtlMap> read = MapReader(line, passed_over_).read();
    if (read) map = read;
    if (!read) passed_over_.see(shown(line) + " has options but no name and is not applied", line.place(0));
  }

  // Not noted where the value is the one that is drawn anyway.
  void pass_over(const ObjLine& line) {
    const auto all = [&](double value) {
      for (std::size_t i = 1; i < line.words.size(); ++i) {
        double number = 0;
        if (!parse_number(line.words[i].text, number) || number != value) return false;
      }
      return true;
    };
    const std::string& keyword = line.keyword;
    const bool no_effect = (keyword == "illum" && all(2)) || (keyword == "d" && all(1)) ||
                           (keyword == "tr" && all(0)) || (keyword == "ke" && all(0)) || (keyword == "tf" && all(1)) ||
                           keyword == "ni" || keyword == "sharpness";
    if (no_effect) return;
    if (keyword == "illum") {
      passed_over_.see("illum " + line.rest(1) + " is not applied; the material is lit as illum 2", line.place(0));
    } else if (keyword == "d" || keyword == "tr" || keyword == "tf") {
      passed_over_.see(shown(line) + " is not applied; the material is drawn opaque", line.place(0));
    } else {
      passed_over_.see(shown(line) + " is not applied", line.place(0));
    }
  }

  std::string file_;
  std::vector<MtlMaterial> materials_;
  PassedOver passed_over_;
  std::vector<std::string> empty_;
};

}  // namespace

std::vector<MtlMaterial> parse_mtl(const std::string& file, std::string_view text, Notes& notes) {
  MtlParser parser(file);
  for_each_obj_line(file, text, [&](const ObjLine& line) { parser.read(line); });
  return parser.finish(notes);
}

}  // namespace wrinkle
