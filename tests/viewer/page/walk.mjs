// One walk: the visitor, time, cameras, keys.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ask, go, open, ready } from '../support/browser.mjs';
import { browser, goToWalk, page, reports, state } from './session.mjs';

/** Where the program says the visitor is at every tick. */
function trajectory(name) {
  const folder = join(reports.output, name);
  const [head, ...lines] = readFileSync(
    join(
      folder,
      readdirSync(folder).find((file) => file.endsWith('.csv')),
    ),
    'utf8',
  )
    .trim()
    .split('\n');
  const columns = head.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, i) => [columns[i], Number(value)])));
}

describe('a walk', () => {
  test('is opened by its address, though the page is about to write its own', async () => {
    const shown = await open(browser, reports.report);
    await shown.evaluate(() => {
      // The page's next delayed work runs when told, which is between an address and the event that tells of it.
      const later = window.setTimeout;
      let write = () => {};
      window.setTimeout = (work) => ((write = work), 1);
      const filter = document.querySelector('.filter-box');
      filter.value = 's:failed';
      filter.dispatchEvent(new Event('input'));
      window.setTimeout = later;
      location.hash = '#walk=to-the-bench.walk.yaml';
      write();
    });
    await shown.waitForSelector('.transport .primary');
    assert.match(await shown.locator('.walk-title').textContent(), /to-the-bench/);
    await shown.context().close();
  });

  test('is opened by its row, and by its address at a time', async () => {
    await page.click('.walk-link:has-text("first-tour")');
    await page.waitForSelector('.walk');
    await ready(page);
    assert.equal(await page.locator('.walk-title h1').textContent(), 'first-tour');
    await goToWalk('first-tour', 12.35);
    assert.equal((await state()).tick, 741);
    const direct = await open(browser, reports.report, { hash: '#walk=adult-visit.walk.yaml&t=3.5&camera=top' });
    assert.deepEqual([(await ask(direct, 'state')).tick, (await ask(direct, 'state')).camera], [210, 'top']);
    assert.deepEqual(direct.complaints, []);
    await direct.context().close();
  });

  for (const name of ['first-tour', 'adult-visit', 'robot-delivery']) {
    test(`has the visitor where the log of ${name} says, to a millimetre at every tick`, async () => {
      await goToWalk(name);
      const expected = trajectory(name);
      const shown = await page.evaluate(
        (count) => Array.from({ length: count }, (_, tick) => window.campuswalk.visitorAt(tick)),
        expected.length,
      );
      const worst = Math.max(
        ...expected.map((at, tick) =>
          Math.max(...['x', 'y', 'z'].map((axis) => Math.abs(at[axis] - shown[tick][axis]))),
        ),
      );
      assert.ok(worst <= 0.0010001, `${worst} m`);
      const turned = Math.max(
        ...expected.map((at, tick) => Math.abs(Math.sin((at.yaw_deg * Math.PI) / 180 - shown[tick].yaw))),
      );
      assert.ok(turned < 0.01, `${turned} rad`);
      // And the figure itself, at ten times.
      for (let i = 1; i <= 10; ++i) {
        const tick = Math.floor((expected.length * i) / 11);
        await go(page, `#walk=${name}.walk.yaml&t=${tick / 60}`);
        const figure = await ask(page, 'figure');
        assert.ok(
          ['x', 'y', 'z'].every((axis, k) => Math.abs(figure[k] - expected[tick][axis]) <= 0.0010001),
          `tick ${tick}`,
        );
      }
    });
  }

  test('goes where a line of the log or a mark of the time line says', async () => {
    await goToWalk('first-tour', 0);
    await page.click('[data-tab=log]');
    await page.click('.log-line[data-tick="386"] >> nth=0');
    assert.equal((await state()).tick, 386);
    const track = page.locator('.timeline-track');
    const { x, y, width } = await track.boundingBox();
    await page.mouse.click(x + (width * 729) / (await state()).ticks + 2, y + 42);
    assert.equal((await state()).tick, 729);
    assert.equal(await page.locator('.log-line.current').getAttribute('data-tick'), '729');
    await page.mouse.click(x + width / 2, y + 12);
    const { tick, ticks } = await state();
    assert.ok(Math.abs(tick - ticks / 2) < ticks / 100);
  });

  test('shows its pop-ups while they are open', async () => {
    await goToWalk('first-tour', 6.4);
    assert.ok(await page.locator('.popup').isHidden());
    await goToWalk('first-tour', 6.45);
    assert.match(await page.locator('.popup').textContent(), /^Gatehousegatehouse.*Two lodges/);
    await goToWalk('first-tour', 12.2);
    assert.ok(await page.locator('.popup').isHidden());
  });

  test('plays, pauses and ends', async () => {
    await goToWalk('adult-visit', 1);
    await page.selectOption('.transport select', '5');
    await page.click('.transport .primary');
    await page.waitForTimeout(1500);
    const playing = await state();
    assert.ok(
      playing.playing && playing.tick > 60 + 5 * 60 * 0.5 && playing.tick < 60 + 5 * 60 * 4,
      `tick ${playing.tick}`,
    );
    await page.click('.transport .primary');
    assert.equal((await state()).playing, false);
    await page.selectOption('.transport select', '50');
    await page.click('.transport .primary');
    await page.waitForFunction(() => !window.campuswalk.state().playing, null, { timeout: 20_000 });
    assert.equal((await state()).tick, (await state()).ticks);
    await page.selectOption('.transport select', '1');
  });

  test('obeys the keys', async () => {
    await goToWalk('first-tour', 10);
    const after = async (key) => {
      await page.keyboard.press(key);
      return state();
    };
    assert.equal((await after('.')).tick, 601);
    assert.equal((await after(',')).tick, 600);
    assert.equal((await after('ArrowRight')).tick, 660);
    assert.equal((await after(']')).tick, 729);
    assert.equal((await after('[')).tick, 556);
    assert.equal((await after('End')).tick, (await state()).ticks);
    assert.equal((await after('Home')).tick, 0);
    assert.equal((await after('+')).speed, 2);
    assert.equal((await after('-')).speed, 1);
    for (const [key, camera] of [
      ['1', 'first'],
      ['3', 'top'],
      ['4', 'orbit'],
      ['5', 'free'],
      ['2', 'third'],
    ])
      assert.equal((await after(key)).camera, camera);
    assert.equal((await after(' ')).playing, true);
    assert.equal((await after(' ')).playing, false);
    await page.keyboard.press('?');
    assert.ok(await page.locator('dialog.help').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('dialog.help').isHidden());
    await page.keyboard.press('j');
    await page.waitForFunction(() => !location.hash.includes('first-tour'));
    await ready(page);
    await page.keyboard.press('Escape');
    await page.waitForSelector('.list');
    await page.keyboard.press('/');
    assert.ok(await page.locator('.filter-box').evaluate((box) => box === document.activeElement));
    await page.keyboard.press('Escape');
  });

  test('has cameras that move as they are called', async () => {
    await goToWalk('first-tour', 30);
    const at = await ask(page, 'visitorAt');
    const seen = async (key) => {
      await page.keyboard.press(key);
      return ask(page, 'camera');
    };
    const eyes = await seen('1');
    assert.ok(Math.hypot(eyes.position[0] - at.x, eyes.position[2] - at.z) < 1e-6 && eyes.position[1] - at.y > 1.5);
    assert.ok(
      Math.abs(Math.atan2(-eyes.direction[0], -eyes.direction[2]) - Math.atan2(Math.sin(at.yaw), Math.cos(at.yaw))) <
        1e-3,
    );
    const top = await seen('3');
    assert.ok(top.direction[1] < -0.999 && Math.abs(top.position[1] - at.y - 40) < 1e-6);
    const behind = await seen('2');
    const away = Math.hypot(behind.position[0] - at.x, behind.position[2] - at.z);
    assert.ok(away > 0.5 && away < 4.1, `${away} m`);
    await page.keyboard.press('5');
    await page.locator('canvas.scene').focus();
    await page.keyboard.down('w');
    await page.waitForFunction(
      (from) => Math.hypot(...window.campuswalk.camera().position.map((value, i) => value - from[i])) > 1,
      behind.position,
    );
    await page.keyboard.up('w');
    const flown = await ask(page, 'camera');
    const along = flown.position.reduce((sum, value, i) => sum + (value - behind.position[i]) * behind.direction[i], 0);
    assert.ok(along > 0.99, `${along} m ahead`);
    await page.keyboard.press('2');
  });
});
