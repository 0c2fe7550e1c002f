// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMeshView
 * @brief   A picture of a planar polygonal mesh, coloured by an array.
 *
 * Elements are drawn as they are, concave or not, to scale. A cell array gives every element one
 * colour; a point array is interpolated linearly on a triangulation of each element and drawn as
 * narrow bands of one colour, which any kind of file holds and any size shows sharply.
 *
 * - Colours: viridis; a diverging map centred on zero where asked for (errors); grey where the
 *   value is NaN, or not positive on a logarithmic scale, with a note that counts these elements.
 * - A cell array of integers with few values (families, polygon ids) gives classes, with a legend;
 *   negative values (fillers) are pale grey and not in the legend.
 * - The elements with the smallest and the largest value can be marked.
 *
 * With no array the elements are plain. A mesh with no elements is drawn as an empty panel with a
 * note, so that the figures of a study whose case failed can still be made.
 */
#ifndef vtkPEMMeshView_h
#define vtkPEMMeshView_h

#include "pemeshChartsModule.h" // For export macro
#include "vtkPEMPanel.h"

#include <vtkSmartPointer.h> // For the mesh

#include <string> // For names
#include <vector> // For labels

class vtkPolyData;

class PEMESHCHARTS_EXPORT vtkPEMMeshView : public vtkPEMPanel
{
public:
  static vtkPEMMeshView* New();
  vtkTypeMacro(vtkPEMMeshView, vtkPEMPanel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum HighlightType
  {
    HIGHLIGHT_NONE = 0,
    HIGHLIGHT_MIN = 1,
    HIGHLIGHT_MAX = 2,
    HIGHLIGHT_BOTH = 3
  };
  enum OutlineType
  {
    OUTLINES_OFF = 0,
    OUTLINES_ON = 1,
    OUTLINES_AUTOMATIC = 2 // where the elements are large enough to tell apart
  };

  ///@{
  /** The mesh: polygons only. No copy is made. */
  void SetMesh(vtkPolyData* mesh);
  vtkPolyData* GetMesh() const;
  ///@}

  ///@{
  /**
   * Cell or point array to colour by (cells first, if both have one). Empty (default): none. Of an
   * array with several components the first counts.
   */
  void SetColorArray(const std::string& name);
  std::string GetColorArray() const;
  /** Title of the colour bar. Empty (default): the name of the array. */
  void SetColorTitle(const std::string& title);
  std::string GetColorTitle() const;
  ///@}

  ///@{
  /** Logarithmic colours. Default off. */
  vtkSetMacro(LogColor, bool);
  vtkGetMacro(LogColor, bool);
  vtkBooleanMacro(LogColor, bool);
  /** A diverging map, centred on zero. Default off. Excludes LogColor, which then has no effect. */
  vtkSetMacro(Diverging, bool);
  vtkGetMacro(Diverging, bool);
  vtkBooleanMacro(Diverging, bool);
  ///@}

  ///@{
  /** Values at the ends of the colours. Default NaN, NaN: those of the array. */
  vtkSetVector2Macro(ColorRange, double);
  vtkGetVector2Macro(ColorRange, double);
  ///@}

  ///@{
  /** "viridis" (default: that of the style) or "cividis". False, and nothing changed, for any other
   * word. */
  bool SetColorMap(const std::string& name);
  std::string GetColorMap() const;
  ///@}

  ///@{
  /** Names of classes 0, 1, … of a cell array of integers. Default: the numbers. */
  void SetClassLabels(const std::vector<std::string>& labels);
  std::vector<std::string> GetClassLabels() const;
  ///@}

  ///@{
  /** Outlines of the elements. Default OUTLINES_AUTOMATIC. */
  vtkSetClampMacro(Outlines, int, OUTLINES_OFF, OUTLINES_AUTOMATIC);
  vtkGetMacro(Outlines, int);
  ///@}

  ///@{
  /**
   * Which extreme elements of the cell array are marked; of a point array, none. Default
   * HIGHLIGHT_NONE.
   */
  vtkSetClampMacro(Highlight, int, HIGHLIGHT_NONE, HIGHLIGHT_BOTH);
  vtkGetMacro(Highlight, int);
  /** "none", "min", "max" or "both". False, and nothing changed, for any other word. */
  bool SetHighlightByName(const std::string& name);
  ///@}

  ///@{
  /**
   * Elements to frame, by id, and a sentence about them for the note below the mesh. Ids that are
   * no element are passed over. Default: none.
   */
  void SetMarkedElements(const std::vector<vtkIdType>& elements, const std::string& note);
  std::vector<vtkIdType> GetMarkedElements() const { return this->MarkedElements; }
  ///@}

  std::string WhyNotDrawable() override;
  double GetPreferredAspect() override;

  ///@{
  /** Where a point of the mesh is in the figure, after it was painted: for tests, and for picking.
   */
  double GetDeviceX(double x) const;
  double GetDeviceY(double y) const;
  ///@}

  /** The element at a point of the device: its cell and the value that colours it. */
  pemesh::ChartPick Pick(double deviceX, double deviceY, double tolerance = 0.8) override;
  /** Elements with a vertex in a rectangle. */
  std::vector<vtkIdType> SelectRectangle(double x0, double y0, double x1, double y1) override;

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkPEMMeshView();
  ~vtkPEMMeshView() override;

private:
  vtkPEMMeshView(const vtkPEMMeshView&) = delete;
  void operator=(const vtkPEMMeshView&) = delete;

  void SetText(std::string& member, const std::string& value);

  vtkSmartPointer<vtkPolyData> Mesh;
  std::string ColorArray;
  std::string ColorTitle;
  std::string ColorMap = "viridis";
  std::vector<std::string> ClassLabels;
  bool LogColor = false;
  bool Diverging = false;
  double ColorRange[2];
  int Outlines = OUTLINES_AUTOMATIC;
  int Highlight = HIGHLIGHT_NONE;
  std::vector<vtkIdType> MarkedElements;
  std::string MarkNote;
  double ToDevice[3] = { 0.0, 0.0, 1.0 }; // offsets and scale of the last painting
};

#endif
