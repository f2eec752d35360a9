/// How a component of texels is classified.
#pragma once

#include "BrickSource.h"
#include "TransferTable.h"

#include <array>
#include <vector>

namespace flatblock
{
struct ComponentTable
{
  const TransferTable* Table = nullptr;
  TexelEncoding Encoding; ///< of the component's values
  double Weight = 1.0;    ///< of independent ones
  double FullColor = 1.0; ///< value that is a full colour, where values are colours
};

using ComponentTables = std::vector<ComponentTable>;

/// Scale and offset that take a texel to its position in the table, counted in entries.
inline std::array<double, 2> GetTexelToTable(const ComponentTable& component)
{
  const TransferTable& table = *component.Table;
  const double span = table.GetHighest() - table.GetLowest();
  const double last = static_cast<double>(table.GetEntries().size()) - 1.0;
  const double entriesPerValue = span > 0.0 ? last / span : 0.0;
  return { component.Encoding.Scale * entriesPerValue,
    (component.Encoding.Offset - table.GetLowest()) * entriesPerValue };
}
} // namespace flatblock
