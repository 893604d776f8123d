# Made by tools/python_stubs.py from the module's docstrings; do not edit.
import os
from typing import Any, Callable, Iterable, Iterator, Sequence, overload

import numpy as np
import numpy.typing as npt

from .arm_driver import ArmDriver
from .controller import Controller

__version__: str

class Adaptation:
    """What became of a family's network, and what its recording told. Errors are those of the tip over the seconds held back, the recording's last fifth, open loop."""
    @property
    def seconds(self) -> float:
        """Recorded [s]."""
    @property
    def moving_s(self) -> float:
        """Of these, in which the arm moved [s]."""
    @property
    def held_back_s(self) -> float:
        """Of these, held back [s]; 0: too few."""
    @property
    def middle_error_m(self) -> float:
        """Of the family's middle [m]."""
    @property
    def fitted_error_m(self) -> float:
        """Of the arm's vector alone [m]."""
    @property
    def trained_error_m(self) -> float:
        """With weights trained too [m]; NaN where none were."""
    @property
    def family_error_m(self) -> float:
        """Of arms of the family, as its record has it [m]; NaN: not known."""
    @property
    def distance(self) -> float:
        """From the family's middle; about 1 for an arm of the family."""
    @property
    def distance_to_nearest(self) -> float:
        """The same from the nearest arm that the family learnt from."""
    @property
    def uncertainty(self) -> float:
        """Share of the family's spread that is left."""
    @property
    def largest_uncertainty(self) -> float:
        """The same of what the recording tells least about."""
    @property
    def expected_error_m(self) -> float:
        """Of the tip, as far as the fit can tell [m]; a tube's width is in proportion."""
    @property
    def has_trained_weights(self) -> bool:
        """Whether `model` has weights of its own."""
    @property
    def is_of_family(self) -> bool:
        """Whether the family contains the arm."""
    @property
    def tells_too_little(self) -> bool:
        """Whether the recording moved too little to tell."""
    @property
    def model(self) -> CompensationModel:
        """CompensationModel of the arm, an ordinary one."""

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

class ArmCommand:
    """A command of the real arm, such as a motor's, and how much of it each segment gets."""
    @property
    def name(self) -> str:
        """Of its column in logs."""
    @property
    def shares(self) -> list[float]:
        """n, with sign."""

class ArmDescription:
    """A planar arm as its file describes it. Models borrow it, so it does not change: load_arm reads one."""
    @property
    def name(self) -> str:
        """The arm's name, as its file has it."""
    @property
    def command(self) -> Command:
        """What its segments are told: Command, pressures in kPa by default."""
    @property
    def no_load(self) -> NoLoadKind:
        """NoLoadKind: what the no-load model makes of the command."""
    @property
    def segment_count(self) -> int:
        """n: segments of the arm."""
    @property
    def point_count(self) -> int:
        """m: plates along the backbone, base included. One more than gaps in all."""
    @property
    def length_m(self) -> float:
        """Length at rest of all segments together [m]."""
    @property
    def frame_rate_hz(self) -> float:
        """Frames per second of recordings, models and plans [Hz], 1 to 1000."""
    @property
    def pressure_rate_limit_kpa_per_s(self) -> float:
        """What the valves can follow [kPa/s], > 0: plans change no set point faster."""
    @property
    def actuator_radius_m(self) -> float:
        """A gap's collision radius is its segment's width/2 + this [m], 0 to 1."""
    @property
    def segments(self) -> list[Segment]:
        """Its Segments, base first: segments[0] is at the base."""
    @property
    def commands(self) -> list[ArmCommand]:
        """The real arm's ArmCommands, where they are not one for each segment; else empty."""
    @property
    def frame_period_s(self) -> float:
        """Time from one frame to the next, 1/frame_rate_hz [s]."""
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
        """Fewest frames that take at least so long. seconds: >= 0."""
    def segment_of_gap(self, gap: int) -> int:
        """Number of the segment, from 0, that the gap between plates gap and gap + 1 belongs to. gap: 0 to m - 2."""
    def hash(self) -> str:
        """Hash of everything that the no-load model and planning depend on, a text."""
    def _repr_svg_(self) -> str: ...

class ArmEstimate:
    """What is known about an arm at one moment of a run."""
    @property
    def frames(self) -> int:
        """Set points sent since the start."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """Set points of the last frame, float32 (n,) [kPa]."""
    @property
    def measured(self) -> ArmState:
        """ArmState as the driver said it, lag_frames behind the set points."""
    @property
    def lag_frames(self) -> int:
        """Frames by which what is measured is behind what was sent."""
    @property
    def frames_unseen(self) -> int:
        """Frames since the arm was tracked last."""
    @property
    def rest(self) -> Any:
        """Mean shape of an arm that has rested for 0.5 s, float32 (m, 3), or None."""
    @property
    def state(self) -> MotionState | None:
        """MotionState after the last set points, or None: no model, or never tracked."""

class ArmStart:
    """State of the arm that a motion starts from."""
    @property
    def pressures_kpa(self) -> npt.NDArray[np.float32]:
        """Pressures that the arm starts with, float32 (n,) [kPa], signed; a copy."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """Shape that the arm starts with, float32 (m, 3): x_m, y_m, theta_rad of each plate; a copy."""
    def __init__(self, pressures_kpa: npt.ArrayLike, backbone: npt.ArrayLike) -> None:
        """pressures_kpa: (n,) [kPa], signed; backbone: (m, 3), rows x_m, y_m, theta_rad in frame B, plate 0 at the base."""

class ArmState:
    """What is known of the arm at one frame: pressures and shape."""
    @property
    def time_s(self) -> float:
        """When it was measured [s]."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Measured pressures, float32 (n,) [kPa], positive bends right; a copy."""
    @property
    def backbone(self) -> npt.NDArray[np.float32] | None:
        """Measured shape, float32 (m, 3): x_m, y_m, theta_rad of each plate; None where nothing tracked it."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32] | None:
        """Set points in force when this was measured, float32 (n,) [kPa], where the arm says so; else None."""
    @property
    def tracker_t(self) -> float | None:
        """When the shape was seen, on the tracker's own clock [s]; or None."""
    def __init__(self, time_s: float, pressure_kpa: npt.ArrayLike, backbone: Any | None = None, setpoint_kpa: Any | None = None, tracker_t: float | None = None) -> None:
        """[s]; (n,) [kPa]; (m, 3) or None where nothing tracks it; (n,) [kPa], in force when this was measured, None: the one commanded last; [s] or None."""

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
        """Gauge pressure of the inflated side [kPa], >= 0."""
    @pressure_kpa.setter
    def pressure_kpa(self, value: float) -> None: ...
    @property
    def strain(self) -> float:
        """Change of the side's length over its length at rest; negative: contracted."""
    @strain.setter
    def strain(self, value: float) -> None: ...
    def __init__(self, *, pressure_kpa: float = ..., strain: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: BenchPoint(pressure_kpa=0.0, strain=0.0)."""

class Certificate:
    """What an independent second look at a plan found."""
    @property
    def certified(self) -> bool:
        """Whether nothing is wrong: failures is empty."""
    @property
    def failures(self) -> list[CertificateFailure]:
        """List of CertificateFailure; empty: certified."""
    @property
    def clearance_m(self) -> float:
        """Smallest distance of the moving arm from an obstacle, a lower bound [m]; negative: how deep; inf without obstacles; NaN: not checked."""
    @property
    def max_deviation_m(self) -> float:
        """Largest distance of a plate between the certificate's own simulation and the plan [m]; up to 1e-4 is allowed."""
    @property
    def cost_kpa(self) -> float:
        """Sum of |dp| over segments and frames [kPa]."""
    @property
    def goal_distance_m(self) -> float:
        """Of the tip from the goal's centre after the hold, by its own simulation [m]; NaN: not checked."""
    @property
    def goal_orientation_rad(self) -> float:
        """Difference of the tip's heading from the goal's after the hold [rad], 0 to pi; 0 where the goal has no heading."""
    @property
    def frames(self) -> int:
        """Frames of the plan, T."""
    @property
    def clearance_frame(self) -> int:
        """Frame that the motion with the smallest clearance leads to, from 0, the start; -1: none."""
    @property
    def clearance_gap(self) -> int:
        """Where on the arm it is smallest: between plates gap and gap + 1; -1: nowhere."""
    @property
    def clearance_obstacle(self) -> int:
        """Index of that obstacle in the environment's list, from 0; -1: none."""
    @property
    def max_step_kpa(self) -> float:
        """Largest change of a set point in one frame [kPa]."""
    @property
    def max_pressure_deviation_kpa(self) -> float:
        """Largest difference of a pressure between its own valves and the plan [kPa]; up to 1e-3 is allowed."""
    @property
    def unfinished(self) -> bool:
        """Whether it was given up before the end; what was not checked has no figure."""

class CertificateFailure:
    """One thing that is wrong with a plan, and in which frame."""
    @property
    def check(self) -> str:
        """"limits", "rate", "start", "waypoints", "cost", "hold", "valves", "model", "collision", "goal", "claims", "tube", "seal", "sizes" or "unfinished"."""
    @property
    def frame(self) -> int:
        """The first frame that fails, from 0; -1: no frame is to blame."""
    @property
    def message(self) -> str:
        """What is wrong, a sentence with numbers."""

class CertifiedFigures:
    """What its certificate said of a plan."""
    @property
    def clearance_m(self) -> float:
        """Smallest distance of the moving arm from an obstacle [m]; inf without obstacles."""
    @property
    def max_deviation_m(self) -> float:
        """Largest distance of a plate between the certificate's simulation and the plan [m]."""
    @property
    def seal_is_intact(self) -> bool:
        """False where the plan's file was changed since it was certified."""

class Certifier:
    """Certifies plans for one problem with nothing of the planner's. Constant: share it freely."""
    @property
    def environment_hash(self) -> str:
        """environment_hash of the environment, which plans have to state."""
    def __init__(self, arm: ArmDescription, network: CompensationModel | None, valves: ValveParameters, environment: Environment) -> None:
        """network: a CompensationModel, None: the no-load model; valves: ValveParameters, ideal ones for a plan without valves. None of them is taken from a plan."""
    def certify(self, plan: Plan) -> Certificate:
        """The Certificate of one plan. Raises InputError where the plan was made for another arm, environment or valves; all else is a failure in the result. Ctrl-C raises KeyboardInterrupt."""

class CharacterisedArm:
    """An arm with fitted polynomials, and how well they fit."""
    @property
    def arm(self) -> ArmDescription:
        """The ArmDescription with the fitted polynomials."""
    @property
    def fits(self) -> list[StrainFit]:
        """List of StrainFit, one for each segment, base first."""

class Circle:
    """A round obstacle, solid; in frame B."""
    @property
    def x_m(self) -> float:
        """Centre, along the straight arm [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """Centre, to the left of the straight arm [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def radius_m(self) -> float:
        """Radius [m], > 0."""
    @radius_m.setter
    def radius_m(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., radius_m: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: Circle(x_m=0.0, y_m=0.0, radius_m=0.0)."""

class Clearance:
    """Smallest distance between the arm and an obstacle."""
    @property
    def value_m(self) -> float:
        """Distance [m]; negative: how deep the arm is in it; inf: no obstacles."""
    @property
    def gap(self) -> int:
        """Where on the arm: between plates gap and gap + 1; -1: nowhere."""
    @property
    def obstacle(self) -> int:
        """Index in the environment's list; -1: none."""

class ClosedLoop:
    """Leads the arm along its plan, and plans again from where it is measured, while it moves and after. One run."""
    def __init__(self, arm: ArmDescription, model: MotionModel, environment: Environment, room: ErrorRoom | None = None, seed: int = 1) -> None:
        """room: ErrorRoom that plans keep, None: error_room(model.forward); seed: of the searches. Raises InputError for a model without a network."""

class CollectionResult:
    """What `collect` recorded, and how long it took."""
    @property
    def recording(self) -> Recording:
        """The Recording, as in the file."""
    @property
    def kept_episodes(self) -> int:
        """Episodes that `resume` found finished."""
    @property
    def wall_time_s(self) -> float:
        """How long this run took [s]."""

class CollectionSettings:
    """How an arm is recorded by `collect`."""
    @property
    def schedule(self) -> ScheduleSettings:
        """ScheduleSettings: which motions."""
    @schedule.setter
    def schedule(self, value: ScheduleSettings) -> None: ...
    @property
    def seed(self) -> int:
        """Seed of the schedule's order."""
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def source(self) -> str:
        """What moves, in words; kept in the recording."""
    @source.setter
    def source(self, value: str) -> None: ...
    @property
    def driver(self) -> str:
        """Everything else that decides the data, such as noise, in words; kept in the recording."""
    @driver.setter
    def driver(self, value: str) -> None: ...
    @property
    def hold_limit_s(self) -> float:
        """A set point that is not reached by then is a SystemFault [s], >= hold_s."""
    @hold_limit_s.setter
    def hold_limit_s(self, value: float) -> None: ...
    @property
    def jobs(self) -> int:
        """Threads, 0: one per core; never changes a result."""
    @jobs.setter
    def jobs(self, value: int) -> None: ...
    @property
    def resume(self) -> bool:
        """Whether to go on from the finished episodes of an interrupted run."""
    @resume.setter
    def resume(self, value: bool) -> None: ...
    @property
    def force(self) -> bool:
        """Whether to replace the file if it exists; else that is an InputError."""
    @force.setter
    def force(self, value: bool) -> None: ...
    @property
    def progress(self) -> ProgressMode:
        """ProgressMode: whether progress goes to standard error."""
    @progress.setter
    def progress(self, value: ProgressMode) -> None: ...
    def __init__(self, *, schedule: ScheduleSettings = ..., seed: int = ..., source: str = ..., driver: str = ..., hold_limit_s: float = ..., jobs: int = ..., resume: bool = ..., force: bool = ..., progress: ProgressMode = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: CollectionSettings(schedule=ScheduleSettings(kind=<ScheduleKind.transitions: 0>, count=0, episodes=0, approach=<Approach.step: 0>, hold_s=3.0, limit_scale=1.0, hold_min_s=None), seed=1, source='virtual arm', driver='', hold_limit_s=15.0, jobs=0, resume=False, force=False, progress=<ProgressMode.automatic: 0>)."""

class CollisionChecker:
    """Collision of a thick backbone with obstacles. Constant: share it."""
    @property
    def obstacle_count(self) -> int:
        """Number of obstacles."""
    @property
    def gap_count(self) -> int:
        """Spaces between plates, m - 1."""
    def __init__(self, arm: ArmDescription, environment: Environment, margin_m: float = 0.0) -> None:
        """margin_m: added to the arm's radius everywhere [m], >= 0."""
    def clearance(self, backbone: npt.ArrayLike) -> Clearance:
        """Clearance of one backbone, float32 (m, 3), less the margin."""
    def is_free(self, backbone: npt.ArrayLike) -> bool:
        """Whether nothing touches the arm: of one backbone, float32 (m, 3)."""
    def is_motion_free(self, from_backbone: npt.ArrayLike, to_backbone: npt.ArrayLike) -> bool:
        """Whether the arm stays free while every plate moves straight from one backbone, float32 (m, 3), to the other."""

class Command:
    """What a segment is told. Of another command than a pressure, names that end in _kpa hold numbers in this unit."""
    @property
    def name(self) -> str:
        """"pressure", or what else segments are told, such as "motor angle"."""
    @property
    def unit(self) -> str:
        """"kPa", or the unit of that other command, such as "rad"."""

class CompensationModel:
    """The network with everything needed to use it."""
    @property
    def layers(self) -> list[Layer]:
        """List of Layer of the leading network; no copies."""
    @property
    def member_count(self) -> int:
        """Networks of the ensemble, 1 where it is none."""
    @property
    def shape(self) -> str:
        """Sizes of the layers, inputs first: "102-100-100-100-48"."""
    @property
    def arm_name(self) -> str:
        """Name of the arm that it was trained for."""
    @property
    def arm_hash(self) -> str:
        """ArmDescription.hash() of that arm."""
    @property
    def preset(self) -> str:
        """Preset it was trained by: "paper" or "best"."""
    @property
    def reads_velocity(self) -> bool:
        """Whether it reads how the backbone changed in the frame before."""
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
        """ValveParameters between set points and pressures of the recordings, or None; can be set."""
    @valves.setter
    def valves(self, value: ValveParameters | None) -> None: ...
    @property
    def valve_findings(self) -> ValveFindings:
        """ValveFindings: how its valves were found, or why there are none."""
    @property
    def prediction_error(self) -> PredictionError | None:
        """PredictionError on motions that it has not seen, as note_unseen stores it; or None."""
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
        """Stores valves and how they were found. identified: IdentifiedValves, as identify_valves returns them."""

class Contact:
    """The arm near or in an obstacle at one moment."""
    @property
    def time_s(self) -> float:
        """Since the run began [s]."""
    @property
    def clearance(self) -> Clearance:
        """Clearance: how near, where on the arm, and to which obstacle."""

class DriverFactory:
    """Makes a virtual arm for each episode; virtual_arm_factory returns one."""

class Environment:
    """What a plan is made for: obstacles, start and goal, in frame B. Plans borrow it, so it does not change."""
    @property
    def name(self) -> str:
        """Its name, as its file has it."""
    @property
    def obstacles(self) -> list[Circle | Rectangle | Polygon]:
        """List of Circle, Rectangle and Polygon, obstacle 0 first; copies, whose fields can't be set."""
    @property
    def goal(self) -> PoseGoal:
        """Where the tip shall end, a PoseGoal; a copy, whose fields can't be set."""
    @property
    def start(self) -> ArmStart | None:
        """ArmStart, or None: at rest, straight and without pressure."""
    def __init__(self, name: str, obstacles: Sequence[Circle | Rectangle | Polygon], goal: PoseGoal, start: ArmStart | None = None) -> None:
        """Checked as a file is: raises InputError naming the field. obstacles: a list of Circle, Rectangle and Polygon, which messages and results count from 0; goal: a PoseGoal; start: an ArmStart, None: straight and without pressure."""
    def _repr_svg_(self) -> str: ...

class Episode:
    """One unbroken run of the arm: T frames, n segments, m plates. Its arrays are views of limber's own memory."""
    @property
    def time_s(self) -> npt.NDArray[np.float64]:
        """Time of each frame, float64 (T,) [s], increasing."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Measured, float32 (T, n) [kPa], positive bends right; the set points, where nothing was measured."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """Set points that were commanded, float32 (T, n) [kPa], positive bends right."""
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
    def physics(self) -> str:
        """JSON of what a varied virtual arm has other than its file (limber collect --vary-physics); '' otherwise."""
    @property
    def log(self) -> str:
        """File name of the log that it was imported from; '' where there is none."""
    @property
    def frame_count(self) -> int:
        """T: number of frames."""
    @property
    def untracked_count(self) -> int:
        """Number of frames without a measured backbone."""
    def __init__(self, time_s: npt.ArrayLike, pressure_kpa: npt.ArrayLike, setpoint_kpa: npt.ArrayLike, backbone: npt.ArrayLike, motion_index: npt.ArrayLike, tracked: npt.ArrayLike | None = None, setpoints_only: bool = False, physics: str = '') -> None:
        """Copies its arrays once: time_s (T,) [s], pressure_kpa and setpoint_kpa (T, n) [kPa], backbone (T, m, 3) in frame B, motion_index (T,), and tracked (T,) or None: all frames. With setpoints_only, pressure_kpa has to be setpoint_kpa. Raises InputError naming the array whose shape does not fit."""
    def __len__(self) -> int: ...

class EpisodeErrors:
    """The simple model's error in every episode."""
    @property
    def outliers(self) -> list[int]:
        """Numbers of the broken episodes, from 0, rising; never one of fewer than 5 episodes."""
    @property
    def median_cm(self) -> float:
        """Middle one of the episodes' errors at the tip [cm]."""
    @property
    def limit_cm(self) -> float:
        """An episode with a larger error is an outlier [cm]; inf for fewer than 5 episodes."""
    @property
    def tip_cm(self) -> list[float]:
        """Mean error of each episode at the tip, a list [cm]; NaN where nothing was tracked."""
    def __str__(self) -> str: ...

class ErrorRoom:
    """What plans keep in hand for the model's error."""
    @property
    def margin_m(self) -> float:
        """Clearance from obstacles [m], >= 0; of a tube its largest radius."""
    @property
    def goal_margin(self) -> PoseError:
        """PoseError: how far inside the goal's tolerances plans end."""
    @property
    def tube(self) -> PlanTube | None:
        """PlanTube of a calibrated model, or None."""
    @property
    def margin_yields_to_start(self) -> bool:
        """Whether an arm that starts nearer to an obstacle than margin_m keeps only the clearance that it starts with, instead of having no plan. True unless margin_m was given."""
    @property
    def note(self) -> str:
        """Why the amounts were not measured, and what to do about it; empty where they were."""

class ErrorStatistics:
    """Errors over frames, in the unit of the field that holds them; NaN where there is no frame."""
    @property
    def mean(self) -> float:
        """Mean over frames."""
    @property
    def std(self) -> float:
        """Standard deviation over frames."""
    @property
    def p95(self) -> float:
        """95th percentile over frames."""
    @property
    def worst_motion(self) -> float:
        """Largest mean over the frames of one motion."""

class Evaluation:
    """Errors of models on one recording."""
    @property
    def frames(self) -> int:
        """Frames that count: tracked, and not the first of an episode."""
    @property
    def no_load_open_loop(self) -> TipErrors:
        """TipErrors of the no-load model, never corrected."""
    @property
    def network(self) -> RolloutErrors | None:
        """RolloutErrors of the network, or None where none was given."""
    @property
    def position_reduction_percent(self) -> float:
        """How much smaller the network's open-loop error of position is than the no-load model's [%]."""
    @property
    def orientation_reduction_percent(self) -> float:
        """The same of headings [%]."""
    @property
    def novel(self) -> NovelFrames | None:
        """NovelFrames of the network, or None where it does not know what it learnt from."""
    def __str__(self) -> str: ...
    def _repr_svg_(self) -> str: ...

class ExecutedError:
    """Distance between predicted and executed tip."""
    @property
    def mean_m(self) -> float:
        """Mean distance over the plan's frames [m]."""
    @property
    def before_hold_m(self) -> float:
        """Mean distance before the plan's hold, while it moves [m]."""
    @property
    def max_m(self) -> float:
        """Largest distance [m]."""
    @property
    def final_m(self) -> float:
        """Distance at the plan's last frame [m]."""

class ExecutionResult:
    """What came of executing a plan."""
    @property
    def status(self) -> ExecutionStatus:
        """ExecutionStatus: how the run ended."""
    @property
    def message(self) -> str:
        """Why it did not arrive: what ended it, or what it missed or struck; else empty."""
    @property
    def frames(self) -> int:
        """Number of set points commanded, those of the hold included."""
    @property
    def frames_not_seen(self) -> int:
        """Number of them after which the arm was not tracked."""
    @property
    def goal_reached(self) -> bool | None:
        """Whether the tip was in the goal after the hold, or None: not tracked in the last 0.25 s."""
    @property
    def goal_error(self) -> PoseError | None:
        """PoseError of the tip after the hold, or None: not tracked in the last 0.25 s."""
    @property
    def collided(self) -> bool | None:
        """Whether the arm touched an obstacle, or None: not tracked in the last 0.25 s."""
    @property
    def prediction(self) -> ExecutedError | None:
        """ExecutedError between plan and arm, or None where nothing was tracked."""
    @property
    def replans(self) -> int:
        """Number of plans after the first."""
    @property
    def halts(self) -> int:
        """Number of plans that were left before their end."""
    @property
    def frames_not_certified(self) -> int:
        """Frames in which nothing was certified from where the arm was."""
    @property
    def open_loop_goal_error(self) -> PoseError | None:
        """PoseError where the first plan's hold ended, if more followed; or None."""
    @property
    def start_error_m(self) -> float:
        """Largest distance of a plate from where the plan starts, before the first set point [m]."""
    @property
    def first_collision(self) -> Contact | None:
        """Contact when it first touched an obstacle, or None."""
    @property
    def closest(self) -> Contact | None:
        """Contact where the arm came nearest to an obstacle, or None: no obstacles, or not tracked in the last 0.25 s."""
    @property
    def final_backbone(self) -> npt.NDArray[np.float32] | None:
        """Shape after the hold, float32 (m, 3), or None: not tracked in the last 0.25 s."""
    @property
    def episode(self) -> Episode:
        """Episode of what was commanded and measured, time 0 being the start."""
    def _repr_svg_(self) -> str | None: ...

class ExecutionSettings:
    """How a plan is executed."""
    @property
    def hold_s(self) -> float:
        """How long the last set point is held, the plan's own hold counted [s], >= 0; then the goal is judged."""
    @hold_s.setter
    def hold_s(self, value: float) -> None: ...
    def __init__(self, *, hold_s: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: ExecutionSettings(hold_s=1.0)."""

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
        """When it was certified, since the search began [s]."""
    @property
    def cost_kpa(self) -> float:
        """Its cost, the sum of |dp| [kPa]."""
    @property
    def queries(self) -> int:
        """Queries of the forward model until it was found."""
    @property
    def candidate_s(self) -> float:
        """When it was found, since the search began [s]."""
    @property
    def certificate_s(self) -> float:
        """What building and certifying it then took [s]."""

class FirstWeights:
    """What weights are before training."""
    he: FirstWeights
    torch: FirstWeights
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class ForwardModel:
    """B_t = F(q_(t-1), q_t, B_(t-1)): the no-load model, or the no-load model compensated by a network. A pure function: any number of threads may share it."""
    @property
    def segment_count(self) -> int:
        """n: segments of the arm."""
    @property
    def point_count(self) -> int:
        """m: plates of the arm, base included."""
    @property
    def has_network(self) -> bool:
        """Whether it has a network."""
    @property
    def reads_velocity(self) -> bool:
        """Whether its network reads how the backbone changed in the frame before, and so wants to be told `before`."""
    @property
    def no_load(self) -> NoLoadModel:
        """The NoLoadModel that the network compensates."""
    @property
    def compensation(self) -> CompensationModel:
        """The CompensationModel, or None: the no-load model alone."""
    def __init__(self, arm: ArmDescription, compensation: CompensationModel | None = None) -> None:
        """compensation: a CompensationModel, None: the no-load model alone. Raises InputError where it was trained for another arm."""
    def step(self, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None, before: npt.ArrayLike | None = None) -> npt.NDArray[np.float32]:
        """One query: pressures a frame ago and now, float32 (n,) and (n,) [kPa], and the backbone a frame ago (m, 3) give the backbone now (m, 3). It is written to `out` where one is given, which may be `previous`. `before` is the backbone two frames ago (m, 3), for models of which reads_velocity says so; None: the arm stood still. Raises InputError for a wrong shape, NaN or infinity."""
    def checked_step(self, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, before: npt.ArrayLike | None = None) -> npt.NDArray[np.float32]:
        """One query: float32 (n,), (n,) [kPa] and (m, 3) give (m, 3); pressures beyond their limits are refused too. `before` as in step."""
    def step_batch(self, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None, before: npt.ArrayLike | None = None) -> npt.NDArray[np.float32]:
        """k queries: float32 (k, n), (k, n) [kPa] and (k, m, 3) give (k, m, 3), each row to the bit what step gives. `out` may be `previous` or `before`, (k, m, 3) as in step."""
    def rollout(self, pressures_kpa: npt.ArrayLike, first: npt.ArrayLike) -> npt.NDArray[np.float32]:
        """Feeds its own output back: pressures float32 (T, n) [kPa] from backbone `first` (m, 3), where the arm stood still, give (T, m, 3), row 0 being `first`."""

class GapBounds:
    """What predictions keep the shape of every gap between two plates within: float32 (m - 1,) each, base first; views of limber's memory."""
    @property
    def min_length_m(self) -> npt.NDArray[np.float32]:
        """Shortest distance of the two plates, float32 (m - 1,) [m]."""
    @property
    def max_length_m(self) -> npt.NDArray[np.float32]:
        """Longest distance of the two plates, float32 (m - 1,) [m]."""
    @property
    def min_turn_rad(self) -> npt.NDArray[np.float32]:
        """Smallest turn from one plate to the next, signed, float32 (m - 1,) [rad]."""
    @property
    def max_turn_rad(self) -> npt.NDArray[np.float32]:
        """Largest turn from one plate to the next, signed, float32 (m - 1,) [rad]."""

class IdentifiedValves:
    """Valves and how they were found."""
    @property
    def parameters(self) -> ValveParameters:
        """ValveParameters; ideal where findings.reason says why."""
    @parameters.setter
    def parameters(self, value: ValveParameters) -> None: ...
    @property
    def findings(self) -> ValveFindings:
        """ValveFindings: how well the parameters fit."""
    @findings.setter
    def findings(self, value: ValveFindings) -> None: ...
    def __init__(self, *, parameters: ValveParameters = ..., findings: ValveFindings = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: IdentifiedValves(parameters=ValveParameters(has_sides=True, segments=[]), findings=ValveFindings(source='', held_back=ValveErrors(mean_kpa=0.0, p95_kpa=0.0, max_kpa=0.0, frames=0), from_setpoints=ValveErrors(mean_kpa=0.0, p95_kpa=0.0, max_kpa=0.0, frames=0), reason='', warnings=[]))."""

class ImportResult:
    """A recording, and what was done to its logs."""
    @property
    def recording(self) -> Recording:
        """The Recording of all logs, an episode for each unbroken run."""
    @property
    def report(self) -> str:
        """Everything that was dropped or changed, a text with a part for each log."""

class InputError(ValueError):
    """A mistake of the caller or of a file: what was found, where, and what is allowed."""

class Interrupted(RuntimeError):
    """Work stopped because it was asked to; what was written is valid."""

class InverseKinematicsResult:
    """What was found; that there is no solution is no error, and raises nothing."""
    @property
    def pressures_kpa(self) -> npt.NDArray[np.float64]:
        """Solutions, float64 (k, n) [kPa], in the order found."""
    @property
    def best_pressures_kpa(self) -> npt.NDArray[np.float64]:
        """The nearest configuration of all starts, float64 (n,) [kPa]."""
    @property
    def best_error(self) -> PoseError:
        """PoseError of best_pressures_kpa: how far they miss the goal's centre."""
    @property
    def starts_used(self) -> int:
        """Number of starts that were tried."""
    @property
    def reason(self) -> str:
        """Why there is no solution; empty where there is one."""
    @property
    def reachable(self) -> bool:
        """Whether there is at least one solution."""

class InverseKinematicsSettings:
    """How long solutions are looked for."""
    @property
    def starts(self) -> int:
        """Random configurations to start from, >= 1."""
    @starts.setter
    def starts(self, value: int) -> None: ...
    @property
    def max_solutions(self) -> int:
        """The search stops at so many solutions, >= 1."""
    @max_solutions.setter
    def max_solutions(self, value: int) -> None: ...
    @property
    def iterations(self) -> int:
        """Largest number of Newton steps from each start, >= 1."""
    @iterations.setter
    def iterations(self, value: int) -> None: ...
    @property
    def convergence_m(self) -> float:
        """A start is done when the tip is this near to the goal [m], > 0."""
    @convergence_m.setter
    def convergence_m(self, value: float) -> None: ...
    @property
    def distinct_pressure_kpa(self) -> float:
        """Solutions differ by more than this in some segment [kPa], >= 0."""
    @distinct_pressure_kpa.setter
    def distinct_pressure_kpa(self, value: float) -> None: ...
    def __init__(self, *, starts: int = ..., max_solutions: int = ..., iterations: int = ..., convergence_m: float = ..., distinct_pressure_kpa: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: InverseKinematicsSettings(starts=40, max_solutions=8, iterations=60, convergence_m=1e-10, distinct_pressure_kpa=1.0)."""

class Layer:
    """One layer, y = W x + b, with ReLU behind every layer but the last."""
    @property
    def weight(self) -> npt.NDArray[np.float32]:
        """W, float32 (outputs, inputs); a view of limber's memory."""
    @property
    def bias(self) -> npt.NDArray[np.float32]:
        """b, float32 (outputs,); a view of limber's memory."""

class LearningCurvePoint:
    """One row of the learning curve."""
    @property
    def epoch(self) -> int:
        """Number of the epoch, from 1."""
    @property
    def window_frames(self) -> int:
        """Frames of its windows."""
    @property
    def learning_rate(self) -> float:
        """Step size of its first batch."""
    @property
    def loss(self) -> float:
        """Mean error of a frame, in normalised units."""
    @property
    def validation_position_error_cm(self) -> float:
        """Mean distance of the tip over open-loop rollouts of up to 600 frames [cm]; NaN where not measured."""
    @property
    def elapsed_s(self) -> float:
        """Since training began [s]."""

class LearntRegion:
    """What the training recordings held: ranges of pressures [kPa], of their rates [kPa/s], and of shapes."""

class LongRollout:
    """How far a model drifts if it is never corrected."""
    @property
    def frames(self) -> int:
        """Number of frames that were rolled out."""
    @property
    def max_distance_m(self) -> float:
        """Largest distance of a plate from the base [m]."""
    @property
    def max_heading_rad(self) -> float:
        """Largest heading of a plate, in magnitude [rad]."""
    @property
    def bounded(self) -> bool:
        """Whether no plate was farther from the base than twice the arm's length, and bounds held a gap in at most a tenth of the frames."""
    @property
    def held_share(self) -> float:
        """Share of the frames in which GapBounds held a gap, 0 to 1."""

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
        """The ForwardModel behind the valves."""
    @property
    def valves(self) -> ValveModel:
        """The ValveModel, ideal where none was given."""
    @property
    def segment_count(self) -> int:
        """n: segments of the arm."""
    @property
    def point_count(self) -> int:
        """m: plates of the arm, base included."""
    @property
    def has_network(self) -> bool:
        """Whether the forward model has a network."""
    def __init__(self, forward: ForwardModel, valves: ValveModel | None = None) -> None:
        """forward: a ForwardModel; valves: a ValveModel, None: pressures are the set points."""
    def settled_state(self, kpa: npt.ArrayLike, backbone: npt.ArrayLike) -> MotionState:
        """MotionState of an arm that has long stood at pressures (n,) [kPa] with backbone (m, 3)."""
    def step(self, setpoint_kpa: npt.ArrayLike, state: MotionState) -> None:
        """One frame at set points float32 (n,) [kPa]: `state` becomes what follows it."""

class MotionState:
    """Everything that decides an arm's future under set points."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Pressures now, float32 (n,) [kPa]; a copy."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """The last set points, float32 (n,) [kPa]; a copy."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """Shape now, float32 (m, 3): x_m, y_m, theta_rad of each plate; a copy."""
    def copy(self) -> MotionState:
        """Another MotionState that is equal and independent."""
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
        """n: segments of the arm."""
    @property
    def point_count(self) -> int:
        """m: plates of the arm, base included."""
    def __init__(self, arm: ArmDescription) -> None:
        """The simple model of an arm."""
    def backbone(self, pressures_kpa: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None) -> npt.NDArray[np.float32]:
        """Backbone at pressures [kPa]: float32 (n,) gives (m, 3), rows x_m, y_m, theta_rad from base to tip; (k, n) gives (k, m, 3). Written to `out` where one is given."""
    def segment_shape(self, segment: int, pressure_kpa: float) -> SegmentShape:
        """Curvature and length of one segment under a pressure: docs/model.md, (3) and (4). segment: 0 at the base; pressure_kpa: signed [kPa]. Raises IndexError for a segment that there is not."""
    def pressure_for_curvature(self, segment: int, curvature_per_m: float) -> SegmentPressure:
        """Pressure that bends a segment as wanted, the inverse of segment_shape: (11). curvature_per_m: positive bends left [1/m]. Beyond the limit: reachable is False."""
    def curvature_limit_per_m(self, segment: int) -> float:
        """Largest curvature that the pressure limit of a segment allows, in magnitude [1/m]."""

class NovelFrames:
    """Tracked frames, and how many of them lie beyond what a model learnt from, by whether their pressures do."""
    @property
    def pressures_within(self) -> NovelFramesCount:
        """NovelFramesCount of frames whose pressures are within the recorded ranges."""
    @property
    def pressures_beyond(self) -> NovelFramesCount:
        """NovelFramesCount of frames whose pressures are beyond them."""

class NovelFramesCount:
    """So many frames of NovelFrames, and so many of them novel."""
    @property
    def frames(self) -> int:
        """Number of frames."""
    @property
    def novel(self) -> int:
        """Frames beyond what the model learnt from."""

class Optimiser:
    """How weights are changed."""
    sgd: Optimiser
    adam: Optimiser
    soap: Optimiser
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
        """Number of threads."""
    def __init__(self, jobs: int = 0) -> None:
        """jobs: threads, 0: one per core; never changes a result."""
    def step_batch(self, model: ForwardModel, previous_kpa: npt.ArrayLike, current_kpa: npt.ArrayLike, previous: npt.ArrayLike, out: npt.NDArray[np.float32] | None = None, before: npt.ArrayLike | None = None) -> npt.NDArray[np.float32]:
        """ForwardModel.step_batch, in parts of some hundred queries: float32 (k, n), (k, n) [kPa] and (k, m, 3) give (k, m, 3). `before` as in ForwardModel.step."""

class Plan:
    """A motion in pressure space. Frame 0 is the start; the set points of frame k are commanded at (k - 1) / frame_rate_hz. Its frames are executed as they stand, never resampled."""
    @property
    def arm_name(self) -> str:
        """Name of the arm that it was made for."""
    @property
    def model(self) -> str:
        """"no_load" or "network": what predicted it."""
    @property
    def environment_name(self) -> str:
        """Name of the environment that it was made for."""
    @property
    def planner(self) -> str:
        """Name of the planner that made it, as make_planner knows it."""
    @property
    def seed(self) -> int:
        """Seed of the search that made it."""
    @property
    def frame_count(self) -> int:
        """T: frames, start and hold included."""
    @property
    def duration_s(self) -> float:
        """Time of the last frame, hold included [s]."""
    @property
    def cost_kpa(self) -> float:
        """Sum of |dp| over segments and frames [kPa]."""
    @property
    def clearance_m(self) -> float:
        """Smallest predicted distance from an obstacle [m], of the tube where there is one; inf without obstacles."""
    @property
    def goal_distance_m(self) -> float:
        """Predicted distance of the tip from the goal's centre after the hold [m]."""
    @property
    def model_hash(self) -> str:
        """content_hash of the model's file; empty for the no-load model."""
    @model_hash.setter
    def model_hash(self, value: str) -> None: ...
    @property
    def arm_hash(self) -> str:
        """ArmDescription.hash() of the arm."""
    @property
    def valves_hash(self) -> str:
        """ValveParameters.hash() of the valves; empty: planned without valves."""
    @property
    def environment_hash(self) -> str:
        """environment_hash() of the environment."""
    @property
    def margin_m(self) -> float:
        """Clearance from obstacles that was asked for [m]."""
    @property
    def tube(self) -> PlanTube | None:
        """PlanTube that it keeps free of obstacles, or None."""
    @property
    def frame_rate_hz(self) -> float:
        """Frames per second [Hz]."""
    @property
    def hold_frame_count(self) -> int:
        """Number of last frames, which repeat the final set point."""
    @property
    def goal_orientation_rad(self) -> float:
        """Predicted difference of the tip's heading from the goal's after the hold [rad]; 0 where the goal has none."""
    @property
    def program_version(self) -> str:
        """Version of limber that made it."""
    @property
    def certified(self) -> CertifiedFigures | None:
        """CertifiedFigures, or None: not certified."""
    @property
    def waypoints_kpa(self) -> npt.NDArray[np.float32]:
        """Set points that it goes straight between, the start first, float32 (w, n) [kPa]; a copy."""
    @property
    def setpoint_kpa(self) -> npt.NDArray[np.float32]:
        """Set points to command, float32 (T, n) [kPa], positive bends right; a copy."""
    @property
    def pressure_kpa(self) -> npt.NDArray[np.float32]:
        """Pressures predicted from them, float32 (T, n) [kPa]; a copy."""
    @property
    def backbone(self) -> npt.NDArray[np.float32]:
        """Predicted shapes, float32 (T, m, 3): x_m, y_m, theta_rad of each plate; a copy."""
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
    """What came of planning; no plan is no error. A notebook draws it."""
    @property
    def status(self) -> PlanStatus:
        """PlanStatus; a plan is there only where it is PlanStatus.solved."""
    @property
    def reason(self) -> str:
        """What ended the search or what is wrong with the problem, a sentence."""
    @property
    def plan(self) -> Plan | None:
        """The certified Plan, or None unless status is solved."""
    @property
    def limit(self) -> PlanLimit | None:
        """PlanLimit that ended the search, or None."""
    @property
    def warnings(self) -> list[str]:
        """What to know before the plan is used, a list of sentences."""
    @property
    def statistics(self) -> PlannerStatistics:
        """PlannerStatistics: what the search took."""
    @property
    def best_partial(self) -> Plan | None:
        """Where there is no plan, the motion that came nearest; never a solution."""
    @property
    def certificate(self) -> Certificate | None:
        """Certificate of the plan, or None."""
    @property
    def first_solution(self) -> FirstSolution | None:
        """FirstSolution: when there was a plan for the first time, or None."""
    @property
    def max_clearance_m(self) -> float | None:
        """What a plan keeps that was found with less clearance [m], or None."""
    @property
    def events(self) -> list[PlannerProgress]:
        """List of PlannerProgress: the first plan, each notably cheaper one, and the end; empty without a plan."""
    @property
    def tree(self) -> npt.NDArray[np.float32]:
        """Tips of nodes and their parents, float32 (edges, 2, 2) [m]."""
    def _repr_svg_(self) -> str | None: ...

class PlanStatus:
    """What came of planning, or what is wrong with the problem."""
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
        """Share of runs that stay in the tube, in (0, 1)."""
    @property
    def plate_radius_m(self) -> list[float]:
        """How far each plate may be from its prediction, m numbers, base first [m]."""
    @property
    def end_radius_m(self) -> float:
        """How far the tip may be after the hold [m], >= 0."""
    @property
    def end_heading_rad(self) -> float:
        """How far the tip's heading may be off after the hold [rad], >= 0."""
    @property
    def start_share(self) -> float:
        """Share of its radius that a plate has where it starts, in (0, 1]."""
    @property
    def full_after_m(self) -> float:
        """Distance from there at which it has all of it [m]; 0: everywhere."""
    @property
    def goal_inside(self) -> bool:
        """Of a plan: whether its end lies so far inside the goal."""

class Planner:
    """A planner in pressure space: one caller at a time."""
    @property
    def name(self) -> str:
        """Its name, a text that make_planner takes."""
    def plan(self, problem: PlanningProblem, limits: PlannerLimits, seed: int, callback: Callable[[PlannerProgress], bool | None] | None = None) -> PlanResult:
        """Searches; the plan is certified. `callback(progress)` comes about ten times per second; False stops the search. Ctrl-C ends it with KeyboardInterrupt. With limits of iterations or queries alone the seed decides everything."""

class PlannerLimits:
    """When to stop; whichever comes first. At least one of time_s, iterations and queries has to be set, or `plan` raises InputError. When a limit is reached, the best plan so far is the result; without one, status is PlanStatus.limit, and PlanResult.limit says which."""
    @property
    def time_s(self) -> float | None:
        """Time [s], > 0; the search ends within 50 ms of it. The plan then depends on the machine. None: no limit."""
    @time_s.setter
    def time_s(self, value: float | None) -> None: ...
    @property
    def iterations(self) -> int | None:
        """Samples, >= 1. With this limit alone a run can be repeated. OMPL's planners count neither these nor memory, and say so. None: no limit."""
    @iterations.setter
    def iterations(self, value: int | None) -> None: ...
    @property
    def queries(self) -> int | None:
        """Queries of the forward model by the search, >= 1, looked at after each round. PlannerStatistics.queries may be more. None: no limit."""
    @queries.setter
    def queries(self, value: int | None) -> None: ...
    @property
    def memory_mb(self) -> float | None:
        """Size of the search tree [MB], > 0. No limit by itself: another one is needed. None: no limit."""
    @memory_mb.setter
    def memory_mb(self, value: float | None) -> None: ...
    @property
    def cost_threshold_kpa(self) -> float | None:
        """The search ends with a plan that costs this or less [kPa], the sum of |dp| over segments and frames. None: it goes on to improve plans."""
    @cost_threshold_kpa.setter
    def cost_threshold_kpa(self, value: float | None) -> None: ...
    def __init__(self, *, time_s: float | None = ..., iterations: int | None = ..., queries: int | None = ..., memory_mb: float | None = ..., cost_threshold_kpa: float | None = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: PlannerLimits(time_s=None, iterations=None, queries=None, memory_mb=None, cost_threshold_kpa=None)."""

class PlannerProgress:
    """How far a search is."""
    @property
    def time_s(self) -> float:
        """Since the search began [s]."""
    @property
    def iterations(self) -> int:
        """Samples so far."""
    @property
    def nodes(self) -> int:
        """Nodes of the search tree."""
    @property
    def queries(self) -> int:
        """Queries of the forward model by the search so far."""
    @property
    def best_cost_kpa(self) -> float | None:
        """Cost of the cheapest plan so far [kPa]; None before the first."""

class PlannerStatistics:
    """What a search took."""
    @property
    def time_s(self) -> float:
        """Time of the whole search [s]."""
    @property
    def iterations(self) -> int:
        """Samples that were drawn."""
    @property
    def queries(self) -> int:
        """All queries of the forward model. More than PlannerLimits.queries, which is for the search alone: also the plan's last simulation and, of an ensemble, the other networks, which judge every plan."""
    @property
    def nodes(self) -> int:
        """Nodes of the search tree."""

class PlanningProblem:
    """What is to be solved; it keeps arm, model and environment alive."""
    @property
    def margin_m(self) -> float:
        """Clearance kept from every obstacle [m], >= 0."""
    @property
    def goal_margin(self) -> PoseError:
        """PoseError: how far inside the goal's tolerances plans end, room for the model's error."""
    @property
    def tube(self) -> PlanTube | None:
        """PlanTube that plans keep free of obstacles beside the margin, or None."""
    def __init__(self, arm: ArmDescription, model: MotionModel, environment: Environment, margin_m: float = 0.0, goal_margin: PoseError = ..., stay_within: RecordedRegion | None = None, margin_yields_to_start: bool = False, limits_kpa: Sequence[tuple[float, float]] = ..., tube: PlanTube | None = None) -> None:
        """margin_m: clearance kept from obstacles [m], >= 0; goal_margin: how far inside the goal's tolerances plans end; stay_within: a RecordedRegion that plans stay in, None: anywhere; margin_yields_to_start: see ErrorRoom; limits_kpa: (lower, upper) of each segment, within the arm's, empty: the arm's; tube: kept free beside the margin. Planning raises InputError where one is out of range."""

class Polygon:
    """A simple polygon, convex or not; the inside is solid."""
    @property
    def points_m(self) -> npt.NDArray[np.float64]:
        """Corners x_m, y_m in order, float64 (k, 2) [m]; a copy."""
    def __init__(self, points_m: npt.ArrayLike) -> None:
        """Corners x_m, y_m in order, (k, 2) [m], 3 to 1000 of them."""

class Pose:
    """A pose in the arm's plane, in frame B: the base is at the origin, x runs along the straight arm, y to its left."""
    @property
    def x_m(self) -> float:
        """Along the straight arm, from the base [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """To the left of the straight arm [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def theta_rad(self) -> float:
        """Heading [rad], counter-clockwise from x, unwrapped: it may exceed pi."""
    @theta_rad.setter
    def theta_rad(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., theta_rad: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: Pose(x_m=0.0, y_m=0.0, theta_rad=0.0)."""

class PoseError:
    """How far a pose is from a goal's centre, or how far inside its tolerances."""
    @property
    def position_m(self) -> float:
        """Distance [m], >= 0."""
    @position_m.setter
    def position_m(self, value: float) -> None: ...
    @property
    def orientation_rad(self) -> float:
        """Difference of the headings [rad], 0 to pi; 0 where the goal has no heading."""
    @orientation_rad.setter
    def orientation_rad(self, value: float) -> None: ...
    def __init__(self, *, position_m: float = ..., orientation_rad: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: PoseError(position_m=0.0, orientation_rad=0.0)."""

class PoseGoal:
    """A region of end-effector poses in frame B; without theta_rad any heading does."""
    @property
    def x_m(self) -> float:
        """Centre, along the straight arm [m]. It is beyond reach farther than the arm's length from the base."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """Centre, to the left of the straight arm [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def theta_rad(self) -> float | None:
        """Heading [rad], counter-clockwise from x, modulo a full turn; None: any heading will do."""
    @theta_rad.setter
    def theta_rad(self, value: float | None) -> None: ...
    @property
    def position_tolerance_m(self) -> float:
        """The tip is in the goal within this distance of its centre [m], > 0."""
    @position_tolerance_m.setter
    def position_tolerance_m(self, value: float) -> None: ...
    @property
    def orientation_tolerance_rad(self) -> float:
        """Largest difference of the heading [rad], > 0; unused without theta_rad."""
    @orientation_tolerance_rad.setter
    def orientation_tolerance_rad(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., theta_rad: float | None = ..., position_tolerance_m: float = ..., orientation_tolerance_rad: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: PoseGoal(x_m=0.0, y_m=0.0, theta_rad=None, position_tolerance_m=0.01, orientation_tolerance_rad=0.05)."""

class PredictionError:
    """How far predictions were from the arm on motions that neither trained nor chose the model, open loop. Each number is one that 95 % of the runs do not exceed."""
    @property
    def runs(self) -> int:
        """Number of runs that it was measured over, >= 1."""
    @property
    def run_s(self) -> float:
        """Mean length of a run [s]."""
    @property
    def max_position_m(self) -> float:
        """Largest distance of any plate from its prediction in a run [m]."""
    @property
    def off_path_m(self) -> float:
        """Largest distance of the arm from the predicted path in a run, early or late [m]."""
    @property
    def end_position_m(self) -> float:
        """Distance of the tip from its prediction at a run's end [m]."""
    @property
    def end_orientation_rad(self) -> float:
        """Difference of the tip's heading at a run's end [rad]."""

class ProcessDriver:
    """An arm behind a program of your own (docs/driver.md; limber.driver.serve makes one of Python), in a process that closes the valves whatever becomes of this one. One thread at a time; `with` closes it."""
    @property
    def limits_kpa(self) -> npt.NDArray[np.float32]:
        """In force, lower and upper, float32 (n, 2) [kPa]."""
    @property
    def is_real_time(self) -> bool:
        """Whether a frame takes its time: then a set point is due in each."""
    @property
    def vent_confirmed(self) -> bool:
        """Whether every measured pressure came down at the last vent."""
    def __init__(self, arm: ArmDescription, command: str, arm_file: str | os.PathLike[str] | None = None, limit_scale: float = 1.0, check_rate: bool = True, log: str | os.PathLike[str] | None = None, on_message: Callable[[str], None] | None = None, simulated: bool = False, calibration: str | os.PathLike[str] | None = None) -> None:
        """Starts "exec:COMMAND" without a shell, and vents. arm_file: its mapping `safety` counts; limit_scale: limits in force are so many times the arm's; check_rate: False where motions jump and the valves ramp by themselves; log: file of what both sides said; on_message(text): told what came of each vent, else standard error is; simulated: True where the driver may be a simulation, asked as fast as it answers; calibration: file of `limber driver calibrate`."""
    def state(self) -> ArmState:
        """The latest ArmState, as the driver measured it."""
    def command(self, setpoint_kpa: npt.ArrayLike) -> ArmState:
        """One frame at set points (n,) [kPa]; returns the ArmState after it. Who commands by hand vents by hand. Raises InputError for a set point beyond the limits, SystemFault where the driver fails."""
    def vent(self) -> None:
        """Opens every vent valve, and watches the pressures come down, 5 s at most."""
    def look(self) -> ArmState:
        """A fresh ArmState of the arm while it is vented."""
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
    def __init__(self, seed: int, stream: int = 0) -> None:
        """seed: >= 0; stream: >= 0, names the unit of work. Streams of one seed are independent."""
    def next_u32(self) -> int:
        """The next word, uniform over all 32-bit integers."""
    def uniform(self, low: float = 0.0, high: float = 1.0) -> float:
        """The next number, uniform in [low, high); both finite, low <= high."""
    def normal(self) -> float:
        """The next number, normal with mean 0 and standard deviation 1."""
    def position(self) -> int:
        """How far the stream is, in 32-bit words; seek goes there again."""
    def seek(self, position: int) -> None:
        """Goes on from a position, as `position` returned it."""

class RecordedRegion:
    """Judges whether motions stay within what the recordings held, for PlanningProblem(stay_within=...)."""
    def __init__(self, learnt: LearntRegion, frame_rate_hz: float) -> None:
        """learnt: LearntRegion, a model's model.learnt; frame_rate_hz: the arm's [Hz], > 0."""

class Recording:
    """Recorded motion of an arm: episodes of pressures and backbones."""
    @property
    def arm_name(self) -> str:
        """Name of the arm that moved."""
    @property
    def arm_hash(self) -> str:
        """ArmDescription.hash() of it."""
    @property
    def segment_count(self) -> int:
        """n: segments of that arm."""
    @property
    def point_count(self) -> int:
        """m: plates of that arm."""
    @property
    def rate_hz(self) -> float:
        """Frames per second [Hz]."""
    @property
    def seed(self) -> int:
        """Seed of its schedule and of noise; 0 for recordings of logs."""
    @property
    def source(self) -> str:
        """What moved, in words: "virtual arm", "motive log.csv", ..."""
    @property
    def settings(self) -> str:
        """How it was collected, in words; can be set."""
    @settings.setter
    def settings(self, value: str) -> None: ...
    @property
    def program_version(self) -> str:
        """Version of limber that wrote the file."""
    @property
    def episodes(self) -> list[Episode]:
        """List of Episode, its runs; no copies."""
    @property
    def setpoints_only(self) -> bool:
        """Nothing was measured in any of its episodes."""
    @property
    def frame_count(self) -> int:
        """Number of frames of all episodes."""
    @property
    def untracked_count(self) -> int:
        """Number of frames without a measured backbone."""
    @property
    def duration_s(self) -> float:
        """Length of all episodes together, frames / rate [s]."""

class Rectangle:
    """A rectangular obstacle at any angle, solid; in frame B."""
    @property
    def x_m(self) -> float:
        """Centre, along the straight arm [m]."""
    @x_m.setter
    def x_m(self, value: float) -> None: ...
    @property
    def y_m(self) -> float:
        """Centre, to the left of the straight arm [m]."""
    @y_m.setter
    def y_m(self, value: float) -> None: ...
    @property
    def width_m(self) -> float:
        """Size along its own x, which angle_rad turns [m], > 0."""
    @width_m.setter
    def width_m(self, value: float) -> None: ...
    @property
    def height_m(self) -> float:
        """Size along its own y, which angle_rad turns [m], > 0."""
    @height_m.setter
    def height_m(self, value: float) -> None: ...
    @property
    def angle_rad(self) -> float:
        """Turned counter-clockwise about its centre [rad]."""
    @angle_rad.setter
    def angle_rad(self, value: float) -> None: ...
    def __init__(self, *, x_m: float = ..., y_m: float = ..., width_m: float = ..., height_m: float = ..., angle_rad: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: Rectangle(x_m=0.0, y_m=0.0, width_m=0.0, height_m=0.0, angle_rad=0.0)."""

class Restart:
    """How often a prediction is corrected by what was recorded."""
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
    """TipErrors by how often a prediction is corrected by what was recorded."""
    @property
    def one_step(self) -> TipErrors:
        """TipErrors, corrected at every frame."""
    @property
    def window_32(self) -> TipErrors:
        """TipErrors, corrected every 32 frames."""
    @property
    def per_motion(self) -> TipErrors:
        """TipErrors, corrected at every motion's start."""
    @property
    def open_loop(self) -> TipErrors:
        """TipErrors, never corrected after the first frame: how good a plan is."""
    @property
    def open_loop_from_setpoints(self) -> TipErrors | None:
        """TipErrors, never corrected, and from set points through the model's valves; None where the model has none."""

class Scaling:
    """What the network's numbers are scaled to."""
    unit_range: Scaling
    unit_spread: Scaling
    shared_range: Scaling
    range_by_unit: Scaling
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
        """ScheduleKind: which motions."""
    @kind.setter
    def kind(self, value: ScheduleKind) -> None: ...
    @property
    def count(self) -> int:
        """Number of motions: in all for transitions, 0: every one; in each episode for random, >= 1."""
    @count.setter
    def count(self, value: int) -> None: ...
    @property
    def episodes(self) -> int:
        """Number of episodes; 0: 16 for transitions, 1 for random."""
    @episodes.setter
    def episodes(self, value: int) -> None: ...
    @property
    def approach(self) -> Approach:
        """Approach: how set points go to the next configuration."""
    @approach.setter
    def approach(self, value: Approach) -> None: ...
    @property
    def hold_s(self) -> float:
        """How long a motion's final set point is commanded [s], > 0."""
    @hold_s.setter
    def hold_s(self, value: float) -> None: ...
    @property
    def limit_scale(self) -> float:
        """Motions stay within so many times the arm's limits, in (0, 1]."""
    @limit_scale.setter
    def limit_scale(self, value: float) -> None: ...
    @property
    def hold_min_s(self) -> float | None:
        """Each hold is sampled between this and hold_s [s]; None: they are all hold_s."""
    @hold_min_s.setter
    def hold_min_s(self, value: float | None) -> None: ...
    def __init__(self, *, kind: ScheduleKind = ..., count: int = ..., episodes: int = ..., approach: Approach = ..., hold_s: float = ..., limit_scale: float = ..., hold_min_s: float | None = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: ScheduleSettings(kind=<ScheduleKind.transitions: 0>, count=0, episodes=0, approach=<Approach.step: 0>, hold_s=3.0, limit_scale=1.0, hold_min_s=None)."""

class Segment:
    """One bending segment, with two actuators on each side. A positive pressure inflates its right side, a negative one its left side."""
    @property
    def length_m(self) -> float:
        """Length without pressure [m], > 0, at most 10."""
    @property
    def width_m(self) -> float:
        """Between the centre lines of its two sides [m], > 0, at most 10."""
    @property
    def gaps(self) -> int:
        """Spaces between its plates, 1 to 100."""
    @property
    def pressure_limit_kpa(self) -> float:
        """The larger one of both sides' limits [kPa], > 0."""
    @property
    def strain_polynomial(self) -> list[float]:
        """c1 to c4 of the contraction e = c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa, e a share of the length. All 0 where the arm has none."""
    @property
    def curvature_per_unit(self) -> float:
        """Curvature [1/m] for one unit of the command; only with NoLoadKind.curvature."""
    @property
    def pressure_range_kpa(self) -> tuple[float, float]:
        """(lower, upper) limit of its command [kPa], signed: positive bends right."""

class SegmentPressure:
    """A pressure that bends a segment as wanted."""
    @property
    def pressure_kpa(self) -> float:
        """Signed pressure within the segment's limits [kPa]."""
    @property
    def reachable(self) -> bool:
        """False where more than the limit would be needed; pressure_kpa is then at the limit."""

class SegmentShape:
    """Curvature and length of one segment."""
    @property
    def curvature_per_m(self) -> float:
        """Curvature [1/m]; positive bends left, which a negative pressure does."""
    @property
    def length_m(self) -> float:
        """Length of its middle line when bent [m]."""

class SegmentValves:
    """One segment's valves and their controller."""
    @property
    def inflating(self) -> ValveDirection:
        """ValveDirection of pressures that go away from 0 (that rise, where has_sides is False)."""
    @inflating.setter
    def inflating(self, value: ValveDirection) -> None: ...
    @property
    def venting(self) -> ValveDirection:
        """ValveDirection of pressures that go towards 0 (that fall, where has_sides is False)."""
    @venting.setter
    def venting(self, value: ValveDirection) -> None: ...
    @property
    def dead_time_s(self) -> float:
        """From a set point to its first effect [s], 0 to 5; need not be whole frames."""
    @dead_time_s.setter
    def dead_time_s(self, value: float) -> None: ...
    @property
    def dead_band_kpa(self) -> float:
        """The valves stay closed while the pressure is within this distance of the set point [kPa], >= 0; 0: they always follow."""
    @dead_band_kpa.setter
    def dead_band_kpa(self, value: float) -> None: ...
    def __init__(self, *, inflating: ValveDirection = ..., venting: ValveDirection = ..., dead_time_s: float = ..., dead_band_kpa: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: SegmentValves(inflating=ValveDirection(time_constant_s=0.0, rate_limit_kpa_per_s=0.0), venting=ValveDirection(time_constant_s=0.0, rate_limit_kpa_per_s=0.0), dead_time_s=0.0, dead_band_kpa=0.0)."""

class SimpleFit:
    """Gains, offsets and lengths of the simple model, fitted to recordings by fit_simple_model."""
    def describe(self, arm: ArmDescription) -> str:
        """Each number with its 95 % interval, as text."""

class StageChoice:
    """What a race between windows found."""
    @property
    def tried(self) -> list[WindowsTried]:
        """List of WindowsTried, windows of 32 alone first."""
    @property
    def chosen(self) -> int:
        """Index of the best in `tried`, from 0."""
    @property
    def race_epochs(self) -> int:
        """Epochs of each short run."""
    @property
    def epochs(self) -> int:
        """Epochs that are left for the chosen windows."""
    def __str__(self) -> str: ...

class StrainFit:
    """A strain polynomial and how well it fits."""
    @property
    def polynomial(self) -> list[float]:
        """c1 to c4 of the contraction e = c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa."""
    @property
    def full_strain(self) -> float:
        """Contraction at the pressure limit, a share of the length."""
    @property
    def rms_residual(self) -> float:
        """Root mean square of the residuals, as a share of full_strain."""
    @property
    def max_residual(self) -> float:
        """Largest residual, as a share of full_strain."""
    @property
    def points(self) -> int:
        """Number of readings that were used."""
    @property
    def warnings(self) -> list[str]:
        """What is odd about the readings, a list of sentences."""

class SystemFault(RuntimeError):
    """The machine or a driver failed: disk full, simulation blown up, arm silent."""

class TipErrors:
    """Errors of the predicted end effector."""
    @property
    def position_cm(self) -> ErrorStatistics:
        """ErrorStatistics of its distance [cm]."""
    @property
    def orientation_rad(self) -> ErrorStatistics:
        """ErrorStatistics of its heading [rad]."""

class TrainingData:
    """What is learnt from, what chooses the best epoch, what is replayed, and what the error is measured on. Lists of Episode: copies; assign whole lists."""
    @property
    def training(self) -> list[Episode]:
        """List of Episode to learn from; a copy."""
    @training.setter
    def training(self, value: Iterable[Episode]) -> None: ...
    @property
    def validation(self) -> list[Episode]:
        """List of Episode that chooses the best epoch; a copy."""
    @validation.setter
    def validation(self, value: Iterable[Episode]) -> None: ...
    @property
    def replay(self) -> list[Episode]:
        """List of Episode that a model to be fine-tuned was trained on before, so that it does not forget them; a copy."""
    @replay.setter
    def replay(self, value: Iterable[Episode]) -> None: ...
    @property
    def unseen(self) -> list[Episode]:
        """List of Episode for note_unseen, which `train` never looks at; a copy."""
    @unseen.setter
    def unseen(self, value: Iterable[Episode]) -> None: ...
    @property
    def arms(self) -> list[int]:
        """For a family: the arm of each training episode, from 0; empty: each one of its own. A copy; assign whole lists."""
    @arms.setter
    def arms(self, value: list[int]) -> None: ...
    @property
    def held_back(self) -> list[int]:
        """Numbers, from 0, of the episodes given to hold_back_validation that validate."""
    def __init__(self, training: Iterable[Episode], validation: Iterable[Episode] = ..., replay: Iterable[Episode] = ..., unseen: Iterable[Episode] = ...) -> None:
        """Lists of Episode, copied; no episode belongs in two of them."""

class TrainingResult:
    """What came of training."""
    @property
    def status(self) -> TrainingStatus:
        """TrainingStatus: how training ended."""
    @property
    def message(self) -> str:
        """Why it diverged, and what to try; else empty."""
    @property
    def best_epoch(self) -> int:
        """Number of the epoch that the model is of, from 1."""
    @property
    def best_validation_position_error_cm(self) -> float:
        """Error of that epoch by validation, open loop [cm]; NaN without validation episodes."""
    @property
    def wall_time_s(self) -> float:
        """How long training took [s]."""
    @property
    def model(self) -> CompensationModel:
        """CompensationModel of the best epoch by validation."""
    @property
    def passed_over_epochs(self) -> list[int]:
        """Epochs with smaller errors by validation whose networks ran away in a long rollout."""
    @property
    def long_rollout(self) -> LongRollout:
        """LongRollout of the best epoch, its worst network."""
    @property
    def curve(self) -> list[LearningCurvePoint]:
        """List of LearningCurvePoint, one for each epoch."""
    @property
    def member_validation_position_error_cm(self) -> list[float]:
        """The same of each network of an ensemble, a list [cm]."""
    def _repr_svg_(self) -> str: ...

class TrainingSettings:
    """Everything that decides a training run besides its data; best_preset() fills it in, TrainingSettings() has no stages yet. Same settings, data and seed: same network, for any number of jobs. `train` raises InputError for a value out of range."""
    @property
    def preset(self) -> str:
        """"paper" or "best"; training_preset fills in the rest."""
    @preset.setter
    def preset(self, value: str) -> None: ...
    @property
    def layout(self) -> BackboneLayout:
        """BackboneLayout: how backbones enter the network."""
    @layout.setter
    def layout(self, value: BackboneLayout) -> None: ...
    @property
    def form(self) -> OutputForm:
        """OutputForm: what the network's outputs mean."""
    @form.setter
    def form(self, value: OutputForm) -> None: ...
    @property
    def reads_velocity(self) -> bool:
        """Whether the network reads how the backbone changed in the frame before."""
    @reads_velocity.setter
    def reads_velocity(self, value: bool) -> None: ...
    @property
    def hidden_units(self) -> list[int]:
        """Units of each hidden layer, >= 1 each; a copy: assign a whole list."""
    @hidden_units.setter
    def hidden_units(self, value: list[int]) -> None: ...
    @property
    def scaling(self) -> Scaling:
        """Scaling of the network's inputs and outputs."""
    @scaling.setter
    def scaling(self, value: Scaling) -> None: ...
    @property
    def error_in_user_units(self) -> bool:
        """True: frame errors count in metres and radians; False: in units of the spread of what is added to the no-load model."""
    @error_in_user_units.setter
    def error_in_user_units(self, value: bool) -> None: ...
    @property
    def first_weights(self) -> FirstWeights:
        """FirstWeights: what training begins with."""
    @first_weights.setter
    def first_weights(self, value: FirstWeights) -> None: ...
    @property
    def bounded(self) -> bool:
        """Whether gaps between plates stay within what was recorded of them."""
    @bounded.setter
    def bounded(self, value: bool) -> None: ...
    @property
    def reduction(self) -> LossReduction:
        """LossReduction: how a batch's errors become one number."""
    @reduction.setter
    def reduction(self, value: LossReduction) -> None: ...
    @property
    def stages(self) -> list[TrainingStage]:
        """List of TrainingStage, done in this order. A copy, whose fields can't be set: assign whole lists."""
    @stages.setter
    def stages(self, value: list[TrainingStage]) -> None: ...
    @property
    def optimiser(self) -> Optimiser:
        """Optimiser: how weights are changed."""
    @optimiser.setter
    def optimiser(self, value: Optimiser) -> None: ...
    @property
    def learning_rate(self) -> float:
        """Step size at the start, > 0."""
    @learning_rate.setter
    def learning_rate(self, value: float) -> None: ...
    @property
    def cosine_decay(self) -> bool:
        """True: the step size falls towards zero over the run; False: it stays."""
    @cosine_decay.setter
    def cosine_decay(self, value: bool) -> None: ...
    @property
    def gradient_norm_limit(self) -> float:
        """Longer gradients are shortened to this; 0: never."""
    @gradient_norm_limit.setter
    def gradient_norm_limit(self, value: float) -> None: ...
    @property
    def growth_limit(self) -> float:
        """What a window's gradients may grow to on their way back, over what was put in; 0: anything."""
    @growth_limit.setter
    def growth_limit(self, value: float) -> None: ...
    @property
    def first_frames_power(self) -> float:
        """A window's frame k, from 0, counts (k + 1)^-power; 0: all count alike."""
    @first_frames_power.setter
    def first_frames_power(self, value: float) -> None: ...
    @property
    def weight_decay(self) -> float:
        """By this times the learning rate every step shortens the weights, >= 0."""
    @weight_decay.setter
    def weight_decay(self, value: float) -> None: ...
    @property
    def average_decay(self) -> float:
        """Decay of the weights' moving average, in [0, 1); 0: none."""
    @average_decay.setter
    def average_decay(self, value: float) -> None: ...
    @property
    def input_noise(self) -> float:
        """Standard deviation of what is added to a window's first backbone, in normalised units, >= 0."""
    @input_noise.setter
    def input_noise(self, value: float) -> None: ...
    @property
    def shift_windows(self) -> bool:
        """Whether each epoch cuts its windows at another frame."""
    @shift_windows.setter
    def shift_windows(self, value: bool) -> None: ...
    @property
    def family_size(self) -> int:
        """Numbers that say which of a family's arms it is, 0 to 64; 0: the network is one arm's."""
    @family_size.setter
    def family_size(self, value: int) -> None: ...
    @property
    def ensemble(self) -> int:
        """Networks trained together, each from its own weights, 1 to 64."""
    @ensemble.setter
    def ensemble(self, value: int) -> None: ...
    @property
    def replay_share(self) -> float:
        """Share of an epoch's windows that comes from TrainingData.replay, 0 to 0.95."""
    @replay_share.setter
    def replay_share(self, value: float) -> None: ...
    @property
    def seed(self) -> int:
        """Seed of first weights and of the windows' order."""
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def jobs(self) -> int:
        """Threads, 0: one per core; never changes a result."""
    @jobs.setter
    def jobs(self, value: int) -> None: ...
    @property
    def time_limit_s(self) -> float:
        """> 0: epochs are scaled to about this time, once, at the start [s]; 0: no limit."""
    @time_limit_s.setter
    def time_limit_s(self, value: float) -> None: ...
    @property
    def keep_epoch(self) -> int:
        """> 0: training ends after this epoch, whose network is kept; nothing may validate. 0: the best one is."""
    @keep_epoch.setter
    def keep_epoch(self, value: int) -> None: ...
    @property
    def validation_interval(self) -> int:
        """Epochs from one validation to the next, >= 1."""
    @validation_interval.setter
    def validation_interval(self, value: int) -> None: ...
    @property
    def checkpoint(self) -> str | os.PathLike[str]:
        """File that the run is stored in to go on from; empty: none."""
    @checkpoint.setter
    def checkpoint(self, value: str | os.PathLike[str]) -> None: ...
    @property
    def checkpoint_interval_s(self) -> float:
        """Least time between storing it [s], >= 0."""
    @checkpoint_interval_s.setter
    def checkpoint_interval_s(self, value: float) -> None: ...
    @property
    def resume(self) -> bool:
        """Whether to go on from the checkpoint: the result is that of an unbroken run."""
    @resume.setter
    def resume(self, value: bool) -> None: ...
    @property
    def epoch_count(self) -> int:
        """Epochs of all stages together."""
    def __init__(self, *, preset: str = ..., layout: BackboneLayout = ..., form: OutputForm = ..., reads_velocity: bool = ..., hidden_units: list[int] = ..., scaling: Scaling = ..., error_in_user_units: bool = ..., first_weights: FirstWeights = ..., bounded: bool = ..., reduction: LossReduction = ..., stages: list[TrainingStage] = ..., optimiser: Optimiser = ..., learning_rate: float = ..., cosine_decay: bool = ..., gradient_norm_limit: float = ..., growth_limit: float = ..., first_frames_power: float = ..., weight_decay: float = ..., average_decay: float = ..., input_noise: float = ..., shift_windows: bool = ..., family_size: int = ..., ensemble: int = ..., replay_share: float = ..., seed: int = ..., jobs: int = ..., time_limit_s: float = ..., keep_epoch: int = ..., validation_interval: int = ..., checkpoint: str | os.PathLike[str] = ..., checkpoint_interval_s: float = ..., resume: bool = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: TrainingSettings(preset='best', layout=<BackboneLayout.gap_poses: 1>, form=<OutputForm.gated_change: 1>, reads_velocity=True, hidden_units=[100, 100, 100], scaling=<Scaling.unit_spread: 1>, error_in_user_units=False, first_weights=<FirstWeights.he: 0>, bounded=True, reduction=<LossReduction.mean_over_batch: 1>, stages=[], optimiser=<Optimiser.adam: 1>, learning_rate=0.003, cosine_decay=True, gradient_norm_limit=0.0, growth_limit=0.0, first_frames_power=0.0, weight_decay=0.0, average_decay=0.0, input_noise=0.0, shift_windows=True, family_size=0, ensemble=1, replay_share=0.25, seed=1, jobs=0, time_limit_s=0.0, keep_epoch=0, validation_interval=1, checkpoint=PosixPath('.'), checkpoint_interval_s=20.0, resume=False)."""

class TrainingStage:
    """A part of training, windows of one length."""
    @property
    def window_frames(self) -> int:
        """Frames that the network is rolled over, fed with its own output, >= 1."""
    @window_frames.setter
    def window_frames(self, value: int) -> None: ...
    @property
    def windows_per_batch(self) -> int:
        """Windows for each change of the weights, >= 1."""
    @windows_per_batch.setter
    def windows_per_batch(self, value: int) -> None: ...
    @property
    def epochs(self) -> int:
        """Passes over the training data, >= 1."""
    @epochs.setter
    def epochs(self, value: int) -> None: ...
    def __init__(self, *, window_frames: int = ..., windows_per_batch: int = ..., epochs: int = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: TrainingStage(window_frames=32, windows_per_batch=128, epochs=1)."""

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
        """Time constant of the lag behind the set point [s], >= 0; 0: no lag."""
    @time_constant_s.setter
    def time_constant_s(self, value: float) -> None: ...
    @property
    def rate_limit_kpa_per_s(self) -> float:
        """Fastest change of the pressure [kPa/s], > 0; infinite where nothing limits it."""
    @rate_limit_kpa_per_s.setter
    def rate_limit_kpa_per_s(self, value: float) -> None: ...
    def __init__(self, *, time_constant_s: float = ..., rate_limit_kpa_per_s: float = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: ValveDirection(time_constant_s=0.0, rate_limit_kpa_per_s=0.0)."""

class ValveErrors:
    """Size of modelled less measured pressure, over frames whose set point changed within 0.5 s."""
    @property
    def mean_kpa(self) -> float:
        """Mean [kPa]."""
    @property
    def p95_kpa(self) -> float:
        """95th percentile [kPa]."""
    @property
    def max_kpa(self) -> float:
        """Largest [kPa]."""
    @property
    def frames(self) -> int:
        """Frames that were looked at; 0: not measured."""

class ValveFindings:
    """How valves were identified, or why not."""
    @property
    def source(self) -> str:
        """The recordings that they were identified from."""
    @property
    def held_back(self) -> ValveErrors:
        """ValveErrors on motions that the fit has not seen."""
    @property
    def from_setpoints(self) -> ValveErrors:
        """ValveErrors on the same motions, if set points were taken for pressures."""
    @property
    def reason(self) -> str:
        """Why there are no parameters; empty where there are."""
    @property
    def warnings(self) -> list[str]:
        """What is suspicious about the recordings, a list of sentences."""

class ValveModel:
    """Set points to pressures, frame by frame. Constant: share it freely."""
    @property
    def is_ideal(self) -> bool:
        """Whether pressures are the set points at once."""
    @property
    def parameters(self) -> ValveParameters:
        """ValveParameters, as given; a copy, whose fields can't be set."""
    @property
    def segment_count(self) -> int:
        """n: segments of the arm."""
    def __init__(self, arm: ArmDescription, parameters: ValveParameters | None = None) -> None:
        """Without parameters ideal valves: pressures are the set points. Raises InputError where the parameters do not fit the arm."""
    def run(self, setpoint_kpa: npt.ArrayLike, first_pressure_kpa: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Pressures along set points float64 (T, n) [kPa] from a settled start (n,): float64 (T, n), row k after frame k; row 0 is the start."""

class ValveParameters:
    """Parameters of the valve model. ValveParameters() are ideal valves: pressures are the set points at once."""
    @property
    def has_sides(self) -> bool:
        """Whether a command has two sides, one of which vents before the other inflates: True for pressures, False for a curvature or an angle."""
    @has_sides.setter
    def has_sides(self, value: bool) -> None: ...
    @property
    def segments(self) -> list[SegmentValves]:
        """List of SegmentValves, one for each segment, base first; empty: ideal valves. A copy, whose fields can't be set: assign whole lists. ValveModel raises InputError where their number or a value does not fit the arm."""
    @segments.setter
    def segments(self, value: list[SegmentValves]) -> None: ...
    @property
    def is_ideal(self) -> bool:
        """Whether there are no segments, so that pressures are the set points."""
    def __init__(self, *, has_sides: bool = ..., segments: list[SegmentValves] = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: ValveParameters(has_sides=True, segments=[])."""
    def hash(self) -> str:
        """Hash of everything that a prediction depends on, a text; empty for ideal valves."""
    def __eq__(self, other: object) -> bool: ...

class VirtualArm:
    """A soft arm lying on a table, simulated; an ArmDriver."""
    def __init__(self, arm: ArmDescription, options: VirtualArmOptions = ...) -> None:
        """At rest: straight, vented, at time 0. Raises InputError where an option is out of range."""
    def state(self) -> ArmState:
        """The latest ArmState; before the first command, the arm at rest."""
    def command(self, setpoint_kpa: npt.ArrayLike) -> ArmState:
        """One frame at set points (n,) [kPa]; returns the ArmState after it. Raises InputError for a set point beyond the limits."""
    def vent(self) -> None:
        """Opens every vent valve: all set points are 0 until the next command."""
    def settle(self, setpoint_kpa: npt.ArrayLike, seconds: float) -> ArmState:
        """The same set points (n,) [kPa] for so long [s]; returns the ArmState after it."""
    def true_backbone(self) -> npt.NDArray[np.float64]:
        """Shape now, float64 (m, 3), without noise, drops or latency."""
    def true_pressure_kpa(self) -> npt.NDArray[np.float64]:
        """Pressures now, float64 (n,) [kPa], without noise or latency."""

class VirtualArmOptions:
    """Faults of a real laboratory, all off by default."""
    @property
    def noise_m(self) -> float:
        """Standard deviation of measured x and y [m], >= 0."""
    @noise_m.setter
    def noise_m(self, value: float) -> None: ...
    @property
    def noise_rad(self) -> float:
        """Standard deviation of measured headings [rad], >= 0."""
    @noise_rad.setter
    def noise_rad(self, value: float) -> None: ...
    @property
    def noise_kpa(self) -> float:
        """Standard deviation of measured pressures [kPa], >= 0."""
    @noise_kpa.setter
    def noise_kpa(self, value: float) -> None: ...
    @property
    def drop_rate(self) -> float:
        """Share of frames without a backbone, 0 to 1."""
    @drop_rate.setter
    def drop_rate(self, value: float) -> None: ...
    @property
    def latency_s(self) -> float:
        """Everything measured was true this long ago [s], >= 0."""
    @latency_s.setter
    def latency_s(self, value: float) -> None: ...
    @property
    def seed(self) -> int:
        """Seed of noise and drops."""
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def stream(self) -> int:
        """Number of the episode or trial, for noise of its own."""
    @stream.setter
    def stream(self, value: int) -> None: ...
    def __init__(self, *, noise_m: float = ..., noise_rad: float = ..., noise_kpa: float = ..., drop_rate: float = ..., latency_s: float = ..., seed: int = ..., stream: int = ...) -> None:
        """Fields are keyword arguments, all optional. The defaults: VirtualArmOptions(noise_m=0.0, noise_rad=0.0, noise_kpa=0.0, drop_rate=0.0, latency_s=0.0, seed=0, stream=0)."""

class WindowsTried:
    """Windows of stages, and how a short run did."""
    @property
    def window_frames(self) -> list[int]:
        """Frames of each stage's windows, a list."""
    @property
    def one_step_cm(self) -> float:
        """Mean error of the tip one frame ahead, by validation [cm]; inf: it diverged."""
    @property
    def window_32_cm(self) -> float:
        """The same over rollouts of 32 frames [cm]."""
    @property
    def window_600_cm(self) -> float:
        """The same over 600 frames [cm]. What decides: sqrt(window_32_cm * window_600_cm)."""

def adapt(arm: ArmDescription, family: CompensationModel, episodes: Iterable[Episode], train_weights: bool = True, seed: int = 1, jobs: int = 0) -> Adaptation:
    """Makes a family's network that of the arm in these episodes, of which a minute is enough: an Adaptation, whose model plans like any other. train_weights: whether weights are trained too where the family does not contain the arm and that is better. jobs: threads, 0: one per core. Raises InputError where the model is of no family, or the episodes are another arm's or too short."""

def arm_differences(there: ArmDescription, here: ArmDescription) -> list[str]:
    """Keys in which the arms differ, with both values; empty where they are the same arm."""

def arm_svg(arm: ArmDescription, backbone: npt.ArrayLike) -> str:
    """The arm with this backbone, float32 (m, 3), as SVG."""

def arm_to_yaml(arm: ArmDescription) -> str:
    """The arm as the text of a file that load_arm reads."""

def bench_test_all(arm: ArmDescription, steps: int = 20) -> list[list[BenchPoint]]:
    """The bench test of every segment of the virtual arm: a list of BenchPoint for each. steps: pressures from 0 to the limit, >= 4."""

def best_preset() -> TrainingSettings:
    """The default TrainingSettings: a network that predicts how each plate moves about the one before it, trained by Adam in windows of 2, 8 and 32 frames. epoch_count says how many epochs; set_epoch_count changes that."""

def certify(plan: Plan, arm: ArmDescription, network: CompensationModel | None, valves: ValveParameters, environment: Environment) -> Certificate:
    """One plan, by a Certifier of its own: simulated, checked for collision and judged again, with nothing of the planner's. It says whether the plan is as the model has it, not whether the model is right. None is refused."""

def characterise(arm: ArmDescription, bench: Sequence[list[BenchPoint]]) -> CharacterisedArm:
    """Fits a monotone quartic to every segment's bench points: a CharacterisedArm. bench: a list of BenchPoint for each segment, base first, at least 5 different pressures up to the limit. Raises InputError naming the segment."""

def choose_stages(arm: ArmDescription, data: TrainingData, settings: TrainingSettings, on_epoch: Callable[[LearningCurvePoint], bool | None] | None = None) -> StageChoice:
    """Chooses windows by validation in short runs, as the program does without --windows; `settings` gets the chosen stages and the epochs that are left."""

def collect(arm: ArmDescription, settings: CollectionSettings, make_driver: DriverFactory | ProcessDriver | Callable[[int], ArmDriver], path: str | os.PathLike[str]) -> CollectionResult:
    """Records a schedule to `path` (HDF5). make_driver: virtual_arm_factory(...), a ProcessDriver, or a function of the episode's index that returns an ArmDriver. Ctrl-C vents the arm and raises KeyboardInterrupt; finished episodes stay, for resume=True."""

def command_shares(arm: ArmDescription) -> npt.NDArray[np.float64]:
    """S, float64 (n, k): commands of segments are S times the arm's own, k of them."""

def commands_for(arm: ArmDescription, segment_commands: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """The arm's own commands, float64 (k,), that make these of its segments (n,): the smallest, by their sum of squares."""

def content_hash(path: str | os.PathLike[str]) -> str:
    """Hash of a file, a text: what plans and models say of the files they were made with."""

def environment_hash(environment: Environment) -> str:
    """Hash of everything that planning depends on, a text; the name is no part of it."""

def environment_picture(arm: ArmDescription, environment: Environment) -> str:
    """The environment with the arm at its start, as an SVG file's text."""

def environment_to_yaml(environment: Environment) -> str:
    """The environment as the text of a file that load_environment reads."""

def episode_errors(arm: ArmDescription, episodes: Iterable[Episode]) -> EpisodeErrors:
    """EpisodeErrors of the simple model, fitted to all episodes; an episode far above the others was broken. Raises InputError where there is no episode, or nothing was tracked."""

def error_room(model: ForwardModel, margin_m: float | None = None, goal_margin_m: float | None = None, goal_margin_rad: float | None = None, tube_level: float | None = None) -> ErrorRoom:
    """The ErrorRoom that plans keep for a model's error: the tube that the model carries, else the error that it states (PredictionError). margin_m, goal_margin_m [m] and goal_margin_rad [rad], >= 0, are taken instead where they are given; tube_level chooses one of the model's tubes, such as 0.9. Raises InputError naming the levels there are. Without a network: 0, its error is larger than any room."""

def evaluate(no_load: ForwardModel, network: ForwardModel | None, episodes: Iterable[Episode], jobs: int = 0) -> Evaluation:
    """Evaluation: errors of the no-load model and of a network on episodes. no_load: ForwardModel(arm); network: ForwardModel(arm, model), or None. Take episodes that it was not trained on. jobs: threads, 0: one per core. Raises InputError where no episode has three frames, or nothing was tracked."""

def execute(arm: ArmDescription, environment: Environment, plan: Plan, driver: ArmDriver | ProcessDriver | VirtualArm, settings: ExecutionSettings = ..., controller: ClosedLoop | Controller | None = None) -> ExecutionResult:
    """Commands a plan's frames as they stand, then holds; or what a controller decides: a ClosedLoop, or a Controller of your own. driver: a VirtualArm, a ProcessDriver, or an ArmDriver of your own for simulation. The arm is vented before this returns, whatever happens; Ctrl-C raises KeyboardInterrupt. Raises InputError where arm, environment and plan do not belong together, or the arm is too far from the plan's start."""

def execution_animation(arm: ArmDescription, environment: Environment, plan: Plan, result: ExecutionResult) -> str:
    """A page in which the arm moves, as predicted and as measured."""

def execution_picture(arm: ArmDescription, environment: Environment, plan: Plan, result: ExecutionResult) -> str:
    """One run beside its prediction, as an SVG file's text."""

def export_csv(recording: Recording, folder: str | os.PathLike[str]) -> list[str | os.PathLike[str]]:
    """Writes each episode as one CSV table, and mapping.yaml to read them back with import_csv. folder: made where it is missing."""

def fine_tune(arm: ArmDescription, data: TrainingData, settings: TrainingSettings, start: CompensationModel, on_epoch: Callable[[LearningCurvePoint], bool | None] | None = None) -> TrainingResult:
    """Trains on from the weights of the model `start`, which keeps its layout and sizes; else as `train`. Raises InputError where it is another arm's."""

def fine_tuning_of(preset: TrainingSettings) -> TrainingSettings:
    """Settings for fine_tune, to go on with a model that has learnt: the last stage of `preset` with half its epochs and a tenth of its learning_rate."""

def fit_simple_model(arm: ArmDescription, episodes: Iterable[Episode]) -> SimpleFit:
    """SimpleFit: how much a pressure bends each segment, and how long it is, from the recordings. Raises InputError where there is no episode, or nothing was tracked."""

def fitted_arm(arm: ArmDescription, fit: SimpleFit, episodes: Iterable[Episode]) -> ArmDescription:
    """The arm with the fit's polynomials and lengths, an ArmDescription. episodes: those that were fitted."""

def gap_bounds_of(episodes: Iterable[Episode]) -> GapBounds:
    """The bounds of a model that learnt from these episodes, for the model.bounds of an old one."""

def hold_back_arms(episodes: Iterable[Episode], arms: Sequence[int], fraction: float, seed: int) -> TrainingData:
    """TrainingData for a family: the episodes of about `fraction` of the arms are held back for validation, none of fewer than ten. arms: the arm of each episode, any numbers."""

def hold_back_unseen(data: TrainingData, fraction: float, seed: int) -> None:
    """Moves about `fraction` of the frames, in [0, 1), from data.training to data.unseen, for note_unseen to measure the error on: whole episodes chosen by `seed`, or the end of the longest. `data` is changed; where it is too short, nothing is moved. Call it after hold_back_validation."""

def hold_back_validation(episodes: Iterable[Episode], fraction: float, seed: int) -> TrainingData:
    """TrainingData of the episodes, some of which are held back for validation: about `fraction` of the frames, in (0, 1), in whole episodes chosen by `seed`, at least one. Of a single episode its end is held back. Raises InputError where nothing would be left to learn from."""

def identify_valves(episodes: Iterable[Episode], arm: ArmDescription, source: str = 'recordings') -> IdentifiedValves:
    """IdentifiedValves between set points and measured pressures; the findings say how well they fit, or why there are none. source: the recordings' name in the findings."""

def import_csv(logs: Sequence[str | os.PathLike[str]] | str | os.PathLike[str], arm: ArmDescription, mapping: str | os.PathLike[str] | None = None, command_logs: Sequence[str | os.PathLike[str]] | str | os.PathLike[str] = ..., time_offset_s: float | None = None) -> ImportResult:
    """A recording from CSV logs: an ImportResult. logs: their paths, or one path; arm: whose logs they are; mapping: file that names their columns and units (docs/importing.md), required; command_logs: logs of pressures on a clock of their own, one for each of `logs`; time_offset_s: what to add to their times [s], None: found by correlation. Raises InputError naming log, line and column."""

def import_motive(logs: Sequence[str | os.PathLike[str]] | str | os.PathLike[str], arm: ArmDescription, mapping: str | os.PathLike[str] | None = None, command_logs: Sequence[str | os.PathLike[str]] | str | os.PathLike[str] = ..., time_offset_s: float | None = None) -> ImportResult:
    """The same from OptiTrack Motive's CSV exports. mapping: None: all rigid bodies, or else all markers, are plates; command_logs: logs of the pressures, which Motive has not, one for each of `logs`."""

def inspect(recording: Recording, arm: ArmDescription | None = None, file: str = 'recording') -> str:
    """What a recording holds and what is odd about it, a text. arm: gives the limits, None: the largest set points stand for them; file: its name in messages."""

def is_family(model: CompensationModel) -> bool:
    """Whether a model is a family's, which adapt makes one arm's."""

def is_within(goal: PoseGoal, error: PoseError) -> bool:
    """Whether both numbers of a PoseError are within the goal's tolerances."""

def learning_curve_svg(curve: Sequence[LearningCurvePoint]) -> str:
    """Loss and validation error over epochs, as SVG text."""

def learnt_region_of(data: TrainingData) -> LearntRegion:
    """What a model has learnt that was trained on these data, for model.learnt."""

def load_arm(path: str | os.PathLike[str]) -> ArmDescription:
    """Reads and checks an arm file (YAML). Raises InputError naming file, line and field, what was found and what is allowed."""

def load_arm_to_characterise(path: str | os.PathLike[str]) -> ArmDescription:
    """An arm file whose strain polynomials may be missing or outdated."""

def load_environment(path: str | os.PathLike[str], arm: ArmDescription | None = None) -> Environment:
    """Reads and checks an environment file (YAML); with an arm, also that its start fits. Raises InputError naming file, line and field. Whether the goal is within reach is judged when planning."""

def make_planner(name: str = 'default', jobs: int = 0) -> Planner:
    """By name; settings may follow it: "default,improved_plans=0". jobs: threads, 0: one per core; they never change a result."""

def make_recording(arm: ArmDescription, episodes: Iterable[Episode], source: str = 'python', seed: int = 0) -> Recording:
    """A Recording of these episodes (copied), checked: sizes agree, times increase, numbers are finite; else InputError. source: what moved, in words."""

def note_unseen(arm: ArmDescription, model: CompensationModel, unseen: Iterable[Episode], jobs: int = 0) -> None:
    """Measures the finished model's error on episodes that it has never seen, and stores it as model.prediction_error: error_room then keeps plans so far clear of obstacles. unseen: data.unseen; motions in it count that move a set point, up to 5 s each. Where there is none, or a prediction is not finite, prediction_error becomes None. jobs: threads, 0: one per core."""

def paper_preset() -> TrainingSettings:
    """The TrainingSettings of the paper: windows of 32 frames, SGD, 6000 epochs. For comparison."""

def plan(arm: ArmDescription, model: str | os.PathLike[str] | CompensationModel | MotionModel, environment: Environment, limits: PlannerLimits = ..., seed: int = 1, *, callback: Callable[[PlannerProgress], bool | None] | None = None, planner: str = 'default', jobs: int = 0, margin_m: float | None = None, goal_margin_m: float | None = None, goal_margin_rad: float | None = None, tube_level: float | None = None, stay_recorded: bool = False, limits_kpa: Sequence[tuple[float, float]] = ..., rate_limit_kpa_per_s: float | None = None) -> PlanResult:
    """What `limber plan` does, and the same plan: it keeps the tube that the model carries, or the error that it states, stands behind the valves that it was trained with, and is certified. model: the file of one, which the plan then names; a CompensationModel; or a MotionModel, with valves of its own or without a network. limits: by default 10 s. The others as Planner.plan, make_planner, error_room and PlanningProblem have them; rate_limit_kpa_per_s: in place of the arm's, at most that; stay_recorded: with set points, rates and shapes like those recorded alone. No plan is no error: PlanResult.status and reason say why, warnings what is doubtful."""

def plan_along(problem: PlanningProblem, waypoints_kpa: npt.ArrayLike, planner: str, seed: int = 0) -> PlanResult:
    """The motion that a planner of your own proposes, from the start straight to each of the waypoints (w, n) [kPa]: simulated, held and certified. Not certified: best_partial is the motion, reason what is wrong with it."""

def plan_animation(arm: ArmDescription, environment: Environment, plan: Plan) -> str:
    """One self-contained HTML page in which the arm moves."""

def plan_picture(arm: ArmDescription, environment: Environment, result: PlanResult) -> str:
    """Environment, search tree and plan (or the nearest motion, dashed), as SVG text."""

def planner_names() -> list[str]:
    """Names that make_planner knows, the default first."""

def pose_error(goal: PoseGoal, pose: Pose) -> PoseError:
    """How far a Pose is from the centre of a PoseGoal: a PoseError."""

def predict(model: ForwardModel, episode: Episode, restart: Restart, jobs: int = 0) -> npt.NDArray[np.float32]:
    """Predicted backbones float32 (T, m, 3) of an episode, fed with its pressures; NaN where a frame is only a start. restart: a Restart; jobs: threads, 0: one per core."""

def pressure_picture(arm: ArmDescription, plan: Plan) -> str:
    """Set points and the pressures predicted from them over time, as SVG text."""

def problem_with_room(arm: ArmDescription, model: MotionModel, environment: Environment, room: ErrorRoom) -> PlanningProblem:
    """The PlanningProblem whose plans keep that room: the model's tube, or one clearance everywhere. room: an ErrorRoom, as error_room makes it."""

def read_bench_csv(path: str | os.PathLike[str], arm: ArmDescription) -> list[list[BenchPoint]]:
    """Bench points of every segment from a CSV file with the columns pressure_kpa, strain and, optionally, segment."""

def read_model(path: str | os.PathLike[str]) -> CompensationModel:
    """Reads and checks a model (safetensors). Raises InputError naming file and key."""

def read_plan(path: str | os.PathLike[str]) -> Plan:
    """Reads and checks a plan (JSON). Raises InputError naming file and field."""

def read_plan_unchecked(path: str | os.PathLike[str]) -> Plan:
    """Reads a plan (JSON) for `certify` to judge: only types and finite numbers are checked."""

def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads and checks a recording (HDF5). Raises InputError naming file and field."""

def read_valves(path: str | os.PathLike[str]) -> IdentifiedValves:
    """Reads and checks a valve file (YAML or JSON): IdentifiedValves. Raises InputError naming file and key."""

def require_model_of(model: CompensationModel, arm: ArmDescription, where: str = 'model') -> None:
    """Raises InputError unless the model was trained for the arm. where: the model's name in the message."""

def require_plan_of(plan: Plan, arm: ArmDescription, file: str = 'plan') -> None:
    """Raises InputError where the plan was made for another arm or breaks its limits. file: the plan's name in the message."""

def require_recording_of(recording: Recording, arm: ArmDescription, file: str = 'recording') -> None:
    """Raises InputError where the recording is not one of this arm. file: the recording's name in the message."""

def rest_positions_m(arm: ArmDescription) -> list[float]:
    """Distance along the arm at rest from the base to each plate, a list of m numbers [m]; the first is 0."""

def segment_commands(arm: ArmDescription, commands: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Commands of segments, float64 (n,), that the arm's own commands (k,) make."""

def set_epoch_count(settings: TrainingSettings, epochs: int) -> None:
    """Scales the stages of `settings` to so many epochs in all, keeping their proportions. Raises InputError where there are fewer epochs than stages."""

def set_family_size(settings: TrainingSettings, size: int) -> None:
    """Settings for a family of arms that so many numbers tell apart, 1 to 64: trained by SOAP in windows of 32 frames."""

def set_window_frames(settings: TrainingSettings, window_frames: Sequence[int]) -> None:
    """Replaces the stages of `settings` by windows of these lengths [frames], in this order, which share the epochs. Raises InputError where there is none or one is < 1."""

def solve_inverse_kinematics(model: NoLoadModel, goal: PoseGoal, settings: InverseKinematicsSettings, random: RandomStream) -> InverseKinematicsResult:
    """Pressures whose no-load tip is at the goal: Newton-Raphson from random starts. model: a NoLoadModel; goal: a PoseGoal; random: a RandomStream. Not complete: if none is found, there may still be one. Raises InputError where the goal or a setting is out of range."""

def start_state(environment: Environment, arm: ArmDescription) -> ArmStart:
    """Where the arm starts, an ArmStart: as the environment has it, or at rest."""

def tip_pose(backbone: npt.ArrayLike) -> Pose:
    """Pose of the end effector: the last row of a backbone (m, 3)."""

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
    """Valves as a dict, with the keys of a valve file."""
@overload
def to_json(error: PredictionError) -> dict[str, Any]:
    """The object `prediction_error` of `limber train --json`."""

def train(arm: ArmDescription, data: TrainingData, settings: TrainingSettings, on_epoch: Callable[[LearningCurvePoint], bool | None] | None = None) -> TrainingResult:
    """Trains a network: a TrainingResult. data: TrainingData, as hold_back_validation makes it. `on_epoch(LearningCurvePoint)` comes after every epoch; False stops the run. Ctrl-C raises KeyboardInterrupt; with a checkpoint, resume=True goes on. Raises InputError where the data do not fit the arm, or are shorter than one window."""

def training_preset(name: str) -> TrainingSettings:
    """TrainingSettings by name: "best" or "paper". Raises InputError naming them."""

def virtual_arm_factory(arm: ArmDescription, options: VirtualArmOptions = ...) -> DriverFactory:
    """A DriverFactory for `collect`: a fresh VirtualArm for each episode, with noise of its own."""

def virtual_collection(arm: ArmDescription, schedule: ScheduleSettings, options: VirtualArmOptions = ...) -> CollectionSettings:
    """CollectionSettings for the virtual arm, with its source, driver and seed."""

def with_setpoints_only(episodes: Iterable[Episode]) -> list:
    """Copies of the episodes without measured pressures: set points take their place."""

def write_arm(path: str | os.PathLike[str], arm: ArmDescription) -> None:
    """Writes an arm file (YAML) that load_arm reads, atomically."""

def write_backbones_csv(path: str | os.PathLike[str], plan: Plan) -> None:
    """Predicted shapes as CSV, one row for each frame: time_s, x_0_m, y_0_m, theta_0_rad, ..."""

def write_environment(path: str | os.PathLike[str], environment: Environment) -> None:
    """Writes an environment file (YAML) that load_environment reads, atomically."""

def write_model(path: str | os.PathLike[str], model: CompensationModel) -> None:
    """Writes a model (safetensors) that read_model reads, atomically."""

def write_plan(path: str | os.PathLike[str], plan: Plan) -> None:
    """Writes a plan (JSON), atomically, every number exactly."""

def write_recording(path: str | os.PathLike[str], recording: Recording) -> None:
    """Writes a recording (HDF5) that read_recording reads, atomically."""

def write_setpoints_csv(path: str | os.PathLike[str], plan: Plan) -> None:
    """Set points for a valve controller as CSV, one row for each frame: time_s, setpoint_0_kpa, ..., pressure_0_kpa, ..."""

def write_valves(path: str | os.PathLike[str], valves: IdentifiedValves) -> None:
    """Writes a valve file that read_valves reads, atomically. valves: IdentifiedValves."""
