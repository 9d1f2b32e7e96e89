// Real reports in a real Chromium. Needs the program; see support/reports.mjs.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { spawnSync } from 'node:child_process';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ask, closeAll, go, launch, open, ready } from './support/browser.mjs';
import { detailsOf, readIndex, rewritten, withIndex } from './support/page_file.mjs';
import { readDepth } from './support/png.mjs';
import { bidi, hostile, makeReports, program } from './support/reports.mjs';

// UPDATE_IMAGES=1 writes them anew.
const images = join(dirname(fileURLToPath(import.meta.url)), 'images');
let reports;
let browser;
let page;

before(async () => {
  reports = makeReports();
  browser = await launch();
  page = await open(browser, reports.report);
});
after(async () => {
  await closeAll();
  reports?.remove();
});

const state = () => ask(page, 'state');
const walk = (name, time) => go(page, `#walk=${name}.walk.yaml${time === undefined ? '' : `&t=${time}`}`);
const totals = (on = page) => on.locator('.totals').textContent();

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

describe('a walk', () => {
  test('is opened by its row, and by its address at a time', async () => {
    await page.click('.walk-link:has-text("first-tour")');
    await page.waitForSelector('.walk');
    await ready(page);
    assert.equal(await page.locator('.walk-title h1').textContent(), 'first-tour');
    await walk('first-tour', 12.35);
    assert.equal((await state()).tick, 741);
    const direct = await open(browser, reports.report, { hash: '#walk=adult-visit.walk.yaml&t=3.5&camera=top' });
    assert.deepEqual([(await ask(direct, 'state')).tick, (await ask(direct, 'state')).camera], [210, 'top']);
    assert.deepEqual(direct.complaints, []);
    await direct.context().close();
  });

  for (const name of ['first-tour', 'adult-visit', 'robot-delivery']) {
    test(`has the visitor where the log of ${name} says, to a millimetre at every tick`, async () => {
      await walk(name);
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
    await walk('first-tour', 0);
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
    await walk('first-tour', 6.4);
    assert.ok(await page.locator('.popup').isHidden());
    await walk('first-tour', 6.45);
    assert.match(await page.locator('.popup').textContent(), /^Gatehousegatehouse.*Two lodges/);
    await walk('first-tour', 12.2);
    assert.ok(await page.locator('.popup').isHidden());
  });

  test('plays, pauses and ends', async () => {
    await walk('adult-visit', 1);
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
    await walk('first-tour', 10);
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
    await walk('first-tour', 30);
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

describe('the campus', () => {
  test('is where the program draws it, to 2 cm', async () => {
    const row = readIndex(reports.report).walks.find((each) => each.name === 'looks-round');
    const { recording } = detailsOf(reports.report, row);
    const tick = Number(recording.log.find((line) => line.includes('snapshot.take')).split(/\s/)[0]);
    await walk('looks-round', tick / 60);
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
    await walk('first-tour', 176.5);
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
    await walk('first-tour', 21.2);
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
    await walk('first-tour', 20);
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

describe('a failure', () => {
  test('is shown where and when it came, with what is in the way', async () => {
    await walk('to-the-bench');
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
    await walk('onto-the-planter');
    assert.match(await page.locator('.failures .measure').textContent(), /riser0\.45 m.*0\.30 m/);
  });

  test('of a picture has a slider', async () => {
    await walk('snapshot-fails');
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
  assert.ok(await fits());
  assert.ok(await narrow.locator('.transport .primary').isVisible());
  await narrow.locator('.panel').scrollIntoViewIfNeeded();
  assert.ok(await narrow.locator('.failures .message').isVisible());
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
