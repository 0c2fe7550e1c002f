// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the tests of the window share: waiting, pictures, a watchdog.
 */
#ifndef StudioSupport_h
#define StudioSupport_h

#include <QElapsedTimer>
#include <QString>
#include <QTimer>

#include <functional>
#include <string>

class QPoint;
class QWidget;

namespace studio_test
{

/** Lets the event loop turn until it is so, or some seconds have passed. */
bool WaitFor(const std::function<bool()>& condition, int milliseconds = 60000);

/** Saves a picture of a widget; kept as documentation where PEMESH_STUDIO_PICTURES names a folder.
 */
void Keep(QWidget* widget, const char* name);

/** Presses the left button, moves in some steps and lets it go. */
void Drag(QWidget* widget, const QPoint& from, const QPoint& to);

std::string ReadFile(const std::string& path);

/**
 * The longest time between two turns of the event loop. On a machine that has much else to do, what
 * the window itself did in a turn says more: the time of its thread.
 */
class Watchdog
{
public:
  Watchdog();
  qint64 GetLongestStall() const { return this->Longest; }
  qint64 GetLongestWork() const { return this->LongestWork; }
  /** Both, for a person to read. */
  std::string Describe() const;
  void Restart();

private:
  QTimer Timer;
  QElapsedTimer Clock;
  qint64 Longest = 0;
  qint64 Work = 0; // of the thread, at the last turn
  qint64 LongestWork = 0;
};

} // namespace studio_test

#endif
