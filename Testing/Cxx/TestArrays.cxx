// Which array of an image is drawn, and what of it: cells, components, blanked points.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace flatblock::testing;

namespace
{
constexpr std::array<int, 3> Samples = { 40, 36, 44 };

vtkSmartPointer<vtkImageData> MakeSmallWaves()
{
  return MakeVolume(Samples, VTK_FLOAT, WavesAt);
}

void Show(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 0.1);
  scene.SetOpacity({ { 550.0, 0.0 }, { 650.0, 0.1 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

// The same values, those of the cells of an image of one more point along each axis.
vtkSmartPointer<vtkImageData> MakeCells()
{
  const auto waves = MakeSmallWaves();
  auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(Samples[0] + 1, Samples[1] + 1, Samples[2] + 1);
  cells->GetCellData()->SetScalars(waves->GetPointData()->GetScalars());
  return cells;
}

// Values that are others', with the waves in one component.
vtkSmartPointer<vtkFloatArray> Interleave(int components, int component)
{
  const auto waves = MakeSmallWaves();
  vtkDataArray* values = waves->GetPointData()->GetScalars();
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("vectors");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(values->GetNumberOfTuples());
  array->Fill(0.0);
  array->CopyComponent(component, values, 0);
  return array;
}

void Hide(vtkUnsignedCharArray* ghosts, vtkIdType first, vtkIdType step)
{
  for (vtkIdType i = first; i < ghosts->GetNumberOfTuples(); i += step)
  {
    ghosts->SetValue(i, ghosts->GetValue(i) | vtkDataSetAttributes::HIDDENPOINT);
  }
}
} // namespace

TEST(Arrays, OfCellsAreDrawnAsThePeerDoes)
{
  for (const bool isNearest : { false, true })
  {
    Scene scene;
    Show(scene, MakeCells());
    scene.Property->SetInterpolationType(
      isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
    const auto ours = scene.Draw();
    EXPECT_TRUE(ShowsSomething(ours));
    EXPECT_GE(PSNR(ours, scene.DrawWithPeer()), isNearest ? 33.0 : 40.0);
  }
}

// Half a cell further, the values of cells are those of points.
TEST(Arrays, OfCellsHaveTheirValuesInTheMiddle)
{
  Scene scene;
  Show(scene, MakeSmallWaves());
  const Picture points = DrawFloats(scene);
  const auto cells = MakeCells();
  cells->SetOrigin(-0.5, -0.5, -0.5);
  scene.Mapper->SetInputData(cells);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.0, 39.0, 0.0, 35.0, 0.0, 43.0);
  EXPECT_LE(RootMeanSquare(DrawFloats(scene), points), 1e-4);
  scene.Mapper->CroppingOff();
  EXPECT_GE(RootMeanSquare(DrawFloats(scene), points), 1e-2);
}

TEST(Arrays, OfASingleLayerOfCells)
{
  Scene scene;
  vtkNew<vtkImageData> image;
  image->SetDimensions(33, 33, 2);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(32 * 32);
  values->Fill(1000.0);
  image->GetCellData()->SetScalars(values);
  Show(scene, image);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(10.0);
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_NEAR(pixel[3], 0.1, 1e-4);
  }
}

TEST(Arrays, AreTheOnesThatAreSelected)
{
  Scene scene;
  const auto image = MakeSmallWaves();
  Show(scene, image);
  const Picture waves = DrawFloats(scene);
  const auto other = MakeVolume(Samples, VTK_SHORT, [](int x, int, int) { return 20.0 * x; });
  other->GetPointData()->GetScalars()->SetName("other");
  image->GetPointData()->GetScalars()->SetName("waves");
  image->GetPointData()->AddArray(other->GetPointData()->GetScalars());
  image->GetPointData()->SetActiveScalars("other");
  const Picture others = DrawFloats(scene);
  EXPECT_GE(RootMeanSquare(others, waves), 1e-2);
  scene.Mapper->SelectScalarArray("waves");
  scene.Mapper->SetScalarModeToUsePointFieldData();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), waves), 0.0);
  scene.Mapper->SelectScalarArray("other");
  EXPECT_EQ(LargestDifference(DrawFloats(scene), others), 0.0);
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (image->GetPointData()->GetArray(i)->GetName() == std::string("waves"))
    {
      scene.Mapper->SelectScalarArray(i);
    }
  }
  EXPECT_EQ(LargestDifference(DrawFloats(scene), waves), 0.0);
}

TEST(Arrays, OfVectorsAreDrawnByComponentOrMagnitude)
{
  Scene scene;
  const auto image = MakeSmallWaves();
  Show(scene, image);
  const Picture waves = DrawFloats(scene);
  image->GetPointData()->SetScalars(Interleave(6, 4));
  scene.Mapper->SetVectorMode(vtkFlatBlockVolumeMapper::COMPONENT);
  scene.Mapper->SetVectorComponent(4);
  EXPECT_EQ(LargestDifference(DrawFloats(scene), waves), 0.0);
  scene.Mapper->SetVectorMode(vtkFlatBlockVolumeMapper::MAGNITUDE);
  EXPECT_LE(LargestDifference(DrawFloats(scene), waves), 1e-5);
  scene.Mapper->SetVectorMode(vtkFlatBlockVolumeMapper::COMPONENT);
  scene.Mapper->SetVectorComponent(6);
  const Messages messages = Listen([&] { scene.Draw(); });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("VectorComponent is 6"), std::string::npos);
}

TEST(Arrays, OfBitsAreDrawnAsBytes)
{
  const auto bytes = MakeVolume(
    Samples, VTK_UNSIGNED_CHAR, [](int x, int y, int z) { return (x / 5 + y / 7 + z / 6) % 2; });
  Scene scene;
  Show(scene, bytes);
  scene.SetOpacity({ { 0.0, 0.0 }, { 1.0, 0.1 } });
  const Picture expected = DrawFloats(scene);
  vtkNew<vtkBitArray> bits;
  bits->DeepCopy(bytes->GetPointData()->GetScalars());
  const auto image = MakeSmallWaves();
  image->GetPointData()->SetScalars(bits);
  scene.Mapper->SetInputData(image);
  EXPECT_EQ(LargestDifference(DrawFloats(scene), expected), 0.0);
}

// As if they were not numbers, but not reported as such; and those that only repeat others stay.
TEST(Arrays, ShowNoBlankedPoints)
{
  Scene scene;
  const auto holes = MakeVolume(Samples, VTK_FLOAT,
    [](int x, int y, int z)
    {
      const int i = x + Samples[0] * (y + Samples[1] * z);
      return i % 977 == 5 ? std::nan("") : std::round(WavesAt(x, y, z));
    });
  Show(scene, holes);
  Picture expected;
  EXPECT_EQ(Listen([&] { expected = DrawFloats(scene); }).Warnings.size(), 1U);
  const auto image = MakeVolume(
    Samples, VTK_SHORT, [](int x, int y, int z) { return std::round(WavesAt(x, y, z)); });
  scene.Mapper->SetInputData(image);
  const Picture whole = DrawFloats(scene);
  vtkUnsignedCharArray* ghosts = image->AllocatePointGhostArray();
  ghosts->Fill(vtkDataSetAttributes::DUPLICATEPOINT);
  image->Modified();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), whole), 0.0);
  Hide(ghosts, 5, 977);
  ghosts->Modified();
  const Messages messages =
    Listen([&] { EXPECT_LE(LargestDifference(DrawFloats(scene), expected), 1e-5); });
  EXPECT_TRUE(messages.Warnings.empty()) << ::testing::PrintToString(messages.Warnings);
  EXPECT_GE(RootMeanSquare(whole, expected), 1e-3);
}

TEST(Arrays, ShowNoBlankedCells)
{
  Scene scene;
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(MakeCells());
  Show(scene, grid);
  scene.Property->SetInterpolationTypeToNearest();
  const Picture whole = DrawFloats(scene);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (cell / (Samples[0] * Samples[1]) >= 22)
    {
      grid->BlankCell(cell);
    }
  }
  grid->Modified();
  Picture half;
  EXPECT_TRUE(Listen([&] { half = DrawFloats(scene); }).Warnings.empty());
  EXPECT_GE(RootMeanSquare(half, whole), 1e-2);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(-1.0, 50.0, -1.0, 50.0, -1.0, 22.0);
  EXPECT_LE(RootMeanSquare(DrawFloats(scene), half), 2e-3);
}
