// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FamilyGallery.h"

#include "Icons.h"
#include "PolygonFamilies.h"

#include <QGridLayout>
#include <QToolButton>

namespace pemesh
{

namespace
{
constexpr int Columns = 2;
constexpr int PictureSize = 52;
}

FamilyGallery::FamilyGallery(QWidget* parent)
  : QWidget(parent)
{
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(10, 6, 10, 10);
  grid->setSpacing(4);
  int position = 0;
  QToolButton* draw = this->AddButton(
    position++, tr("Draw"), tr("Draw a polygon by hand: drag around it, or click its corners (D)"));
  draw->setIcon(MakeIcon("draw"));
  connect(draw, &QToolButton::clicked, this, &FamilyGallery::DrawingWanted);
  QToolButton* file = this->AddButton(position++, tr("From file"),
    tr("Add the polygon of a file: OFF, OBJ, STL, NODE, VTP, or points as CSV"));
  file->setIcon(MakeIcon("open"));
  connect(file, &QToolButton::clicked, this, &FamilyGallery::FileWanted);
  const auto families = PolygonFamilies();
  for (std::size_t i = 0; i < families.size(); ++i)
  {
    if (families[i].IsFixed())
    {
      continue;
    }
    QToolButton* button = this->AddButton(position++, QString::fromUtf8(families[i].Label),
      QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p>")
        .arg(QString::fromUtf8(families[i].Label), QString::fromUtf8(families[i].Description),
          QString::fromUtf8(families[i].Reference)));
    button->setObjectName(QStringLiteral("family-") + QString::fromUtf8(families[i].Name));
    const QString name = QString::fromUtf8(families[i].Name);
    connect(button, &QToolButton::clicked, this, [this, name] { emit this->FamilyChosen(name); });
    this->Entries.push_back({ static_cast<int>(i), button });
  }
  grid->setRowStretch(grid->rowCount(), 1);
  this->SetTime(0.5);
}

QToolButton* FamilyGallery::AddButton(int position, const QString& text, const QString& tip)
{
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(text);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize({ PictureSize, PictureSize });
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  if (position < Columns)
  {
    button->setIconSize({ PictureSize / 2, PictureSize / 2 });
  }
  static_cast<QGridLayout*>(this->layout())
    ->addWidget(button, position / Columns, position % Columns);
  return button;
}

void FamilyGallery::SetTime(double t)
{
  if (this->Time == t)
  {
    return;
  }
  this->Time = t;
  for (const Entry& entry : this->Entries)
  {
    entry.Button->setIcon(MakeFamilyIcon(entry.Family, t, PictureSize));
  }
}

} // namespace pemesh
