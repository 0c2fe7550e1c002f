// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshPage.h"

#include "Appearance.h"
#include "DocumentPath.h"
#include "FamilyGallery.h"
#include "Icons.h"
#include "LayoutCanvas.h"
#include "MeshFormats.h"
#include "OptionForm.h"
#include "PolygonTableModel.h"
#include "StudyModel.h"
#include "StudyPreview.h"
#include "TimeBar.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr double FirstScale = 0.6; // of a polygon that is added
constexpr double DuplicateShift = 0.05;

QLabel* MakeHeading(const QString& text, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setObjectName(QStringLiteral("heading"));
  label->setContentsMargins(14, 12, 14, 2);
  return label;
}

QWidget* MakeScrolled(QWidget* content)
{
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return scroll;
}

std::string PathOf(int polygon)
{
  return "polygons[" + std::to_string(polygon) + "]";
}

} // namespace

MeshPage::MeshPage(StudyModel* model, StudyPreview* preview, QWidget* parent)
  : QWidget(parent)
  , Model(model)
  , Preview(preview)
{
  auto* splitter = new QSplitter(this);
  splitter->setHandleWidth(1);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(this->MakeLeft());
  splitter->addWidget(this->MakeMiddle());
  splitter->addWidget(this->MakeRight());
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({ 190, 636, 356 });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter);
  connect(preview, &StudyPreview::OutlinesChanged, this, &MeshPage::ShowOutlines);
  connect(preview, &StudyPreview::PictureChanged, this, &MeshPage::ShowPicture);
  connect(preview, &StudyPreview::PlaceChanged, this, &MeshPage::ShowPlace);
  connect(preview, &StudyPreview::BusyChanged, this->Time, &TimeBar::SetBusy);
  connect(model, &StudyModel::Changed, this, &MeshPage::ShowHint);
  this->ShowPlace();
  this->ShowHint();
}

QWidget* MeshPage::MakeLeft()
{
  auto* panel = new QFrame(this);
  panel->setObjectName(QStringLiteral("leftPanel"));
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(MakeHeading(tr("Add a polygon"), panel));
  this->Gallery = new FamilyGallery(panel);
  layout->addWidget(MakeScrolled(this->Gallery), 1);
  panel->setMinimumWidth(190);
  connect(this->Gallery, &FamilyGallery::FamilyChosen, this, &MeshPage::AddPolygon);
  connect(this->Gallery, &FamilyGallery::FileWanted, this,
    [this]
    {
      const QString file = QFileDialog::getOpenFileName(this, tr("Add the polygon of a file"), {},
        tr("Polygons (%1 *.csv *.txt *.xy);;All files (*)")
          .arg(QString::fromStdString(ListMeshExtensions("*"))));
      if (!file.isEmpty())
      {
        this->AddPolygonFile(file);
      }
    });
  connect(this->Gallery, &FamilyGallery::DrawingWanted, this,
    [this] { this->Canvas->SetTool(LayoutCanvas::Tool::Draw); });
  return panel;
}

QWidget* MeshPage::MakeMiddle()
{
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  this->Canvas = new LayoutCanvas(this->Model, panel);
  this->Tools = new QToolBar(panel);
  this->Tools->setIconSize({ 18, 18 });
  this->MakeActions();
  this->Numbers = new QLabel(panel);
  this->Numbers->setObjectName(QStringLiteral("muted"));
  this->Numbers->setAlignment(Qt::AlignRight);
  this->Numbers->setContentsMargins(12, 0, 12, 6);
  this->Fault = new QLabel(panel);
  this->Fault->setObjectName(QStringLiteral("fault"));
  this->Fault->setWordWrap(true);
  this->Fault->hide();
  this->Time = new TimeBar(panel);
  auto* below = new QFrame(panel);
  below->setObjectName(QStringLiteral("barBelow"));
  auto* line = new QVBoxLayout(below);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(0);
  line->addWidget(this->Time);
  line->addWidget(this->Numbers);
  layout->addWidget(this->Tools);
  layout->addWidget(this->Fault);
  layout->addWidget(this->Canvas, 1);
  layout->addWidget(below);
  connect(this->Time, &TimeBar::PlaceChanged, this->Preview, &StudyPreview::SetPlace);
  connect(this->Canvas, &LayoutCanvas::SelectionChanged, this, &MeshPage::Select);
  connect(this->Canvas, &LayoutCanvas::Faulty, this, &MeshPage::Told);
  connect(this->Canvas, &PlaneView::PointerMoved, this,
    [this](const Point2& point)
    {
      emit this->Told(
        QStringLiteral("x %1   y %2").arg(point.x, 0, 'f', 4).arg(point.y, 0, 'f', 4));
    });
  connect(this->Canvas, &LayoutCanvas::Drawn, this,
    [this](const std::vector<Point2>& points)
    {
      JsonValue::List list;
      for (const Point2& point : points)
      {
        list.push_back({ JsonValue::List{ JsonNumber(point.x), JsonNumber(point.y) } });
      }
      this->Model->AddItem("polygons",
        { JsonValue::Object{ { "family", { std::string("points") } }, { "points", { list } } } },
        tr("Draw polygon"));
    });
  return panel;
}

QAction* MeshPage::AddAction(
  const char* icon, const QString& text, const QKeySequence& key, void (MeshPage::*method)())
{
  auto* action = new QAction(MakeIcon(icon), text, this);
  action->setShortcut(key);
  action->setToolTip(QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(action, &QAction::triggered, this, method);
  this->addAction(action);
  this->Tools->addAction(action);
  this->EditActions << action;
  return action;
}

void MeshPage::MakeActions()
{
  auto* group = new QActionGroup(this);
  const auto addTool = [this, group](const char* icon, const QString& text, const QString& key,
                         LayoutCanvas::Tool tool)
  {
    QAction* action = this->Tools->addAction(MakeIcon(icon), text);
    action->setCheckable(true);
    action->setShortcut(QKeySequence(key));
    action->setToolTip(QStringLiteral("%1 (%2)").arg(text, key));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    this->addAction(action);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, tool] { this->Canvas->SetTool(tool); });
    connect(this->Canvas, &LayoutCanvas::ToolChanged, action,
      [action, tool](LayoutCanvas::Tool now) { action->setChecked(now == tool); });
    return action;
  };
  addTool("select", tr("Select and move"), QStringLiteral("S"), LayoutCanvas::Tool::Select)
    ->setChecked(true);
  addTool("draw", tr("Draw a polygon"), QStringLiteral("D"), LayoutCanvas::Tool::Draw);
  QAction* snap = this->Tools->addAction(MakeIcon("snap"), tr("Snap to the grid"));
  snap->setCheckable(true);
  snap->setShortcut(QKeySequence(QStringLiteral("G")));
  snap->setToolTip(tr("Snap to the grid (G)"));
  connect(snap, &QAction::toggled, this->Canvas, &LayoutCanvas::SetSnapping);
  QAction* fit = this->Tools->addAction(MakeIcon("fit"), tr("Show all"));
  fit->setToolTip(tr("Show all (Home)"));
  connect(fit, &QAction::triggered, this->Canvas, &PlaneView::Fit);
  this->Tools->addSeparator();
  this->AddAction("duplicate", tr("Duplicate polygon"), QKeySequence(QStringLiteral("Ctrl+D")),
    &MeshPage::Duplicate);
  this->AddAction("delete", tr("Delete polygon"), QKeySequence(Qt::Key_Delete), &MeshPage::Delete);
  this->AddAction("up", tr("Move polygon up in the list"), QKeySequence(QStringLiteral("Ctrl+Up")),
    &MeshPage::MoveUp);
  this->AddAction("down", tr("Move polygon down in the list"),
    QKeySequence(QStringLiteral("Ctrl+Down")), &MeshPage::MoveDown);
  this->Select(-1);
}

QWidget* MeshPage::MakeOptions(const std::vector<std::pair<std::string, QString>>& objects)
{
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (const auto& [path, title] : objects)
  {
    layout->addWidget(MakeHeading(title, content));
    auto* form = new OptionForm(this->Model, content);
    form->SetPath(path);
    layout->addWidget(form);
  }
  layout->addStretch(1);
  return MakeScrolled(content);
}

QWidget* MeshPage::MakeRight()
{
  auto* panel = new QFrame(this);
  panel->setObjectName(QStringLiteral("sidePanel"));
  panel->setMinimumWidth(320);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Tabs = new QTabWidget(panel);
  this->Tabs->setDocumentMode(true);
  layout->addWidget(this->Tabs);

  this->Table = new QTableView(panel);
  this->Table->setModel(new PolygonTableModel(this->Model, this->Table));
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->verticalHeader()->setDefaultSectionSize(26);
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  this->Table->horizontalHeader()->setMinimumSectionSize(46);
  this->Table->setTabKeyNavigation(false);
  this->Table->setAccessibleName(tr("Polygons"));
  connect(this->Table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
    [this](const QModelIndex& index) { this->Select(index.isValid() ? index.row() : -1); });
  this->PolygonForm = new OptionForm(this->Model, panel);
  auto* polygons = new QSplitter(Qt::Vertical, panel);
  polygons->setHandleWidth(1);
  polygons->addWidget(this->Table);
  this->FormStack = new QStackedWidget(panel);
  auto* hint =
    new QLabel(tr("Select a polygon on the canvas or in the table to change it."), panel);
  hint->setObjectName(QStringLiteral("emptyText"));
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);
  hint->setMargin(24);
  this->FormStack->addWidget(hint);
  this->FormStack->addWidget(MakeScrolled(this->PolygonForm));
  polygons->addWidget(this->FormStack);
  polygons->setSizes({ 220, 380 });
  this->Tabs->addTab(polygons, tr("Polygons"));
  this->Tabs->addTab(
    this->MakeOptions({ { "domain", tr("Domain") }, { "mesh", tr("Mesh") } }), tr("Mesh"));
  this->Tabs->addTab(this->MakeOptions({ { "sweep[0]", tr("Sweep") } }), tr("Series"));
  this->RunButton = new QToolButton(panel);
  this->RunButton->setObjectName(QStringLiteral("primary"));
  this->RunButton->setToolButtonStyle(Qt::ToolButtonTextOnly);
  this->RunButton->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* below = new QHBoxLayout;
  below->setContentsMargins(14, 8, 14, 12);
  below->addWidget(this->RunButton);
  layout->addLayout(below);
  return panel;
}

void MeshPage::SetRunAction(QAction* action)
{
  this->RunButton->setDefaultAction(action);
}

void MeshPage::AddPolygon(const QString& family)
{
  const QRectF home = this->Preview->GetOutlines().Domain.empty() ? QRectF(0.0, 0.0, 1.0, 1.0)
                                                                  : this->Canvas->GetHomeBox();
  const QPointF center = home.center();
  this->Model->AddItem("polygons",
    { JsonValue::Object{ { "family", { family.toStdString() } },
      { "center", { JsonValue::List{ JsonNumber(center.x()), JsonNumber(center.y()) } } },
      { "scale", JsonNumber(FirstScale) } } },
    tr("Add %1").arg(family));
  this->Select(static_cast<int>(this->Model->GetStudy().Polygons.size()) - 1);
}

void MeshPage::AddPolygonFile(const QString& file)
{
  this->Model->AddItem("polygons",
    { JsonValue::Object{ { "family", { std::string("file") } }, { "file", { file.toStdString() } },
      { "scale", JsonNumber(FirstScale) } } },
    tr("Add polygon of a file"));
}

void MeshPage::Select(int polygon)
{
  const int count = static_cast<int>(this->Model->GetStudy().Polygons.size());
  const bool any = polygon >= 0 && polygon < count;
  for (QAction* action : this->EditActions)
  {
    action->setEnabled(any);
  }
  this->Canvas->SetSelected(any ? polygon : -1);
  if (this->Table && any)
  {
    this->Table->selectRow(polygon);
  }
  else if (this->Table)
  {
    this->Table->clearSelection();
  }
  if (this->PolygonForm)
  {
    this->PolygonForm->SetPath(any ? PathOf(polygon) : std::string());
    this->FormStack->setCurrentIndex(any ? 1 : 0);
  }
}

void MeshPage::Duplicate()
{
  const int selected = this->Canvas->GetSelected();
  const JsonValue* found = FindAtPath(this->Model->GetDocument(), PathOf(selected));
  if (selected < 0 || !found)
  {
    return;
  }
  JsonValue copy = *found;
  const auto& center = this->Model->GetStudy().Polygons[static_cast<std::size_t>(selected)].Center;
  SetAtPath(copy, "center",
    { JsonValue::List{
      JsonNumber(center[0] + DuplicateShift), JsonNumber(center[1] - DuplicateShift) } },
    "center");
  RemoveAtPath(copy, "name");
  this->Model->AddItem("polygons", copy, tr("Duplicate polygon"));
  this->Select(static_cast<int>(this->Model->GetStudy().Polygons.size()) - 1);
}

void MeshPage::Delete()
{
  const int selected = this->Canvas->GetSelected();
  if (selected >= 0)
  {
    this->Select(-1);
    this->Model->RemoveValue(PathOf(selected), tr("Delete polygon"));
  }
}

void MeshPage::MoveUp()
{
  const int selected = this->Canvas->GetSelected();
  this->Model->MoveItem("polygons", selected, selected - 1, tr("Move polygon up"));
  this->Select(std::max(0, selected - 1));
}

void MeshPage::MoveDown()
{
  const int selected = this->Canvas->GetSelected();
  const int last = static_cast<int>(this->Model->GetStudy().Polygons.size()) - 1;
  this->Model->MoveItem("polygons", selected, selected + 1, tr("Move polygon down"));
  this->Select(std::min(last, selected + 1));
}

void MeshPage::ShowOutlines()
{
  this->Canvas->SetOutlines(this->Preview->GetOutlines());
}

/** The mesh is painted in the colours of the theme. */
void MeshPage::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange && this->Numbers)
  {
    this->ShowPicture();
  }
}

void MeshPage::ShowPicture()
{
  const MeshPicturePointer picture = this->Preview->GetPicture();
  const Theme& theme = CurrentTheme();
  MeshColoring coloring;
  coloring.Line = theme.Muted.rgb();
  coloring.Plain = theme.Canvas.rgb();
  this->Canvas->SetColoring(coloring);
  this->Canvas->SetPicture(picture);
  if (picture && this->Preview->GetOutlines().Domain.empty())
  {
    this->Canvas->SetHomeBox(picture->GetBounds());
  }
  const QString fault =
    this->Model->GetFault().isEmpty() ? this->Preview->GetFault() : this->Model->GetFault();
  this->Fault->setText(fault);
  this->Fault->setVisible(!fault.isEmpty());
  this->Numbers->setText(picture && picture->GetNumberOfElements() > 0
      ? tr("%L1 elements, %L2 vertices")
          .arg(picture->GetNumberOfElements())
          .arg(picture->GetMesh()->GetNumberOfPoints())
      : QString());
}

void MeshPage::ShowPlace()
{
  this->Preview->IsContinuous() ? this->Time->SetContinuous()
                                : this->Time->SetCount(this->Preview->GetNumberOfCases());
  this->Time->SetPlace(this->Preview->GetPlace());
  this->Time->SetText(this->Preview->GetPlaceName());
  if (this->Preview->IsContinuous())
  {
    this->Gallery->SetTime(this->Preview->GetPlace());
  }
}

void MeshPage::ShowHint()
{
  const Study& study = this->Model->GetStudy();
  const bool isEmpty =
    study.Polygons.empty() && !study.Scatter && !HasMeshFiles(study) && IsTriangulated(study.Mesh);
  this->Canvas->SetHint(isEmpty
      ? tr("Pick a polygon on the left or draw one.\nMesh files and studies can be dropped here.")
      : QString());
  if (this->Canvas->GetSelected() >= static_cast<int>(study.Polygons.size()))
  {
    this->Select(-1);
  }
}

} // namespace pemesh
