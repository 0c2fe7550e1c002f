// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TimeBar.h"

#include "Icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QToolButton>

#include <cmath>

namespace pemesh
{

namespace
{
constexpr int Steps = 1000;      // of a free t
constexpr int StepsOfPlay = 10;  // of them in one frame
constexpr int Milliseconds = 80; // a frame at most
}

TimeBar::TimeBar(QWidget* parent)
  : QWidget(parent)
  , Play(new QToolButton(this))
  , Slider(new QSlider(Qt::Horizontal, this))
  , Label(new QLabel(this))
  , Timer(new QTimer(this))
{
  this->Play->setIcon(MakeIcon("play"));
  this->Play->setCheckable(true);
  this->Play->setToolTip(tr("Play (Space)"));
  this->Play->setAccessibleName(tr("Play"));
  this->Slider->setAccessibleName(tr("Deformation or mesh"));
  this->Slider->setObjectName(QStringLiteral("timeSlider"));
  this->Label->setMinimumWidth(120);
  this->Timer->setInterval(Milliseconds);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 6, 12, 6);
  line->setSpacing(10);
  line->addWidget(this->Play);
  line->addWidget(this->Slider, 1);
  line->addWidget(this->Label);
  connect(this->Slider, &QSlider::valueChanged, this,
    [this] { emit this->PlaceChanged(this->GetPlace()); });
  connect(this->Play, &QToolButton::toggled, this, &TimeBar::SetPlaying);
  connect(this->Timer, &QTimer::timeout, this, &TimeBar::Advance);
  this->SetContinuous();
}

void TimeBar::SetContinuous()
{
  this->Continuous = true;
  const QSignalBlocker blocker(this->Slider);
  this->Slider->setRange(0, Steps);
  this->Slider->setPageStep(Steps / 10);
  this->setEnabled(true);
}

void TimeBar::SetCount(int count)
{
  this->Continuous = false;
  const QSignalBlocker blocker(this->Slider);
  this->Slider->setRange(0, std::max(0, count - 1));
  this->Slider->setPageStep(1);
  this->setEnabled(count > 1);
}

void TimeBar::SetPlace(double place)
{
  const QSignalBlocker blocker(this->Slider);
  this->Slider->setValue(static_cast<int>(std::lround(this->Continuous ? place * Steps : place)));
}

double TimeBar::GetPlace() const
{
  const double value = this->Slider->value();
  return this->Continuous ? value / Steps : value;
}

void TimeBar::SetText(const QString& text)
{
  this->Label->setText(text);
}

bool TimeBar::IsPlaying() const
{
  return this->Timer->isActive();
}

void TimeBar::SetPlaying(bool playing)
{
  this->Play->setChecked(playing);
  this->Play->setIcon(MakeIcon(playing ? "pause" : "play"));
  playing ? this->Timer->start() : this->Timer->stop();
}

void TimeBar::Advance()
{
  if (this->Busy)
  {
    return;
  }
  const int next = this->Slider->value() + (this->Continuous ? StepsOfPlay : 1);
  this->Slider->setValue(next > this->Slider->maximum() ? this->Slider->minimum() : next);
}

} // namespace pemesh
