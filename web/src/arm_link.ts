import { type ArmFrame, type ArmStatus, post, vent } from './api';
import type { RunOptions } from './motion';

export type ArmRun = RunOptions & { limit_scale: number; plan?: number };

/**
 * The arm behind the driver, as this page sees it. Who arms it holds a lease, renewed by a worker;
 * VENT is everybody's.
 */
export class ArmLink {
  status: ArmStatus = { state: 'off', message: '', recording: '' };
  /** Whether the studio is heard: else nobody knows what has become of `status`. */
  isSeen = true;
  private frame: ArmFrame | null = null;
  paused = false;
  /** Whether what runs, or has just run, is this page's plan. */
  ownRun = false;
  private lease = '';
  private renewed = ''; // the same, until VENT is pressed
  private worker: Worker | null = null;
  private ready: Promise<void> | null = null;
  private ventNow: Promise<void> | null = null;
  /** Whether VENT was pressed, and its last try reached nobody. */
  isUnanswered = false;

  constructor(
    private readonly tab: () => string,
    private readonly changed: () => void,
  ) {
    window.addEventListener('beforeunload', (event) => {
      if (this.isMine) event.preventDefault(); // the browser asks
    });
  }

  /** Whether this page has armed it. */
  get isMine(): boolean {
    return this.lease !== '' && this.status.state !== 'off';
  }
  get runs(): boolean {
    return this.status.state === 'running' || this.ownRun;
  }
  /** Whether the arm may be under pressure still: the studio keeps saying so until the next arming. */
  get isAlarm(): boolean {
    return this.status.message.includes('NOT CONFIRMED');
  }
  /** The last frame of this page's run, while that goes on. */
  get live(): ArmFrame | null {
    return this.runs && this.ownRun ? this.frame : null;
  }

  /** Has the worker there before there is a lease to renew: its start may take seconds. */
  prepare(): void {
    const worker = new Worker(new URL('./lease_worker.ts', import.meta.url), { type: 'module' });
    this.worker = worker;
    this.ready = new Promise((resolve, reject) => {
      worker.onerror = () => reject(new Error('The page can’t renew its hold on the arm: load it again.'));
      worker.onmessage = ({ data }: MessageEvent<'ready' | 'over'>) => (data === 'ready' ? resolve() : this.drop());
    });
    this.ready.catch(() => {}); // arm() says it
  }
  async arm(): Promise<void> {
    await this.ready;
    const { lease } = await post<{ lease: string }>('arm/arm', { confirmed: true });
    this.lease = this.renewed = lease;
    this.renews(true);
    this.changed();
  }
  async disarm(): Promise<void> {
    await post('arm/disarm', { lease: this.lease });
    this.drop();
  }
  async run(options: ArmRun): Promise<void> {
    this.frame = null;
    this.paused = false;
    this.ownRun = true;
    try {
      await post('arm/run', { ...options, lease: this.lease, tab: this.tab() });
    } catch (error) {
      this.ownRun = false;
      throw error;
    }
  }
  async pause(paused: boolean): Promise<void> {
    await post('arm/pause', { lease: this.lease, paused });
    this.paused = paused;
    this.changed();
  }
  stop(): Promise<unknown> {
    return post('arm/stop', { lease: this.lease });
  }
  /** The same one until that has ended, however often it is pressed: a press is a pointer's, then a click's. */
  vent(): Promise<void> {
    this.renewed = ''; // where the request is lost, the lease runs out
    this.renews(false);
    if (this.ventNow) return this.ventNow;
    this.ventNow = vent((on) => {
      const isNews = this.isUnanswered === on;
      this.isUnanswered = !on;
      if (isNews) this.changed();
    }).finally(() => {
      this.ventNow = null;
      this.drop(); // over by now: what is armed next is another page's, even if nobody tells this one of the end
    });
    this.changed();
    return this.ventNow;
  }
  get isVenting(): boolean {
    return this.ventNow !== null;
  }

  /** Whether the lease, if there is one, is renewed. */
  renews(on: boolean): void {
    this.worker?.postMessage(on ? this.renewed : '');
  }

  sees(on: boolean): void {
    if (on === this.isSeen) return;
    this.isSeen = on;
    this.changed();
  }
  onStatus(status: ArmStatus): void {
    this.status = status;
    if (!this.isVenting) this.isUnanswered = false; // the studio is there again
    if (status.state !== 'running') {
      this.frame = null;
      this.ownRun = false;
    }
    if (status.state === 'off') this.drop();
    this.changed();
  }
  onFrame(frame: ArmFrame): void {
    this.frame = frame;
    if (this.ownRun) this.changed(); // nothing is shown of another page's
  }

  private drop(): void {
    this.lease = this.renewed = '';
    this.renews(false);
    this.changed();
  }
}
