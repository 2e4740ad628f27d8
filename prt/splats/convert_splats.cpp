#include "prt/splats/convert_splats.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/progress.hpp"
#include "prt/binary/input_file.hpp"
#include "prt/chunks.hpp"
#include "prt/splats/splat_axes.hpp"

namespace sh::prt {
namespace {

/// make(block) -> result on all threads, take(result) in the order of the blocks.
template <class Result>
void pipe_blocks(const SplatReader& reader, const std::string& what, const std::function<Result(SplatBlock&)>& make,
                 const std::function<void(Result&)>& take) {
  const std::size_t blocks = (reader.count() + kSplatsPerBlock - 1) / kSplatsPerBlock;
  output::Progress progress(what, blocks);
  std::size_t next = 0;
  const auto number = [&](tbb::flow_control& control) {
    if (next == blocks) control.stop();
    return next++;
  };
  tbb::enumerable_thread_specific<SplatBlock> blocks_in_use;  // so that each thread allocates once
  // At most so many blocks are on their way. They end in order, so a block's place is free when the next one takes it.
  const auto tokens = static_cast<std::size_t>(2 * thread_count(0));
  std::vector<std::optional<Result>> results(tokens);
  const auto work = [&](std::size_t block_number) {
    SplatBlock& block = blocks_in_use.local();
    const std::size_t first = block_number * kSplatsPerBlock;
    reader.read(first, std::min(kSplatsPerBlock, reader.count() - first), block);
    results[block_number % tokens].emplace(make(block));
    return block_number;
  };
  const auto finish = [&](std::size_t block_number) {
    std::optional<Result>& result = results[block_number % tokens];
    take(*result);
    result.reset();
    progress.advance();
  };
  tbb::parallel_pipeline(tokens, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, number) &
                                     tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, work) &
                                     tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, finish));
}

/// What becomes of every block.
class Editor {
 public:
  Editor(const SplatReader& reader, const SplatEdit& edit, const SplatFormat& from, const SplatFormat& to)
      : reader_(reader), edit_(edit), degree_(edit.degree.value_or(reader.degree())) {
    const std::string in(edit.axes_in.empty() ? from.axes : edit.axes_in);
    const std::string out(edit.axes_out.empty() ? to.axes : edit.axes_out);
    const bool keeps_axes = &from == &to && edit.axes_out.empty();
    asked_ = Similarity{between_axes(in, keeps_axes ? in : out)}.after(edit.similarity);
    whole_ = asked_.after(reader.placement());
  }

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] SplatParts changes() const { return whole_.changes(); }
  [[nodiscard]] bool may_drop() const { return edit_.crop.has_value() || edit_.flaws.drop; }
  /// Nothing is asked; a placement that the file states stays in it.
  [[nodiscard]] bool is_idle() const {
    return asked_.is_identity() && degree_ == reader_.degree() && !may_drop() && !edit_.spz.any();
  }

  void edit(SplatBlock& block, FlawCounts& counts, std::atomic<std::size_t>& cropped) const {
    select(block, counts, cropped);
    transform(whole_, block);
    change_degree(degree_, block);
    if (!whole_.is_identity()) require_finite_splats(reader_, block);
  }

  /// Positions alone.
  void place(SplatBlock& block, FlawCounts& counts, std::atomic<std::size_t>& cropped) const {
    select(block, counts, cropped);
    transform_positions(whole_, block);
  }

 private:
  void select(SplatBlock& block, FlawCounts& counts, std::atomic<std::size_t>& cropped) const {
    mend_splats(reader_, edit_.flaws, block, counts);
    if (!edit_.crop) return;
    const std::size_t before = block.count;
    crop(*edit_.crop, reader_.placement(), block);
    cropped += before - block.count;
  }

  const SplatReader& reader_;
  const SplatEdit& edit_;
  int degree_;
  Similarity asked_;  // edit, then axes
  Similarity whole_;  // after the placement in the file
};

struct Survey {
  SplatSummary summary;
  FlawCounts counts;
  std::atomic<std::size_t> cropped{0};
};

/// A first pass, for the count of the splats that remain and the box of their positions.
void survey(const SplatReader& reader, const Editor& editor, Survey& result) {
  result.summary = {};
  pipe_blocks<SplatSummary>(
      reader, fmt::format("checking {}", reader.file()),
      [&](SplatBlock& block) {
        editor.place(block, result.counts, result.cropped);
        SplatSummary summary{block.count, {}};
        for (std::size_t i = 0; i < block.count; ++i) {
          summary.box.extend(Eigen::Map<const Eigen::Vector3f>(&block.position[3 * i]));
        }
        return summary;
      },
      [&](SplatSummary& summary) {
        result.summary.count += summary.count;
        result.summary.box.extend(summary.box);
      });
}

void copy_file(const std::string& from, const std::string& to) {
  const InputFile input(from);
  output::AtomicFile file(to);
  constexpr std::uint64_t kPart = std::uint64_t{1} << 22U;
  std::string bytes;
  for (std::uint64_t offset = 0; offset < input.size(); offset += kPart) {
    output::check_interrupt();
    bytes.resize(static_cast<std::size_t>(std::min(kPart, input.size() - offset)));
    input.read(offset, bytes.data(), bytes.size());
    file.write(bytes.data(), bytes.size());
  }
  file.commit();
}

}  // namespace

SplatResult convert_splats(const std::string& input, const std::string& output, const SplatEdit& edit) {
  const SplatFormat& from = splat_format_of(input);
  const SplatFormat& to = splat_format_named(output);
  const std::unique_ptr<SplatReader> reader = from.read(input);
  const Editor editor(*reader, edit, from, to);
  const bool is_copy = &from == &to && editor.is_idle();
  Survey first;
  first.summary.count = reader->count();
  if (is_copy || to.needs_box || editor.may_drop()) survey(*reader, editor, first);
  SplatResult result;
  result.count = first.summary.count;
  result.degree = editor.degree();
  result.is_copy = is_copy;
  FlawCounts counts;
  std::atomic<std::size_t> cropped{0};
  if (is_copy) {
    copy_file(input, output);
  } else {
    const std::unique_ptr<SplatWriter> writer =
        to.write({output, editor.degree(), first.summary, editor.changes(), reader.get(), edit.spz});
    pipe_blocks<SplatPieces>(
        *reader, fmt::format("writing {}", output),
        [&](SplatBlock& block) {
          editor.edit(block, counts, cropped);
          return writer->encode(block);
        },
        [&](SplatPieces& pieces) { writer->append(pieces); });
    writer->finish();
    result.losses = writer->losses();
    if (reader->ply() == nullptr || &from != &to) result.left_out = reader->extras();
  }
  const FlawCounts& seen = is_copy ? first.counts : counts;
  result.dropped = seen.dropped;
  result.mended = seen.mended;
  result.cropped = cropped;
  return result;
}

void for_splats(const SplatReader& reader, const FlawChoice& flaws, FlawCounts& counts,
                const std::function<void(const SplatBlock&)>& each) {
  pipe_blocks<SplatBlock>(
      reader, fmt::format("reading {}", reader.file()),
      [&](SplatBlock& block) {
        mend_splats(reader, flaws, block, counts);
        return std::move(block);
      },
      [&](SplatBlock& block) { each(block); });
}

}  // namespace sh::prt
