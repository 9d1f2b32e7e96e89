// The list of walks.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { join } from 'node:path';
import { ask, open } from '../support/browser.mjs';
import { withIndex } from '../support/page_file.mjs';
import { browser, goToWalk, page, reports, totals } from './session.mjs';

describe('the list', () => {
  test('opens from disk without a message or a request', async () => {
    await page.waitForTimeout(1500);
    assert.deepEqual(page.complaints, []);
    assert.match(await totals(), /^9 walks/);
  });

  test('has the failures first', async () => {
    const rows = await page.locator('.walk-row').evaluateAll((list) => list.map((row) => row.className));
    const lastBad = rows.findLastIndex((name) => /\bfailed\b/.test(name));
    assert.equal(lastBad, rows.filter((name) => /\bfailed\b/.test(name)).length - 1);
    assert.equal(lastBad, 2);
  });

  test('shows a picture or a plan of each path', async () => {
    await page.waitForTimeout(300);
    assert.ok((await page.locator('img.thumbnail').count()) >= 3);
    const inked = await page.locator('canvas.thumbnail').evaluateAll((list) =>
      list.map((canvas) => {
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        return new Set(new Uint32Array(data.buffer)).size;
      }),
    );
    assert.ok(inked.length >= 2 && inked.every((colours) => colours > 3), String(inked));
  });

  test('filters as it is told', async () => {
    const filter = async (query) => {
      await page.fill('.filter-box', query);
      return (await totals()).split(' · ')[0];
    };
    assert.equal(await filter('s:failed'), '3 of 9 walks');
    assert.equal(await filter('s:failed @smoke'), '1 of 9 walks');
    assert.equal(await filter('@smoke bench'), '1 of 9 walks');
    assert.equal(await filter('!s:failed'), '6 of 9 walks');
    assert.equal(await filter('nothing has this'), '0 of 9 walks');
    assert.match(await page.locator('.list-empty').textContent(), /No walk matches/);
    await page.click('text=Remove the filter');
    assert.equal((await totals()).split(' · ')[0], '9 walks');
    await page.click('.count-chip.failed');
    assert.equal(await page.inputValue('.filter-box'), 's:failed');
    await page.waitForFunction(() => location.hash === '#q=s:failed');
    await page.fill('.filter-box', '');
  });

  test('has all its paths in a picture that is taken at once', async () => {
    await page.mouse.move(2, 2);
    await goToWalk('first-tour');
    // Within the page, so that nothing but the page itself takes time.
    const pictures = await page.evaluate(async () => {
      const listed = new Promise((resolve) => addEventListener('hashchange', resolve, { once: true }));
      location.hash = '#';
      await listed;
      const atOnce = await window.campuswalk.picture(320, 180);
      await new Promise((resolve) => setTimeout(resolve, 300));
      return [atOnce, await window.campuswalk.picture(320, 180)];
    });
    assert.equal(pictures[0], pictures[1]);
  });

  test('of ten thousand walks scrolls and filters at once', async () => {
    const many = withIndex(reports.report, join(reports.folder, 'many.html'), (index) => {
      const rows = index.walks;
      index.walks = Array.from({ length: 10_000 }, (_, i) => ({
        ...rows[i % rows.length],
        id: `many/${i}.walk.yaml`,
        file: `many/${i}.walk.yaml`,
        name: `walk-${i}`,
        outcome: i % 50 === 7 ? 'failed' : 'passed',
      }));
    });
    const large = await open(browser, many, { width: 900 });
    const times = [];
    for (const query of ['s:failed', '@smoke', 'walk-77', '!s:passed', '']) {
      await large.fill('.filter-box', query);
      times.push((await ask(large, 'statistics')).filterTime);
    }
    assert.match(await totals(large), /^10,000 walks/);
    // The limit is 100 ms; the machine may be doing other things for a while, but not all the time.
    assert.ok(times.sort((a, b) => a - b)[2] <= 100, `filtering took ${times.map(Math.round)} ms`);
    await large.locator('.walks').evaluate((list) => (list.scrollTop = list.scrollHeight));
    await large.waitForTimeout(200);
    assert.ok((await large.locator('.walk-row').count()) < 60);
    assert.deepEqual(large.complaints, []);
    await large.context().close();
  });
});
