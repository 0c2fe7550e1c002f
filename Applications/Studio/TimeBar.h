// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   TimeBar
 * @brief   A slider with a play button over the deformation t or over the meshes of a study.
 */
#ifndef pemesh_TimeBar_h
#define pemesh_TimeBar_h

#include <QWidget>

class QLabel;
class QSlider;
class QTimer;
class QToolButton;

namespace pemesh
{

class TimeBar : public QWidget
{
  Q_OBJECT
public:
  explicit TimeBar(QWidget* parent = nullptr);

  /** A free t in [0, 1]. */
  void SetContinuous();
  /** One of so many meshes. */
  void SetCount(int count);
  /** t, or the number of the mesh; nothing is emitted. */
  void SetPlace(double place);
  double GetPlace() const;
  void SetText(const QString& text);

  bool IsPlaying() const;
  void SetPlaying(bool playing);
  /** Play waits for what is shown. */
  void SetBusy(bool busy) { this->Busy = busy; }

signals:
  void PlaceChanged(double place);

private:
  void Advance();

  QToolButton* Play;
  QSlider* Slider;
  QLabel* Label;
  QTimer* Timer;
  bool Continuous = true;
  bool Busy = false;
};

} // namespace pemesh

#endif
