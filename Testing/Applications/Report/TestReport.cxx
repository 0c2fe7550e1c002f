// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReportPages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** Results with everything that a page must not take for markup. */
fs::path WriteHostileFolder(const std::string& name)
{
  const fs::path folder = pemesh::TestFolder(name);
  std::ofstream(folder / "study.json")
    << R"({"pemesh": 1, "name": "<script>alert(1)<script> & \"quotes\"", "written-by": "PEMesh <b>",
           "meshes": ["a.off"], "solvers": [{"solver": "no-such-solver", "name": "run"}]})";
  std::ofstream(folder / "results.csv")
    << "Index,Mesh,MeshSize,Area_min,Area_max,Area_mean,run_error,Status\n"
       "0,<img src=x onerror=alert(2)>,0.4,1,2,1.5,0.16,ok\n"
       "1,\"b & \"\"c\"\"\",0.2,0.5,1,0.7,0.04,ok\n"
       "2,\xff\xfe,0.1,0.2,0.4,0.3,0.01,ok\n"
       "3,d,nan,nan,nan,nan,nan,invalid-layout\n";
  std::ofstream(folder / "failures.csv")
    << "Index,Mesh,Stage,Status,Message\n3,d,mesh,invalid-layout,\"Polygons <0> & <1> cross.\"\n";
  std::ofstream(folder / "findings.csv")
    << "Performance,Metric,Rank,N,Words,Sentence,Joint\n"
       "run_error,Area_min,1,3,strong positive,\"Area_min: <strong> positive.\",No joint model.\n";
  std::ofstream(folder / "correlation.csv") << "X,Y,Words\nArea_min,run_error,strong positive\n";
  std::ofstream(folder / "findings.txt") << "run_error (3 rows)\n\nNote: a <note>.\n";
  return folder;
}

using Visitor = std::function<void(vtkXMLDataElement*)>;

void Visit(vtkXMLDataElement* element, const Visitor& visitor)
{
  visitor(element);
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    Visit(element->GetNestedElement(i), visitor);
  }
}

/** Parses the page as XML, and checks what every page must hold. */
void CheckPage(const std::string& page)
{
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(page.c_str()));
  ASSERT_NE(root, nullptr) << "not well-formed";
  EXPECT_STREQ(root->GetName(), "html");
  EXPECT_STREQ(root->GetAttribute("lang"), "en");
  std::set<std::string> ids;
  std::vector<std::string> targets;
  int headings = 0;
  Visit(root,
    [&](vtkXMLDataElement* element)
    {
      const std::string name = element->GetName();
      if (const char* id = element->GetAttribute("id"))
      {
        EXPECT_TRUE(ids.insert(id).second) << id;
      }
      if (name == "img")
      {
        ASSERT_NE(element->GetAttribute("alt"), nullptr);
        EXPECT_GT(std::string(element->GetAttribute("alt")).size(), 10U);
        EXPECT_EQ(std::string(element->GetAttribute("src")).rfind("data:image/", 0), 0U);
      }
      if (name == "a")
      {
        const std::string target = element->GetAttribute("href");
        EXPECT_EQ(target.front(), '#') << "nothing outside the page";
        targets.push_back(target.substr(1));
      }
      if (name == "table")
      {
        ASSERT_GT(element->GetNumberOfNestedElements(), 0);
        EXPECT_STREQ(element->GetNestedElement(0)->GetName(), "caption");
      }
      headings += name == "h1" ? 1 : 0;
      EXPECT_NE(name, "link");
      EXPECT_NE(name, "iframe");
    });
  EXPECT_EQ(headings, 1);
  for (const std::string& target : targets)
  {
    EXPECT_TRUE(ids.count(target)) << target;
  }
  EXPECT_THAT(page, HasSubstr("@media print"));
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_LT(page.size(), 2000000U);
}

TEST(Report, OfAStudyHoldsAllOfIt)
{
  const fs::path folder = pages::RunSmallStudy("small-study");
  const std::string page = pages::Page(folder);
  CheckPage(page);
  for (const char* text : { "What was run", "First mesh, 000_0.000000", "Middle mesh, 002_",
         "Last mesh, 005_0.800000", "Metrics", "Nothing failed.", "Methods and words", "Swept: t",
         "0 to 0.8, 6 values", "Seed of statistics" })
  {
    EXPECT_THAT(page, HasSubstr(text));
  }
  EXPECT_EQ(page, pages::Page(folder)) << "the same bytes every time";
}

TEST(Report, TakesNothingOfAUserForMarkup)
{
  const fs::path folder = WriteHostileFolder("hostile");
  const std::string page = pages::Page(folder);
  CheckPage(page);
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)&lt;script&gt; &amp; &quot;quotes&quot;"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert(1)")));
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, HasSubstr("Polygons &lt;0&gt; &amp; &lt;1&gt; cross."));
  EXPECT_THAT(page, HasSubstr("1 failure"));
  EXPECT_THAT(page, HasSubstr("a solver is not known here"));
  EXPECT_THAT(page, HasSubstr("No mesh is shown"));
  EXPECT_THAT(page, HasSubstr("Area_min: &lt;strong&gt; positive."));
}

TEST(Report, TellsTheObservedOrder)
{
  // The error is the square of the mesh size.
  const std::string page = pages::Page(WriteHostileFolder("order"));
  EXPECT_THAT(page, HasSubstr("The mesh size varies from 0.1 to 0.4."));
  EXPECT_THAT(page, HasSubstr(">run_error</td>\n<td class=\"number\">2</td>"));
}

/** One performance of two runs: one chart with a colour each, and not one chart each. */
TEST(Report, ComparesSolversAndShowsTheHeatMap)
{
  const fs::path folder = pemesh::TestFolder("two-solvers");
  std::ofstream(folder / "study.json") << R"({"pemesh": 1, "name": "two", "meshes": ["*.off"],
    "style": {"palette": "ibm"},
    "solvers": [{"solver": "pemesh-vem", "name": "low"}, {"solver": "pemesh-vem", "name": "high"}]})";
  std::ofstream results(folder / "results.csv");
  results << "Index,Mesh,MeshSize,Area_min,Area_max,Area_mean,low_error,high_error,low_dofs\n";
  for (int i = 0; i < 8; ++i)
  {
    results << i << ",m" << i << ",0.3," << 1 + i << "," << 2 + i << "," << 1.5 + i << ","
            << 1.0 / (1 + i) << "," << 0.1 / (1 + i * i) << "," << 100 + i % 3 << "\n";
  }
  results.close();
  std::ofstream findings(folder / "findings.csv");
  findings << "Performance,Metric,Rank,N,Words,Sentence,Joint\n";
  for (const char* run : { "low_error", "low_dofs", "high_error" })
  {
    findings << run << ",Area_min,1,8,strong,s,j\n" << run << ",Area_max,2,8,strong,s,j\n";
  }
  findings.close();
  const std::string page = pages::Page(folder);
  CheckPage(page);
  EXPECT_THAT(page, HasSubstr("Heat map of a matrix of correlation"));
  EXPECT_THAT(page, HasSubstr("Scatter chart coloured by solver"));
  EXPECT_THAT(page, HasSubstr("low from 0.13 to 1; high from 0.002 to 0.1"));
  const auto place = [&page](const char* run)
  { return page.find(run, page.find("Heat map of a matrix of correlation")); };
  EXPECT_LT(place("<h3>high_error</h3>"), place("degrees of freedom, low</h3>"))
    << "the same performance of all solvers together";
  EXPECT_EQ(page.find("<p>j</p>"), page.rfind("<p>j</p>")) << "what is the same is said once";
  EXPECT_NE(page.find("<p>j</p>"), std::string::npos);
  EXPECT_THAT(page, HasSubstr("%23648fff")) << "the first colour of the palette of the study";
}

TEST(Report, OfWhatIsNoStudyIsASentence)
{
  const fs::path folder = pemesh::TestFolder("nothing");
  EXPECT_THAT(pages::Page(folder), HasSubstr("does not hold the results of a study"));
  EXPECT_FALSE(fs::exists(folder / "report.html"));
  std::ofstream(folder / "study.json") << R"({"pemesh": 1, "name": "e", "meshes": ["a.off"]})";
  std::ofstream(folder / "results.csv") << "Index,Mesh\n";
  CheckPage(pages::Page(folder));
}

} // namespace
