// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StyleDialog.h"

#include "ChartStyleFile.h"
#include "DocumentPath.h"
#include "NumberEdit.h"
#include "PlotStyle.h"
#include "StudyModel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr double LargestShown = 1e6;
constexpr const char* StylePath = "style"; // in the document

/** As the document holds it. */
JsonValue JsonOf(const SettingField<ChartStyle>& field, const QString& text)
{
  if (std::holds_alternative<bool ChartStyle::*>(field.Member))
  {
    return { text == QLatin1String("true") };
  }
  return std::holds_alternative<std::string ChartStyle::*>(field.Member)
    ? JsonValue{ text.toStdString() }
    : JsonNumber(text.toDouble());
}

} // namespace

StyleDialog::StyleDialog(StudyModel* model, QWidget* parent)
  : QDialog(parent)
  , Model(model)
  , Owner(new QComboBox(this))
{
  this->setWindowTitle(tr("Plot settings"));
  this->resize(460, 680);
  this->Owner->addItems({ tr("all studies"), tr("this study, saved with it") });
  this->Owner->setAccessibleName(tr("Settings of"));
  auto* owner = new QFormLayout;
  owner->addRow(tr("Settings of"), this->Owner);
  auto* content = new QWidget(this);
  this->Form = new QFormLayout(content);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(owner);
  layout->addWidget(scroll, 1);
  layout->addWidget(this->MakeButtons());
  connect(this->Owner, &QComboBox::currentIndexChanged, this, &StyleDialog::Fill);
  connect(model, &StudyModel::Changed, this,
    [this]
    {
      if (this->IsOfStudy() && LoadPlotStyle() != this->Style) // undone, or another study
      {
        this->Fill();
      }
    });
  this->Fill();
}

QDialogButtonBox* StyleDialog::MakeButtons()
{
  auto* buttons = new QDialogButtonBox(
    QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults, Qt::Horizontal, this);
  QPushButton* load = buttons->addButton(tr("Load …"), QDialogButtonBox::ActionRole);
  QPushButton* save = buttons->addButton(tr("Save as …"), QDialogButtonBox::ActionRole);
  load->setToolTip(tr("Take the settings of a style that was saved as a file"));
  save->setToolTip(tr("Save these settings as a style of a name, for other studies and commands"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
    &StyleDialog::Reset);
  connect(load, &QPushButton::clicked, this,
    [this] {
      this->Load(QFileDialog::getOpenFileName(this, tr("Load a style"), {}, tr("Styles (*.json)")));
    });
  connect(save, &QPushButton::clicked, this,
    [this]
    {
      this->SaveAs(QFileDialog::getSaveFileName(
        this, tr("Save the style"), QStringLiteral("style.json"), tr("Styles (*.json)")));
    });
  return buttons;
}

void StyleDialog::Reset()
{
  if (!this->IsOfStudy())
  {
    ResetUserStyle();
  }
  else if (HasPath(this->Model->GetDocument(), StylePath))
  {
    this->Model->RemoveValue(StylePath, tr("Default style"));
  }
  this->Fill();
  emit this->Changed();
}

void StyleDialog::Load(const QString& file)
{
  try
  {
    const ChartStyle style = file.isEmpty() ? this->Style : ReadChartStyleFile(file.toStdString());
    for (const SettingField<ChartStyle>& field : ChartStyleFields())
    {
      const std::string text = GetSetting(field, style);
      if (text != GetSetting(field, this->Style))
      {
        this->Set(field, QString::fromStdString(text));
      }
    }
    this->Fill();
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this, tr("Load a style"), QString::fromUtf8(error.what()));
  }
}

void StyleDialog::SaveAs(const QString& file)
{
  try
  {
    if (!file.isEmpty())
    {
      WriteChartStyleFile(file.toStdString(), this->Style);
    }
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this, tr("Save the style"), QString::fromUtf8(error.what()));
  }
}

bool StyleDialog::IsOfStudy() const
{
  return this->Owner->currentIndex() == 1;
}

void StyleDialog::Fill()
{
  this->Style = this->IsOfStudy() ? LoadPlotStyle() : LoadUserStyle();
  while (this->Form->rowCount() > 0)
  {
    this->Form->removeRow(0);
  }
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    QWidget* editor = this->MakeEditor(field);
    editor->setObjectName(QString::fromStdString(field.Name));
    editor->setToolTip(QString::fromStdString(field.Description + " " + DescribeSetting(field)));
    editor->setAccessibleName(QString::fromStdString(field.Label));
    this->Form->addRow(QString::fromStdString(field.Label), editor);
  }
}

void StyleDialog::Set(const SettingField<ChartStyle>& field, const QString& text)
{
  try
  {
    SetSetting(ChartStyleFields(), this->Style, field.Name, text.toStdString());
  }
  catch (const std::exception&) // a colour that is half typed
  {
    return;
  }
  if (this->IsOfStudy())
  {
    this->SetInStudy(field, text);
  }
  else
  {
    SaveUserStyle(field.Name, text);
  }
  emit this->Changed();
}

/** A style that is the name of a file becomes what differs from the file. */
void StyleDialog::SetInStudy(const SettingField<ChartStyle>& field, const QString& text)
{
  const JsonValue* before = FindAtPath(this->Model->GetDocument(), StylePath);
  JsonValue style{ JsonValue::Object{} };
  if (before && before->As<JsonValue::Object>())
  {
    style = *before;
  }
  else if (before && before->As<std::string>())
  {
    style = { JsonValue::Object{ { "from", *before } } };
  }
  SetAtPath(style, field.Name, JsonOf(field, text), StylePath);
  this->Model->SetValue(StylePath, style, tr("Change %1").arg(QString::fromStdString(field.Label)));
}

QWidget* StyleDialog::MakeEditor(const SettingField<ChartStyle>& field)
{
  const QString value = QString::fromStdString(GetSetting(field, this->Style));
  if (!field.Choices.empty())
  {
    auto* box = new QComboBox(this);
    for (const std::string& choice : field.Choices)
    {
      box->addItem(QString::fromStdString(choice));
    }
    box->setCurrentText(value);
    connect(box, &QComboBox::currentTextChanged, this,
      [this, &field](const QString& text) { this->Set(field, text); });
    return box;
  }
  if (std::holds_alternative<bool ChartStyle::*>(field.Member))
  {
    auto* box = new QCheckBox(this);
    box->setChecked(value == QLatin1String("true"));
    connect(box, &QCheckBox::toggled, this,
      [this, &field](bool on) { this->Set(field, on ? "true" : "false"); });
    return box;
  }
  if (std::holds_alternative<std::string ChartStyle::*>(field.Member))
  {
    auto* edit = new QLineEdit(value, this);
    connect(edit, &QLineEdit::textChanged, this,
      [this, &field](const QString& text) { this->Set(field, text); });
    return edit;
  }
  auto* edit = new NumberEdit(this);
  edit->SetInteger(std::holds_alternative<int ChartStyle::*>(field.Member));
  edit->setRange(std::max(field.Least, -LargestShown), std::min(field.Greatest, LargestShown));
  edit->setValue(value.toDouble());
  connect(edit, &QDoubleSpinBox::valueChanged, this,
    [this, &field, edit](double) { this->Set(field, edit->text()); });
  return edit;
}

} // namespace pemesh
