// Scenes of a few meshes.
#pragma once
#include <string>

#include "prt/scene/scene.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {

/// The scene whose `meshes` are these, without a ground.
inline Scene scene_of_json(const std::string& meshes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("scene.json");
  write_all(file, R"({"meshes": [)" + meshes + "]}");
  return load_scene(file, OnFlaw::kRefuse);
}

}  // namespace sh::prt::test
