// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   Selection
 * @brief   What is looked at: a mesh of the study, an element of it, a metric. All pages share one.
 */
#ifndef pemesh_Selection_h
#define pemesh_Selection_h

#include <QObject>
#include <QString>

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

public slots:
  /** A case of the study from 0; none is -1. No element is selected afterwards. */
  void SetCase(int index);
  /** An element of the mesh; none is -1. */
  void SetElement(qint64 element);
  void SetMetric(const QString& metric);

signals:
  void CaseChanged(int index);
  void ElementChanged(qint64 element);
  void MetricChanged(const QString& metric);

private:
  int Case = -1;
  qint64 Element = -1;
  QString Metric = QStringLiteral("MinAngle");
};

} // namespace pemesh

#endif
