// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunBox.h"

#include "RunController.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

namespace pemesh
{

RunBox::RunBox(RunController* controller, QWidget* parent)
  : QWidget(parent)
  , Controller(controller)
  , State(new QLabel(this))
  , Progress(new QProgressBar(this))
  , RunButton(this->AddButton(tr("Run all meshes"), tr("Run the study (F5)")))
  , SomeButton(this->AddButton(tr("Run some …"), tr("Choose the meshes to run (Alt+F5)")))
  , PauseButton(this->AddButton(
      tr("Pause"), tr("End the work for now, to be continued, also after the program was ended")))
  , StopButton(
      this->AddButton(tr("Stop and keep"), tr("End the run and keep the meshes that are done")))
  , CancelButton(
      this->AddButton(tr("Cancel"), tr("End the run and keep the results of the run before")))
{
  this->RunButton->setObjectName(QStringLiteral("primary"));
  this->Progress->setRange(0, 1000);
  this->Progress->setTextVisible(false);
  this->Progress->setAccessibleName(tr("Progress of the run"));
  this->State->setObjectName(QStringLiteral("muted"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(this->State, 0, 0, 1, 3);
  grid->addWidget(this->Progress, 1, 0, 1, 3);
  grid->addWidget(this->RunButton, 2, 0, 1, 2);
  grid->addWidget(this->SomeButton, 2, 2);
  grid->addWidget(this->PauseButton, 3, 0);
  grid->addWidget(this->StopButton, 3, 1);
  grid->addWidget(this->CancelButton, 3, 2);
  connect(this->RunButton, &QPushButton::clicked, this, &RunBox::RunWanted);
  connect(this->SomeButton, &QPushButton::clicked, this, &RunBox::SomeWanted);
  connect(this->PauseButton, &QPushButton::clicked, controller, &RunController::Pause);
  connect(this->StopButton, &QPushButton::clicked, controller, &RunController::Stop);
  connect(this->CancelButton, &QPushButton::clicked, controller, &RunController::Cancel);
  connect(controller, &RunController::Started, this, &RunBox::Show);
  connect(controller, &RunController::StateChanged, this, &RunBox::Show);
  connect(controller, &RunController::Finished, this, &RunBox::Show);
  connect(controller, &RunController::Progressed, this,
    [this](double fraction)
    {
      this->Progress->setValue(static_cast<int>(std::lround(fraction * 1000.0)));
      this->State->setText(tr("Running, %1 s").arg(this->Controller->GetSeconds(), 0, 'f', 1));
    });
  this->Show();
}

QPushButton* RunBox::AddButton(const QString& text, const QString& tip)
{
  auto* button = new QPushButton(text, this);
  button->setToolTip(tip);
  return button;
}

void RunBox::Show()
{
  const bool running = this->Controller->IsRunning();
  const bool paused = this->Controller->IsPaused();
  this->RunButton->setEnabled(!running);
  this->RunButton->setText(paused ? tr("Continue") : tr("Run all meshes"));
  this->SomeButton->setEnabled(!running && !paused); // it would give up what is paused
  this->PauseButton->setEnabled(running);
  this->StopButton->setEnabled(running || paused);
  this->CancelButton->setEnabled(running || paused);
  this->Progress->setVisible(running || paused);
  if (!paused)
  {
    this->Progress->setValue(0);
  }
  this->State->setText(running ? tr("Running")
      : paused                 ? tr("Paused: what is done is kept until you continue")
                               : QString());
}

} // namespace pemesh
