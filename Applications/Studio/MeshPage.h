// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   MeshPage
 * @brief   The first page: polygons are placed in the domain, and the mesh around them is seen.
 */
#ifndef pemesh_MeshPage_h
#define pemesh_MeshPage_h

#include <QWidget>

class QAction;
class QLabel;
class QStackedWidget;
class QTableView;
class QTabWidget;
class QToolBar;
class QToolButton;

namespace pemesh
{

class FamilyGallery;
class LayoutCanvas;
class OptionForm;
class StudyModel;
class StudyPreview;
class TimeBar;

class MeshPage : public QWidget
{
  Q_OBJECT
public:
  MeshPage(StudyModel* model, StudyPreview* preview, QWidget* parent = nullptr);

  LayoutCanvas* GetCanvas() const { return this->Canvas; }
  void AddPolygonFile(const QString& file);
  /** For the menu: what is done with the selected polygon. */
  QList<QAction*> GetEditActions() const { return this->EditActions; }
  /** What the button below the options does: runs the solver. */
  void SetRunAction(QAction* action);

signals:
  /** One line for the status bar. */
  void Told(const QString& line);

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* MakeLeft();
  QWidget* MakeMiddle();
  QWidget* MakeRight();
  QWidget* MakeOptions(const std::vector<std::pair<std::string, QString>>& objects);
  void MakeActions();
  QAction* AddAction(
    const char* icon, const QString& text, const QKeySequence& key, void (MeshPage::*method)());
  void AddPolygon(const QString& family);
  void Select(int polygon);
  void Duplicate();
  void Delete();
  void MoveUp();
  void MoveDown();
  void ShowOutlines();
  void ShowPicture();
  void ShowPlace();
  void ShowHint();

  StudyModel* Model;
  StudyPreview* Preview;
  FamilyGallery* Gallery = nullptr;
  LayoutCanvas* Canvas = nullptr;
  TimeBar* Time = nullptr;
  QLabel* Fault = nullptr;
  QLabel* Numbers = nullptr;
  QTabWidget* Tabs = nullptr;
  QTableView* Table = nullptr;
  OptionForm* PolygonForm = nullptr;
  QStackedWidget* FormStack = nullptr;
  QToolBar* Tools = nullptr;
  QToolButton* RunButton = nullptr;
  QList<QAction*> EditActions;
};

} // namespace pemesh

#endif
