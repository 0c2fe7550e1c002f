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
#include "Selection.h"
#include "Session.h"
#include "SolverPage.h"
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
constexpr const char* DefaultSolver = "pemesh-vem";
}

StudioWindow::StudioWindow(QWidget* parent)
  : QMainWindow(parent)
  , Model(new StudyModel(this))
  , Preview(new StudyPreview(this->Model, this))
  , Results(new ResultSet(this))
  , Controller(new RunController(this))
  , Selected(new Selection(this))
  , Files(new Session(this->Model, this))
{
  this->setAcceptDrops(true);
  this->Preview->SetPlace(FirstPlace);
  this->Log = new LogDock(this->Selected, this);
  this->addDockWidget(Qt::BottomDockWidgetArea, this->Log);
  this->Log->hide();
  this->MakePages();
  this->MakeStatusBar();
  this->MakeToolBar();
  this->MakeMenus();
  connect(this->Model, &StudyModel::FileChanged, this, &StudioWindow::ShowTitle);
  connect(this->Model, &StudyModel::Changed, this, &StudioWindow::ShowTitle);
  connect(this->Files, &Session::Opened, this, &StudioWindow::LoadKeptResults);
  connect(this->Preview, &StudyPreview::BusyChanged, this, &StudioWindow::ShowRunning);
  connect(this->Preview, &StudyPreview::PictureChanged, this,
    [this] { this->SaveMeshAction->setEnabled(this->Preview->GetPicture() != nullptr); });
  connect(this->Results, &ResultSet::Failed, this,
    [this](const QString& sentence) { this->Log->Tell(sentence, true); });
  connect(this->Results, &ResultSet::PictureChanged, this,
    [this] { this->Log->SetPicture(this->Results->GetPicture()); });
  connect(this->Controller, &RunController::Started, this, &StudioWindow::ShowRunning);
  connect(this->Controller, &RunController::Told, this,
    [this](const QString& line) { this->Log->Tell(line); });
  connect(this->Controller, &RunController::Progressed, this,
    [this](double fraction)
    { this->Progress->setValue(static_cast<int>(std::lround(fraction * 1000.0))); });
  connect(this->Controller, &RunController::Finished, this, &StudioWindow::FinishRun);
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
    new SolverPage(this->Model, this->Results, this->Controller, this->Selected, this->Pages);
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
  connect(this->Meshes, &MeshPage::Told, this, tell);
  connect(this->Geometry, &GeometryPage::Told, this, tell);
  connect(this->Geometry, &GeometryPage::RunWanted, this, &StudioWindow::Run);
  connect(this->Geometry, &GeometryPage::PictureShown, this->Log, &LogDock::SetPicture);
  connect(this->Solver, &SolverPage::RunWanted, this, &StudioWindow::Run);
  connect(this->Correlation, &CorrelationPage::Told, this, tell);
  connect(this->Correlation, &CorrelationPage::RunWanted, this, &StudioWindow::RunWithSolver);
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
  this->UndoAction = add("undo", tr("Undo"), QKeySequence::Undo);
  this->RedoAction = add("redo", tr("Redo"), QKeySequence::Redo);
  connect(this->UndoAction, &QAction::triggered, stack, &QUndoStack::undo);
  connect(this->RedoAction, &QAction::triggered, stack, &QUndoStack::redo);
  const auto show = [this, stack]
  {
    this->UndoAction->setEnabled(stack->canUndo());
    this->RedoAction->setEnabled(stack->canRedo());
    this->UndoAction->setToolTip(tr("Undo %1").arg(stack->undoText()));
    this->RedoAction->setToolTip(tr("Redo %1").arg(stack->redoText()));
  };
  connect(stack, &QUndoStack::indexChanged, this, show);
  show();
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  this->RunAction = add("run", tr("Run study"), QKeySequence(Qt::Key_F5));
  this->StopAction =
    add("stop", tr("Stop and keep what is done"), QKeySequence(QStringLiteral("Shift+F5")));
  this->CancelAction = add("cancel", tr("Cancel the run"), QKeySequence(QStringLiteral("Ctrl+F5")));
  connect(this->RunAction, &QAction::triggered, this, &StudioWindow::Run);
  connect(this->StopAction, &QAction::triggered, this->Controller, &RunController::Stop);
  connect(this->CancelAction, &QAction::triggered, this->Controller, &RunController::Cancel);
  auto* run = qobject_cast<QToolButton*>(bar->widgetForAction(this->RunAction));
  run->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->ShowRunning();
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

void StudioWindow::ShowRunning()
{
  const bool running = this->Controller->IsRunning();
  this->RunAction->setEnabled(!running);
  for (QAction* action : { this->StopAction, this->CancelAction })
  {
    action->setEnabled(running);
    action->setVisible(running);
  }
  this->Progress->setVisible(running);
  this->Status->setText(running ? tr("Running …")
      : this->Preview->IsBusy() ? tr("Meshing …")
                                : QString());
}

bool StudioWindow::OpenFiles(const QStringList& files)
{
  return this->Files->OpenFiles(files);
}

void StudioWindow::Run()
{
  if (this->Controller->IsRunning())
  {
    return;
  }
  if (!this->Model->GetFault().isEmpty())
  {
    this->Log->ShowLog();
    this->Log->Tell(this->Model->GetFault(), true);
    return;
  }
  this->Progress->setValue(0);
  this->Log->Tell(tr("Running %1").arg(this->Model->GetTitle()));
  this->Controller->Start(
    this->Model->GetText(), this->Model->GetFolder(), this->Files->GetOutputFolder());
}

void StudioWindow::RunWithSolver()
{
  if (this->Model->GetStudy().Solvers.empty())
  {
    this->Solver->AddSolver(QString::fromLatin1(DefaultSolver));
  }
  this->ShowPage(SolverPageIndex);
  this->Run();
}

void StudioWindow::FinishRun(bool isGood, const QString& folder, const QStringList& messages)
{
  this->ShowRunning();
  for (const QString& message : messages)
  {
    this->Log->Tell(message, true);
  }
  this->Log->Tell(folder.isEmpty()
      ? tr("The run was ended and nothing was kept.")
      : tr("Done in %1 s: %2").arg(this->Controller->GetSeconds(), 0, 'f', 1).arg(folder));
  if (!isGood && folder.isEmpty() && !messages.isEmpty())
  {
    this->Log->ShowLog();
  }
  if (!folder.isEmpty())
  {
    this->Results->Load(folder);
  }
  if (this->ClosesAfterRun)
  {
    this->close();
  }
}

/** Of the study that was opened, where it was run before; nothing runs unasked. */
void StudioWindow::LoadKeptResults()
{
  this->Results->Clear();
  this->Selected->SetCase(-1);
  const QString folder = this->Files->GetOutputFolder();
  if (!this->Model->GetFile().isEmpty() && QFile::exists(folder + QStringLiteral("/results.csv")))
  {
    this->Results->Load(folder);
  }
}

void StudioWindow::closeEvent(QCloseEvent* event)
{
  if (this->Controller->IsRunning())
  {
    this->ClosesAfterRun = true;
    this->Controller->Cancel(); // FinishRun closes the window
    event->ignore();
    return;
  }
  if (!this->Files->ConfirmDiscard())
  {
    this->ClosesAfterRun = false;
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
