// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudioMenus.h"

#include "Icons.h"
#include "LogDock.h"
#include "MeshFormats.h"
#include "MeshPage.h"
#include "MetricRegistry.h"
#include "PanelView.h"
#include "PlotStyle.h"
#include "PolygonTable.h"
#include "Preferences.h"
#include "PreferencesDialog.h"
#include "ResultSet.h"
#include "RunDesk.h"
#include "Session.h"
#include "StudioWindow.h"
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

StudioMenus::StudioMenus(StudioWindow* window, const SharedActions& shared)
  : QObject(window)
  , Window(window)
{
  this->MakeFileMenu(shared.Save);
  this->MakeEditMenu(shared);
  this->MakeViewMenu();
  this->MakeRunMenu();
  this->MakeHelpMenu();
  connect(window->GetModel(), &StudyModel::Changed, this, &StudioMenus::UseStyleOfStudy);
  this->UseStyleOfStudy();
}

QMenu* StudioMenus::AddMenu(const QString& title)
{
  return this->Window->menuBar()->addMenu(title);
}

QAction* StudioMenus::AddAction(
  QMenu* menu, const char* icon, const QString& text, const QKeySequence& key)
{
  QAction* action = menu->addAction(MakeIcon(icon), text);
  action->setShortcut(key);
  return action;
}

void StudioMenus::MakeEditMenu(const SharedActions& shared)
{
  QMenu* menu = this->AddMenu(tr("&Edit"));
  menu->addAction(shared.Undo);
  menu->addAction(shared.Redo);
  menu->addSeparator();
  menu->addActions(this->Window->GetMeshPage()->GetEditActions());
  menu->addSeparator();
  connect(
    this->AddAction(menu, "palette", tr("Pre&ferences …"), QKeySequence(QStringLiteral("Ctrl+,"))),
    &QAction::triggered, this, &StudioMenus::ShowPreferences);
}

void StudioMenus::MakeRunMenu()
{
  QMenu* menu = this->AddMenu(tr("&Run"));
  const RunDesk* runs = this->Window->GetRuns();
  for (int type = 0; type < RunDesk::NumberOfActions; ++type)
  {
    if (type == RunDesk::Pause)
    {
      menu->addSeparator();
    }
    menu->addAction(runs->GetAction(static_cast<RunDesk::ActionType>(type)));
  }
}

void StudioMenus::MakeFileMenu(QAction* save)
{
  Session* files = this->Window->GetSession();
  QMenu* menu = this->AddMenu(tr("&File"));
  connect(this->AddAction(menu, "new", tr("&New study"), {}), &QAction::triggered, files,
    &Session::MakeNew);
  connect(this->AddAction(menu, "open", tr("&Open study …"), {}), &QAction::triggered, files,
    &Session::Open);
  connect(
    this->AddAction(menu, "mesh", tr("Open &meshes …"), QKeySequence(QStringLiteral("Ctrl+M"))),
    &QAction::triggered, files, &Session::OpenMeshes);
  QMenu* recent = menu->addMenu(tr("&Recent studies"));
  connect(recent, &QMenu::aboutToShow, this, [files, recent] { files->FillRecentMenu(recent); });
  connect(this->AddAction(menu, "table", tr("Open res&ults …"), {}), &QAction::triggered, this,
    &StudioMenus::OpenResults);
  menu->addSeparator();
  menu->addAction(save);
  connect(this->AddAction(menu, "save", tr("Save study &as …"), QKeySequence::SaveAs),
    &QAction::triggered, files, &Session::SaveAs);
  QAction* mesh = this->AddAction(menu, "export", tr("Save m&esh …"), {});
  connect(mesh, &QAction::triggered, this, &StudioMenus::SaveMesh);
  connect(this->Window->GetPreview(), &StudyPreview::PictureChanged, mesh,
    [this, mesh] { mesh->setEnabled(this->Window->GetPreview()->GetPicture() != nullptr); });
  connect(this->AddAction(menu, "export", tr("Save &polygons as a table …"), {}),
    &QAction::triggered, this, &StudioMenus::SavePolygons);
  menu->addSeparator();
  connect(this->AddAction(menu, "cancel", tr("&Quit"), QKeySequence::Quit), &QAction::triggered,
    this->Window, &QWidget::close);
}

void StudioMenus::MakeViewMenu()
{
  QMenu* menu = this->AddMenu(tr("&View"));
  QAction* log = this->Window->GetLog()->toggleViewAction();
  log->setShortcut(QKeySequence(QStringLiteral("Ctrl+L")));
  menu->addAction(log);
  connect(this->AddAction(menu, "palette", tr("&Plot settings …"), {}), &QAction::triggered, this,
    &StudioMenus::ShowPlotSettings);
  this->MakeThemeMenu(menu->addMenu(tr("&Theme")));
}

void StudioMenus::MakeThemeMenu(QMenu* menu)
{
  auto* group = new QActionGroup(this);
  const QString names[] = { tr("As the system"), tr("Light"), tr("Dark") };
  for (int i = 0; i < 3; ++i)
  {
    QAction* action = menu->addAction(names[i]);
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this,
      [i]
      {
        SetPreference(ThemePreference, i);
        ApplyPreferences(*qApp);
      });
  }
  connect(menu, &QMenu::aboutToShow, this,
    [group] { group->actions()[GetPreference(ThemePreference)]->setChecked(true); });
}

void StudioMenus::MakeHelpMenu()
{
  QMenu* menu = this->AddMenu(tr("&Help"));
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
    &StudioMenus::ShowAbout);
  connect(menu->addAction(tr("About &Qt")), &QAction::triggered, qApp, &QApplication::aboutQt);
}

void StudioMenus::SaveMesh()
{
  const MeshPicturePointer picture = this->Window->GetPreview()->GetPicture();
  const QString file =
    QFileDialog::getSaveFileName(this->Window, tr("Save mesh"), QStringLiteral("mesh.off"),
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
    QMessageBox::warning(this->Window, tr("Save mesh"), QString::fromUtf8(error.what()));
  }
}

void StudioMenus::SavePolygons()
{
  const QString file = QFileDialog::getSaveFileName(
    this->Window, tr("Save polygons"), QStringLiteral("polygons.csv"), tr("Tables (*.csv)"));
  try
  {
    if (!file.isEmpty())
    {
      WritePolygonTable(file.toStdString(), this->Window->GetModel()->GetStudy().Polygons);
    }
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this->Window, tr("Save polygons"), QString::fromUtf8(error.what()));
  }
}

void StudioMenus::ShowPlotSettings()
{
  auto* dialog = new StyleDialog(this->Window->GetModel(), this->Window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &StyleDialog::Changed, this, &StudioMenus::RepaintCharts);
  dialog->show();
}

void StudioMenus::ShowPreferences()
{
  auto* dialog = new PreferencesDialog(this->Window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::Changed, this,
    [this]
    {
      ApplyPreferences(*qApp);
      this->RepaintCharts();
    });
  dialog->show();
}

void StudioMenus::RepaintCharts()
{
  for (PanelView* view : this->Window->findChildren<PanelView*>())
  {
    view->Refresh();
  }
}

void StudioMenus::UseStyleOfStudy()
{
  QString fault;
  if (pemesh::UseStyleOfStudy(this->Window->GetModel()->GetStudy(), fault))
  {
    this->RepaintCharts();
  }
  if (!fault.isEmpty())
  {
    this->Window->GetLog()->Tell(fault, true);
  }
}

void StudioMenus::ShowReference(const QString& title, const QString& markdown)
{
  auto* browser = new QTextBrowser(this->Window);
  browser->setWindowFlag(Qt::Window);
  browser->setAttribute(Qt::WA_DeleteOnClose);
  browser->setWindowTitle(title);
  browser->setOpenExternalLinks(true);
  browser->setMarkdown(markdown);
  browser->resize(820, 720);
  browser->show();
}

void StudioMenus::OpenResults()
{
  const QString folder = QFileDialog::getExistingDirectory(this->Window, tr("Results of a study"));
  if (!folder.isEmpty() && this->Window->OpenFiles({ folder + QStringLiteral("/study.json") }))
  {
    this->Window->GetResults()->Load(folder);
    this->Window->ShowPage(StudioWindow::GeometryPageIndex);
  }
}

void StudioMenus::ShowAbout()
{
  QMessageBox::about(this->Window, tr("About PEMesh Studio"),
    tr("<h3>PEMesh Studio %1</h3><p>How the geometry of polygonal meshes affects polytopal element "
       "methods.</p><p>Free software under the GNU General Public License, version 3 or later. It "
       "uses Qt, VTK, CGAL, Eigen, SuiteSparse, METIS, Boost, Cairo and nlohmann-json, each under "
       "a licence of its own.</p>")
      .arg(QCoreApplication::applicationVersion()));
}

} // namespace pemesh
