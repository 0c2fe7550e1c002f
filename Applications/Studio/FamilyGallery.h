// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   FamilyGallery
 * @brief   The families of polygons as pictures at their deformation; a click adds one.
 */
#ifndef pemesh_FamilyGallery_h
#define pemesh_FamilyGallery_h

#include <QWidget>

#include <vector>

class QToolButton;

namespace pemesh
{

class FamilyGallery : public QWidget
{
  Q_OBJECT
public:
  explicit FamilyGallery(QWidget* parent = nullptr);

  /** The pictures are those at t. */
  void SetTime(double t);

signals:
  void FamilyChosen(const QString& name);
  void FileWanted();
  void DrawingWanted();

private:
  struct Entry
  {
    int Family;
    QToolButton* Button;
  };
  QToolButton* AddButton(int position, const QString& text, const QString& tip);

  std::vector<Entry> Entries;
  double Time = -1.0;
};

} // namespace pemesh

#endif
