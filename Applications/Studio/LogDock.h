// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   LogDock
 * @brief   What happened, and the numbers of the mesh in view, always at hand.
 */
#ifndef pemesh_LogDock_h
#define pemesh_LogDock_h

#include "MeshPicture.h"

#include <QDockWidget>

class QPlainTextEdit;
class QTableWidget;
class QTabWidget;

namespace pemesh
{

class Selection;

class LogDock : public QDockWidget
{
  Q_OBJECT
public:
  explicit LogDock(Selection* selection, QWidget* parent = nullptr);

  /** A line with the time of day. */
  void Tell(const QString& line, bool isFault = false);
  QString GetText() const;
  /** The mesh whose numbers are shown: of all of it, and of the selected element. */
  void SetPicture(const MeshPicturePointer& picture);
  void ShowLog();

private:
  void ShowValues();

  Selection* Selected;
  QTabWidget* Tabs;
  QPlainTextEdit* Log;
  QTableWidget* Values;
  MeshPicturePointer Picture;
};

} // namespace pemesh

#endif
