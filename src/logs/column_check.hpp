#pragma once

#include <string>
#include <vector>

#include "level_correlation.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"

namespace limber {

/// Why a log can't tell whether a segment's column is its own.
enum class Undecidable {
  no,             ///< it can
  turned_little,  ///< the segment hardly turned
  told_little,    ///< its column hardly changed
  moved_seldom,   ///< too few motions to tell
  told_alike      ///< as another segment
};

/// Which column drives a segment, and with which sign, as its motion has it.
struct FittedColumn {
  Eigen::Index column = 0;
  bool turned = false;       ///< its sign is the opposite of what the arm file says
  double as_given = 0.0;     ///< correlation of the column that the mapping gives, 1 being perfect
  double correlation = 0.0;  ///< of `column` with its sign
  bool follows_weakly = false;  ///< it moved often, and hardly as its column says
  Undecidable undecidable = Undecidable::no;
  Eigen::Index alike = 0;  ///< Undecidable::told_alike: the other segment
};

/// Whether a log's columns are those of the arm's segments (docs/importing.md).
struct ColumnFit {
  std::vector<FittedColumn> segments;  ///< n
  double given_evidence = 0.0;         ///< [nats] for order and signs as given
  double best_evidence = 0.0;          ///< for the best order and signs
  bool belongs = true;  ///< those are not decisively better: columns are taken as given
};

/// +1 where a larger command bends to the left, −1 to the right, 0 where nothing is known of it.
double bends_left(const ArmDescription& arm, Eigen::Index segment);

/// Odds of 20 to 1, and of 20 000 to 1 against a log whose companions have proven the mapping.
inline constexpr double kDecisive = 3.0;        // [nats]
inline constexpr double kDecisiveAlone = 10.0;  // [nats]

/// Of all orders of the columns and all their signs, those that the segments' turns speak for most;
/// others than the given ones only where they are better by `decisive`. Where the no-load model is
/// straight, no sign is wrong.
ColumnFit fit_columns(const LevelCorrelations& levels, const ArmDescription& arm,
                      double decisive = kDecisive);

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
                   const ImportMapping& mapping, const ArmDescription& arm,
                   std::vector<SegmentCheck>& checks);

}  // namespace limber
