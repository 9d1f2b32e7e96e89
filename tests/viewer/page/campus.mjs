// The campus in 3D: where it is, what it is called, what authors copy from it.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { join } from 'node:path';
import { ask } from '../support/browser.mjs';
import { detailsOf, readIndex } from '../support/page_file.mjs';
import { readDepth } from '../support/png.mjs';
import { goToWalk, page, reports, state } from './session.mjs';

describe('the campus', () => {
  test('is where the program draws it, to 2 cm', async () => {
    const row = readIndex(reports.report).walks.find((each) => each.name === 'looks-round');
    const { recording } = detailsOf(reports.report, row);
    const tick = Number(recording.log.find((line) => line.includes('snapshot.take')).split(/\s/)[0]);
    await goToWalk('looks-round', tick / 60);
    await page.keyboard.press('1');
    await page.waitForTimeout(150);
    const depth = readDepth(join(reports.output, 'looks-round/square-depth.png'));
    const camera = await ask(page, 'camera');
    const view = viewOf(camera, depth.width / depth.height);
    const canvas = await page
      .locator('canvas.scene')
      .evaluate(({ clientWidth, clientHeight }) => ({ clientWidth, clientHeight }));
    const across = view.half * (canvas.clientWidth / canvas.clientHeight);
    let compared = 0;
    for (let i = 0; i < 60; ++i) {
      const [px, py] = [16 + ((i * 67) % (depth.width - 32)), 60 + ((i * 29) % (depth.height - 64))];
      const at = depth.at(px, py);
      // Not where a pixel's neighbours are of other things, or seen so flat that a pixel is long; the sky is nowhere.
      const around = [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
      ].map(([dx, dy]) => Math.abs(depth.at(px + dx, py + dy) - at));
      if (at < 0.3 || at > 30 || Math.max(...around) > 0.15) continue;
      const [sx, sy] = [
        (((px + 0.5) / depth.width) * 2 - 1) * view.half * (depth.width / depth.height),
        (1 - ((py + 0.5) / depth.height) * 2) * view.half,
      ];
      const expected = view.point(sx, sy, at);
      const picked = await ask(
        page,
        'pick',
        ((sx / across + 1) / 2) * canvas.clientWidth,
        ((1 - sy / view.half) / 2) * canvas.clientHeight,
      );
      assert.ok(picked, `nothing at ${px}, ${py}`);
      const apart = Math.hypot(...picked.point.map((value, k) => value - expected[k]));
      assert.ok(apart < 0.02, `${apart} m at pixel ${px}, ${py}: ${picked.point}, drawn at ${expected}`);
      ++compared;
    }
    assert.ok(compared >= 15, `${compared} pixels`);
    await page.keyboard.press('2');
  });

  test('can be cut above a storey', async () => {
    // Inside the library: from above there is its roof, then the visitor's floor.
    await goToWalk('first-tour', 176.5);
    await page.keyboard.press('3');
    await page.waitForTimeout(150);
    const { y } = await ask(page, 'visitorAt');
    const middle = await page
      .locator('canvas.scene')
      .evaluate(({ clientWidth, clientHeight }) => [clientWidth / 2 + 3, clientHeight / 2 + 3]);
    const roof = await ask(page, 'pick', ...middle);
    assert.ok(roof.point[1] > y + 3 && roof.objects.includes('library/walls'), JSON.stringify(roof));
    await page.keyboard.press('x');
    const floor = await ask(page, 'pick', ...middle);
    assert.ok(Math.abs(floor.point[1] - y) < 1.2, JSON.stringify(floor));
    await page.click('text=Storeys');
    await page.click('.cut-storeys >> text=All');
    assert.equal((await state()).cut, null);
    await page.click('.cut-storeys button >> nth=2');
    assert.ok((await state()).cut > 0);
    await page.keyboard.press('Escape');
    await page.keyboard.press('x');
    assert.equal((await state()).cut, null);
    await page.keyboard.press('2');
  });

  test('names what is under the pointer', async () => {
    await goToWalk('first-tour', 21.2);
    const canvas = page.locator('canvas.scene');
    const { x, y, width, height } = await canvas.boundingBox();
    const spots = [];
    for (let i = 0; i < 40; ++i)
      spots.push([width * (0.3 + (i % 8) * 0.05), height * (0.5 + Math.floor(i / 8) * 0.07)]);
    let spot = null;
    for (const [px, py] of spots)
      if ((await ask(page, 'pick', px, py))?.objects.includes('bench/bench-01')) spot ??= [px, py];
    assert.ok(spot, 'the bench is not in view');
    await page.mouse.move(x + spot[0], y + spot[1]);
    assert.match(
      await page.locator('.hover-card').textContent(),
      /bench\/bench-01.*touched at 20\.25 s.*in the visitor's way at 21\.18 s/,
    );
    await page.mouse.move(2, 2);
  });

  test('gives authors coordinates, steps and a trigger', async () => {
    await goToWalk('first-tour', 20);
    await page.keyboard.press('3');
    await page.keyboard.press('p');
    const { x, y, width, height } = await page.locator('canvas.scene').boundingBox();
    const click = async (px, py) => {
      const hit = await ask(page, 'pick', px, py);
      await page.mouse.click(x + px, y + py);
      return hit.point;
    };
    const point = await click(width * 0.4, height * 0.7);
    const numbers = (text) => text.match(/-?\d+(\.\d+)?/g).map(Number);
    const copied = numbers(await ask(page, 'copied'));
    assert.ok(
      copied.every((value, i) => Math.abs(value - point[i]) <= 0.0006),
      `${copied} for ${point}`,
    );
    await click(width * 0.45, height * 0.8);
    const snippets = await page.locator('.snippets').textContent();
    assert.match(snippets, /- walk_to: \[/);
    assert.match(snippets, /- follow:\n {4}- \[.*\n {4}- \[/);
    await page.keyboard.press('b');
    await page.mouse.move(x + width * 0.4, y + height * 0.6);
    await page.mouse.down();
    await page.mouse.move(x + width * 0.5, y + height * 0.7, { steps: 4 });
    await page.mouse.up();
    const yaml = await page.locator('.snippets section:has-text("Trigger") pre').textContent();
    assert.match(yaml, /^- id: .*\n(.*\n)? {2}mode: trigger\n {2}shape: box\n {2}center: \[.*\]\n {2}size: \[.*\]$/);
    await page.keyboard.press('b');
    await page.keyboard.press('2');
  });
});

/** A camera that looks along `direction`, with a vertical field of view of 60 degrees. */
function viewOf({ position, direction }) {
  const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const right = cross(direction, [0, 1, 0]);
  const length = Math.hypot(...right);
  const unit = right.map((value) => value / length);
  const up = cross(unit, direction);
  return {
    half: Math.tan(Math.PI / 6),
    /** At so many metres along the axis. */
    point: (x, y, depth) => position.map((value, i) => value + depth * (direction[i] + x * unit[i] + y * up[i])),
  };
}
