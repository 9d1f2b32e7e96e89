// Failures, and runs that are compared.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { ask, open, ready } from '../support/browser.mjs';
import { readIndex } from '../support/page_file.mjs';
import { browser, goToWalk, page, reports, state } from './session.mjs';

describe('a failure', () => {
  test('is shown where and when it came, with what is in the way', async () => {
    await goToWalk('to-the-bench');
    assert.deepEqual([(await state()).tick, (await state()).tab], [1304, 'failure']);
    const { position, direction } = await ask(page, 'camera');
    const obstacle = [1.68, -0.95, 62];
    const to = obstacle.map((value, i) => value - position[i]);
    const distance = Math.hypot(...to);
    const cosine = to.reduce((sum, value, i) => sum + value * direction[i], 0) / distance;
    assert.ok(distance < 8 && cosine > 0.9, `${distance} m away, cosine ${cosine}`);
    const middle = await page
      .locator('canvas.scene')
      .evaluate(({ clientWidth, clientHeight }) => [clientWidth, clientHeight]);
    let red = 0;
    for (let i = 0; i < 100; ++i)
      red += (
        await ask(page, 'pick', (middle[0] * (i % 10)) / 10, (middle[1] * Math.floor(i / 10)) / 10)
      )?.objects.includes('bench/bench-01')
        ? 1
        : 0;
    assert.ok(red > 0, 'the bench is not seen');
    assert.deepEqual(await ask(page, 'lit'), ['bench/bench-01']);
    const panel = await page.locator('.failures').textContent();
    assert.match(panel, /walk_to bench was not reached/);
    assert.match(panel, /campuswalk run to-the-bench\.walk\.yaml/);
    assert.match(await page.locator('.failures .code-line.marked').textContent(), /- walk_to: bench/);
  });

  test('has its riser in numbers', async () => {
    await goToWalk('onto-the-planter');
    assert.match(await page.locator('.failures .measure').textContent(), /riser0\.45 m.*0\.30 m/);
  });

  test('of a picture has a slider', async () => {
    await goToWalk('snapshot-fails');
    await page.click('[data-tab=pictures]');
    await page.waitForFunction(() =>
      [...document.querySelectorAll('.slider img')].every((image) => image.complete && image.naturalWidth > 0),
    );
    assert.equal(await page.locator('.slider img').count(), 2);
    await page.locator('.slider-input').fill('250');
    assert.match(await page.locator('.slider-over').evaluate((over) => over.style.clipPath), /25%/);
    await page.click('.comparison >> text=Difference');
    assert.equal(await page.locator('.comparison-stage img').count(), 1);
  });
});

test('a comparison lists what changed, and shows both paths', async () => {
  const compared = await open(browser, reports.compared);
  await compared.click('text=Against');
  assert.match(await compared.locator('.walk-row').textContent(), /to-the-bench.*passed→failed/);
  await compared.click('.walk-row .walk-link');
  await compared.waitForSelector('.legend');
  await ready(compared);
  const { index, parts_at: partsAt } = readIndex(reports.compared).against.walks[0];
  assert.equal((await ask(compared, 'state')).tick, partsAt);
  assert.equal((await ask(compared, 'figures')).length, 2);
  assert.ok(index >= 0);
  assert.match(await compared.locator('.label.parting').textContent(), /part/);
  assert.deepEqual(compared.complaints, []);
  await compared.context().close();
});

test("a walk that can't be read has its errors, and the lines that they are about", async () => {
  const compared = await open(browser, reports.compared, { hash: '#walk=goes-nowhere.walk.yaml' });
  await compared.waitForSelector('.failures .failure');
  const codes = await compared.locator('.failures .code').allTextContents();
  assert.deepEqual(codes, ['missing-file', 'unknown-key', 'wrong-type']);
  assert.match(await compared.locator('.failures .message').nth(1).textContent(), /'walks_to'.*'walk_to'/);
  const marked = await compared.locator('.failures .failure').nth(1).locator('.code-line.marked code').allTextContents();
  assert.deepEqual(marked, ['campus: missing.campus.yaml', '  - walks_to: square', '  - wait: long']);
  assert.deepEqual(compared.complaints, []);
  await compared.context().close();
});
