#include "limber/data/recording.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/recording_export.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

FrameMatrix frames_from(const FloatArray& array, py::ssize_t frames, const char* name) {
  if (array.ndim() == 0 || array.shape(0) != frames) {
    throw InputError(fmt::format("{} has shape {}; expected {} frames, as time_s has", name,
                                 to_text(shape_of(array)), frames));
  }
  const py::ssize_t columns = frames == 0 ? 0 : array.size() / frames;
  return Eigen::Map<const FrameMatrix>(array.data(), frames, columns);
}

/// One whole number for each frame.
template <class Number>
std::vector<Number> numbers_from(const DoubleArray& values, py::ssize_t frames, const char* name,
                                 Number highest) {
  require_shape(values, {frames}, name);
  for (py::ssize_t t = 0; t < frames; ++t) {
    require_number(name, values.data()[t], 0.0, highest);
    if (values.data()[t] != std::floor(values.data()[t])) {
      throw InputError(fmt::format("{} = {}; expected whole numbers", name, values.data()[t]));
    }
  }
  return {values.data(), values.data() + frames};
}

Episode make_episode(const DoubleArray& time_s, const FloatArray& pressure_kpa,
                     const FloatArray& setpoint_kpa, const FloatArray& backbone,
                     const DoubleArray& motion_index, const std::optional<DoubleArray>& tracked,
                     bool setpoints_only, const std::string& physics, bool lifted,
                     const std::string& log) {
  Episode episode;
  episode.setpoints_only = setpoints_only;
  episode.physics = physics;
  episode.log = log;
  const py::ssize_t frames = time_s.size();
  require_shape(time_s, {frames}, "time_s");
  episode.motion_index =
      numbers_from(motion_index, frames, "motion_index", std::numeric_limits<int>::max());
  if (tracked) {
    episode.tracked = numbers_from(*tracked, frames, "tracked", std::uint8_t{1});
  }
  const OthersMayRun others_may_run;
  require_finite(time_s, "time_s");
  episode.time_s = Eigen::Map<const Eigen::VectorXd>(time_s.data(), frames);
  for (py::ssize_t t = 1; t < frames; ++t) {
    if (episode.time_s[t] <= episode.time_s[t - 1]) {
      throw InputError(fmt::format("time_s[{}] = {} follows {}; expected times to increase", t,
                                   episode.time_s[t], episode.time_s[t - 1]));
    }
  }
  episode.pressure_kpa = frames_from(pressure_kpa, frames, "pressure_kpa");
  episode.setpoint_kpa = frames_from(setpoint_kpa, frames, "setpoint_kpa");
  if (frames > 0 && (pressure_kpa.ndim() != 2 || pressure_kpa.size() == 0)) {
    throw InputError(
        fmt::format("pressure_kpa has shape {}; expected (T, n)", to_text(shape_of(pressure_kpa))));
  }
  require_shape(setpoint_kpa, shape_of(pressure_kpa), "setpoint_kpa");
  refuse_if(setpoints_only && episode.pressure_kpa != episode.setpoint_kpa,
            "pressure_kpa is not setpoint_kpa; expected that with setpoints_only");
  const bool in_space = backbone.ndim() == 3 && backbone.shape(2) == kSpacePoseSize;
  if (backbone.ndim() != 3 || (!in_space && backbone.shape(2) != kPoseSize) ||
      (frames > 0 && backbone.shape(1) < 2)) {
    throw InputError(
        fmt::format("backbone has shape {}; expected (T, m, 3), in space (T, m, 7), m from 2",
                    to_text(shape_of(backbone))));
  }
  episode.dimension = in_space ? Dimension::space : Dimension::plane;
  episode.lifted = lifted;
  episode.backbone = frames_from(backbone, frames, "backbone");
  if (in_space) {
    make_signs_continuous(episode.backbone);
  }
  return episode;
}

/// One list of frames, a view.
template <FrameMatrix Episode::*kFrames>
py::array_t<float> frames_of(const py::object& self) {
  const FrameMatrix& frames = self.cast<const Episode&>().*kFrames;
  return view_of(frames.data(), {frames.rows(), frames.cols()}, self);
}

py::array_t<bool> tracked_of(const Episode& episode) {
  py::array_t<bool> tracked(episode.frame_count());
  for (int t = 0; t < episode.frame_count(); ++t) {
    tracked.mutable_at(t) = episode.was_tracked(t);
  }
  return tracked;
}

void bind_episode(py::module_& module) {
  py::class_<Episode>(module, "Episode",
                      "One unbroken run of the arm: T frames, n segments, m plates. Its arrays "
                      "are read-only views of limber's own memory.")
      .def(py::init(&make_episode), "time_s"_a, "pressure_kpa"_a, "setpoint_kpa"_a, "backbone"_a,
           "motion_index"_a, "tracked"_a = py::none(), "setpoints_only"_a = false, "physics"_a = "",
           "lifted"_a = false, "log"_a = "",
           "Copies its arrays once: time_s (T,) [s], pressure_kpa and setpoint_kpa (T, n) "
           "[kPa], backbone (T, m, 3) in frame B, in space (T, m, 7), motion_index (T,), and "
           "tracked (T,) or None: all frames. With setpoints_only, pressure_kpa has to be "
           "setpoint_kpa. lifted: in space, rotations were made from positions. log: the "
           "file that it is of. Raises InputError naming the array that does not fit.")
      .def_property_readonly(
          "time_s",
          [](const py::object& self) {
            const auto& episode = self.cast<const Episode&>();
            return view_of(episode.time_s.data(), {episode.time_s.size()}, self);
          },
          "Time of each frame, float64 (T,) [s], increasing.")
      .def_property_readonly(
          "pressure_kpa", &frames_of<&Episode::pressure_kpa>,
          "Measured, float32 (T, n) [kPa], positive bends right; the set points, where "
          "nothing was measured.")
      .def_property_readonly(
          "setpoint_kpa", &frames_of<&Episode::setpoint_kpa>,
          "Set points that were commanded, float32 (T, n) [kPa], positive bends right.")
      .def_property_readonly(
          "backbone",
          [](const py::object& self) {
            const auto& episode = self.cast<const Episode&>();
            const FrameMatrix& rows = episode.backbone;
            return view_of(rows.data(),
                           {rows.rows(), episode.point_count(), pose_size(episode.dimension)},
                           self);
          },
          "Poses x_m, y_m, theta_rad of the plates, float32 (T, m, 3); in space x_m, y_m, z_m, "
          "qx, qy, qz, qw, (T, m, 7).")
      .def_property_readonly(
          "dimension", [](const Episode& episode) { return position_size(episode.dimension); },
          "2: poses in a plane, 3: in space.")
      .def_readonly("lifted", &Episode::lifted,
                    "In space: rotations were made from positions, and no error is measured "
                    "of them.")
      .def_property_readonly(
          "motion_index",
          [](const py::object& self) {
            const auto& index = self.cast<const Episode&>().motion_index;
            return view_of(index.data(), {static_cast<py::ssize_t>(index.size())}, self);
          },
          "Number of the commanded motion that a frame belongs to, int32 (T,).")
      .def_property_readonly("tracked", &tracked_of,
                             "Whether the backbone was seen, bool (T,); a copy.")
      .def_readonly("setpoints_only", &Episode::setpoints_only,
                    "Nothing was measured: pressure_kpa holds the set points.")
      .def_readonly("physics", &Episode::physics,
                    "JSON of what a varied virtual arm has other than its file (limber collect "
                    "--vary-physics); '' otherwise.")
      .def_readonly("log", &Episode::log,
                    "File name of the log that it was imported from; '' where there is none.")
      .def_property_readonly("frame_count", &Episode::frame_count, "T: number of frames.")
      .def_property_readonly("untracked_count", &Episode::untracked_count,
                             "Number of frames without a measured backbone.")
      .def("__len__", &Episode::frame_count)
      .def("__repr__", [](const Episode& episode) {
        return fmt::format("Episode(frames={}, {}={}, points={})", episode.frame_count(),
                           episode.dimension == Dimension::space ? "chambers" : "segments",
                           episode.pressure_kpa.cols(), episode.point_count());
      });
}

void bind_recording(py::module_& module) {
  py::class_<Recording>(module, "Recording",
                        "Recorded motion of an arm: episodes of pressures and backbones.")
      .def_readonly("arm_name", &Recording::arm_name, "Name of the arm that moved.")
      .def_readonly("arm_hash", &Recording::arm_hash, "ArmDescription.hash() of it.")
      .def_readonly("segment_count", &Recording::segment_count, "Segments of that arm.")
      .def_property_readonly("channel_count", &Recording::channel_count,
                             "n: commands of that arm, one for each segment, in space for each "
                             "chamber.")
      .def_property_readonly(
          "dimension",
          [](const Recording& recording) { return position_size(recording.dimension); },
          "2: poses in a plane, backbones are (T, m, 3); 3: in space, (T, m, 7).")
      .def_readonly("point_count", &Recording::point_count, "m: plates of that arm.")
      .def_readonly("rate_hz", &Recording::rate_hz, "Frames per second [Hz].")
      .def_readonly("seed", &Recording::seed,
                    "Seed of its schedule and of noise; 0 for recordings of logs.")
      .def_readonly("source", &Recording::source,
                    "What moved, in words: \"virtual arm\", \"motive log.csv\", ...")
      .def_readwrite("settings", &Recording::settings,
                     "How it was collected, in words; can be set.")
      .def_readonly("program_version", &Recording::program_version,
                    "Version of limber that wrote the file.")
      .def_property_readonly(
          "episodes",
          [](const py::object& self) {
            py::list episodes;
            for (const Episode& episode : self.cast<const Recording&>().episodes) {
              episodes.append(
                  py::cast(&episode, py::return_value_policy::reference_internal, self));
            }
            return episodes;
          },
          "List of Episode, its runs; no copies.")
      .def_property_readonly("setpoints_only", &Recording::setpoints_only,
                             "Nothing was measured in any of its episodes.")
      .def_property_readonly("frame_count", &Recording::frame_count,
                             "Number of frames of all episodes.")
      .def_property_readonly("untracked_count", &Recording::untracked_count,
                             "Number of frames without a measured backbone.")
      .def_property_readonly("duration_s", &Recording::duration_s,
                             "Length of all episodes together, frames / rate [s].")
      .def("__repr__", [](const Recording& recording) {
        return fmt::format("Recording(arm='{}', episodes={}, frames={}, duration_s={:.1f})",
                           recording.arm_name, recording.episodes.size(), recording.frame_count(),
                           recording.duration_s());
      });
}

void bind_export(py::module_& module) {
  module.def("export_csv", &export_csv, "recording"_a, "folder"_a, py::call_guard<OthersMayRun>(),
             "Writes each episode as one CSV table, and mapping.yaml to read them back with "
             "import_csv. folder: made where it is missing.");
  Record<EpisodeErrors>(module, "EpisodeErrors", "The simple model's error in every episode.")
      .property("outliers", &EpisodeErrors::outliers,
                "Numbers of the broken episodes, from 0, rising; never one of fewer than 5 "
                "episodes.")
      .read_only("median_cm", &EpisodeErrors::median_cm,
                 "Middle one of the episodes' errors at the tip [cm].")
      .read_only("limit_cm", &EpisodeErrors::limit_cm,
                 "An episode with a larger error is an outlier [cm]; inf for fewer than 5 "
                 "episodes.")
      .done()
      .def_property_readonly(
          "tip_cm",
          [](const EpisodeErrors& errors) {
            return mapped<double>(errors.episodes,
                                  [&](const EpisodeError& one) { return one.tip_cm; });
          },
          "Mean error of each episode at the tip, a list [cm]; NaN where nothing was tracked.")
      .def("__str__", [](const EpisodeErrors& errors) { return to_text(errors); });
  module.def(
      "episode_errors",
      [](const ArmDescription& arm, const EpisodeList& episodes) {
        const std::vector<Episode> copies = episodes_from(episodes);
        return interruptibly([&] { return episode_errors(arm, copies); });
      },
      "arm"_a, "episodes"_a,
      "EpisodeErrors of the simple model, fitted to all episodes; an episode far "
      "above the others was broken. Raises InputError where there is no episode, or "
      "nothing was tracked.");
}

void bind_recording_inspection(py::module_& module) {
  module.def(
      "inspect",
      [](const Recording& recording, const ArmDescription* arm, const std::string& file) {
        return to_text(recording, inspect(recording, arm, file));
      },
      "recording"_a, "arm"_a = py::none(), "file"_a = "recording", py::call_guard<OthersMayRun>(),
      "What a recording holds and what is odd about it, a text. arm: gives the "
      "limits, None: the largest set points stand for them; file: its name in messages.");
  module.def(
      "identify_valves",
      [](const EpisodeList& episodes, const ArmDescription& arm, const std::string& source) {
        const std::vector<Episode> copies = episodes_from(episodes);
        const OthersMayRun others_may_run;
        require_episodes_of(copies, arm, source);
        return identify_valves(copies, arm, source);
      },
      "episodes"_a, "arm"_a, "source"_a = "recordings",
      "IdentifiedValves between set points and measured pressures; the findings say how well they "
      "fit, or why there are none. source: the recordings' name in the findings.");
}

/// @throws TypeError with what to write instead.
[[noreturn]] void refuse_episodes(const py::handle& found, const char* where) {
  const char* hint = "";
  if (py::isinstance<Recording>(found)) {
    hint = "; its episodes are recording.episodes";
  } else if (py::isinstance<Episode>(found)) {
    hint = "; put it in a list: [episode]";
  } else if (py::isinstance<py::str>(found) || py::hasattr(found, "__fspath__")) {
    hint = "; read_recording(path).episodes is one";
  }
  throw py::type_error(
      fmt::format("expected a list of Episode, found {}{}{}", type_name(found), where, hint));
}

}  // namespace

std::vector<Episode> episodes_from(const EpisodeList& episodes) {
  if (py::isinstance<Episode>(episodes) || !py::isinstance<py::iterable>(episodes) ||
      py::isinstance<py::str>(episodes)) {
    refuse_episodes(episodes, "");
  }
  std::vector<py::object> kept;  // whose last owner the iterable may be
  std::vector<const Episode*> found;
  for (const py::handle& episode : episodes) {
    if (!py::isinstance<Episode>(episode)) {
      refuse_episodes(episode, " in the list");
    }
    kept.push_back(py::reinterpret_borrow<py::object>(episode));
    found.push_back(&episode.cast<const Episode&>());
  }
  const OthersMayRun others_may_run;
  std::vector<Episode> copies;
  copies.reserve(found.size());
  for (const Episode* episode : found) {
    copies.push_back(*episode);
  }
  return copies;
}

py::list episodes_to(std::vector<Episode> episodes) {
  py::list list;
  for (Episode& episode : episodes) {
    list.append(py::cast(std::move(episode)));
  }
  return list;
}

void bind_recordings(py::module_& module) {
  bind_episode(module);
  bind_recording(module);
  module.def(
      "make_recording",
      [](const ArmDescription& arm, const EpisodeList& episodes, const std::string& source,
         std::uint64_t seed) {
        Recording recording = make_recording(arm, source, seed);
        recording.episodes = episodes_from(episodes);
        const OthersMayRun others_may_run;
        validate(recording, "recording");
        require_episodes_of(recording.episodes, arm, "recording");
        return recording;
      },
      "arm"_a, "episodes"_a, "source"_a = "python", "seed"_a = 0,
      "A Recording of these episodes (copied), checked: sizes agree, times increase, "
      "numbers are finite; else InputError. source: what moved, in words.");
  module.def(
      "with_setpoints_only",
      [](const EpisodeList& episodes) {
        std::vector<Episode> copies = episodes_from(episodes);
        {
          const OthersMayRun others_may_run;
          copies = with_setpoints_only(std::move(copies));
        }
        return episodes_to(std::move(copies));
      },
      "episodes"_a,
      "Copies of the episodes without measured pressures: set points take their place.");
  module.def("read_recording", &read_recording, "path"_a, py::call_guard<OthersMayRun>(),
             "Reads and checks a recording (HDF5). Raises InputError naming file and field.");
  module.def("write_recording", &write_recording, "path"_a, "recording"_a,
             py::call_guard<OthersMayRun>(),
             "Writes a recording (HDF5) that read_recording reads, atomically.");
  module.def("require_recording_of", &require_recording_of, "recording"_a, "arm"_a,
             "file"_a = "recording", py::call_guard<OthersMayRun>(),
             "Raises InputError where the recording is not one of this arm. file: the "
             "recording's name in the message.");
  bind_export(module);
  bind_recording_inspection(module);
}

}  // namespace limber::python
