#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/error.hpp"
#include "limber/logs/import_mapping.hpp"

namespace limber {

/// A log with a plausible clock that is slower than the arm: another frame rate in the arm file
/// would do.
class SlowLog : public InputError {
  using InputError::InputError;
};

/// What is said where several logs are to be imported and some are slower than the arm.
/// @param rates_hz  of all of them, named by `logs`
[[noreturn]] void refuse_slow_logs(const std::vector<std::string>& logs,
                                   const std::vector<double>& rates_hz, const ArmDescription& arm);

/// Refuses times that can't be a log's of this arm, before anything is allocated by them: fewer
/// rows per second than the arm has frames, more than any logger gives, or gaps that make up most
/// of the log. Such times are mostly in another unit than the mapping says; the message guesses
/// which.
/// @param time_s  increasing, at least 2.
/// @throws InputError naming the log, the column, what was found and what is allowed; SlowLog where
/// a lower frame rate of the arm would do.
void check_clock(const std::string& log, const TimeColumn& time, const std::vector<double>& time_s,
                 const ArmDescription& arm);

/// Refuses a command log on a clock of its own that is far shorter than the motion log, or longer
/// than a day. @throws InputError as above.
void check_span(const std::string& log, const TimeColumn& time, const std::vector<double>& time_s,
                const std::string& motion_log, const std::vector<double>& motion_time_s);

}  // namespace limber
