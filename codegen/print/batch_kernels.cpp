#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "codegen/ir/cost.hpp"
#include "codegen/print/batch_driver.hpp"
#include "codegen/print/dialect.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::codegen::print {
namespace {

enum class Loop { kPlain, kFixed, kHalf };

// The loop over registers that runs a kernel: its name and template arguments.
std::string loop_of(const RecordSignature& s, Loop loop) {
  const std::string count = "(Degree + 1) * (Degree + 1)";
  const std::string inputs = std::to_string(s.inputs.size());
  if (loop == Loop::kFixed) return "for_every_register_fixed<" + inputs + ", " + count + ">";
  if (loop == Loop::kHalf) return "for_every_register_half<" + inputs + ", Size>";
  return s.sums ? "sum_every_register<" + inputs + ", " + count + ">" : "for_every_register<" + inputs + ">";
}

// The template arguments of scalar products: rows of a record, sums, values of a row.
std::string scalar_products(const Kernel& kernel) {
  const int length = numeric::coefficient_count(kernel.degree);
  const RecordSignature s = signature_of(kernel);
  return filled("$rows, $sums, $length", {{"rows", std::to_string(s.inputs[0].size / length)},
                                          {"sums", std::to_string(s.inputs[1].size / length)},
                                          {"length", std::to_string(length)}});
}

// The kernels of scalar products that take plain records, of float and of halves; empty if there are none.
std::string records_kernel(const Driver& driver, const Kernel& kernel) {
  constexpr int kLeast = 4;  // values of a row that multiply_records takes
  if (!driver.spec.scalar_products || numeric::coefficient_count(kernel.degree) < kLeast) return {};
  const std::string products = scalar_products(kernel);
  return "float_only<T>(multiply_records<" + products + ", float>), float_only<T>(multiply_records<" + products +
         ", Half>)";
}

// The place of the input that serves all records; -1: there is none.
int shared_input(const RecordSignature& s) {
  const auto found = std::find_if(s.inputs.begin(), s.inputs.end(), [](const Record& r) { return r.shared; });
  return found == s.inputs.end() ? -1 : static_cast<int>(found - s.inputs.begin());
}

// A statement of a kernel, or stages on rings where a degree has them.
std::string in_stages(const Kernel& kernel, Loop loop, const std::string& statement) {
  const int channels = signature_of(kernel).out_size / numeric::coefficient_count(kernel.degree);
  const bool half = loop == Loop::kHalf;
  std::string indented;
  for (std::size_t at = 0, end = 0; at < statement.size(); at = end) {
    end = statement.find('\n', at) + 1;
    indented += "  " + statement.substr(at, end - at);
  }
  return filled(R"(  if constexpr (kInStages<Degree, $type>) {
    apply_on_rings<Degree, $channels, $scalar>(blocks);
  } else {
$statement  }
)",
                {{"type", half ? "float" : "T"},
                 {"channels", std::to_string(channels)},
                 {"scalar", half ? "Half" : "T"},
                 {"statement", indented}});
}

// Whether a kernel stores more than it loads, but for its constants.
bool stores_most(const Kernel& kernel) {
  const RecordSignature s = signature_of(kernel);
  int loaded = 0;
  for (const Record& record : s.inputs) loaded += record.size;
  return !s.sums && s.out_size > loaded;
}

// The last degree whose constants and values fit in the registers of AVX-512.
int last_in_registers(const Driver& driver) {
  constexpr int kRegisters = 32;
  int last = -1;
  for (const FinishedKernel& finished : driver.kernels) {
    const Kernel& kernel = finished.kernel;
    const std::vector<bool> live = live_nodes(kernel);
    int constants = 0;
    for (NodeId id = 0; id < kernel.size(); ++id) constants += live[id] && kernel.node(id).op == Op::kConstant ? 1 : 0;
    if (constants + cost(kernel).max_live > kRegisters) break;
    last = kernel.degree;
  }
  return last;
}

// The kernel of blocks that stores more than it loads, but for its constants: two loops, one of which gets those without
// loads.
std::string storing_kernel(const Driver& driver) {
  const Kernel& kernel = driver.last();
  return filled(R"(template <int Degree, class T>
[[gnu::flatten]] void kernel(const Blocks<T>& blocks) {
  const auto compute = [](const auto* const* in, auto* out) {
    $call
  };
#if defined(SH_BATCH_BROADCASTS)
  constexpr int kLastInRegisters = $last;  // degree
  constexpr Constants kWithoutLoads = Degree <= kLastInRegisters ? Constants::kRegisters : Constants::kInstructions;
  if (detail::loads_delay_stores) return for_every_register<$inputs, kWithoutLoads>(blocks, compute);
#endif
  for_every_register<$inputs>(blocks, compute);
}

)",
                {{"inputs", std::to_string(signature_of(kernel).inputs.size())},
                 {"call", call_of(kernel)},
                 {"last", std::to_string(last_in_registers(driver))}});
}

std::string block_kernel(const std::string& name, const Kernel& kernel, Loop loop = Loop::kPlain,
                         bool has_stages = false) {
  const bool is_float = loop == Loop::kHalf;
  const std::string statement = filled(R"(  $loop(blocks, [$capture](const Lanes<$t>* const* in, Lanes<$t>* out) {
    $call
  });
)",
                                       {{"capture", shared_input(signature_of(kernel)) < 0 ? "" : "&blocks"},
                                        {"t", is_float ? "float" : "T"},
                                        {"loop", loop_of(signature_of(kernel), loop)},
                                        {"call", call_of(kernel)}});
  return filled(R"(template <int Degree$class_t>
[[gnu::flatten]] void $name(const Blocks<$t>& blocks) {
$body}

)",
                {{"class_t", is_float ? ", int Size" : ", class T"},
                 {"name", name},
                 {"t", is_float ? "float" : "T"},
                 {"body", has_stages ? in_stages(kernel, loop, statement) : statement}});
}

// Whether input 0 holds the coefficients of three channels.
bool has_colors(const Kernel& kernel) { return are_coefficients(signature_of(kernel).inputs[0].size, kernel, 3); }

// Whether something that is no function, such as a matrix, maps coefficients to coefficients: often the same for many.
bool turns_colors(const Kernel& kernel) {
  const RecordSignature s = signature_of(kernel);
  return s.inputs.size() == 2 && !are_coefficients(s.inputs[0].size, kernel, 1) &&
         are_coefficients(s.inputs[1].size, kernel, 1) && are_coefficients(s.out_size, kernel, 1);
}

// The places that the functions of records fill in.
std::map<std::string, std::string> parts_of_records(const Kernel& kernel) {
  const RecordSignature s = signature_of(kernel);
  std::string inputs, further, sum;
  for (std::size_t j = 0; j < s.inputs.size(); ++j) {
    const std::string size = size_in_degree(s.inputs[j].size, kernel);
    inputs += j == 0 ? "first.at(i)" : ", reinterpret_cast<const One<T>*>(b) + i * " + size;
    if (j > 0) further += ", " + size;
    if (j > 0) sum += " + " + size;
  }
  const std::string first = size_in_degree(s.inputs[0].size, kernel);
  return {{"inputs", inputs},
          {"first", first},
          {"further", further},
          {"in", "kStep<Rows, " + first + ">" + sum},
          {"b", s.inputs.size() > 1 ? "b" : "/*b*/"},
          {"size", size_in_degree(s.out_size, kernel)},
          {"call", call_of(kernel)}};
}

// Kernels of records in rows, one by one and by groups, and the choice between them.
std::string record_kernels(const Kernel& kernel) {
  return filled(R"(template <int Degree, class T, class Rows = InOrder>
[[gnu::flatten, gnu::noinline]] void one_by_one(const T* a, const T* $b, std::size_t n, T* to) {
  RecordInputs<$first, T, Rows> first(a);
  for (std::size_t i = 0; i < n; ++i) {
    const One<T>* const in[] = {$inputs};
    RecordValues<$size, $in, T> record(to + i * $size);
    One<T>* const out = record.values();
    $call
    record.keep();
  }
}

template <int Degree, class T, class Rows = InOrder>
[[gnu::flatten]] void in_groups(const T* a, const T* b, std::size_t count, T* to) {
  for_every_group<T, Rows, $size, $first$further>(a, b, count, to, [](const Group<T>* const* in, Group<T>* out) {
    $call
  });
}

template <int Degree, class T, class Rows = InOrder>
[[gnu::flatten]] void in_part(const T* a, const T* b, std::size_t count, T* to) {
  for_part_of_group<T, Rows, $size, $first$further>(a, b, count, to, [](const Group<T>* const* in, Group<T>* out) {
    $call
  });
}

template <int Degree, class T, class Rows = InOrder>
void records(const T* a, const T* b, std::size_t n, T* to) {
  run_records<T, Rows, one_by_one<Degree, T, Rows>, in_groups<Degree, T, Rows>, in_part<Degree, T, Rows>, $size, $first$further>(a, b, n, to);
}

)",
                parts_of_records(kernel));
}

// Kernels that need no driver, of interleaved records and of whole blocks.
std::string direct_kernels(const Kernel& kernel) {
  std::string text;
  if (has_colors(kernel)) {
    text = R"(template <int Degree, class T>
void interleaved(const T* a, const T* b, std::size_t n, T* to) {
  records<Degree, T, ByChannelOf<(Degree + 1) * (Degree + 1)>>(a, b, n, to);
}

)";
  }
  return text + filled(R"(template <int Degree, class T>
void blocks(const T* a, const T* b, std::size_t count, T* to) {
  kernel<Degree>(whole_blocks<T, $size, $first$further>(a, b, count, to));
}

)",
                       parts_of_records(kernel));
}

int most_single(const Driver& driver, int degree) {
  const std::vector<int>& single = driver.spec.single;
  return single[std::min(static_cast<std::size_t>(degree), single.size() - 1)];
}

// The body of a kernel of few records: by groups at low degrees, else one after the other; `b` that serves all; a sum.
std::string_view few_body(const Driver& driver) {
  if (signature_of(driver.last()).sums) {
    return R"(  constexpr bool kGrouped = Degree >= 2 && Degree <= $grouped;
  sum_records<kGrouped, $size, $first$further>(a, is_shared, b, n, to, [](const auto* const* in, auto* out) __attribute__((always_inline)) {
    $call
  });
)";
  }
  if (driver.spec.scalar_products) {
    return R"(  std::size_t first = 0;
  if constexpr (Degree >= 1 && Degree <= $grouped && sizeof(T) == sizeof(float)) {
    if (n > kMostProducts && !is_shared) first = multiply_few<$rows, $sums, (Degree + 1) * (Degree + 1)>(a, b, n, to);
  }
  for (std::size_t i = first; i < n; ++i) {
    const T* const in[] = {a + (is_shared ? 0 : i * $first)};
    T* const out = to + i * $size;
    $call
  }
)";
  }
  return R"(  if constexpr (Degree <= $grouped) {
    if (is_shared) return records<Degree, T, Shared>(a, b, n, to);
    records<Degree, T>(a, b, n, to);
  } else {
    const auto kernel = [](const One<T>* const* in, One<T>* out) __attribute__((noinline)) { $call };
    for_every_record<$size, $first$further>(a, is_shared, b, n, to, kernel);
  }
)";
}

constexpr std::string_view kSharedScalars = "blocks.in[1]";  // as signature_of names them

// Kernels of few records, and of the channels of interleaved ones.
std::string few_kernels(const Driver& driver) {
  const Kernel& kernel = driver.last();
  std::map<std::string, std::string> parts = parts_of_records(kernel);
  parts["grouped"] = std::to_string(driver.spec.grouped);
  const RecordSignature s = signature_of(kernel);
  const int length = numeric::coefficient_count(kernel.degree);
  parts["rows"] = std::to_string(s.inputs[0].size / length);
  parts["sums"] = std::to_string(s.inputs[1].size / length);
  if (const auto at = parts["call"].find(kSharedScalars); at != std::string::npos) {
    parts["call"].replace(at, kSharedScalars.size(), "b");
  }
  const std::string text = filled(
      "template <int Degree, class T>\nvoid few(const T* a, bool is_shared, const T* b, std::size_t n, T* to) {\n" +
          std::string(few_body(driver)) + "}\n\n",
      parts);
  if (!turns_colors(kernel)) return text;
  return text + filled(R"(template <int Degree, class T>
[[gnu::flatten]] void turn_colors(const T* a, const T* b, std::size_t n, T* to) {
  for_every_color<$first$further>(a, b, n, to, [](const Color<T>* const* in, Color<T>* out) {
    $call
  });
}

template <int Degree, class T>
constexpr detail::RecordKernel<T> colors() {
  if constexpr (kHoldsColors<T>) return turn_colors<Degree, T>;
  return nullptr;
}

)",
                       parts);
}

// The kernels that need no driver, by degree.
std::string direct_table(const Driver& driver, const std::string& scalar) {
  std::string text =
      filled("extern const detail::DirectKernels<$t> $table[];\nconst detail::DirectKernels<$t> $table[] = {\n",
             {{"t", scalar}, {"table", table_of_direct(driver, scalar)}});
  for (const FinishedKernel& finished : driver.kernels) {
    const std::string_view row = has_colors(driver.last())
                                     ? "    {records<$degree, $t>, blocks<$degree, $t>, interleaved<$degree, $t>},\n"
                                     : "    {records<$degree, $t>, blocks<$degree, $t>},\n";
    text += filled(row, {{"degree", std::to_string(finished.kernel.degree)}, {"t", scalar}});
  }
  return text + "};\n";
}

// The most records that a driver computes one by one at a degree, in code.
std::string single_records(const Driver& driver, int degree, const std::string& scalar) {
  return filled("single_records<$t>($single)",
                {{"t", scalar}, {"single", std::to_string(most_single(driver, degree))}});
}

// The kernels of few records by degree.
std::string single_table(const Driver& driver, const std::string& scalar) {
  std::string text =
      filled("extern const detail::SingleKernels<$t> $table[];\nconst detail::SingleKernels<$t> $table[] = {\n",
             {{"t", scalar}, {"table", table_of_direct(driver, scalar)}});
  for (const FinishedKernel& finished : driver.kernels) {
    const int degree = finished.kernel.degree;
    const std::string at_degree = "<" + std::to_string(degree) + ", " + scalar + ">";
    std::string most = single_records(driver, degree, scalar);
    if (degree <= driver.spec.grouped && driver.has_records()) {
      most = filled(
          "grouped_records<$t>($degree, $single)",
          {{"t", scalar}, {"degree", std::to_string(degree)}, {"single", std::to_string(most_single(driver, degree))}});
    } else if (driver.spec.scalar_products && degree >= 1 && degree <= driver.spec.grouped && scalar == "float") {
      most = "detail::kMostDirect";
    }
    text += "    {few" + at_degree + ", " + most + (turns_colors(driver.last()) ? ", colors" + at_degree + "()" : "") +
            "},\n";
  }
  return text + "};\n";
}

// Where the instruction set has no conversions, the driver widens and runs the kernel: nothing is compiled twice.
constexpr std::string_view kHalfKernel = R"(template <int Degree, int Size, class T>
constexpr BlockKernel<T> half() {
#if defined(SH_BATCH_CONVERTS_HALVES)
  if constexpr (sizeof(T) == sizeof(float)) return kernel_half<Degree, Size>;
#endif
  return nullptr;
}

)";

// The most records that are copied to rows first: copies take as long as kernels. A sum has the same bits in every layout.
std::string most_copied(const Driver& driver, int degree) {
  const std::string most = single_records(driver, degree, "T");
  return signature_of(driver.last()).sums ? most : most + " / 2";
}

// The row of the table of plans for one degree.
std::string plan_row(const Driver& driver, std::size_t i) {
  const Kernel& kernel = driver.kernels[i].kernel;
  const RecordSignature s = signature_of(kernel);
  std::string sizes;
  for (const Record& record : s.inputs) sizes += (sizes.empty() ? "" : ", ") + std::to_string(record.size);
  const bool by_parts = driver.adds_parts() && kernel.degree <= kLargestByParts;
  const std::string at_degree = "<" + std::to_string(kernel.degree);
  std::string prepared = "nullptr, 0, nullptr";
  if (driver.prepares() && kernel.degree <= kLargestPrepared) {
    const int size = signature_of((*driver.prepare)[i].kernel).out_size;
    prepared =
        "detail::prepare_" + driver.name + ", " + std::to_string(size) + ", kernel_prepared" + at_degree + ", T>";
  }
  std::string plain = (by_parts ? "parts" : "kernel") + at_degree + ", T>";
  std::string half = "half" + at_degree + ", " + std::to_string(s.inputs[0].size) + ", T>()";
  if (driver.spec.scalar_products) {
    plain = "multiply_blocks<" + scalar_products(kernel) + ", T, T>";
    half = "float_only<T>(multiply_blocks<" + scalar_products(kernel) + ", float, Half>)";
  }
  std::string records = records_kernel(driver, kernel);
  if (records.empty()) records = "nullptr, nullptr";
  std::string further = ", " + std::to_string(shared_input(s)) + ", " + records;
  further += driver.spec.groups ? ", records" + at_degree + ", T>" : ", nullptr";
  further += driver.spec.groups && has_colors(driver.last()) ? ", interleaved" + at_degree + ", T>" : ", nullptr";
  if (driver.has_few()) {
    further += ", of_type<T>(" + table_of_direct(driver, "float") + ", " + table_of_direct(driver, "double") + ") + " +
               std::to_string(kernel.degree);
  } else {
    further += ", nullptr";
  }
  if (driver.has_few()) further += ", " + most_copied(driver, kernel.degree);
  return filled("      {$inputs, {$sizes}, $out, $sums, $kernel, $half, $prepared, $finish$further},\n",
                {{"inputs", std::to_string(s.inputs.size())},
                 {"sizes", sizes},
                 {"out", std::to_string(s.out_size)},
                 {"sums", s.sums ? "true" : "false"},
                 {"kernel", plain},
                 {"half", driver.spec.half ? half : "nullptr"},
                 {"prepared", prepared},
                 {"finish", by_parts ? "detail::finish_" + driver.name : "nullptr"},
                 {"further", further}});
}

// A function that a driver runs once a call: the kernels of a family, for each of some scalars.
struct OnceFunction {
  std::string name;
  std::vector<std::string> scalars;
  const std::vector<FinishedKernel>* kernels = nullptr;

  [[nodiscard]] std::string declaration(const std::string& scalar) const {
    return filled("void $name(int degree, const $t* in, $t* out)", {{"name", name}, {"t", scalar}});
  }
};

std::vector<OnceFunction> once_functions(const std::vector<Driver>& drivers) {
  std::vector<OnceFunction> functions;
  for (const Driver& driver : drivers) {
    if (driver.prepares()) functions.push_back({"prepare_" + driver.name, {"float", "double"}, driver.prepare});
    if (driver.adds_parts()) functions.push_back({"finish_" + driver.name, {"double"}, driver.finish});
  }
  return functions;
}

// Chooses by degree among the kernels.
std::string definition(const OnceFunction& function, const std::string& scalar) {
  std::string runs;
  for (const FinishedKernel& finished : *function.kernels) {
    const Kernel& kernel = finished.kernel;
    if (kernel.parameters.size() != 1 || kernel.results.size() != 1)
      throw std::logic_error(kernel.name + ": only a kernel from one array to one array can run once a call");
    runs += "      sh::" + kernel.name + "<" + scalar + ">,\n";
  }
  return filled(R"(
$declaration {
  static constexpr Run<$t> kRuns[] = {
$runs  };
  kRuns[degree](in, out);
}
)",
                {{"declaration", function.declaration(scalar)}, {"t", scalar}, {"runs", runs}});
}

}  // namespace

std::string table_of_direct(const Driver& driver, const std::string& scalar) { return driver.name + "_" + scalar; }

std::string kernels_file(const Driver& driver) {
  std::string includes;
  includes += "#include \"../cpp/" + driver.name + ".hpp\"\n";
  for (const auto* further : {driver.prepared, driver.parts}) {
    if (further != nullptr) includes += "#include \"../cpp/" + further->back().kernel.family + ".hpp\"\n";
  }
  includes += "#include \"drive.hpp\"\n";
  if (driver.spec.groups || driver.has_few()) includes += "#include \"groups.hpp\"\n";
  if (driver.spec.rings) includes += "#include \"transfer_rings.hpp\"\n";
  if (driver.prepares() || driver.adds_parts()) includes += "#include \"once.hpp\"\n";
  const bool rings = driver.spec.rings;
  std::string kernels = driver.spec.scalar_products  ? ""
                        : stores_most(driver.last()) ? storing_kernel(driver)
                                                     : block_kernel("kernel", driver.last(), Loop::kPlain, rings);
  if (driver.adds_parts()) kernels += block_kernel("parts", driver.parts->back().kernel);
  if (driver.prepares()) kernels += block_kernel("kernel_prepared", driver.prepared->back().kernel, Loop::kFixed);
  if (driver.has_records()) kernels += record_kernels(driver.last());
  if (driver.spec.groups) kernels += direct_kernels(driver.last());
  if (driver.has_few()) kernels += few_kernels(driver);
  if (driver.spec.half && !driver.spec.scalar_products) {
    kernels +=
        "#if defined(SH_BATCH_CONVERTS_HALVES)\n" + block_kernel("kernel_half", driver.last(), Loop::kHalf, rings);
    kernels.insert(kernels.size() - 1, "#endif\n");
    kernels += kHalfKernel;
  }
  if (!kernels.empty()) kernels = "namespace {\n\n" + kernels + "}  // namespace\n\n";
  std::string plans, tables;
  for (std::size_t i = 0; i < driver.kernels.size(); ++i) plans += plan_row(driver, i);
  for (const char* scalar : {"float", "double"}) {
    if (driver.spec.groups) tables += direct_table(driver, scalar);
    if (driver.has_few()) tables += single_table(driver, scalar);
  }
  return filled(
      R"(// sh::batch::$name on the instruction set SH_BATCH_ISA.
//
$stamp$includes
namespace sh::batch::SH_BATCH_ISA {

$kernels$tables
template <class T>
void $name(const detail::Call<T>& call) {
  static constexpr Plan<T> kPlans[] = {
$plans  };
  drive(call, kPlans[call.degree]);
}
template void $name(const detail::Call<float>&);
template void $name(const detail::Call<double>&);

}  // namespace sh::batch::SH_BATCH_ISA
)",
      {{"name", driver.name},
       {"stamp", kStamp},
       {"includes", includes},
       {"kernels", kernels},
       {"plans", plans},
       {"tables", tables}});
}

std::string once_header(const std::vector<Driver>& drivers) {
  std::string declarations;
  for (const OnceFunction& function : once_functions(drivers)) {
    for (const std::string& scalar : function.scalars) declarations += function.declaration(scalar) + ";\n";
  }
  return filled(R"(// What drivers compute once a call, whatever the instruction set: from a shared input, or of a sum.
//
$stamp#pragma once

namespace sh::batch::detail {

$declarations
}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp}, {"declarations", declarations}});
}

std::string once_file(const std::vector<Driver>& drivers) {
  std::set<std::string> includes;
  std::string definitions;
  for (const OnceFunction& function : once_functions(drivers)) {
    includes.insert("#include \"../cpp/" + function.kernels->back().kernel.family + ".hpp\"\n");
    for (const std::string& scalar : function.scalars) definitions += definition(function, scalar);
  }
  std::string text = "// Chooses by degree what drivers compute once a call.\n//\n" + std::string(kStamp);
  text += "#include \"once.hpp\"\n\n";
  for (const std::string& include : includes) text += include;
  return text +
         "\nnamespace sh::batch::detail {\nnamespace {\n\ntemplate <class T>\nusing Run = void (*)(const T*, T*);\n\n} "
         " // namespace\n" +
         definitions + "\n}  // namespace sh::batch::detail\n";
}

}  // namespace sh::codegen::print
