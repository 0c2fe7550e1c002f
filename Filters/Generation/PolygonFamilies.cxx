// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonFamilies.h"

#include "RandomPolygon.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr const char* Attene2021 =
  "Attene et al., Benchmarking the geometrical robustness of a Virtual Element Poisson solver, "
  "Math. Comput. Simul. 190 (2021) 1392-1414, doi:10.1016/j.matcom.2021.07.018";

constexpr double MostVertices = 100000;

constexpr Parameter CombParameters[] = { { "teeth", "extra teeth at t = 1", 10, 1, MostVertices,
  true } };
constexpr Parameter NSidedParameters[] = { { "sides", "sides at t = 1", 40, 3, MostVertices,
  true } };
constexpr Parameter StarParameters[] = { { "spikes", "spikes at t = 1", 40, 3, MostVertices,
  true } };
constexpr Parameter RandomParameters[] = { { "seed", "another seed, another polygon", 0, 0, 0x1p53,
                                             true },
  { "vertices", "number of vertices", 16, 3, 10000, true },
  { "irregularity", "at t = 1, 0: equal angles between vertices; 1: very unequal ones", 0.5, 0, 1 },
  { "spikiness", "at t = 1, 0: all vertices on a circle; 1: from 0.1 to 1 of its radius", 0.5, 0,
    1 },
  { "tangle", "at t = 1, 0: star-shaped; 1: the vertices have wandered far", 0.5, 0, 1 } };

/** How near to its degenerate end a family is taken. */
constexpr double DegenerateMargin = 1e-5;

double Clamp(double t, double low, double high)
{
  return std::isnan(t) ? low : std::clamp(t, low, high);
}

double Lerp(double from, double to, double t)
{
  return from * (1.0 - t) + to * t;
}

Point2 Lerp(const Point2& from, const Point2& to, double t)
{
  return { Lerp(from.x, to.x, t), Lerp(from.y, to.y, t) };
}

/** ceil(x), but 3.0000000000000004 (0.1 * 3 * 10) still counts as 3. */
int CeilingOf(double x)
{
  return static_cast<int>(std::ceil(x - 1e-12 * std::max(1.0, x)));
}

/** From the parameter's least value at t = 0 to its value at t = 1. */
int GrownCount(double t, const Parameter& parameter, const ParameterValues& values)
{
  const int least = static_cast<int>(parameter.Least);
  return least + CeilingOf((values.GetInteger(parameter.Name) - least) * t);
}

/** Points at equal angles, the first straight above the origin. */
Point2 OnCircle(double radius, int i, int n)
{
  const double angle = 2.0 * std::numbers::pi * i / n + 0.5 * std::numbers::pi;
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

std::vector<Point2> Comb(double time, const ParameterValues& values)
{
  const double t = Clamp(time, 0.0, 1.0);
  const int teeth = values.GetInteger("teeth");
  const int extra = static_cast<int>(std::lround(teeth * t));
  const int last = 2 * extra + 2;
  std::vector<Point2> vertices;
  vertices.reserve(last + 3);
  for (int i = 0; i <= last; ++i)
  {
    vertices.push_back({ 2.0 * i / last, i % 2 == 0 ? 0.0 : 0.5 });
  }
  vertices.push_back({ 2.0, 1.0 });
  vertices.push_back({ 0.0, 1.0 });
  return vertices;
}

std::vector<Point2> Convexity(double time, const ParameterValues&)
{
  const double t = Clamp(time, 0.0, 1.0 - DegenerateMargin);
  return { { t, t }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
}

std::vector<Point2> Isotropy(double time, const ParameterValues&)
{
  const double t = Clamp(time, 0.0, 1.0 - DegenerateMargin);
  const double low = t / 2.0;
  return { { 0.0, low }, { 1.0, low }, { 1.0, 1.0 - low }, { 0.0, 1.0 - low } };
}

std::vector<Point2> Maze(double time, const ParameterValues&)
{
  const double t = Clamp(time, 0.0, 1.0);
  return { { 0.0, 1.0 }, { 0.0, 0.75 }, { 0.0, 0.5 }, { 0.0, 0.25 }, { 0.0, 0.0 }, { 0.25, 0.0 },
    { 0.5, 0.0 }, { 0.75, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.25 }, { 1.0, 0.5 }, { 1.0, 0.75 },
    { 0.75, 0.75 }, { 0.5, 0.75 }, Lerp({ 0.5, 0.5 }, { 0.5, 0.745 }, t),
    Lerp({ 0.75, 0.5 }, { 0.995, 0.745 }, t), Lerp({ 0.75, 0.25 }, { 0.995, 0.005 }, t),
    Lerp({ 0.5, 0.25 }, { 0.5, 0.005 }, t), Lerp({ 0.25, 0.25 }, { 0.005, 0.005 }, t),
    Lerp({ 0.25, 0.5 }, { 0.005, 0.5 }, t), Lerp({ 0.25, 0.75 }, { 0.005, 0.75 }, t),
    Lerp({ 0.25, 1.0 }, { 0.005, 1.0 }, t) };
}

std::vector<Point2> NSided(double time, const ParameterValues& values)
{
  const int sides = GrownCount(Clamp(time, 0.0, 1.0), NSidedParameters[0], values);
  std::vector<Point2> vertices;
  vertices.reserve(sides);
  for (int i = 0; i < sides; ++i)
  {
    vertices.push_back(OnCircle(1.0, i, sides));
  }
  return vertices;
}

std::vector<Point2> Star(double time, const ParameterValues& values)
{
  const int spikes = GrownCount(Clamp(time, 0.0, 1.0), StarParameters[0], values);
  std::vector<Point2> vertices;
  vertices.reserve(2 * spikes);
  for (int i = 0; i < 2 * spikes; ++i)
  {
    vertices.push_back(OnCircle(i % 2 == 0 ? 1.8 : 1.0, i, 2 * spikes));
  }
  return vertices;
}

std::vector<Point2> ULike(double time, const ParameterValues&)
{
  const double t = Clamp(time, DegenerateMargin, 1.0);
  return { { 0.0, 0.0 }, Lerp({ 0.25, 0.0 }, { 0.01, 0.99 }, t),
    Lerp({ 0.5, 0.0 }, { 0.5, 0.99 }, t), Lerp({ 0.75, 0.0 }, { 0.99, 0.99 }, t), { 1.0, 0.0 },
    { 1.0, 1.0 }, { 0.0, 1.0 } };
}

std::vector<Point2> Zeta(double time, const ParameterValues&)
{
  const double t = Clamp(time, 0.0, 1.0);
  return { { 0.0, 0.0 }, { 1.0, 0.0 }, Lerp({ 1.0, 0.5 }, { 0.02, 0.01 }, t), { 1.0, 1.0 },
    { 0.0, 1.0 }, Lerp({ 0.0, 0.5 }, { 0.98, 0.99 }, t) };
}

std::vector<Point2> Random(double time, const ParameterValues& values)
{
  RandomPolygonOptions options;
  options.Seed = static_cast<std::uint64_t>(values.Get("seed"));
  options.Vertices = values.GetInteger("vertices");
  options.Irregularity = values.Get("irregularity");
  options.Spikiness = values.Get("spikiness");
  options.Tangle = values.Get("tangle");
  return MakeRandomPolygon(options, time);
}

constexpr PolygonFamily Families[] = {
  { "comb", "Comb", "A rectangle whose lower side grows more and more teeth.", CombParameters, true,
    Attene2021, &Comb },
  { "convexity", "Convexity",
    "A square with one vertex pushed in: a triangle at t = 0.5, concave beyond.", {}, false,
    Attene2021, &Convexity },
  { "isotropy", "Isotropy", "A square flattened to a rectangle of height 1 - t.", {}, false,
    Attene2021, &Isotropy },
  { "maze", "Maze", "A winding corridor that gets thinner: tiny area and empty kernel.", {}, false,
    Attene2021, &Maze },
  { "n-sided", "N-sided", "A regular polygon with more and more sides.", NSidedParameters, true,
    Attene2021, &NSided },
  { "star", "Star", "A star with more and more spikes.", StarParameters, true, Attene2021, &Star },
  { "u-like", "U-like", "A square with a notch that leaves a thin U.", {}, false, Attene2021,
    &ULike },
  { "zeta", "Zeta", "A square pinched from both sides to a thin Z.", {}, false, Attene2021, &Zeta },
  { "random", "Random", "A regular polygon whose vertices wander off at random.", RandomParameters,
    false, "", &Random },
  { FileFamilyName, "File", "The first polygon of a file; it does not depend on t.", {}, false, "",
    nullptr },
  { PointsFamilyName, "Points", "A polygon given by its points; it does not depend on t.", {},
    false, "", nullptr },
};

bool SameWord(std::string_view a, std::string_view b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace

std::span<const PolygonFamily> PolygonFamilies()
{
  return Families;
}

const PolygonFamily* FindPolygonFamily(std::string_view name)
{
  for (const PolygonFamily& family : Families)
  {
    if (SameWord(family.Name, name))
    {
      return &family;
    }
  }
  return nullptr;
}

int PolygonFamilyIndex(const PolygonFamily* family)
{
  return static_cast<int>(family - Families);
}

} // namespace pemesh
