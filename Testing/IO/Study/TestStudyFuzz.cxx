// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverDescriptionFile.h"
#include "StudyFile.h"

#include "StudyTexts.h"
#include "TextFile.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

/** Random damage: bytes and whole tokens lost, doubled, exchanged or replaced by tempting ones. */
class Mutator
{
public:
  explicit Mutator(std::uint64_t seed)
    : Bits(seed)
  {
  }

  std::string Mutate(std::string text)
  {
    const std::size_t times = 1 + this->Below(4);
    for (std::size_t i = 0; i < times && !text.empty(); ++i)
    {
      this->MutateOnce(text);
    }
    return text;
  }

private:
  std::size_t Below(std::size_t bound) { return static_cast<std::size_t>(this->Bits() % bound); }

  void MutateOnce(std::string& text)
  {
    static const std::vector<std::string> tempting{ "null", "true", "-1", "1e308", "1e999",
      "1e-400", "99999999999999999999", "0.5", "\"\"", "\"t\"", "[]", "{}", "[[", "}}", ",", ":",
      "\"", "\\u0000", "\xFF", "\xEF\xBB\xBF", "{\"a\":1,\"a\":1}", "-", "\"constant\"", "\"mesh\"",
      "\n" };
    const std::size_t at = this->Below(text.size());
    const std::size_t length = std::min(1 + this->Below(12), text.size() - at);
    switch (this->Below(6))
    {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(this->Below(text.size()), text.substr(at, length));
        break;
      case 2:
        text[at] = static_cast<char>(this->Bits());
        break;
      case 3:
        text.resize(at);
        break;
      case 4:
        text.insert(at, tempting[this->Below(tempting.size())]);
        break;
      default:
        this->ReplaceValue(text, tempting[this->Below(tempting.size())]);
    }
  }

  /** Keeps the syntax whole more often than not, to get past the parser. */
  void ReplaceValue(std::string& text, const std::string& value)
  {
    const std::size_t colon = text.find(": ", this->Below(text.size()));
    if (colon != std::string::npos)
    {
      const std::size_t end = std::min(text.find_first_of(",}]\n", colon), text.size());
      text.replace(colon + 2, end - colon - 2, value);
    }
  }

  std::mt19937_64 Bits;
};

/** Reading may succeed or throw std::runtime_error with a sentence, and nothing else. */
template <typename Read>
void Fuzz(const std::string& seedText, int rounds, std::uint64_t seed, Read read)
{
  Mutator mutator(seed);
  int good = 0;
  for (int round = 0; round < rounds; ++round)
  {
    const std::string text = mutator.Mutate(seedText);
    try
    {
      read(text);
      ++good;
    }
    catch (const std::runtime_error& error)
    {
      const std::string sentence = error.what();
      ASSERT_FALSE(sentence.empty());
      ASSERT_EQ(sentence.find("json.exception"), std::string::npos) << sentence;
    }
    catch (const std::exception& error)
    {
      FAIL() << "another exception: " << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(good, 0) << "mutations too harsh to get anywhere";
  EXPECT_LT(good, rounds);
}

TEST(StudyFuzz, Documents)
{
  Fuzz(FullStudy, 2500, 1,
    [](const std::string& text)
    {
      const pemesh::Study study = pemesh::ParseStudy(text, "s.json");
      // What was read is sound enough to survive the way back.
      ASSERT_EQ(pemesh::ParseStudy(pemesh::FormatStudy(study), "s.json"), study) << text;
    });
}

TEST(StudyFuzz, Settings)
{
  Fuzz("polygons[0].center[1]=0.25", 1000, 2,
    [](const std::string& setting)
    { pemesh::ParseStudy(pemesh::ApplySetting(FullStudy, setting), "s.json"); });
}

TEST(StudyFuzz, SolverDescriptions)
{
  const std::string text =
    pemesh::ReadTextFile(std::string(PEMESH_SOURCE_DIR) + "/Applications/Solvers/pemesh-vem.json");
  Fuzz(text, 1500, 3,
    [](const std::string& changed)
    {
      const auto description = pemesh::ParseSolverDescription(changed, "t.json");
      ASSERT_EQ(
        pemesh::ParseSolverDescription(pemesh::FormatSolverDescription(description), "t.json"),
        description)
        << changed;
    });
}

} // namespace
