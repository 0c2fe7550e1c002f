// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudioWindow.h"

#include "CorrelationPage.h"
#include "GeometryPage.h"
#include "Icons.h"
#include "LayoutCanvas.h"
#include "LogDock.h"
#include "MeshFormats.h"
#include "MeshPage.h"
#include "ResultSet.h"
#include "RunController.h"
#include "RunDesk.h"
#include "Selection.h"
#include "Session.h"
#include "SolverPage.h"
#include "StudioMenus.h"
#include "StudyModel.h"
#include "StudyPreview.h"

#include <QAction>
#include <QButtonGroup>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include <cmath>

namespace pemesh
{

namespace
{
constexpr double FirstPlace = 0.5;
}

StudioWindow::StudioWindow(QWidget* parent)
  : QMainWindow(parent)
  , Model(new StudyModel(this))
  , Preview(new StudyPreview(this->Model, this))
  , Results(new ResultSet(this))
  , Selected(new Selection(this))
  , Files(new Session(this->Model, this))
{
  this->setAcceptDrops(true);
  this->Preview->SetPlace(FirstPlace);
  this->Log = new LogDock(this->Selected, this);
  this->addDockWidget(Qt::BottomDockWidgetArea, this->Log);
  this->Log->hide();
  // Before the pages, which show what it says.
  this->Runs = new RunDesk(
    { this->Model, this->Preview, this->Results, this->Selected, this->Files, this->Log }, this);
  this->MakePages();
  this->MakeStatusBar();
  this->MakeToolBar();
  this->ConnectRuns();
  connect(this->Model, &StudyModel::FileChanged, this, &StudioWindow::ShowTitle);
  connect(this->Model, &StudyModel::Changed, this, &StudioWindow::ShowTitle);
  connect(this->Results, &ResultSet::Failed, this,
    [this](const QString& sentence) { this->Log->Tell(sentence, true); });
  connect(this->Results, &ResultSet::PictureChanged, this,
    [this] { this->Log->SetPicture(this->Results->GetPicture()); });
  this->MakeReachable();
  this->ShowTitle();
  this->ShowPage(MeshPageIndex);
  this->resize(1360, 860);
  this->restoreGeometry(QSettings().value(QStringLiteral("geometry")).toByteArray());
}

StudioWindow::~StudioWindow() = default;

void StudioWindow::MakePages()
{
  auto* center = new QWidget(this);
  auto* line = new QHBoxLayout(center);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(0);
  this->Pages = new QStackedWidget(center);
  this->Meshes = new MeshPage(this->Model, this->Preview, this->Pages);
  this->Geometry = new GeometryPage(this->Preview, this->Results, this->Selected, this->Pages);
  this->Solver =
    new SolverPage(this->Model, this->Results, this->GetController(), this->Selected, this->Pages);
  this->Correlation = new CorrelationPage(this->Results, this->Selected, this->Pages);
  for (QWidget* page : std::initializer_list<QWidget*>{
         this->Meshes, this->Geometry, this->Solver, this->Correlation })
  {
    this->Pages->addWidget(page);
  }
  auto* navigation = new QFrame(center);
  navigation->setObjectName(QStringLiteral("navigation"));
  line->addWidget(navigation);
  line->addWidget(this->Pages, 1);
  this->setCentralWidget(center);
  this->MakeNavigation();
  const auto tell = [this](const QString& text) { this->statusBar()->showMessage(text, 8000); };
  connect(this->Selected, &Selection::CasesMarked, this,
    [this, tell]
    {
      if (const auto count = this->Selected->GetMarkedCases().size(); count > 1)
      {
        tell(tr("%1 meshes are marked").arg(count));
      }
    });
  connect(this->Selected, &Selection::ElementsMarked, this,
    [this, tell]
    {
      if (const auto count = this->Selected->GetMarkedElements().size(); count > 1)
      {
        tell(tr("%1 elements are marked").arg(count));
      }
    });
  connect(this->Meshes, &MeshPage::Told, this, tell);
  connect(this->Geometry, &GeometryPage::Told, this, tell);
  connect(this->Geometry, &GeometryPage::PictureShown, this->Log, &LogDock::SetPicture);
  connect(this->Correlation, &CorrelationPage::Told, this, tell);
  connect(this->Correlation, &CorrelationPage::MeshWanted, this,
    [this] { this->ShowPage(GeometryPageIndex); });
}

void StudioWindow::MakeNavigation()
{
  auto* panel = this->centralWidget()->findChild<QFrame*>(QStringLiteral("navigation"));
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(8, 10, 8, 10);
  layout->setSpacing(6);
  this->Navigation = new QButtonGroup(this);
  const std::pair<const char*, QString> pages[] = { { "mesh", tr("Mesh") },
    { "geometry", tr("Geometry") }, { "solver", tr("Solver") },
    { "correlation", tr("Correlation") } };
  for (int i = 0; i < 4; ++i)
  {
    auto* button = new QToolButton(panel);
    button->setIcon(MakeIcon(pages[i].first));
    button->setIconSize({ 26, 26 });
    button->setText(pages[i].second);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setCheckable(true);
    button->setFixedWidth(88);
    button->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(i + 1)));
    button->setToolTip(tr("%1 (Ctrl+%2)").arg(pages[i].second).arg(i + 1));
    button->setAccessibleName(pages[i].second);
    this->Navigation->addButton(button, i);
    layout->addWidget(button);
  }
  layout->addStretch(1);
  connect(this->Navigation, &QButtonGroup::idClicked, this, &StudioWindow::ShowPage);
}

void StudioWindow::MakeToolBar()
{
  auto* bar = this->addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize({ 20, 20 });
  const auto add = [this, bar](const char* icon, const QString& text, const QKeySequence& key)
  {
    QAction* action = bar->addAction(MakeIcon(icon), text);
    action->setShortcut(key);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
    return action;
  };
  connect(add("new", tr("New study"), QKeySequence::New), &QAction::triggered, this->Files,
    &Session::MakeNew);
  connect(add("open", tr("Open study"), QKeySequence::Open), &QAction::triggered, this->Files,
    &Session::Open);
  this->SaveAction = add("save", tr("Save study"), QKeySequence::Save);
  connect(this->SaveAction, &QAction::triggered, this->Files, &Session::Save);
  bar->addSeparator();
  QUndoStack* stack = this->Model->GetUndoStack();
  QAction* undo = add("undo", tr("Undo"), QKeySequence::Undo);
  QAction* redo = add("redo", tr("Redo"), QKeySequence::Redo);
  connect(undo, &QAction::triggered, stack, &QUndoStack::undo);
  connect(redo, &QAction::triggered, stack, &QUndoStack::redo);
  const auto show = [stack, undo, redo]
  {
    undo->setEnabled(stack->canUndo());
    redo->setEnabled(stack->canRedo());
    undo->setToolTip(tr("Undo %1").arg(stack->undoText()));
    redo->setToolTip(tr("Redo %1").arg(stack->redoText()));
  };
  connect(stack, &QUndoStack::indexChanged, this, show);
  show();
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  for (const RunDesk::ActionType type :
    { RunDesk::RunAll, RunDesk::Pause, RunDesk::Stop, RunDesk::Cancel })
  {
    bar->addAction(this->Runs->GetAction(type));
  }
  auto* run =
    qobject_cast<QToolButton*>(bar->widgetForAction(this->Runs->GetAction(RunDesk::RunAll)));
  run->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  new StudioMenus(this, { this->SaveAction, undo, redo });
}

/** What the pages want of runs, and what runs want of the window. */
void StudioWindow::ConnectRuns()
{
  this->Meshes->SetRunAction(this->Runs->GetAction(RunDesk::RunSolver));
  connect(this->Geometry, &GeometryPage::RunWanted, this->Runs, &RunDesk::Run);
  connect(this->Solver, &SolverPage::RunWanted, this->Runs, &RunDesk::Run);
  connect(this->Solver, &SolverPage::SomeWanted, this->Runs, &RunDesk::RunChosen);
  connect(this->Correlation, &CorrelationPage::RunWanted, this->Runs, &RunDesk::RunWithSolver);
  connect(this->Runs, &RunDesk::SolverWanted, this->Solver, &SolverPage::AddSolver);
  connect(
    this->Runs, &RunDesk::SolverPageWanted, this, [this] { this->ShowPage(SolverPageIndex); });
  connect(this->Runs, &RunDesk::Ended, this, &QWidget::close);
  connect(this->Runs, &RunDesk::StateChanged, this, &StudioWindow::ShowRunning);
  connect(this->GetController(), &RunController::Progressed, this->Progress,
    [this](double fraction)
    { this->Progress->setValue(static_cast<int>(std::lround(fraction * 1000.0))); });
  connect(this->GetController(), &RunController::Started, this->Progress, &QProgressBar::reset);
  this->ShowRunning();
}

void StudioWindow::ShowRunning()
{
  this->Progress->setVisible(this->GetController()->IsRunning());
  this->Status->setText(this->Runs->GetState());
}

RunController* StudioWindow::GetController() const
{
  return this->Runs->GetController();
}

void StudioWindow::Run()
{
  this->Runs->Run();
}

void StudioWindow::RunWithSolver()
{
  this->Runs->RunWithSolver();
}

void StudioWindow::RunSome()
{
  this->Runs->RunChosen();
}

/** Tool buttons take part in the order of Tab, which Qt leaves them out of. */
void StudioWindow::MakeReachable()
{
  for (const QToolBar* bar : this->findChildren<QToolBar*>())
  {
    for (QToolButton* button : bar->findChildren<QToolButton*>())
    {
      button->setFocusPolicy(Qt::TabFocus);
    }
  }
}

void StudioWindow::MakeStatusBar()
{
  this->Status = new QLabel(this);
  this->Status->setObjectName(QStringLiteral("muted"));
  this->Progress = new QProgressBar(this);
  this->Progress->setRange(0, 1000);
  this->Progress->setFixedWidth(180);
  this->Progress->setTextVisible(false);
  this->statusBar()->addPermanentWidget(this->Status);
  this->statusBar()->addPermanentWidget(this->Progress);
  this->Progress->hide();
}

void StudioWindow::ShowPage(int page)
{
  this->Pages->setCurrentIndex(page);
  this->Navigation->button(page)->setChecked(true);
}

void StudioWindow::ShowTitle()
{
  this->setWindowTitle(this->Model->GetTitle() + QStringLiteral("[*] – PEMesh Studio"));
  this->setWindowModified(this->Model->IsModified());
}

bool StudioWindow::OpenFiles(const QStringList& files)
{
  return this->Files->OpenFiles(files);
}

/** A run that goes on is paused, so that nothing is lost; that of a study without a file ends. */
void StudioWindow::closeEvent(QCloseEvent* event)
{
  if (!this->IsClosing && !this->Files->ConfirmDiscard())
  {
    event->ignore();
    return;
  }
  this->IsClosing = !this->Runs->EndForClosing(); // which closes it later
  if (this->IsClosing)
  {
    event->ignore();
    return;
  }
  QSettings().setValue(QStringLiteral("geometry"), this->saveGeometry());
  event->accept();
}

void StudioWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls())
  {
    event->acceptProposedAction();
  }
}

void StudioWindow::dropEvent(QDropEvent* event)
{
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
  {
    files << url.toLocalFile();
  }
  files.removeAll(QString());
  event->acceptProposedAction();
  this->OpenFiles(files);
}

} // namespace pemesh
