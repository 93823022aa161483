#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "sim/scene/gltf_parts.h"
#include "sim/scene/textures.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

using nlohmann::json;

// An element of the document by its pointer; null where there is none.
const json& element_of(const GltfFile& file, const std::string& pointer) {
  static const json kNone;
  const json::json_pointer at(pointer);
  return file.json.contains(at) ? file.json.at(at) : kNone;
}

double number_of(const GltfFile& file, const std::string& pointer, double standard, double minimum, double maximum) {
  const json& value = element_of(file, pointer);
  if (value.is_null()) return standard;
  const std::string key = pointer.substr(pointer.rfind('/') + 1);
  if (!value.is_number()) throw InputError(file.place(pointer), value.dump().substr(0, 60), "a number");
  return checked_number(value.get<double>(), minimum, maximum, key, file.place(pointer));
}

// `standard` where there is no array, else as many numbers.
std::vector<double> numbers_of(const GltfFile& file, const std::string& pointer, std::vector<double> standard,
                               double minimum, double maximum) {
  const json& value = element_of(file, pointer);
  if (value.is_null()) return standard;
  if (!value.is_array() || value.size() != standard.size()) {
    throw InputError(file.place(pointer), shortened(value.dump()), std::to_string(standard.size()) + " numbers");
  }
  for (std::size_t i = 0; i < standard.size(); ++i) {
    standard[i] = number_of(file, pointer + "/" + std::to_string(i), 0, minimum, maximum);
  }
  return standard;
}

int index_of(const GltfFile& file, const std::string& pointer, int standard) {
  return static_cast<int>(number_of(file, pointer, standard, -1, 2147483647.0));
}

// How a material uses a texture.
struct TextureUse {
  int texture = -1;
  int uv_set = 0;
  UvTransform transform;
  std::string pointer;
};

std::optional<TextureUse> texture_use(const GltfFile& file, const std::string& pointer) {
  if (!element_of(file, pointer).is_object()) return std::nullopt;
  const std::string extension = pointer + "/extensions/KHR_texture_transform";
  TextureUse use{index_of(file, pointer + "/index", -1), index_of(file, pointer + "/texCoord", 0), {}, pointer};
  checked_index(file, use.texture, file.model.textures.size(), "textures", pointer + "/index");
  use.uv_set = index_of(file, extension + "/texCoord", use.uv_set);
  if (use.uv_set < 0 || use.uv_set > 7) {
    throw InputError(file.place(pointer + "/texCoord"), std::to_string(use.uv_set), "0 to 7");
  }
  const std::vector<double> offset = numbers_of(file, extension + "/offset", {0, 0}, -1e6, 1e6);
  const std::vector<double> scale = numbers_of(file, extension + "/scale", {1, 1}, -1e6, 1e6);
  use.transform = {
      {offset[0], offset[1]}, {scale[0], scale[1]}, number_of(file, extension + "/rotation", 0, -1e6, 1e6)};
  return use;
}

// Index of the image that a texture shows: that of an extension for a format that OpenImageIO reads before the plain
// one, which stands for programs that do not know the extension.
int image_of(const GltfFile& file, const TextureUse& use) {
  const std::string pointer = "/textures/" + std::to_string(use.texture);
  int source = file.model.textures[static_cast<std::size_t>(use.texture)].source;
  for (const char* name : {"MSFT_texture_dds", "EXT_texture_webp"}) {
    source = index_of(file, pointer + "/extensions/" + name + "/source", source);
  }
  if (source == -1 && !element_of(file, pointer + "/extensions").is_null()) {
    throw InputError(file.place(pointer + "/extensions"),
                     "an image in an extension that is not known: " +
                         shortened(element_of(file, pointer + "/extensions").begin().key()),
                     "a source that is PNG or JPEG");
  }
  return checked_index(file, source, file.model.images.size(), "images", pointer + "/source");
}

Wrap wrap_of(const GltfFile& file, int mode, const std::string& pointer) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return Wrap::kRepeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::kClamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::kMirror;
    default:
      throw InputError(file.place(pointer), std::to_string(mode), "10497, 33071 or 33648");
  }
}

Wraps read_sampler(const GltfFile& file, int texture, Notes& notes) {
  const int index = file.model.textures[static_cast<std::size_t>(texture)].sampler;
  if (index == -1) return {};
  const std::string pointer = "/textures/" + std::to_string(texture) + "/sampler";
  checked_index(file, index, file.model.samplers.size(), "samplers", pointer);
  const tinygltf::Sampler& sampler = file.model.samplers[static_cast<std::size_t>(index)];
  const std::string own = "/samplers/" + std::to_string(index);
  const bool nearest =
      sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST || sampler.minFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  if (nearest) notes.push_back(file.place(own).text() + ": asks for nearest; the filter is the configuration's");
  return {wrap_of(file, sampler.wrapS, own + "/wrapS"), wrap_of(file, sampler.wrapT, own + "/wrapT")};
}

// Roughness r as the exponent of Blinn and Phong's lobe, n = 2 / r^4 - 2, to the nearest power of two from 1 to 256.
int exponent_of(double roughness) {
  const double n = 2 / std::pow(std::max(roughness, 0.05), 4) - 2;
  return 1 << std::clamp(static_cast<int>(std::lround(std::log2(std::max(n, 1.0)))), 0, 8);
}

double roughness_of(const GltfFile& file, const std::string& pointer, PassedOver& passed_over) {
  const double factor = number_of(file, pointer + "/roughnessFactor", 1, 0, 1);
  const auto use = texture_use(file, pointer + "/metallicRoughnessTexture");
  const double metallic = number_of(file, pointer + "/metallicFactor", use ? 1 : 0, 0, 1);
  if (metallic > 0) passed_over.see("metallic is not applied", file.place(pointer));
  if (!use) return factor;
  passed_over.see("of the texture of roughness only the mean is used", file.place(use->pointer));
  return factor * mean_colour(read_gltf_image(file, image_of(file, *use))).y;
}

// What is lit: base colour, specular colour and exponent.
Material material_of(const std::vector<double>& base, Vec3 specular, double roughness) {
  Material material;
  material.ambient = 0.1 * Vec3{base[0], base[1], base[2]};
  material.diffuse = 0.85 * Vec3{base[0], base[1], base[2]};
  material.specular = {std::min(specular.x, 1.0), std::min(specular.y, 1.0), std::min(specular.z, 1.0)};
  material.exponent = exponent_of(roughness);
  return material;
}

// `specular`: the extension KHR_materials_specular, whose factors are of the whole highlight here.
Material metallic_roughness(const GltfFile& file, const std::string& pointer, const std::string& specular,
                            PassedOver& passed_over) {
  const std::vector<double> base = numbers_of(file, pointer + "/baseColorFactor", {1, 1, 1, 1}, 0, 1);
  const double roughness = roughness_of(file, pointer, passed_over);
  const double lobe = (0.04 + 0.3 * (1 - roughness)) * number_of(file, specular + "/specularFactor", 1, 0, 1);
  const std::vector<double> colour = numbers_of(file, specular + "/specularColorFactor", {1, 1, 1}, 0, 1e6);
  if (texture_use(file, specular + "/specularColorTexture")) {
    passed_over.see("the texture of specular colour is not applied", file.place(specular));
  }
  return material_of(base, {lobe * colour[0], lobe * colour[1], lobe * colour[2]}, roughness);
}

Material specular_glossiness(const GltfFile& file, const std::string& pointer, PassedOver& passed_over) {
  const std::vector<double> base = numbers_of(file, pointer + "/diffuseFactor", {1, 1, 1, 1}, 0, 1);
  const std::vector<double> f = numbers_of(file, pointer + "/specularFactor", {1, 1, 1}, 0, 1);
  const double glossiness = number_of(file, pointer + "/glossinessFactor", 1, 0, 1);
  if (texture_use(file, pointer + "/specularGlossinessTexture")) {
    passed_over.see("of the texture of specular colour and glossiness only the colour is used", file.place(pointer));
  }
  const double lobe = 0.3 * glossiness;
  return material_of(base, {f[0] + lobe, f[1] + lobe, f[2] + lobe}, 1 - glossiness);
}

// Where the textures of a material are, but for its normal map.
struct TexturePointers {
  std::string base, gloss;
  bool gloss_is_alpha = true;  // else its colour
};

std::optional<Image> read_gloss(const GltfFile& file, const TextureUse& use, bool is_alpha, Notes& notes) {
  const std::string place = file.place(use.pointer).text();
  if (!is_alpha) return gloss_of(read_gltf_image(file, image_of(file, use)), place, notes);
  Image alpha = read_gltf_alpha(file, image_of(file, use));
  if (!alpha.pixels.empty()) return alpha;
  notes.push_back(place + ": has no alpha, and with it no gloss");
  return std::nullopt;
}

// The texture that all others of the material are drawn like: its coordinates and wrap modes are theirs.
struct Leading {
  const TextureUse& use;
  const char* name;
  Wraps wraps;
};

// Whether a texture is drawn beside the leading one; what is lost or changed is noted.
bool follows(const GltfFile& file, const TextureUse& use, const Leading& leading, Notes& notes) {
  if (&use == &leading.use) return true;
  const std::string place = file.place(use.pointer).text();
  if (use.uv_set != leading.use.uv_set || use.transform != leading.use.transform) {
    notes.push_back(place + ": other texture coordinates than the " + leading.name + "; left out");
    return false;
  }
  const Wraps own = read_sampler(file, use.texture, notes);
  if (own.u != leading.wraps.u || own.v != leading.wraps.v) {
    notes.push_back(place + ": drawn with the wrap modes of the " + leading.name);
  }
  return true;
}

// Normal map, base colour and gloss, as far as they are on the same texture coordinates.
void read_textures(const GltfFile& file, const std::string& pointer, const TexturePointers& pointers,
                   GltfMaterial& material, Notes& notes) {
  const auto normal = texture_use(file, pointer + "/normalTexture");
  const auto base = texture_use(file, pointers.base), gloss = texture_use(file, pointers.gloss);
  material.bump = normal.has_value();
  if (!normal && !base && !gloss) return;
  const TextureUse& use = normal ? *normal : base ? *base : *gloss;
  const Leading leading{use, normal ? "normal map" : "base colour", read_sampler(file, use.texture, notes)};
  material.uv_set = use.uv_set;
  material.uv_transform = use.transform;
  material.wrap_u = leading.wraps.u;
  material.wrap_v = leading.wraps.v;
  MipChain normals;
  std::optional<Image> decal, shine;
  if (base && follows(file, *base, leading, notes)) decal = read_gltf_image(file, image_of(file, *base));
  if (gloss && follows(file, *gloss, leading, notes)) shine = read_gloss(file, *gloss, pointers.gloss_is_alpha, notes);
  if (normal) {
    const double scale = number_of(file, normal->pointer + "/scale", 1, -100, 100);
    normals = normals_of(read_gltf_normal_map(file, image_of(file, *normal), notes), scale, leading.wraps);
  }
  material.maps = {decal.has_value(), shine.has_value()};
  if (normal || decal || shine) material.texture = make_texture(normals, decal, shine, leading.wraps);
}

// What the file says of the material and is not drawn.
void note_the_rest(const GltfFile& file, const std::string& pointer, PassedOver& passed_over) {
  const json& mode = element_of(file, pointer + "/alphaMode");
  if (mode.is_string() && mode != "OPAQUE") {
    passed_over.see("alphaMode " + shortened(mode.get<std::string>()) + " is not applied: drawn opaque",
                    file.place(pointer + "/alphaMode"));
  }
  for (const double c : numbers_of(file, pointer + "/emissiveFactor", {0, 0, 0}, 0, 1e6)) {
    if (c > 0) {
      passed_over.see("emission is not applied", file.place(pointer + "/emissiveFactor"));
      break;
    }
  }
  if (texture_use(file, pointer + "/occlusionTexture")) {
    passed_over.see("occlusion is not applied", file.place(pointer + "/occlusionTexture"));
  }
}

}  // namespace

// Rotation, counter-clockwise as the image is seen, which has v downwards.
Vec2 UvTransform::operator()(Vec2 uv) const {
  if (*this == UvTransform{}) return uv;
  const Vec2 s{scale.x * uv.x, scale.y * uv.y};
  const double c = std::cos(rotation), d = std::sin(rotation);
  return {c * s.x + d * s.y + offset.x, -d * s.x + c * s.y + offset.y};
}

GltfMaterial read_gltf_material(const GltfFile& file, int index, const std::string& referrer, PassedOver& passed_over,
                                Notes& notes) {
  GltfMaterial material;
  if (index == -1) return material;
  checked_index(file, index, file.model.materials.size(), "materials", referrer);
  const std::string pointer = "/materials/" + std::to_string(index);
  const std::string metallic = pointer + "/pbrMetallicRoughness", extensions = pointer + "/extensions/";
  const std::string glossy = extensions + "KHR_materials_pbrSpecularGlossiness";
  const std::string specular = extensions + "KHR_materials_specular";
  const bool is_glossy = element_of(file, glossy).is_object();
  material.material = is_glossy ? specular_glossiness(file, glossy, passed_over)
                                : metallic_roughness(file, metallic, specular, passed_over);
  material.double_sided = file.model.materials[static_cast<std::size_t>(index)].doubleSided;
  note_the_rest(file, pointer, passed_over);
  const TexturePointers of_glossy{glossy + "/diffuseTexture", glossy + "/specularGlossinessTexture", false};
  const TexturePointers of_metallic{metallic + "/baseColorTexture", specular + "/specularTexture"};
  read_textures(file, pointer, is_glossy ? of_glossy : of_metallic, material, notes);
  return material;
}

}  // namespace wrinkle
