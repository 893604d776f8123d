// What users have made before they open the studio.

import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { network, program, root } from './studio.mjs';

/** A model, a recording and a small experiment in the project folder. */
export function makeResults(project) {
  const at = (name) => join(project, name);
  for (const folder of ['models', 'recordings', 'environments']) mkdirSync(at(folder));
  copyFileSync(network, at('models/ten_hours.safetensors'));
  copyFileSync(join(root, 'environments/01_pillar.yaml'), at('environments/01_pillar.yaml'));
  const limber = (...words) => execFileSync(program, words, { stdio: ['ignore', 'ignore', 'inherit'] });
  limber('collect', '--schedule', 'random', '--count', '6', '--seed', '5', '--out', at('recordings/six.h5'));
  limber('experiment', '--environments', at('environments'), '--model', network, '--trials', '2',
    '--max-queries', '20000', '--jobs', '1', '--out', at('results/table'));
}
