// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terminal.h"

#include "ErrorText.h"

#include <algorithm>
#include <iostream>

#include <unistd.h>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace pemesh
{

namespace
{

class MessageHandler : public vtkOutputWindow
{
public:
  static MessageHandler* New();
  vtkTypeMacro(MessageHandler, vtkOutputWindow);

  void DisplayText(const char* text) override { Complain(SentenceOfError(text)); }
};

vtkStandardNewMacro(MessageHandler);

} // namespace

void Complain(const std::string& message)
{
  std::cerr << "pemesh: " << message << "\n";
}

void InstallMessageHandler()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it would say the same once more
  vtkNew<MessageHandler> handler;
  vtkOutputWindow::SetInstance(handler);
}

ProgressBar::ProgressBar(vtkObject* source, const std::string& label, bool inLog)
  : Source(source)
  , Label(label)
  , InLog(inLog && !isatty(STDERR_FILENO))
{
  if (!isatty(STDERR_FILENO) && !inLog)
  {
    return;
  }
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject*, unsigned long, void* self, void* fraction)
    { static_cast<ProgressBar*>(self)->Draw(*static_cast<double*>(fraction)); });
  this->Observer = source->AddObserver(vtkCommand::ProgressEvent, observer);
  this->Draw(0.0);
}

ProgressBar::~ProgressBar()
{
  if (this->Observer != 0)
  {
    this->Source->RemoveObserver(this->Observer);
  }
  if (this->Observer != 0 && !this->InLog)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void ProgressBar::Draw(double fraction)
{
  constexpr int width = 40;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (percent == this->Drawn)
  {
    return;
  }
  if (this->InLog)
  {
    constexpr int step = 10;
    if (percent / step != this->Drawn / step)
    {
      std::cerr << this->Label << " " << percent - percent % step << " %" << std::endl;
    }
    this->Drawn = percent;
    return;
  }
  this->Drawn = percent;
  const int filled = percent * width / 100;
  std::cerr << "\r" << this->Label << " [" << std::string(static_cast<std::size_t>(filled), '#')
            << std::string(static_cast<std::size_t>(width - filled), '.') << "] " << percent << " %"
            << std::flush;
}

} // namespace pemesh
