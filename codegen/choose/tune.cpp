#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/wisdom.hpp"
#include "codegen/print/files.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kInputs = 64;
constexpr const char* kFlags = " -std=c++17 -O3 -march=native -ffp-contract=fast -w ";

// Runs every timed function in turn, kPasses times, and prints the least time of each in nanoseconds.
constexpr const char* kHarness = R"(
constexpr int kPasses = 15;
constexpr double kPassSeconds = 1e-3;

double seconds(void (*run)(), int repeats) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < repeats; ++i) run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Timed {
  void (*run)();
  double results;  // number of results of one run
  int repeats;
  double least;
};

int main() {
  for (Timed& t : kTimed) {
    while (seconds(t.run, t.repeats) < kPassSeconds) t.repeats *= 2;
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    for (Timed& t : kTimed) t.least = std::min(t.least, seconds(t.run, t.repeats) / t.repeats);
  }
  for (const Timed& t : kTimed) std::printf("%.9g\n", t.least * 1e9 / t.results);
}
)";

constexpr const char* kHead = R"(
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <type_traits>
#if __has_include(<xsimd/xsimd.hpp>)
#include <xsimd/xsimd.hpp>
using Lanes = xsimd::batch<float>;
constexpr int kWidth = Lanes::size;
#else
using Lanes = float;
constexpr int kWidth = 1;
#endif
)";

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "shgen-tune-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error(fs::temp_directory_path().string() +
                               ": expected a folder in which shgen can create another folder");
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string compiler() {
  const char* chosen = std::getenv("CXX");
  return chosen != nullptr && *chosen != '\0' ? chosen : "c++";
}

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

// The first line of what the compiler says of itself.
std::string compiler_version() {
  const TemporaryFolder folder;
  const fs::path version = folder.path() / "version";
  if (std::system((compiler() + " --version >'" + version.string() + "' 2>&1").c_str()) != 0)
    throw std::runtime_error("tune: " + compiler() + " cannot run: expected the name of a C++ compiler in CXX");
  return first_line(version);
}

// A line of the system's description of the processor.
std::string processor(const std::string& key, const std::string& otherwise) {
  std::ifstream processors("/proc/cpuinfo");
  std::string line;
  while (std::getline(processors, line) && line.rfind(key, 0) != 0) continue;
  const std::size_t colon = line.find(": ");
  return colon == std::string::npos ? otherwise : line.substr(colon + 2);
}

// The test inputs of the family, repeated until there are kInputs of them.
std::string input_table(const Family& family, int degree) {
  const std::vector<std::vector<double>> inputs = family.domain.test_inputs(degree);
  std::ostringstream text;
  text << std::hexfloat << "const float kValues[] = {";
  // The inputs are spread over the set, because the set begins with special inputs such as the axes.
  const std::size_t step = std::max<std::size_t>(1, inputs.size() / kInputs);
  for (std::size_t i = 0; i < kInputs; ++i) {
    for (const double value : inputs[i * step % inputs.size()]) text << static_cast<float>(value) << "f, ";
  }
  text << "};\n";
  return text.str();
}

// "call_0<T>(in, out)": one call with arguments from flat arrays. It first copies a result that is updated in place.
std::string call_function(const Kernel& kernel, std::size_t index) {
  std::string copies;
  std::string passed;
  const auto place_of = [&](const std::string& name) {
    const int position = position_of(kernel.results, name);
    const auto first = kernel.results.begin();
    return position < 0 ? -1 : total_size({first, first + position});
  };
  int in = 0;
  for (const Parameter& parameter : kernel.parameters) {
    const std::string from = "in + " + std::to_string(in);
    const int place = place_of(parameter.name);
    if (place >= 0) {
      const std::string to = "out + " + std::to_string(place);
      copies += "  std::copy_n(" + from + ", " + std::to_string(parameter.size()) + ", " + to + ");\n";
      passed += to + ", ";
    } else {
      passed += (parameter.shape.empty() ? "in[" + std::to_string(in) + "]" : from) + ", ";
    }
    in += parameter.size();
  }
  for (const Parameter& result : kernel.results) {
    if (position_of(kernel.parameters, result.name) >= 0 || kernel.returns_scalar()) continue;
    passed += "out + " + std::to_string(place_of(result.name)) + ", ";
  }
  passed.resize(passed.size() - 2);
  return "template <class T> inline void call_" + std::to_string(index) + "(const T* in, T* out) {\n" + copies + "  " +
         (kernel.returns_scalar() ? "*out = " : "") + "sh::" + kernel.name + "(" + passed + ");\n}\n";
}

std::string program(const Family& family, const std::vector<Recipe>& recipes, int degree) {
  std::string functions;
  std::string calls;
  std::string timed;
  std::string table;
  for (std::size_t i = 0; i < recipes.size(); ++i) {
    Kernel kernel = kernel_stages(family, recipes[i], degree).back().kernel;
    kernel.name = "recipe_" + std::to_string(i);
    const std::string n = std::to_string(i);
    functions += print::function(kernel, print::cpp_dialect()) + "\n";
    calls += call_function(kernel, i);
    if (i == 0) {
      const std::string in = std::to_string(total_size(kernel.parameters));
      const std::string out = std::to_string(total_size(kernel.results));
      table = input_table(family, degree) + "constexpr int kIn = " + in + ", kOut = " + out +
              ", kInputs = " + std::to_string(kInputs) + ", kLaneInputs = 4;\n" +
              "alignas(64) float values_in[kInputs * kIn];\nalignas(64) float values_out[kInputs * kOut];\n" +
              "alignas(64) Lanes lanes_in[kLaneInputs * kIn];\nalignas(64) Lanes lanes_out[kLaneInputs * kOut];\n" +
              "const bool kFilled = [] {\n  for (int i = 0; i < kInputs * kIn; ++i) values_in[i] = kValues[i];\n" +
              "  for (int i = 0; i < kLaneInputs * kIn; ++i) lanes_in[i] = Lanes(kValues[i]);\n  return true;\n}();\n" +
              "inline void keep(void* p) { asm volatile(\"\" : : \"r\"(p) : \"memory\"); }\n";
    }
    calls += "void run_" + n + "() {\n  for (int i = 0; i < kInputs; ++i) {\n    call_" + n +
             "(values_in + i * kIn, values_out + i * kOut);\n    keep(values_out);\n  }\n}\n" + "void lanes_" + n +
             "() {\n  for (int i = 0; i < kLaneInputs; ++i) call_" + n +
             "(lanes_in + i * kIn, lanes_out + i * kOut);\n  keep(lanes_out);\n}\n";
    timed += "    {run_" + n + ", kInputs, 1, 1e9},\n    {lanes_" + n + ", double(kLaneInputs) * kWidth, 1, 1e9},\n";
  }
  const std::string harness = kHarness;
  const std::size_t main_function = harness.find("int main");
  return kHead + print::cpp_prelude() + "\nnamespace sh {\n" + functions + "}\n" + table + calls +
         harness.substr(0, main_function) + "Timed kTimed[] = {\n" + timed + "};\n\n" + harness.substr(main_function);
}

}  // namespace

std::string machine_name() {
  const std::string vendor = processor("vendor_id", "");
  const std::string maker = vendor == "AuthenticAMD" ? "amd" : vendor == "GenuineIntel" ? "intel" : "other";
  return maker + (compiler_version().find("clang") == std::string::npos ? "-gcc" : "-clang");
}

std::string describe_machine() {
  return processor("model name", "unknown processor") + "; " + compiler_version() + kFlags;
}

std::vector<Timing> measure_times(const Family& family, const std::vector<Recipe>& recipes, int degree) {
  const TemporaryFolder folder;
  const std::string base = (folder.path() / "tune").string();
  std::ofstream(base + ".cpp") << program(family, recipes, degree);
  const auto run = [](const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  if (run(compiler() + kFlags + "-o '" + base + "' '" + base + ".cpp' 2>'" + base + ".log'") != 0)
    throw std::runtime_error("tune: " + compiler() + " does not compile " + family.name + " at degree " +
                             std::to_string(degree) + ": " + first_line(base + ".log"));
  if (run("'" + base + "' >'" + base + ".out'") != 0)
    throw std::runtime_error("tune: the measurement of " + family.name + " at degree " + std::to_string(degree) +
                             " did not finish");
  std::ifstream results(base + ".out");
  std::vector<Timing> timings(recipes.size());
  for (Timing& timing : timings) results >> timing.call >> timing.lane;
  return timings;
}

}  // namespace sh::codegen
