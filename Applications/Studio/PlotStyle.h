// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How charts look in the window: as the user likes it, and on top what the study says.
 */
#ifndef pemesh_PlotStyle_h
#define pemesh_PlotStyle_h

#include "ChartStyle.h"

#include <QString>

namespace pemesh
{

struct Study;

///@{
/** The style of the user, kept from session to session. */
ChartStyle LoadUserStyle();
void SaveUserStyle(const std::string& name, const QString& text);
void ResetUserStyle();
///@}

/** What charts are drawn with: that of the user, with what differs from the default in the study.
 */
ChartStyle LoadPlotStyle();

/**
 * The study that charts belong to from now on. True if they look otherwise than before. Where its
 * style cannot be read, `fault` is one sentence, and charts look as the user likes it; where its
 * font is not installed, the sentence says which is drawn.
 */
bool UseStyleOfStudy(const Study& study, QString& fault);

} // namespace pemesh

#endif
