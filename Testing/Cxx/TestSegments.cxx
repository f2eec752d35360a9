// The shader's integral of one segment, against quadrature in double precision.
#include "FloatPicture.h"
#include "TransferIntegrals.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

using namespace flatblock::testing;
using flatblock::TransferTable;
using Entry = TransferTable::Entry;

namespace
{
constexpr double LargestError = 1e-4;
constexpr int Entries = 1024;

std::string ReadFile(const std::string& path)
{
  std::ifstream file(path);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

// The shader's segments between all pairs of positions.
class SegmentShader
{
public:
  explicit SegmentShader(const TransferTable& table)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(16, 16);
    this->Window->Render();
    std::string source = ReadFile(FLATBLOCK_TEST_SHADERS "/Segments.frag.glsl");
    const std::string shaders = FLATBLOCK_SHADERS;
    vtkShaderProgram::Substitute(source, "//FlatBlock::TransferTable",
      ReadFile(shaders + "/Counting.glsl") + ReadFile(shaders + "/TransferTable.glsl"));
    vtkShaderProgram::Substitute(
      source, "//FlatBlock::Classification", ReadFile(shaders + "/PreIntegrated.glsl"));
    this->Program = this->GetWindow()->GetShaderCache()->ReadyShaderProgram(
      ReadFile(shaders + "/RayImage.vert.glsl").c_str(), source.c_str(), "");
    const auto texels = flatblock::IntegrateTransferTable(table);
    this->Table->SetContext(this->GetWindow());
    this->TableBuffer->Upload(texels, vtkOpenGLBufferObject::TextureBuffer);
    this->Table->CreateTextureBuffer(texels.size(), 4, VTK_FLOAT, this->TableBuffer);
  }

  vtkOpenGLRenderWindow* GetWindow() { return vtkOpenGLRenderWindow::SafeDownCast(this->Window); }

  Picture Draw(const std::vector<float>& fronts, const std::vector<float>& backs, double length)
  {
    const int count = static_cast<int>(fronts.size());
    std::vector<float> positions(fronts);
    positions.insert(positions.end(), backs.begin(), backs.end());
    FloatFramebuffer framebuffer(this->Window, count, count);
    vtkNew<vtkTextureObject> texture;
    texture->SetContext(this->GetWindow());
    texture->Create2DFromRaw(count, 2, 1, VTK_FLOAT, positions.data());
    this->GetWindow()->GetShaderCache()->ReadyShaderProgram(this->Program);
    texture->Activate();
    this->Table->Activate();
    this->Program->SetUniformi("in_Positions", texture->GetTextureUnit());
    this->Program->SetUniformi("in_TransferTable", this->Table->GetTextureUnit());
    this->Program->SetUniformi("in_TexelsPerEntry", flatblock::TransferTexels);
    this->Program->SetUniformf("in_LastEntry", static_cast<float>(Entries - 1));
    this->Program->SetUniformf("in_Length", static_cast<float>(length));
    vtkOpenGLState* state = this->GetWindow()->GetState();
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_SCISSOR_TEST);
    vtkNew<vtkOpenGLVertexArrayObject> empty;
    empty->Bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    empty->Release();
    texture->Deactivate();
    this->Table->Deactivate();
    return framebuffer.Read();
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkOpenGLBufferObject> TableBuffer;
  vtkNew<vtkTextureObject> Table;
  vtkShaderProgram* Program = nullptr;
};

using Color = std::array<double, 4>;

Color At(const TransferTable& table, double position)
{
  const auto& entries = table.GetEntries();
  const double first = std::min(std::floor(position), double(entries.size() - 2));
  const Entry& low = entries[std::size_t(first)];
  const Entry& high = entries[std::size_t(first) + 1];
  Color color;
  for (int c = 0; c < 4; ++c)
  {
    color[c] = low[c] + (position - first) * (double(high[c]) - low[c]);
  }
  return color;
}

// Colour and extinction linear over the piece: Gauss-Legendre with 3 points for the colour, in
// parts of little optical depth.
void AddLinearPiece(const Color& begin, const Color& end, double length, Color& sum, double& depth)
{
  constexpr double MostDepth = 0.05;
  constexpr double Opaque = 30.0;
  const double pieceDepth = 0.5 * length * (begin[3] + end[3]);
  // Where extinction begins with nothing, parts at its end are deeper than the mean one.
  const double parts = std::ceil(2.0 * pieceDepth / MostDepth) + 1.0;
  for (double part = 0.0; part < parts && depth < Opaque; part += 1.0)
  {
    constexpr double Nodes[3] = { 0.1127016653792583, 0.5, 0.8872983346207417 };
    constexpr double Weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    const double from = part / parts;
    const double at = begin[3] + from * (end[3] - begin[3]);
    const double partLength = length / parts;
    for (int node = 0; node < 3; ++node)
    {
      const double share = from + Nodes[node] / parts;
      const double here = begin[3] + share * (end[3] - begin[3]);
      const double before = 0.5 * (at + here) * Nodes[node] * partLength;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += Weights[node] * partLength * here * (begin[c] + share * (end[c] - begin[c])) *
                  std::exp(-depth - before);
      }
    }
    depth += 0.5 * partLength * (2.0 * at + (end[3] - begin[3]) / parts);
  }
}

Color Integrate(const TransferTable& table, double front, double back, double length)
{
  Color sum = { 0.0, 0.0, 0.0, 0.0 };
  double depth = 0.0;
  const double span = std::abs(back - front);
  const double direction = back < front ? -1.0 : 1.0;
  double from = front;
  while (from != back || span == 0.0)
  {
    const double border = direction > 0.0 ? std::floor(from) + 1.0 : std::ceil(from) - 1.0;
    const double to = (back - border) * direction > 0.0 ? border : back;
    AddLinearPiece(At(table, from), At(table, to),
      span > 0.0 ? length * std::abs(to - from) / span : length, sum, depth);
    from = to;
    if (span == 0.0)
    {
      break;
    }
  }
  sum[3] = -std::expm1(-depth);
  return sum;
}

double CompareAll(const TransferTable& table, const std::vector<float>& fronts,
  const std::vector<float>& backs, const std::vector<double>& lengths)
{
  SegmentShader shader(table);
  double largest = 0.0;
  for (double length : lengths)
  {
    const Picture drawn = shader.Draw(fronts, backs, length);
    EXPECT_TRUE(IsSound(drawn));
    const auto count = static_cast<std::ptrdiff_t>(fronts.size());
#pragma omp parallel for schedule(dynamic) reduction(max : largest)
    for (std::ptrdiff_t row = 0; row < count; ++row)
    {
      for (std::ptrdiff_t column = 0; column < count; ++column)
      {
        const Color expected = Integrate(table, fronts[column], backs[row], length);
        for (int c = 0; c < 4; ++c)
        {
          largest = std::max(largest, std::abs(drawn[row * count + column][c] - expected[c]));
        }
      }
    }
  }
  return largest;
}

std::vector<float> SpreadPositions(int count, int entries, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> anywhere(0.0F, static_cast<float>(entries - 1));
  std::vector<float> positions;
  for (int i = 0; i < count; ++i)
  {
    const float position = anywhere(random);
    positions.push_back(i % 4 == 0 ? std::floor(position) : position);
  }
  positions[0] = 0.0F;
  positions[1] = static_cast<float>(entries - 1);
  return positions;
}

const std::vector<double> Lengths = { 1.0 / 64.0, 1.0 / 8.0, 0.5, 1.0, 8.0, 64.0 };

Entry MakeEntry(double r, double g, double b, double opacity)
{
  return { static_cast<float>(r), static_cast<float>(g), static_cast<float>(b),
    static_cast<float>(flatblock::GetExtinction(opacity, 1.0)) };
}

TransferTable MakeTable(const std::function<Entry(double)>& entryAt)
{
  std::vector<Entry> entries;
  for (int i = 0; i < Entries; ++i)
  {
    entries.push_back(entryAt(i / (Entries - 1.0)));
  }
  return TransferTable(0.0, 1.0, entries);
}

// Opacities of every size, from 1e-7 to 1.
double AnyOpacity(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double kind = unit(random);
  return kind < 0.2 ? 0.0 : (kind > 0.9 ? 1.0 : std::pow(10.0, -7.0 * unit(random)));
}

std::vector<std::pair<std::string, TransferTable>> MakeTables()
{
  std::vector<std::pair<std::string, TransferTable>> tables;
  const auto ramp = [](double v) { return MakeEntry(v, 1.0 - v, 0.5, v); };
  tables.emplace_back("ramp", MakeTable(ramp));
  for (double opacity : { 1e-7, 1e-3, 0.3, 1.0 })
  {
    tables.emplace_back("ramp of colour at opacity " + std::to_string(opacity),
      MakeTable([opacity](double v) { return MakeEntry(v, 1.0 - v, v * v, opacity); }));
  }
  tables.emplace_back("shells", MakeTable(
                                  [](double v)
                                  {
                                    const bool isShell = std::fmod(v * 7.3, 1.0) < 0.01;
                                    return MakeEntry(
                                      v, std::fmod(v * 5.0, 1.0), 1.0, isShell ? 0.7 : 0.0);
                                  }));
  tables.emplace_back("edges from black to white",
    MakeTable(
      [](double v)
      {
        const double color = std::fmod(v * 11.0, 1.0) < 0.5 ? 0.0 : 1.0;
        return MakeEntry(color, 1.0 - color, color, 0.2 + 0.7 * v);
      }));
  tables.emplace_back("almost nothing beside what is opaque",
    MakeTable([](double v)
      { return MakeEntry(v, 0.3, 1.0 - v, std::fmod(v * 3.0, 1.0) < 0.5 ? 1.0 : 1e-7); }));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  tables.emplace_back("noise",
    MakeTable([&](double)
      { return MakeEntry(unit(random), unit(random), unit(random), AnyOpacity(random)); }));
  tables.emplace_back("translucent noise",
    MakeTable([&](double)
      { return MakeEntry(unit(random), unit(random), unit(random), 0.3 * unit(random)); }));
  return tables;
}
} // namespace

TEST(Segments, EqualQuadratureBetweenAllValues)
{
  const auto fronts = SpreadPositions(36, Entries, 1);
  const auto backs = SpreadPositions(36, Entries, 2);
  for (const auto& [name, table] : MakeTables())
  {
    const double error = CompareAll(table, fronts, backs, Lengths);
    std::cout << name << ": largest error " << error << "\n";
    EXPECT_LE(error, LargestError) << name;
  }
}

// Each back value is so many units in the last place from the front value of its column.
TEST(Segments, CloseValuesDoNotCancel)
{
  std::vector<float> fronts;
  std::vector<float> backs;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> anywhere(1.0F, Entries - 2.0F);
  for (int i = 0; i < 40; ++i)
  {
    const float front = i % 3 == 0 ? std::floor(anywhere(random)) : anywhere(random);
    fronts.push_back(front);
    float back = front;
    const int steps = 1 << (i / 4);
    for (int k = 0; k < steps; ++k)
    {
      back = std::nextafter(back, i % 2 == 0 ? 0.0F : float(Entries));
    }
    backs.push_back(back);
  }
  for (const auto& [name, table] : MakeTables())
  {
    const double error = CompareAll(table, fronts, backs, Lengths);
    std::cout << name << ": largest error " << error << "\n";
    EXPECT_LE(error, LargestError) << name;
  }
}

// What is almost transparent keeps its digits: 100,000 of them add up.
TEST(Segments, FaintOnesKeepTheirDigits)
{
  const TransferTable table = MakeTable([](double v) { return MakeEntry(1.0, v, 0.0, 1e-7); });
  SegmentShader shader(table);
  const auto fronts = SpreadPositions(32, Entries, 1);
  const auto backs = SpreadPositions(32, Entries, 2);
  for (double length : Lengths)
  {
    const Picture drawn = shader.Draw(fronts, backs, length);
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
      const Color expected =
        Integrate(table, fronts[i % fronts.size()], backs[i / fronts.size()], length);
      ASSERT_NEAR(drawn[i][3] / expected[3], 1.0, 1e-5);
      ASSERT_NEAR(drawn[i][0] / expected[0], 1.0, 1e-5);
    }
  }
}

TEST(Segments, RebuildingIsQuick)
{
  const TransferTable table = MakeTable([](double v) { return MakeEntry(v, 1.0 - v, 0.5, v); });
  std::vector<double> milliseconds;
  for (int run = 0; run < 9; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    const auto texels = flatblock::IntegrateTransferTable(table);
    const std::chrono::duration<double, std::milli> taken =
      std::chrono::steady_clock::now() - start;
    ASSERT_EQ(texels.size(), std::size_t(flatblock::TransferTexels) * Entries);
    milliseconds.push_back(taken.count());
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << "integrals of " << Entries << " entries: " << milliseconds[4] << " ms\n";
  EXPECT_LE(milliseconds[4], 5.0);
}
