// The viewer's modules that need no page: logs, paths, filters, groups, links, reasons, snippets, rays.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';

const root = process.env.CAMPUSWALK_ROOT ?? resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const sources = process.env.CAMPUSWALK_VIEWER_SOURCES ?? join(root, 'tools/viewer/src'); // beside the packages that they need
let folder;
const modules = {};

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'campuswalk-modules-'));
  const names = [
    'data/log',
    'data/path',
    'data/filter',
    'data/groups',
    'data/link',
    'data/obstacle',
    'data/snippets',
    'data/spans',
    'data/text',
    'scene/feature_edges',
    'scene/triangle_tree',
  ];
  await build({
    entryPoints: names.map((name) => join(sources, `${name}.ts`)),
    outbase: sources,
    outdir: folder,
    outExtension: { '.js': '.mjs' },
    bundle: true,
    format: 'esm',
    platform: 'node',
    logLevel: 'error',
  });
  for (const name of names) Object.assign(modules, await import(pathToFileURL(join(folder, `${name}.mjs`)).href));
});
after(() => rmSync(folder, { recursive: true, force: true }));

describe('a log line', () => {
  test('is read as it was written', () => {
    const line = modules.parseLogLine(
      '000386    6.433333 trigger.enter    gatehouse/arch    pos=0.000,-1.440,80.000 at=0.714',
    );
    assert.equal(line.tick, 386);
    assert.equal(line.seconds, 6.433333);
    assert.equal(line.kind, 'trigger.enter');
    assert.equal(line.object, 'gatehouse/arch');
    assert.equal(modules.fieldOf(line, 'pos'), '0.000,-1.440,80.000');
    assert.equal(modules.fieldOf(line, 'at'), '0.714');
  });
  test('has quoted names and texts', () => {
    const line = modules.parseLogLine(
      '000001 0.016667 popup.open "a \\"b\\" c" title="x=1, \\\\ y\\nz" body="\\xe2\\x80\\xae\u603b" n=2',
    );
    assert.equal(line.object, 'a "b" c');
    assert.deepEqual(
      line.fields.map((field) => field.value),
      ['x=1, \\ y\nz', '\u202E\u603b', '2'],
    );
  });
  test('without details has an object', () => {
    assert.deepEqual(modules.parseLogLine('000729   12.150000 popup.close      gatehouse').fields, []);
  });
  test('is refused if it is none', () => {
    assert.equal(modules.parseLogLine('# walk-log 1 walk=x'), null);
  });
  test('is found in every line of the golden log', () => {
    const lines = readFileSync(join(root, 'tests/golden/first-tour.log'), 'utf8').trim().split('\n').slice(1);
    const log = modules.parseLog(lines);
    assert.equal(log.length, lines.length);
    assert.ok(log.every((line) => lines.includes(line.text) && line.object !== ''));
    const open = log.filter((line) => line.kind === 'popup.open');
    assert.ok(open.length > 10 && open.every((line) => modules.fieldOf(line, 'body').length > 20));
    const spans = modules.spansOf(log, log.at(-1).tick);
    assert.equal(spans.length, log.filter((line) => /^(collision|trigger|ray)\.enter$/.test(line.kind)).length);
    const arch = spans.find((span) => span.object === 'gatehouse/arch');
    assert.deepEqual([arch.from, arch.to], [386, 729]);
  });
});

describe('a path', () => {
  const frames = {
    tick: [0, 10, 10, 1, 9],
    x: [0, 1000, 0, 5000, 500],
    y: [60, 0, 0, 0, 0],
    z: [17000, 0, -2000, 0, 0],
    yaw: [0, 900, 0, 0, 2700],
    pitch: [0, 0, 0, -100, 0],
    cut: [3],
  };
  const at = (tick) => new modules.Path(frames).at(tick);
  test('is linear between key frames', () => {
    assert.deepEqual([at(5).x, at(5).y, at(5).z], [0.5, 0.06, 17]);
    assert.ok(Math.abs(at(5).yaw - Math.PI / 4) < 1e-12);
    assert.equal(at(15).z, 16);
  });
  test('holds until a jump', () => {
    assert.deepEqual([at(20).x, at(20.9).x, at(21).x], [1, 1, 6]);
  });
  test('ends where it ends', () => {
    assert.deepEqual([at(-3).x, at(30).x, at(99).x], [0, 6.5, 6.5]);
  });
  test('counts metres, but not those of a jump', () => {
    const path = new modules.Path(frames);
    assert.equal(path.distanceAt(10), 1);
    assert.equal(path.distanceAt(30), 3.5);
    assert.deepEqual(path.pieces(), [
      [0, 2],
      [3, 4],
    ]);
  });
  test('of a row is coded in decimetres', () => {
    assert.deepEqual(modules.planPoints([10, -20, 5, 5]), [
      [1, -2],
      [1.5, -1.5],
    ]);
  });
});

const row = (changes) => ({
  id: 'walks/a.walk.yaml',
  file: 'walks/a.walk.yaml',
  name: 'a',
  project: '',
  repetition: 0,
  tags: [],
  outcome: 'passed',
  expected_to_fail: false,
  seconds: 1,
  ticks: 60,
  distance: 2,
  campus: 0,
  chunk: 0,
  line: 0,
  ...changes,
});

describe('a filter', () => {
  const matches = (query, changes) => modules.parseFilter(query).matches(modules.searchable(row(changes), 'demo'));
  test('takes outcomes, tags, projects, campuses, files and text', () => {
    assert.ok(matches('s:failed', { outcome: 'failed' }));
    assert.ok(!matches('s:failed', {}));
    assert.ok(matches('s:xfail', { expected_to_fail: true }) && !matches('s:passed', { expected_to_fail: true }));
    assert.ok(matches('@smoke', { tags: ['Smoke'] }) && !matches('@smo', { tags: ['smoke'] }));
    assert.ok(matches('p:child', { project: 'Child' }) && !matches('p:child', { project: 'adult' }));
    assert.ok(matches('c:demo', {}) && !matches('c:school', {}));
    assert.ok(matches('f:walks/', {}) && !matches('f:a.yaml', {}));
    assert.ok(matches('riser', { message: 'a Riser of 0.45 m' }));
  });
  test('wants all words, and none of the excluded', () => {
    assert.ok(matches('s:failed @x door', { outcome: 'failed', tags: ['x'], name: 'door' }));
    assert.ok(!matches('s:failed @y', { outcome: 'failed', tags: ['x'] }));
    assert.ok(!matches('!s:failed', { outcome: 'failed' }) && matches('-@x', { tags: ['y'] }));
  });
  test('keeps quoted words together', () => {
    assert.ok(
      matches('"two words"', { message: 'of two words here' }) && !matches('"two words"', { message: 'words two' }),
    );
    assert.ok(matches('@"a b"', { tags: ['a b'] }) && matches('!"two words', { message: 'words two' }));
  });
  test('can be toggled by words', () => {
    assert.equal(modules.toggled('door', 's:failed'), 'door s:failed');
    assert.equal(modules.toggled('door s:failed', 's:failed'), 'door');
  });
});

test('failures come first, in groups of a file', () => {
  const rows = [
    row({}),
    row({ file: 'b', outcome: 'passed' }),
    row({ file: 'b', outcome: 'failed', project: 'x' }),
    row({ file: 'c', outcome: 'broken' }),
  ];
  const groups = modules.grouped(rows, [0, 1, 2, 3]);
  assert.deepEqual(
    groups.map((group) => group.walks),
    [[2, 1], [3], [0]],
  );
  assert.deepEqual(
    groups.map((group) => group.failed),
    [1, 1, 0],
  );
  const counts = modules.counted(rows, [0, 1, 2, 3]);
  assert.deepEqual([counts.passed, counts.failed, counts.broken, counts.seconds], [2, 1, 1, 4]);
});

test('a link says where and when', () => {
  const link = { walk: 'a b/c&d.walk.yaml #1', time: 12.35, against: true, camera: 'top' };
  assert.deepEqual(modules.parseLink(modules.formatLink(link)), link);
  assert.deepEqual(modules.parseLink('#walk=x/y.walk.yaml&t=12.35'), { walk: 'x/y.walk.yaml', time: 12.35 });
  assert.deepEqual(modules.parseLink('#t=nonsense'), {});
});

describe('an obstacle', () => {
  const failure = (reason, scene = { tick: 10 }) => ({
    code: 'blocked',
    message: 'words that nobody reads, at 1.00, 2.00, 3.00',
    file: '',
    line: 0,
    column: 0,
    object: 'bench',
    scene,
    reason,
  });
  const riser = { kind: 'riser', object: 'stair', at: [1, 0.45, 2], measured: 0.45, allowed: 0.3 };
  test('has a place, an object and a measure', () => {
    assert.deepEqual(modules.obstacleOf(failure(riser)), {
      at: [1, 0.45, 2],
      object: 'stair',
      measure: { kind: 'riser', unit: 'm', measured: 0.45, allowed: 0.3 },
      tick: 10,
    });
  });
  test('is where one should look', () => {
    assert.deepEqual(modules.obstacleOf(failure(riser, { tick: 3, contact: [9, 9, 9] })).at, [9, 9, 9]);
    assert.deepEqual(modules.obstacleOf(failure({ ...riser, look_at: [1, 1, 1] })).at, [1, 1, 1]);
  });
  test('is measured in metres or degrees', () => {
    const measure = (reason) => modules.measureOf({ at: [0, 0, 0], ...reason });
    assert.deepEqual(measure({ kind: 'slope', measured_deg: 61, allowed_deg: 50 }), {
      kind: 'slope',
      unit: '°',
      measured: 61,
      allowed: 50,
    });
    assert.deepEqual(measure({ kind: 'ledge', measured: 2 }).allowed, null);
    assert.equal(measure({ kind: 'solid' }), null);
    assert.equal(measure({ kind: 'no_nearer', measured: 3.5 }), null);
  });
  test('of several parts is the first', () => {
    const parts = [
      { kind: 'object', object: 'fountain', at: [1, 2, 3] },
      { ...riser, object: 'step' },
    ];
    for (const kind of ['sequence', 'several', 'through']) {
      const { at, object, measure } = modules.obstacleOf(failure({ kind, name: 'hall', parts }));
      assert.deepEqual([at, object, measure.kind], [[1, 2, 3], 'fountain', 'riser']);
    }
  });
  test('without a reason is what the failure is about', () => {
    assert.deepEqual(modules.obstacleOf(failure(null, null)), { at: null, object: 'bench', measure: null, tick: null });
  });
});

describe('a snippet', () => {
  test('is YAML', () => {
    assert.equal(modules.walkToStep([1.23456, -0.0001, 7]), '- walk_to: [1.235, 0, 7]');
    assert.equal(
      modules.followStep([
        [0, 0, 0],
        [1, 0, 2],
      ]),
      '- follow:\n    - [0, 0, 0]\n    - [1, 0, 2]',
    );
  });
  test('of a box is centred, and turned as the YAML turns', () => {
    const box = modules.boxBetween([0, 1, 0], [2, 1, -4], 2.4, 0);
    assert.equal(
      modules.triggerCollider(box, 'hall/door', 'hall'),
      [
        '- id: hall/door',
        '  building: hall',
        '  mode: trigger',
        '  shape: box',
        '  center: [1, 2.2, -2]',
        '  size: [2, 2.4, 4]',
      ].join('\n'),
    );
    const turned = modules.boxBetween([0, 0, 0], [2, 0, -4], 2, 90);
    assert.ok(Math.abs(turned.width - 4) < 1e-9 && Math.abs(turned.depth - 2) < 1e-9);
    assert.match(modules.triggerCollider(turned, 'a', ''), /yaw_deg: 90/);
  });
  test('of a command is safe to paste', () => {
    const command = (file, project) =>
      modules.replayCommand('campuswalk run {file}[ --project {project}]', { file, project });
    assert.equal(command('a/b.walk.yaml', ''), 'campuswalk run a/b.walk.yaml');
    assert.equal(command("it's; rm.walk.yaml", 'child'), "campuswalk run 'it'\\''s; rm.walk.yaml' --project child");
  });
});

test('characters that would control the display are shown', () => {
  assert.equal(modules.visible('a\u202Eb\u0007\n'), 'a\\u{202e}b\\u{7}\n');
});

test('blank letters are shown, letters stay', () => {
  for (const code of [0xa0, 0xad, 0x34f, 0x115f, 0x180e, 0x200d, 0x2800, 0x3000, 0x3164, 0xfe0f, 0xfff9, 0xd800, 0xe0041]) {
    assert.equal(modules.visible(`a${String.fromCodePoint(code)}b`), `a\\u{${code.toString(16)}}b`);
  }
  const words = 'Bücherei, 図書館 مكتبة \u06dd12 ספרייה पुस्तकालय 🏛\t1\u0301';
  assert.equal(modules.visible(words), words);
});

describe('the edges that are drawn', () => {
  const mesh = (triangles, scale = 1) => {
    const values = triangles.flat(2);
    return {
      geometry: {
        getAttribute: () => ({
          count: values.length / 3,
          getX: (i) => values[3 * i],
          getY: (i) => values[3 * i + 1],
          getZ: (i) => values[3 * i + 2],
        }),
        getIndex: () => null,
      },
      matrixWorld: { elements: [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1] },
    };
  };
  const quad = (a, b, c, d) => [
    [a, b, c],
    [a, c, d],
  ];
  const turned = (triangles) => triangles.map((triangle) => [...triangle].reverse());
  const at = (x, y, z) => [x, y, z];
  const cube = [0, 1, 2].flatMap((axis) =>
    [0, 4].flatMap((side) => {
      const corner = (u, v) => {
        const point = [u, v];
        point.splice(axis, 0, side);
        return point;
      };
      return quad(corner(0, 0), corner(4, 0), corner(4, 4), corner(0, 4));
    }),
  );
  const floor = quad(at(0, 0, 0), at(4, 0, 0), at(4, 0, 4), at(0, 0, 4));
  const lengths = (meshes) => {
    const { array } = modules.featureEdges(meshes, 28).getAttribute('position');
    const found = [];
    for (let i = 0; i < array.length; i += 6)
      found.push(Math.hypot(array[i] - array[i + 3], array[i + 1] - array[i + 4], array[i + 2] - array[i + 5]));
    return found.sort((a, b) => a - b);
  };
  test('are the twelve of a cube, once or twice there, of any scale', () => {
    assert.deepEqual(lengths([mesh(cube)]), Array(12).fill(4));
    assert.deepEqual(lengths([mesh([...cube, ...turned(cube)])]), Array(12).fill(4));
    assert.deepEqual(lengths([mesh(cube, 0.25)]), Array(12).fill(1));
  });
  test('are the rims of a floor, not its diagonal', () => {
    assert.deepEqual(lengths([mesh(floor)]), Array(4).fill(4));
    assert.deepEqual(lengths([mesh([...floor, ...turned(floor)])]), Array(4).fill(4));
  });
  test('are not the seams of flat surfaces', () => {
    assert.deepEqual(lengths([mesh([floor[0]]), mesh([floor[1]])]), Array(4).fill(4)); // in two meshes
    const beside = [quad(at(4, 0, 0), at(8, 0, 0), at(8, 0, 3), at(4, 0, 3)), quad(at(4, 0, 3), at(8, 0, 3), at(8, 0, 4), at(4, 0, 4))];
    const seen = lengths([mesh([...floor, ...beside.flat()])]); // the floor's edge has a vertex of its neighbours'
    assert.deepEqual(seen, [1, 3, 4, 4, 4, 4, 4]);
    const gap = quad(at(4.01, 0, 0), at(8, 0, 0), at(8, 0, 4), at(4.01, 0, 4));
    assert.equal(lengths([mesh([...floor, ...gap])]).length, 6);
  });
  test('are those of a fold between two meshes', () => {
    const wall = quad(at(4, 0, 0), at(4, 3, 0), at(4, 3, 4), at(4, 0, 4));
    assert.equal(lengths([mesh(floor), mesh(wall)]).length, 8); // the fold is an end of both
  });
  test('are not those of triangles that are lines', () => {
    const line = [[at(0, 0, 0), at(4, 0, 4), at(2.001, 0.001, 2)]];
    assert.deepEqual(lengths([mesh([...floor, ...line])]), Array(4).fill(4));
  });
});

test('the triangle tree finds what testing every triangle finds', () => {
  let seed = 7;
  const random = () => ((seed = (seed * 16807) % 2147483647) / 2147483647) * 10;
  const count = 400;
  const values = Array.from({ length: count * 9 }, (_, i) => random());
  for (let t = 0; t < count; ++t)
    for (let k = 3; k < 9; ++k) values[t * 9 + k] = values[t * 9 + (k % 3)] + (random() - 5) * 0.2;
  const geometry = {
    getAttribute: () => ({
      count: count * 3,
      getX: (i) => values[i * 3],
      getY: (i) => values[i * 3 + 1],
      getZ: (i) => values[i * 3 + 2],
    }),
    getIndex: () => null,
  };
  const tree = new modules.TriangleTree(geometry);
  let hits = 0;
  for (let ray = 0; ray < 300; ++ray) {
    const origin = [random(), random(), -1];
    const direction = [(random() - 5) / 20, (random() - 5) / 20, 1];
    const nearest = Math.min(...Array.from({ length: count }, (_, t) => bruteForce(values, t, origin, direction)));
    const found = tree.cast(origin, direction, Infinity);
    assert.ok(found === null ? nearest === Infinity : Math.abs(found.distance - nearest) < 1e-4, `ray ${ray}`);
    hits += found === null ? 0 : 1;
  }
  assert.ok(hits > 50 && hits < 300);
});

/** By the plane and three edges, in another way than the tree does it. */
function bruteForce(values, triangle, origin, direction) {
  const vertex = (k) => Array.from({ length: 3 }, (_, axis) => Math.fround(values[triangle * 9 + k * 3 + axis]));
  const minus = (p, q) => p.map((value, i) => value - q[i]);
  const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  const [a, b, c] = [0, 1, 2].map(vertex);
  const normal = cross(minus(b, a), minus(c, a));
  const distance = dot(minus(a, origin), normal) / dot(direction, normal);
  const point = origin.map((value, i) => value + direction[i] * distance);
  const inside = [
    [a, b],
    [b, c],
    [c, a],
  ].every(([from, to]) => dot(cross(minus(to, from), minus(point, from)), normal) >= 0);
  return inside && distance >= 0 ? distance : Infinity;
}
