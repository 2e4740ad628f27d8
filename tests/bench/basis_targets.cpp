// Basis: one direction against the scalar recurrence and the textbook, batches against the time of stores and
// multiply-adds.
#include <algorithm>
#include <string>

#include "generated/batch/batch.hpp"
#include "generated/cpp/basis.hpp"
#include "numeric/methods/textbook_basis.hpp"
#include "tests/bench/controls/recurrence_basis.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr std::size_t kSingles = 512;  // directions, taken one by one
constexpr double kNano = 1e9;

template <class F>
std::function<void()> one_by_one(const std::vector<float>& directions, float* out, const F& f) {
  return [&directions, out, f] {
    for (std::size_t i = 0; i < directions.size(); i += 3) {
      f(directions[i], directions[i + 1], directions[i + 2], out);
      keep(*out);
    }
  };
}

// Multiplications and additions of a kernel cannot take less than this many multiply-adds.
int least_instructions(int degree) {
  const Counts counts = manifest_counts("basis_l" + std::to_string(degree));
  return std::max(counts.mul, counts.add);
}

void single(Table& table) {
  table.section("Basis, one float direction, ns",
                "controls: the scalar recurrence of [Sloan13], the textbook's formula");
  const std::vector<float> directions = random_directions(kSingles);
  const Buffer<float> out = make_buffer<float>(coefficient_count(10));
  for_degrees<2, 10>([&]<int kDegree>() {
    const std::vector<double> t = least_times(
        {one_by_one(directions, out.get(), [](float x, float y, float z, float* o) { sh::basis<kDegree>(x, y, z, o); }),
         one_by_one(directions, out.get(),
                    [](float x, float y, float z, float* o) { control::recurrence_basis<kDegree>(x, y, z, o); }),
         one_by_one(directions, out.get(),
                    [](float x, float y, float z, float* o) { textbook::textbook_basis(kDegree, x, y, z, o); })});
    const double ns = kNano / kSingles;
    const std::string what = "basis_l" + std::to_string(kDegree);
    table.ratio(what + " against the recurrence", "ns", t[0] * ns, t[1] * ns, "recurrence", 1.02);  // 2 % of noise
    table.ratio(what + " against the textbook", "ns", t[0] * ns, t[2] * ns, "textbook", 0.05);
    table.cell("basis, one direction", kDegree, t[0] * ns);
    table.cell("the scalar recurrence [Sloan 2013]", kDegree, t[1] * ns);
    table.cell("the textbook [Green 2003]", kDegree, t[2] * ns);
  });
}

// Whole blocks of directions whose values take half of a first cache of 48 KB.
std::size_t cached_directions(std::size_t values) { return 16 * std::max<std::size_t>(1, 24576 / (64 * values)); }

// The scalar recurrence on 16 lanes, block by block, compiled for this machine and without a call: the strongest control.
template <int Degree>
std::function<void()> recurrence_of_blocks(const float* in, std::size_t n, float* out) {
  return [in, n, out] {
    for (std::size_t block = 0; block < n / 16; ++block) {
      const auto* d = reinterpret_cast<const Sixteen*>(in + 48 * block);
      auto* values = reinterpret_cast<Sixteen*>(out) + block * coefficient_count(Degree);
      control::recurrence_basis<Degree>(d[0], d[1], d[2], values);
    }
    keep(*out);
  };
}

void batched(Table& table) {
  table.section(
      "Basis, batches that stay in the first cache, blocked, ns a direction",
      "controls: the scalar recurrence on 16 lanes; the larger of filling the output and of the multiply-adds");
  for_degrees<2, 9>([&]<int kDegree>() {
    const std::size_t n = cached_directions(coefficient_count(kDegree));
    const Buffer<float> in = to_blocks(random_directions(n), 3);
    const Buffer<float> out = make_buffer<float>(n * coefficient_count(kDegree));
    const std::vector<double> t =
        least_times({[&] { batch::basis(kDegree, n, batch::blocked(in.get()), batch::blocked(out.get())); },
                     recurrence_of_blocks<kDegree>(in.get(), n, out.get()),
                     fill_task(out.get(), n * coefficient_count(kDegree)), fma_task()});
    const double store = t[2] / static_cast<double>(n);
    const double fma = t[3] / kFmaOperations * least_instructions(kDegree) / 16;
    const std::string what = "batch basis, degree " + std::to_string(kDegree);
    const double each = kNano / static_cast<double>(n);
    table.ratio(what, "ns", t[0] * each, t[1] * each, "recurrence", kDegree < 5 ? 1.0 : 0.95);
    table.ratio(what, "ns", t[0] * each, std::max(store, fma) * kNano, store > fma ? "stores" : "multiply-adds", 1.05);
    table.cell("basis, a direction of a batch", kDegree, t[0] * each);
    table.cell("the recurrence on 16 lanes", kDegree, t[1] * each);
    table.cell("filling the output alone", kDegree, store * kNano);
  });
}

void gradients(Table& table) {
  table.section("Values and gradients, batches that stay in the first cache, blocked, ns a direction",
                "limit: filling the output");
  for (int degree = 2; degree <= 6; ++degree) {
    const std::size_t values = 4 * coefficient_count(degree);
    const std::size_t n = cached_directions(values);
    const Buffer<float> in = to_blocks(random_directions(n), 3);
    const Buffer<float> out = make_buffer<float>(n * values);
    const std::vector<double> t =
        least_times({[&] { batch::basis_gradient(degree, n, batch::blocked(in.get()), batch::blocked(out.get())); },
                     fill_task(out.get(), n * values)});
    const double ns = kNano / static_cast<double>(n);
    table.ratio("batch basis_gradient, degree " + std::to_string(degree), "ns", t[0] * ns, t[1] * ns, "stores", 1.2);
    table.cell("values and gradients, of a batch", degree, t[0] * ns);
    table.cell("filling their output alone", degree, t[1] * ns);
  }
}

// More directions than the caches hold the outputs of.
void many(Table& table, std::size_t n, const std::string& where, const std::vector<int>& degrees,
          const std::vector<int>& degrees_of_gradients) {
  const Buffer<float> in = to_blocks(random_directions(n), 3);
  const double ns = kNano / static_cast<double>(n);
  const auto compare = [&](const char* name, const auto& driver, int degree, std::size_t sets) {
    const std::size_t count = batch::blocked_size<float>(n, sets * coefficient_count(degree));
    const Buffer<float> from = make_buffer<float>(count);
    const Buffer<float> out = make_buffer<float>(count);
    const std::vector<double> t = least_times(
        {[&] { driver(degree, out.get()); }, [&] { std::copy_n(from.get(), count, out.get()), keep(*out.get()); }});
    table.ratio(std::string("batch ") + name + ", " + where + ", degree " + std::to_string(degree), "ns", t[0] * ns,
                t[1] * ns, "copying", 1.1);
  };
  for (const int degree : degrees) {
    compare(
        "basis", [&](int l, float* out) { batch::basis(l, n, batch::blocked(in.get()), batch::blocked(out)); }, degree,
        1);
  }
  for (const int degree : degrees_of_gradients) {
    compare(
        "basis_gradient",
        [&](int l, float* out) { batch::basis_gradient(l, n, batch::blocked(in.get()), batch::blocked(out)); }, degree,
        4);
  }
}

}  // namespace

void basis(Table& table) {
  single(table);
  batched(table);
  gradients(table);
  table.section("Basis of many directions, blocked, ns a direction", "limit: copying as many bytes to the same place");
  many(table, 100'000, "100k", {2, 3, 4, 5, 6, 7, 8, 9}, {2, 4, 6});
  many(table, 1'000'000, "1M", {3, 6, 9}, {2, 4});
}

}  // namespace sh::bench
