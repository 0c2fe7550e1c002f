// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   ResultSet
 * @brief   The results of a study that was run: its folder, read in a worker.
 */
#ifndef pemesh_ResultSet_h
#define pemesh_ResultSet_h

#include "MeshPicture.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

class vtkTable;

namespace pemesh
{

class ColumnLabels;
class LatestJob;
struct Study;

class ResultSet : public QObject
{
  Q_OBJECT
public:
  explicit ResultSet(QObject* parent = nullptr);
  ~ResultSet() override;

  /** Reads a folder; Changed or Failed follows. */
  void Load(const QString& folder);
  void Clear();

  bool IsEmpty() const { return !this->Data; }
  QString GetFolder() const;
  ///@{
  /** Null while there is none. They do not change once they are there. */
  vtkTable* GetTable() const;
  vtkTable* GetCorrelation() const;
  /** What vtkPEMFindings says of it. */
  vtkTable* GetFindings() const;
  vtkTable* GetFailures() const;
  const Study* GetStudy() const;
  std::shared_ptr<const ColumnLabels> GetLabels() const;
  ///@}

  int GetNumberOfCases() const;
  QString GetMeshName(int index) const;
  /** The number of a mesh of that name, or -1. */
  int FindMesh(const QString& name) const;
  /** The columns that hold numbers. */
  QStringList GetNumberColumns() const;
  /** The metrics of which the table has the smallest, largest and mean value. */
  QStringList GetMetrics() const;
  /** Smallest and largest value of a metric over all meshes; equal where there is none. */
  void GetRange(const QString& metric, double range[2]) const;

  /** Reads the mesh of a case with its arrays; PictureChanged follows. */
  void ShowCase(int index);
  /** Null while there is none. */
  MeshPicturePointer GetPicture() const { return this->Picture; }
  int GetCase() const { return this->Case; }

signals:
  void Changed();
  void PictureChanged();
  void Failed(const QString& sentence);

private:
  struct Contents;
  static std::shared_ptr<const Contents> Read(const std::string& folder);

  std::shared_ptr<const Contents> Data;
  MeshPicturePointer Picture;
  int Case = -1;
  LatestJob* ReadJob;
  LatestJob* MeshJob;
};

} // namespace pemesh

#endif
