#include <algorithm>
#include <cmath>

#include "sim/scene/gltf_parts.h"
#include "sim/scene/textures.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

// Index of the image that a texture shows; `pointer` is who refers to the texture.
int image_of(const GltfFile& file, int texture, const std::string& pointer) {
  const int t = checked_index(file, texture, file.model.textures.size(), "textures", pointer + "/index");
  return checked_index(file, file.model.textures[static_cast<std::size_t>(t)].source, file.model.images.size(),
                       "images", "/textures/" + std::to_string(t) + "/source");
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

void read_sampler(const GltfFile& file, int texture, GltfMaterial& material, Notes& notes) {
  const int index = file.model.textures[static_cast<std::size_t>(texture)].sampler;
  if (index == -1) return;
  const std::string pointer = "/textures/" + std::to_string(texture) + "/sampler";
  checked_index(file, index, file.model.samplers.size(), "samplers", pointer);
  const tinygltf::Sampler& sampler = file.model.samplers[static_cast<std::size_t>(index)];
  const std::string own = "/samplers/" + std::to_string(index);
  material.wrap_u = wrap_of(file, sampler.wrapS, own + "/wrapS");
  material.wrap_v = wrap_of(file, sampler.wrapT, own + "/wrapT");
  const bool nearest =
      sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST || sampler.minFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  if (nearest) notes.push_back(file.place(own).text() + ": asks for nearest; the filter is the configuration's");
}

// Roughness r as the exponent of Blinn and Phong's lobe, n = 2 / r^4 - 2, to the nearest power of two from 1 to 256.
int exponent_of(double roughness) {
  const double n = 2 / std::pow(std::max(roughness, 0.05), 4) - 2;
  return 1 << std::clamp(static_cast<int>(std::lround(std::log2(std::max(n, 1.0)))), 0, 8);
}

double roughness_of(const GltfFile& file, const tinygltf::PbrMetallicRoughness& pbr, const std::string& pointer) {
  const double factor = checked_number(pbr.roughnessFactor, 0, 1, "roughnessFactor", file.place(pointer));
  if (pbr.metallicRoughnessTexture.index == -1) return factor;
  const std::string own = pointer + "/metallicRoughnessTexture";
  return factor * mean_colour(read_gltf_image(file, image_of(file, pbr.metallicRoughnessTexture.index, own))).y;
}

void check_uv_set(const GltfFile& file, int set, const std::string& pointer) {
  if (set < 0 || set > 7) throw InputError(file.place(pointer + "/texCoord"), std::to_string(set), "0 to 7");
}

// Normal map and base colour; a base colour on other texture coordinates than the normal map is left out.
void read_textures(const GltfFile& file, const tinygltf::Material& source, const std::string& pointer,
                   GltfMaterial& material, Notes& notes) {
  const auto& normal = source.normalTexture;
  const auto& base = source.pbrMetallicRoughness.baseColorTexture;
  const std::string normal_pointer = pointer + "/normalTexture";
  const std::string base_pointer = pointer + "/pbrMetallicRoughness/baseColorTexture";
  MipChain normals;
  std::optional<Image> decal;
  material.bump = normal.index != -1;
  material.decal = base.index != -1;
  if (material.decal) {
    check_uv_set(file, base.texCoord, base_pointer);
    const int image = image_of(file, base.index, base_pointer);
    material.uv_set = base.texCoord;
    read_sampler(file, base.index, material, notes);
    decal = read_gltf_image(file, image);
  }
  if (material.bump) {
    check_uv_set(file, normal.texCoord, normal_pointer);
    const double scale = checked_number(normal.scale, -100, 100, "scale", file.place(normal_pointer));
    normals = normals_of(read_gltf_image(file, image_of(file, normal.index, normal_pointer)), scale);
    if (material.decal && base.texCoord != normal.texCoord) {
      notes.push_back(file.place(base_pointer).text() + ": other texture coordinates than the normal map; left out");
      decal.reset();
      material.decal = false;
    }
    material.uv_set = normal.texCoord;
    read_sampler(file, normal.index, material, notes);
  }
  if (material.bump || material.decal) material.texture = make_texture(normals, decal);
}

}  // namespace

GltfMaterial read_gltf_material(const GltfFile& file, int index, const std::string& referrer, Notes& notes) {
  GltfMaterial material;
  if (index == -1) return material;
  checked_index(file, index, file.model.materials.size(), "materials", referrer);
  const std::string pointer = "/materials/" + std::to_string(index);
  const tinygltf::Material& source = file.model.materials[static_cast<std::size_t>(index)];
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const std::string pbr_pointer = pointer + "/pbrMetallicRoughness";
  if (pbr.baseColorFactor.size() != 4) {
    throw InputError(file.place(pbr_pointer + "/baseColorFactor"),
                     std::to_string(pbr.baseColorFactor.size()) + " numbers", "4");
  }
  std::array<double, 3> base{};
  for (std::size_t i = 0; i < 3; ++i) {
    base[i] = checked_number(pbr.baseColorFactor[i], 0, 1, "baseColorFactor", file.place(pbr_pointer));
  }
  const double roughness = roughness_of(file, pbr, pbr_pointer);
  const double specular = 0.04 + 0.3 * (1 - roughness);
  material.material.ambient = 0.1 * Vec3{base[0], base[1], base[2]};
  material.material.diffuse = 0.85 * Vec3{base[0], base[1], base[2]};
  material.material.specular = {specular, specular, specular};
  material.material.exponent = exponent_of(roughness);
  material.double_sided = source.doubleSided;
  if (source.alphaMode != "OPAQUE" && !source.alphaMode.empty()) {
    notes.push_back(file.place(pointer + "/alphaMode").text() + ": drawn opaque");
  }
  read_textures(file, source, pointer, material, notes);
  return material;
}

}  // namespace wrinkle
