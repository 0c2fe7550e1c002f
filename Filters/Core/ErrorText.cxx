// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ErrorText.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <algorithm>

namespace pemesh
{

std::string SentenceOfError(const char* text)
{
  std::string sentence = text ? text : "";
  if (const std::size_t start = sentence.find("): "); start != std::string::npos)
  {
    sentence.erase(0, start + 3);
  }
  sentence.erase(sentence.find_last_not_of(" \n") + 1);
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  return sentence;
}

std::string UpdateExplaining(vtkAlgorithm* algorithm)
{
  std::string sentence;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&sentence);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* text)
    {
      auto& first = *static_cast<std::string*>(client); // the cause
      first = first.empty() ? SentenceOfError(static_cast<const char*>(text)) : first;
    });
  algorithm->AddObserver(vtkCommand::ErrorEvent, observer);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  algorithm->Update();
  algorithm->RemoveObserver(observer);
  algorithm->GetExecutive()->RemoveObserver(observer);
  return sentence;
}

} // namespace pemesh
