#include "CurvatureFields.h"

#include <boost/math/differentiation/autodiff.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace flatblock::testing
{
namespace
{
constexpr double Waves = 3.0; // of the gyroid, in radians a length

// Derivatives are those of the formula itself, by automatic differentiation.
template <typename Formula>
CurvatureField MakeField(const char* name, Formula formula)
{
  CurvatureField field;
  field.Name = name;
  field.Value = [formula](const std::array<double, 3>& p) { return formula(p[0], p[1], p[2]); };
  field.Derivatives = [formula](const std::array<double, 3>& p) -> FieldDerivatives
  {
    const auto variables =
      boost::math::differentiation::make_ftuple<double, 2, 2, 2>(p[0], p[1], p[2]);
    const auto value =
      formula(std::get<0>(variables), std::get<1>(variables), std::get<2>(variables));
    const auto take = [&value](int x, int y, int z)
    { return static_cast<double>(value.derivative(x, y, z)); };
    FieldDerivatives found;
    found.Gradient = { take(1, 0, 0), take(0, 1, 0), take(0, 0, 1) };
    found.Hessian = { take(2, 0, 0), take(0, 2, 0), take(0, 0, 2), take(0, 1, 1), take(1, 0, 1),
      take(1, 1, 0) };
    return found;
  };
  return field;
}

std::vector<CurvatureField> MakeFields()
{
  using std::cos;
  using std::exp;
  using std::sin;
  using std::sqrt;
  const auto bump = [](auto x, auto y, auto z, double width)
  { return exp((x * x + y * y + z * z) * (-1.0 / (width * width))); };
  return {
    MakeField(
      "sphere", [](auto x, auto y, auto z) { return 0.6 - sqrt(x * x + y * y + z * z + 0.0); }),
    MakeField("ellipsoid", [](auto x, auto y, auto z)
      { return 1.0 - sqrt(x * x / 0.64 + y * y / 0.36 + z * z / 0.2025); }),
    MakeField("torus",
      [](auto x, auto y, auto z)
      {
        const auto across = sqrt(x * x + y * y) - 0.5;
        return 0.25 - sqrt(across * across + z * z);
      }),
    MakeField(
      "cylinder", [](auto x, auto y, auto z) { return 0.4 - sqrt(x * x + z * z + 0.0 * y); }),
    MakeField(
      "saddle", [](auto x, auto y, auto z) { return 0.35 * (cos(2.0 * y) - cos(2.0 * x)) - z; }),
    MakeField("gyroid",
      [](auto x, auto y, auto z)
      {
        return sin(Waves * x) * cos(Waves * y) + sin(Waves * y) * cos(Waves * z) +
               sin(Waves * z) * cos(Waves * x);
      }),
    MakeField("Gaussians",
      [bump](auto x, auto y, auto z)
      {
        return bump(x - 0.25, y, z, 0.4) + bump(x + 0.3, y - 0.2, z + 0.1, 0.35) +
               bump(x, y + 0.35, z - 0.2, 0.3) - 0.5;
      }),
  };
}
} // namespace

const std::vector<CurvatureField>& GetCurvatureFields()
{
  static const std::vector<CurvatureField> fields = MakeFields();
  return fields;
}

const CurvatureField& GetCurvatureField(const std::string& name)
{
  const std::vector<CurvatureField>& fields = GetCurvatureFields();
  const auto found = std::find_if(fields.begin(), fields.end(),
    [&name](const CurvatureField& field) { return field.Name == name; });
  if (found == fields.end())
  {
    throw std::invalid_argument("No field " + name);
  }
  return *found;
}
} // namespace flatblock::testing
