// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFile.h"

#include "StudyTexts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

/** A bad document and the sentence that it earns. */
struct BadStudy
{
  const char* Text;
  const char* Sentence; // after "\"s.json\": " unless it starts with a quote
};

void PrintTo(const BadStudy& study, std::ostream* stream)
{
  *stream << study.Text;
}

std::string Polygons(const std::string& rest)
{
  return R"({"pemesh": 1, "polygons": [{"family": "comb"}], )" + rest + "}";
}

std::string ComplaintAbout(const std::string& text)
{
  return Complaint([&] { pemesh::ParseStudy(text, "s.json"); });
}

class StudyMessages : public testing::TestWithParam<BadStudy>
{
};

TEST_P(StudyMessages, AreOneClearSentence)
{
  const std::string expected = GetParam().Sentence;
  EXPECT_EQ(ComplaintAbout(GetParam().Text),
    expected.front() == '"' ? expected : "\"s.json\": " + expected);
}

INSTANTIATE_TEST_SUITE_P(Document, StudyMessages,
  testing::Values(BadStudy{ "[]", "the document is [] where an object {…} is expected." },
    BadStudy{ "1", "the document is 1 where an object {…} is expected." },
    BadStudy{ "{}", "pemesh is missing (the number 1)." },
    BadStudy{ R"({"pemesh": 1})",
      "the document has neither polygons nor meshes nor mesh.source: place polygons in the domain, "
      "name mesh files, for example \"meshes\": \"folder/*.off\", or a source of meshes, for "
      "example "
      "\"mesh\": {\"source\": \"voronoi\"}." },
    BadStudy{ R"({"pemesh": 1, "polygns": []})", "polygns is not a key; did you mean polygons?" },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "meshes": "*.off"})",
      "the document has both polygons and meshes: a study makes its meshes or reads them." },
    BadStudy{ R"({"pemesh": 2, "polygons": []})",
      "pemesh is 2, a version of the document that this program does not know; it reads version "
      "1." },
    BadStudy{ R"({"pemesh": "1", "polygons": []})", "pemesh is \"1\" where a number is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "pemesh": 1})", "pemesh is given twice." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{}, {"family": "comb", "scale": 1, "scale": 2}]})",
      "polygons[1].scale is given twice." },
    BadStudy{ R"({"pemesh": 1, "mesh": {"max-area": {"rule": "none", "rule": "none"}}})",
      "mesh.max-area.rule is given twice." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "name": "a/b"})",
      "name is \"a/b\", which cannot name a file or a folder: use letters, digits, hyphens and "
      "blanks." }));

INSTANTIATE_TEST_SUITE_P(Polygon, StudyMessages,
  testing::Values(
    BadStudy{ R"({"pemesh": 1, "polygons": {}})", "polygons is {} where a list is expected." },
    BadStudy{
      R"({"pemesh": 1, "polygons": [1]})", "polygons[0] is 1 where an object {…} is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"center": [0.5, 0.5]}]})",
      "polygons[0].family is missing (one of comb, convexity, isotropy, maze, n-sided, star, "
      "u-like, zeta, random, file, points)." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comp"}]})",
      "polygons[0].family is \"comp\"; did you mean \"comb\"? (one of comb, convexity, isotropy, "
      "maze, n-sided, star, u-like, zeta, random, file, points)" },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "center": 0.5}]})",
      "polygons[0].center is 0.5 where a list is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "center": [0.5]}]})",
      "polygons[0].center is [0.5] where two numbers [x, y] are expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "center": [0.5, "a"]}]})",
      "polygons[0].center[1] is \"a\" where a number is expected." },
    BadStudy{
      R"({"pemesh": 1, "polygons": [{"family": "file"}]})", "polygons[0].file is missing (text)." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "file", "file": ""}]})",
      "polygons[0].file is empty: name a file." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "file": "a.off"}]})",
      "polygons[0].file does not apply here: it is a key of the family file." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "file", "file": "a.off", "to": 1}]})",
      "polygons[0].to does not apply here: it is a key of families that depend on t." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "points", "points": [[0, 0], [1, 0]]}]})",
      "polygons[0].points has 2 points; a polygon needs three." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "points", "points": [[0, 0], [1]]}]})",
      "polygons[0].points[1] is [1] where two numbers [x, y] are expected." },
    BadStudy{
      R"({"pemesh": 1, "polygons": [{"family": "points", "points": [[1, 1], [1, 1], [1, 1]]}]})",
      "polygons[0].points are too near or too far from each other." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "random", "seed": 0.5}]})",
      "polygons[0].seed is 0.5 where an integer is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "random", "tangle": 2}]})",
      "polygons[0].tangle is 2; it must be between 0 and 1." },
    BadStudy{ R"({"pemesh": 1, "scatter": {"families": ["file"]}})",
      "scatter.families is \"file\"; did you mean \"maze\"? (one of comb, convexity, isotropy, "
      "maze, n-sided, star, u-like, zeta, random)" },
    BadStudy{ R"({"pemesh": 1, "scatter": {"smallest-scale": 0.3}})",
      "scatter.smallest-scale is 0.3, which is more than largest-scale, 0.2." },
    BadStudy{ R"({"pemesh": 1, "scatter": {"seed": 1.5}})",
      "scatter.seed is 1.5 where an integer is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "scale": 0}]})",
      "polygons[0].scale is 0; it must be greater than 0." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "spikes": 3}]})",
      "polygons[0].spikes does not apply here: it is a key of the family star." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "maze", "teeth": 3}]})",
      "polygons[0].teeth does not apply here: it is a key of the family comb." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "teeth": 2.5}]})",
      "polygons[0].teeth is 2.5 where an integer is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "teeth": 0}]})",
      "polygons[0].teeth is 0; it must be between 1 and 100000." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "star", "spikes": 1}]})",
      "polygons[0].spikes is 1; it must be between 3 and 100000." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "to": 1.01}]})",
      "polygons[0].to is 1.01; it must be between 0 and 1." },
    BadStudy{ R"({"pemesh": 1, "polygons": [{"family": "comb", "rotation": "15"}]})",
      "polygons[0].rotation is \"15\" where a number is expected." }));

TEST(StudyMessages, OfTheMesh)
{
  EXPECT_EQ(ComplaintAbout(Polygons(R"("mesh": {"min-angel": 20})")),
    "\"s.json\": mesh.min-angel is not a key; did you mean min-angle?");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("mesh": {"min-angle": 34.5})")),
    "\"s.json\": mesh.min-angle is 34.5; it must be between 0 and 33.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("mesh": {"max-area": {"rule": "constant"}})")),
    "\"s.json\": mesh.max-area.value is missing (number greater than 0).");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("mesh": {"max-area": {"value": 1}})")),
    "\"s.json\": mesh.max-area.value does not apply here: it is a key of the rule constant.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("mesh": {"preserve-polygons": 1})")),
    "\"s.json\": mesh.preserve-polygons is 1 where true or false is expected.");
  EXPECT_EQ(ComplaintAbout(R"({"pemesh": 1, "meshes": "a.off", "domain": {}})"),
    "\"s.json\": domain does not apply here: it is a key of a study that makes its meshes, not of "
    "mesh files.");
  EXPECT_EQ(ComplaintAbout(R"({"pemesh": 1, "meshes": "a.off", "mesh": {"min-angle": 20}})"),
    "\"s.json\": mesh.min-angle does not apply here: it is a key of the source triangulation.");
  EXPECT_THAT(ComplaintAbout(R"({"pemesh": 1, "meshes": "a.off", "mesh": {"source": "koch"}})"),
    testing::HasSubstr("the source files belongs to a study with meshes"));
  EXPECT_THAT(ComplaintAbout(Polygons(R"("mesh": {"source": "koch"})")),
    testing::HasSubstr("mesh.source is \"koch\", which takes no polygons"));
  EXPECT_THAT(ComplaintAbout(R"({"pemesh": 1, "mesh": {"source": "koch", "cells": 3}})"),
    testing::HasSubstr("mesh.cells does not apply here: it is a key of the source"));
  EXPECT_EQ(ComplaintAbout(R"({"pemesh": 1, "mesh": {"source": "koch", "depth": 2.5}})"),
    "\"s.json\": mesh.depth is 2.5 where an integer is expected.");
  EXPECT_THAT(ComplaintAbout(Polygons(R"("mesh": {"tile": [1, 2, 3]})")),
    testing::HasSubstr("mesh.tile is [1, 2, 3] where two integers [columns, rows] are expected"));
  EXPECT_EQ(ComplaintAbout(Polygons(R"("mesh": {"agglomerate": {"percentage": 10}})")),
    "\"s.json\": mesh.agglomerate.percentage does not apply here: it is a key of rules other than "
    "none.");
  EXPECT_THAT(ComplaintAbout(Polygons(
                R"("mesh": {"agglomerate": {"rule": "metis", "elements": 9, "percentage": 5}})")),
    testing::HasSubstr("say one of them"));
  EXPECT_THAT(ComplaintAbout(Polygons(R"("mesh": {"target": {"quantity": "dofs"}})")),
    testing::HasSubstr("mesh.target.value is missing"));
  EXPECT_EQ(ComplaintAbout(R"({"pemesh": 1, "meshes": []})"),
    "\"s.json\": meshes is []: name files, or a pattern such as \"folder/*.off\".");
}

TEST(StudyMessages, OfTheSweep)
{
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{"parameter": "order"}])")),
    "\"s.json\": sweep[0].parameter is \"order\", which cannot be swept; sweep t, or a value by "
    "its "
    "path, such as \"mesh.min-angle\" (it begins with domain, polygons, scatter, mesh, solvers).");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{"count": 0}])")),
    "\"s.json\": sweep[0].count is 0; it must be between 1 and 10000000.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{"from": 0.5, "to": 0.2}])")),
    "\"s.json\": sweep[0].from is 0.5, which is more than to, 0.2.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{"to": 1.5}])")),
    "\"s.json\": sweep[0].to is 1.5; it must be between 0 and 1.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{"values": [0, 2]}])")),
    "\"s.json\": sweep[0].values[1] is 2; it must be between 0 and 1.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{"values": [0], "count": 3}])")),
    "\"s.json\": sweep[0].count does not apply here: it is a key of a sweep without values.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("sweep": [{}, {}])")),
    "\"s.json\": sweep[1].parameter is \"t\", which is swept already.");
}

TEST(StudyMessages, OfMetricsSolversAndOutput)
{
  EXPECT_EQ(ComplaintAbout(Polygons(R"("metrics": ["MinAngel"])")),
    "\"s.json\": metrics names \"MinAngel\", which is no metric; did you mean \"MinAngle\"?");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("metrics": ["Area", "Area"])")),
    "\"s.json\": metrics names \"Area\" twice.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("metrics": "al")")),
    "\"s.json\": metrics names \"al\", which is no metric; did you mean \"all\"?");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("metrics": ["KAR"])")),
    "\"s.json\": metrics names \"KAR\", which is no metric; did you mean \"KernelAreaRatio\"?");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("solvers": [{}])")),
    "\"s.json\": solvers[0].solver is missing (text).");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("solvers": [{"solver": "a", "x": [1]}])")),
    "\"s.json\": solvers[0].x is [1] where a text, a number, true or false is expected.");
  EXPECT_EQ(ComplaintAbout(Polygons(
              R"("solvers": [{"solver": "a", "name": "x"}, {"solver": "b", "name": "x"}])")),
    "\"s.json\": solvers[1].name is \"x\", the name of another run: runs need different names.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("solvers": [{"solver": "a", "name": "../x"}])")),
    "\"s.json\": solvers[0].name is \"../x\", which cannot name a file or a folder: use letters, "
    "digits, hyphens and blanks.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("solvers": [{"solver": "a", "time-limit": -1}])")),
    "\"s.json\": solvers[0].time-limit is -1; it must be at least 0.");
  EXPECT_THAT(ComplaintAbout(Polygons(R"("output": {"formats": ["offf"]})")),
    testing::StartsWith("\"s.json\": output.formats is \"offf\"; did you mean \"off\"? (one of "));
  EXPECT_EQ(ComplaintAbout(Polygons(R"("output": {"formats": ["off", "off"]})")),
    "\"s.json\": output.formats names \"off\" twice.");
}

TEST(StudyMessages, OfPlots)
{
  EXPECT_EQ(ComplaintAbout(Polygons(R"("plots": [{"kind": "lines"}])")),
    "\"s.json\": plots[0].kind is \"lines\"; did you mean \"line\"? (one of line, scatter, "
    "small-multiples, scatter-matrix, correlation-matrix, histogram, box, violin, convergence, "
    "element-scatter, mesh, "
    "overview)");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("plots": [{"kind": "line"}])")),
    "\"s.json\": plots[0].y is missing (text or list of texts).");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("plots": [{"kind": "line", "y": []}])")),
    "\"s.json\": plots[0].y is empty: name at least one column.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("plots": [{"kind": "line", "y": ["a", 1]}])")),
    "\"s.json\": plots[0].y[1] is 1 where a text is expected.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("plots": [{"kind": "mesh", "x": "t"}])")),
    "\"s.json\": plots[0].x does not apply here: it is a key of the kinds line, scatter, "
    "small-multiples, correlation-matrix, convergence, element-scatter and "
    "overview.");
  EXPECT_EQ(ComplaintAbout(Polygons(R"("plots": [{"kind": "line", "y": "a", "log": "z"}])")),
    "\"s.json\": plots[0].log is \"z\"; did you mean \"x\"? (one of none, x, y, xy)");
  EXPECT_EQ(ComplaintAbout(Polygons(
              R"("plots": [{"kind": "mesh", "file": "a"}, {"kind": "mesh", "file": "a.png"}])")),
    "\"s.json\": plots[1].file is \"a.png\", the file of another plot.");
}

TEST(StudyMessages, SyntaxErrorsHaveLineAndColumn)
{
  EXPECT_THAT(ComplaintAbout(""), testing::StartsWith("\"s.json\", line 1, column 1: "));
  EXPECT_THAT(ComplaintAbout("{\n  \"pemesh\": 1,\n  }"),
    testing::StartsWith("\"s.json\", line 3, column 3: "));
  EXPECT_THAT(ComplaintAbout("{\"pemesh\": 1,\n\"polygons\": [1 2]}"),
    testing::StartsWith("\"s.json\", line 2, column 16: "));
  EXPECT_THAT(
    ComplaintAbout("{\"pemesh\": 1} x"), testing::StartsWith("\"s.json\", line 1, column 15: "));
  EXPECT_THAT(ComplaintAbout(R"({"pemesh": 1e999})"), testing::HasSubstr("number overflow"));
  EXPECT_THAT(ComplaintAbout(R"({"pemesh": NaN})"), testing::StartsWith("\"s.json\", line 1"));
  EXPECT_THAT(ComplaintAbout("{\"pemesh\": \"\xFF\"}"), testing::StartsWith("\"s.json\", line 1"));
  EXPECT_THAT(ComplaintAbout(std::string(100000, '[')), testing::HasSubstr("levels deep"));
}

INSTANTIATE_TEST_SUITE_P(Metrics, StudyMessages,
  testing::Values(BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": 3})",
                    "metrics is 3 where a list is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"name": "all"}})",
      "metrics.name is not a key; did you mean names?" },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"names": ["jumps", "MinAngel"]}})",
      "metrics.names names \"MinAngel\", which is no metric; did you mean \"MinAngle\"?" },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"mesh": ["Meshrho"]}})",
      "metrics.mesh names \"Meshrho\", which is no metric of a mesh; did you mean \"MeshRho\"?" },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"statistics": ["min", "meen"]}})",
      "metrics.statistics names \"meen\", which is no statistic; did you mean \"mean\"?" },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"statistics": ["min", "min"]}})",
      "metrics.statistics names \"min\" twice." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"groups": "triangle"}})",
      "metrics.groups names \"triangle\", which is no group of elements; did you mean "
      "\"triangles\"?" },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"quantiles": [0.5, 1.5]}})",
      "metrics.quantiles[1] is 1.5; it must be between 0 and 1." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"quantiles": "median"}})",
      "metrics.quantiles is \"median\" where a list is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"histogram": 1.5}})",
      "metrics.histogram is 1.5 where an integer is expected." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"groups": ["selected"]}})",
      "metrics.selection is missing (text)." },
    BadStudy{ R"({"pemesh": 1, "polygons": [], "metrics": {"selection": "MinAngle:0:1"}})",
      "metrics.selection does not apply here: it is a key of groups with selected." },
    BadStudy{
      R"({"pemesh": 1, "polygons": [], "metrics": {"groups": "selected", "selection": "MinAngle:1:0"}})",
      "metrics.selection is wrong. The selection \"MinAngle:1:0\" is empty: it begins at 1 and "
      "ends "
      "at 0." },
    BadStudy{
      R"({"pemesh": 1, "polygons": [], "metrics": {"groups": "selected", "selection": "MinAngle<1:"}})",
      "metrics.selection is wrong. The selection \"MinAngle<1:\" is not METRIC:FROM:TO: write it "
      "like MinAngle:0.1:0.5, or MinAngle::0.5 for all values up to 0.5." }));

} // namespace
