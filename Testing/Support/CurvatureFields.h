/// Fields whose derivatives are known, in and around the cube [-1, 1]^3; their surface is where
/// they are 0, and above it they are inside.
#pragma once

#include "ReferenceCurvature.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace flatblock::testing
{
struct CurvatureField
{
  std::string Name;
  std::function<double(const std::array<double, 3>&)> Value;
  std::function<FieldDerivatives(const std::array<double, 3>&)> Derivatives;
};

/// Sphere, ellipsoid, torus, cylinder, saddle, gyroid, sum of Gaussians.
const std::vector<CurvatureField>& GetCurvatureFields();
const CurvatureField& GetCurvatureField(const std::string& name);
} // namespace flatblock::testing
