import type { TrackKey } from './api';

export const trackNames: Record<TrackKey, string> = {
  simple: 'Simple model',
  network: 'Network',
  virtual_arm: 'Virtual arm',
  arm: 'The arm',
};
