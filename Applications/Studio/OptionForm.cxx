// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "OptionForm.h"

#include "DocumentPath.h"
#include "Icons.h"
#include "NumberEdit.h"
#include "StudyModel.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr double LargestShown = 1e15;
constexpr const char* FileChoice = "file";

/** "max-area" to "Max area". */
QString LabelOf(const std::string& key)
{
  QString label = QString::fromStdString(key).replace(QLatin1Char('-'), QLatin1Char(' '));
  label[0] = label[0].toUpper();
  return label;
}

QString TipOf(const FormField& field)
{
  return QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p>")
    .arg(QString::fromStdString(field.Path).toHtmlEscaped(),
      QString::fromStdString(field.Doc).toHtmlEscaped(),
      QString::fromStdString(field.Type).toHtmlEscaped());
}

/** The object of a path: "mesh.max-area" of "mesh.max-area.rule". */
std::string OwnerOf(const std::string& path)
{
  return path.substr(0, path.rfind('.'));
}

bool SameEditors(const std::vector<FormField>& a, const FormField& b, std::size_t i)
{
  return i < a.size() && a[i].Path == b.Path && a[i].Form.Kind == b.Form.Kind &&
    a[i].Form.Choices == b.Form.Choices && a[i].Form.Least == b.Form.Least &&
    a[i].Form.Greatest == b.Form.Greatest;
}

} // namespace

OptionForm::OptionForm(StudyModel* model, QWidget* parent)
  : QWidget(parent)
  , Model(model)
{
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(14, 10, 10, 10);
  layout->setHorizontalSpacing(10);
  layout->setVerticalSpacing(7);
  layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layout->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  connect(model, &StudyModel::Changed, this, &OptionForm::Refresh);
}

QFormLayout* OptionForm::GetLayout() const
{
  return static_cast<QFormLayout*>(this->layout());
}

void OptionForm::SetPath(const std::string& path)
{
  if (this->Path != path)
  {
    this->Path = path;
    this->Refresh();
  }
}

void OptionForm::SetOtherFields(std::function<std::vector<FormField>()> other)
{
  this->Other = std::move(other);
  this->Refresh();
}

void OptionForm::SetHiddenKeys(const std::vector<std::string>& keys)
{
  this->HiddenKeys = keys;
  this->Refresh();
}

std::vector<FormField> OptionForm::ReadFields() const
{
  std::vector<FormField> fields;
  if (!this->Path.empty())
  {
    fields = DescribeStudyForm(this->Model->GetStudy(), this->Path);
    if (this->Other)
    {
      const std::vector<FormField> other = this->Other();
      fields.insert(fields.end(), other.begin(), other.end());
    }
  }
  std::erase_if(fields,
    [this](const FormField& field)
    {
      return std::find(this->HiddenKeys.begin(), this->HiddenKeys.end(), field.Key) !=
        this->HiddenKeys.end();
    });
  return fields;
}

void OptionForm::Refresh()
{
  const std::vector<FormField> fields = this->ReadFields();
  bool same = fields.size() == this->Rows.size();
  for (std::size_t i = 0; same && i < fields.size(); ++i)
  {
    same = SameEditors(fields, this->Rows[i].Field, i);
  }
  if (!same)
  {
    this->Rebuild(fields);
  }
  this->IsShowing = true;
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    Row& row = this->Rows[i];
    row.Field = fields[i];
    if (fields[i].Value)
    {
      row.Show(*fields[i].Value);
    }
    else if (row.ShowUnset)
    {
      row.ShowUnset();
    }
    row.Reset->setVisible(
      !fields[i].IsRequired && HasPath(this->Model->GetDocument(), fields[i].Path));
  }
  this->IsShowing = false;
}

void OptionForm::Rebuild(const std::vector<FormField>& fields)
{
  QFormLayout* layout = this->GetLayout();
  while (layout->rowCount() > 0)
  {
    const QFormLayout::TakeRowResult row = layout->takeRow(0);
    for (QLayoutItem* item : { row.labelItem, row.fieldItem })
    {
      if (item && item->widget())
      {
        item->widget()->hide();
        item->widget()->deleteLater(); // one of them may be the sender
      }
      delete item;
    }
  }
  this->Rows.clear();
  this->Rows.reserve(fields.size());
  std::string owner = this->Path;
  for (const FormField& field : fields)
  {
    if (OwnerOf(field.Path) != owner)
    {
      owner = OwnerOf(field.Path);
      if (owner.size() > this->Path.size())
      {
        auto* heading = new QLabel(LabelOf(owner.substr(this->Path.size() + 1)), this);
        heading->setObjectName(QStringLiteral("heading"));
        heading->setContentsMargins(0, 10, 0, 0);
        layout->addRow(heading);
      }
    }
    this->AddRow(field);
  }
}

QWidget* OptionForm::AddRow(const FormField& field)
{
  Row& row = this->Rows.emplace_back();
  row.Field = field;
  auto* box = new QWidget(this);
  auto* line = new QHBoxLayout(box);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(4);
  QWidget* editor = this->MakeEditor(row);
  editor->setToolTip(TipOf(field));
  editor->setAccessibleName(QString::fromStdString(field.Path));
  editor->setObjectName(QString::fromStdString(field.Path));
  row.Reset = new QToolButton(box);
  row.Reset->setIcon(MakeIcon("reset"));
  row.Reset->setIconSize({ 14, 14 });
  row.Reset->setToolTip(tr("Back to the default"));
  row.Reset->setAccessibleName(tr("Default of %1").arg(QString::fromStdString(field.Path)));
  QSizePolicy policy = row.Reset->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  row.Reset->setSizePolicy(policy);
  connect(row.Reset, &QToolButton::clicked, this,
    [this, path = field.Path, key = field.Key]
    { this->Model->RemoveValue(path, tr("Default of %1").arg(QString::fromStdString(key))); });
  line->addWidget(editor, 1);
  line->addWidget(row.Reset);
  auto* label = new QLabel(LabelOf(field.Key), this);
  label->setToolTip(TipOf(field));
  label->setBuddy(editor);
  this->GetLayout()->addRow(label, box);
  return box;
}

QWidget* OptionForm::MakeEditor(Row& row)
{
  switch (row.Field.Form.Kind)
  {
    case ValueForm::Number:
    case ValueForm::Integer:
      return this->MakeNumber(row);
    case ValueForm::Pair:
      return this->MakePair(row);
    case ValueForm::Choice:
      return this->MakeChoice(row);
    case ValueForm::Truth:
      return this->MakeTruth(row);
    default:
      return this->MakeText(row);
  }
}

int OptionForm::GestureOf(const std::string& path)
{
  if (this->GesturePath != path)
  {
    this->GesturePath = path;
    this->Gesture = StudyModel::NewGesture();
  }
  return this->Gesture;
}

void OptionForm::Set(const FormField& field, const JsonValue& value)
{
  if (!this->IsShowing)
  {
    this->Model->SetValue(field.Path, value, tr("Change %1").arg(QString::fromStdString(field.Key)),
      this->GestureOf(field.Path));
  }
}

void OptionForm::Unset(const FormField& field)
{
  if (!this->IsShowing)
  {
    this->Model->RemoveValue(
      field.Path, tr("Default of %1").arg(QString::fromStdString(field.Key)));
  }
}

void OptionForm::Choose(const FormField& field, const std::string& choice)
{
  if (this->IsShowing)
  {
    return;
  }
  const QString text = tr("Change %1").arg(QString::fromStdString(field.Key));
  if (choice == FileChoice)
  {
    const QString file =
      QFileDialog::getOpenFileName(this, tr("File of %1").arg(LabelOf(field.Key)));
    if (!file.isEmpty())
    {
      this->Model->SetValue(OwnerOf(field.Path),
        { JsonValue::Object{ { field.Key, { choice } }, { "file", { file.toStdString() } } } },
        text);
    }
    this->Refresh();
    return;
  }
  try
  {
    const JsonValue chosen = ChooseInDocument(this->Model->GetDocument(), field.Path, choice);
    if (!HasPath(chosen, field.Path)) // which no table knows
    {
      this->Model->SetValue(field.Path, { choice }, text);
      return;
    }
    this->Model->SetValue(OwnerOf(field.Path), *FindAtPath(chosen, OwnerOf(field.Path)), text);
  }
  catch (const std::exception&) // the document was wrong before: it says so itself
  {
    this->Model->SetValue(field.Path, { choice }, text);
  }
}

QWidget* OptionForm::MakeNumber(Row& row)
{
  const FormField field = row.Field;
  auto* edit = new NumberEdit(this);
  edit->SetInteger(field.Form.Kind == ValueForm::Integer);
  edit->setRange(
    std::max(field.Form.Least, -LargestShown), std::min(field.Form.Greatest, LargestShown));
  if (!field.Form.WhenUnset.empty())
  {
    edit->SetOptional(QString::fromStdString(field.Form.WhenUnset));
    row.ShowUnset = [edit] { edit->Unset(); };
  }
  row.Show = [edit](const JsonValue& value)
  {
    if (value.IsNumber() && edit->value() != value.ToNumber())
    {
      edit->setValue(value.ToNumber());
    }
  };
  connect(edit, &QDoubleSpinBox::valueChanged, this,
    [this, field, edit](double value)
    { edit->IsUnset() ? this->Unset(field) : this->Set(field, JsonNumber(value)); });
  return edit;
}

QWidget* OptionForm::MakePair(Row& row)
{
  const FormField field = row.Field;
  auto* box = new QWidget(this);
  auto* line = new QHBoxLayout(box);
  line->setContentsMargins(0, 0, 0, 0);
  NumberEdit* edits[2] = { new NumberEdit(box), new NumberEdit(box) };
  for (NumberEdit* edit : edits)
  {
    line->addWidget(edit);
    edit->setAccessibleName(QString::fromStdString(field.Path) + (edit == edits[0] ? " x" : " y"));
    connect(edit, &QDoubleSpinBox::valueChanged, this,
      [this, field, x = edits[0], y = edits[1]] {
        this->Set(field, { JsonValue::List{ JsonNumber(x->value()), JsonNumber(y->value()) } });
      });
  }
  row.Show = [x = edits[0], y = edits[1]](const JsonValue& value)
  {
    const auto* list = value.As<JsonValue::List>();
    if (list && list->size() == 2 && (*list)[0].IsNumber() && (*list)[1].IsNumber())
    {
      x->setValue((*list)[0].ToNumber());
      y->setValue((*list)[1].ToNumber());
    }
  };
  return box;
}

QWidget* OptionForm::MakeChoice(Row& row)
{
  const FormField field = row.Field;
  auto* box = new QComboBox(this);
  box->setFocusPolicy(Qt::StrongFocus);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (const std::string& choice : field.Form.Choices)
  {
    box->addItem(QString::fromStdString(choice));
  }
  row.Show = [box](const JsonValue& value)
  {
    if (const auto* text = value.As<std::string>())
    {
      box->setCurrentText(QString::fromStdString(*text));
    }
  };
  connect(box, &QComboBox::currentTextChanged, this,
    [this, field](const QString& text) { this->Choose(field, text.toStdString()); });
  return box;
}

QWidget* OptionForm::MakeTruth(Row& row)
{
  const FormField field = row.Field;
  auto* box = new QCheckBox(this);
  row.Show = [box](const JsonValue& value)
  { box->setChecked(value.As<bool>() && *value.As<bool>()); };
  connect(
    box, &QCheckBox::toggled, this, [this, field](bool checked) { this->Set(field, { checked }); });
  return box;
}

/** Texts as they are; lists and whatever else as JSON. */
QWidget* OptionForm::MakeText(Row& row)
{
  const FormField field = row.Field;
  auto* edit = new QLineEdit(this);
  const bool isText = field.Form.Kind == ValueForm::Text;
  row.Show = [edit](const JsonValue& value)
  {
    const auto* text = value.As<std::string>();
    edit->setText(QString::fromStdString(text ? *text : FormatJsonCompact(value)));
  };
  connect(edit, &QLineEdit::editingFinished, this,
    [this, field, edit, isText]
    {
      const std::string text = edit->text().toStdString();
      const bool unchanged = !field.Value && text.empty();
      JsonValue value{ text };
      try
      {
        value = isText && !(field.Value && !field.Value->As<std::string>())
          ? value
          : ParseJson(text, field.Path);
      }
      catch (const std::exception&) // then it is a text
      {
      }
      if (!unchanged && edit->isModified())
      {
        this->Set(field, value);
      }
    });
  return edit;
}

} // namespace pemesh
