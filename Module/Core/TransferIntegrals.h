/// Integrals over a transfer function, from which the ray caster has those between any two values.
#pragma once

#include "TransferTable.h"

#include <vector>

namespace flatblock
{
/// Texels for each entry of the table:
/// - the entry itself
/// - colour times extinction, and extinction, integrated from the first entry to this one, with
///   lengths counted in entries, both being linear between entries: as a float,
/// - and what that float leaves out: the sum of both has 48 bits, so that what is small keeps its
///   digits behind what is large
/// - sums of by how much the slopes of the colour (of the channel that changes most) and of the
///   extinction change at the entries up to here; sum of by how much the colour changes in the
///   intervals up to the one that begins here, with it and without it
constexpr int TransferTexels = 4;

/// Writes the texels, entry by entry. O(entries).
std::vector<TransferTable::Entry> IntegrateTransferTable(const TransferTable& table);
} // namespace flatblock
