// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PreferencesDialog.h"

#include "Preferences.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace pemesh
{

PreferencesDialog::PreferencesDialog(QWidget* parent)
  : QDialog(parent)
  , Form(new QFormLayout)
{
  this->setWindowTitle(tr("Preferences"));
  auto* buttons = new QDialogButtonBox(
    QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults, Qt::Horizontal, this);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(16);
  this->Form->setVerticalSpacing(10);
  layout->addLayout(this->Form);
  layout->addStretch(1);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
    [this]
    {
      ResetPreferences();
      this->Fill();
      emit this->Changed();
    });
  this->Fill();
}

void PreferencesDialog::Fill()
{
  while (this->Form->rowCount() > 0)
  {
    this->Form->removeRow(0);
  }
  for (const Preference& preference : Preferences())
  {
    QWidget* editor = this->MakeEditor(preference);
    editor->setObjectName(QLatin1String(preference.Key));
    editor->setToolTip(preference.Tip);
    editor->setAccessibleName(preference.Label);
    this->Form->addRow(preference.Label, editor);
  }
}

QWidget* PreferencesDialog::MakeEditor(const Preference& preference)
{
  const char* key = preference.Key;
  if (!preference.Choices.isEmpty())
  {
    auto* box = new QComboBox(this);
    box->addItems(preference.Choices);
    box->setCurrentIndex(GetPreference(key));
    connect(box, &QComboBox::currentIndexChanged, this,
      [this, key](int index) { this->Set(key, index); });
    return box;
  }
  auto* edit = new QSpinBox(this);
  edit->setRange(preference.Least, preference.Greatest);
  edit->setSuffix(preference.Unit);
  edit->setSpecialValueText(preference.WhenLeast);
  edit->setKeyboardTracking(false); // not with half a number
  edit->setValue(GetPreference(key));
  connect(edit, &QSpinBox::valueChanged, this, [this, key](int value) { this->Set(key, value); });
  return edit;
}

void PreferencesDialog::Set(const char* key, int value)
{
  SetPreference(key, value);
  emit this->Changed();
}

} // namespace pemesh
