#include "limber/forward/forward_model.hpp"

#include <time.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/forward/checked_query.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// Scratch of this thread. What it holds never reaches a result.
ForwardModel::Workspace& workspace() {
  thread_local ForwardModel::Workspace scratch;
  return scratch;
}

using Before = std::optional<FloatArray>;  // the backbone of a frame before `previous`

void require_finite_query(const FloatArray& previous_kpa, const FloatArray& current_kpa,
                          const FloatArray& previous, const Before& before) {
  require_finite(previous_kpa, "previous_kpa");
  require_finite(current_kpa, "current_kpa");
  require_finite(previous, "previous");
  if (before) {
    require_finite(*before, "before");
  }
}

/// Sizes of one query or, with `rows` ≥ 0, of a batch.
void require_query_shapes(const ForwardModel& model, py::ssize_t rows,
                          const FloatArray& previous_kpa, const FloatArray& current_kpa,
                          const FloatArray& previous, const Before& before) {
  const py::ssize_t n = model.command_size();
  const py::ssize_t m = model.point_count();
  const py::ssize_t size = pose_size(model.dimension());
  const bool fits = rows < 0 ? previous_kpa.ndim() == 1 && previous_kpa.shape(0) == n &&
                                   current_kpa.ndim() == 1 && current_kpa.shape(0) == n &&
                                   previous.ndim() == 2 && previous.shape(0) == m &&
                                   previous.shape(1) == size
                             : false;
  if (!fits) {
    require_shape(previous_kpa, rows < 0 ? Shape{n} : Shape{rows, n}, "previous_kpa");
    require_shape(current_kpa, rows < 0 ? Shape{n} : Shape{rows, n}, "current_kpa");
    require_shape(previous, rows < 0 ? Shape{m, size} : Shape{rows, m, size}, "previous");
  }
  if (before) {
    require_shape(*before, rows < 0 ? Shape{m, size} : Shape{rows, m, size}, "before");
  }
}

/// Sizes and numbers of one query.
void require_query(const ForwardModel& model, const FloatArray& previous_kpa,
                   const FloatArray& current_kpa, const FloatArray& previous,
                   const Before& before) {
  require_query_shapes(model, -1, previous_kpa, current_kpa, previous, before);
  require_finite_query(previous_kpa, current_kpa, previous, before);
}

py::array_t<float> step(const ForwardModel& model, const FloatArray& previous_kpa,
                        const FloatArray& current_kpa, const FloatArray& previous,
                        const py::object& out, const Before& before) {
  require_query(model, previous_kpa, current_kpa, previous, before);
  const int size = pose_size(model.dimension());
  py::array_t<float> next = result_array(out, {model.point_count(), size});
  const FloatArray& earlier = before ? *before : previous;
  if (model.dimension() == Dimension::space) {
    model.step_batch(pressures_map(previous_kpa), pressures_map(current_kpa),
                     pressures_map(earlier), pressures_map(previous),
                     Eigen::Map<Eigen::VectorXf>(next.mutable_data(), next.size()), workspace());
    return next;
  }
  model.step(pressures_map(previous_kpa), pressures_map(current_kpa), backbone_map(earlier),
             backbone_map(previous),
             Eigen::Map<Backbone>(next.mutable_data(), model.point_count(), size), workspace());
  return next;
}

py::array_t<float> checked_step(const ForwardModel& model, const FloatArray& previous_kpa,
                                const FloatArray& current_kpa, const FloatArray& previous,
                                const Before& before) {
  require_query(model, previous_kpa, current_kpa, previous, before);
  const FloatArray& earlier = before ? *before : previous;
  const Pressures from = pressures_map(previous_kpa);
  const Pressures to = pressures_map(current_kpa);
  if (model.dimension() == Dimension::space) {
    return backbone_array<float>(checked_query(model, from, to,
                                               SpaceBackbone(space_backbone_map(earlier)),
                                               SpaceBackbone(space_backbone_map(previous))));
  }
  return backbone_array<float>(model.checked_step(from, to, Backbone(backbone_map(earlier)),
                                                  Backbone(backbone_map(previous))));
}

constexpr py::ssize_t kRowsAtOnce = 1 << 15;  // some 0.2 s of one core; signals wait no longer

/// The batch's results; `query` gets inputs and outputs as limber has them.
template <class Query>
py::array_t<float> batch(const ForwardModel& model, const FloatArray& previous_kpa,
                         const FloatArray& current_kpa, const FloatArray& previous,
                         const Before& before, const py::object& out, const Query& query) {
  const py::ssize_t rows = batch_size(previous_kpa, "previous_kpa");
  require_query_shapes(model, rows, previous_kpa, current_kpa, previous, before);
  py::array_t<float> next =
      result_array(out, {rows, model.point_count(), pose_size(model.dimension())});
  // Each row of a shape is read before it is written; commands are read for some rows at once.
  require_own_memory(next, previous, "previous", true);
  if (before) {
    require_own_memory(next, *before, "before", true);
  }
  require_own_memory(next, previous_kpa, "previous_kpa", false);
  require_own_memory(next, current_kpa, "current_kpa", false);
  const auto from = batch_map(previous_kpa);
  const auto to = batch_map(current_kpa);
  const auto now = batch_map(previous);
  const auto earlier = batch_map(before ? *before : previous);
  auto after = batch_map(next);
  const OthersMayRun others_may_run;
  require_finite_query(previous_kpa, current_kpa, previous, before);
  for (py::ssize_t row = 0; row < rows; row += kRowsAtOnce) {
    if (row > 0) {
      answer_signals();
    }
    const py::ssize_t count = std::min(kRowsAtOnce, rows - row);
    auto some = after.middleCols(row, count);
    query(from.middleCols(row, count), to.middleCols(row, count), earlier.middleCols(row, count),
          now.middleCols(row, count), some);
  }
  return next;
}

py::array_t<float> step_batch(const ForwardModel& model, const FloatArray& previous_kpa,
                              const FloatArray& current_kpa, const FloatArray& previous,
                              const py::object& out, const Before& before) {
  return batch(model, previous_kpa, current_kpa, previous, before, out,
               [&](const auto& from, const auto& to, const auto& earlier, const auto& now,
                   auto& after) { model.step_batch(from, to, earlier, now, after, workspace()); });
}

/// Processor time of this thread [s].
double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// What benchmarks/python_figures.py compares Python with: the same loop here. Processor seconds of
/// one pass over all queries, `size` at a time, or one by one with 0.
double pass_s(const ForwardModel& model, const FloatArray& previous_kpa,
              const FloatArray& current_kpa, const FloatArray& previous, py::array_t<float>& out,
              Eigen::Index size) {
  require_planar_model(model.dimension(), "_pass_s");
  require_query_shapes(model, previous_kpa.shape(0), previous_kpa, current_kpa, previous, {});
  require_shape(out, shape_of(previous), "out");
  const auto from = batch_map(previous_kpa);
  const auto to = batch_map(current_kpa);
  const auto before = batch_map(previous);
  auto after = batch_map(out);
  const Eigen::Index m = model.point_count();
  const double begin_s = processor_s();
  for (Eigen::Index k = 0; k < from.cols(); k += std::max<Eigen::Index>(1, size)) {
    if (size == 0) {
      model.step(from.col(k), to.col(k),
                 Eigen::Map<const Backbone>(before.col(k).data(), m, kPoseSize),
                 Eigen::Map<Backbone>(after.col(k).data(), m, kPoseSize), workspace());
    } else {
      const Eigen::Index n = std::min(size, from.cols() - k);
      model.step_batch(from.middleCols(k, n), to.middleCols(k, n), before.middleCols(k, n),
                       after.middleCols(k, n), workspace());
    }
  }
  return processor_s() - begin_s;
}

py::array_t<float> rollout(const ForwardModel& model, const FloatArray& pressures_kpa,
                           const FloatArray& first) {
  const py::ssize_t frames = batch_size(pressures_kpa, "pressures_kpa");
  require_shape(pressures_kpa, {frames, model.channel_count()}, "pressures_kpa");
  const py::ssize_t size = pose_size(model.dimension());
  require_shape(first, {model.point_count(), size}, "first");
  require_finite(first, "first");
  py::array_t<float> backbones({frames, py::ssize_t{model.point_count()}, size});
  if (frames == 0) {
    return backbones;
  }
  const auto pressures = batch_map(pressures_kpa);
  auto result = batch_map(backbones);
  std::copy_n(first.data(), first.size(), backbones.mutable_data());
  const OthersMayRun others_may_run;
  require_finite(pressures_kpa, "pressures_kpa");
  model.rollout(pressures, result, workspace());
  return backbones;
}

py::array_t<float> told_commands(const ForwardModel& model, const FloatArray& commands) {
  const py::ssize_t frames = batch_size(commands, "commands");
  require_shape(commands, {frames, model.channel_count()}, "commands");
  py::array_t<float> told({frames, py::ssize_t{model.command_size()}});
  batch_map(told) = model.told_commands(batch_map(commands));
  return told;
}

void bind_parallel_forward(py::module_& module) {
  Record<ParallelForward>(module, "ParallelForward",
                          "Large batches over several threads; the answers are the same for "
                          "any number. One caller at a time.")
      .property("jobs", &ParallelForward::jobs, "Number of threads.")
      .done()
      .def(py::init([](int jobs) {
             require_jobs(jobs);
             return ParallelForward(jobs);
           }),
           "jobs"_a = 0, "jobs: threads, 0: one per core; never changes a result.")
      .def(
          "step_batch",
          [](ParallelForward& parallel, const ForwardModel& model, const FloatArray& previous_kpa,
             const FloatArray& current_kpa, const FloatArray& previous, const py::object& out,
             const Before& before) {
            return batch(
                model, previous_kpa, current_kpa, previous, before, out,
                [&](const auto& from, const auto& to, const auto& earlier, const auto& now,
                    auto& after) { parallel.step_batch(model, from, to, earlier, now, after); });
          },
          "model"_a, "previous_kpa"_a, "current_kpa"_a, "previous"_a, "out"_a = py::none(),
          "before"_a = py::none(),
          "ForwardModel.step_batch, in parts of some hundred queries: float32 (k, n), (k, n) [kPa] "
          "and (k, m, 3) give (k, m, 3), in space 7 for 3. `before` as in ForwardModel.step.");
}

}  // namespace

void bind_forward_model(py::module_& module) {
  module.def("_pass_s", &pass_s);
  py::class_<ForwardModel>(
      module, "ForwardModel",
      "B_t = F(q_(t-1), q_t, B_(t-1)): the no-load model, or the no-load model compensated by a "
      "network. A pure function: any number of threads may share it.")
      .def(py::init([](const ArmDescription& arm, std::optional<CompensationModel> compensation) {
             const OthersMayRun others_may_run;
             return compensation ? ForwardModel(arm, *std::move(compensation)) : ForwardModel(arm);
           }),
           "arm"_a, "compensation"_a = py::none(),
           "compensation: a CompensationModel, None: the no-load model alone. Raises "
           "InputError where it was trained for another arm.")
      .def_property_readonly("segment_count", &ForwardModel::segment_count, "Segments of the arm.")
      .def_property_readonly("command_size", &ForwardModel::command_size,
                             "Numbers that tell one query's commands: n, or of networks that read "
                             "past commands what told_commands makes of them.")
      .def("told_commands", &told_commands, "commands"_a,
           "Commands (frames, channel_count) of frames one after the other as step and step_batch "
           "are told them, (frames, command_size): a network of an arm in space reads those of "
           "earlier frames too. Before the first frame they were what they are there.")
      .def_property_readonly("channel_count", &ForwardModel::channel_count,
                             "n: pressures of a query, one for each segment, in space for each "
                             "chamber.")
      .def_property_readonly(
          "dimension", [](const ForwardModel& model) { return position_size(model.dimension()); },
          "2: the arm moves in a plane, backbones are (m, 3); 3: in space, (m, 7).")
      .def_property_readonly("point_count", &ForwardModel::point_count,
                             "m: plates of the arm, base included.")
      .def_property_readonly("has_network", &ForwardModel::has_network, "Whether it has a network.")
      .def_property_readonly("reads_velocity", &ForwardModel::reads_velocity,
                             "Whether its network reads how the backbone changed in the frame "
                             "before, and so wants to be told `before`.")
      .def_property_readonly("no_load", &ForwardModel::no_load,
                             "The NoLoadModel that the network compensates.")
      .def_property_readonly(
          "compensation",
          [](const ForwardModel& model) {
            return model.has_network() ? std::optional(model.compensation()) : std::nullopt;
          },
          "A copy of the CompensationModel, or None: the no-load model alone.")
      .def("step", &step, "previous_kpa"_a, "current_kpa"_a, "previous"_a, "out"_a = py::none(),
           "before"_a = py::none(),
           "One query: pressures a frame ago and now, float32 (n,) and (n,) [kPa], and the "
           "backbone a frame ago (m, 3) give the backbone now (m, 3). It is written to "
           "`out` where one is given, which may be `previous`. `before` is the backbone two "
           "frames ago (m, 3), for models of which reads_velocity says so; None: the arm stood "
           "still. In space (m, 7) for (m, 3), here and below. Raises InputError for a wrong "
           "shape, NaN or infinity.")
      .def("checked_step", &checked_step, "previous_kpa"_a, "current_kpa"_a, "previous"_a,
           "before"_a = py::none(),
           "One query: float32 (n,), (n,) [kPa] and (m, 3) give (m, 3); pressures beyond their "
           "limits are refused too. `before` as in step.")
      .def("step_batch", &step_batch, "previous_kpa"_a, "current_kpa"_a, "previous"_a,
           "out"_a = py::none(), "before"_a = py::none(),
           "k queries: float32 (k, n), (k, n) [kPa] and (k, m, 3) give (k, m, 3), each row to the "
           "bit what step gives. `out` may be `previous` or `before`, (k, m, 3) as in step.")
      .def("rollout", &rollout, "pressures_kpa"_a, "first"_a,
           "Feeds its own output back: pressures float32 (T, n) [kPa] from backbone `first` "
           "(m, 3), where the arm stood still, give (T, m, 3), row 0 being `first`.")
      .def("__repr__", [](const ForwardModel& model) {
        return fmt::format("ForwardModel(segments={}, points={}, network={})",
                           model.segment_count(), model.point_count(),
                           model.has_network() ? model.compensation().shape() : "None");
      });
  bind_parallel_forward(module);
}

}  // namespace limber::python
