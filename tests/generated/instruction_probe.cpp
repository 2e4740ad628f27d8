// Runs drivers and plain loops over the headers under callgrind: each measured part ends with a dump, named by a line
// "family scalar degree records way" with way `batch` or `loop` (instruction_count_test.cpp reads them).
#include <valgrind/callgrind.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "generated/batch/batch.hpp"
#include "generated/cpp/basis.hpp"
#include "generated/cpp/basis_gradient.hpp"
#include "generated/cpp/rotate.hpp"

namespace sh::test {
namespace {

template <class Run>
void measure(const std::string& name, const Run& run) {
  run();  // what is done once in a process is not counted
  CALLGRIND_ZERO_STATS;
  run();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

// A loop must not be merged with what measures it.
template <int Degree, class T>
[[gnu::noinline]] void basis_loop(std::size_t n, const T* d, T* out) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  for (std::size_t i = 0; i < n; ++i) sh::basis<Degree>(d[3 * i], d[3 * i + 1], d[3 * i + 2], out + i * kSize);
}

template <int Degree, class T>
[[gnu::noinline]] void gradient_loop(std::size_t n, const T* d, T* out) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  for (std::size_t i = 0; i < n; ++i) {
    T* to = out + i * 4 * kSize;
    sh::basis_gradient<Degree>(d[3 * i], d[3 * i + 1], d[3 * i + 2], to, to + kSize, to + 2 * kSize, to + 3 * kSize);
  }
}

template <int Degree, class T>
[[gnu::noinline]] void rotate_loop(std::size_t n, const T* r, const T* c, T* out) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  for (std::size_t i = 0; i < n; ++i) sh::rotate<Degree>(r, c + i * kSize, out + i * kSize);
}

template <int Degree, class T>
void measure_degree(const std::string& scalar) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  constexpr std::size_t kMost = 320;
  std::vector<T> d(3 * kMost);
  for (std::size_t i = 0; i < kMost; ++i) d[3 * i + i % 3] = T(1);
  std::vector<T> out(4 * kSize * kMost);
  const std::vector<T> c(kSize * kMost, T(1));
  constexpr T kTurn[] = {T(.36), T(.48), T(-.8), T(-.8), T(.6), T(0), T(.48), T(.64), T(.6)};
  for (const std::size_t n : {std::size_t{1}, std::size_t{2}, std::size_t{17}, kMost}) {
    const std::string name = scalar + " " + std::to_string(Degree) + " " + std::to_string(n) + " ";
    measure("basis " + name + "batch",
            [&] { batch::basis(Degree, n, batch::plain<const T>(d.data()), batch::plain(out.data())); });
    measure("basis " + name + "loop", [&] { basis_loop<Degree>(n, d.data(), out.data()); });
    measure("basis_gradient " + name + "batch",
            [&] { batch::basis_gradient(Degree, n, batch::plain<const T>(d.data()), batch::plain(out.data())); });
    measure("basis_gradient " + name + "loop", [&] { gradient_loop<Degree>(n, d.data(), out.data()); });
    measure("rotate " + name + "batch", [&] {
      batch::rotate(Degree, n, batch::shared<const T>(kTurn), batch::plain<const T>(c.data()),
                    batch::plain(out.data()));
    });
    measure("rotate " + name + "loop", [&] { rotate_loop<Degree, T>(n, kTurn, c.data(), out.data()); });
  }
}

template <class T, int... Degree>
void measure_all(const std::string& scalar, std::integer_sequence<int, Degree...> /*degrees*/) {
  (measure_degree<Degree, T>(scalar), ...);
}

}  // namespace
}  // namespace sh::test

int main() {
  using namespace sh;
  batch::use_instruction_set(batch::InstructionSet::kAvx2);
  test::measure_all<float>("float", std::make_integer_sequence<int, 11>());
  test::measure_all<double>("double", std::make_integer_sequence<int, 11>());
}
