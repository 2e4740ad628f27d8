// The committed inputs of the fuzzers, run by the same functions, in every build. A broken promise aborts the test.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/fuzz/entry.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::fuzz {
namespace {

struct Target {
  const char* name;
  void (*run)(std::string_view bytes);
};

class Fuzz : public testing::TestWithParam<Target> {};

// Also every start of each input, in at most 16 steps.
TEST_P(Fuzz, TakesTheCommittedInputsAndTheirStarts) {
  const std::filesystem::path folder = std::filesystem::path(SHFORGE_SOURCE_DIR) / "tests/data/fuzz" / GetParam().name;
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  ASSERT_GE(files.size(), 2U);
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const std::string bytes = prt::test::read_all(file);
    GetParam().run(bytes);
    const std::size_t step = bytes.size() / 16 + 1;
    for (std::size_t size = 0; size < bytes.size(); size += step)
      GetParam().run(std::string_view(bytes).substr(0, size));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Fuzz,
                         testing::Values(Target{"transfer", run_transfer}, Target{"checkpoint", run_checkpoint},
                                         Target{"scene", run_scene}, Target{"stage", run_stage},
                                         Target{"parts", run_parts}, Target{"plan", run_plan},
                                         Target{"table", run_table}, Target{"identify", run_identify},
                                         Target{"image", run_image}, Target{"light", run_light},
                                         Target{"report", run_report}, Target{"splats", run_splats},
                                         Target{"density", run_density}, Target{"command", run_command}),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace sh::fuzz
