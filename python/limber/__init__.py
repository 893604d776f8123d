"""limber: learn, simulate and plan the motion of soft pneumatic arms.

Where to start: lines that plan a motion past a pillar.

    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(
        limber.data_folder() / "environments" / "01_pillar.yaml", arm)
    no_load = limber.MotionModel(limber.ForwardModel(arm))  # or "model.safetensors"
    print(limber.plan(arm, no_load, environment, limber.PlannerLimits(time_s=5)))

docs/tutorial_python.md goes from a folder of logs to a verified plan; docs/python.md has the rest.

Frame    Coordinates are in frame B: its origin is the arm's base, x runs along the straight arm,
         y to its left. theta_rad is counter-clockwise from x and unwrapped.
Signs    A positive pressure inflates a segment's right side, which it bends to (towards -y), a
         negative one its left side. Pressures are gauge. Commands other than pressures have the
         sign that the arm's file gives them.
Units    Metres, radians, kPa and seconds, as the names say: x_m, theta_rad, pressure_kpa, time_s.
         Of an arm with another command than a pressure, kpa stands for the unit of that command.
Counts   Segments, plates, gaps, obstacles, frames and episodes are counted from 0. Segment 0 and
         plate 0 are at the base, gap i is between plates i and i + 1, frame 0 is the start.
Arrays   NumPy's: a C-contiguous float32 array is not copied, anything else is copied once.
         n: segments, m: plates, k: queries of a batch, T: frames. Pressures are (n,), (k, n) or
         (T, n); a backbone is (m, 3), with a row x_m, y_m, theta_rad for each plate.
Space    Of an arm in space (arm.dimension is 3) n counts chambers, and a backbone is (m, 7): x_m,
         y_m, z_m and a unit quaternion qx, qy, qz, qw; z is up where the arm lies. It is recorded,
         trained, evaluated, asked and exported; what can't use it yet raises InputError and says so.
Errors   InputError (a ValueError) is a mistake in an argument or file, SystemFault a failure of
         the machine or a driver, Interrupted work that was stopped. No plan is no error: see
         PlanResult.status and PlanResult.reason.
"""

from __future__ import annotations

import os
import pathlib
import sys

try:
    from ._limber import *  # noqa: F401,F403
    from ._limber import SystemFault, __version__
except ImportError as _error:
    raise ImportError(f"limber can't be imported by {sys.executable}: {_error.__cause__ or _error}. "
                      "It wants the Python that it was built with, Debian's /usr/bin/python3, and "
                      "its NumPy (docs/python.md, To get it)") from _error
from . import _pickles  # noqa: F401
from .arm_driver import ArmDriver
from .controller import Controller

__all__ = [
    "Adaptation", "Approach", "ArmCommand", "ArmDescription", "ArmDriver", "ArmEstimate", "ArmStart", "ArmState",
    "BackboneLayout", "BenchPoint", "Certificate", "CertificateFailure", "CertifiedFigures", "Certifier",
    "Chamber", "CharacterisedArm", "Circle", "Clearance", "ClosedLoop", "CollectionResult", "CollectionSettings",
    "CollisionChecker", "Command", "CompensationModel", "Contact", "Controller", "DriverFactory", "EnsembleForward", "Environment",
    "Episode", "EpisodeErrors", "ErrorRoom", "ErrorStatistics", "Evaluation", "ExecutedError",
    "ExecutionResult", "ExecutionSettings", "ExecutionStatus", "FirstSolution", "FirstWeights", "ForwardModel",
    "GapBounds", "IdentifiedValves", "ImportResult", "InputError", "Interrupted",
    "InverseKinematicsResult", "InverseKinematicsSettings", "Layer", "LearningCurvePoint",
    "LearntRegion", "LongRollout", "LossReduction", "MotionModel", "MotionState", "NoLoadKind",
    "NoLoadModel", "NovelFrames", "NovelFramesCount", "Optimiser", "OutputForm", "ParallelForward",
    "Plan", "PlanLimit",
    "PlanResult", "PlanStatus", "PlanTube", "Planner", "PlannerLimits", "PlannerProgress",
    "PlannerStatistics", "PlanningProblem", "Polygon", "Pose", "PoseError", "PoseGoal",
    "PredictionError", "PressureLoss", "ProcessDriver", "ProgressMode", "RandomStream", "RecordedRegion",
    "Recording", "Rectangle", "Restart", "RolloutErrors", "Scaling", "ScheduleKind", "ScheduleSettings",
    "Segment", "SegmentPressure", "SegmentShape", "SegmentValves", "SimpleFit",
    "SpaceFit", "SpreadRollout", "StrainFit", "SystemFault", "TipErrors", "TrainingData", "TrainingResult", "TrainingSettings",
    "TrainingStage", "TrainingStatus", "TraitEstimate", "ValveDirection", "ValveErrors",
    "ValveFindings", "ValveModel", "ValveParameters", "VirtualArm", "VirtualArmOptions",
    "adapt", "arm_differences", "arm_svg", "arm_to_yaml", "bench_test_all", "best_preset",
    "certify", "characterise", "collect", "command_shares", "commands_for", "content_hash",
    "data_folder",
    "environment_hash", "environment_picture", "environment_to_yaml", "episode_errors",
    "error_room", "evaluate", "execute", "execution_animation", "execution_picture", "export_csv",
    "fine_tune", "fine_tuning_of", "fit_simple_model", "fit_space_model", "fitted_arm",
    "gap_bounds_of", "hold_back_arms",
    "hold_back_unseen", "hold_back_validation", "identify_valves", "import_csv", "import_motive",
    "inspect", "is_family", "is_within", "learning_curve_svg", "learnt_region_of", "load_arm",
    "load_arm_to_characterise", "load_environment", "make_planner", "make_recording",
    "model_of_followed_arm",
    "note_unseen", "paper_preset", "plan", "plan_along", "plan_animation", "plan_picture",
    "planner_names", "pose_error", "predict", "pressure_picture", "problem_with_room",
    "read_bench_csv", "read_model", "read_plan", "read_plan_unchecked", "read_recording",
    "read_valves", "require_model_of", "require_plan_of", "require_recording_of",
    "rest_positions_m", "segment_commands", "set_epoch_count", "set_family_size", "set_window_frames",
    "solve_inverse_kinematics",
    "start_state", "tip_pose", "to_json", "train", "training_preset", "virtual_arm_factory",
    "virtual_collection", "with_setpoints_only", "with_space_fit", "write_arm", "write_backbones_csv",
    "write_environment", "write_model", "write_plan", "write_recording", "write_setpoints_csv",
    "write_valves",
]


def data_folder() -> pathlib.Path:
    """Where the arms and environments lie that limber comes with.

    LIMBER_DATA_DIR where that is set; the package's own, the source tree's, or the installed ones.
    """
    chosen = os.environ.get("LIMBER_DATA_DIR")
    here = pathlib.Path(__file__).resolve().parent
    candidates = [here / "data", *(parent / "share" / "limber" for parent in here.parents),
                  *list(here.parents)[:4]]
    if chosen:
        candidates = [pathlib.Path(chosen)]
    for candidate in candidates:
        if (candidate / "arms").is_dir() and (candidate / "environments").is_dir():
            return candidate
    raise SystemFault("limber's arms/ and environments/ were not found in: "
                      + " ".join(map(str, candidates)) + "; set LIMBER_DATA_DIR")
