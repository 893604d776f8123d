#pragma once

#include <string>
#include <vector>

#include "column_fit.hpp"
#include "level_correlation.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"

namespace limber {

/// Refuses a log whose columns are another segment's or of the other sign, and says which order and
/// signs would fit. @pre !fit.belongs. @throws InputError, its message beginning with `log`.
[[noreturn]] void refuse_columns(const std::string& log, const ColumnFit& fit,
                                 const ImportMapping& mapping, const ArmDescription& arm);

/// Does so where an import's logs ask for it: all of them together decide about the mapping, then
/// each about itself. Notes in `checks` segments that hardly follow their columns and those of
/// which these logs can't tell.
/// @param logs  names, one for each of `levels`.
/// @throws InputError; also where no segment follows its column at all.
void check_columns(const std::vector<std::string>& logs, const std::vector<LevelTable>& levels,
                   const ImportMapping& mapping, const ArmDescription& arm, ColumnReport& checks);

}  // namespace limber
