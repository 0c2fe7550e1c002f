// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StyleDialog
 * @brief   How charts look, on the screen and in files: editors made from the table of settings.
 */
#ifndef pemesh_StyleDialog_h
#define pemesh_StyleDialog_h

#include "ChartStyle.h"

#include <QDialog>

class QFormLayout;

namespace pemesh
{

/** The style of the user, kept from session to session. */
ChartStyle LoadPlotStyle();

class StyleDialog : public QDialog
{
  Q_OBJECT
public:
  explicit StyleDialog(QWidget* parent = nullptr);

signals:
  /** Kept already; what is seen should be painted anew. */
  void Changed();

private:
  void Fill();
  void Set(const std::string& name, const QString& text);
  QWidget* MakeEditor(const SettingField<ChartStyle>& field);

  ChartStyle Style;
  QFormLayout* Form;
};

} // namespace pemesh

#endif
