// shforge::batch as methods: many records a call on SIMD lanes, and one call with SIMD inside.
//
// Time: a record of kRecords, in blocks, aligned. Errors: over the check's inputs as they are, one record after the
// other.
#include <algorithm>
#include <functional>

#include "generated/batch/batch.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/report/code.hpp"
#include "numeric/report/methods.hpp"
#include "numeric/report/task_checks.hpp"

namespace sh::numeric {
namespace {

constexpr std::size_t kRecords = 512;

// Inputs of consecutive sizes to an output; of one type.
template <class T>
struct BatchCall {
  std::vector<std::size_t> in;  // sizes of the records, together the flat inputs
  std::size_t out = 0;
  std::function<void(std::size_t n, const std::vector<batch::Records<const T>>& in, batch::Records<T> out)> run;
};

struct FreeAligned {
  void operator()(void* memory) const { std::free(memory); }  // NOLINT(cppcoreguidelines-no-malloc): of aligned_alloc
};
template <class T>
using Aligned = std::unique_ptr<T[], FreeAligned>;

// Zeros, aligned as blocks like it.
template <class T>
Aligned<T> aligned(std::size_t count) {
  constexpr std::size_t kAlignment = 64;
  const std::size_t bytes = (count * sizeof(T) + kAlignment - 1) / kAlignment * kAlignment;
  Aligned<T> memory(static_cast<T*>(std::aligned_alloc(kAlignment, bytes)));
  std::fill_n(memory.get(), count, T(0));
  return memory;
}

// Part `first` .. `first + size` of every input, as records of their own.
template <class T>
std::vector<T> part_of(const Samples<T>& samples, std::size_t first, std::size_t size) {
  std::vector<T> part;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    part.insert(part.end(), samples.input(i) + first, samples.input(i) + first + size);
  }
  return part;
}

template <class T>
void run_batch(const BatchCall<T>& call, const Samples<T>& samples, T* out) {
  std::vector<std::vector<T>> parts;
  std::vector<batch::Records<const T>> in;
  std::size_t first = 0;
  for (const std::size_t size : call.in) {
    parts.push_back(part_of(samples, first, size));
    in.push_back(batch::plain<const T>(parts.back().data()));
    first += size;
  }
  call.run(samples.count(), in, batch::plain(out));
}

template <class T>
double time_batch(const BatchCall<T>& call, const Samples<T>& samples, std::chrono::nanoseconds budget) {
  std::vector<Aligned<T>> memory;
  std::vector<batch::Records<const T>> in;
  std::size_t first = 0;
  for (const std::size_t size : call.in) {
    memory.push_back(aligned<T>(batch::blocked_size<T>(kRecords, size)));
    for (std::size_t i = 0; i < kRecords; ++i) {
      // The last inputs are the random ones.
      const T* const record =
          samples.input(samples.count() - 1 - i % std::min<std::size_t>(64, samples.count())) + first;
      constexpr std::size_t kBlock = batch::kBlock<T>;
      for (std::size_t k = 0; k < size; ++k) {
        memory.back()[i / kBlock * kBlock * size + k * kBlock + i % kBlock] = record[k];
      }
    }
    in.push_back(batch::blocked<const T>(memory.back().get()));
    first += size;
  }
  const auto out = aligned<T>(batch::blocked_size<T>(kRecords, call.out));
  std::vector<std::function<void()>> calls = {[&] { call.run(kRecords, in, batch::blocked(out.get())); }};
  return least_nanoseconds(calls, budget) / static_cast<double>(kRecords);
}

MethodInfo info_of(const std::string& task, const std::string& name, int degree, const std::string& arguments) {
  return {.task = task,
          .name = "batch " + name,
          .degree = degree,
          .scalar = {},
          .mode = Mode::kBatch,
          .header = "generated/batch/batch.hpp",
          .call = "sh::batch::" + name + "(" + std::to_string(degree) + ", n, " + arguments + ")",
          .leaves_out = "a time a record of " + std::to_string(kRecords) + " in blocks",
          .source = "generated, on SIMD lanes"};
}

template <class T>
void add_batch(std::vector<Method>& all, const MethodInfo& info, const FamilyCheck& check, const BatchCall<T>& call) {
  const Code<T> code = {
      [call](const Samples<T>& samples, T* out) { run_batch(call, samples, out); },
      [call](const Samples<T>& samples, std::chrono::nanoseconds budget) { return time_batch(call, samples, budget); }};
  all.push_back(method_of(info, check, code));
}

template <class T>
void add_batches(std::vector<Method>& all, const std::string& task, int degree) {
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  if (task == "basis") {
    add_batch<T>(all, info_of(task, "basis", degree, "directions, out"), task_check("basis"),
                 {{3}, count, [degree](auto n, const auto& in, auto out) { batch::basis(degree, n, in[0], out); }});
  } else if (task == "gradient") {
    add_batch<T>(
        all, info_of(task, "basis_gradient", degree, "directions, out"), task_check("basis_gradient"),
        {{3}, 4 * count, [degree](auto n, const auto& in, auto out) { batch::basis_gradient(degree, n, in[0], out); }});
  } else if (task == "evaluate") {
    add_batch<T>(
        all, info_of(task, "evaluate", degree, "c, directions, out"), task_check("evaluate"),
        {{count, 3}, 1, [degree](auto n, const auto& in, auto out) { batch::evaluate(degree, n, in[0], in[1], out); }});
  } else if (task == "rotate") {
    add_batch<T>(all, info_of(task, "rotate", degree, "r, c, out"), task_check("rotate"),
                 {{9, count}, count, [degree](auto n, const auto& in, auto out) {
                    batch::rotate(degree, n, in[0], in[1], out);
                  }});
  } else if (task == "product" && degree <= 6) {
    add_batch<T>(all, info_of(task, "product", degree, "a, b, out"), task_check("product"),
                 {{count, count}, count, [degree](auto n, const auto& in, auto out) {
                    batch::product(degree, n, in[0], in[1], out);
                  }});
  }
}

// Records with a sum of their own for the errors; one sum for the time.
template <class T>
void add_batch_projection(std::vector<Method>& all, int degree) {
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  const BatchCall<T> timed = {
      {3, 1}, count, [degree](auto n, const auto& in, auto out) { batch::project(degree, n, in[0], in[1], out.data); }};
  const Code<T> code = {runner_of<T>([degree, count](const T* in, T* out) {
                          std::copy_n(in + 4, count, out);
                          batch::project(degree, 1, batch::plain(in), batch::plain(in + 3), out);
                        }),
                        [timed](const Samples<T>& samples, std::chrono::nanoseconds budget) {
                          return time_batch(timed, samples, budget);
                        }};
  all.push_back(
      method_of(info_of("project", "project", degree, "directions, weights, sum"), task_check("project"), code));
}

void add_simd_inside(std::vector<Method>& all, const std::string& task, int degree) {
  const auto info = [&](const std::string& name, const std::string& arguments) {
    auto result = info_of(task, name, degree, "");
    result.name = name + " (SIMD)";
    result.call = "sh::batch::" + name + "(" + std::to_string(degree) + ", " + arguments + ")";
    result.mode = Mode::kOne;
    result.leaves_out = task == "rotate" ? "takes r for a rotation" : "";
    return result;
  };
  if (task == "product") {
    const auto count = static_cast<std::size_t>(coefficient_count(degree));
    all.push_back(
        method_of(info("product_one", "a, b, out"), task_check("product"),
                  code_of<float>(
                      [degree, count](const float* in, float* out) { batch::product_one(degree, in, in + count, out); },
                      degree)));
  }
  if (task != "rotate") return;
  all.push_back(method_of(
      info("rotate_one", "r, c, out"), task_check("rotate"),
      code_of<float>([degree](const float* in, float* out) { batch::rotate_one(degree, in, in + 9, out); }, degree)));
  auto prepared_info = info("rotate_prepared_one", "prepared, c, out");
  prepared_info.mode = Mode::kPrepared;
  prepared_info.leaves_out = "rotate_prepare, once for many functions";
  const auto run = [degree](const float* in, float* out) {
    const auto prepared = aligned<float>(batch::rotate_prepared_size(degree));
    batch::rotate_prepare(degree, in, prepared.get());
    batch::rotate_prepared_one(degree, prepared.get(), in + 9, out);
  };
  all.push_back(method_of(
      prepared_info, task_check("rotate"),
      Code<float>{runner_of<float>(run), [degree](const Samples<float>& samples, std::chrono::nanoseconds budget) {
                    const float* const in = samples.input(samples.count() - 1);
                    const auto prepared = aligned<float>(batch::rotate_prepared_size(degree));
                    batch::rotate_prepare(degree, in, prepared.get());
                    std::vector<float> out(samples.signature.output_count());
                    std::vector<std::function<void()>> calls = {
                        [&] { batch::rotate_prepared_one(degree, prepared.get(), in + 9, out.data()); }};
                    return least_nanoseconds(calls, budget);
                  }}));
}

}  // namespace

void add_batch_methods(std::vector<Method>& all, const std::string& task, int degree) {
  constexpr int kHighest = 10;  // batch.hpp
  if (degree > kHighest) return;
  add_simd_inside(all, task, degree);
  add_batches<float>(all, task, degree);
  add_batches<double>(all, task, degree);
  if (task == "project") {
    add_batch_projection<float>(all, degree);
    add_batch_projection<double>(all, degree);
  }
}

}  // namespace sh::numeric
