// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudioSupport.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QPixmap>
#include <QTest>
#include <QWidget>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace studio_test
{

namespace
{

/** Milliseconds of the processor. */
qint64 WorkOfThread()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1000 * static_cast<qint64>(time.tv_sec) + time.tv_nsec / 1000000;
}

} // namespace

bool WaitFor(const std::function<bool()>& condition, int milliseconds)
{
  QElapsedTimer clock;
  clock.start();
  while (!condition())
  {
    if (clock.elapsed() > milliseconds)
    {
      return false;
    }
    QTest::qWait(5);
  }
  return true;
}

void Keep(QWidget* widget, const char* name)
{
  QTest::qWait(100); // what was asked for is painted
  const QString folder = qEnvironmentVariable("PEMESH_STUDIO_PICTURES", PEMESH_TEST_OUTPUT);
  const QString density = widget->devicePixelRatioF() > 1.0 ? QStringLiteral("-dense") : QString();
  const QString file =
    QStringLiteral("%1/studio-%2%3.png").arg(folder, QLatin1String(name), density);
  EXPECT_TRUE(widget->grab().save(file)) << file.toStdString();
}

std::string ReadFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void Drag(QWidget* widget, const QPoint& from, const QPoint& to)
{
  QTest::mousePress(widget, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i)
  {
    QTest::mouseMove(widget, from + (to - from) * i / 8);
    QTest::qWait(5);
  }
  QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
}

Watchdog::Watchdog()
{
  this->Timer.setInterval(0);
  QObject::connect(&this->Timer, &QTimer::timeout, &this->Timer,
    [this]
    {
      this->Longest = std::max(this->Longest, this->Clock.restart());
      const qint64 work = WorkOfThread();
      this->LongestWork = std::max(this->LongestWork, work - this->Work);
      this->Work = work;
    });
  this->Restart();
  this->Timer.start();
}

std::string Watchdog::Describe() const
{
  return "longest stall " + std::to_string(this->Longest) + " ms, longest work of the window " +
    std::to_string(this->LongestWork) + " ms";
}

void Watchdog::Restart()
{
  this->Longest = 0;
  this->LongestWork = 0;
  this->Clock.restart();
  this->Work = WorkOfThread();
}

} // namespace studio_test
