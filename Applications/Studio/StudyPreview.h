// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StudyPreview
 * @brief   The polygons and the mesh of a study as it stands, made in workers.
 *
 * Whenever the document or the place in its sweep changes, the outlines come at once and the mesh
 * as soon as it is made; a mesh that has become stale is given up.
 */
#ifndef pemesh_StudyPreview_h
#define pemesh_StudyPreview_h

#include "MeshPicture.h"
#include "StudyOutlines.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace pemesh
{

class LatestJob;
class StudyModel;
struct Study;
struct StudyCase;

class StudyPreview : public QObject
{
  Q_OBJECT
public:
  explicit StudyPreview(StudyModel* model, QObject* parent = nullptr);
  ~StudyPreview() override;

  ///@{
  /** Whether the elements are measured as well. Default false. */
  void SetMeasured(bool measured);
  ///@}

  ///@{
  /** Whether the deformation t moves freely; else the place is one of the cases of the study. */
  bool IsContinuous() const;
  /** t in [0, 1], or the number of the case. */
  void SetPlace(double place);
  double GetPlace() const { return this->Place; }
  int GetNumberOfCases() const;
  /** "t = 0.45", "009_0.426316": what the place is called. */
  QString GetPlaceName() const;
  ///@}

  const StudyOutlines& GetOutlines() const { return this->Outlines; }
  /** The last mesh made; may be null. */
  MeshPicturePointer GetPicture() const { return this->Picture; }
  /** One sentence on why there is no mesh, or empty. */
  QString GetFault() const { return this->Fault; }
  bool IsBusy() const;

signals:
  void OutlinesChanged();
  void PictureChanged();
  void BusyChanged(bool busy);
  void PlaceChanged();

private:
  void Refresh();
  void MakeOutlines();
  void MakePicture();
  StudyCase CaseOfPlace() const;
  void SetPicture(const MeshPicturePointer& picture, const QString& fault);

  struct Maker;
  StudyModel* Model;
  std::shared_ptr<Maker> MeshMaker; // used in the worker alone
  LatestJob* OutlineJob;
  LatestJob* MeshJob;
  bool Measured = false;
  double Place = 0.0;
  std::vector<StudyCase> Cases; // where the place is one of them
  StudyOutlines Outlines;
  MeshPicturePointer Picture;
  QString Fault;
};

} // namespace pemesh

#endif
