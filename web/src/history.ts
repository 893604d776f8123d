/** Undo and redo of values that never change. A drag is one step, however many values it passes. */
export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private before: T | undefined;

  constructor(private value: T) {}

  get now(): T {
    return this.value;
  }
  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** One step. */
  set(value: T): void {
    this.begin();
    this.change(value);
    this.end();
  }

  /** Until `end`, changes are one step. */
  begin(): void {
    this.before ??= this.value;
  }
  change(value: T): void {
    this.value = value;
  }
  end(): void {
    if (this.before !== undefined && this.before !== this.value) {
      this.past.push(this.before);
      this.future = [];
    }
    this.before = undefined;
  }

  undo(): void {
    this.end();
    this.step(this.past, this.future);
  }
  redo(): void {
    this.end();
    this.step(this.future, this.past);
  }
  private step(from: T[], to: T[]): void {
    const value = from.pop();
    if (value === undefined) return;
    to.push(this.value);
    this.value = value;
  }

  /** Another document: nothing before it can come back. */
  reset(value: T): void {
    this.value = value;
    this.past = [];
    this.future = [];
    this.before = undefined;
  }
}
