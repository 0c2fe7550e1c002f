// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "NumberEdit.h"
#include "OptionForm.h"
#include "StudioSupport.h"
#include "StudyForm.h"
#include "StudyModel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QTest>
#include <QUndoStack>

using namespace pemesh;

namespace
{

template <typename Editor>
Editor* Find(const OptionForm& form, const char* path)
{
  return form.findChild<Editor*>(QString::fromLatin1(path));
}

} // namespace

TEST(OptionForm, HasAnEditorForEveryKeyThatApplies)
{
  StudyModel model;
  OptionForm form(&model);
  form.SetPath("mesh");
  const std::vector<FormField> fields = DescribeStudyForm(model.GetStudy(), "mesh");
  ASSERT_GT(fields.size(), 8U);
  for (const FormField& field : fields)
  {
    QWidget* editor = Find<QWidget>(form, field.Path.c_str());
    ASSERT_NE(editor, nullptr) << field.Path;
    EXPECT_FALSE(editor->accessibleName().isEmpty()) << field.Path;
    EXPECT_TRUE(editor->toolTip().contains(QString::fromStdString(field.Doc).toHtmlEscaped()));
  }
  EXPECT_EQ(Find<QWidget>(form, "mesh.cells"), nullptr) << "a key of another source";
}

TEST(OptionForm, AChoiceBringsItsOwnKeysAndTakesAwayThoseOfTheOther)
{
  StudyModel model;
  OptionForm form(&model);
  form.SetPath("mesh");
  Find<QComboBox>(form, "mesh.max-area.rule")->setCurrentText("constant");
  EXPECT_TRUE(model.GetFault().isEmpty()) << model.GetFault().toStdString();
  auto* value = Find<NumberEdit>(form, "mesh.max-area.value");
  ASSERT_NE(value, nullptr);
  value->setValue(0.003);
  EXPECT_EQ(model.GetStudy().Mesh.MaximumArea.Value, 0.003);
  Find<QComboBox>(form, "mesh.max-area.rule")->setCurrentText("diagonal");
  EXPECT_TRUE(model.GetFault().isEmpty()) << model.GetFault().toStdString();
  Find<QComboBox>(form, "mesh.source")->setCurrentText("voronoi");
  EXPECT_TRUE(model.GetFault().isEmpty()) << model.GetFault().toStdString();
  QTest::qWait(10);
  auto* cells = Find<NumberEdit>(form, "mesh.cells");
  ASSERT_NE(cells, nullptr);
  cells->setValue(33);
  EXPECT_EQ(model.GetStudy().Mesh.Parameters.front().second, 33.0);
  while (model.GetUndoStack()->canUndo())
  {
    model.GetUndoStack()->undo();
    EXPECT_TRUE(model.GetFault().isEmpty()) << model.GetFault().toStdString();
  }
  EXPECT_EQ(model.GetStudy().Mesh.Source, "triangulation");
}

TEST(OptionForm, RangesAreThoseOfTheTables)
{
  StudyModel model;
  OptionForm form(&model);
  form.SetPath("mesh");
  const auto* angle = Find<NumberEdit>(form, "mesh.min-angle");
  EXPECT_EQ(angle->minimum(), 0.0);
  EXPECT_EQ(angle->maximum(), 33.0);
  EXPECT_EQ(angle->text(), "20");
  Find<QCheckBox>(form, "mesh.preserve-polygons")->click();
  EXPECT_TRUE(model.GetStudy().Mesh.PreservePolygons);
}

TEST(NumberEdit, ShowsNumbersAsTheDocumentHasThem)
{
  NumberEdit edit;
  for (const char* text : { "0.1", "0.4263157894736842", "1e-09", "-3", "1234567" })
  {
    edit.setValue(QString(text).toDouble());
    EXPECT_EQ(edit.text().toStdString(), text);
  }
}
