// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The window for those who do not see it, have no mouse or read another language.
#include "CorrelationPage.h"
#include "FamilyGallery.h"
#include "GeometryPage.h"
#include "LayoutCanvas.h"
#include "MeshChoiceDialog.h"
#include "MeshPage.h"
#include "OptionForm.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "RunController.h"
#include "Selection.h"
#include "SolverPage.h"
#include "StudioFixture.h"
#include "StudioSupport.h"
#include "StudyModel.h"
#include "StudyPreview.h"
#include "StyleDialog.h"
#include "TestFolder.h"

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

#include <algorithm>

using namespace pemesh;
using studio_test::WaitFor;
using testing::IsEmpty;

namespace
{

using StudioAccess = studio_test::Studio;

/** What a user reaches by himself, rather than a part of it. */
bool IsControl(const QWidget* widget)
{
  const QWidget* parent = widget->parentWidget();
  const bool isPart = qobject_cast<const QHeaderView*>(widget) ||
    qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QAbstractSpinBox*>(parent) ||
    qobject_cast<const QComboBox*>(parent) || qobject_cast<const QTabBar*>(parent) ||
    qobject_cast<const QLineEdit*>(parent) ||
    (parent && qobject_cast<const QComboBox*>(parent->parentWidget())) ||
    qobject_cast<const QAbstractItemView*>(parent) || // the button in the corner of a table
    widget->objectName().startsWith("qt_");
  return !isPart &&
    (qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
      qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
      qobject_cast<const QAbstractSlider*>(widget) ||
      qobject_cast<const QAbstractItemView*>(widget) ||
      qobject_cast<const QPlainTextEdit*>(widget) || qobject_cast<const PlaneView*>(widget) ||
      qobject_cast<const PanelView*>(widget));
}

std::string Describe(const QWidget* widget)
{
  std::string text;
  for (; widget; widget = widget->parentWidget())
  {
    text += std::string(widget->metaObject()->className()) + "(" +
      widget->objectName().toStdString() + ") ";
  }
  return text;
}

std::vector<std::string> Nameless(const QWidget& window)
{
  std::vector<std::string> nameless;
  for (QWidget* widget : window.findChildren<QWidget*>())
  {
    QAccessibleInterface* access =
      IsControl(widget) ? QAccessible::queryAccessibleInterface(widget) : nullptr;
    if (access && access->text(QAccessible::Name).trimmed().isEmpty())
    {
      nameless.push_back(Describe(widget));
    }
  }
  return nameless;
}

/** Every text of the window in brackets. */
class Brackets : public QTranslator
{
public:
  QString translate(const char*, const char* source, const char*, int) const override
  {
    return QStringLiteral("«") + QString::fromUtf8(source) + QStringLiteral("»");
  }
  bool isEmpty() const override { return false; }
};

bool IsData(const QWidget* widget)
{
  for (const QWidget* at = widget; at; at = at->parentWidget())
  {
    if (qobject_cast<const OptionForm*>(at) || qobject_cast<const QComboBox*>(at) ||
      qobject_cast<const FamilyGallery*>(at))
    {
      return true; // keys, choices and families, which are what documents say
    }
  }
  return false;
}

/** The texts that are not translated. */
class Untranslated
{
public:
  explicit Untranslated(const QWidget& window)
  {
    for (const QWidget* widget : window.findChildren<QWidget*>())
    {
      if (!IsData(widget))
      {
        this->Check(*widget);
      }
    }
    for (const QAction* action : window.findChildren<QAction*>())
    {
      this->Check(action->text());
      this->Check(action->toolTip());
    }
  }

  std::vector<std::string> Texts;

private:
  void Check(const QString& text)
  {
    const bool isWord = std::any_of(text.begin(), text.end(), [](QChar c) { return c.isLetter(); });
    const bool isFormula = text.startsWith(QStringLiteral("t = "));
    if (isWord && !isFormula && !text.contains(QStringLiteral("«")))
    {
      this->Texts.push_back(text.toStdString());
    }
  }

  void Check(const QWidget& widget)
  {
    this->Check(widget.toolTip());
    this->Check(widget.accessibleName());
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    {
      this->Check(button->text());
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
    {
      this->Check(label->text());
    }
    if (const auto* edit = qobject_cast<const QLineEdit*>(&widget))
    {
      this->Check(edit->placeholderText());
    }
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget))
    {
      for (int i = 0; i < bar->count(); ++i)
      {
        this->Check(bar->tabText(i));
      }
    }
  }
};

void Press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
  QWidget* focus = QApplication::focusWidget();
  ASSERT_NE(focus, nullptr);
  QTest::keyClick(focus, key, modifiers);
}

/** With Tab alone. */
testing::AssertionResult GoTo(const QWidget* wanted)
{
  for (int i = 0; i < 300 && QApplication::focusWidget(); ++i)
  {
    if (QApplication::focusWidget() == wanted)
    {
      return testing::AssertionSuccess();
    }
    Press(Qt::Key_Tab);
  }
  return testing::AssertionFailure() << "it ends at " << Describe(QApplication::focusWidget());
}

/** With Ctrl and a number; the button is seen to be pressed first. */
bool OpenPage(Qt::Key key, const QWidget* page)
{
  Press(key, Qt::ControlModifier);
  return WaitFor([page] { return page->isVisible(); });
}

} // namespace

TEST_F(StudioAccess, EveryControlHasAName)
{
  this->AddFamily("family-star");
  this->Window.GetModel()->AddItem(
    "solvers", { JsonValue::Object{ { "solver", { std::string("pemesh-vem") } } } }, "solver");
  EXPECT_THAT(Nameless(this->Window), IsEmpty());
  const StyleDialog style(this->Window.GetModel());
  EXPECT_THAT(Nameless(style), IsEmpty());
  const MeshChoiceDialog choice(this->Window.GetModel()->GetStudy(), {});
  EXPECT_THAT(Nameless(choice), IsEmpty());
}

TEST(StudioLanguage, EveryTextCanBeTranslated)
{
  Brackets brackets;
  QApplication::installTranslator(&brackets);
  {
    StudioWindow window;
    EXPECT_THAT(Untranslated(window).Texts, IsEmpty());
    const MeshChoiceDialog choice(window.GetModel()->GetStudy(), {});
    EXPECT_THAT(Untranslated(choice).Texts, IsEmpty());
  }
  QApplication::removeTranslator(&brackets);
}

TEST_F(StudioAccess, TheWholePathIsWalkedWithKeysAlone)
{
  const std::filesystem::path folder = pemesh::TestFolder("keys");
  StudyModel* model = this->Window.GetModel();
  model->SetValue("name", { std::string("keys") }, "name");
  model->Save(QString::fromStdString((folder / "keys.json").string()));
  this->Window.activateWindow();
  ASSERT_TRUE(WaitFor([] { return QApplication::focusWidget() != nullptr; }));
  // a star, moved to the right
  ASSERT_TRUE(GoTo(this->Find<QToolButton>("family-star")));
  Press(Qt::Key_Space);
  ASSERT_EQ(model->GetStudy().Polygons.size(), 1U);
  ASSERT_TRUE(this->WaitForMesh());
  LayoutCanvas* canvas = this->Window.GetMeshPage()->GetCanvas();
  ASSERT_TRUE(
    WaitFor([this] { return !this->Window.GetPreview()->GetOutlines().Polygons.empty(); }));
  ASSERT_TRUE(GoTo(canvas));
  Press(Qt::Key_Right);
  EXPECT_GT(model->GetStudy().Polygons[0].Center[0], 0.5);
  model->SetValue("sweep[0].count", JsonNumber(4), "count");
  // a solver, and a run
  ASSERT_TRUE(OpenPage(Qt::Key_3, this->Find<SolverPage>()));
  ASSERT_TRUE(GoTo(this->Find<QPushButton>("addSolver")));
  Press(Qt::Key_Space);
  ASSERT_EQ(model->GetStudy().Solvers.size(), 1U);
  Press(Qt::Key_F5);
  const RunController* controller = this->Window.GetController();
  ASSERT_TRUE(WaitFor([&] { return controller->IsRunning(); }));
  ASSERT_TRUE(WaitFor(
    [&] { return this->Window.GetResults()->GetFolder() == controller->GetOutput(); }, 120000))
    << this->GetLogText();
  // an element of the table
  auto* geometry = this->Find<GeometryPage>();
  ASSERT_TRUE(OpenPage(Qt::Key_2, geometry));
  ASSERT_TRUE(WaitFor([=] { return geometry->GetTable()->model()->rowCount() > 0; }));
  ASSERT_TRUE(GoTo(geometry->GetTable()));
  Press(Qt::Key_Down);
  EXPECT_GE(this->Window.GetSelection()->GetElement(), 0);
  // what drives what
  auto* correlation = this->Find<CorrelationPage>();
  ASSERT_TRUE(OpenPage(Qt::Key_4, correlation));
  ASSERT_TRUE(GoTo(correlation->GetFindings()));
  const int before = correlation->GetFindings()->currentRow();
  Press(Qt::Key_Down);
  EXPECT_GT(correlation->GetFindings()->currentRow(), before);
  ASSERT_TRUE(GoTo(correlation->GetChart()));
}
