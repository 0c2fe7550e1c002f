// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EmptyState.h"

#include "Icons.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pemesh
{

EmptyState::EmptyState(const char* icon, const QString& title, const QString& text,
  const QString& button, QWidget* parent)
  : QWidget(parent)
{
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(12);
  layout->addStretch(2);
  auto* picture = new QLabel(this);
  picture->setPixmap(MakeIcon(icon).pixmap(QSize(56, 56)));
  layout->addWidget(picture, 0, Qt::AlignHCenter);
  auto* heading = new QLabel(title, this);
  heading->setObjectName(QStringLiteral("emptyTitle"));
  layout->addWidget(heading, 0, Qt::AlignHCenter);
  auto* words = new QLabel(text, this);
  words->setObjectName(QStringLiteral("emptyText"));
  words->setAlignment(Qt::AlignCenter);
  words->setWordWrap(true);
  words->setMinimumWidth(460);
  words->setMaximumWidth(560);
  layout->addWidget(words, 0, Qt::AlignHCenter);
  if (!button.isEmpty())
  {
    auto* push = new QPushButton(button, this);
    push->setObjectName(QStringLiteral("primary"));
    connect(push, &QPushButton::clicked, this, &EmptyState::Clicked);
    layout->addWidget(push, 0, Qt::AlignHCenter);
  }
  layout->addStretch(3);
}

} // namespace pemesh
