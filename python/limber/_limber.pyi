# Made by tools/python_stubs.py from the module's docstrings; do not edit.
import os
from typing import Any, Callable, Iterable, Iterator, Sequence, overload

import numpy as np
import numpy.typing as npt

from .arm_driver import ArmDriver

__version__: str

class Approach:
    """How set points go to the next configuration."""
    step: Approach
    straight: Approach
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class ArmDescription:
    """A planar arm as its file describes it. Models borrow it, so it does not change: load_arm reads one."""
    @property
    def name(self) -> str:
        """The arm's name."""
    @property
    def command(self) -> Command:
        """What its segments are told."""
    @property
    def no_load(self) -> NoLoadKind:
        """What the no-load model makes of it."""
    @property
    def segment_count(self) -> int:
        """n."""
    @property
    def point_count(self) -> int:
        """m: plates along the backbone, base included."""
    @property
    def length_m(self) -> float:
        """All segments [m]."""
    @property
    def frame_rate_hz(self) -> float:
        """Of recordings, models and plans [Hz]."""
    @property
    def pressure_rate_limit_kpa_per_s(self) -> float:
        """Bounds a plan's frames [kPa/s]."""
    @property
    def actuator_radius_m(self) -> float:
        """A gap's collision radius is width/2 + this [m]."""
    @property
    def segments(self) -> list[Segment]:
        """Base first."""
    @property
    def frame_period_s(self) -> float:
        """1/rate [s]."""
    @property
    def pressure_step_limit_kpa(self) -> float:
        """Largest change of a set point within one frame [kPa]."""
    @property
    def pressure_limits_kpa(self) -> npt.NDArray[np.float32]:
        """Largest pressure of each segment, of either side, float32 (n,) [kPa]."""
    @property
    def pressure_ranges_kpa(self) -> npt.NDArray[np.float32]:
        """Lower and upper limit of each segment, float32 (n, 2) [kPa]."""
    def frames_in(self, seconds: float) -> int:
        """Fewest frames that take at least so long."""
    def segment_of_gap(self, gap: int) -> int:
        """Segment that the gap between plates gap and gap + 1 belongs to."""
    def hash(self) -> str:
        """Of everything that the no-load model and planning depend on."""
    def _repr_svg_(self) -> str: ...

class ArmStart:
    """State of the arm that a motion starts from."""
    @property
    def pressures_kpa(self) -> npt.NDArray[np.float32]:
        """float32 (n,) [kPa]."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """float32 (m, 3)."""
    def __init__(self, pressures_kpa: npt.ArrayLike, backbone: npt.ArrayLike) -> None:
        """(n,) [kPa] and (m, 3)."""

class ArmState:
    """What is known of the arm at one frame."""
    @property
    def time_s(self) -> float:
        """[s]"""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Measured, float32 (n,) [kPa]."""
    @property
    def backbone(self) -> npt.NDArray[np.float32] | None:
        """float32 (m, 3), or None."""
    def __init__(self, time_s: float, pressure_kpa: npt.ArrayLike, backbone: Any | None = None) -> None:
        """[s], (n,) [kPa], and (m, 3) or None where nothing tracks it."""

class BackboneLayout:
    """How backbones enter the network."""
    base_poses: BackboneLayout
    gap_poses: BackboneLayout
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class BenchPoint:
    """One settled reading of a bench test."""
    @property
    def pressure_kpa(self) -> float:
        """Of the inflated side, gauge [kPa]."""
    @pressure_kpa.setter
    def pressure_kpa(self, value: float) -> None: ...
    @property
    def strain(self) -> float:
        """Change of length over l0, negative: contracted."""
    @strain.setter
    def strain(self, value: float) -> None: ...
    def __init__(self, *, pressure_kpa: float = ..., strain: float = ...) -> None: ...

class Certificate:
    """What an independent second look at a plan found."""
    @property
    def certified(self) -> bool:
        """Whether nothing is wrong."""
    @property
    def failures(self) -> list[CertificateFailure]:
        """Empty: certified."""
    @property
    def clearance_m(self) -> float:
        """Of the moving arm, from below [m]."""
    @property
    def max_deviation_m(self) -> float:
        """Of a plate, own simulation against the plan [m]."""
    @property
    def cost_kpa(self) -> float:
        """Sum of |dp| [kPa]."""
    @property
    def goal_distance_m(self) -> float:
        """Of the last tip [m]."""
    @property
    def goal_orientation_rad(self) -> float:
        """The same [rad]."""
    @property
    def frames(self) -> int:
        """Of the plan."""
    @property
    def clearance_frame(self) -> int:
        """Where it is smallest."""
    @property
    def clearance_gap(self) -> int:
        """Between plates gap, gap + 1."""
    @property
    def clearance_obstacle(self) -> int:
        """Index in the list."""
    @property
    def max_step_kpa(self) -> float:
        """Of a pressure in a frame [kPa]."""
    @property
    def max_pressure_deviation_kpa(self) -> float:
        """Of a predicted pressure [kPa]."""
    @property
    def unfinished(self) -> bool:
        """Given up before the end."""

class CertificateFailure:
    """One thing that is wrong with a plan."""
    @property
    def check(self) -> str:
        """"limits", "collision", "goal", ..."""
    @property
    def frame(self) -> int:
        """The first that fails; -1: none to blame."""
    @property
    def message(self) -> str:
        """A sentence with numbers."""

class CertifiedFigures:
    """What its certificate said of a plan."""
    @property
    def clearance_m(self) -> float:
        """[m]; inf without obstacles."""
    @property
    def max_deviation_m(self) -> float:
        """Of a plate [m]."""
    @property
    def seal_is_intact(self) -> bool:
        """False where the file was changed since."""

class Certifier:
    """Certifies plans for one problem with nothing of the planner's. Constant: share it freely."""
    @property
    def environment_hash(self) -> str:
        """What plans have to state."""
    def __init__(self, arm: ArmDescription, network: CompensationModel | None, valves: ValveParameters, environment: Environment) -> None:
        """Without network (None): the no-load model."""
    def certify(self, plan: Plan) -> Certificate:
        """Raises InputError where the plan was made for something else; all else is a failure in the result."""

class CharacterisedArm:
    """An arm with fitted polynomials."""
    @property
    def arm(self) -> ArmDescription:
        """The arm."""
    @property
    def fits(self) -> list[StrainFit]:
        """One a segment."""

class Circle:
    """An obstacle."""
    @property
    def x_m(self) -> float:
        """Centre [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """Centre [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def radius_m(self) -> float:
        """[m], > 0."""
    @radius_m.setter
    def radius_m(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., radius_m: float = ...) -> None: ...

class Clearance:
    """Smallest distance between the arm and an obstacle."""
    @property
    def value_m(self) -> float:
        """[m]; negative: how deep; inf: no obstacles."""
    @property
    def gap(self) -> int:
        """Between plates gap and gap + 1; -1: none."""
    @property
    def obstacle(self) -> int:
        """Index in the environment's list; -1: none."""

class CollectionResult:
    """What was recorded."""
    @property
    def recording(self) -> Recording:
        """The recording, as in the file."""
    @property
    def kept_episodes(self) -> int:
        """Found by `resume`."""
    @property
    def wall_time_s(self) -> float:
        """Of this run [s]."""

class CollectionSettings:
    """How an arm is recorded."""
    @property
    def schedule(self) -> ScheduleSettings:
        """ScheduleSettings."""
    @schedule.setter
    def schedule(self, value: ScheduleSettings) -> None: ...
    @property
    def seed(self) -> int:
        """Of the schedule."""
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def source(self) -> str:
        """What moves, in words."""
    @source.setter
    def source(self, value: str) -> None: ...
    @property
    def driver(self) -> str:
        """Everything else that decides the data."""
    @driver.setter
    def driver(self, value: str) -> None: ...
    @property
    def hold_limit_s(self) -> float:
        """A set point not reached by then is a fault [s]."""
    @hold_limit_s.setter
    def hold_limit_s(self, value: float) -> None: ...
    @property
    def jobs(self) -> int:
        """Threads, 0: one per core."""
    @jobs.setter
    def jobs(self, value: int) -> None: ...
    @property
    def resume(self) -> bool:
        """Go on from an interrupted run."""
    @resume.setter
    def resume(self, value: bool) -> None: ...
    @property
    def force(self) -> bool:
        """Replace the file."""
    @force.setter
    def force(self, value: bool) -> None: ...
    @property
    def progress(self) -> ProgressMode:
        """ProgressMode."""
    @progress.setter
    def progress(self, value: ProgressMode) -> None: ...
    def __init__(self, *, schedule: ScheduleSettings = ..., seed: int = ..., source: str = ..., driver: str = ..., hold_limit_s: float = ..., jobs: int = ..., resume: bool = ..., force: bool = ..., progress: ProgressMode = ...) -> None: ...

class CollisionChecker:
    """Collision of a thick backbone with obstacles. Constant: share it."""
    @property
    def obstacle_count(self) -> int:
        """Obstacles."""
    @property
    def gap_count(self) -> int:
        """m - 1."""
    def __init__(self, arm: ArmDescription, environment: Environment, margin_m: float = 0.0) -> None:
        """The margin is added to the arm's radius everywhere [m]."""
    def clearance(self, backbone: npt.ArrayLike) -> Clearance:
        """Of one backbone, float32 (m, 3), less the margin."""
    def is_free(self, backbone: npt.ArrayLike) -> bool:
        """Whether nothing touches the arm: of one backbone, float32 (m, 3)."""
    def is_motion_free(self, from_backbone: npt.ArrayLike, to_backbone: npt.ArrayLike) -> bool:
        """Whether the arm stays free while every plate moves straight from one backbone, float32 (m, 3), to the other."""

class Command:
    """What a segment is told. Of another command than a pressure, names that end in _kpa hold numbers in this unit."""
    @property
    def name(self) -> str:
        """"pressure", or what else."""
    @property
    def unit(self) -> str:
        """"kPa", or what else."""

class CompensationModel:
    """The network with everything needed to use it."""
    @property
    def layers(self) -> list[Layer]:
        """Of the leading network; no copies."""
    @property
    def member_count(self) -> int:
        """Networks of the ensemble, 1 where it is none."""
    @property
    def answer(self) -> str:
        """Of an ensemble: "first", its first network's, or "mean" of all. No part of the file."""
    @answer.setter
    def answer(self, value: str) -> None: ...
    @property
    def shape(self) -> str:
        """"102-100-100-100-48"."""
    @property
    def arm_name(self) -> str:
        """Of the arm it was trained for."""
    @property
    def arm_hash(self) -> str:
        """ArmDescription.hash() of it."""
    @property
    def preset(self) -> str:
        """"paper" or "best"."""
    @property
    def training(self) -> dict[str, str]:
        """Record of the training, a dict of texts; assign a whole one."""
    @training.setter
    def training(self, value: dict[str, str]) -> None: ...
    @property
    def learnt_from_setpoints(self) -> bool:
        """It knows the valves along with the arm, and none belong before it."""
    @property
    def valves(self) -> ValveParameters | None:
        """Between set points and pressures of the recordings, or None."""
    @valves.setter
    def valves(self, value: ValveParameters | None) -> None: ...
    @property
    def valve_findings(self) -> ValveFindings:
        """How they were found."""
    @property
    def prediction_error(self) -> PredictionError | None:
        """On motions it has not seen, or None."""
    @property
    def learnt(self) -> LearntRegion | None:
        """What the recordings held, or None: see learnt_region_of."""
    @learnt.setter
    def learnt(self, value: LearntRegion | None) -> None: ...
    @property
    def bounds(self) -> GapBounds | None:
        """What predictions stay within, or None: see gap_bounds_of."""
    @bounds.setter
    def bounds(self, value: GapBounds | None) -> None: ...
    def set_valves(self, identified: IdentifiedValves) -> None:
        """Stores valves and how they were found."""

class Contact:
    """The arm near or in an obstacle at one moment."""
    @property
    def time_s(self) -> float:
        """[s]"""
    @property
    def clearance(self) -> Clearance:
        """Clearance."""

class DriverFactory:
    """Makes a virtual arm for each episode."""

class Environment:
    """What a plan is made for: obstacles, start and goal, in frame B. Plans borrow it, so it does not change."""
    @property
    def name(self) -> str:
        """Of the file."""
    @property
    def obstacles(self) -> list[Circle | Rectangle | Polygon]:
        """Circle, Rectangle, Polygon; copies."""
    @property
    def goal(self) -> PoseGoal:
        """A copy."""
    @property
    def start(self) -> ArmStart | None:
        """ArmStart, or None: at rest."""
    def __init__(self, name: str, obstacles: Sequence[Circle | Rectangle | Polygon], goal: PoseGoal, start: ArmStart | None = None) -> None:
        """Checked as a file is. Without start: at rest."""
    def _repr_svg_(self) -> str: ...

class Episode:
    """One unbroken run of the arm: T frames, n segments, m plates. Its arrays are views of limber's own memory."""
    @property
    def time_s(self) -> npt.NDArray[np.float64]:
        """float64 (T,) [s]."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Measured, float32 (T, n) [kPa]; the set points, where nothing was measured."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """Commanded, float32 (T, n) [kPa]."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """Poses x_m, y_m, theta_rad of the plates, float32 (T, m, 3)."""
    @property
    def motion_index(self) -> npt.NDArray[np.int32]:
        """Number of the commanded motion that a frame belongs to, int32 (T,)."""
    @property
    def tracked(self) -> npt.NDArray[np.bool_]:
        """Whether the backbone was seen, bool (T,); a copy."""
    @property
    def setpoints_only(self) -> bool:
        """Nothing was measured: pressure_kpa holds the set points."""
    @property
    def frame_count(self) -> int:
        """T."""
    @property
    def untracked_count(self) -> int:
        """Frames without a measured backbone."""
    def __init__(self, time_s: npt.ArrayLike, pressure_kpa: npt.ArrayLike, setpoint_kpa: npt.ArrayLike, backbone: npt.ArrayLike, motion_index: npt.ArrayLike, tracked: npt.ArrayLike | None = None, setpoints_only: bool = False) -> None:
        """Copies its arrays once: (T,), (T, n), (T, n), (T, m, 3), (T,), and (T,) or None. With setpoints_only, pressure_kpa has to be setpoint_kpa."""
    def __len__(self) -> int: ...

class EpisodeErrors:
    """The simple model's error in every episode."""
    @property
    def outliers(self) -> list[int]:
        """Numbers of broken episodes, rising."""
    @property
    def median_cm(self) -> float:
        """At the tip [cm]."""
    @property
    def limit_cm(self) -> float:
        """Above it an episode is an outlier [cm]."""
    @property
    def tip_cm(self) -> list[float]:
        """Mean error of each episode [cm]; NaN where nothing was tracked."""
    def __str__(self) -> str: ...

class ErrorRoom:
    """What plans keep in hand for the model's error."""
    @property
    def margin_m(self) -> float:
        """Clearance from obstacles [m]; of a tube its largest radius."""
    @property
    def goal_margin(self) -> PoseError:
        """Way to the goal's rim."""
    @property
    def tube(self) -> PlanTube | None:
        """PlanTube of a calibrated model, or None."""
    @property
    def margin_yields_to_start(self) -> bool:
        """Whether nobody has asked for this very amount."""
    @property
    def note(self) -> str:
        """Why the amounts are no measured ones."""

class ErrorStatistics:
    """Over frames."""
    @property
    def mean(self) -> float:
        """Mean."""
    @property
    def std(self) -> float:
        """Standard deviation."""
    @property
    def p95(self) -> float:
        """95th percentile."""
    @property
    def worst_motion(self) -> float:
        """Largest mean over one motion."""

class Evaluation:
    """Errors of models on one recording."""
    @property
    def frames(self) -> int:
        """That count."""
    @property
    def no_load_open_loop(self) -> TipErrors:
        """Of the simple model."""
    @property
    def network(self) -> RolloutErrors | None:
        """RolloutErrors, or None."""
    @property
    def position_reduction_percent(self) -> float:
        """Open loop, network against no load [%]."""
    @property
    def orientation_reduction_percent(self) -> float:
        """The same of headings [%]."""
    @property
    def novel(self) -> NovelFrames | None:
        """NovelFrames of the network, or None where it does not know what it learnt from."""
    def __str__(self) -> str: ...
    def _repr_svg_(self) -> str: ...

class ExecutedError:
    """Between predicted and executed tip."""
    @property
    def mean_m(self) -> float:
        """[m]"""
    @property
    def before_hold_m(self) -> float:
        """Mean while it moves [m]."""
    @property
    def max_m(self) -> float:
        """[m]"""
    @property
    def final_m(self) -> float:
        """At the plan's last frame [m]."""

class ExecutionResult:
    """What came of executing a plan."""
    @property
    def status(self) -> ExecutionStatus:
        """ExecutionStatus."""
    @property
    def message(self) -> str:
        """Of a fault; else empty."""
    @property
    def frames(self) -> int:
        """Set points commanded."""
    @property
    def goal_reached(self) -> bool:
        """After the hold."""
    @property
    def goal_error(self) -> PoseError:
        """PoseError after the hold."""
    @property
    def collided(self) -> bool:
        """Whether it touched an obstacle."""
    @property
    def prediction(self) -> ExecutedError | None:
        """ExecutedError, or None."""
    @property
    def replans(self) -> int:
        """Plans after the first."""
    @property
    def halts(self) -> int:
        """Plans that were left before their end."""
    @property
    def open_loop_goal_error(self) -> PoseError | None:
        """PoseError where the first plan's hold ended, if more followed; or None."""
    @property
    def start_error_m(self) -> float:
        """Of a plate, before the first set point [m]."""
    @property
    def first_collision(self) -> Contact | None:
        """Contact, or None."""
    @property
    def closest(self) -> Contact | None:
        """Contact, or None."""
    @property
    def final_backbone(self) -> npt.NDArray[np.float32] | None:
        """float32 (m, 3) after the hold, or None."""
    @property
    def episode(self) -> Episode:
        """What was commanded and measured."""
    def _repr_svg_(self) -> str | None: ...

class ExecutionSettings:
    """How a plan is executed."""
    @property
    def hold_s(self) -> float:
        """The last set point is held this long, the plan's hold counted [s]."""
    @hold_s.setter
    def hold_s(self, value: float) -> None: ...
    def __init__(self, *, hold_s: float = ...) -> None: ...

class ExecutionStatus:
    """How an execution ended."""
    done: ExecutionStatus
    fault: ExecutionStatus
    stopped: ExecutionStatus
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class FirstSolution:
    """The first plan that was certified."""
    @property
    def time_s(self) -> float:
        """[s]"""
    @property
    def cost_kpa(self) -> float:
        """[kPa]"""
    @property
    def queries(self) -> int:
        """Until it was found."""
    @property
    def candidate_s(self) -> float:
        """When it was found [s]."""
    @property
    def certificate_s(self) -> float:
        """What building and certifying it then took [s]."""

class ForwardModel:
    """B_t = F(q_(t-1), q_t, B_(t-1)): the no-load model, or the no-load model compensated by a network. A pure function: any number of threads may share it."""
    @property
    def segment_count(self) -> int:
        """n."""
    @property
    def point_count(self) -> int:
        """m."""
    @property
    def has_network(self) -> bool:
        """Whether there is one."""
    @property
    def no_load(self) -> NoLoadModel:
        """The simple model within."""
    @property
    def compensation(self) -> CompensationModel:
        """The network, or None."""
    def __init__(self, arm: ArmDescription, compensation: CompensationModel | None = None) -> None:
        """Without a network the no-load model alone."""
    def step(self, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None) -> npt.NDArray[np.float32]:
        """One query: float32 (n,), (n,) [kPa] and (m, 3) give (m, 3). `out` may be `previous`."""
    def checked_step(self, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike) -> npt.NDArray[np.float32]:
        """One query: float32 (n,), (n,) [kPa] and (m, 3) give (m, 3); pressures beyond their limits are refused too."""
    def step_batch(self, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None) -> npt.NDArray[np.float32]:
        """k queries: float32 (k, n), (k, n) [kPa] and (k, m, 3) give (k, m, 3), each row to the bit what step gives. `out` may be `previous`."""
    def rollout(self, pressures_kpa: npt.ArrayLike, first: npt.ArrayLike) -> npt.NDArray[np.float32]:
        """Feeds its own output back: pressures float32 (T, n) [kPa] from backbone `first` (m, 3) give (T, m, 3), row 0 being `first`."""

class GapBounds:
    """What predictions keep every gap's shape within: float32 (gaps,) each."""
    @property
    def min_length_m(self) -> npt.NDArray[np.float32]:
        """[m]."""
    @property
    def max_length_m(self) -> npt.NDArray[np.float32]:
        """[m]."""
    @property
    def min_turn_rad(self) -> npt.NDArray[np.float32]:
        """[rad]."""
    @property
    def max_turn_rad(self) -> npt.NDArray[np.float32]:
        """[rad]."""

class IdentifiedValves:
    """Valves and how they were found."""
    @property
    def parameters(self) -> ValveParameters:
        """Ideal where there is a reason."""
    @parameters.setter
    def parameters(self, value: ValveParameters) -> None: ...
    @property
    def findings(self) -> ValveFindings:
        """How well they fit."""
    @findings.setter
    def findings(self, value: ValveFindings) -> None: ...
    def __init__(self, *, parameters: ValveParameters = ..., findings: ValveFindings = ...) -> None: ...

class ImportResult:
    """A recording, and what was done to its logs."""
    @property
    def recording(self) -> Recording:
        """The recording."""
    @property
    def report(self) -> str:
        """Everything that was dropped or changed, in sentences."""

class InputError(ValueError):
    """A mistake of the caller or of a file: what was found, where, and what is allowed."""

class Interrupted(RuntimeError):
    """Work stopped because it was asked to; what was written is valid."""

class InverseKinematicsResult:
    """What was found; none is no error."""
    @property
    def pressures_kpa(self) -> npt.NDArray[np.float64]:
        """Solutions, float64 (k, n) [kPa], in the order found."""
    @property
    def best_pressures_kpa(self) -> npt.NDArray[np.float64]:
        """The nearest configuration of all starts, float64 (n,) [kPa]."""
    @property
    def best_error(self) -> PoseError:
        """Its errors."""
    @property
    def starts_used(self) -> int:
        """Starts that were tried."""
    @property
    def reason(self) -> str:
        """Why there is no solution; empty where there is one."""
    @property
    def reachable(self) -> bool:
        """Whether there is a solution."""

class InverseKinematicsSettings:
    """How long solutions are looked for."""
    @property
    def starts(self) -> int:
        """Random configurations to start from, >= 1."""
    @starts.setter
    def starts(self, value: int) -> None: ...
    @property
    def max_solutions(self) -> int:
        """Stops at so many, >= 1."""
    @max_solutions.setter
    def max_solutions(self, value: int) -> None: ...
    @property
    def iterations(self) -> int:
        """Newton steps a start, >= 1."""
    @iterations.setter
    def iterations(self, value: int) -> None: ...
    @property
    def convergence_m(self) -> float:
        """A start is done at this residual [m]."""
    @convergence_m.setter
    def convergence_m(self, value: float) -> None: ...
    @property
    def distinct_pressure_kpa(self) -> float:
        """Solutions differ by more than this in some segment [kPa]."""
    @distinct_pressure_kpa.setter
    def distinct_pressure_kpa(self, value: float) -> None: ...
    def __init__(self, *, starts: int = ..., max_solutions: int = ..., iterations: int = ..., convergence_m: float = ..., distinct_pressure_kpa: float = ...) -> None: ...

class Layer:
    """One layer, y = W x + b, with ReLU behind every layer but the last."""
    @property
    def weight(self) -> npt.NDArray[np.float32]:
        """float32 (out, in), a view."""
    @property
    def bias(self) -> npt.NDArray[np.float32]:
        """float32 (out,), a view."""

class LearningCurvePoint:
    """One row of the learning curve."""
    @property
    def epoch(self) -> int:
        """From 1."""
    @property
    def window_frames(self) -> int:
        """Of its stage."""
    @property
    def learning_rate(self) -> float:
        """Of its first batch."""
    @property
    def loss(self) -> float:
        """Mean frame error, normalised units."""
    @property
    def validation_position_error_cm(self) -> float:
        """Of the tip [cm]; NaN where not measured."""
    @property
    def elapsed_s(self) -> float:
        """[s]"""

class LearntRegion:
    """What the training recordings held: ranges of pressures, rates, shapes."""

class LongRollout:
    """How far a model drifts if it is never corrected."""
    @property
    def frames(self) -> int:
        """Rolled out."""
    @property
    def max_distance_m(self) -> float:
        """Of a plate from the base [m]."""
    @property
    def max_heading_rad(self) -> float:
        """Of a plate [rad]."""
    @property
    def bounded(self) -> bool:
        """No plate beyond twice the arm's length."""
    @property
    def held_share(self) -> float:
        """Of the frames, at a bound."""
    @property
    def ran_away(self) -> bool:
        """Unbounded, or leaning on its bounds."""

class LossReduction:
    """How windows' errors become one number."""
    sum_over_batch: LossReduction
    mean_over_batch: LossReduction
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class MotionModel:
    """Set points to backbones, frame by frame: valves, and behind them the forward model. Constant: share it freely."""
    @property
    def forward(self) -> ForwardModel:
        """The forward model."""
    @property
    def valves(self) -> ValveModel:
        """The valves."""
    @property
    def segment_count(self) -> int:
        """n."""
    @property
    def point_count(self) -> int:
        """m."""
    @property
    def has_network(self) -> bool:
        """Whether there is one."""
    def __init__(self, forward: ForwardModel, valves: ValveModel | None = None) -> None:
        """Without valves pressures are the set points."""
    def settled_state(self, kpa: npt.ArrayLike, backbone: npt.ArrayLike) -> MotionState:
        """Of an arm that has long stood at (n,) [kPa] with backbone (m, 3)."""
    def step(self, setpoint_kpa: npt.ArrayLike, state: MotionState) -> None:
        """One frame at set points float32 (n,) [kPa]: `state` becomes what follows it."""

class MotionState:
    """Everything that decides an arm's future under set points."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """float32 (n,) [kPa], a copy."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """The last ones, float32 (n,) [kPa], a copy."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """float32 (m, 3), a copy."""
    def copy(self) -> MotionState:
        """Another one like this."""
    def __eq__(self, other: object) -> bool: ...

class NoLoadKind:
    """What the no-load model takes a command for."""
    strain_polynomial: NoLoadKind
    curvature: NoLoadKind
    straight: NoLoadKind
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class NoLoadModel:
    """Shape of the unloaded, frictionless arm at given pressures. Constant: any number of threads may share it."""
    @property
    def segment_count(self) -> int:
        """n."""
    @property
    def point_count(self) -> int:
        """m."""
    def __init__(self, arm: ArmDescription) -> None: ...
    def backbone(self, pressures_kpa: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None) -> npt.NDArray[np.float32]:
        """Backbone at pressures [kPa]: float32 (n,) gives (m, 3), rows x_m, y_m, theta_rad from base to tip; (k, n) gives (k, m, 3). Written to `out` where one is given."""
    def segment_shape(self, segment: int, pressure_kpa: float) -> SegmentShape:
        """Equations (3) and (4) of one segment."""
    def pressure_for_curvature(self, segment: int, curvature_per_m: float) -> SegmentPressure:
        """Their inverse, (11)."""
    def curvature_limit_per_m(self, segment: int) -> float:
        """Largest curvature that the pressure limit allows [1/m]."""

class NovelFrames:
    """Tracked frames, and how many of them lie beyond what a model learnt from, by whether their pressures do."""
    @property
    def pressures_within(self) -> NovelFramesCount:
        """Pressures within the recorded ranges."""
    @property
    def pressures_beyond(self) -> NovelFramesCount:
        """Pressures beyond them."""

class NovelFramesCount:
    """Of the frames of NovelFrames."""
    @property
    def frames(self) -> int:
        """All."""
    @property
    def novel(self) -> int:
        """Beyond what the model learnt from."""

class Optimiser:
    """How weights are changed."""
    sgd: Optimiser
    adam: Optimiser
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class OutputForm:
    """What the network's outputs mean."""
    compensation: OutputForm
    gated_change: OutputForm
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class ParallelForward:
    """Large batches over several threads; the answers are the same for any number. One caller at a time."""
    @property
    def jobs(self) -> int:
        """Threads."""
    def __init__(self, jobs: int = 0) -> None:
        """0: one per core."""
    def step_batch(self, model: ForwardModel, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None) -> npt.NDArray[np.float32]:
        """ForwardModel.step_batch, in parts of some hundred queries: float32 (k, n), (k, n) [kPa] and (k, m, 3) give (k, m, 3)."""

class Plan:
    """A motion in pressure space. Its frames are executed as they stand, never resampled."""
    @property
    def arm_name(self) -> str:
        """Of the arm."""
    @property
    def model(self) -> str:
        """"no_load" or "network"."""
    @property
    def environment_name(self) -> str:
        """Of the environment."""
    @property
    def planner(self) -> str:
        """Its planner."""
    @property
    def seed(self) -> int:
        """Its seed."""
    @property
    def frame_count(self) -> int:
        """T, start and hold included."""
    @property
    def duration_s(self) -> float:
        """Hold included [s]."""
    @property
    def cost_kpa(self) -> float:
        """Sum of |dp| over segments and frames [kPa]."""
    @property
    def clearance_m(self) -> float:
        """Smallest predicted [m]."""
    @property
    def goal_distance_m(self) -> float:
        """Predicted, after the hold [m]."""
    @property
    def model_hash(self) -> str:
        """content_hash of the model's file; empty for the no-load model."""
    @model_hash.setter
    def model_hash(self, value: str) -> None: ...
    @property
    def ensemble(self) -> str:
        """"mean": predicted by all of an ensemble's networks; empty: by one."""
    @property
    def arm_hash(self) -> str:
        """Of the arm."""
    @property
    def valves_hash(self) -> str:
        """Of its valves; empty: none."""
    @property
    def environment_hash(self) -> str:
        """Of the environment."""
    @property
    def margin_m(self) -> float:
        """Clearance asked for [m]."""
    @property
    def tube(self) -> PlanTube | None:
        """PlanTube that it keeps free, or None."""
    @property
    def frame_rate_hz(self) -> float:
        """Frames per second."""
    @property
    def hold_frame_count(self) -> int:
        """The last frames, which repeat the final set point."""
    @property
    def goal_orientation_rad(self) -> float:
        """Predicted [rad]."""
    @property
    def program_version(self) -> str:
        """That made it."""
    @property
    def certified(self) -> CertifiedFigures | None:
        """CertifiedFigures, or None: not certified."""
    @property
    def waypoints_kpa(self) -> npt.NDArray[np.float32]:
        """Start first, float32 (w, n) [kPa]; a copy."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """Commanded, float32 (T, n) [kPa]; a copy."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Predicted, float32 (T, n) [kPa]; a copy."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """Predicted, float32 (T, m, 3); a copy."""
    def _repr_svg_(self) -> str | None: ...

class PlanLimit:
    """The limit that ended a search."""
    time: PlanLimit
    iterations: PlanLimit
    queries: PlanLimit
    memory: PlanLimit
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class PlanResult:
    """What came of planning."""
    @property
    def status(self) -> PlanStatus:
        """PlanStatus."""
    @property
    def reason(self) -> str:
        """What ended the search, a sentence."""
    @property
    def plan(self) -> Plan | None:
        """The plan, if and only if solved."""
    @property
    def limit(self) -> PlanLimit | None:
        """The limit that ended the search, or None."""
    @property
    def warnings(self) -> list[str]:
        """What to know of the plan, sentences."""
    @property
    def statistics(self) -> PlannerStatistics:
        """What it took."""
    @property
    def best_partial(self) -> Plan | None:
        """Where there is no plan, the motion that came nearest; never a solution."""
    @property
    def certificate(self) -> Certificate | None:
        """Of the plan."""
    @property
    def first_solution(self) -> FirstSolution | None:
        """FirstSolution, or None."""
    @property
    def max_clearance_m(self) -> float | None:
        """What a plan keeps that was found with less clearance [m], or None."""
    @property
    def events(self) -> list[PlannerProgress]:
        """Each plan that was notably cheaper."""
    @property
    def tree(self) -> npt.NDArray[np.float32]:
        """Tips of nodes and their parents, float32 (edges, 2, 2) [m]."""
    def _repr_svg_(self) -> str | None: ...

class PlanStatus:
    """What came of planning."""
    solved: PlanStatus
    limit: PlanStatus
    invalid_start: PlanStatus
    goal_unreachable: PlanStatus
    goal_in_collision: PlanStatus
    not_certified: PlanStatus
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class PlanTube:
    """How far the arm may be from where a plan predicts it, in a share of all runs; `limber calibrate` measures it."""
    @property
    def level(self) -> float:
        """Share of runs, in (0, 1)."""
    @property
    def plate_radius_m(self) -> list[float]:
        """One a plate, base first [m]."""
    @property
    def end_radius_m(self) -> float:
        """Of the tip after the hold [m]."""
    @property
    def end_heading_rad(self) -> float:
        """Of its heading [rad]."""
    @property
    def goal_inside(self) -> bool:
        """Of a plan: whether its end lies so far inside the goal."""

class Planner:
    """A planner in pressure space: one caller at a time."""
    @property
    def name(self) -> str:
        """As make_planner knows it."""
    def plan(self, problem: PlanningProblem, limits: PlannerLimits, seed: int, callback: Callable[[PlannerProgress], bool | None] | None = None) -> PlanResult:
        """Searches; the plan is certified. `callback(progress)` comes about ten times per second; False stops the search. Ctrl-C ends it with KeyboardInterrupt. With limits of iterations or queries alone the seed decides everything."""

class PlannerLimits:
    """When to stop; whichever comes first. At least one of time_s, iterations and queries is set."""
    @property
    def time_s(self) -> float | None:
        """[s]"""
    @time_s.setter
    def time_s(self, value: float | None) -> None: ...
    @property
    def iterations(self) -> int | None:
        """Samples."""
    @iterations.setter
    def iterations(self, value: int | None) -> None: ...
    @property
    def queries(self) -> int | None:
        """Of the forward model."""
    @queries.setter
    def queries(self, value: int | None) -> None: ...
    @property
    def memory_mb(self) -> float | None:
        """Of the tree [MB]."""
    @memory_mb.setter
    def memory_mb(self, value: float | None) -> None: ...
    @property
    def cost_threshold_kpa(self) -> float | None:
        """Stops at a plan this cheap [kPa]."""
    @cost_threshold_kpa.setter
    def cost_threshold_kpa(self, value: float | None) -> None: ...
    def __init__(self, *, time_s: float | None = ..., iterations: int | None = ..., queries: int | None = ..., memory_mb: float | None = ..., cost_threshold_kpa: float | None = ...) -> None: ...

class PlannerProgress:
    """How far a search is."""
    @property
    def time_s(self) -> float:
        """[s]"""
    @property
    def iterations(self) -> int:
        """Samples."""
    @property
    def nodes(self) -> int:
        """Of the tree."""
    @property
    def queries(self) -> int:
        """Of the forward model."""
    @property
    def best_cost_kpa(self) -> float | None:
        """None before the first plan."""

class PlannerStatistics:
    """What a search took."""
    @property
    def time_s(self) -> float:
        """[s]"""
    @property
    def iterations(self) -> int:
        """Samples."""
    @property
    def queries(self) -> int:
        """Of the forward model."""
    @property
    def nodes(self) -> int:
        """Of the tree."""

class PlanningProblem:
    """What is to be solved; it keeps arm, model and environment alive."""
    @property
    def margin_m(self) -> float:
        """[m]"""
    @property
    def goal_margin(self) -> PoseError:
        """Room for the model's error."""
    @property
    def tube(self) -> PlanTube | None:
        """PlanTube, or None."""
    def __init__(self, arm: ArmDescription, model: MotionModel, environment: Environment, margin_m: float = 0.0, goal_margin: PoseError = ..., stay_within: RecordedRegion | None = None, margin_yields_to_start: bool = False, limits_kpa: Sequence[tuple[float, float]] = ..., tube: PlanTube | None = None) -> None:
        """margin_m: clearance kept from obstacles [m]; goal_margin: how far inside the goal's tolerances plans end; limits_kpa: lower and upper of each segment, within the arm's; empty: the arm's; tube: kept free beside the margin."""

class Polygon:
    """A simple polygon, convex or not; the inside is solid."""
    @property
    def points_m(self) -> npt.NDArray[np.float64]:
        """Corners, float64 (k, 2) [m]."""
    def __init__(self, points_m: npt.ArrayLike) -> None:
        """Corners, (k, 2), k >= 3 [m]."""

class Pose:
    """A pose in the arm's plane, frame B."""
    @property
    def x_m(self) -> float:
        """Along the straight arm [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """To its left [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def theta_rad(self) -> float:
        """Heading, counter-clockwise, unwrapped [rad]."""
    @theta_rad.setter
    def theta_rad(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., theta_rad: float = ...) -> None: ...

class PoseError:
    """How far a pose is from a goal's centre."""
    @property
    def position_m(self) -> float:
        """Distance [m]."""
    @position_m.setter
    def position_m(self, value: float) -> None: ...
    @property
    def orientation_rad(self) -> float:
        """In [0, pi]; 0 where the goal has no heading."""
    @orientation_rad.setter
    def orientation_rad(self, value: float) -> None: ...
    def __init__(self, *, position_m: float = ..., orientation_rad: float = ...) -> None: ...

class PoseGoal:
    """A region of end-effector poses in frame B; without theta_rad any heading does."""
    @property
    def x_m(self) -> float:
        """Centre [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """Centre [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def theta_rad(self) -> float | None:
        """Heading [rad], or None."""
    @theta_rad.setter
    def theta_rad(self, value: float | None) -> None: ...
    @property
    def position_tolerance_m(self) -> float:
        """Radius [m], > 0."""
    @position_tolerance_m.setter
    def position_tolerance_m(self, value: float) -> None: ...
    @property
    def orientation_tolerance_rad(self) -> float:
        """Of the heading [rad], > 0; unused without theta_rad."""
    @orientation_tolerance_rad.setter
    def orientation_tolerance_rad(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., theta_rad: float | None = ..., position_tolerance_m: float = ..., orientation_tolerance_rad: float = ...) -> None: ...

class PredictionError:
    """How far predictions were from the arm on motions that neither trained nor chose the model; not exceeded by 95 % of the runs."""
    @property
    def runs(self) -> int:
        """That it was measured over."""
    @property
    def run_s(self) -> float:
        """Their mean length [s]."""
    @property
    def max_position_m(self) -> float:
        """Of any plate [m]."""
    @property
    def off_path_m(self) -> float:
        """Off the predicted motion [m]."""
    @property
    def end_position_m(self) -> float:
        """Of the tip at the end [m]."""
    @property
    def end_orientation_rad(self) -> float:
        """Of its heading [rad]."""

class ProcessDriver:
    """An arm behind a program of your own (docs/driver.md; limber.driver.serve makes one of Python), in a process that closes the valves whatever becomes of this one. One thread at a time; `with` closes it."""
    @property
    def limits_kpa(self) -> npt.NDArray[np.float32]:
        """In force, lower and upper, float32 (n, 2) [kPa]."""
    @property
    def is_real_time(self) -> bool:
        """Whether a frame takes its time."""
    @property
    def vent_confirmed(self) -> bool:
        """Whether every measured pressure came down at the last vent."""
    def __init__(self, arm: ArmDescription, command: str, arm_file: str | os.PathLike[str] | None = None, limit_scale: float = 1.0, check_rate: bool = True, log: str | os.PathLike[str] | None = None, on_message: Callable[[str], None] | None = None) -> None:
        """Starts "exec:COMMAND" without a shell, and vents. arm_file: its mapping `safety` counts; limit_scale: limits in force are so many times the arm's; check_rate: False where motions jump and the valves ramp by themselves; log: file of what both sides said; on_message(text): told what came of each vent, else standard error is."""
    def state(self) -> ArmState:
        """The latest state."""
    def command(self, setpoint_kpa: npt.ArrayLike) -> ArmState:
        """One frame at set points (n,) [kPa]; the state after it. Who commands by hand vents by hand."""
    def vent(self) -> None:
        """Opens every vent valve, and watches the pressures come down, 5 s at most."""
    def look(self) -> ArmState:
        """A fresh state of the vented arm."""
    def close(self) -> None:
        """Vents and ends the process; so does the end of this object."""
    def __enter__(self) -> ProcessDriver: ...
    def __exit__(self, *args) -> None: ...

class ProgressMode:
    """Whether progress goes to standard error."""
    automatic: ProgressMode
    quiet: ProgressMode
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class RandomStream:
    """Counter-based random numbers (Philox): the k-th sample depends on seed, stream and k alone. One stream, one thread."""
    def __init__(self, seed: int, stream: int = 0) -> None: ...
    def next_u32(self) -> int:
        """Uniform over all 32-bit words."""
    def uniform(self, low: float = 0.0, high: float = 1.0) -> float:
        """Uniform in [low, high)."""
    def normal(self) -> float:
        """Standard normal deviate."""
    def position(self) -> int:
        """Draws made so far, in 32-bit words."""
    def seek(self, position: int) -> None:
        """Goes on from a position."""

class RecordedRegion:
    """Judges whether motions stay within what the recordings held."""
    def __init__(self, learnt: LearntRegion, frame_rate_hz: float) -> None: ...

class Recording:
    """Recorded motion of an arm."""
    @property
    def arm_name(self) -> str:
        """Of the arm that moved."""
    @property
    def arm_hash(self) -> str:
        """ArmDescription.hash() of it."""
    @property
    def segment_count(self) -> int:
        """n."""
    @property
    def point_count(self) -> int:
        """m."""
    @property
    def rate_hz(self) -> float:
        """Frames per second."""
    @property
    def seed(self) -> int:
        """Of the schedule and of noise."""
    @property
    def source(self) -> str:
        """"virtual arm", "motive log.csv", ..."""
    @property
    def settings(self) -> str:
        """How it was collected, in words."""
    @settings.setter
    def settings(self, value: str) -> None: ...
    @property
    def program_version(self) -> str:
        """That wrote the file."""
    @property
    def episodes(self) -> list[Episode]:
        """Its runs; no copies."""
    @property
    def setpoints_only(self) -> bool:
        """Nothing was measured in any of its episodes."""
    @property
    def frame_count(self) -> int:
        """Of all episodes."""
    @property
    def untracked_count(self) -> int:
        """Frames without a measured backbone."""
    @property
    def duration_s(self) -> float:
        """Frames / rate [s]."""

class Rectangle:
    """An obstacle."""
    @property
    def x_m(self) -> float:
        """Centre [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """Centre [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def width_m(self) -> float:
        """Along its own x [m], > 0."""
    @width_m.setter
    def width_m(self, value: float) -> None: ...
    @property
    def height_m(self) -> float:
        """Along its own y [m], > 0."""
    @height_m.setter
    def height_m(self, value: float) -> None: ...
    @property
    def angle_rad(self) -> float:
        """Counter-clockwise [rad]."""
    @angle_rad.setter
    def angle_rad(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., width_m: float = ..., height_m: float = ..., angle_rad: float = ...) -> None: ...

class Replanner:
    """Plans again from where the arm is measured, whenever it stands off the goal or has strayed. One run at a time."""
    def __init__(self, arm: ArmDescription, model: MotionModel, environment: Environment, room: ErrorRoom | None = None, seed: int = 1) -> None:
        """room: what plans keep in hand; None: error_room's."""

class Restart:
    """How often a prediction is corrected."""
    every_frame: Restart
    every_32_frames: Restart
    every_motion: Restart
    at_the_start_only: Restart
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class RolloutErrors:
    """By how often a prediction is corrected."""
    @property
    def one_step(self) -> TipErrors:
        """At every frame."""
    @property
    def window_32(self) -> TipErrors:
        """Every 32 frames."""
    @property
    def per_motion(self) -> TipErrors:
        """At every motion's start."""
    @property
    def open_loop(self) -> TipErrors:
        """Never."""
    @property
    def open_loop_from_setpoints(self) -> TipErrors | None:
        """Never, and through the model's valves; or None."""

class Scaling:
    """What the network's numbers are scaled to."""
    unit_range: Scaling
    unit_spread: Scaling
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class ScheduleKind:
    """Which motions are recorded."""
    transitions: ScheduleKind
    random: ScheduleKind
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class ScheduleSettings:
    """What motions are recorded."""
    @property
    def kind(self) -> ScheduleKind:
        """ScheduleKind."""
    @kind.setter
    def kind(self, value: ScheduleKind) -> None: ...
    @property
    def count(self) -> int:
        """Motions; 0: every transition."""
    @count.setter
    def count(self, value: int) -> None: ...
    @property
    def episodes(self) -> int:
        """0: 16 for transitions, 1 for random."""
    @episodes.setter
    def episodes(self, value: int) -> None: ...
    @property
    def approach(self) -> Approach:
        """Approach."""
    @approach.setter
    def approach(self, value: Approach) -> None: ...
    @property
    def hold_s(self) -> float:
        """Of a motion's final set point [s]."""
    @hold_s.setter
    def hold_s(self, value: float) -> None: ...
    @property
    def limit_scale(self) -> float:
        """Motions stay within so many times the arm's limits, in (0, 1]."""
    @limit_scale.setter
    def limit_scale(self, value: float) -> None: ...
    @property
    def hold_min_s(self) -> float | None:
        """Holds are sampled between this and hold_s [s]; or None."""
    @hold_min_s.setter
    def hold_min_s(self, value: float | None) -> None: ...
    def __init__(self, *, kind: ScheduleKind = ..., count: int = ..., episodes: int = ..., approach: Approach = ..., hold_s: float = ..., limit_scale: float = ..., hold_min_s: float | None = ...) -> None: ...

class Segment:
    """One bending segment: two actuators on each side."""
    @property
    def length_m(self) -> float:
        """Unpressurised length [m]."""
    @property
    def width_m(self) -> float:
        """Between the two sides [m]."""
    @property
    def gaps(self) -> int:
        """Spaces between its plates."""
    @property
    def pressure_limit_kpa(self) -> float:
        """The larger one of both sides [kPa]."""
    @property
    def strain_polynomial(self) -> list[float]:
        """c1 to c4 of e = c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa."""
    @property
    def curvature_per_unit(self) -> float:
        """[1/m] over the command; NoLoadKind.curvature alone."""
    @property
    def pressure_range_kpa(self) -> tuple[float, float]:
        """Its limits: lower and upper [kPa]."""

class SegmentPressure:
    """A pressure that bends a segment as wanted."""
    @property
    def pressure_kpa(self) -> float:
        """Within the limit [kPa]."""
    @property
    def reachable(self) -> bool:
        """False where more than the limit would be needed."""

class SegmentShape:
    """Curvature and length of one segment."""
    @property
    def curvature_per_m(self) -> float:
        """Positive bends left [1/m]."""
    @property
    def length_m(self) -> float:
        """[m]"""

class SegmentValves:
    """One segment's valves and their controller."""
    @property
    def inflating(self) -> ValveDirection:
        """Away from zero."""
    @inflating.setter
    def inflating(self, value: ValveDirection) -> None: ...
    @property
    def venting(self) -> ValveDirection:
        """Toward zero."""
    @venting.setter
    def venting(self, value: ValveDirection) -> None: ...
    @property
    def dead_time_s(self) -> float:
        """From a set point to its effect [s]."""
    @dead_time_s.setter
    def dead_time_s(self, value: float) -> None: ...
    @property
    def dead_band_kpa(self) -> float:
        """The valves stay closed within this distance of the set point [kPa]."""
    @dead_band_kpa.setter
    def dead_band_kpa(self, value: float) -> None: ...
    def __init__(self, *, inflating: ValveDirection = ..., venting: ValveDirection = ..., dead_time_s: float = ..., dead_band_kpa: float = ...) -> None: ...

class SimpleFit:
    """Gains, offsets and lengths of the simple model, fitted to recordings."""
    def describe(self, arm: ArmDescription) -> str:
        """Each number with its 95 % interval, as text."""

class StageChoice:
    """What a race between windows found."""
    @property
    def tried(self) -> list[WindowsTried]:
        """WindowsTried, the preset's first."""
    @property
    def chosen(self) -> int:
        """Index in `tried`."""
    @property
    def race_epochs(self) -> int:
        """Of each short run."""
    @property
    def epochs(self) -> int:
        """Left for the chosen windows."""
    def __str__(self) -> str: ...

class StrainFit:
    """A strain polynomial and how well it fits."""
    @property
    def polynomial(self) -> list[float]:
        """c1 to c4."""
    @property
    def full_strain(self) -> float:
        """At the pressure limit."""
    @property
    def rms_residual(self) -> float:
        """Over full strain."""
    @property
    def max_residual(self) -> float:
        """Over full strain."""
    @property
    def points(self) -> int:
        """Readings that were used."""
    @property
    def warnings(self) -> list[str]:
        """Sentences."""

class SystemFault(RuntimeError):
    """The machine or a driver failed: disk full, simulation blown up, arm silent."""

class TipErrors:
    """Errors of the end effector."""
    @property
    def position_cm(self) -> ErrorStatistics:
        """[cm]"""
    @property
    def orientation_rad(self) -> ErrorStatistics:
        """[rad]"""

class TrainingData:
    """What is learnt from, what chooses the best epoch, what is replayed, and what the error is measured on. Lists of Episode: copies; assign whole lists."""
    @property
    def training(self) -> list[Episode]:
        """Learnt from."""
    @training.setter
    def training(self, value: Iterable[Episode]) -> None: ...
    @property
    def validation(self) -> list[Episode]:
        """Chooses the best epoch."""
    @validation.setter
    def validation(self, value: Iterable[Episode]) -> None: ...
    @property
    def replay(self) -> list[Episode]:
        """What a model to be fine-tuned was trained on."""
    @replay.setter
    def replay(self, value: Iterable[Episode]) -> None: ...
    @property
    def unseen(self) -> list[Episode]:
        """Never looked at by `train`."""
    @unseen.setter
    def unseen(self, value: Iterable[Episode]) -> None: ...
    @property
    def held_back(self) -> list[int]:
        """Which of the episodes given to hold_back_validation validate."""
    def __init__(self, training: Iterable, validation: Iterable = ..., replay: Iterable = ..., unseen: Iterable = ...) -> None: ...

class TrainingResult:
    """What came of training."""
    @property
    def status(self) -> TrainingStatus:
        """TrainingStatus."""
    @property
    def message(self) -> str:
        """Why it diverged, and what to try."""
    @property
    def best_epoch(self) -> int:
        """Which the model is of."""
    @property
    def best_validation_position_error_cm(self) -> float:
        """Open loop [cm]."""
    @property
    def wall_time_s(self) -> float:
        """[s]"""
    @property
    def model(self) -> CompensationModel:
        """The best by validation."""
    @property
    def passed_over_epochs(self) -> list[int]:
        """Better by validation, but their networks ran away in a long rollout."""
    @property
    def long_rollout(self) -> LongRollout:
        """LongRollout of the best epoch."""
    @property
    def curve(self) -> list[LearningCurvePoint]:
        """LearningCurvePoint, one an epoch."""
    @property
    def member_validation_position_error_cm(self) -> list[float]:
        """Of an ensemble [cm]."""
    def _repr_svg_(self) -> str: ...

class TrainingSettings:
    """Everything that decides a training run besides its data. Same settings, data and seed: same network, for any number of jobs."""
    @property
    def preset(self) -> str:
        """"paper" or "best"; training_preset fills in the rest."""
    @preset.setter
    def preset(self, value: str) -> None: ...
    @property
    def layout(self) -> BackboneLayout:
        """BackboneLayout."""
    @layout.setter
    def layout(self, value: BackboneLayout) -> None: ...
    @property
    def form(self) -> OutputForm:
        """OutputForm."""
    @form.setter
    def form(self, value: OutputForm) -> None: ...
    @property
    def hidden_units(self) -> list[int]:
        """Of each hidden layer; assign a whole list."""
    @hidden_units.setter
    def hidden_units(self, value: list[int]) -> None: ...
    @property
    def scaling(self) -> Scaling:
        """Scaling."""
    @scaling.setter
    def scaling(self, value: Scaling) -> None: ...
    @property
    def reduction(self) -> LossReduction:
        """LossReduction."""
    @reduction.setter
    def reduction(self, value: LossReduction) -> None: ...
    @property
    def stages(self) -> TrainingStages:
        """In this order."""
    @stages.setter
    def stages(self, value: TrainingStages) -> None: ...
    @property
    def optimiser(self) -> Optimiser:
        """Optimiser."""
    @optimiser.setter
    def optimiser(self, value: Optimiser) -> None: ...
    @property
    def learning_rate(self) -> float:
        """At the start."""
    @learning_rate.setter
    def learning_rate(self, value: float) -> None: ...
    @property
    def cosine_decay(self) -> bool:
        """Towards zero over the run; else constant."""
    @cosine_decay.setter
    def cosine_decay(self, value: bool) -> None: ...
    @property
    def gradient_norm_limit(self) -> float:
        """0: none."""
    @gradient_norm_limit.setter
    def gradient_norm_limit(self, value: float) -> None: ...
    @property
    def average_decay(self) -> float:
        """Of the weights' moving average; 0: none."""
    @average_decay.setter
    def average_decay(self, value: float) -> None: ...
    @property
    def input_noise(self) -> float:
        """Added to a window's first backbone, normalised."""
    @input_noise.setter
    def input_noise(self, value: float) -> None: ...
    @property
    def shift_windows(self) -> bool:
        """Each epoch cuts its windows elsewhere."""
    @shift_windows.setter
    def shift_windows(self, value: bool) -> None: ...
    @property
    def ensemble(self) -> int:
        """Networks trained together, 1 to 64."""
    @ensemble.setter
    def ensemble(self, value: int) -> None: ...
    @property
    def replay_share(self) -> float:
        """Of an epoch's windows, from what is replayed."""
    @replay_share.setter
    def replay_share(self, value: float) -> None: ...
    @property
    def seed(self) -> int:
        """Of all chance."""
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def jobs(self) -> int:
        """Threads, 0: one per core."""
    @jobs.setter
    def jobs(self, value: int) -> None: ...
    @property
    def time_limit_s(self) -> float:
        """Fixes the number of epochs at the start [s]."""
    @time_limit_s.setter
    def time_limit_s(self, value: float) -> None: ...
    @property
    def validation_interval(self) -> int:
        """Epochs between validations."""
    @validation_interval.setter
    def validation_interval(self, value: int) -> None: ...
    @property
    def checkpoint(self) -> str | os.PathLike[str]:
        """File to go on from; empty: none."""
    @checkpoint.setter
    def checkpoint(self, value: str | os.PathLike[str]) -> None: ...
    @property
    def checkpoint_interval_s(self) -> float:
        """Between storing [s]."""
    @checkpoint_interval_s.setter
    def checkpoint_interval_s(self, value: float) -> None: ...
    @property
    def resume(self) -> bool:
        """Go on from the checkpoint."""
    @resume.setter
    def resume(self, value: bool) -> None: ...
    @property
    def epoch_count(self) -> int:
        """Of all stages."""
    def __init__(self, *, preset: str = ..., layout: BackboneLayout = ..., form: OutputForm = ..., hidden_units: list[int] = ..., scaling: Scaling = ..., reduction: LossReduction = ..., stages: TrainingStages = ..., optimiser: Optimiser = ..., learning_rate: float = ..., cosine_decay: bool = ..., gradient_norm_limit: float = ..., average_decay: float = ..., input_noise: float = ..., shift_windows: bool = ..., ensemble: int = ..., replay_share: float = ..., seed: int = ..., jobs: int = ..., time_limit_s: float = ..., validation_interval: int = ..., checkpoint: str | os.PathLike[str] = ..., checkpoint_interval_s: float = ..., resume: bool = ...) -> None: ...

class TrainingStage:
    """A part of training, windows of one length."""
    @property
    def window_frames(self) -> int:
        """Frames a window."""
    @window_frames.setter
    def window_frames(self, value: int) -> None: ...
    @property
    def windows_per_batch(self) -> int:
        """Windows a batch."""
    @windows_per_batch.setter
    def windows_per_batch(self, value: int) -> None: ...
    @property
    def epochs(self) -> int:
        """>= 1."""
    @epochs.setter
    def epochs(self, value: int) -> None: ...
    def __init__(self, *, window_frames: int = ..., windows_per_batch: int = ..., epochs: int = ...) -> None: ...

class TrainingStages:
    """Stages of training, a list."""
    @overload
    def __init__(self) -> None: ...
    @overload
    def __init__(self, value: TrainingStages) -> None:
        """Copy constructor"""
    @overload
    def __init__(self, value: Iterable) -> None: ...
    def append(self, x: TrainingStage) -> None:
        """Add an item to the end of the list"""
    def clear(self) -> None:
        """Clear the contents"""
    @overload
    def extend(self, L: TrainingStages) -> None:
        """Extend the list by appending all the items in the given list"""
    @overload
    def extend(self, L: Iterable) -> None:
        """Extend the list by appending all the items in the given list"""
    def insert(self, i: int, x: TrainingStage) -> None:
        """Insert an item at a given position."""
    @overload
    def pop(self) -> TrainingStage:
        """Remove and return the last item"""
    @overload
    def pop(self, i: int) -> TrainingStage:
        """Remove and return the item at index ``i``"""
    @overload
    def __setitem__(self, value: int, arg1: TrainingStage) -> None: ...
    @overload
    def __setitem__(self, value: slice, arg1: TrainingStages) -> None:
        """Assign list elements using a slice object"""
    @overload
    def __getitem__(self, s: slice) -> TrainingStages:
        """Retrieve list elements using a slice object"""
    @overload
    def __getitem__(self, value: int) -> TrainingStage: ...
    @overload
    def __delitem__(self, value: int) -> None:
        """Delete the list elements at index ``i``"""
    @overload
    def __delitem__(self, value: slice) -> None:
        """Delete list elements using a slice object"""
    def __iter__(self) -> Iterator: ...
    def __bool__(self) -> bool:
        """Check whether the list is nonempty"""
    def __len__(self) -> int: ...

class TrainingStatus:
    """How training ended."""
    finished: TrainingStatus
    interrupted: TrainingStatus
    diverged: TrainingStatus
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class ValveDirection:
    """How a segment's pressure moves one way."""
    @property
    def time_constant_s(self) -> float:
        """[s]; 0 follows at once."""
    @time_constant_s.setter
    def time_constant_s(self, value: float) -> None: ...
    @property
    def rate_limit_kpa_per_s(self) -> float:
        """[kPa/s], > 0; infinite where nothing limits it."""
    @rate_limit_kpa_per_s.setter
    def rate_limit_kpa_per_s(self, value: float) -> None: ...
    def __init__(self, *, time_constant_s: float = ..., rate_limit_kpa_per_s: float = ...) -> None: ...

class ValveErrors:
    """Modelled less measured pressure over moving frames."""
    @property
    def mean_kpa(self) -> float:
        """[kPa]"""
    @property
    def p95_kpa(self) -> float:
        """[kPa]"""
    @property
    def max_kpa(self) -> float:
        """[kPa]"""
    @property
    def frames(self) -> int:
        """0: not measured."""

class ValveFindings:
    """How valves were identified, or why not."""
    @property
    def source(self) -> str:
        """The recordings."""
    @property
    def held_back(self) -> ValveErrors:
        """On motions that the fit has not seen."""
    @property
    def from_setpoints(self) -> ValveErrors:
        """The same, had set points been taken for pressures."""
    @property
    def reason(self) -> str:
        """Why there are no parameters."""
    @property
    def warnings(self) -> list[str]:
        """Sentences."""

class ValveModel:
    """Set points to pressures, frame by frame. Constant: share it freely."""
    @property
    def is_ideal(self) -> bool:
        """Whether pressures follow at once."""
    @property
    def parameters(self) -> ValveParameters:
        """As given."""
    @property
    def segment_count(self) -> int:
        """n."""
    def __init__(self, arm: ArmDescription, parameters: ValveParameters | None = None) -> None:
        """Without parameters ideal valves: pressures are the set points."""
    def run(self, setpoint_kpa: npt.ArrayLike, first_pressure_kpa: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Pressures along set points float64 (T, n) [kPa] from a settled start (n,): float64 (T, n), row k after frame k; row 0 is the start."""

class ValveParameters:
    """Parameters of the valve model; without segments ideal valves."""
    @property
    def has_sides(self) -> bool:
        """Whether a pressure has two sides."""
    @has_sides.setter
    def has_sides(self, value: bool) -> None: ...
    @property
    def segments(self) -> list[SegmentValves]:
        """One a segment, or none; assign whole lists."""
    @segments.setter
    def segments(self, value: list[SegmentValves]) -> None: ...
    @property
    def is_ideal(self) -> bool:
        """Whether pressures are the set points."""
    def __init__(self, *, has_sides: bool = ..., segments: list[SegmentValves] = ...) -> None: ...
    def hash(self) -> str:
        """Of everything that a prediction depends on."""
    def __eq__(self, other: object) -> bool: ...

class VirtualArm:
    """A soft arm lying on a table, simulated; an ArmDriver."""
    def __init__(self, arm: ArmDescription, options: VirtualArmOptions = ...) -> None:
        """At rest: straight, vented, at time 0."""
    def state(self) -> ArmState:
        """The latest state."""
    def command(self, setpoint_kpa: npt.ArrayLike) -> ArmState:
        """One frame at set points (n,) [kPa]; the state after it."""
    def vent(self) -> None:
        """Opens every vent valve."""
    def settle(self, setpoint_kpa: npt.ArrayLike, seconds: float) -> ArmState:
        """The same set points (n,) [kPa] for so long [s]; the state after it."""
    def true_backbone(self) -> npt.NDArray[np.float64]:
        """float64 (m, 3), without noise, drops or latency."""
    def true_pressure_kpa(self) -> npt.NDArray[np.float64]:
        """float64 (n,) [kPa], without noise or latency."""

class VirtualArmOptions:
    """Faults of a real laboratory, all off by default."""
    @property
    def noise_m(self) -> float:
        """Of measured x and y [m]."""
    @noise_m.setter
    def noise_m(self, value: float) -> None: ...
    @property
    def noise_rad(self) -> float:
        """Of measured headings [rad]."""
    @noise_rad.setter
    def noise_rad(self, value: float) -> None: ...
    @property
    def noise_kpa(self) -> float:
        """Of measured pressures [kPa]."""
    @noise_kpa.setter
    def noise_kpa(self, value: float) -> None: ...
    @property
    def drop_rate(self) -> float:
        """Share of frames without a backbone."""
    @drop_rate.setter
    def drop_rate(self, value: float) -> None: ...
    @property
    def latency_s(self) -> float:
        """Of everything measured [s]."""
    @latency_s.setter
    def latency_s(self, value: float) -> None: ...
    @property
    def seed(self) -> int:
        """Of noise and drops."""
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def stream(self) -> int:
        """Unit of work, for noise of its own."""
    @stream.setter
    def stream(self, value: int) -> None: ...
    def __init__(self, *, noise_m: float = ..., noise_rad: float = ..., noise_kpa: float = ..., drop_rate: float = ..., latency_s: float = ..., seed: int = ..., stream: int = ...) -> None: ...

class WindowsTried:
    """Windows of stages, and how a short run did."""
    @property
    def window_frames(self) -> list[int]:
        """Of each stage."""
    @property
    def one_step_cm(self) -> float:
        """Tip error by validation [cm]."""
    @property
    def window_32_cm(self) -> float:
        """Over rollouts of 32 frames."""
    @property
    def window_600_cm(self) -> float:
        """Of 600 frames: what decides."""

def arm_differences(there: ArmDescription, here: ArmDescription) -> list[str]:
    """Keys in which the arms differ, with both values; empty where they are the same arm."""

def arm_svg(arm: ArmDescription, backbone: npt.ArrayLike) -> str:
    """The arm with this backbone, float32 (m, 3), as SVG."""

def arm_to_yaml(arm: ArmDescription) -> str:
    """The arm as the text of a file that load_arm reads."""

def bench_test_all(arm: ArmDescription, steps: int = 20) -> list[list[BenchPoint]]:
    """The bench test of every segment of the virtual arm."""

def best_preset() -> TrainingSettings:
    """The default."""

def certify(plan: Plan, arm: ArmDescription, network: CompensationModel | None, valves: ValveParameters, environment: Environment) -> Certificate:
    """One plan, by a Certifier of its own: simulated, checked for collision and judged again, with nothing of the planner's. It says whether the plan is as the model has it, not whether the model is right. None is refused."""

def characterise(arm: ArmDescription, bench: Sequence[list[BenchPoint]]) -> CharacterisedArm:
    """Fits a monotone quartic to every segment's bench points."""

def choose_stages(arm: ArmDescription, data: TrainingData, settings: TrainingSettings, on_epoch: Callable[[LearningCurvePoint], bool | None] | None = None) -> StageChoice:
    """Chooses windows by validation in short runs, as the program does without --windows; `settings` gets the chosen stages and the epochs that are left."""

def collect(arm: ArmDescription, settings: CollectionSettings, make_driver: DriverFactory | ProcessDriver | Callable[[int], ArmDriver], path: str | os.PathLike[str]) -> CollectionResult:
    """Records a schedule to `path` (HDF5). make_driver: virtual_arm_factory(...), a ProcessDriver, or a function of the episode's index that returns an ArmDriver. Ctrl-C vents the arm and raises KeyboardInterrupt; finished episodes stay, for resume=True."""

def content_hash(path: str | os.PathLike[str]) -> str:
    """Of a file: what plans and models say of the files they were made with."""

def environment_hash(environment: Environment) -> str:
    """Of everything that planning depends on."""

def environment_picture(arm: ArmDescription, environment: Environment) -> str:
    """The environment with the arm at its start, as an SVG file's text."""

def environment_to_yaml(environment: Environment) -> str:
    """The environment as the text of a file that load_environment reads."""

def episode_errors(arm: ArmDescription, episodes: Iterable) -> EpisodeErrors:
    """Errors of the simple model, fitted to all episodes; one far above the others' was broken."""

def error_room(model: ForwardModel, margin_m: float | None = None, goal_margin_m: float | None = None, goal_margin_rad: float | None = None, tube_level: float | None = None) -> ErrorRoom:
    """The tube that a model carries, or the error that it states, or the amounts that are given instead."""

def evaluate(no_load: ForwardModel, network: ForwardModel | None, episodes: Iterable, jobs: int = 0) -> Evaluation:
    """Errors of the no-load model and, unless None, of a network."""

def execute(arm: ArmDescription, environment: Environment, plan: Plan, driver: ArmDriver | ProcessDriver | VirtualArm, settings: ExecutionSettings = ..., replanner: Replanner | None = None) -> ExecutionResult:
    """Commands a plan's frames as they stand, then holds; a Replanner plans again. driver: a VirtualArm, a ProcessDriver, or an ArmDriver of your own for simulation. The arm is vented before this returns, whatever happens; Ctrl-C raises KeyboardInterrupt."""

def execution_animation(arm: ArmDescription, environment: Environment, plan: Plan, result: ExecutionResult) -> str:
    """A page in which the arm moves, as predicted and as measured."""

def execution_picture(arm: ArmDescription, environment: Environment, plan: Plan, result: ExecutionResult) -> str:
    """One run beside its prediction, as an SVG file's text."""

def export_csv(recording: Recording, folder: str | os.PathLike[str]) -> list[str | os.PathLike[str]]:
    """Each episode as one CSV table, and mapping.yaml to read them back with."""

def fine_tune(arm: ArmDescription, data: TrainingData, settings: TrainingSettings, start: CompensationModel, on_epoch: Callable[[LearningCurvePoint], bool | None] | None = None) -> TrainingResult:
    """The same, from the weights of a model."""

def fine_tuning_of(preset: TrainingSettings) -> TrainingSettings:
    """Settings to train a model on that has learnt already."""

def fit_simple_model(arm: ArmDescription, episodes: Iterable) -> SimpleFit:
    """How much a pressure bends each segment, and how long it is, from the recordings."""

def fitted_arm(arm: ArmDescription, fit: SimpleFit, episodes: Iterable) -> ArmDescription:
    """The arm with the fit's polynomials and lengths."""

def gap_bounds_of(episodes: Iterable) -> GapBounds:
    """The bounds of a model that learnt from these episodes, for the model.bounds of an old one."""

def hold_back_unseen(data: TrainingData, fraction: float, seed: int) -> None:
    """Then moves about `fraction` of the frames to data.unseen."""

def hold_back_validation(episodes: Iterable, fraction: float, seed: int) -> TrainingData:
    """Holds back whole episodes for validation, about `fraction` of the frames."""

def identify_valves(episodes: Iterable, arm: ArmDescription, source: str = 'recordings') -> IdentifiedValves:
    """Valves between set points and measured pressures; the findings say how well they fit, or why there are none."""

def import_csv(logs: Sequence[str | os.PathLike[str]], arm: ArmDescription, mapping: str | os.PathLike[str] | None = None, command_logs: Sequence[str | os.PathLike[str]] = ..., time_offset_s: float | None = None) -> ImportResult:
    """A recording from CSV logs; the mapping file names their columns and units (docs/importing.md)."""

def import_motive(logs: Sequence[str | os.PathLike[str]], arm: ArmDescription, mapping: str | os.PathLike[str] | None = None, command_logs: Sequence[str | os.PathLike[str]] = ..., time_offset_s: float | None = None) -> ImportResult:
    """The same from OptiTrack Motive's CSV exports, with pressures in logs of their own."""

def inspect(recording: Recording, arm: ArmDescription | None = None, file: str = 'recording') -> str:
    """What a recording holds and what is odd about it, in sentences."""

def is_within(goal: PoseGoal, error: PoseError) -> bool:
    """Whether both errors are within the goal's tolerances."""

def learning_curve_svg(curve: Sequence[LearningCurvePoint]) -> str:
    """Loss and validation error over epochs, as SVG text."""

def learnt_region_of(data: TrainingData) -> LearntRegion:
    """What a model has learnt that was trained on these data, for model.learnt."""

def load_arm(path: str | os.PathLike[str]) -> ArmDescription:
    """Reads and checks an arm file (YAML). Raises InputError naming file, line and field."""

def load_arm_to_characterise(path: str | os.PathLike[str]) -> ArmDescription:
    """An arm file whose strain polynomials may be missing or outdated."""

def load_environment(path: str | os.PathLike[str], arm: ArmDescription | None = None) -> Environment:
    """Reads and checks an environment file (YAML); with an arm, that its start fits."""

def make_planner(name: str = 'default', jobs: int = 0) -> Planner:
    """By name; settings may follow it: "default,improved_plans=0". jobs: threads, 0: one per core; they never change a result."""

def make_recording(arm: ArmDescription, episodes: Iterable, source: str = 'python', seed: int = 0) -> Recording:
    """A recording of these episodes (copied), checked: sizes agree, times increase, numbers are finite."""

def note_unseen(arm: ArmDescription, model: CompensationModel, unseen: Iterable, jobs: int = 0) -> None:
    """Measures the finished model's error on episodes that it has never seen, and stores it."""

def paper_preset() -> TrainingSettings:
    """As published."""

def plan_along(problem: PlanningProblem, waypoints_kpa: npt.ArrayLike, planner: str, seed: int = 0) -> PlanResult:
    """The motion that a planner of your own proposes, from the start straight to each of the waypoints (w, n) [kPa]: simulated, held and certified. Not certified: best_partial is the motion, reason what is wrong with it."""

def plan_animation(arm: ArmDescription, environment: Environment, plan: Plan) -> str:
    """One self-contained HTML page in which the arm moves."""

def plan_picture(arm: ArmDescription, environment: Environment, result: PlanResult) -> str:
    """Environment, search tree and plan (or the nearest motion, dashed), as SVG text."""

def planner_names() -> list[str]:
    """Names that make_planner knows, the default first."""

def pose_error(goal: PoseGoal, pose: Pose) -> PoseError:
    """How far a pose is from the goal's centre."""

def predict(model: ForwardModel, episode: Episode, restart: Restart, jobs: int = 0) -> npt.NDArray[np.float32]:
    """Backbones float32 (T, m, 3) of an episode, fed with its pressures; NaN where a frame is only a start."""

def pressure_picture(arm: ArmDescription, plan: Plan) -> str:
    """Set points and the pressures predicted from them over time, as SVG text."""

def problem_with_room(arm: ArmDescription, model: MotionModel, environment: Environment, room: ErrorRoom) -> PlanningProblem:
    """The problem whose plans keep that room: the model's tube, or one clearance everywhere."""

def read_bench_csv(path: str | os.PathLike[str], arm: ArmDescription) -> list[list[BenchPoint]]:
    """Bench points of every segment from a CSV file with the columns pressure_kpa, strain and, optionally, segment."""

def read_model(path: str | os.PathLike[str]) -> CompensationModel:
    """Reads and checks a model (safetensors)."""

def read_plan(path: str | os.PathLike[str]) -> Plan:
    """Reads and checks a plan (JSON). Raises InputError naming file and field."""

def read_plan_unchecked(path: str | os.PathLike[str]) -> Plan:
    """Reads what `certify` is to judge: types and finite numbers alone are checked."""

def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads and checks a recording (HDF5)."""

def read_valves(path: str | os.PathLike[str]) -> IdentifiedValves:
    """Reads a valve file (YAML or JSON)."""

def require_model_of(model: CompensationModel, arm: ArmDescription, where: str = 'model') -> None:
    """Raises InputError unless the model was trained for the arm."""

def require_plan_of(plan: Plan, arm: ArmDescription, file: str = 'plan') -> None:
    """Raises InputError where the plan was made for another arm or breaks its limits."""

def require_recording_of(recording: Recording, arm: ArmDescription, file: str = 'recording') -> None:
    """Raises InputError where the recording is not one of this arm."""

def rest_positions_m(arm: ArmDescription) -> list[float]:
    """Distance along the arm at rest from the base to each plate, m numbers [m]."""

def set_epoch_count(settings: TrainingSettings, epochs: int) -> None:
    """Scales the stages to so many epochs in all."""

def set_window_frames(settings: TrainingSettings, window_frames: Sequence[int]) -> None:
    """Stages of windows of these lengths instead."""

def solve_inverse_kinematics(model: NoLoadModel, goal: PoseGoal, settings: InverseKinematicsSettings, random: RandomStream) -> InverseKinematicsResult:
    """Pressures whose no-load tip is at the goal: Newton-Raphson from random starts."""

def start_state(environment: Environment, arm: ArmDescription) -> ArmStart:
    """Where the arm starts: as the environment has it, or at rest."""

def tip_pose(backbone: npt.ArrayLike) -> Pose:
    """Pose of the end effector: the last row of (m, 3)."""

@overload
def to_json(evaluation: Evaluation) -> dict[str, Any]:
    """The dict of `limber evaluate --json`."""
@overload
def to_json(certificate: Certificate, environment: Environment, command: Command = ...) -> dict[str, Any]:
    """The dict of `limber verify --json`. `command`: the arm's, where that is no pressure."""
@overload
def to_json(result: PlanResult, goal: PoseGoal, planner: str, model: str, seed: int, command: Command = ...) -> dict[str, Any]:
    """The dict of `limber plan --json`. `command`: the arm's, where that is no pressure."""
@overload
def to_json(result: ExecutionResult, environment: Environment) -> dict[str, Any]:
    """The dict of `limber execute --json`."""
@overload
def to_json(valves: IdentifiedValves) -> dict[str, Any]:
    """Keys as in a valve file."""
@overload
def to_json(error: PredictionError) -> dict[str, Any]:
    """The object `prediction_error` of `limber train --json`."""

def train(arm: ArmDescription, data: TrainingData, settings: TrainingSettings, on_epoch: Callable[[LearningCurvePoint], bool | None] | None = None) -> TrainingResult:
    """Trains a network. `on_epoch(LearningCurvePoint)` comes after every epoch; False stops the run. Ctrl-C raises KeyboardInterrupt; with a checkpoint, resume=True goes on."""

def training_preset(name: str) -> TrainingSettings:
    """Settings by name."""

def virtual_arm_factory(arm: ArmDescription, options: VirtualArmOptions = ...) -> DriverFactory:
    """A fresh virtual arm an episode, each with noise of its own."""

def virtual_collection(arm: ArmDescription, schedule: ScheduleSettings, options: VirtualArmOptions = ...) -> CollectionSettings:
    """Settings for the virtual arm, with its source, driver and seed."""

def with_setpoints_only(episodes: Iterable) -> list:
    """Copies of them without what was measured: set points alone."""

def write_arm(path: str | os.PathLike[str], arm: ArmDescription) -> None:
    """Writes an arm file that load_arm reads."""

def write_backbones_csv(path: str | os.PathLike[str], plan: Plan) -> None:
    """Predicted shapes, one row a frame."""

def write_environment(path: str | os.PathLike[str], environment: Environment) -> None:
    """Writes such a file."""

def write_model(path: str | os.PathLike[str], model: CompensationModel) -> None:
    """Writes a model (safetensors), atomically."""

def write_plan(path: str | os.PathLike[str], plan: Plan) -> None:
    """Writes a plan (JSON), atomically, every number exactly."""

def write_recording(path: str | os.PathLike[str], recording: Recording) -> None:
    """Writes a recording (HDF5), atomically."""

def write_setpoints_csv(path: str | os.PathLike[str], plan: Plan) -> None:
    """Set points for a valve controller, one row a frame."""

def write_valves(path: str | os.PathLike[str], valves: IdentifiedValves) -> None:
    """Writes a valve file, atomically."""
