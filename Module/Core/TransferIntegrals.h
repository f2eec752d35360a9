/// Integrals over a transfer function, from which the ray caster has those between any two values.
#pragma once

#include "TransferTable.h"

#include <vector>

namespace flatblock
{
/// Rows of texels, each with one for every entry of the table:
/// - the entries themselves
/// - colour times extinction, and extinction, integrated from the first entry to this one, with
///   lengths counted in entries, both being linear between entries: as a float,
/// - and what that float leaves out: the sum of both has 48 bits, so that what is small keeps its
///   digits behind what is large
/// - sums up to here of how much varies from one entry to the next: the colour (the channel that
///   varies most), the colour's slope, the extinction; here included
constexpr int TransferRows = 4;

/// Writes the rows, one behind the other. O(entries).
std::vector<TransferTable::Entry> IntegrateTransferTable(const TransferTable& table);
} // namespace flatblock
