#include "numeric/output/read_file.hpp"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace sh::output {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const std::string& path, int error) {
  throw std::runtime_error(fmt::format("{}: cannot read: {}", path, std::strerror(error)));
}

}  // namespace

std::string read_file(const std::string& path, std::size_t largest) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, errno);
  std::string text;
  std::array<char, 65536> part;
  for (std::size_t got = part.size(); got == part.size();) {
    got = std::fread(part.data(), 1, part.size(), file.get());
    if (std::ferror(file.get()) != 0) fail(path, errno);
    text.append(part.data(), got);
    if (text.size() > largest)
      throw std::runtime_error(fmt::format("{}: larger than {} MB", path, largest / 1'000'000));
  }
  return text;
}

}  // namespace sh::output
