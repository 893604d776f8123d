#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

/// For EXPECT_EXIT: the process ends with 0 if `work` heeds a Ctrl-C that has come, with 1 if
/// it runs to its end.
template <class Work>
[[noreturn]] void exit_interrupted(const Work& work) {
  install_interrupt_handler();
  std::raise(SIGINT);
  try {
    work();
  } catch (const Interrupted& stop) {
    std::fputs(stop.what(), stderr);
    std::exit(0);
  }
  std::exit(1);
}

}  // namespace limber
