// Makes the reports that the tests open, with the program: CAMPUSWALK_PROGRAM, or that of the release build. The
// repository is CAMPUSWALK_ROOT, where these tests are a copy elsewhere.
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { withViewer } from './page_file.mjs';

export const root = process.env.CAMPUSWALK_ROOT ?? resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
export const program = process.env.CAMPUSWALK_PROGRAM ?? join(root, 'build/release/campuswalk');
export const hostile = '</script><img src=x onerror=alert(1)>';
export const bidi = '\u202Edesrever\u202C';

const walks = {
  'to-the-bench': `campus: DEMO
avatar: adult
tags: [smoke, avenue]
steps:
  - spawn: main-gate
  - walk_to: gate-arch
  - walk_to: avenue-bench
  - walk_to: bench
  - walk_to: avenue-north
`,
  'onto-the-planter': `campus: DEMO
avatar: adult
tags: steps
steps:
  - spawn: square-south
  - go_to: [-18.9, 0.51, -6.88]
`,
  'waits-for-a-ramp': `campus: DEMO
avatar: adult
status: {is: skip, because: the ramp is being built}
steps:
  - spawn: main-gate
`,
  'looks-round': `campus: DEMO
avatar: adult
tags: [pictures]
steps:
  - spawn: square-south
  - wait: 0.2
  - look_at: library-door
  - snapshot: {name: square, channels: [depth]}
  - walk_to: square
expect:
  - reaches: {place: square, within: 0.3}
`,
};

/** A campus and a walk whose every name tries to be markup. The folders' names make up the first slash. */
function writeHostile(project) {
  const folder = join(project, 'x<', 'script><img src=x onerror=alert(1)>');
  mkdirSync(folder, { recursive: true });
  const text = JSON.stringify;
  writeFileSync(
    join(folder, 'hostile.campus.yaml'),
    `scenes:
  - file: ${text(join(relative(folder, root), 'campus_assets/demo/ground.glb'))}
buildings:
  - {id: hall, title: ${text(`${hostile} ${bidi}`)}, text: ${text(`${bidi} ${hostile}`)}, hours: ${text(hostile)}}
colliders:
  - {id: ground, nodes: [terrain, "road_*", "path_*", square], shape: mesh, mode: [solid, ray]}
  - {id: hall/door, building: hall, shape: box, center: [0, 1, 24], size: [4, 3, 4], mode: trigger}
spawns:
  start: {at: [0, 0.06, 28], yaw_deg: 0}
`,
  );
  writeFileSync(
    join(folder, 'greets.walk.yaml'),
    `# ${hostile}
campus: hostile.campus.yaml
avatar: adult
camera: {width: 320, height: 180}
steps:
  - spawn: start
  - walk_to: [0, 24]
  - wait: 1
expect:
  - popup: {building: hall, title: ${text(`no ${hostile}`)}}
`,
  );
}

function writeProject(project) {
  const toRoot = relative(project, root);
  mkdirSync(project, { recursive: true });
  cpSync(join(root, 'config/avatars'), join(project, 'avatars'), { recursive: true });
  writeFileSync(join(project, 'walks.config.yaml'), '{}\n');
  const add = (name, text) =>
    writeFileSync(
      join(project, `${name}.walk.yaml`),
      text.replace(/^campus: .*$/m, `campus: ${JSON.stringify(join(toRoot, 'config/demo.campus.yaml'))}`),
    );
  // Small pictures are made faster.
  const small = 'camera: {view: first_person, width: 320, height: 180, fov_deg: 60}\n';
  for (const [name, text] of Object.entries(walks)) add(name, text.replace(/^steps:/m, `${small}steps:`));
  for (const name of ['first-tour', 'adult-visit', 'robot-delivery']) {
    // Without pictures, which take time.
    const text = readFileSync(join(root, `config/walks/${name}.walk.yaml`), 'utf8');
    add(name, text.replace(/^.*\bsnapshot:.*\n/gm, '').replace(/^.*\bvisible:.*\n/gm, ''));
  }
  const expectations = join(root, 'config/walks/expectations');
  const snapshot = 'snapshot-fails.walk.yaml';
  cpSync(join(expectations, snapshot), join(project, snapshot));
  cpSync(join(expectations, `${snapshot}-snapshots`), join(project, `${snapshot}-snapshots`), { recursive: true });
  const kiosk = readFileSync(join(expectations, 'kiosk.campus.yaml'), 'utf8');
  writeFileSync(join(project, 'kiosk.campus.yaml'), kiosk.replace(/file: .*\.\//g, `file: ${toRoot}/`));
  writeHostile(project);
}

function run(project, files, output, ...more) {
  const done = spawnSync(program, ['run', ...files, '--root', root, '--output', output, '--quiet', ...more], {
    cwd: project,
    encoding: 'utf8',
    maxBuffer: 1 << 26,
  });
  if (done.error) throw done.error;
  return done;
}

/** The reports of a run and of a comparison of two others, and the folder that they are in. */
export function makeReports() {
  if (!existsSync(program)) throw new Error(`there is no ${program}: build it, or set CAMPUSWALK_PROGRAM`);
  const folder = mkdtempSync(join(tmpdir(), 'campuswalk-viewer-'));
  const project = join(folder, 'project');
  const made = {
    folder,
    report: join(folder, 'report.html'),
    compared: join(folder, 'compared.html'),
    output: join(folder, 'out'),
  };
  writeProject(project);
  const done = run(
    project,
    ['.'],
    made.output,
    '--record',
    'csv',
    '--reporter',
    `html=${made.report}`,
    '--report-geometry',
    'exact',
  );
  if (!existsSync(made.report)) throw new Error(`no report was written:\n${done.stdout}${done.stderr}`);
  compare(project, folder, made.compared);
  const { CAMPUSWALK_VIEWER: viewer, KEEP_REPORTS: keep } = process.env;
  if (viewer) for (const report of [made.report, made.compared]) withViewer(report, resolve(viewer));
  made.remove = () => (keep ? console.log(`reports: ${folder}`) : rmSync(folder, { recursive: true, force: true }));
  return made;
}

/** In the other run, the visitor goes round the bench. A third walk can't be read. */
function compare(project, folder, report) {
  const files = ['to-the-bench.walk.yaml', 'adult-visit.walk.yaml', 'goes-nowhere.walk.yaml'];
  writeFileSync(
    join(project, files[2]),
    'campus: missing.campus.yaml\nsteps:\n  - spawn: start\n  - walks_to: square\n  - wait: long\n',
  );
  const bench = join(project, files[0]);
  const record = (name) =>
    run(
      project,
      files,
      join(folder, name),
      '--record',
      'report',
      '--rendering-backend',
      'none',
      '--reporter',
      `jsonl=${folder}/${name}.jsonl`,
    );
  record('a');
  const text = readFileSync(bench, 'utf8');
  writeFileSync(bench, text.replace('  - walk_to: bench\n', '  - walk_to: avenue-tree\n'));
  record('b');
  writeFileSync(bench, text);
  execFileSync(
    program,
    [
      'report',
      `${folder}/a.jsonl`,
      '-o',
      report,
      '--output',
      `${folder}/a`,
      '--against',
      `${folder}/b.jsonl`,
      '--against-output',
      `${folder}/b`,
      '--root',
      root,
    ],
    { cwd: project, stdio: 'pipe' },
  );
}
