// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   PreferencesDialog
 * @brief   Editors for the table of preferences; what is changed is in force at once.
 */
#ifndef pemesh_PreferencesDialog_h
#define pemesh_PreferencesDialog_h

#include <QDialog>

class QFormLayout;

namespace pemesh
{

struct Preference;

class PreferencesDialog : public QDialog
{
  Q_OBJECT
public:
  explicit PreferencesDialog(QWidget* parent = nullptr);

signals:
  /** Kept already. */
  void Changed();

private:
  void Fill();
  QWidget* MakeEditor(const Preference& preference);
  void Set(const char* key, int value);

  QFormLayout* Form;
};

} // namespace pemesh

#endif
