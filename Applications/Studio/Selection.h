// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   Selection
 * @brief   What is looked at: a mesh of the study, an element of it, a metric. All pages share one.
 *
 * Beside the one mesh (element) in view, any number may be marked: by a rectangle in a chart, on a
 * canvas, in the table. They stand out wherever they are shown.
 */
#ifndef pemesh_Selection_h
#define pemesh_Selection_h

#include <QObject>
#include <QString>

#include <vector>

#include <vtkType.h>

namespace pemesh
{

class Selection : public QObject
{
  Q_OBJECT
public:
  using QObject::QObject;

  int GetCase() const { return this->Case; }
  qint64 GetElement() const { return this->Element; }
  QString GetMetric() const { return this->Metric; }

  ///@{
  /** Those that stand out, ascending: what is marked and what is in view. */
  std::vector<vtkIdType> GetMarkedCases() const;
  std::vector<vtkIdType> GetMarkedElements() const;
  ///@}

public slots:
  /**
   * A case of the study from 0; none is -1. No element is selected afterwards, and unless it is one
   * of them no case is marked any more.
   */
  void SetCase(int index);
  /** An element of the mesh; none is -1. As above. */
  void SetElement(qint64 element);
  void SetMetric(const QString& metric);
  ///@{
  /** Ascending. The first one comes into view where the one that was is not among them. */
  void MarkCases(const std::vector<vtkIdType>& cases);
  void MarkElements(const std::vector<vtkIdType>& elements);
  ///@}

signals:
  void CaseChanged(int index);
  void ElementChanged(qint64 element);
  void MetricChanged(const QString& metric);
  /** GetMarkedCases or GetMarkedElements is another one. */
  void CasesMarked();
  void ElementsMarked();

private:
  int Case = -1;
  qint64 Element = -1;
  std::vector<vtkIdType> Cases;
  std::vector<vtkIdType> Elements;
  QString Metric = QStringLiteral("MinAngle");
};

} // namespace pemesh

#endif
