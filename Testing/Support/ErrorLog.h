// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Keeps the errors of a filter, and of its executive, instead of printing them.
 */
#ifndef pemesh_ErrorLog_h
#define pemesh_ErrorLog_h

#include <string>

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

namespace pemesh
{

class ErrorLog
{
public:
  explicit ErrorLog(vtkAlgorithm* filter)
  {
    this->Observe(filter, &this->OfFilter);
    this->Observe(filter->GetExecutive(), &this->OfExecutive);
  }

  /** What the filter itself said. */
  const std::string& GetText() const { return this->OfFilter; }

  void Clear()
  {
    this->OfFilter.clear();
    this->OfExecutive.clear();
  }

private:
  void Observe(vtkObject* object, std::string* text)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(text);
    command->SetCallback([](vtkObject*, unsigned long, void* client, void* words)
      { *static_cast<std::string*>(client) += static_cast<const char*>(words); });
    object->AddObserver(vtkCommand::ErrorEvent, command);
  }

  std::string OfFilter;
  std::string OfExecutive;
};

} // namespace pemesh

#endif
