#include "codegen/output/write_file.hpp"

#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace sh::codegen {

namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& content) {
  fs::path temporary = path;
  temporary += ".new" + std::to_string(::getpid());
  std::ofstream stream(temporary, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  std::error_code error;
  if (stream) fs::rename(temporary, path, error);
  if (!stream || error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw std::runtime_error(path.string() +
                             ": cannot be written; the folder should be writable and the disk have space");
  }
}

}  // namespace sh::codegen
