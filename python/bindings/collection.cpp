#include "limber/run/collection.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "process_driver.hpp"
#include "python_driver.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// Makes a virtual arm an episode.
struct VirtualArms {
  DriverFactory make;
};

/// One process for all episodes, one after the other.
CollectionResult collect_on(const ArmDescription& arm, CollectionSettings settings,
                            SharedProcessDriver& shared, const fs::path& path,
                            CallerThread& caller) {
  const SharedProcessDriver::Use driver(shared);
  require_reach(arm, settings.schedule.limit_scale, *driver);
  settings.source = describe(*driver);
  settings.driver = how_it_is_moved(*driver);
  settings.jobs = 1;
  settings.partial = fs::path(path).replace_extension(".partial.h5");
  return caller.run([&] { return collect(arm, settings, on_one_driver(*driver), path); });
}

CollectionResult collect_with(const ArmDescription& arm, const CollectionSettings& asked,
                              const py::object& make_driver, const fs::path& path) {
  require_jobs(asked.jobs);
  require_number("hold_limit_s", asked.hold_limit_s, 0.0, kMaxSeconds);
  CollectionSettings settings = asked;
  CallerThread caller;
  settings.should_stop = [&] { return caller.should_stop(); };
  DriverFactory factory;
  if (py::isinstance<VirtualArms>(make_driver)) {
    factory = make_driver.cast<const VirtualArms&>().make;
  } else if (py::isinstance<SharedProcessDriver>(make_driver)) {
    return collect_on(arm, settings, make_driver.cast<SharedProcessDriver&>(), path, caller);
  } else {
    factory = [&](int index) -> std::unique_ptr<ArmDriver> {
      std::unique_ptr<ArmDriver> driver;
      if (!caller.call(
              [&] { driver = std::make_unique<PythonDriver>(make_driver(index), caller); })) {
        throw Interrupted("make_driver raised an exception");
      }
      return driver;
    };
  }
  return caller.run([&] { return collect(arm, settings, factory, path); });
}

void bind_schedule(py::module_& module) {
  Choice<ScheduleKind>(module, "ScheduleKind", "Which motions are recorded.")
      .value("transitions", ScheduleKind::transitions,
             "between configurations with each segment fully right, fully left or off")
      .value("random", ScheduleKind::random,
             "between configurations sampled uniformly within the limits");
  Choice<Approach>(module, "Approach", "How set points go to the next configuration.")
      .value("step", Approach::step, "they jump, and each valve ramps by itself")
      .value("straight", Approach::straight, "together, along a straight line, as a plan's do");
  Record<ScheduleSettings>(module, "ScheduleSettings", "What motions are recorded.")
      .field("kind", &ScheduleSettings::kind, "ScheduleKind: which motions.")
      .field("count", &ScheduleSettings::count,
             "Number of motions: in all for transitions, 0: every one; in each episode for "
             "random, >= 1.")
      .field("episodes", &ScheduleSettings::episodes,
             "Number of episodes; 0: 16 for transitions, 1 for random.")
      .field("approach", &ScheduleSettings::approach,
             "Approach: how set points go to the next configuration.")
      .field("hold_s", &ScheduleSettings::hold_s,
             "How long a motion's final set point is commanded [s], > 0.")
      .field("limit_scale", &ScheduleSettings::limit_scale,
             "Motions stay within so many times the arm's limits, in (0, 1].")
      .field("hold_min_s", &ScheduleSettings::hold_min_s,
             "Each hold is sampled between this and hold_s [s]; None: they are all hold_s.")
      .keywords()
      .done();
}

}  // namespace

void bind_collection(py::module_& module) {
  bind_schedule(module);
  Choice<Progress::Mode>(module, "ProgressMode", "Whether progress goes to standard error.")
      .value("automatic", Progress::Mode::automatic, "often on a terminal, else every 10 s")
      .value("quiet", Progress::Mode::quiet, "never");
  Record<CollectionSettings>(module, "CollectionSettings", "How an arm is recorded by `collect`.")
      .field("schedule", &CollectionSettings::schedule, "ScheduleSettings: which motions.")
      .field("seed", &CollectionSettings::seed, "Seed of the schedule's order.")
      .field("source", &CollectionSettings::source, "What moves, in words; kept in the recording.")
      .field("driver", &CollectionSettings::driver,
             "Everything else that decides the data, such as noise, in words; kept in the "
             "recording.")
      .field("hold_limit_s", &CollectionSettings::hold_limit_s,
             "A set point that is not reached by then is a SystemFault [s], >= hold_s.")
      .field("jobs", &CollectionSettings::jobs, "Threads, 0: one per core; never changes a result.")
      .field("resume", &CollectionSettings::resume,
             "Whether to go on from the finished episodes of an interrupted run.")
      .field("force", &CollectionSettings::force,
             "Whether to replace the file if it exists; else that is an InputError.")
      .field("progress", &CollectionSettings::progress,
             "ProgressMode: whether progress goes to standard error.")
      .keywords()
      .done();
  Record<CollectionResult>(module, "CollectionResult",
                           "What `collect` recorded, and how long it took.")
      .read_only("recording", &CollectionResult::recording, "The Recording, as in the file.")
      .read_only("kept_episodes", &CollectionResult::kept_episodes,
                 "Episodes that `resume` found finished.")
      .read_only("wall_time_s", &CollectionResult::wall_time_s, "How long this run took [s].")
      .done();
  py::class_<VirtualArms>(module, "DriverFactory",
                          "Makes a virtual arm for each episode; virtual_arm_factory returns one.")
      .def("__repr__",
           [](const VirtualArms&) { return "DriverFactory(a VirtualArm for each episode)"; });
  module.def(
      "virtual_arm_factory",
      [](const ArmDescription& arm, const VirtualArmOptions& options) {
        return VirtualArms{virtual_arm_factory(arm, options)};
      },
      "arm"_a, "options"_a = VirtualArmOptions{}, py::keep_alive<0, 1>(),
      "A DriverFactory for `collect`: a fresh VirtualArm for each episode, with noise of its own.");
  module.def(
      "virtual_collection",
      [](const ArmDescription& arm, const ScheduleSettings& schedule,
         const VirtualArmOptions& options) {
        CollectionSettings settings = virtual_collection(arm, schedule, options);
        settings.progress = Progress::Mode::quiet;
        return settings;
      },
      "arm"_a, "schedule"_a, "options"_a = VirtualArmOptions{},
      "CollectionSettings for the virtual arm, with its source, driver and seed.");
  module.def(
      "collect", &collect_with, "arm"_a, "settings"_a, "make_driver"_a, "path"_a,
      "Records a schedule to `path` (HDF5). make_driver: virtual_arm_factory(...), a "
      "ProcessDriver, or a function of the episode's index that returns an ArmDriver. Ctrl-C vents "
      "the arm and raises KeyboardInterrupt; finished episodes stay, for resume=True.");
}

}  // namespace limber::python
