// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMCairoContextDevice2D
 * @brief   Paints context items through Cairo to PNG, SVG or PDF, in memory, with no display.
 *
 * Whatever draws through vtkContext2D (a vtkChartXY in its scene, a vtkPEMChart, any context item)
 * can be painted on this device: give the format and the size, Begin(nullptr), paint, End(), and
 * GetContents() is the file. The unit of the coordinates is the point (1/72 inch) divided by
 * UnitsPerPoint, y upwards; the resolution matters to PNG only.
 *
 * - Polygons are filled as they are, concave ones too. Markers are vector shapes.
 * - Pen widths, markers and text keep their size under a transform, as in VTK's OpenGL device.
 * - Text is set in DejaVu Sans (Debian package fonts-dejavu-core) unless a family other than VTK's
 *   own (Arial, Courier, Times) is asked for,
 *   measured by Cairo without hinting, and stays text in PDF and SVG. In SVG all text lies above
 *   all other marks, and is not clipped.
 * - Textures of brushes are not drawn: the plain colour is.
 * - The same calls give the same bytes: no dates, and the ids in an SVG are numbered anew.
 *
 * Threads: several devices may be in use at once, each in one thread.
 */
#ifndef vtkPEMCairoContextDevice2D_h
#define vtkPEMCairoContextDevice2D_h

#include "pemeshChartsModule.h" // For export macro

#include <vtkContextDevice2D.h>
#include <vtkStdString.h>     // For the Python wrapper
#include <vtkUnicodeString.h> // For the Python wrapper

#include <array>  // For matrices
#include <memory> // For the canvas
#include <string> // For the contents
#include <vector> // For batches of polygons

namespace pemesh
{
class CairoCanvas;
struct CanvasTextStyle;
}

class PEMESHCHARTS_EXPORT vtkPEMCairoContextDevice2D : public vtkContextDevice2D
{
public:
  static vtkPEMCairoContextDevice2D* New();
  vtkTypeMacro(vtkPEMCairoContextDevice2D, vtkContextDevice2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FormatType
  {
    FORMAT_PNG = 0,
    FORMAT_SVG = 1,
    FORMAT_PDF = 2,
    FORMAT_PIXELS = 3 ///< no file: the picture of FORMAT_PNG for a window, see GetContents
  };

  ///@{
  /** What is made; takes effect at Begin, as the four below. Default FORMAT_PNG. */
  vtkSetClampMacro(Format, int, FORMAT_PNG, FORMAT_PIXELS);
  vtkGetMacro(Format, int);
  ///@}
  ///@{
  /** Size of the page in points, each from 1 to 14400. Default 400 x 300. */
  void SetPageSize(double width, double height);
  vtkGetVector2Macro(PageSize, double);
  ///@}
  ///@{
  /** Pixels an inch of a PNG, 1 to 2400. Default 72: a pixel a point. */
  vtkSetClampMacro(DPI, double, 1.0, 2400.0);
  vtkGetMacro(DPI, double);
  ///@}
  ///@{
  /** Units of the coordinates in a point, 0.01 to 1000. Default 1. */
  vtkSetClampMacro(UnitsPerPoint, double, 0.01, 1000.0);
  vtkGetMacro(UnitsPerPoint, double);
  ///@}
  ///@{
  /** Title in the properties of a PDF and an SVG. Empty by default. */
  void SetDocumentTitle(const std::string& title);
  std::string GetDocumentTitle() const;
  ///@}

  /** Starts a white page. The viewport is not used and may be null. */
  void Begin(vtkViewport* viewport) override;
  /** Finishes the page: GetContents is the whole file, or empty with GetErrorMessage saying why. */
  void End() override;
  /**
   * The file. Of FORMAT_PIXELS the rows of pixels from the top, GetNumberOfPixels wide and high,
   * four bytes each: 0xRRGGBB as a number of the machine, its highest byte without meaning.
   */
  std::string GetContents() const;
  /** Of a page in pixels (FORMAT_PNG, FORMAT_PIXELS), as the page and the resolution make it. */
  void GetNumberOfPixels(int size[2]) const;
  std::string GetErrorMessage() const;

  /**
   * Fills many polygons with one colour in one go, `sizes` telling the vertices of each and
   * `points` their coordinates x0 y0 x1 y1 …. Polygons that share edges leave no seam; a line of
   * `seamWidth` around them hides the one to neighbours in other colours.
   */
  void DrawPolygons(const std::vector<double>& points, const std::vector<int>& sizes,
    const unsigned char color[4], double seamWidth);
  /** The same for outlines, with the current pen. */
  void DrawOutlines(const std::vector<double>& points, const std::vector<int>& sizes);

  void DrawPoly(float* points, int n, unsigned char* colors = nullptr, int nc_comps = 0) override;
  void DrawLines(float* points, int n, unsigned char* colors = nullptr, int nc_comps = 0) override;
  void DrawPoints(float* points, int n, unsigned char* colors = nullptr, int nc_comps = 0) override;
  void DrawPointSprites(vtkImageData* sprite, float* points, int n, unsigned char* colors = nullptr,
    int nc_comps = 0) override;
  void DrawMarkers(int shape, bool highlight, float* points, int n, unsigned char* colors = nullptr,
    int nc_comps = 0) override;
  void DrawQuad(float* points, int n) override;
  void DrawQuadStrip(float* points, int n) override;
  void DrawPolygon(float* points, int n) override;
  void DrawColoredPolygon(
    float* points, int n, unsigned char* colors = nullptr, int nc_comps = 0) override;
  void DrawEllipseWedge(float x, float y, float outRx, float outRy, float inRx, float inRy,
    float startAngle, float stopAngle) override;
  void DrawEllipticArc(
    float x, float y, float rX, float rY, float startAngle, float stopAngle) override;

  using vtkContextDevice2D::ComputeStringBounds;
  using vtkContextDevice2D::DrawString;
  void DrawString(float* point, const vtkStdString& string) override;
  void ComputeStringBounds(const vtkStdString& string, float bounds[4]) override;
  void DrawString(float* point, const vtkUnicodeString& string) override;
  void ComputeStringBounds(const vtkUnicodeString& string, float bounds[4]) override;
  void ComputeJustifiedStringBounds(const char* string, float bounds[4]) override;
  /** There is no MathText: the markup is drawn as it is. */
  void DrawMathTextString(float* point, const vtkStdString& string) override;
  bool MathTextIsSupported() override { return false; }

  void DrawImage(float point[2], float scale, vtkImageData* image) override;
  void DrawImage(const vtkRectf& position, vtkImageData* image) override;

  void SetColor4(unsigned char color[4]) override;
  void SetTexture(vtkImageData* image, int properties) override;
  void SetPointSize(float size) override;
  void SetLineWidth(float width) override;
  void SetLineType(int type) override;

  void SetMatrix(vtkMatrix3x3* matrix) override;
  void GetMatrix(vtkMatrix3x3* matrix) override;
  void MultiplyMatrix(vtkMatrix3x3* matrix) override;
  void PushMatrix() override;
  void PopMatrix() override;

  void SetClipping(int* rectangle) override;
  void EnableClipping(bool enable) override;

protected:
  vtkPEMCairoContextDevice2D();
  ~vtkPEMCairoContextDevice2D() override;

private:
  vtkPEMCairoContextDevice2D(const vtkPEMCairoContextDevice2D&) = delete;
  void operator=(const vtkPEMCairoContextDevice2D&) = delete;

  void AddPath(const float* points, int n, bool closed);
  void AddPolygons(const std::vector<double>& points, const std::vector<int>& sizes);
  void Fill(const unsigned char* color);
  void Stroke(const unsigned char* color);
  void Transform(double& x, double& y) const;
  pemesh::CanvasTextStyle TextStyle() const;
  void ApplyClip();

  std::unique_ptr<pemesh::CairoCanvas> Canvas;
  int Format = FORMAT_PNG;
  double PageSize[2] = { 400.0, 300.0 };
  double DPI = 72.0;
  double UnitsPerPoint = 1.0;
  std::string DocumentTitle;
  std::string Contents;
  std::string ErrorMessage;
  using Matrix = std::array<double, 9>; // row by row
  static constexpr Matrix Identity = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  Matrix Current = Identity;
  std::vector<Matrix> Below;
  int Clip[4] = { 0, 0, 0, 0 };
  bool ClipIsEnabled = false;
};

#endif
