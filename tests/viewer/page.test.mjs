// Real reports in a real Chromium, one after the other in the same page. Needs the program; see support/reports.mjs.
import { after, before } from 'node:test';
import { start, stop } from './page/session.mjs';

before(start);
after(stop);

await import('./page/list.mjs');
await import('./page/walk.mjs');
await import('./page/campus.mjs');
await import('./page/verdicts.mjs');
await import('./page/pictures.mjs');
await import('./page/surroundings.mjs');
