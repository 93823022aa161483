#include "sim/report/paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/comparison.h"
#include "sim/layout.h"
#include "sim/report/error.h"
#include "sim/tessellation.h"

namespace wrinkle {
namespace {

using nlohmann::json;

// Details are shown so many times as large.
constexpr int kMagnification = 4;
// Two highlights differ by roundings alone, so their difference needs a larger gain to be seen.
constexpr double kHighlightGain = 32;

// A detail of a sheet: its upper left corner, as shares of the picture.
struct Detail {
  const char* shows;
  double x, y;
};
using Details = std::array<Detail, 2>;
constexpr Details kFigureDetails{{{"bumps", .395, .36}, {"highlight", .235, .195}}};
// Where the bumps of a triangle meet those of its neighbour.
constexpr Details kHeldDetails{{{"edge of triangles", .28, .2}, {"edge of triangles", .785, .31}}};
constexpr std::array<float, 3> kDetailColours[] = {{.93F, .27F, .2F}, {.2F, .5F, .95F}};

int detail_side(int size) { return (size - kSheetMargin) / 2 / kMagnification; }

struct Drawn {
  std::string name;
  Picture picture;
  std::vector<std::uint8_t> covered;
};

class Painter {
 public:
  explicit Painter(const PaperOptions& options) : options_(options) {}

  // Draws the frame by the chosen engine, and appends its line of the table to `entries`.
  Drawn draw(const std::string& name, const DividedFrame& frame, json& entries);
  // Measures a - b over the pixels that both cover, and adds the difference picture to the others.
  json compare_pair(const Drawn& a, const Drawn& b, double gain);

  DividedPatch patch(const std::string& scene, const std::string& config, int divisions) const {
    return {scene, config, divisions, options_.size, Filtering::kConfigured};
  }
  void keep_sheet(const std::string& name, Picture sheet) { result_.sheets.push_back({name, std::move(sheet)}); }
  const Picture& last_picture() const { return result_.pictures.back().picture; }
  PaperFigures& result() { return result_; }

 private:
  PaperOptions options_;
  PaperFigures result_;
};

Drawn Painter::draw(const std::string& name, const DividedFrame& frame, json& entries) {
  Drawn drawing{name, {}, {}};
  json entry{{"name", name}, {"config", frame.config_name}, {"scene", frame.frame.name}};
  if (options_.engine == Engine::kRtl) {
    const ComparedDrawing compared = draw_compared(frame.config, frame.frame, bench_options(options_.rtl));
    drawing.picture = compared.framebuffer.colour();
    drawing.covered = compared.framebuffer.covered();
    if (compared.result.first) fmt::print("{}\n", describe(*compared.result.first));
    result_.equal &= compared.result.equal();
    entry["mismatches"] = compared.result.equal() ? 0 : std::max<std::uint64_t>(compared.result.mismatches, 1);
  } else {
    const Framebuffer framebuffer = drawn(options_.engine, frame.config, frame.frame);
    drawing.picture = framebuffer.colour();
    drawing.covered = framebuffer.covered();
  }
  entry["pixels"] = std::count(drawing.covered.begin(), drawing.covered.end(), 1);
  entries.push_back(std::move(entry));
  result_.pictures.push_back({name, drawing.picture});
  return drawing;
}

json Painter::compare_pair(const Drawn& a, const Drawn& b, double gain) {
  std::vector<std::uint8_t> both = a.covered;
  for (std::size_t i = 0; i < both.size(); ++i) both[i] &= b.covered[i];
  json pair = wrinkle::to_json(picture_error(a.picture, b.picture, both));
  const std::vector<std::uint8_t> everywhere(both.size(), 1);
  pair["psnr_whole_db"] = compare(a.picture, b.picture, everywhere).psnr_db;
  const std::string name = fmt::format("{}_minus_{}_x{}", a.name, b.name, int(gain));
  pair["a"] = a.name;
  pair["b"] = b.name;
  pair["pixels"] = std::count(both.begin(), both.end(), 1);
  pair["difference"] = name;
  pair["gain"] = gain;
  result_.pictures.push_back({name, difference_picture(a.picture, b.picture, gain)});
  return pair;
}

// Pictures side by side with their details outlined, and below them the details, enlarged. Room for `rows` more rows of
// pictures stays white at the bottom.
Picture detail_sheet(const std::vector<Picture>& pictures, const Details& details, int rows = 0) {
  const int size = pictures.front().width, side = detail_side(size), column = size + kSheetMargin;
  Picture sheet = blank_sheet(int(pictures.size()) * column + kSheetMargin,
                              (1 + rows) * column + side * kMagnification + 2 * kSheetMargin);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Picture marked = pictures[i];
    const int left = kSheetMargin + int(i) * column;
    for (std::size_t k = 0; k < details.size(); ++k) {
      const Region region{int(details[k].x * size), int(details[k].y * size), side};
      outline(marked, region, kDetailColours[k], std::max(1, size / 256));
      Picture enlarged = magnified(pictures[i], region, kMagnification);
      constexpr int kBorder = 3;
      outline(enlarged, {kBorder, kBorder, enlarged.width - 2 * kBorder}, kDetailColours[k], kBorder);
      paste(sheet, enlarged, k == 0 ? left : left + size - enlarged.width, column + kSheetMargin);
    }
    paste(sheet, marked, left, kSheetMargin);
  }
  return sheet;
}

json to_json(const Details& details, int size) {
  json list = json::array();
  for (const Detail& detail : details)
    list.push_back({{"shows", detail.shows},
                    {"x", int(detail.x * size)},
                    {"y", int(detail.y * size)},
                    {"side", detail_side(size)},
                    {"magnification", kMagnification}});
  return list;
}

// Figs. 5, 6 and 7, and every pair of them.
void draw_figures(Painter& painter, int size) {
  json& results = painter.result().results;
  std::vector<Drawn> figures;
  for (const auto& [name, scene] :
       {std::pair{"fig5", "patch_fig5"}, std::pair{"fig6", "patch_fig6"}, std::pair{"fig7", "patch_fig7"}})
    figures.push_back(painter.draw(name, divided_frame(painter.patch(scene, "", 8)), results["figures"]));
  std::vector<Picture> pictures, differences;
  for (const Drawn& figure : figures) pictures.push_back(figure.picture);
  for (const auto& [a, b] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
    results["pairs"].push_back(painter.compare_pair(figures[std::size_t(a)], figures[std::size_t(b)], kDifferenceGain));
    differences.push_back(painter.last_picture());
  }
  Picture sheet = detail_sheet(pictures, kFigureDetails, 1);
  for (std::size_t i = 0; i < differences.size(); ++i)
    paste(sheet, differences[i], kSheetMargin + int(i) * (size + kSheetMargin), sheet.height - size - kSheetMargin);
  painter.keep_sheet("figures", std::move(sheet));
  results["details"] = to_json(kFigureDetails, size);
}

// [Ernst et al. 1995] Pv x N and N x Pu held over a triangle, beside Fig. 2 itself, where triangles are largest.
void draw_held(Painter& painter) {
  constexpr int kCoarse = 4;
  json& held = painter.result().results["held"];
  const Drawn constant =
      painter.draw("held_4x4", divided_frame(painter.patch("patch_constant", "", kCoarse)), held["figures"]);
  const Drawn planes =
      painter.draw("interpolated_4x4", divided_frame(painter.patch("patch_fig5", "", kCoarse)), held["figures"]);
  held["divisions"] = kCoarse;
  held["pair"] = painter.compare_pair(constant, planes, kDifferenceGain);
  held["details"] = to_json(kHeldDetails, constant.picture.width);
  painter.keep_sheet("held", detail_sheet({constant.picture, planes.picture, painter.last_picture()}, kHeldDetails));
}

// The frame with nothing but its highlight, white.
DividedFrame highlight_of(DividedFrame frame) {
  for (Draw& draw : frame.frame.draws)
    draw.state.material = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, draw.state.material.exponent};
  return frame;
}

double exact_agreement(const DividedFrame& a, const DividedFrame& b) {
  const Framebuffer first = drawn(Engine::kExact, a.config, a.frame);
  return compare(first.colour(), drawn(Engine::kExact, b.config, b.frame).colour(), first.covered()).psnr_db;
}

// [Kuijk and Blake 1989] N constant in a rotated frame, against Phong shading, whose highlight it must have.
void draw_highlight(Painter& painter) {
  json& highlight = painter.result().results["highlight"];
  const DividedFrame rotated = divided_frame(painter.patch("patch_rotated", "rotated", 8));
  const DividedFrame phong = divided_frame(painter.patch("patch_fig1", "phong", 8));
  const Drawn a = painter.draw("rotated", rotated, highlight["figures"]);
  const Drawn b = painter.draw("phong", phong, highlight["figures"]);
  highlight["pair"] = painter.compare_pair(a, b, kHighlightGain);
  std::vector<Picture> sheet{a.picture, b.picture, painter.last_picture()};
  const Drawn shine_a = painter.draw("rotated_highlight", highlight_of(rotated), highlight["figures"]);
  const Drawn shine_b = painter.draw("phong_highlight", highlight_of(phong), highlight["figures"]);
  highlight["highlight_pair"] = painter.compare_pair(shine_a, shine_b, kHighlightGain);
  for (const Picture& picture : {shine_a.picture, shine_b.picture, painter.last_picture()}) sheet.push_back(picture);
  painter.keep_sheet("highlight", contact_sheet(sheet, 3));
  for (const int divisions : {4, 8, 16, 32}) {
    const DividedFrame coarse_a = divided_frame(painter.patch("patch_rotated", "rotated", divisions));
    const DividedFrame coarse_b = divided_frame(painter.patch("patch_fig1", "phong", divisions));
    highlight["exact"].push_back(
        {{"divisions", divisions},
         {"psnr_db", exact_agreement(coarse_a, coarse_b)},
         {"psnr_highlight_db", exact_agreement(highlight_of(coarse_a), highlight_of(coarse_b))}});
  }
}

// The unit normals of a frame by the exact twin, by pixel; zero where nothing is drawn.
std::vector<Vec3> exact_normals(const DividedFrame& frame) {
  std::vector<Vec3> normals(std::size_t(frame.frame.width) * std::size_t(frame.frame.height));
  draw_exact(frame.config, frame.frame, [&](const ExactFragment& f) {
    normals[std::size_t(f.y) * std::size_t(frame.frame.width) + std::size_t(f.x)] = f.n;
  });
  return normals;
}

// Eq. 8-11 take the patch to be square. This measures by how much their normals lean from those of Eq. 3-6, in degrees,
// and how far the pictures are apart, in decibels.
json warp(const Painter& painter) {
  const DividedFrame true_frame = divided_frame(painter.patch("patch_fig6", "standard", 8));
  const DividedFrame square_frame = divided_frame(painter.patch("patch_fig7", "standard", 8));
  const std::vector<Vec3> a = exact_normals(square_frame), b = exact_normals(true_frame);
  double sum = 0, largest = 0;
  std::uint64_t pixels = 0, bumped = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (b[i] == Vec3{}) continue;
    const double degrees = std::atan2(length(cross(a[i], b[i])), dot(a[i], b[i])) * 180 / std::numbers::pi;
    sum += degrees;
    largest = std::max(largest, degrees);
    ++pixels;
    // Where the map is flat both have the surface's own normal.
    bumped += b[i].z < 1 - 1e-6;
  }
  return {{"pixels", pixels},
          {"bumped_pixels", bumped},
          {"mean_degrees", sum / double(pixels)},
          {"mean_degrees_bumped", bumped > 0 ? sum / double(bumped) : 0},
          {"max_degrees", largest},
          {"psnr_exact_db", exact_agreement(square_frame, true_frame)}};
}

}  // namespace

PaperFigures draw_paper_figures(const PaperOptions& options) {
  Painter painter(options);
  draw_figures(painter, options.size);
  draw_held(painter);
  draw_highlight(painter);
  PaperFigures& result = painter.result();
  result.results["warp"] = warp(painter);
  result.results["tessellation"] = method_table(options.size);
  result.results["size"] = options.size;
  result.results["engine"] = options.engine == Engine::kRtl ? "rtl" : "golden";
  result.results["equal"] = result.equal;
  return std::move(result);
}

}  // namespace wrinkle
