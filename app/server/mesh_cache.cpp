#include "app/server/mesh_cache.h"

#include <utility>

#include "app/session/recording.h"
#include "app/session/vessel_glb.h"

namespace app {

base::Result<std::shared_ptr<const EncodedMesh>> MeshCache::mesh(const std::string& anatomy_id) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = meshes_.find(anatomy_id);
    if (found != meshes_.end()) return found->second;
  }
  const auto vessel = scenes_.vessel(anatomy_id);
  if (!vessel) return vessel.error();
  const auto glb = encode_glb((*vessel)->display_surface);
  auto encoded = std::make_shared<EncodedMesh>();
  encoded->bytes.assign(reinterpret_cast<const char*>(glb.data()), glb.size());
  encoded->tag = "\"" + sha256_hex(glb).substr(0, 32) + "\"";

  const std::lock_guard lock(mutex_);
  return meshes_.emplace(anatomy_id, std::move(encoded)).first->second;
}

}  // namespace app
