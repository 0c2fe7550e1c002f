// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   RunBox
 * @brief   How a run goes, and the buttons that begin, pause and end it.
 */
#ifndef pemesh_RunBox_h
#define pemesh_RunBox_h

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace pemesh
{

class RunController;

class RunBox : public QWidget
{
  Q_OBJECT
public:
  explicit RunBox(RunController* controller, QWidget* parent = nullptr);

signals:
  /** Of all meshes, or what was paused. */
  void RunWanted();
  void SomeWanted();

private:
  QPushButton* AddButton(const QString& text, const QString& tip);
  void Show();

  RunController* Controller;
  QLabel* State;
  QProgressBar* Progress;
  QPushButton* RunButton;
  QPushButton* SomeButton;
  QPushButton* PauseButton;
  QPushButton* StopButton;
  QPushButton* CancelButton;
};

} // namespace pemesh

#endif
