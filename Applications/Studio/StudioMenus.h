// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StudioMenus
 * @brief   The menu bar of the window, and what its entries do that no page does.
 */
#ifndef pemesh_StudioMenus_h
#define pemesh_StudioMenus_h

#include <QList>
#include <QObject>

class QAction;
class QKeySequence;
class QMenu;

namespace pemesh
{

class StudioWindow;

class StudioMenus : public QObject
{
  Q_OBJECT
public:
  /** Actions of the tool bar that menus have as well. */
  struct SharedActions
  {
    QAction* Save;
    QAction* Undo;
    QAction* Redo;
  };

  StudioMenus(StudioWindow* window, const SharedActions& shared);

  void ShowPreferences();
  void ShowPlotSettings();

private:
  QMenu* AddMenu(const QString& title);
  QAction* AddAction(QMenu* menu, const char* icon, const QString& text, const QKeySequence& key);
  void MakeFileMenu(QAction* save);
  void MakeEditMenu(const SharedActions& shared);
  void MakeViewMenu();
  void MakeThemeMenu(QMenu* menu);
  void MakeRunMenu();
  void MakeHelpMenu();
  void SaveMesh();
  void SavePolygons();
  void RepaintCharts();
  void UseStyleOfStudy();
  void ShowReference(const QString& title, const QString& markdown);
  void OpenResults();
  void ShowAbout();

  StudioWindow* Window;
};

} // namespace pemesh

#endif
