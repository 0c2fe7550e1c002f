// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StyleDialog
 * @brief   How charts look, on the screen and in files: editors made from the table of settings.
 *
 * The settings of the user hold for all studies; those of the study are edits of its document, and
 * go before them. Either can be saved as a style of a name and loaded again.
 */
#ifndef pemesh_StyleDialog_h
#define pemesh_StyleDialog_h

#include "ChartStyle.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;

namespace pemesh
{

class StudyModel;

class StyleDialog : public QDialog
{
  Q_OBJECT
public:
  explicit StyleDialog(StudyModel* model, QWidget* parent = nullptr);

  ///@{
  /** Files of styles; an empty name does nothing. */
  void Load(const QString& file);
  void SaveAs(const QString& file);
  ///@}

signals:
  /** Kept already; what is seen should be painted anew. */
  void Changed();

private:
  QDialogButtonBox* MakeButtons();
  void Fill();
  void Reset();
  bool IsOfStudy() const;
  void Set(const SettingField<ChartStyle>& field, const QString& text);
  void SetInStudy(const SettingField<ChartStyle>& field, const QString& text);
  QWidget* MakeEditor(const SettingField<ChartStyle>& field);

  StudyModel* Model;
  QComboBox* Owner;
  ChartStyle Style;
  QFormLayout* Form;
};

} // namespace pemesh

#endif
