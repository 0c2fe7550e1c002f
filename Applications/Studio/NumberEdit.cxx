// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "NumberEdit.h"

#include "NumberText.h"

#include <QWheelEvent>

#include <cmath>

namespace pemesh
{

namespace
{
constexpr int Decimals = 30; // more than a double has, so that nothing is rounded
}

NumberEdit::NumberEdit(QWidget* parent)
  : QDoubleSpinBox(parent)
{
  this->setDecimals(Decimals);
  this->setRange(-1e15, 1e15);
  this->setKeyboardTracking(false);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
}

void NumberEdit::SetInteger(bool isInteger)
{
  this->IsInteger = isInteger;
  this->setDecimals(isInteger ? 0 : Decimals);
  this->setStepType(
    isInteger ? QAbstractSpinBox::DefaultStepType : QAbstractSpinBox::AdaptiveDecimalStepType);
}

void NumberEdit::SetOptional(const QString& text)
{
  this->IsOptional = true;
  this->setMinimum(this->minimum() - 1.0);
  this->setSpecialValueText(text);
}

QString NumberEdit::textFromValue(double value) const
{
  return this->IsInteger ? QString::number(std::llround(value))
                         : QString::fromStdString(FormatNumber(value));
}

double NumberEdit::valueFromText(const QString& text) const
{
  if (this->IsOptional && text == this->specialValueText())
  {
    return this->minimum();
  }
  return ParseNumber(text.toStdString()).value_or(0.0);
}

QValidator::State NumberEdit::validate(QString& text, int&) const
{
  if (this->IsOptional && text == this->specialValueText())
  {
    return QValidator::Acceptable;
  }
  const std::optional<double> value = ParseNumber(text.toStdString());
  if (!value)
  {
    // What may still become a number, such as "-", "1e" and nothing at all.
    static const QString allowed = QStringLiteral("0123456789.eE+-");
    for (const QChar c : text)
    {
      if (!allowed.contains(c))
      {
        return QValidator::Invalid;
      }
    }
    return QValidator::Intermediate;
  }
  const double least = this->minimum() + (this->IsOptional ? 1.0 : 0.0);
  const bool inRange = *value >= least && *value <= this->maximum() &&
    (!this->IsInteger || *value == std::trunc(*value));
  return inRange ? QValidator::Acceptable : QValidator::Intermediate;
}

QSize NumberEdit::sizeHint() const
{
  QSize size = QDoubleSpinBox::sizeHint();
  size.setWidth(this->fontMetrics().horizontalAdvance(QStringLiteral("0.000000000")) + 40);
  return size;
}

/** Two of them, a label and a button are in a row of a form. */
QSize NumberEdit::minimumSizeHint() const
{
  QSize size = this->sizeHint();
  size.setWidth(this->fontMetrics().horizontalAdvance(QStringLiteral("0.0000")) + 40);
  return size;
}

void NumberEdit::wheelEvent(QWheelEvent* event)
{
  this->hasFocus() ? QDoubleSpinBox::wheelEvent(event) : event->ignore();
}

} // namespace pemesh
