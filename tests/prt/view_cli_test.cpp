// `prt view` as a child process. tests/view looks at its pages in a browser.
#include <gtest/gtest.h>

#include <csignal>

#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(ViewTool, WritesOnePageThatAsksForNothing) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a <b>.transfer"), baked(primitive_mesh("box"), &kShadowed, 64, 2));
  write_transfer(folder.file("c.transfer"), baked(primitive_mesh("torus"), &kGlossyShadowed, 64, 3));
  const Finished done =
      succeeded({"view", folder.file("a <b>.transfer"), folder.file("c.transfer"), "-o", folder.file("view.html")});
  EXPECT_EQ(done.out, "");
  const std::string page = read_all(folder.file("view.html"));
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_EQ(count_of("{{", page), 0U) << "every part of the template is filled";
  EXPECT_EQ(count_of("</script>", page), 2U) << "no text ends a script early";
  EXPECT_EQ(count_of("http", page), 0U);
  EXPECT_EQ(count_of("\nimport ", page) + count_of("\nexport ", page), 0U);
  for (const char* part : {"rotate_l3", "evaluate_rgb_l6", "transfer_prepare_l3", R"("name":"a <b>.transfer")"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

TEST(ViewTool, WritesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a.transfer"), baked(primitive_mesh("box"), &kInterreflected, 64, 2));
  for (const char* threads : {"1", "3"}) {
    succeeded(
        {"view", folder.file("a.transfer"), "-o", folder.file(std::string(threads) + ".html"), "--threads", threads});
  }
  EXPECT_EQ(read_all(folder.file("1.html")), read_all(folder.file("3.html")));
}

TEST(ViewTool, WritesAModuleWithItsExports) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a.transfer"), baked(primitive_mesh("box"), &kShadowed, 64, 2));
  succeeded({"view", folder.file("a.transfer"), "-o", folder.file("relight.js")});
  const std::string module = read_all(folder.file("relight.js"));
  EXPECT_EQ(count_of("\nimport ", module), 0U);
  for (const char* name :
       {"function load(", "class Relighter", "class FileError", "function uniformsOf(", "const runtime"}) {
    EXPECT_EQ(count_of(std::string("\nexport ") + name, module), 1U) << name;
  }
}

TEST(ViewTool, RefusesWithOneLineAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.transfer");
  const std::string page = folder.file("view.html");
  write_transfer(file, baked(primitive_mesh("box"), &kShadowed, 64, 1));
  write_all(folder.file("text"), std::string(100, 'x'));
  expect_refused({"view", folder.file("none"), "-o", page}, "none: cannot read");
  expect_refused({"view", folder.file("text"), "-o", page}, "text: not a transfer file");
  expect_refused({"view", file, "-o", folder.file("view.png")}, "expected a name that ends in .html or .js");
  expect_refused({"view", file}, "expected either -o FILE.html, -o FILE.js or --serve");
  expect_refused({"view", file, "-o", page, "--serve"}, "expected either");
  expect_refused({"view", file, file, "-o", folder.file("a.js")}, "expected one transfer file, got ");
  expect_refused({"view", file, "-o", page, "--light", folder.file("none.json")}, "none.json");
  expect_refused({"view", file, "--serve", "--port", "70000"}, "--port");
  expect_refused({"view", file, "-o", folder.file("no/view.html")}, "view.html");
  EXPECT_FALSE(std::filesystem::exists(page));
  std::filesystem::copy_file(file, folder.file("in.html"));
  expect_refused({"view", folder.file("in.html"), "-o", folder.file("in.html")}, "not an input too");
  EXPECT_EQ(read_all(folder.file("in.html")), read_all(file));
}

TEST(ViewTool, ServesUntilItIsStopped) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a.transfer"), baked(primitive_mesh("box"), &kShadowed, 64, 1));
  const Finished done = interrupt_prt({"view", folder.file("a.transfer"), "--serve"}, 1500);
  EXPECT_EQ(done.status, 0);
  EXPECT_NE(done.err.find("prt: open http://127.0.0.1:"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace sh::prt::test
