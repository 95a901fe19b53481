// Vessel surfaces as glTF binary, each encoded once. May be used from several threads.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/session/scene.h"
#include "sim/base/result.h"

namespace app {

struct EncodedMesh {
  std::string bytes;
  std::string tag;  // of the content, for If-None-Match
};

class MeshCache {
 public:
  explicit MeshCache(SceneStore& scenes) : scenes_(scenes) {}
  // Builds the vessel where needed, which takes a second or so. not_found.
  base::Result<std::shared_ptr<const EncodedMesh>> mesh(const std::string& anatomy_id);

 private:
  SceneStore& scenes_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const EncodedMesh>> meshes_;  // shared: with its senders
};

}  // namespace app
