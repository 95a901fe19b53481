#include "app/session/vessel_glb.h"

#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim/base/require.h"

namespace app {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "glTF is little endian");

// Codes of the glTF 2.0 specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

// Fills a file whose size is known from the start.
class Writer {
 public:
  explicit Writer(std::size_t size) : bytes_(size) {}

  void put(std::span<const std::byte> raw) {
    assert(used_ + raw.size() <= bytes_.size());
    std::memcpy(bytes_.data() + used_, raw.data(), raw.size());
    used_ += raw.size();
  }
  void put(std::uint32_t number) { put(std::as_bytes(std::span(&number, 1))); }
  void put(const std::vector<sim::Vec3>& vectors) {
    for (const sim::Vec3& vector : vectors) {
      const Eigen::Vector3f stored = vector.cast<float>();
      put(std::as_bytes(std::span(stored.data(), 3)));
    }
  }

  std::vector<std::byte> take() {
    assert(used_ == bytes_.size());
    return std::move(bytes_);
  }

 private:
  std::vector<std::byte> bytes_;
  std::size_t used_ = 0;
};

// Exactly the extremes of the float32 numbers stored, as the specification demands.
Json extreme(const std::vector<sim::Vec3>& vectors, bool highest) {
  sim::Vec3 found = vectors.front();
  for (const sim::Vec3& vector : vectors) {
    found = highest ? found.cwiseMax(vector).eval() : found.cwiseMin(vector).eval();
  }
  const Eigen::Vector3f stored = found.cast<float>();
  return Json::array({stored.x(), stored.y(), stored.z()});
}

Json description(const sim::TriangleMesh& mesh) {
  const std::size_t vertex_bytes = 12 * mesh.vertices.size();
  const std::size_t index_bytes = 12 * mesh.triangles.size();
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", "cathedra"}};
  json["scene"] = 0;
  json["scenes"] = Json::array({Json{{"nodes", Json::array({0})}}});
  json["nodes"] = Json::array({Json{{"mesh", 0}}});
  const Json primitive = {
      {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}, {"mode", 4}};
  json["meshes"] = Json::array({Json{{"primitives", Json::array({primitive})}}});
  json["buffers"] = Json::array({Json{{"byteLength", 2 * vertex_bytes + index_bytes}}});
  const auto view = [](std::size_t offset, std::size_t length, int target) {
    return Json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", target}};
  };
  json["bufferViews"] = Json::array({view(0, vertex_bytes, kVertexBuffer),
                                     view(vertex_bytes, vertex_bytes, kVertexBuffer),
                                     view(2 * vertex_bytes, index_bytes, kIndexBuffer)});
  const auto accessor = [](int buffer_view, int component, std::size_t count, const char* type) {
    return Json{{"bufferView", buffer_view},
                {"componentType", component},
                {"count", count},
                {"type", type}};
  };
  Json positions = accessor(0, kFloat, mesh.vertices.size(), "VEC3");
  positions["min"] = extreme(mesh.vertices, false);
  positions["max"] = extreme(mesh.vertices, true);
  json["accessors"] = Json::array({positions, accessor(1, kFloat, mesh.vertices.size(), "VEC3"),
                                   accessor(2, kUnsignedInt, 3 * mesh.triangles.size(), "SCALAR")});
  return json;
}

}  // namespace

std::vector<std::byte> encode_glb(const sim::TriangleMesh& mesh) {
  base::require(!mesh.triangles.empty() && !mesh.vertices.empty(), "there is no surface to draw");
  base::require(mesh.normals.size() == mesh.vertices.size(),
                "a surface to draw needs a normal for each vertex");
  std::string json = description(mesh).dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');  // chunks are padded to whole words

  const std::size_t binary_size = 24 * mesh.vertices.size() + 12 * mesh.triangles.size();
  const std::size_t total = 12 + 8 + json.size() + 8 + binary_size;

  Writer file(total);
  for (const std::size_t number :
       {std::size_t{kMagic}, std::size_t{2}, total, json.size(), std::size_t{kJsonChunk}}) {
    file.put(static_cast<std::uint32_t>(number));
  }
  file.put(std::as_bytes(std::span(json)));
  file.put(static_cast<std::uint32_t>(binary_size));
  file.put(kBinaryChunk);
  file.put(mesh.vertices);
  file.put(mesh.normals);
  for (const auto& triangle : mesh.triangles) file.put(std::as_bytes(std::span(triangle)));
  return file.take();
}

}  // namespace app
