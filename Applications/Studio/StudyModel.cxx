// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyModel.h"

#include "DocumentPath.h"
#include "EditCommand.h"
#include "StudyFile.h"
#include "TextFile.h"

#include <QDir>
#include <QFileInfo>
#include <QUndoStack>

#include <stdexcept>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* Polygons = "polygons";
constexpr const char* Untitled = "untitled";

JsonValue EmptyDocument()
{
  return { JsonValue::Object{ { "pemesh", { std::int64_t{ 1 } } },
    { "name", { std::string(Untitled) } }, { Polygons, { JsonValue::List() } } } };
}

/** Gives the texts of a document that name files those of the study moved to another folder. */
void MovePaths(JsonValue& document, const Study& moved)
{
  const auto set = [&document](const std::string& path, const std::string& value)
  {
    if (HasPath(document, path))
    {
      SetAtPath(document, path, { value }, path);
    }
  };
  set("domain.file", moved.Domain.File);
  for (std::size_t i = 0; i < moved.Polygons.size(); ++i)
  {
    set("polygons[" + std::to_string(i) + "].file", moved.Polygons[i].File);
  }
  for (std::size_t i = 0; i < moved.Solvers.size(); ++i)
  {
    set("solvers[" + std::to_string(i) + "].solver", moved.Solvers[i].Solver);
  }
  if (!moved.Meshes.empty())
  {
    JsonValue::List meshes;
    for (const std::string& mesh : moved.Meshes)
    {
      meshes.push_back({ mesh });
    }
    SetAtPath(document, "meshes", { std::move(meshes) }, "meshes");
  }
}

} // namespace

StudyModel::StudyModel(QObject* parent)
  : QObject(parent)
  , Stack(new QUndoStack(this))
{
  connect(this->Stack, &QUndoStack::cleanChanged, this, &StudyModel::FileChanged);
  this->MakeNew();
}

StudyModel::~StudyModel() = default;

std::string StudyModel::GetText() const
{
  return FormatJson(this->Document);
}

int StudyModel::NewGesture()
{
  static int last = 0;
  return ++last;
}

/** Those in force, even where the document gives none or names a table of them. */
JsonValue::List StudyModel::GetItems(const std::string& list) const
{
  const JsonValue* given = FindAtPath(this->Document, list);
  if (given && given->As<JsonValue::List>())
  {
    return *given->As<JsonValue::List>();
  }
  const JsonValue full = ParseJson(FormatStudy(this->LastStudy), "study");
  const JsonValue* written = FindAtPath(full, list);
  return written && written->As<JsonValue::List>() ? *written->As<JsonValue::List>()
                                                   : JsonValue::List();
}

/** An item can be changed only in a list. */
void StudyModel::EnsureList(const std::string& path)
{
  const std::size_t end = path.find('[');
  const std::string list = path.substr(0, end);
  const JsonValue* given = FindAtPath(this->Document, list);
  if (end != std::string::npos && (!given || !given->As<JsonValue::List>()))
  {
    this->Stack->push(new EditCommand(
      this, list, JsonValue{ this->GetItems(list) }, tr("List the %1").arg(list.c_str()), 0));
  }
}

void StudyModel::SetValue(
  const std::string& path, const JsonValue& value, const QString& text, int gesture)
{
  const JsonValue* before = FindAtPath(this->Document, path);
  if (before && FormatJsonCompact(*before) == FormatJsonCompact(value))
  {
    return;
  }
  this->EnsureList(path);
  this->Stack->push(new EditCommand(this, path, value, text, gesture));
}

void StudyModel::RemoveValue(const std::string& path, const QString& text)
{
  this->EnsureList(path);
  if (!HasPath(this->Document, path))
  {
    return;
  }
  if (!path.ends_with(']'))
  {
    this->Stack->push(new EditCommand(this, path, std::nullopt, text, 0));
    return;
  }
  // An item comes back to its place only with the whole list.
  const std::size_t begin = path.rfind('[');
  const std::string list = path.substr(0, begin);
  JsonValue items = *FindAtPath(this->Document, list);
  items.As<JsonValue::List>()->erase(
    items.As<JsonValue::List>()->begin() + std::stoi(path.substr(begin + 1)));
  this->Stack->push(new EditCommand(this, list, items, text, 0));
}

void StudyModel::AddItem(const std::string& list, const JsonValue& item, const QString& text)
{
  JsonValue::List items = this->GetItems(list);
  items.push_back(item);
  this->Stack->push(new EditCommand(this, list, JsonValue{ std::move(items) }, text, 0));
}

void StudyModel::MoveItem(const std::string& list, int from, int to, const QString& text)
{
  JsonValue::List items = this->GetItems(list);
  const int count = static_cast<int>(items.size());
  if (from == to || from < 0 || to < 0 || from >= count || to >= count)
  {
    return;
  }
  const JsonValue moved = items[static_cast<std::size_t>(from)];
  items.erase(items.begin() + from);
  items.insert(items.begin() + to, moved);
  this->Stack->push(new EditCommand(this, list, JsonValue{ std::move(items) }, text, 0));
}

void StudyModel::Apply(const std::string& path, const std::optional<JsonValue>& value)
{
  value ? SetAtPath(this->Document, path, *value, path) : RemoveAtPath(this->Document, path);
  this->Parse();
  emit this->Changed();
}

std::string StudyModel::GetFolder() const
{
  return (this->File.isEmpty() ? QDir::homePath() : QFileInfo(this->File).absolutePath())
    .toStdString();
}

void StudyModel::Parse()
{
  const std::string source = this->File.isEmpty()
    ? this->GetFolder() + "/untitled.json"
    : QFileInfo(this->File).absoluteFilePath().toStdString();
  try
  {
    this->LastStudy = ParseStudy(this->GetText(), source);
    this->Fault.clear();
  }
  catch (const std::exception& error)
  {
    this->Fault = QString::fromUtf8(error.what());
  }
}

void StudyModel::Reset(JsonValue document, const QString& file)
{
  this->Document = std::move(document);
  this->File = file;
  this->IsRecovered = false;
  this->LastStudy = {};
  this->Parse();
  this->Stack->clear();
  emit this->FileChanged();
  emit this->Changed();
}

void StudyModel::MakeNew()
{
  this->Reset(EmptyDocument(), {});
}

void StudyModel::MakeFromMeshes(const QStringList& files)
{
  JsonValue::List meshes;
  for (const QString& file : files)
  {
    meshes.push_back({ QFileInfo(file).absoluteFilePath().toStdString() });
  }
  const std::string name = files.size() == 1
    ? QFileInfo(files.front()).completeBaseName().toStdString()
    : std::string("meshes");
  this->Reset({ JsonValue::Object{ { "pemesh", { std::int64_t{ 1 } } }, { "name", { name } },
                { "meshes", { std::move(meshes) } } } },
    {});
}

void StudyModel::Open(const QString& file)
{
  const std::string path = QFileInfo(file).absoluteFilePath().toStdString();
  const std::string text = ReadTextFile(path);
  ParseStudy(text, path); // throws before anything is lost
  this->Reset(ParseJson(text, path), QString::fromStdString(path));
}

void StudyModel::Save(const QString& file)
{
  const QString path = QFileInfo(file).absoluteFilePath();
  const fs::path folder = QFileInfo(path).absolutePath().toStdString();
  if (folder != fs::path(this->GetFolder()))
  {
    JsonValue moved = this->Document;
    MovePaths(moved, MoveStudy(this->LastStudy, folder));
    this->Document = std::move(moved);
  }
  WriteTextFile(path.toStdString(), this->GetText());
  this->File = path;
  this->IsRecovered = false;
  this->Parse();
  this->Stack->setClean();
  emit this->FileChanged();
}

void StudyModel::Recover(const std::string& text, const QString& file)
{
  this->Reset(ParseJson(text, "recovered study"), file);
  this->IsRecovered = true;
  emit this->FileChanged();
}

QString StudyModel::GetTitle() const
{
  if (!this->File.isEmpty())
  {
    return QFileInfo(this->File).fileName();
  }
  return this->LastStudy.Name.empty() || this->LastStudy.Name == Untitled
    ? tr("Untitled study")
    : QString::fromStdString(this->LastStudy.Name);
}

bool StudyModel::IsModified() const
{
  return this->IsRecovered || !this->Stack->isClean();
}

} // namespace pemesh
