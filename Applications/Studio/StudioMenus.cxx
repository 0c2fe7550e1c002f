// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of the window.
#include "StudioWindow.h"

#include "Appearance.h"
#include "Icons.h"
#include "LogDock.h"
#include "MeshFormats.h"
#include "MeshPage.h"
#include "MetricRegistry.h"
#include "PanelView.h"
#include "PolygonTable.h"
#include "ResultSet.h"
#include "Session.h"
#include "StudyFile.h"
#include "StudyModel.h"
#include "StudyPreview.h"
#include "StyleDialog.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTextBrowser>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** The registry as text, with the formulas as they are written in plain text. */
QString DescribeMetricsInMarkdown()
{
  QString text;
  for (const Metric& metric : Metrics())
  {
    text += QStringLiteral("### %1\n\n`%2` = `%3`, in %4, unit %5. %6 *%7*\n\n")
              .arg(QString::fromUtf8(metric.Label), QString::fromUtf8(metric.Name),
                QString::fromUtf8(metric.Formula), QString::fromUtf8(metric.Range),
                QString::fromUtf8(metric.Unit), QString::fromUtf8(metric.Description),
                QString::fromUtf8(metric.Reference));
  }
  return text;
}

} // namespace

QAction* StudioWindow::AddAction(
  QMenu* menu, const char* icon, const QString& text, const QKeySequence& key)
{
  QAction* action = menu->addAction(MakeIcon(icon), text);
  action->setShortcut(key);
  return action;
}

void StudioWindow::MakeMenus()
{
  this->MakeFileMenu();
  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  edit->addAction(this->UndoAction);
  edit->addAction(this->RedoAction);
  edit->addSeparator();
  edit->addActions(this->Meshes->GetEditActions());
  this->MakeViewMenu();
  QMenu* run = this->menuBar()->addMenu(tr("&Run"));
  run->addAction(this->RunAction);
  connect(this->AddAction(run, "solver", tr("Run with the default &solver"), {}),
    &QAction::triggered, this, &StudioWindow::RunWithSolver);
  run->addAction(this->RunSomeAction);
  run->addSeparator();
  run->addAction(this->PauseAction);
  run->addAction(this->StopAction);
  run->addAction(this->CancelAction);
  this->MakeHelpMenu();
}

void StudioWindow::MakeFileMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&File"));
  connect(this->AddAction(menu, "new", tr("&New study"), {}), &QAction::triggered, this->Files,
    &Session::MakeNew);
  connect(this->AddAction(menu, "open", tr("&Open study …"), {}), &QAction::triggered, this->Files,
    &Session::Open);
  connect(
    this->AddAction(menu, "mesh", tr("Open &meshes …"), QKeySequence(QStringLiteral("Ctrl+M"))),
    &QAction::triggered, this->Files, &Session::OpenMeshes);
  QMenu* recent = menu->addMenu(tr("&Recent studies"));
  connect(
    recent, &QMenu::aboutToShow, this, [this, recent] { this->Files->FillRecentMenu(recent); });
  connect(this->AddAction(menu, "table", tr("Open res&ults …"), {}), &QAction::triggered, this,
    &StudioWindow::OpenResults);
  menu->addSeparator();
  menu->addAction(this->SaveAction);
  connect(this->AddAction(menu, "save", tr("Save study &as …"), QKeySequence::SaveAs),
    &QAction::triggered, this->Files, &Session::SaveAs);
  this->SaveMeshAction = this->AddAction(menu, "export", tr("Save m&esh …"), {});
  connect(this->SaveMeshAction, &QAction::triggered, this, &StudioWindow::SaveMesh);
  connect(this->AddAction(menu, "export", tr("Save &polygons as a table …"), {}),
    &QAction::triggered, this, &StudioWindow::SavePolygons);
  menu->addSeparator();
  connect(this->AddAction(menu, "cancel", tr("&Quit"), QKeySequence::Quit), &QAction::triggered,
    this, &QWidget::close);
}

void StudioWindow::MakeViewMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&View"));
  menu->addAction(this->Log->toggleViewAction());
  this->Log->toggleViewAction()->setShortcut(QKeySequence(QStringLiteral("Ctrl+L")));
  connect(this->AddAction(menu, "palette", tr("&Plot settings …"), {}), &QAction::triggered, this,
    &StudioWindow::ShowPlotSettings);
  QMenu* theme = menu->addMenu(tr("&Theme"));
  auto* group = new QActionGroup(this);
  const QString names[] = { tr("As the system"), tr("Light"), tr("Dark") };
  const int chosen = QSettings().value(QStringLiteral("theme")).toInt();
  for (int i = 0; i < 3; ++i)
  {
    QAction* action = theme->addAction(names[i]);
    action->setCheckable(true);
    action->setChecked(i == chosen);
    group->addAction(action);
    connect(action, &QAction::triggered, this,
      [i]
      {
        QSettings().setValue(QStringLiteral("theme"), i);
        ApplyTheme(*qApp, static_cast<ThemeChoice>(i));
      });
  }
}

void StudioWindow::MakeHelpMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&Help"));
  connect(menu->addAction(tr("Reference of the &metrics")), &QAction::triggered, this,
    [this] { this->ShowReference(tr("Metrics"), DescribeMetricsInMarkdown()); });
  connect(menu->addAction(tr("Reference of the &study document")), &QAction::triggered, this,
    [this]
    {
      this->ShowReference(tr("The keys of a study"),
        QStringLiteral("- ") +
          QString::fromStdString(DescribeStudyKeys()).trimmed().replace("\n", "\n- "));
    });
  menu->addSeparator();
  connect(menu->addAction(tr("&About PEMesh Studio")), &QAction::triggered, this,
    &StudioWindow::ShowAbout);
  connect(menu->addAction(tr("About &Qt")), &QAction::triggered, qApp, &QApplication::aboutQt);
}

void StudioWindow::SaveMesh()
{
  const MeshPicturePointer picture = this->Preview->GetPicture();
  const QString file =
    QFileDialog::getSaveFileName(this, tr("Save mesh"), QStringLiteral("mesh.off"),
      tr("Meshes (%1)").arg(QString::fromStdString(ListMeshExtensions("*"))));
  if (file.isEmpty() || !picture)
  {
    return;
  }
  try
  {
    WriteMesh(file.toStdString(), picture->GetMesh());
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this, tr("Save mesh"), QString::fromUtf8(error.what()));
  }
}

void StudioWindow::SavePolygons()
{
  const QString file = QFileDialog::getSaveFileName(
    this, tr("Save polygons"), QStringLiteral("polygons.csv"), tr("Tables (*.csv)"));
  try
  {
    if (!file.isEmpty())
    {
      WritePolygonTable(file.toStdString(), this->Model->GetStudy().Polygons);
    }
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this, tr("Save polygons"), QString::fromUtf8(error.what()));
  }
}

void StudioWindow::ShowPlotSettings()
{
  auto* dialog = new StyleDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &StyleDialog::Changed, this,
    [this]
    {
      for (PanelView* view : this->findChildren<PanelView*>())
      {
        view->Refresh();
      }
    });
  dialog->show();
}

void StudioWindow::ShowReference(const QString& title, const QString& markdown)
{
  auto* browser = new QTextBrowser(this);
  browser->setWindowFlag(Qt::Window);
  browser->setAttribute(Qt::WA_DeleteOnClose);
  browser->setWindowTitle(title);
  browser->setOpenExternalLinks(true);
  browser->setMarkdown(markdown);
  browser->resize(820, 720);
  browser->show();
}

void StudioWindow::OpenResults()
{
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Results of a study"));
  if (!folder.isEmpty() && this->Files->OpenFiles({ folder + QStringLiteral("/study.json") }))
  {
    this->Results->Load(folder);
    this->ShowPage(GeometryPageIndex);
  }
}

void StudioWindow::ShowAbout()
{
  QMessageBox::about(this, tr("About PEMesh Studio"),
    tr("<h3>PEMesh Studio %1</h3><p>How the geometry of polygonal meshes affects polytopal element "
       "methods.</p><p>Free software under the GNU General Public License, version 3 or later. It "
       "uses Qt, VTK, CGAL, Eigen, SuiteSparse, METIS, Boost, Cairo and nlohmann-json, each under "
       "a licence of its own.</p>")
      .arg(QCoreApplication::applicationVersion()));
}

} // namespace pemesh
