import type { Point } from './environment';
import type { Scene } from './picture';

/** One of the things to do; each fills the panel and says what is shown. */
export interface Mode {
  enter(panel: HTMLElement): void;
  leave(): void;
  /** Something has changed: the panel follows. */
  refresh(): void;
  /** What was asked for under that number was refused. */
  onFault(request: number, message: string): void;
  scene(): Partial<Scene>;
  /** What a pointer does, in metres. Whether it grabs something: else it moves the stage. */
  down?(at: Point, reach_m: number): boolean;
  /** @param at_ms  when the hand was there */
  drag?(at: Point, at_ms: number): void;
  /** @param isCut  by something else than the hand */
  up?(isCut: boolean): void;
  /** What stands for what on the stage: class of the swatch, and words. */
  legend(): [string, string][];
}
