// Calls a bound C++ kernel with its inputs and outputs as one array each, in the order of signature.hpp.
//
// Every argument lives in storage of exactly its size, so that the sanitizers see any access beyond it.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/signature.hpp"

namespace sh::numeric {

/// Throws std::logic_error, one line, unless the kernel's arguments are those of the signature.
inline void require_match(const BoundKernel& kernel, const Signature& signature) {
  const auto matches = [](ArgumentKind kind, const Parameter& parameter) {
    if (parameter.count == 0) return kind == ArgumentKind::kValue;
    return kind == (parameter.access == Access::kIn ? ArgumentKind::kReadArray : ArgumentKind::kWriteArray);
  };
  if (kernel.returns_value == signature.returns_value &&
      std::equal(kernel.arguments.begin(), kernel.arguments.end(), signature.parameters.begin(),
                 signature.parameters.end(), matches)) {
    return;
  }
  throw std::logic_error(kernel.name() + ": expected the arguments that its check describes, got others");
}

/// Two parameters, by place in the signature, of which the second may overwrite the first: equal sizes, in and out.
struct InPlacePair {
  std::size_t read;
  std::size_t written;
};
inline std::vector<InPlacePair> in_place_pairs(const Signature& signature) {
  std::vector<InPlacePair> pairs;
  const auto& all = signature.parameters;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool in_and_out = all[i].access == Access::kIn && all[k].access == Access::kOut;
      const bool same_shape = all[i].count == all[k].count && all[i].rows == all[k].rows;
      if (in_and_out && same_shape && all[i].count > 0) pairs.push_back({i, k});
    }
  }
  return pairs;
}

/// T: float, double or Wide.
template <class T>
class FlatCall {
 public:
  FlatCall(const BoundKernel& kernel, const Signature& signature)
      : call_(kernel.call<T>()), signature_(signature), storage_(signature.parameters.size() + 1) {
    require_match(kernel, signature);
    for (std::size_t i = 0; i < signature.parameters.size(); ++i) {
      storage_[i].resize(signature.parameters[i].values());
      pointers_.push_back(storage_[i].data());
      if (signature.parameters[i].access == Access::kInOut) updated_.push_back({storage_[i], storage_[i].data()});
    }
    storage_.back().resize(1);
    pointers_.push_back(storage_.back().data());
  }

  ~FlatCall() = default;
  FlatCall(FlatCall&&) noexcept = default;  // pointers_ stay right: the arrays themselves do not move
  FlatCall& operator=(FlatCall&&) noexcept = default;
  FlatCall(const FlatCall&) = delete;
  FlatCall& operator=(const FlatCall&) = delete;

  /// in (signature.input_count()), out (signature.output_count())
  void operator()(const T* in, T* out) {
    load(in);
    call_(pointers_.data());
    store(out);
  }

  /// The same with one array as both arguments of the pair.
  void in_place(const InPlacePair& pair, const T* in, T* out) {
    load(in);
    T* const apart = pointers_[pair.written];
    pointers_[pair.written] = pointers_[pair.read];
    call_(pointers_.data());
    std::copy_n(pointers_[pair.written], storage_[pair.written].size(), apart);
    pointers_[pair.written] = apart;
    store(out);
  }

  /// The timed call, on the inputs loaded last: in-out arrays get their inputs back, nothing else is copied.
  void call_again() {
    for (const auto& array : updated_) std::copy(array.loaded.begin(), array.loaded.end(), array.at);
    call_(pointers_.data());
  }

 private:
  // An in-out array and its input.
  struct Updated {
    std::vector<T> loaded;
    T* at;
  };

  void load(const T* in) {
    auto updated = updated_.begin();
    for (std::size_t i = 0; i < signature_.parameters.size(); ++i) {
      if (!signature_.parameters[i].is_read()) continue;
      std::copy_n(in, storage_[i].size(), storage_[i].data());
      if (signature_.parameters[i].is_written()) (updated++)->loaded = storage_[i];
      in += storage_[i].size();
    }
  }

  void store(T* out) const {
    if (signature_.returns_value) *out++ = storage_.back()[0];
    for (std::size_t i = 0; i < signature_.parameters.size(); ++i) {
      if (!signature_.parameters[i].is_written()) continue;
      out = std::copy_n(storage_[i].data(), storage_[i].size(), out);
    }
  }

  PointerCall<T> call_;
  Signature signature_;
  std::vector<std::vector<T>> storage_;
  std::vector<Updated> updated_;
  std::vector<T*> pointers_;
};

}  // namespace sh::numeric
