// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Appearance.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

#include <cmath>
#include <utility>

namespace pemesh
{

namespace
{

const Theme LightTheme{ "#f4f6f8", "#ffffff", "#ffffff", "#1f2a35", "#64727f", "#d6dce2", "#1f6fb2",
  "#e2eefa", "#b3261e", "#fdeceb", false };
const Theme DarkTheme{ "#1d2126", "#262b31", "#1a1e22", "#e4e8ec", "#98a4b0", "#3b434c", "#5aa9e6",
  "#2b4258", "#f2a29c", "#4a2a2a", true };

Theme Current = LightTheme;
double Scale = 1.0; // of text

/** Colours by name in place of @name. */
QString StyleSheetOf(const Theme& theme)
{
  QString sheet = QStringLiteral(R"(
QMainWindow, QDialog { background: @window; }
QToolTip { background: @panel; color: @text; border: 1px solid @border; padding: 4px; }
QMenuBar { background: @window; }
QToolBar { background: @window; border: 0; border-bottom: 1px solid @border; padding: 4px 8px;
  spacing: 2px; }
QToolBar::separator { background: @border; width: 1px; margin: 6px 6px; }
QToolButton { border: 1px solid transparent; border-radius: 6px; padding: 5px 8px; }
QToolButton:hover { background: @soft; }
QToolButton:checked { background: @soft; border-color: @accent; }
QToolButton:pressed { background: @border; }
QToolButton:disabled { color: @muted; }
#navigation { background: @panel; border-right: 1px solid @border; }
#navigation QToolButton { border-radius: 8px; padding: 10px 4px; color: @muted; }
#navigation QToolButton:checked { color: @accent; border-color: transparent; background: @soft;
  font-weight: 600; }
#sidePanel { background: @panel; border: 0; border-left: 1px solid @border; }
#leftPanel { background: @panel; border: 0; border-right: 1px solid @border; }
#barAbove { background: @panel; border: 0; border-bottom: 1px solid @border; }
#barBelow { background: @panel; border: 0; border-top: 1px solid @border; }
#heading { font-weight: 600; font-size: @size14; }
#muted { color: @muted; }
#emptyTitle { font-size: @size20; font-weight: 600; }
#emptyText { color: @muted; font-size: @size14; }
#fault { background: @dangersoft; color: @danger; border: 1px solid @danger; border-radius: 6px;
  padding: 6px 10px; }
#primary { background: @accent; color: @onaccent; border: 0; border-radius: 6px;
  padding: 7px 16px; font-weight: 600; }
#primary:hover { background: @text; color: @panel; }
#primary:disabled { background: @border; color: @muted; }
QPushButton { background: @panel; border: 1px solid @border; border-radius: 6px;
  padding: 6px 14px; }
QPushButton:hover { border-color: @accent; }
QPushButton:disabled { color: @muted; }
QListView::item { padding: 3px; }
QTableView, QListView, QTreeView, QPlainTextEdit, QTextBrowser { background: @panel; border: 0;
  selection-background-color: @soft; selection-color: @text; alternate-background-color: @window;
  gridline-color: @border; }
QHeaderView::section { background: @window; color: @muted; border: 0;
  border-bottom: 1px solid @border; padding: 4px 6px; font-weight: 600; }
QTabBar { qproperty-drawBase: 0; }
QTabWidget::pane { border: 0; border-top: 1px solid @border; }
QTabBar::tab { background: transparent; color: @muted; padding: 7px 12px; border: 0;
  border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; font-weight: 600; }
QScrollArea { background: transparent; border: 0; }
QScrollArea > QWidget > QWidget { background: transparent; }
QScrollBar { background: transparent; border: 0; }
QScrollBar:vertical { width: 10px; } QScrollBar:horizontal { height: 10px; }
QScrollBar::handle { background: @border; border-radius: 5px; min-height: 24px; min-width: 24px; }
QScrollBar::handle:hover { background: @muted; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QDockWidget { color: @muted; }
QDockWidget::title { background: @window; padding: 5px 8px; border-top: 1px solid @border; }
QStatusBar { background: @window; border-top: 1px solid @border; }
QStatusBar::item { border: 0; }
QProgressBar { background: @border; border: 0; border-radius: 4px; max-height: 8px; }
QProgressBar::chunk { background: @accent; border-radius: 4px; }
QSplitter::handle { background: @border; }
QSlider::groove:horizontal { background: @border; height: 4px; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { background: @panel; border: 2px solid @accent; width: 12px;
  margin: -6px 0; border-radius: 8px; }
QSlider::handle:horizontal:disabled { border-color: @border; }
)");
  const std::pair<const char*, QColor> names[] = { { "@window", theme.Window },
    { "@panel", theme.Panel }, { "@text", theme.Text }, { "@muted", theme.Muted },
    { "@border", theme.Border }, { "@accent", theme.Accent }, { "@soft", theme.AccentSoft },
    { "@dangersoft", theme.DangerSoft }, { "@danger", theme.Danger },
    { "@onaccent", theme.IsDark ? theme.Window : theme.Panel } };
  for (const auto& [name, color] : names)
  {
    sheet.replace(QLatin1String(name), color.name());
  }
  for (const auto& [name, pixels] : { std::pair("@size14", 14.0), { "@size20", 20.0 } })
  {
    sheet.replace(QLatin1String(name), QStringLiteral("%1px").arg(std::lround(Scale * pixels)));
  }
  return sheet;
}

QPalette PaletteOf(const Theme& theme)
{
  QPalette palette;
  palette.setColor(QPalette::Window, theme.Window);
  palette.setColor(QPalette::WindowText, theme.Text);
  palette.setColor(QPalette::Base, theme.Panel);
  palette.setColor(QPalette::AlternateBase, theme.Window);
  palette.setColor(QPalette::Text, theme.Text);
  palette.setColor(QPalette::Button, theme.Panel);
  palette.setColor(QPalette::ButtonText, theme.Text);
  palette.setColor(QPalette::BrightText, theme.Danger);
  palette.setColor(QPalette::ToolTipBase, theme.Panel);
  palette.setColor(QPalette::ToolTipText, theme.Text);
  palette.setColor(QPalette::PlaceholderText, theme.Muted);
  palette.setColor(QPalette::Highlight, theme.Accent);
  palette.setColor(QPalette::HighlightedText, theme.IsDark ? theme.Window : theme.Panel);
  palette.setColor(QPalette::Link, theme.Accent);
  for (const auto role : { QPalette::WindowText, QPalette::Text, QPalette::ButtonText })
  {
    palette.setColor(QPalette::Disabled, role, theme.Muted);
  }
  return palette;
}

} // namespace

const Theme& CurrentTheme()
{
  return Current;
}

double TextScale()
{
  return Scale;
}

void ApplyTheme(QApplication& application, ThemeChoice choice, double textSize)
{
  static const QFont systemFont = QApplication::font();
  static const bool systemIsDark =
    QApplication::palette().color(QPalette::Window).lightnessF() < 0.5;
  const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && systemIsDark);
  Current = dark ? DarkTheme : LightTheme;
  QFont font = systemFont;
  Scale = textSize > 0.0 && font.pointSizeF() > 0.0 ? textSize / font.pointSizeF() : 1.0;
  font.setPointSizeF(Scale * font.pointSizeF());
  QApplication::setFont(font);
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(PaletteOf(Current));
  application.setStyleSheet(StyleSheetOf(Current));
}

} // namespace pemesh
