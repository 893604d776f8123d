// Units handed out over MPI, longest first, to whichever rank is free. No other file knows MPI;
// a module of its own, so that the program does not need it (lab/rank_work.hpp).
//
// Rank 0 works as the others do, on a thread of its own: its first thread answers. It sleeps
// between looks, because each rank has one core, which is for units. Two messages of a number per
// unit.

#include <mpi.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "limber/common/seconds_since.hpp"
#include "limber/lab/rank_work.hpp"

namespace limber {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kAsk = 1;  // tags
constexpr int kAnswer = 2;
constexpr long long kNoMore = -1;
// Between looks for questions: 1 ms is allowed. A look takes 20 µs from the core's unit.
constexpr std::chrono::microseconds kLook{800};
constexpr std::chrono::milliseconds kEndLook{5};  // while others still work

/// The units of rank 0, which its two threads share.
class Queue {
 public:
  explicit Queue(const RankWork& work) : work_(work), units_(work.list()) {}

  long long next() {
    const std::lock_guard lock(mutex_);
    if (next_ == units_.size() || work_.should_stop()) {
      return kNoMore;
    }
    return static_cast<long long>(units_[next_++]);
  }
  std::size_t handed_out() const { return next_; }

 private:
  const RankWork& work_;
  std::vector<std::size_t> units_;
  std::size_t next_ = 0;
  std::mutex mutex_;
};

struct Busy {
  double seconds = 0.0;
  void run(const RankWork& work, long long unit) {
    const Clock::time_point begin = Clock::now();
    work.run(std::size_t(unit));
    seconds += seconds_since(begin);
  }
};

/// Until every other rank has heard that there is no more, and rank 0 itself is done.
void answer(Queue& queue, int others, const std::atomic<bool>& own_done) {
  while (others > 0 || !own_done) {
    int there = 0;
    MPI_Status status;
    // Open MPI looks for new messages only after it has looked among the known ones: so twice.
    for (int look = 0; look < 2 && there == 0; ++look) {
      MPI_Iprobe(MPI_ANY_SOURCE, kAsk, MPI_COMM_WORLD, &there, &status);
    }
    if (there == 0) {
      std::this_thread::sleep_for(others > 0 ? std::chrono::microseconds(kLook) : kEndLook);
      continue;
    }
    int stops = 0;
    MPI_Recv(&stops, 1, MPI_INT, status.MPI_SOURCE, kAsk, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const long long unit = stops != 0 ? kNoMore : queue.next();
    MPI_Send(&unit, 1, MPI_LONG_LONG, status.MPI_SOURCE, kAnswer, MPI_COMM_WORLD);
    others -= unit == kNoMore ? 1 : 0;
  }
}

struct Waits {
  double sum_s = 0.0;
  double max_s = 0.0;
  double count = 0.0;
};

void work_as_asked(const RankWork& work, Busy& busy, Waits& waits) {
  while (true) {
    const Clock::time_point begin = Clock::now();
    long long unit = kNoMore;
    const int stops = work.should_stop() ? 1 : 0;  // this rank alone: the others go on
    MPI_Send(&stops, 1, MPI_INT, 0, kAsk, MPI_COMM_WORLD);
    MPI_Recv(&unit, 1, MPI_LONG_LONG, 0, kAnswer, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (unit == kNoMore) {
      return;
    }
    const double wait_s = seconds_since(begin);
    waits = {waits.sum_s + wait_s, std::max(waits.max_s, wait_s), waits.count + 1.0};
    busy.run(work, unit);
  }
}

/// A barrier that leaves the core to those who still work.
void wait_for_all() {
  MPI_Request all;
  MPI_Ibarrier(MPI_COMM_WORLD, &all);
  for (int done = 0; done == 0;) {
    std::this_thread::sleep_for(kEndLook);
    MPI_Test(&all, &done, MPI_STATUS_IGNORE);
  }
}

RankFigures run_ranks(const RankWork& work) {
  RankFigures figures;
  MPI_Comm_rank(MPI_COMM_WORLD, &figures.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &figures.ranks);
  Busy busy;
  Waits waits;
  Clock::time_point begin = Clock::now();
  if (figures.rank == 0) {
    Queue queue(work);
    begin = Clock::now();
    std::atomic<bool> own_done = false;
    std::thread own([&] {
      for (long long unit = queue.next(); unit != kNoMore; unit = queue.next()) {
        busy.run(work, unit);
      }
      own_done = true;
    });
    answer(queue, figures.ranks - 1, own_done);
    own.join();
    figures.units = queue.handed_out();
  } else {
    work_as_asked(work, busy, waits);
  }
  wait_for_all();
  const double span_s = seconds_since(begin);
  const double sums[3] = {waits.sum_s, waits.count, busy.seconds};
  double all[3] = {};
  MPI_Reduce(sums, all, 3, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(&waits.max_s, &figures.hand_out_max_s, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  figures.hand_out_mean_s = all[1] > 0.0 ? all[0] / all[1] : 0.0;
  figures.busy_share = span_s > 0.0 ? all[2] / (span_s * figures.ranks) : 1.0;
  return figures;
}

}  // namespace

}  // namespace limber

extern "C" limber::RankFigures limber_run_over_ranks(const limber::RankWork& work) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  // The other ranks wait for an answer: where there is no list, that there is no more.
  std::exception_ptr refusal;
  limber::RankWork answered = work;
  answered.list = [&] {
    try {
      return work.list();
    } catch (...) {
      refusal = std::current_exception();
      return std::vector<std::size_t>();
    }
  };
  const limber::RankFigures figures = limber::run_ranks(answered);
  MPI_Finalize();
  if (refusal) {
    std::rethrow_exception(refusal);
  }
  return figures;
}
