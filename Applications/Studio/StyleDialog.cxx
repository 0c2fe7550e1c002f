// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StyleDialog.h"

#include "NumberEdit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr double LargestShown = 1e6;

QString KeyOf(const std::string& name)
{
  return QStringLiteral("plot/") + QString::fromStdString(name);
}

} // namespace

ChartStyle LoadPlotStyle()
{
  ChartStyle style;
  const QSettings settings;
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    const QString text = settings.value(KeyOf(field.Name)).toString();
    try
    {
      if (!text.isEmpty())
      {
        SetSetting(ChartStyleFields(), style, field.Name, text.toStdString());
      }
    }
    catch (const std::exception&) // of another version: the default stays
    {
    }
  }
  return style;
}

StyleDialog::StyleDialog(QWidget* parent)
  : QDialog(parent)
  , Style(LoadPlotStyle())
{
  this->setWindowTitle(tr("Plot settings"));
  this->resize(460, 640);
  auto* content = new QWidget(this);
  this->Form = new QFormLayout(content);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  auto* buttons = new QDialogButtonBox(
    QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults, Qt::Horizontal, this);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll, 1);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
    [this]
    {
      for (const SettingField<ChartStyle>& field : ChartStyleFields())
      {
        QSettings().remove(KeyOf(field.Name));
      }
      this->Style = ChartStyle();
      this->Fill();
      emit this->Changed();
    });
  this->Fill();
}

void StyleDialog::Fill()
{
  while (this->Form->rowCount() > 0)
  {
    this->Form->removeRow(0);
  }
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    QWidget* editor = this->MakeEditor(field);
    editor->setToolTip(QString::fromStdString(field.Description + " " + DescribeSetting(field)));
    editor->setAccessibleName(QString::fromStdString(field.Label));
    this->Form->addRow(QString::fromStdString(field.Label), editor);
  }
}

void StyleDialog::Set(const std::string& name, const QString& text)
{
  try
  {
    SetSetting(ChartStyleFields(), this->Style, name, text.toStdString());
    QSettings().setValue(KeyOf(name), text);
    emit this->Changed();
  }
  catch (const std::exception&) // a colour that is half typed
  {
  }
}

QWidget* StyleDialog::MakeEditor(const SettingField<ChartStyle>& field)
{
  const QString value = QString::fromStdString(GetSetting(field, this->Style));
  const std::string name = field.Name;
  if (!field.Choices.empty())
  {
    auto* box = new QComboBox(this);
    for (const std::string& choice : field.Choices)
    {
      box->addItem(QString::fromStdString(choice));
    }
    box->setCurrentText(value);
    connect(box, &QComboBox::currentTextChanged, this,
      [this, name](const QString& text) { this->Set(name, text); });
    return box;
  }
  if (std::holds_alternative<bool ChartStyle::*>(field.Member))
  {
    auto* box = new QCheckBox(this);
    box->setChecked(value == QLatin1String("true"));
    connect(box, &QCheckBox::toggled, this,
      [this, name](bool on) { this->Set(name, on ? "true" : "false"); });
    return box;
  }
  if (std::holds_alternative<std::string ChartStyle::*>(field.Member))
  {
    auto* edit = new QLineEdit(value, this);
    connect(edit, &QLineEdit::textChanged, this,
      [this, name](const QString& text) { this->Set(name, text); });
    return edit;
  }
  auto* edit = new NumberEdit(this);
  edit->SetInteger(std::holds_alternative<int ChartStyle::*>(field.Member));
  edit->setRange(std::max(field.Least, -LargestShown), std::min(field.Greatest, LargestShown));
  edit->setValue(value.toDouble());
  connect(edit, &QDoubleSpinBox::valueChanged, this,
    [this, name, edit](double) { this->Set(name, edit->text()); });
  return edit;
}

} // namespace pemesh
