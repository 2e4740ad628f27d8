#include "tests/fuzz/checkpoint_bytes.hpp"

#include <cstdint>
#include <cstring>

#include "prt/transfer/checksum.hpp"

namespace sh::fuzz {
namespace {

constexpr std::size_t kPrologue = 24;
constexpr std::size_t kHead = 32;

template <class Number>
Number number_at(const std::string& bytes, std::size_t place) {
  Number number;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

void put_checksum(std::string& bytes, std::size_t place, const std::string& covered) {
  const std::uint64_t sum = prt::checksum(covered.data(), covered.size());
  std::memcpy(bytes.data() + place, &sum, sizeof sum);
}

}  // namespace

std::string checkpoint_front(std::string_view key) {
  const std::uint32_t numbers[] = {3, static_cast<std::uint32_t>(key.size()), 0, 0};
  std::string front("shpart\n\x1a");
  front.append(reinterpret_cast<const char*>(numbers), sizeof numbers).append(key);
  return checkpoint_with_checksums(front);
}

std::string checkpoint_with_checksums(std::string bytes) {
  std::size_t place = 0;
  if (bytes.starts_with("shpart") && bytes.size() >= kPrologue) {
    const auto key = number_at<std::uint32_t>(bytes, 12);
    if (key > bytes.size() - kPrologue) return bytes;
    put_checksum(bytes, 16, bytes.substr(0, 16) + bytes.substr(kPrologue, key));
    place = kPrologue + key;
  }
  while (bytes.size() - place >= kHead) {
    const auto size = number_at<std::uint64_t>(bytes, place + 8);
    const bool is_inside = size <= bytes.size() - place - kHead;
    if (is_inside) put_checksum(bytes, place + 16, bytes.substr(place + kHead, size));
    put_checksum(bytes, place + 24, bytes.substr(place, 24));
    if (!is_inside) break;
    place += kHead + size;
  }
  return bytes;
}

}  // namespace sh::fuzz
