// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   EmptyState
 * @brief   What a page shows while there is nothing to show: what it is for and what to do next.
 */
#ifndef pemesh_EmptyState_h
#define pemesh_EmptyState_h

#include <QWidget>

namespace pemesh
{

class EmptyState : public QWidget
{
  Q_OBJECT
public:
  EmptyState(const char* icon, const QString& title, const QString& text, const QString& button,
    QWidget* parent = nullptr);

signals:
  void Clicked();
};

} // namespace pemesh

#endif
