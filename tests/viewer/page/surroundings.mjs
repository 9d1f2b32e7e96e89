// Whoever and whatever shows the page: hostile names, themes, narrow screens, paper, no WebGL, damaged files.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { join } from 'node:path';
import { ask, go, launch, open, ready } from '../support/browser.mjs';
import { readIndex, rewritten, withIndex } from '../support/page_file.mjs';
import { bidi, hostile } from '../support/reports.mjs';
import { browser, page, reports } from './session.mjs';

test('hostile names stay text', async () => {
  await go(page, '#q=f:script');
  await page.waitForSelector('.walk-row');
  assert.ok((await page.locator('.walk-row').textContent()).includes(hostile));
  await page.click('.walk-link');
  await page.waitForSelector('.walk');
  await ready(page);
  assert.ok((await page.locator('.walk-facts').textContent()).includes(hostile));
  await page.keyboard.press('End');
  for (const tab of ['failure', 'log', 'steps', 'file']) await page.click(`[data-tab=${tab}]`);
  assert.ok((await page.locator('.popup').textContent()).includes(hostile));
  const text = await page.locator('body').evaluate((body) => body.innerText);
  assert.ok(!text.includes('\u202E'), 'a character that turns the text round');
  assert.ok(bidi.includes('\u202E'));
  assert.equal(await page.locator('img[src="x"]').count(), 0);
  assert.deepEqual(page.complaints, []);
});

test('light and dark follow the system, and the button', async () => {
  const dark = await open(browser, reports.report, { colorScheme: 'dark' });
  const background = () => dark.evaluate(() => Number(/\d+/.exec(getComputedStyle(document.body).backgroundColor)[0]));
  assert.ok((await background()) < 60);
  await dark.click('.top-bar button >> nth=0');
  assert.ok((await background()) > 200);
  await dark.click('.top-bar button >> nth=0');
  assert.ok((await background()) < 60);
  assert.deepEqual(dark.complaints, []);
  await dark.context().close();
});

test('a narrow screen has all without scrolling sideways', async () => {
  const narrow = await open(browser, reports.report, { width: 390, height: 844 });
  const fits = () => narrow.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
  assert.ok(await fits());
  await go(narrow, '#walk=to-the-bench.walk.yaml');
  await narrow.locator('.transport .primary').waitFor();
  assert.ok(await fits());
  await narrow.locator('.panel').scrollIntoViewIfNeeded();
  await narrow.locator('.failures .message').waitFor();
  await narrow.context().close();
});

test('paper has the failures', async () => {
  await go(page, '#');
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  assert.ok(await page.locator('.printed table').isVisible());
  assert.match(await page.locator('.printed tbody tr').first().textContent(), /^failed/);
  await page.emulateMedia({ media: 'screen' });
});

test('without WebGL there are list, plan, log and pictures, and a note', async () => {
  const flat = await open(await launch({ webgl: false }), reports.report, { hash: '#walk=to-the-bench.walk.yaml' });
  assert.match(await flat.locator('.banner').textContent(), /can't draw in 3D/);
  assert.ok(await flat.locator('.walk-plan canvas').isVisible());
  await flat.click('[data-tab=log]');
  await flat.click('.log-line[data-tick="386"] >> nth=0');
  assert.equal((await ask(flat, 'state')).tick, 386);
  await flat.click('[data-tab=pictures]');
  assert.equal(await flat.locator('.pictures img').count(), 3);
  await go(flat, '#');
  await flat.waitForFunction(() => document.querySelectorAll('.walk-row').length === 9);
  assert.deepEqual(
    flat.complaints.filter((text) => !/WebGL/.test(text)),
    [],
  );
});

test('a damaged report says so', async () => {
  const copy = (name, change) => rewritten(reports.report, join(reports.folder, `${name}.html`), change);
  const cases = [
    [
      copy('truncated', (text) => text.replace(/<script[^>]*data-chunk="index"[^>]*>[^<]*<\/script>/, '')),
      /isn't complete/,
    ],
    [copy('damaged', (text) => text.replace(/(data-chunk="index"[^>]*>)[^<]{40}/, '$1')), /damaged/],
    [
      withIndex(reports.report, join(reports.folder, 'foreign.html'), () => ({ something: 'else' })),
      /holds no campuswalk report/,
    ],
    [
      withIndex(reports.report, join(reports.folder, 'newer.html'), (index) => void (index.campuswalk_report = 2)),
      /another version/,
    ],
  ];
  for (const [file, message] of cases) {
    const broken = await open(browser, file);
    assert.match(await broken.locator('[role=alert]').textContent(), message);
    await broken.context().close();
  }
});

test('a walk whose details are damaged says so, and the list goes on', async () => {
  const row = readIndex(reports.report).walks.find((each) => each.name === 'looks-round');
  const file = rewritten(reports.report, join(reports.folder, 'details.html'), (text) =>
    text.replace(new RegExp(`(data-chunk="${row.chunk}"[^>]*>)[^<]{40}`), '$1'),
  );
  const broken = await open(browser, file, { hash: `#walk=${row.id}` });
  assert.match(await broken.locator('[role=alert]').textContent(), /damaged/);
  await broken.click('text=All walks');
  await broken.waitForSelector('.walk-row');
  assert.deepEqual(broken.complaints, []);
  await broken.context().close();
});
