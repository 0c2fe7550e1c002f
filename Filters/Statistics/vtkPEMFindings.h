// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMFindings
 * @brief   What drives each performance: metrics ranked by how well they predict it, in sentences.
 *
 * Input port 0 : vtkTable, the output of vtkPEMCorrelation.
 * Input port 1 : vtkTable, the table of meshes that it correlated.
 * Output port 0: vtkTable, one row a performance and metric, by performance, best metric first:
 *   `Performance`, `Metric` | `Rank` from 1 | `N`, `Coefficient`, `Tested`, `P`, `PHolm`,
 *   `PBenjaminiHochberg`, `Low`, `High` as of the correlation | `Words` | `JointRank`,
 *   `JointWeight` of the metric among all of them together | `Sentence` | `Joint` a sentence on all
 *   of them together, in the first row of each performance. GetText() is all of it to read.
 *
 * Alone: by the size of the tested coefficient, then by how well the form fits, then by distance
 *   correlation. Metrics whose coefficient is undefined come last and without a rank (0).
 * Jointly: ridge regression (RidgeRegression.h) on all metrics that vary, standardised; columns of
 *   positive values that span a factor of ten or more enter by their logarithm. Refused, with a
 *   sentence, below three rows a predictor and along a single family.
 *
 * @sa vtkPEMCorrelation
 */
#ifndef vtkPEMFindings_h
#define vtkPEMFindings_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For the text

class PEMESHFILTERSSTATISTICS_EXPORT vtkPEMFindings : public vtkTableAlgorithm
{
public:
  static vtkPEMFindings* New();
  vtkTypeMacro(vtkPEMFindings, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Metrics a performance in the text; the table has all. Range [1, 1000000]. Default 10. */
  vtkSetClampMacro(NumberOfSentences, int, 1, 1000000);
  vtkGetMacro(NumberOfSentences, int);
  ///@}

  /** After an update: the ranked lists in sentences, lines of text. */
  std::string GetText() const;

protected:
  vtkPEMFindings();
  ~vtkPEMFindings() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMFindings(const vtkPEMFindings&) = delete;
  void operator=(const vtkPEMFindings&) = delete;

  int NumberOfSentences = 10;
  std::string Text;
};

#endif
