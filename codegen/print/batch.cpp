#include "codegen/print/batch.hpp"

#include <algorithm>
#include <string_view>

#include "codegen/print/batch_driver.hpp"
#include "codegen/print/dialect.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::codegen::print {
namespace {

// The files of codegen/runtime/: name and text.
using namespace std::string_view_literals;
constexpr std::pair<std::string_view, std::string_view> kRuntime[] = {
#include "runtime.inc"
};

constexpr int kChunkLines = 192;

// The scalar type of a driver, and that of its input 0.
struct Overload {
  std::string scalar;
  std::string first;
};

std::vector<Overload> overloads(const Driver& driver) {
  std::vector<Overload> types{{"float", "float"}, {"double", "double"}};
  if (driver.spec.half) types.push_back({"float", "Half"});
  return types;
}

// "void basis(int degree, std::size_t n, Records<const float> directions, Records<float> out)"
std::string public_signature(const Driver& driver, const Overload& types) {
  const RecordSignature s = signature_of(driver.last());
  std::string text = "void " + driver.name + "(int degree, std::size_t n";
  for (std::size_t j = 0; j < s.inputs.size(); ++j) {
    const std::string& scalar = j == 0 ? types.first : types.scalar;
    const std::string type = s.inputs[j].shared ? "const " + scalar + "* " : "Records<const " + scalar + "> ";
    text += ", " + type + s.inputs[j].name;
  }
  return text + ", " + (s.sums ? types.scalar + "* " : "Records<" + types.scalar + "> ") + s.out + ")";
}

// "3", "bands^2", "4 bands^2".
std::string size_text(int size, int degree) {
  const int count = numeric::coefficient_count(degree);
  if (size % count != 0) return std::to_string(size);
  return (size == count ? "" : std::to_string(size / count) + " ") + "bands^2";
}

// {sets of bands^2 values, further values}
std::string size_in_code(int size, int degree) {
  const int count = numeric::coefficient_count(degree);
  return size % count == 0 ? "{" + std::to_string(size / count) + ", 0}" : "{0, " + std::to_string(size) + "}";
}

bool has_table(const Driver& driver) { return driver.spec.groups || driver.has_few(); }
bool is_direct(const Driver& driver, const Overload& types) { return has_table(driver) && types.first != "Half"; }

// "SingleKernels<float>": what its table holds by degree.
std::string table_type(const Driver& driver, const std::string& scalar) {
  return (driver.spec.groups ? "DirectKernels<" : "SingleKernels<") + scalar + ">";
}

// AnyCall of direct.hpp.
std::string any_signature(const Driver& driver, const std::string& scalar, const std::string& prefix = {}) {
  return filled("void $function(int degree, std::size_t n, const $t* a, const $t* $b, $t* out, Layouts layouts)",
                {{"function", prefix + "run_" + driver.name},
                 {"t", scalar},
                 {"b", signature_of(driver.last()).inputs.size() > 1 ? "b" : "/*b*/"}});
}

// Whether the first input may be shared in a call that needs no driver.
bool may_share(const Driver& driver) { return driver.has_few(); }

// The degrees at which a loop over plain records in the caller serves: those that add nothing, so that every compiler rounds
// alike.
std::span<const FinishedKernel> kernels_in_caller(const Driver& driver) {
  return driver.kernels.first(driver.has_records() ? last_without_sums(driver) + 1 : 0);
}

std::string loop_in_caller(const Driver& driver, const Kernel& kernel) {
  const RecordSignature s = signature_of(kernel);
  std::string parameters, records;
  for (const Record& record : s.inputs) {
    const bool may_be_one = may_share(driver) && records.empty();
    const std::string size = std::to_string(record.size);
    parameters += ", const T* " + record.name + (may_be_one ? ", bool is_shared" : "");
    records += (records.empty() ? "" : ", ") + record.name +
               (may_be_one ? " + (is_shared ? 0 : i * " + size + ")" : " + i * " + size);
  }
  return filled(R"(template <class T>
[[gnu::always_inline]] inline void loop_$name(std::size_t n$parameters, T* to) {
  for_each_record(n, [=](std::size_t i) {
    const T* const in[] = {$records};
    T* const out = to + i * $size;
    $call
  });
}
)",
                {{"name", kernel.name},
                 {"parameters", parameters},
                 {"records", records},
                 {"size", std::to_string(s.out_size)},
                 {"call", call_of(kernel, kernel.name, std::to_string(numeric::coefficient_count(kernel.degree)))}});
}

// The branches of a driver that call such loops.
std::string branches_to_loops(const Driver& driver) {
  const RecordSignature s = signature_of(driver.last());
  std::string arrays, plain = s.out, rows;
  for (const Record& record : s.inputs) {
    const bool may_be_one = may_share(driver) && arrays.empty();
    arrays += ", " + record.name + ".data";
    if (may_be_one) arrays += ", " + record.name + ".layout == Layout::kShared";
    (may_be_one ? rows : plain) += (may_be_one ? " && detail::is_in_rows(" + record.name + ")" : ", " + record.name);
  }
  std::string loops;
  for (const FinishedKernel& finished : kernels_in_caller(driver)) {
    loops += filled("    if (degree == $degree) return detail::loop_$name(n$arrays, $out.data);\n",
                    {{"degree", std::to_string(finished.kernel.degree)},
                     {"name", finished.kernel.name},
                     {"arrays", arrays},
                     {"out", s.out}});
  }
  if (loops.empty()) return {};
  return filled("  if (SH_BATCH_LIKELY(SH_BATCH_KNOWS(degree) && detail::are_few(n, $plain)$rows)) {\n$loops  }\n",
                {{"plain", plain}, {"rows", rows}, {"loops", loops}});
}

// A driver whose calls need none where records are all plain or in whole blocks.
std::string direct_function(const Driver& driver, const Overload& types) {
  const RecordSignature s = signature_of(driver.last());
  std::string inputs;
  for (const Record& record : s.inputs) inputs += ", " + (record.shared ? "shared(" + record.name + ")" : record.name);
  std::string run = "run_direct<";
  if (driver.has_few()) run = std::string("run_single<Layout::") + (s.inputs[1].shared ? "kShared, " : "kPlain, ");
  return filled(R"([[gnu::always_inline]] inline $signature {
  if (!detail::are_given($out$inputs)) return detail::run_any<$t>(detail::run_$name, degree, n, $out$inputs);
$loops  detail::$run$t>(detail::$table, detail::run_$name, degree, $degree, n, $out$inputs);
}
)",
                {{"signature", public_signature(driver, types)},
                 {"loops", branches_to_loops(driver)},
                 {"run", run},
                 {"t", types.scalar},
                 {"table", table_of_direct(driver, types.scalar)},
                 {"degree", std::to_string(driver.last().degree)},
                 {"name", driver.name},
                 {"out", s.sums ? "plain(" + s.out + ")" : s.out},
                 {"inputs", inputs}});
}

// The tables that these functions choose from, and what they call otherwise.
std::string direct_declarations(const std::vector<Driver>& drivers) {
  std::string text;
  for (const Driver& driver : drivers) {
    for (const FinishedKernel& finished : kernels_in_caller(driver)) text += loop_in_caller(driver, finished.kernel);
    for (const Overload& types : overloads(driver)) {
      if (!is_direct(driver, types)) continue;
      const std::string name = table_of_direct(driver, types.scalar);
      const std::string type = "extern const " + table_type(driver, types.scalar) + "* const ";
      text += type + name + "[];\n";
      text += any_signature(driver, types.scalar) + ";\n";
    }
  }
  return text;
}

std::string declaration(const Driver& driver) {
  const Kernel& kernel = driver.last();
  const RecordSignature s = signature_of(kernel);
  std::string records;
  for (const Record& record : s.inputs) {
    const std::string size = record.size_text.empty() ? size_text(record.size, kernel.degree) : record.size_text;
    records += " " + record.name + " (" + size + "),";
  }
  std::string text = filled(R"(
/// $what.
/// degree 0 to $degree;$records $out ($size).
/// Domain: $domain.
)",
                            {{"what", driver.spec.what},
                             {"degree", std::to_string(kernel.degree)},
                             {"records", records},
                             {"out", s.out},
                             {"size", size_text(s.out_size, kernel.degree)},
                             {"domain", kernel.domain}});
  if (driver.further > 0) {
    text += filled("/// Single calls go on to degree $last: sh::$name<$last>.\n",
                   {{"last", std::to_string(driver.further)}, {"name", driver.name}});
  }
  for (const Overload& types : overloads(driver)) {
    text += is_direct(driver, types) ? direct_function(driver, types) : public_signature(driver, types) + ";\n";
  }
  return text;
}

std::string drivers_header(const std::vector<Driver>& drivers) {
  std::string declarations, includes;
  for (const Driver& driver : drivers) {
    declarations += declaration(driver);
    for (const FinishedKernel& finished : kernels_in_caller(driver))
      includes += "#include \"../cpp/" + finished.kernel.name + ".hpp\"\n";
  }
  return filled(R"(// Kernels over n records, for batch.hpp.
//
$stamp#pragma once

$includes#include "direct.hpp"
#include "records.hpp"

namespace sh::batch {

namespace detail {
$direct}  // namespace detail
$declarations
}  // namespace sh::batch
)",
                {{"stamp", kStamp},
                 {"includes", includes},
                 {"direct", direct_declarations(drivers)},
                 {"declarations", declarations}});
}

// The arguments of a call as a driver takes them, half: input 0 of binary16.
std::string arguments_of(const RecordSignature& s, bool half) {
  std::string inputs;
  for (std::size_t j = 0; j < s.inputs.size(); ++j) {
    const std::string& name = s.inputs[j].name;
    inputs += (j == 0 ? "" : ", ") + (half && j == 0       ? "{nullptr, " + name + ".layout}"
                                      : s.inputs[j].shared ? "shared(" + name + ")"
                                                           : name);
  }
  return "{" + inputs + "}, " + (s.sums ? "plain(" + s.out + ")" : s.out) +
         (half ? ", " + s.inputs[0].name + ".data" : "");
}

// The arrays of a driver whose records are the coefficients of so many channels: inputs, and whether the output is one.
struct Coefficients {
  std::vector<std::size_t> inputs;
  bool out = false;
};
Coefficients coefficients_of(const Driver& driver, int channels) {
  const RecordSignature s = signature_of(driver.last());
  Coefficients found;
  for (std::size_t j = 0; j < s.inputs.size(); ++j) {
    if (!s.inputs[j].shared && are_coefficients(s.inputs[j].size, driver.last(), channels)) found.inputs.push_back(j);
  }
  found.out = !s.sums && are_coefficients(s.out_size, driver.last(), channels);
  return found;
}

// Whether a driver maps coefficients to coefficients: those of three channels, one after the other.
bool maps_coefficients(const Driver& driver) {
  const Coefficients found = coefficients_of(driver, 1);
  return found.out && !found.inputs.empty();
}

// The arrays that may be interleaved: Colors of choice.hpp.
std::string colors_of(const Driver& driver) {
  const bool maps = maps_coefficients(driver);
  const Coefficients found = coefficients_of(driver, maps ? 1 : 3);
  std::string bits;
  for (const std::size_t j : found.inputs) bits += (bits.empty() ? "" : " | ") + std::to_string(1U << j);
  if (found.out) bits += bits.empty() ? "detail::kOutput" : " | detail::kOutput";
  return bits.empty() ? "" : ", {" + bits + (maps ? ", false}" : ", true}");
}

std::string definition(const Driver& driver, const Overload& types) {
  const Kernel& kernel = driver.last();
  const RecordSignature s = signature_of(kernel);
  std::string tables, signature = public_signature(driver, types), arguments = arguments_of(s, types.first == "Half");
  if (is_direct(driver, types)) {
    const std::string type = "const detail::" + table_type(driver, types.scalar) + "* const";
    const std::string table = table_of_direct(driver, types.scalar);
    tables = filled("$type detail::$table[] = SH_BATCH_EVERY($table);\n\n", {{"type", type}, {"table", table}});
    signature = any_signature(driver, types.scalar, "detail::");
    arguments = s.inputs.size() > 1 ? "{{a, layouts.a()}, {b, layouts.b()}}" : "{{a, layouts.a()}}";
    arguments += ", {out, layouts.out()}";
  }
  return filled(
      R"(
$tables$signature {
  static constexpr detail::Run<$t> kEvery[] = SH_BATCH_EVERY($name);
  detail::run<$t>("$name", kEvery, {degree, n, $arguments}, $count, $degree, $size$colors);
}
)",
      {{"tables", tables},
       {"signature", signature},
       {"t", types.scalar},
       {"name", driver.name},
       {"arguments", arguments},
       {"count", std::to_string(s.inputs.size())},
       {"degree", std::to_string(kernel.degree)},
       {"size", s.sums ? "{0, 0}" : size_in_code(s.out_size, kernel.degree)},
       {"colors", colors_of(driver)}});
}

std::string drivers_file(const std::vector<Driver>& drivers) {
  std::string text = "// Passes every call to the driver of the instruction set in use.\n//\n" + std::string(kStamp) +
                     "#include \"drivers.hpp\"\n\n#include \"choice.hpp\"\n\nnamespace sh::batch {\n";
  for (const char* isa : {"baseline", "avx2", "avx512"}) {
    text += "\nnamespace " + std::string(isa) + " {\n";
    for (const Driver& driver : drivers) {
      text += "template <class T>\nvoid " + driver.name + "(const detail::Call<T>& call);\n";
      for (const char* scalar : {"float", "double"}) {
        if (!has_table(driver)) continue;
        text += filled("extern const detail::$type $table[];\n",
                       {{"type", table_type(driver, scalar)}, {"table", table_of_direct(driver, scalar)}});
      }
    }
    text += "}  // namespace " + std::string(isa) + "\n";
  }
  for (const Driver& driver : drivers) {
    for (const Overload& types : overloads(driver)) text += definition(driver, types);
  }
  return text + "\n}  // namespace sh::batch\n";
}

// The memory that a driver needs in addition to the caller's arrays, in lines of 64 bytes.
int room_lines(const Driver& driver) {
  const RecordSignature s = signature_of(driver.last());
  const int channels = maps_coefficients(driver) ? 3 : 1;
  const int out = channels * s.out_size;
  int in = 0;
  for (const Record& record : s.inputs) in += record.shared ? 0 : channels * record.size;
  int prepared = 0;
  if (driver.prepares()) prepared = 2 * signature_of(driver.prepare->back().kernel).out_size;  // once plain
  const int chunk = std::max(kChunkLines, in + out);
  const int halves = driver.spec.half ? s.inputs[0].size : 0;  // widened before they are put in place
  return in + prepared + chunk + std::max(kChunkLines, out) + halves;
}

std::string sizes_header(const std::vector<Driver>& drivers) {
  int sums = 1;
  int room = 0;
  for (const Driver& driver : drivers) {
    const RecordSignature s = signature_of(driver.last());
    if (s.sums) sums = std::max(sums, s.out_size);
    room = std::max(room, room_lines(driver));
  }
  return filled(R"(// How large the records of the drivers are, in drive.cpp.
//
$stamp#pragma once

#include <cstddef>

namespace sh::batch::detail {

constexpr int kMostSums = $sums;             // values of the largest sum
constexpr std::size_t kChunkLines = $chunk;  // copied at a time: 12 KB stay in the first cache
constexpr std::size_t kRoomLines = $room;  // for copies of a chunk of records

}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp},
                 {"sums", std::to_string(sums)},
                 {"chunk", std::to_string(kChunkLines)},
                 {"room", std::to_string(room + 2)}});  // an array of lanes may reach past its last block
}

}  // namespace

std::map<std::string, std::string> batch_files(const std::vector<WrittenFamily>& families) {
  const std::vector<Driver> drivers = drivers_of(families);
  std::map<std::string, std::string> files{{"batch/drivers.hpp", drivers_header(drivers)},
                                           {"batch/drivers.cpp", drivers_file(drivers)},
                                           {"batch/once.hpp", once_header(drivers)},
                                           {"batch/once.cpp", once_file(drivers)},
                                           {"batch/sizes.hpp", sizes_header(drivers)}};
  for (const Driver& driver : drivers) files["batch/" + driver.name + ".cpp"] = kernels_file(driver);
  for (const Driver& driver : drivers) {
    if (driver.spec.rings) files["batch/rings.hpp"] = rings_file(driver.last().degree);
  }
  for (const auto& [name, text] : kRuntime) files["batch/" + std::string(name)] = text;
  files.merge(lane_tables());
  return files;
}

}  // namespace sh::codegen::print
