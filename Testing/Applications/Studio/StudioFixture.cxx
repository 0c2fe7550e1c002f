// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudioFixture.h"
#include "TestFolder.h"

#include "LogDock.h"
#include "ResultSet.h"
#include "RunController.h"
#include "StudioSupport.h"
#include "StudyModel.h"
#include "StudyPreview.h"

#include <QTest>
#include <QToolButton>

#include <fstream>

using namespace pemesh;

namespace studio_test
{

namespace
{

/** One number a vertex, and the number of vertices as the performance. */
constexpr const char* GatedSolver = R"sh(mesh=$1; output=$2; stem=$3
case "$stem" in
  000* | 001*) ;;
  *) until [ -e "$(dirname "$0")/through-$(echo "$stem" | cut -c1-3)" ]; do sleep 0.02; done ;;
esac
count=$(sed -n 2p "$mesh" | cut -d' ' -f1)
yes 1 | head -n "$count" >"$output/$stem-solution.txt"
echo "$count" >"$output/$stem-size.txt"
)sh";

std::string NameOf(int mesh)
{
  return QStringLiteral("through-%1").arg(mesh, 3, 10, QLatin1Char('0')).toStdString();
}

} // namespace

Studio::Studio()
{
  this->Window.resize(1360, 860);
  this->Window.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->Window));
}

Studio::~Studio()
{
  this->Window.GetModel()->MakeNew(); // nothing to ask about
}

void Studio::AddFamily(const char* family)
{
  QTest::mouseClick(this->Find<QToolButton>(family), Qt::LeftButton);
}

bool Studio::WaitForMesh()
{
  return WaitFor([this]
    { return !this->Window.GetPreview()->IsBusy() && this->Window.GetPreview()->GetPicture(); });
}

std::filesystem::path Studio::MakeStudy(const std::string& name, int count)
{
  const std::filesystem::path folder = pemesh::TestFolder(name);
  StudyModel* model = this->Window.GetModel();
  this->AddFamily("family-star");
  model->SetValue(
    "polygons[0].center", { JsonValue::List{ JsonNumber(0.4), JsonNumber(0.6) } }, "move");
  model->SetValue("sweep[0].count", JsonNumber(count), "count");
  model->AddItem(
    "solvers", { JsonValue::Object{ { "solver", { std::string("pemesh-vem") } } } }, "solver");
  model->SetValue("name", { name }, "name");
  model->Save(QString::fromStdString((folder / (name + ".json")).string()));
  return folder;
}

std::filesystem::path Studio::MakeGatedStudy(const std::string& name, int count)
{
  const std::filesystem::path folder = this->MakeStudy(name, count);
  std::ofstream(folder / "gated.sh") << GatedSolver;
  std::ofstream(folder / "gated.json")
    << R"({"name": "gated", "command": ["sh", ")" << (folder / "gated.sh").string()
    << R"(", "{mesh}", "{output}", "{stem}"],
    "mesh-format": "off", "performances": [{"name": "size", "label": "Size"}]})";
  StudyModel* model = this->Window.GetModel();
  model->SetValue(
    "solvers[0]", { JsonValue::Object{ { "solver", { std::string("gated.json") } } } }, "solver");
  model->Save(model->GetFile());
  return folder;
}

void Studio::LetThrough(const std::filesystem::path& folder, int mesh)
{
  std::ofstream(folder / NameOf(mesh)) << "now\n";
}

void Studio::LetAllThrough(const std::filesystem::path& folder, int count)
{
  for (int mesh = 0; mesh < count; ++mesh)
  {
    LetThrough(folder, mesh);
  }
}

bool Studio::Run()
{
  this->Window.Run();
  const RunController* controller = this->Window.GetController();
  return WaitFor(
    [&]
    {
      return !controller->IsRunning() &&
        this->Window.GetResults()->GetFolder() == controller->GetOutput();
    },
    120000);
}

bool Studio::RunUntil(int meshes)
{
  int done = 0;
  const QMetaObject::Connection counting = QObject::connect(
    this->Window.GetController(), &RunController::Told, &this->Window, [&done] { ++done; });
  this->Window.Run();
  const bool isReached = WaitFor([&] { return done >= meshes; }, 120000);
  QObject::disconnect(counting);
  return isReached;
}

bool Studio::WaitForEnd()
{
  return WaitFor([this] { return !this->Window.GetController()->IsRunning(); }, 120000);
}

std::string Studio::GetLogText() const
{
  return this->Window.GetLog()->GetText().toStdString();
}

} // namespace studio_test
