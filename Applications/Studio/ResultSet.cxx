// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResultSet.h"

#include "ArrayValues.h"
#include "ColumnLabels.h"
#include "ColumnRoles.h"
#include "CsvTable.h"
#include "LatestJob.h"
#include "MeshFormats.h"
#include "MetricRegistry.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "StudyFile.h"

#include <cmath>
#include <filesystem>

#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace pemesh
{

namespace fs = std::filesystem;

struct ResultSet::Contents
{
  fs::path Folder;
  vtkSmartPointer<vtkTable> Table;
  vtkSmartPointer<vtkTable> Correlation;
  vtkSmartPointer<vtkTable> Findings;
  vtkSmartPointer<vtkTable> Failures;
  Study TheStudy;
  std::shared_ptr<const ColumnLabels> Labels;
};

namespace
{

vtkSmartPointer<vtkTable> ReadIfThere(const fs::path& file)
{
  return fs::exists(file) ? ReadCsvFile(file) : nullptr;
}

/** Descriptions may have gone since; then the columns keep their own names. */
std::shared_ptr<const ColumnLabels> LabelsOf(Study study)
{
  try
  {
    const std::vector<SolverDescription> solvers = FindStudySolvers(study);
    return std::make_shared<ColumnLabels>(study, solvers);
  }
  catch (const std::exception&)
  {
    return std::make_shared<ColumnLabels>();
  }
}

} // namespace

ResultSet::ResultSet(QObject* parent)
  : QObject(parent)
  , ReadJob(new LatestJob(this))
  , MeshJob(new LatestJob(this, 0))
{
}

ResultSet::~ResultSet()
{
  delete this->ReadJob;
  delete this->MeshJob;
}

std::shared_ptr<const ResultSet::Contents> ResultSet::Read(const std::string& folder)
{
  auto contents = std::make_shared<Contents>();
  contents->Folder = folder;
  contents->Table = ReadCsvFile(contents->Folder / "results.csv");
  contents->Correlation = ReadIfThere(contents->Folder / "correlation.csv");
  contents->Findings = ReadIfThere(contents->Folder / "findings.csv");
  contents->Failures = ReadIfThere(contents->Folder / "failures.csv");
  contents->TheStudy = ReadStudy(contents->Folder / "study.json");
  contents->Labels = LabelsOf(contents->TheStudy);
  return contents;
}

void ResultSet::Load(const QString& folder)
{
  this->ReadJob->Cancel(); // the folder before may be gone by now
  this->ReadJob->Start(
    [this, path = folder.toStdString()](const std::atomic<bool>&) -> LatestJob::Delivery
    {
      std::shared_ptr<const Contents> contents;
      QString fault;
      try
      {
        contents = Read(path);
      }
      catch (const std::exception& error)
      {
        fault = QString::fromUtf8(error.what());
      }
      return [this, contents, fault]
      {
        this->MeshJob->Cancel(); // a mesh of the folder before
        this->Data = contents;
        this->Picture.reset();
        this->Case = -1;
        emit this->Changed();
        if (!fault.isEmpty())
        {
          emit this->Failed(fault);
        }
      };
    });
}

void ResultSet::Clear()
{
  this->ReadJob->Cancel();
  this->MeshJob->Cancel();
  this->Data.reset();
  this->Picture.reset();
  this->Case = -1;
  emit this->Changed();
}

QString ResultSet::GetFolder() const
{
  return this->Data ? QString::fromStdString(this->Data->Folder.string()) : QString();
}

vtkTable* ResultSet::GetTable() const
{
  return this->Data ? this->Data->Table : nullptr;
}

vtkTable* ResultSet::GetCorrelation() const
{
  return this->Data ? this->Data->Correlation : nullptr;
}

vtkTable* ResultSet::GetFindings() const
{
  return this->Data ? this->Data->Findings : nullptr;
}

vtkTable* ResultSet::GetFailures() const
{
  return this->Data ? this->Data->Failures : nullptr;
}

const Study* ResultSet::GetStudy() const
{
  return this->Data ? &this->Data->TheStudy : nullptr;
}

std::shared_ptr<const ColumnLabels> ResultSet::GetLabels() const
{
  return this->Data ? this->Data->Labels : std::make_shared<const ColumnLabels>();
}

int ResultSet::GetNumberOfCases() const
{
  return this->Data ? static_cast<int>(this->Data->Table->GetNumberOfRows()) : 0;
}

QString ResultSet::GetMeshName(int index) const
{
  return index >= 0 && index < this->GetNumberOfCases()
    ? QString::fromStdString(this->Data->Table->GetValueByName(index, "Mesh").ToString())
    : QString();
}

int ResultSet::FindMesh(const QString& name) const
{
  for (int i = 0; i < this->GetNumberOfCases(); ++i)
  {
    if (this->GetMeshName(i) == name)
    {
      return i;
    }
  }
  return -1;
}

QStringList ResultSet::GetNumberColumns() const
{
  QStringList names;
  if (this->Data)
  {
    for (const std::string& name : NumericColumns(this->Data->Table))
    {
      names << QString::fromStdString(name);
    }
  }
  return names;
}

QStringList ResultSet::GetMetrics() const
{
  QStringList names;
  for (const Metric& metric : Metrics())
  {
    if (this->Data &&
      this->Data->Table->GetColumnByName((std::string(metric.Name) + "_min").c_str()))
    {
      names << QString::fromUtf8(metric.Name);
    }
  }
  return names;
}

void ResultSet::GetRange(const QString& metric, double range[2]) const
{
  double found[2] = { INFINITY, -INFINITY };
  bool any = false;
  for (const char* ending : { "_min", "_max" })
  {
    const std::string name = metric.toStdString() + ending;
    any = this->Data &&
      ExtendRange(
        vtkDataArray::SafeDownCast(this->Data->Table->GetColumnByName(name.c_str())), found);
  }
  range[0] = any ? found[0] : 0.0;
  range[1] = any ? found[1] : 0.0;
}

void ResultSet::ShowCase(int index)
{
  if (this->Case == index || index < 0 || index >= this->GetNumberOfCases())
  {
    return;
  }
  this->Case = index;
  const std::string name = this->GetMeshName(index).toStdString();
  this->MeshJob->Start(
    [this, file = this->Data->Folder / "meshes" / (name + ".vtp")](
      const std::atomic<bool>&) -> LatestJob::Delivery
    {
      MeshPicturePointer picture;
      QString fault;
      try
      {
        picture = std::make_shared<MeshPicture>(ReadMesh(file));
      }
      catch (const std::exception& error)
      {
        fault = QString::fromUtf8(error.what());
      }
      return [this, picture, fault]
      {
        this->Picture = picture;
        emit this->PictureChanged();
        if (!fault.isEmpty())
        {
          emit this->Failed(fault);
        }
      };
    });
}

} // namespace pemesh
