// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlotStyle.h"

#include "ChartStyleFile.h"
#include "FontFiles.h"
#include "Study.h"

#include <QSettings>

#include <map>

namespace pemesh
{

namespace
{

/** Of the study, by name: what is not the default. */
std::map<std::string, std::string> OfStudy;

QString KeyOf(const std::string& name)
{
  return QStringLiteral("plot/") + QString::fromStdString(name);
}

} // namespace

ChartStyle LoadUserStyle()
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

void SaveUserStyle(const std::string& name, const QString& text)
{
  QSettings().setValue(KeyOf(name), text);
}

void ResetUserStyle()
{
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    QSettings().remove(KeyOf(field.Name));
  }
}

ChartStyle LoadPlotStyle()
{
  ChartStyle style = LoadUserStyle();
  for (const auto& [name, text] : OfStudy)
  {
    SetSetting(ChartStyleFields(), style, name, text);
  }
  return style;
}

bool UseStyleOfStudy(const Study& study, QString& fault)
{
  std::map<std::string, std::string> settings;
  try
  {
    const ChartStyle style = MakeChartStyle(study.Folder, { study.Style });
    for (const SettingField<ChartStyle>& field : ChartStyleFields())
    {
      const std::string text = GetSetting(field, style);
      if (text != GetSetting(field, ChartStyle()) || study.Style.Settings.contains(field.Name))
      {
        settings[field.Name] = text;
      }
    }
  }
  catch (const std::exception& error)
  {
    fault = QString::fromUtf8(error.what());
  }
  const bool isOther = settings != OfStudy;
  OfStudy = std::move(settings);
  if (isOther && fault.isEmpty())
  {
    fault = QString::fromStdString(WhyOtherFont(LoadPlotStyle().FontFamily));
  }
  return isOther;
}

} // namespace pemesh
