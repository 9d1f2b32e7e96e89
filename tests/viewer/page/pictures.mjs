// The canvas against pictures that were looked at.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { spawnSync } from 'node:child_process';
import { copyFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ask, go, open } from '../support/browser.mjs';
import { program, root } from '../support/reports.mjs';
import { browser, page, reports } from './session.mjs';

// UPDATE_IMAGES=1 writes them anew.
const images = join(root, 'tests/viewer/images');

describe('the pictures of', () => {
  const views = [
    ['list', () => reports.report, '#'],
    ['walk', () => reports.report, '#walk=first-tour.walk.yaml&t=170'],
    ['failure', () => reports.report, '#walk=to-the-bench.walk.yaml'],
    ['comparison', () => reports.compared, '#walk=to-the-bench.walk.yaml&against=1'],
  ];
  for (const [name, report, hash] of views) {
    test(`${name} are as they were`, async () => {
      const shown = report() === reports.report ? page : await open(browser, report());
      await shown.mouse.move(2, 2); // a row under the pointer emphasizes its path
      await go(shown, '#');
      await go(shown, hash);
      const address = await ask(shown, 'picture', 320, 180);
      if (shown !== page) await shown.context().close();
      const actual = join(reports.folder, `${name}.png`);
      writeFileSync(actual, Buffer.from(address.split(',')[1], 'base64'));
      const expected = join(images, `${name}.png`);
      if (process.env.UPDATE_IMAGES) copyFileSync(actual, expected);
      // Colours may round otherwise on another processor; lines may lie half a pixel elsewhere in another Chromium.
      const limits = ['--max-diff-pixel-ratio', '0.01', '--min-tile-ssim', '0.8'];
      const compared = spawnSync(program, ['imgdiff', expected, actual, ...limits], { encoding: 'utf8' });
      assert.equal(compared.status, 0, `${compared.stdout}${compared.stderr}`);
    });
  }
});
