import { type Environment, type Plan, post, type Progress, type Result, type Tree } from './api';

export type PlanQuestion = {
  arm: string;
  model: string;
  environment: Environment;
  time_limit_s: number;
  tree: boolean;
  limit_scale: number;
  margin_m: number | null; // null: what the model's error asks for
};

/** So long a search goes on although there is a newer question: else a quick hand sees no plan. */
const kPatience_ms = 80;

/**
 * Asks for plans. While one question waits for its first answer, only the newest of those that
 * follow waits, so that a drag never queues. Answers to older questions are dropped.
 */
export class LivePlanner {
  plan: Plan | null = null;
  progress: Progress | null = null;
  result: Result | null = null;
  tree: number[] | null = null; // of the search, while it grows and when it has ended
  fault = '';
  searching = false;
  private request = 0;
  private awaited = 0; // the request of a plan that is being opened; 0: none
  private opens = 2 ** 32; // these requests' numbers: no other work's fault is taken for theirs
  private sending = false;
  private seed = 1;
  private scene: Environment | null = null; // of the question before
  private next: { question: PlanQuestion & { seed: number }; asked_ms: number } | null = null;
  private asked_ms = 0;
  private heard = () => {}; // the question that was sent needs no more patience

  constructor(
    private readonly tab: () => string,
    /** @param seen  whether the picture changes too, or words alone */
    private readonly changed: (seen?: boolean) => void,
  ) {}

  /** Whether the plan answers the last question, and none takes its place. */
  get isCurrent(): boolean {
    return this.plan !== null && this.plan.request === this.request && this.awaited === 0;
  }
  /** The studio's number of the plan: of the request that found or opened it. */
  get number(): number | undefined {
    return this.plan?.opened ?? this.plan?.request;
  }
  /** When the event happened that the plan answers. [ms of performance.now] */
  get askedAt_ms(): number {
    return this.asked_ms;
  }

  /** @param again  by other samples, if the scene is that of the question before */
  ask(question: PlanQuestion, asked_ms: number, again = false): void {
    if (question.environment !== this.scene) this.seed = 1;
    else if (again) ++this.seed;
    this.scene = question.environment;
    this.next = { question: { ...question, seed: this.seed }, asked_ms };
    if (this.tab() === '') ++this.request; // nobody answers for now: the plan is of another scene
    this.begin();
    void this.send();
  }
  /** What was said of the question before is over. */
  private begin(): void {
    this.searching = true;
    this.awaited = 0;
    this.progress = this.result = this.tree = null;
    this.fault = '';
  }
  /** The hand has let go: the newest question goes at once. */
  hurry(): void {
    if (this.next !== null) this.heard();
  }

  /** No further answer is awaited; a plan is of another scene if a newer question still waited. */
  end(): void {
    if (this.next !== null) ++this.request;
    this.next = null;
    this.searching = false;
    this.heard();
  }
  forget(): void {
    this.end();
    ++this.request;
    this.awaited = 0;
    this.plan = this.progress = this.result = this.tree = null;
    this.fault = '';
  }

  /** A plan is being opened; until it is there, the one before stays. @return the request that it answers */
  expect(): number {
    this.giveUp();
    this.end();
    this.awaited = ++this.opens;
    return this.awaited;
  }
  isAwaited(request: number): boolean {
    return request !== 0 && request === this.awaited;
  }
  /** Where it was not refused, the studio may have opened it already: then the one before is no more. */
  giveUp(): void {
    if (this.awaited !== 0) this.forget();
  }
  /**
   * The plan before is current again.
   * @param mayBeOpen  in the studio: then the one before is no more
   * @return whether that was the plan to be opened
   */
  refuse(request: number, mayBeOpen = false): boolean {
    if (!this.isAwaited(request)) return false;
    if (mayBeOpen) this.giveUp();
    this.awaited = 0;
    this.changed();
    return true;
  }

  async stop(): Promise<void> {
    this.end();
    this.changed();
    await post('stop', { tab: this.tab() });
  }

  /** One that was opened. */
  take(plan: Plan): void {
    this.awaited = 0;
    this.onPlan({ ...plan, opened: plan.request, request: ++this.request });
  }
  onPlan(plan: Plan): void {
    if (plan.request !== this.request) return;
    this.plan = plan;
    this.heard();
    this.changed();
  }
  onProgress(progress: Progress): void {
    if (progress.request !== this.request) return;
    this.progress = progress;
    this.changed(false);
  }
  onTree({ request, tree }: Tree): void {
    if (request !== this.request) return;
    this.tree = tree;
    this.changed();
  }
  onResult(result: Result): void {
    if (result.request !== this.request) return;
    this.result = result;
    this.tree = result.tree;
    this.searching = false;
    this.heard();
    if (result.status !== 'solved') this.plan = null;
    this.changed();
  }
  onFault(request: number, message: string): void {
    if (request !== this.request) return;
    this.fault = message;
    this.plan = null;
    this.searching = false;
    this.heard();
    this.changed();
  }

  private async send(): Promise<void> {
    if (this.sending || this.next === null || this.tab() === '') return;
    const { question, asked_ms } = this.next;
    this.next = null;
    const wasAnswered = this.result !== null || this.fault !== '';
    this.begin();
    if (wasAnswered) this.changed(); // while this one waited
    this.sending = true;
    this.asked_ms = asked_ms;
    const request = ++this.request;
    const heard = new Promise<void>((done) => {
      this.heard = done;
      setTimeout(done, kPatience_ms);
    });
    try {
      await post('plan', { ...question, request, tab: this.tab() });
      await heard;
    } catch (error) {
      this.onFault(request, (error as Error).message);
    } finally {
      this.sending = false;
    }
    void this.send();
  }
}
