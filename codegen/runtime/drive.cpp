// Runs kernels of whole blocks over any layout: hands them the caller's blocks where those serve, copies where not.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#include "drive.hpp"

#include <cstddef>
#include <cstdint>

#include "layout.hpp"
#include "sizes.hpp"

namespace sh::batch::SH_BATCH_ISA {
namespace {

constexpr std::size_t kSegmentBlocks = 64;  // added up in lanes before they go to the total

// Whether a kernel can work on the array itself; records of one value are blocked as they are.
bool direct(const void* data, Layout layout, std::size_t size) {
  const bool blocks = layout == Layout::kBlocked || (layout == Layout::kPlain && size == 1);
  return blocks && reinterpret_cast<std::uintptr_t>(data) % detail::kLine == 0;
}

// The sum of the lanes of a value, in double: both halves are added until one number is left.
double sum_of_lanes(const float* lanes) {
  using FourDoubles = double __attribute__((vector_size(32)));
  FourDoubles four[4];
  for (std::size_t i = 0; i < 4; ++i) four[i] = __builtin_convertvector(load(lanes + 4 * i), FourDoubles);
  const FourDoubles sum = (four[0] + four[2]) + (four[1] + four[3]);
  return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}
double sum_of_lanes(const double* lanes) {
  const double even = (lanes[0] + lanes[4]) + (lanes[2] + lanes[6]);
  const double odd = (lanes[1] + lanes[5]) + (lanes[3] + lanes[7]);
  return even + odd;
}

// Whether kernels of few records take all arrays as they are.
template <class T>
bool are_in_rows(const detail::Call<T>& call, const Plan<T>& plan) {
  return (call.in[0].layout == Layout::kPlain || call.in[0].layout == Layout::kShared) &&
         call.out.layout == Layout::kPlain && (plan.shared == 1 || call.in[1].layout == Layout::kPlain);
}

// The most records for those.
template <class T>
std::size_t most_few(const detail::Call<T>& call, const Plan<T>& plan) {
  if (plan.single == nullptr || call.half != nullptr) return 0;
  return are_in_rows(call, plan) ? plan.single->most : plan.most_copied;
}

// Where values of a record of a channel stand in an array: the first, and from one to the next.
struct Places {
  std::size_t first;
  std::size_t step;
};
template <class T>
Places places_of(Layout layout, std::size_t size, std::size_t i, std::size_t channel) {
  if (layout == Layout::kShared) return {0, 1};
  if (layout == Layout::kInterleaved) return {i * size * 3 + channel, 3};
  if (layout == Layout::kBlocked) return {i / kBlock<T> * size * kBlock<T> + i % kBlock<T>, kBlock<T>};
  return {i * size, 1};
}

// Calls copy(at, size) for the values that a row takes of record i: those of one channel of `channels` that a kernel takes one
// after the other, or all, channel by channel.
template <class T, class Copy>
void for_every_part(Layout layout, std::size_t size, std::size_t i, std::size_t channel, std::size_t channels,
                    const Copy& copy) {
  if (layout != Layout::kInterleaved || channels > 1) return copy(places_of<T>(layout, size, i, channel), size);
  for (std::size_t c = 0; c < 3; ++c) copy(places_of<T>(layout, size / 3, i, c), size / 3);
}

// `count` records from `first` on; those of other layouts are copied to rows and back, a few at a time.
template <class T>
void run_few(const detail::Call<T>& call, const Plan<T>& plan, std::size_t first, std::size_t count) {
  const bool is_shared = call.in[0].layout == Layout::kShared;
  if (are_in_rows(call, plan)) {
    return plan.single->run(call.in[0].data + (is_shared ? 0 : first * plan.in[0]), is_shared,
                            call.in[1].data + (plan.shared == 1 ? 0 : first * plan.in[1]), count,
                            call.out.data + first * plan.out);
  }
  constexpr std::size_t kRoom = detail::kRoomLines * kBlock<T>;  // values: more than a block takes and gives
  T room[kRoom];
  const std::size_t chunk = kRoom / ((plan.in[0] + plan.in[1] + plan.out) * call.channels);
  for (const std::size_t end = first + count; first < end; first += chunk) {
    const std::size_t last = end - first < chunk ? end : first + chunk;
    const T* in[2];
    T* free = room;
    for (int j = 0; j < 2; ++j) {
      const bool is_there = j == plan.shared || (j == 0 && is_shared);
      in[j] = is_there ? call.in[j].data : free;
      for (std::size_t i = first; !is_there && i < last; ++i) {
        for (std::size_t c = 0; c < call.channels; ++c) {
          for_every_part<T>(call.in[j].layout, plan.in[j], i, c, call.channels, [&](Places at, std::size_t size) {
            for (std::size_t k = 0; k < size; ++k) *free++ = call.in[j].data[at.first + k * at.step];
          });
        }
      }
    }
    if (plan.sums) return plan.single->run(in[0], is_shared, in[1], count, call.out.data);
    plan.single->run(in[0], is_shared, in[1], (last - first) * call.channels, free);
    const T* row = free;
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t c = 0; c < call.channels; ++c) {
        for_every_part<T>(call.out.layout, plan.out, i, c, call.channels, [&](Places at, std::size_t size) {
          for (std::size_t k = 0; k < size; ++k) call.out.data[at.first + k * at.step] = *row++;
        });
      }
    }
  }
}

template <class T>
class Driver {
 public:
  Driver(const detail::Call<T>& call, const Plan<T>& plan) : call_(call), plan_(plan) {
    for (int j = 0; j < plan.inputs; ++j) take_input(j);
    direct_out_ =
        (takes_records() || direct(call.out.data, call.out.layout, plan.out)) && (!call.stream || takes_halves());
  }

  void run() {
    if (plan_.sums) return sum();
    const std::size_t whole = call_.n / kBlock<T>;
    const std::size_t chunk = chunk_blocks(direct_out_ ? 0 : size_out(), whole);
    for (std::size_t first = 0; first < whole; first += chunk) {
      step(first * kBlock<T>, whole - first < chunk ? whole - first : chunk, kBlock<T>);
    }
    if (const std::size_t rest = call_.n % kBlock<T>; rest > 0) finish(whole, rest);
    if (call_.stream) finish_stream();
  }

 private:
  // The records after the last whole block. A block that ends with the last record is faster than part of a block; it
  // computes some records twice, from inputs that must still be there.
  void finish(std::size_t whole, std::size_t rest) {
    if (rest <= most_few(call_, plan_)) return run_few(call_, plan_, whole * kBlock<T>, rest);
    for (int j = 0; j < plan_.inputs; ++j) direct_in_[j] = direct_in_[j] && call_.in[j].layout == Layout::kShared;
    direct_out_ = false;
    if (whole > 0 && may_overlap()) return step(call_.n - kBlock<T>, 1, kBlock<T>);
    step(whole * kBlock<T>, 1, rest);
  }

  bool may_overlap() const {
    bool plain = call_.out.layout != Layout::kBlocked;
    for (int j = 0; j < plan_.inputs; ++j) {
      plain = plain && call_.in[j].layout != Layout::kBlocked && call_.in[j].data != call_.out.data;
    }
    return plain;
  }

  bool is_half(int j) const { return j == 0 && call_.half != nullptr; }

  // Whether a kernel takes whole blocks of input 0 record by record, and writes records.
  bool takes_records() const {
    return records_kernel() != nullptr && call_.in[0].layout == Layout::kPlain && call_.out.layout == Layout::kPlain;
  }
  BlockKernel<T> records_kernel() const {
    return call_.half == nullptr ? plan_.kernel_records : plan_.kernel_records_half;
  }

  // Whether a kernel takes whole blocks of input 0 in half precision. It fetches its outputs ahead, which hides them
  // behind its arithmetic; stores past the cache would hold up those of the next block.
  bool takes_halves() const { return is_half(0) && direct_in_[0] && call_.in[0].layout != Layout::kShared; }

  T* take_room(std::size_t values) {
    T* room = room_;
    room_ += values * kBlock<T>;
    return room;
  }

  // Shared inputs are prepared if there is a kernel for that, and spread over a block; one that is always shared is not.
  void take_input(int j) {
    const Records<const T>& in = call_.in[j];
    const bool halves = is_half(j);
    direct_in_[j] = in.layout == Layout::kShared ||
                    (halves ? plan_.kernel_half != nullptr && direct(call_.half, in.layout, plan_.in[j])
                            : direct(in.data, in.layout, plan_.in[j]));
    if (in.layout != Layout::kShared) return;
    if (j == plan_.shared) {
      blocks_.in[j] = in.data;
      return;
    }
    const T* record = in.data;
    std::size_t size = plan_.in[j];
    if (halves) {
      T* wide = take_room(size);
      widen(call_.half, size, wide);
      record = wide;
    }
    if (j == 0 && plan_.prepare != nullptr) {
      size = plan_.prepared;
      T* prepared = take_room(size);
      plan_.prepare(call_.degree, record, prepared);
      record = prepared;
      kernel_ = plan_.kernel_prepared;
    }
    T* room = take_room(size);
    for (std::size_t k = 0; k < size * kBlock<T>; k += Lanes<T>::kWidth) {
      *reinterpret_cast<Lanes<T>*>(room + k) = Lanes<T>(record[k / kBlock<T>]);
    }
    blocks_.in[j] = room;
  }

  // Values of a record in an array: those of all channels that it interleaves.
  std::size_t size_of(Layout layout, std::size_t size) const {
    return layout == Layout::kInterleaved ? call_.channels * size : size;
  }
  std::size_t size_in(int j) const { return size_of(call_.in[j].layout, plan_.in[j]); }
  std::size_t size_out() const { return size_of(call_.out.layout, plan_.out); }

  // Blocks that are copied at a time; out: values of an output record that is copied.
  std::size_t chunk_blocks(std::size_t out, std::size_t whole) const {
    std::size_t copied = out;
    for (int j = 0; j < plan_.inputs; ++j) {
      copied += direct_in_[j] || (j == 0 && takes_records()) ? 0 : size_in(j);
    }
    const std::size_t blocks = copied == 0 ? whole : detail::kChunkLines / copied;
    return blocks > 0 ? blocks : 1;
  }

  // Points the kernel at the inputs of `count` blocks from record `first`; `lanes` of each are in use (fewer than kBlock
  // in the last one only). Returns the room that is left.
  T* set_inputs(std::size_t first, std::size_t count, std::size_t lanes) {
    T* room = room_;
    blocks_.count = count;
    blocks_.lanes = plan_.sums ? kBlock<T> : lanes;
    for (int j = 0; j < plan_.inputs; ++j) {
      const bool shared = call_.in[j].layout == Layout::kShared;
      if (shared && (lanes == kBlock<T> || !plan_.sums)) continue;  // in a sum, lanes that are not in use have to be 0
      const std::size_t size = size_in(j);
      const std::size_t block = size * kBlock<T>;
      blocks_.step[j] = shared ? 0 : block;
      if (is_half(j) && !shared) {
        if (takes_halves() && lanes == kBlock<T>) {
          blocks_.in[j] = reinterpret_cast<const T*>(call_.half + first * size);
          blocks_.step[j] = block / 2;
          continue;
        }
        if (takes_records() && lanes == kBlock<T>) {
          blocks_.in[j] = reinterpret_cast<const T*>(call_.half + first * size);
          continue;
        }
        fetch_halves(first * size, count, lanes, room);
      } else {
        const T* from = shared ? blocks_.in[j] : call_.in[j].data + first * size;
        blocks_.in[j] = from;
        if ((direct_in_[j] || (j == 0 && takes_records())) && lanes == kBlock<T>) continue;
        // A shared record has been spread over a block.
        fetch(shared ? Layout::kBlocked : call_.in[j].layout, size, from, count, lanes, room);
      }
      blocks_.in[j] = room;
      room += count * block;
    }
    return room;
  }

  // Input 0 from half precision; a block at a time is widened behind the room that it will take.
  void fetch_halves(std::size_t start, std::size_t count, std::size_t lanes, T* to) const {
    const std::size_t size = size_in(0);
    const bool plain = call_.in[0].layout != Layout::kBlocked;
    if (!plain && lanes == kBlock<T>) return widen(call_.half + start, count * size * kBlock<T>, to);
    T* wide = to + count * size * kBlock<T>;
    for (std::size_t b = 0; b < count; ++b) {
      const std::size_t block = b * size * kBlock<T>;
      widen(call_.half + start + block, plain ? lanes * size : (size - 1) * kBlock<T> + lanes, wide);
      fetch(call_.in[0].layout, size, wide, 1, lanes, to + block);
    }
  }

  // The hardware's prefetching misses records that are read side by side, where they are not in a cache.
  void prefetch(const T* block, std::size_t size) const {
    constexpr std::size_t kLinesAhead = 128;
    constexpr std::size_t kNear = 8192;  // lines in the second cache
    if (call_.n / kBlock<T> * size < kNear) return;
    for (std::size_t k = 0; k < size; ++k) __builtin_prefetch(block + (kLinesAhead + k) * kBlock<T>);
  }

  void fetch(Layout layout, std::size_t size, const T* from, std::size_t count, std::size_t lanes, T* to) const {
    for (std::size_t b = 0; b < count; ++b, from += size * kBlock<T>, to += size * kBlock<T>) {
      if (layout == Layout::kBlocked) {
        copy_lanes_and_zeros(from, lanes, size, to);
        continue;
      }
      prefetch(from, size);
      if (layout == Layout::kInterleaved) {
        to_block(from, lanes, size, to, ByChannel{size / 3});
      } else {
        to_block(from, lanes, size, to);
      }
    }
  }

  void step(std::size_t first, std::size_t count, std::size_t lanes) {
    T* room = set_inputs(first, count, lanes);
    const std::size_t block = size_out() * kBlock<T>;
    T* out = call_.out.data + first * size_out();
    blocks_.out_step = block;
    blocks_.out = direct_out_ ? out : room;
    const bool halves = takes_halves() && lanes == kBlock<T>;
    const bool records = takes_records() && lanes == kBlock<T>;
    run_channels(halves ? plan_.kernel_half : records ? records_kernel() : kernel_);
    if (direct_out_) return;
    if (records) return copy(blocks_.out, count * block, call_.stream, out);
    deliver(count, lanes, room + count * block, out);
  }

  // The channels of interleaved arrays stand one after the other in a block; other inputs serve them all.
  void run_channels(BlockKernel<T> kernel) {
    kernel(blocks_);
    if (call_.channels == 1) return;
    Blocks<T> channel = blocks_;
    for (std::size_t c = 1; c < call_.channels; ++c) {
      for (int j = 0; j < plan_.inputs; ++j) {
        if (call_.in[j].layout == Layout::kInterleaved) channel.in[j] += plan_.in[j] * kBlock<T>;
      }
      channel.out += plan_.out * kBlock<T>;
      kernel(channel);
    }
  }

  // spare: room for as many records as were computed.
  void deliver(std::size_t count, std::size_t lanes, T* spare, T* to) const {
    const std::size_t size = size_out();
    const bool plain = call_.out.layout != Layout::kBlocked;
    if (!plain && lanes == kBlock<T>) return copy(blocks_.out, count * size * kBlock<T>, call_.stream, to);
    if (!plain) return copy_lanes(blocks_.out, lanes, size, to);
    constexpr std::size_t kFew = 2;  // records, which are written one by one
    const bool by_way_of_spare = call_.stream || (lanes < kBlock<T> && lanes % kTaken<T> > kFew);
    T* records = by_way_of_spare ? spare : to;
    const std::size_t written = by_way_of_spare ? kBlock<T> : lanes;
    for (std::size_t b = 0; b < count; ++b) {
      const T* const block = blocks_.out + b * size * kBlock<T>;
      T* const record = records + b * size * kBlock<T>;
      if (call_.out.layout == Layout::kInterleaved) {
        to_records(block, written, size, record, ByChannel{size / 3});
      } else {
        to_records(block, written, size, record);
      }
    }
    if (by_way_of_spare) copy(spare, ((count - 1) * kBlock<T> + lanes) * size, call_.stream, to);
  }

  // Lanes are added up over segments of fixed length, segments in double: the same sum for every layout.
  void sum() {
    T* lanes = take_room(plan_.out);
    double totals[detail::kMostSums];
    for (std::size_t k = 0; k < plan_.out; ++k) totals[k] = 0;
    const std::size_t whole = call_.n / kBlock<T>;
    const std::size_t rest = call_.n % kBlock<T>;
    const std::size_t chunk = chunk_blocks(0, whole);
    blocks_.out = lanes;
    for (std::size_t start = 0; start * kBlock<T> < call_.n; start += kSegmentBlocks) {
      for (std::size_t k = 0; k < plan_.out * kBlock<T>; ++k) lanes[k] = T(0);
      const std::size_t end = whole - start < kSegmentBlocks ? whole : start + kSegmentBlocks;
      for (std::size_t first = start; first < end; first += chunk) {
        set_inputs(first * kBlock<T>, end - first < chunk ? end - first : chunk, kBlock<T>);
        kernel_(blocks_);
      }
      if (end == whole && rest > 0 && end - start < kSegmentBlocks) {
        set_inputs(whole * kBlock<T>, 1, rest);
        kernel_(blocks_);
      }
      for (std::size_t k = 0; k < plan_.out; ++k) totals[k] += sum_of_lanes(lanes + k * kBlock<T>);
    }
    double finished[detail::kMostSums];
    if (plan_.finish != nullptr) plan_.finish(call_.degree, totals, finished);
    const double* sums = plan_.finish != nullptr ? finished : totals;
    for (std::size_t k = 0; k < plan_.out; ++k) call_.out.data[k] += T(sums[k]);
  }

  const detail::Call<T>& call_;
  const Plan<T>& plan_;
  BlockKernel<T> kernel_ = plan_.kernel;
  Blocks<T> blocks_;
  bool direct_in_[detail::kMostInputs] = {};
  bool direct_out_ = false;
  alignas(detail::kLine) T memory_[detail::kRoomLines * kBlock<T>];
  T* room_ = memory_;
};

// The kernel that takes all records as they are, plain or with an interleaved input 0; null: none.
template <class T>
detail::RecordKernel<T> record_kernel(const detail::Call<T>& call, const Plan<T>& plan) {
  bool plain = call.out.layout == Layout::kPlain && call.half == nullptr && !call.stream;
  for (int j = 1; j < plan.inputs; ++j) plain = plain && call.in[j].layout == Layout::kPlain;
  if (plain && call.in[0].layout == Layout::kPlain) return plan.kernel_plain;
  return plain && call.in[0].layout == Layout::kInterleaved ? plan.kernel_interleaved : nullptr;
}

// Whether channels of interleaved records go through registers together.
template <class T>
bool takes_colors(const detail::Call<T>& call, const Plan<T>& plan) {
  return plan.single != nullptr && plan.single->colors != nullptr && !call.stream &&
         call.in[0].layout == Layout::kShared && call.in[1].layout == Layout::kInterleaved &&
         call.out.layout == Layout::kInterleaved;
}

// Whether all records stand in whole blocks that a kernel can work on, but for an input that is always shared.
template <class T>
bool is_direct(const detail::Call<T>& call, const Plan<T>& plan) {
  bool blocks = call.n % kBlock<T> == 0 && call.half == nullptr && direct(call.out.data, call.out.layout, plan.out);
  for (int j = 0; j < plan.inputs; ++j) {
    blocks = blocks && (j == plan.shared || direct(call.in[j].data, call.in[j].layout, plan.in[j]));
  }
  return blocks;
}

template <class T>
void run_blocks(const detail::Call<T>& call, const Plan<T>& plan) {
  Blocks<T> blocks;
  for (int j = 0; j < plan.inputs; ++j) {
    blocks.in[j] = call.in[j].data;
    blocks.step[j] = j == plan.shared ? 0 : plan.in[j] * kBlock<T>;
  }
  blocks.out = call.out.data;
  blocks.out_step = plan.out * kBlock<T>;
  blocks.count = call.n / kBlock<T>;
  plan.kernel(blocks);
}

}  // namespace

template <class T>
void drive(const detail::Call<T>& call, const Plan<T>& plan) {
  if (const auto kernel = record_kernel(call, plan))
    return kernel(call.in[0].data, call.in[1].data, call.n, call.out.data);
  if (takes_colors(call, plan)) return plan.single->colors(call.in[0].data, call.in[1].data, call.n, call.out.data);
  if (!call.stream && call.n <= most_few(call, plan)) return run_few(call, plan, 0, call.n);
  if (!call.stream && !plan.sums && is_direct(call, plan)) return run_blocks(call, plan);
  Driver<T>(call, plan).run();
}
template void drive(const detail::Call<float>&, const Plan<float>&);
template void drive(const detail::Call<double>&, const Plan<double>&);

}  // namespace sh::batch::SH_BATCH_ISA
