import type { Plan } from './api';
import type { LivePlanner } from './planner';

/** From the hand to the screen: the frame after the first one that shows a certified plan. */
export class Latency {
  private measured: Plan | null = null;

  constructor(private readonly planner: LivePlanner) {}

  /** After each frame that was drawn. */
  measure(): void {
    const { plan, isCurrent, askedAt_ms: start } = this.planner;
    if (!plan || !isCurrent || this.measured?.request === plan.request) return;
    this.measured = plan;
    requestAnimationFrame((end) => {
      performance.clearMeasures(); // the newest alone is of use
      performance.measure('certified plan painted', { start, end: Math.max(start, end), detail: plan.request });
    });
  }
}
