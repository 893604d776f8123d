// What the server says (docs/studio_api.md). Keys are those of limber's files: kPa, m, rad, s.

export type Circle = { circle: { x_m: number; y_m: number; radius_m: number } };
export type Rectangle = {
  rectangle: { x_m: number; y_m: number; width_m: number; height_m: number; angle_rad: number };
};
export type Polygon = { polygon: [number, number][] };
export type Obstacle = Circle | Rectangle | Polygon;
export type Goal = {
  x_m: number;
  y_m: number;
  theta_rad?: number;
  position_tolerance_m: number;
  orientation_tolerance_rad?: number;
};
export type Environment = { name: string; obstacles: Obstacle[]; start: unknown; goal: Goal };

export type Segment = {
  length_m: number;
  width_m: number;
  gaps: number;
  lower_kpa: number;
  upper_kpa: number;
};
export type Arm = {
  name: string;
  command: { name: string; unit: string };
  length_m: number;
  actuator_radius_m: number;
  segments: Segment[];
  rest: number[];
  reach: { cell_m: number; middles_m: number[] };
};
export type Project = {
  version: string;
  folder: string;
  arms: string[];
  models: string[];
  families: string[]; // those of the models that are of no arm alone
  environments: string[];
  recordings: string[];
  plans: string[];
  first_arm: string;
  first_model: string;
  driver: string; // its command; empty: none
  driver_arm: string;
  driver_limit_scale: number; // the most that a run may ask for
};
export type Tube = {
  level: number;
  plate_radius_m: number[];
  start_share: number;
  full_after_m: number;
};
export type Plan = {
  request: number;
  opened?: number; // by this request; none: it was searched for
  time_s?: number;
  first_s?: number; // none: it was opened, not searched for
  warnings?: string[]; // of one that was opened; else the search's result has them
  cost_kpa: number;
  duration_s: number;
  frame_rate_hz: number;
  clearance_m: number | null;
  goal_distance_m: number;
  tube: Tube | null;
  setpoints_kpa: number[][];
  pressures_kpa: number[][];
  shapes: number[][];
};
export type Progress = {
  request: number;
  time_s: number;
  nodes: number;
  queries: number;
  best_cost_kpa: number | null;
  doubt: string;
};
/** From and to of each edge's tips: x, y, x, y. [m] */
export type Tree = { request: number; tree: number[] };
export type Result = {
  request: number;
  status: string;
  reason: string;
  warnings: string[];
  time_s: number;
  queries: number;
  nodes: number;
  tree: number[] | null;
};
export type TrackKey = 'simple' | 'network' | 'virtual_arm' | 'arm';
export type Track = {
  key: TrackKey;
  outcome: string;
  shapes: number[][];
  pressures_kpa: number[][];
  clearances_m: (number | null)[]; // empty without obstacles
};
export type Motion = {
  frame_rate_hz: number;
  setpoints_kpa: number[][];
  appeared: { time_s: number; obstacle: Obstacle } | null;
  tracks: Track[];
};
export type Run = Motion & { request: number };
/** Where the tip is to be in each frame. */
export type Followed = Run & { wanted_m: [number, number][] };
export type Drive = { request: number; time_s: number; setpoint_kpa: number[] } & Record<
  Exclude<TrackKey, 'arm'>,
  number[] | null
>;
export type ArmStatus = { state: 'off' | 'armed' | 'running'; message: string; recording: string };
export type ArmFrame = {
  time_s: number;
  setpoint_kpa: number[];
  pressure_kpa: number[];
  shape: number[] | null; // null: nobody has seen it yet
  obstacle: Obstacle | null;
  noticed: string; // of the arm so far in this run
  holds: string;
};

/** What tells arms of the model's family apart; empty: it is of none. */
export type Family = { is_family: boolean; e: number[]; traits: Trait[] };
/** A quantity of an arm's physics, in `unit`: middle + slope · e. Along `along`, it alone changes. */
export type Trait = {
  text: string; unit: string; of_arm_file: number; low: number; high: number;
  middle: number; slope: number[]; along: number[];
};

export type Figure = { median: number | null; p95: number | null; count: number } | null;
/** A row of `limber experiment`'s table. */
export type Row = {
  environment: string;
  model: string;
  planner: string;
  controller: string;
  disturbance: string;
  trials: number;
  solved: number;
  executed: number;
  collided: number;
  reached: number;
  distance_to_goal_cm: Figure;
};
export type Experiment = { folder: string; rows: Row[] };
export type TrialRun = {
  plan: string | null;
  status: string;
  cost_kpa: number | null;
  goal_reached: boolean | null;
  collided: boolean | null;
  stopped_ahead: boolean | null;
  distance_to_goal_cm: number | null;
};
export type Opened = { request: number; arm: string; model: string; environment: string; plan: Plan };
export type Horizons = { frames: number[]; tip_error_cm: Record<string, (number | null)[]> };
export type Coverage = { cells: number; pairs: { segments: [number, number]; frames: number[] }[] };
export type Measured = {
  request: number;
  recording: string;
  frame_rate_hz: number;
  frames: number;
  frames_used: number;
  learnt_from_it: boolean;
  horizons: Horizons;
  coverage: Coverage;
};

/** A family becomes the virtual arm's own model. */
export type Fitting = { request: number; step: string };
export type Fitted = { request: number; model: string; error_cm: number | null };

export type Events = {
  tab: { id: string };
  progress: Progress;
  tree: Tree;
  fitting: Fitting;
  fitted: Fitted;
  plan: Plan;
  result: Result;
  run: Run;
  followed: Followed;
  drive: Drive;
  arm: ArmStatus;
  arm_frame: ArmFrame;
  arm_run: Motion;
  opened: Opened;
  measuring: { request: number; share: number };
  measured: Measured;
  fault: { request: number; message: string };
};
export type Handlers = { [Kind in keyof Events]: (event: Events[Kind]) => void };

/** What the server refused, in its words; of status 0 where it did not answer. */
export class Refusal extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

const kSilent = 'The studio does not answer.';

async function read<T>(response: Response): Promise<T> {
  const body = (await response.json()) as T & { error?: string };
  if (!response.ok) {
    throw new Refusal(response.status, body.error ?? response.statusText);
  }
  return body;
}

let others = new AbortController(); // of all requests but VENT

async function ask<T>(path: string, request: RequestInit, signal: AbortSignal): Promise<T> {
  try {
    return await read<T>(await fetch(`/api/${path}`, { ...request, signal }));
  } catch (error) {
    if (signal.aborted) throw new Refusal(0, 'VENT was pressed, and nothing else is done.');
    throw error instanceof Refusal ? error : new Refusal(0, kSilent);
  }
}

export async function get<T>(path: string, query: Record<string, string> = {}): Promise<T> {
  return ask<T>(`${path}?${new URLSearchParams(query)}`, {}, others.signal);
}

const asJson = (body: object): RequestInit => ({
  method: 'POST',
  headers: { 'Content-Type': 'application/json' },
  body: JSON.stringify(body),
});

type Chain = 'arm' | 'read' | 'rest';
const noneYet = (): Record<Chain, Promise<unknown>> =>
  ({ arm: Promise.resolve(), read: Promise.resolve(), rest: Promise.resolve() });
let lastPost = noneYet();

/** One after another: what is asked for later arrives later. The arm waits for nothing else, a plan for no files. */
export function post<T>(path: string, body: object): Promise<T> {
  const { signal } = others;
  const chain: Chain = path.startsWith('arm/') ? 'arm' : path === 'experiment/runs' ? 'read' : 'rest';
  const answer = lastPost[chain].then(() => ask<T>(path, asJson(body), signal));
  lastPost[chain] = answer.catch(() => {});
  return answer;
}

const kVentTries = 100; // where a crowd of other connections costs it its own
const kVentPatience_ms = 500;

/**
 * Behind nothing: what else this page has asked for gives up its connections first.
 * @param answered  told after each try whether somebody has answered
 */
export async function vent(answered: (on: boolean) => void = () => {}): Promise<void> {
  others.abort();
  others = new AbortController();
  lastPost = noneYet();
  const send = () =>
    fetch('/api/arm/vent', {
      ...asJson({}),
      priority: 'high',
      keepalive: true,
      signal: AbortSignal.timeout(kVentPatience_ms),
    });
  for (let tries = 1; ; ++tries) {
    try {
      const response = await send();
      answered(true);
      await read(response);
      return;
    } catch (error) {
      if (error instanceof Refusal) throw error;
      answered(false);
      if (tries === kVentTries) throw new Refusal(0, kSilent);
    }
  }
}

const kAskAgain_ms = 2000;
const kSilence_ms = 2000; // ten of the studio's beats

/**
 * The page's own stream. A browser connects again by itself after a loss, as another tab; but not
 * after a refusal.
 * @param hears  told of a silence, which a connection outlives where a tunnel stalls, and of every event
 */
export function listen(handlers: Handlers, lost: (isRefused: boolean) => void, hears: (on: boolean) => void): void {
  const source = new EventSource('/api/events');
  let silence: ReturnType<typeof setTimeout> | undefined;
  // Each event puts the timer off: late in a tab in the background, it still finds none that has run out.
  const wait = () => {
    clearTimeout(silence);
    silence = setTimeout(() => hears(false), kSilence_ms);
  };
  const heard = () => {
    wait();
    hears(true);
  };
  wait();
  source.addEventListener('beat', heard);
  for (const kind of Object.keys(handlers) as (keyof Events)[]) {
    source.addEventListener(kind, (message) => {
      heard();
      (handlers[kind] as (event: unknown) => void)(JSON.parse((message as MessageEvent).data));
    });
  }
  source.onerror = () => {
    const isRefused = source.readyState === EventSource.CLOSED;
    clearTimeout(silence); // it is lost already
    lost(isRefused);
    if (isRefused) setTimeout(() => listen(handlers, lost, hears), kAskAgain_ms);
  };
}
