// The viewer: one HTML file that holds its modules (prt/view/web), the generated functions of a degree, and transfer
// files as they are, alone or placed on stages; and the ES module with which pages of others relight such files.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/scene/camera.hpp"
#include "prt/scene/stage.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A transfer file: its name for people, its bytes, and what they hold.
struct ViewedFile {
  std::string name;
  std::string bytes;
  std::shared_ptr<const Transfer> transfer;
};

/// What a page shows at a time: a transfer file, or the objects of a stage.
struct ViewedSubject {
  std::string name;                                 // of its file
  std::string title;                                // of its scene
  std::vector<std::size_t> files;                   // of each object: its place among those of the page
  std::vector<StageObject> objects;                 // how they stand on their stage; empty for a transfer file
  std::vector<std::optional<std::size_t>> volumes;  // of each object of a stage: the place of the space around it
};

/// At least one subject.
struct Viewed {
  std::vector<ViewedFile> files;
  std::vector<ViewedSubject> subjects;
};

struct ViewedLight {
  std::string name;
  LightCoefficients coefficients;
};

/// The most bytes of all files of a page: what browsers read as one string, after base64.
inline constexpr std::size_t kMostEmbedded = std::size_t{256} << 20U;

/// Where the page has the bytes of the files: in itself, or at the addresses file/0, file/1, ... of its server.
enum class FilesOfPage { kInside, kServed };

/// The page. `light` has the highest degree of the files. Without a camera the page frames the meshes. Throws
/// std::invalid_argument for more bytes inside than kMostEmbedded.
std::string viewer_page(const Viewed& viewed, const ViewedLight& light, const std::optional<Camera>& camera,
                        FilesOfPage where = FilesOfPage::kInside);

/// The ES module that reads and relights files of the kind, shapes and materials of this one (prt/view/MODULE.md).
std::string viewer_module(const Transfer& transfer);

}  // namespace sh::prt
