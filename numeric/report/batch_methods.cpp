// shforge::batch as methods: many records a call on SIMD lanes, and one call with SIMD inside.
//
// Time: of a record of kRecords, in aligned blocks. Errors: over the inputs of the check, plain.
#include <fmt/core.h>

#include <boost/align/aligned_allocator.hpp>

#include "generated/batch/batch.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/report/method.hpp"
#include "numeric/report/tasks.hpp"

namespace sh::numeric {
namespace {

constexpr int kRecords = 512;

template <class T>
using Aligned = std::vector<T, boost::alignment::aligned_allocator<T, 64>>;
template <class T>
using Inputs = std::vector<batch::Records<const T>>;

// A call on n records: inputs of some sizes, together the flat input, to an output.
template <class T>
struct BatchCall {
  const char* task;
  const char* name;  ///< in sh::batch, and of the family
  const char* arguments;
  std::vector<int> in;
  int out;
  std::function<void(std::size_t n, const Inputs<T>& in, batch::Records<T> out)> run;
  int highest = 10;
};

template <class T>
void run_batch(const BatchCall<T>& call, const Samples<T>& samples, T* out) {
  std::vector<std::vector<T>> parts;
  Inputs<T> in;
  int first = 0;
  for (const int size : call.in) {
    auto& part = parts.emplace_back();
    for (std::size_t i = 0; i < samples.count(); ++i) {
      part.insert(part.end(), samples.input(i) + first, samples.input(i) + first + size);
    }
    in.push_back(batch::plain<const T>(part.data()));
    first += size;
  }
  call.run(samples.count(), in, batch::plain(out));
}

template <class T>
double time_batch(const BatchCall<T>& call, const Samples<T>& samples, std::chrono::nanoseconds budget) {
  constexpr std::size_t kBlock = batch::kBlock<T>;
  std::vector<Aligned<T>> parts;
  Inputs<T> in;
  int first = 0;
  for (const int size : call.in) {
    auto& part = parts.emplace_back(batch::blocked_size<T>(kRecords, size));
    for (std::size_t i = 0; i < kRecords; ++i) {
      // The last inputs are the random ones.
      const T* const record =
          samples.input(samples.count() - 1 - i % std::min<std::size_t>(64, samples.count())) + first;
      for (int k = 0; k < size; ++k) part[i / kBlock * kBlock * size + k * kBlock + i % kBlock] = record[k];
    }
    in.push_back(batch::blocked<const T>(part.data()));
    first += size;
  }
  Aligned<T> out(batch::blocked_size<T>(kRecords, call.out));
  std::vector<std::function<void()>> calls = {[&] { call.run(kRecords, in, batch::blocked(out.data())); }};
  return least_nanoseconds(calls, budget) / kRecords;
}

template <class T>
std::vector<BatchCall<T>> batch_calls(int degree) {
  const int count = coefficient_count(degree);
  return {{"basis",
           "basis",
           "directions, out",
           {3},
           count,
           [=](auto n, const auto& in, auto out) { batch::basis(degree, n, in[0], out); }},
          {"gradient",
           "basis_gradient",
           "directions, out",
           {3},
           4 * count,
           [=](auto n, const auto& in, auto out) { batch::basis_gradient(degree, n, in[0], out); }},
          {"evaluate",
           "evaluate",
           "c, directions, out",
           {count, 3},
           1,
           [=](auto n, const auto& in, auto out) { batch::evaluate(degree, n, in[0], in[1], out); }},
          {"project",
           "project",
           "directions, weights, sum",
           {3, 1},
           count,
           [=](auto n, const auto& in, auto out) { batch::project(degree, n, in[0], in[1], out.data); }},
          {"rotate",
           "rotate",
           "r, c, out",
           {9, count},
           count,
           [=](auto n, const auto& in, auto out) { batch::rotate(degree, n, in[0], in[1], out); }},
          {"product",
           "product",
           "a, b, out",
           {count, count},
           count,
           [=](auto n, const auto& in, auto out) { batch::product(degree, n, in[0], in[1], out); },
           6}};
}

MethodInfo info_of(const std::string& task, int degree) {
  return {.task = task,
          .name = {},
          .degree = degree,
          .header = "generated/batch/batch.hpp",
          .source = "generated, on SIMD lanes"};
}

template <class T>
void add_batches(std::vector<Method>& all, const std::string& task, int degree) {
  for (const BatchCall<T>& call : batch_calls<T>(degree)) {
    if (call.task != task || degree > call.highest) continue;
    MethodInfo info = info_of(task, degree);
    info.name = fmt::format("batch {}", call.name);
    info.mode = Mode::kBatch;
    info.call = fmt::format("sh::batch::{}({}, n, {})", call.name, degree, call.arguments);
    info.leaves_out = fmt::format("a time a record of {} in blocks", kRecords);
    Code<T> code = {[call](const Samples<T>& samples, T* out) { run_batch(call, samples, out); },
                    [call](const Samples<T>& samples, std::chrono::nanoseconds budget) {
                      return time_batch(call, samples, budget);
                    }};
    if (task == "project") {  // one sum for the time; a sum for each record, begun with its inputs, for the errors
      code.run = runner_of<T>([=, count = call.out](const T* in, T* out) {
        std::copy_n(in + 4, count, out);
        batch::project(degree, 1, batch::plain(in), batch::plain(in + 3), out);
      });
    }
    all.push_back(method_of(info, task_check(call.name), code));
  }
}

MethodInfo simd_info(const std::string& task, int degree, const std::string& name, const std::string& arguments) {
  MethodInfo info = info_of(task, degree);
  info.name = name + " (SIMD)";
  info.call = fmt::format("sh::batch::{}({}, {})", name, degree, arguments);
  if (task == "rotate") info.leaves_out = "takes r for a rotation";
  return info;
}

Method prepared_rotation(int degree) {
  MethodInfo info = simd_info("rotate", degree, "rotate_prepared_one", "prepared, c, out");
  info.mode = Mode::kPrepared;
  info.leaves_out = "rotate_prepare, once for many functions";
  const auto prepare = [degree](const float* r) {
    Aligned<float> prepared(batch::rotate_prepared_size(degree));
    batch::rotate_prepare(degree, r, prepared.data());
    return prepared;
  };
  const auto run = [=](const float* in, float* out) {
    batch::rotate_prepared_one(degree, prepare(in).data(), in + 9, out);
  };
  const auto time = [=](const Samples<float>& samples, std::chrono::nanoseconds budget) {
    const float* const in = samples.input(samples.count() - 1);
    const auto prepared = prepare(in);
    std::vector<float> out(samples.signature.output_count());
    std::vector<std::function<void()>> calls = {
        [&] { batch::rotate_prepared_one(degree, prepared.data(), in + 9, out.data()); }};
    return least_nanoseconds(calls, budget);
  };
  return method_of(info, task_check("rotate"), Code<float>{runner_of<float>(run), time});
}

void add_simd_inside(std::vector<Method>& all, const std::string& task, int degree) {
  const auto add = [&](const char* name, const char* arguments, const FlatFunction<float>& function) {
    all.push_back(
        method_of(simd_info(task, degree, name, arguments), task_check(task), code_of<float>(function, degree)));
  };
  if (task == "product") {
    add("product_one", "a, b, out", [=, count = coefficient_count(degree)](const float* in, float* out) {
      batch::product_one(degree, in, in + count, out);
    });
  } else if (task == "rotate") {
    add("rotate_one", "r, c, out", [=](const float* in, float* out) { batch::rotate_one(degree, in, in + 9, out); });
    all.push_back(prepared_rotation(degree));
  }
}

}  // namespace

void add_batch_methods(std::vector<Method>& all, const std::string& task, int degree) {
  constexpr int kHighest = 10;  // batch.hpp
  if (degree > kHighest) return;
  add_simd_inside(all, task, degree);
  add_batches<float>(all, task, degree);
  add_batches<double>(all, task, degree);
}

}  // namespace sh::numeric
