// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   NumberEdit
 * @brief   A field for one number, which shows it as the document has it: 0.1, not 0.100.
 *
 * The wheel turns it only while it has the focus, so that a form can be scrolled.
 */
#ifndef pemesh_NumberEdit_h
#define pemesh_NumberEdit_h

#include <QDoubleSpinBox>

namespace pemesh
{

class NumberEdit : public QDoubleSpinBox
{
public:
  explicit NumberEdit(QWidget* parent = nullptr);

  void SetInteger(bool isInteger);
  /** May be unset, which the text says in place of a number; it is the step below the least. */
  void SetOptional(const QString& text);
  bool IsUnset() const { return this->IsOptional && this->value() == this->minimum(); }
  void Unset() { this->setValue(this->minimum()); }

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void wheelEvent(QWheelEvent* event) override;

private:
  bool IsInteger = false;
  bool IsOptional = false;
};

} // namespace pemesh

#endif
