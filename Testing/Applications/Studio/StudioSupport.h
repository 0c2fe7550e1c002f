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

/** The longest time between two turns of the event loop. */
class Watchdog
{
public:
  Watchdog();
  qint64 GetLongestStall() const { return this->Longest; }
  void Restart();

private:
  QTimer Timer;
  QElapsedTimer Clock;
  qint64 Longest = 0;
};

} // namespace studio_test

#endif
