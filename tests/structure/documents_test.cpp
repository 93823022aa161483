// What the documents name is there: files, links with their headings, Verilog modules.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cctype>

#include "tests/structure/tree.h"

namespace wrinkle {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<fs::path> documents(const fs::path& root) {
  std::vector<fs::path> pages = files_below(root / "docs", {".md"});
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
    if (fs::exists(root / name)) pages.push_back(root / name);
  return pages;
}

// As GitHub makes the anchor of a heading.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_') anchor += char(std::tolower(c));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

bool has_anchor(const fs::path& page, const std::string& anchor) {
  for (const std::string& heading : headings(page))
    if (anchor_of(heading) == anchor) return true;
  return false;
}

void check_links(const fs::path& page, const std::string& text, const std::string& where, Faults& faults) {
  for (const std::string& link : matches(text, "\\]\\(([^)\\s]+)\\)")) {
    if (link.find("://") != std::string::npos) continue;
    const std::size_t hash = link.find('#');
    const std::string file = link.substr(0, hash);
    const fs::path target = file.empty() ? page : page.parent_path() / file;
    if (!fs::exists(target))
      faults.push_back(where + ": the link to " + link + " leads nowhere");
    else if (hash != std::string::npos && !has_anchor(target, link.substr(hash + 1)))
      faults.push_back(where + ": " + link + " has no such heading");
  }
}

// A path of this project, with or without its ending. Words in capitals stand for a name and are not looked up.
void check_paths(const fs::path& root, const std::string& text, const std::string& where, Faults& faults) {
  for (const std::string& path : matches(text, "`((?:golden|rtl|sim|tb|tests|docs)/[\\w./+-]+)`")) {
    const fs::path file = root / path;
    const bool placeholder = path.find("NAME") != std::string::npos;
    if (!placeholder && !fs::exists(file) && !fs::exists(file.string() + ".h"))
      faults.push_back(where + ": there is no " + path);
  }
}

void check_modules(const fs::path& root, const std::string& text, const std::string& where, Faults& faults) {
  std::vector<std::string> modules;
  for (const fs::path& file : files_below(root / "rtl", {".v", ".vh"})) modules.push_back(file.stem());
  for (const std::string& name : matches(text, "\\b(wrinkle_\\w*[a-z0-9])\\b"))
    if (name.find("NAME") == std::string::npos && !contains(modules, name))
      faults.push_back(where + ": there is no module " + name);
}

Faults faults_of_documents(const fs::path& root) {
  Faults faults;
  for (const fs::path& page : documents(root)) {
    const std::string text = text_of(page), where = fs::relative(page, root).generic_string();
    check_links(page, text, where, faults);
    check_paths(root, text, where, faults);
    check_modules(root, text, where, faults);
  }
  return faults;
}

TEST(Documents, NameWhatIsThere) {
  ASSERT_FALSE(documents(WRINKLE_SOURCE_DIR).empty());
  EXPECT_THAT(faults_of_documents(WRINKLE_SOURCE_DIR), IsEmpty());
}

TEST(Documents, WhatIsNotThereIsSaid) {
  const fs::path root = fs::path(testing::TempDir()) / ("wrinkle_documents_" + std::to_string(getpid()));
  const auto write = [&](const std::string& file, const std::string& text) {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << text;
  };
  write("rtl/stage/wrinkle_light.v", "");
  write("golden/pixel/rsqrt.h", "");
  write("docs/other.md", "## What it costs, in gates\n");
  write("docs/page.md",
        "`golden/pixel/rsqrt` `golden/pixel/NAME-inl.h` wrinkle_light [o](other.md#what-it-costs-in-gates)\n"
        "[w](https://example.org/a) wrinkle_NAME wrinkle_error_...");
  EXPECT_THAT(faults_of_documents(root), IsEmpty());
  write("docs/page.md", "`golden/pixel/root.h` wrinkle_dark [o](others.md) [o](other.md#what-it-costs)");
  EXPECT_THAT(faults_of_documents(root),
              UnorderedElementsAre("docs/page.md: there is no golden/pixel/root.h",
                                   "docs/page.md: there is no module wrinkle_dark",
                                   "docs/page.md: the link to others.md leads nowhere",
                                   "docs/page.md: other.md#what-it-costs has no such heading"));
  fs::remove_all(root);
}

}  // namespace
}  // namespace wrinkle
