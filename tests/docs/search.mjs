// Runs the search worker of the built site: `node search.mjs WORKER INDEX`, with a list of queries as JSON on standard input.
// Prints, as JSON, the pages that each finds, the best first.
import { readFileSync } from 'node:fs';
import vm from 'node:vm';

const [worker, index] = process.argv.slice(2);
const listeners = [];
let answer;
const self = {
  addEventListener: (_, listener) => listeners.push(listener),
  postMessage: (message) => answer(message),
  console: { warn: (text) => { throw new Error(text); } },
};
self.self = self;
vm.runInNewContext(readFileSync(worker, 'utf8'), self, { filename: worker });

/** As a page's message to its worker: each listener gets the same event. */
const ask = (type, data) => new Promise((resolve) => {
  answer = resolve;
  const event = { data: { type, data } };
  listeners.forEach((listener) => listener(event));
});

const { config, docs } = JSON.parse(readFileSync(index, 'utf8'));
// The defaults of the theme: see "search.config.pipeline" in a page.
await ask(0, { config, docs, options: { pipeline: ['trimmer', 'stopWordFilter'], suggestions: false } });
const found = [];
for (const query of JSON.parse(readFileSync(0, 'utf8'))) {
  const { data: { items } } = await ask(2, query);
  found.push(items.map(([best]) => best.location.split('#')[0]));
}
console.log(JSON.stringify(found));
