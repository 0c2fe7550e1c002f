// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The page in a browser without a window, where one is installed (Debian: chromium).
 */
#include "ReportPages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;
using testing::HasSubstr;

namespace
{

std::string FindBrowser()
{
  for (const char* path :
    { "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome" })
  {
    if (fs::exists(path))
    {
      return path;
    }
  }
  return {};
}

/** What the browser says of the page, without a network. */
pemesh::ProgramRun Browse(
  const std::string& browser, const fs::path& page, const std::vector<std::string>& arguments)
{
  std::vector<std::string> all{ "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
    "--disable-dev-shm-usage", "--host-resolver-rules=MAP * ~NOTFOUND",
    "--user-data-dir=" + (page.parent_path() / "browser").string() };
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.push_back("file://" + page.string());
  return pemesh::RunProgram(browser, all);
}

TEST(ReportInBrowser, ShowsAndSorts)
{
  const std::string browser = FindBrowser();
  if (browser.empty())
  {
    GTEST_SKIP() << "no chromium here: apt-get install chromium";
  }
  const fs::path folder = pages::RunSmallStudy("browser");
  ASSERT_THAT(pages::Page(folder), HasSubstr("<html"));
  const auto dom = Browse(browser, folder / "report.html", { "--dump-dom" });
  ASSERT_EQ(dom.ExitCode, 0) << dom.Errors;
  EXPECT_THAT(dom.Output, HasSubstr("<button type=\"button\">Elements</button>"))
    << "the script has run";
  EXPECT_THAT(dom.Output, HasSubstr("<h2 id=\"methods-title\">Methods and words</h2>"))
    << "the page is read to its end";
  const auto picture = Browse(browser, folder / "report.html",
    { "--window-size=1200,3000", "--screenshot=" + (folder / "page.png").string() });
  ASSERT_EQ(picture.ExitCode, 0) << picture.Errors;
  EXPECT_GT(fs::file_size(folder / "page.png"), 20000U) << "an empty page is smaller";
}

} // namespace
