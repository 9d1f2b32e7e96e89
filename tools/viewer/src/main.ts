// Entry: reads the page's report and shows it.

import './style/viewer.css';
import { App } from './app';
import { BadReport, Chunks } from './data/chunks';
import { Report } from './data/report';
import { Store } from './store';
import { exposeForTests } from './test_seam';
import { element, replace } from './ui/dom';
import { emptyState } from './ui/controls';

async function start(): Promise<App | null> {
  const root = document.getElementById('app') ?? document.body.appendChild(element('div'));
  if (typeof DecompressionStream === 'undefined') {
    replace(
      root,
      emptyState("This browser can't unpack the report.", element('p', { text: 'Use one from 2023 or later.' })),
    );
    return null;
  }
  try {
    const report = await Report.open(new Chunks(document));
    return new App(report, new Store(), root);
  } catch (error) {
    if (!(error instanceof BadReport)) throw error;
    replace(
      root,
      emptyState("This report can't be shown.", element('p', { text: error.message, attributes: { role: 'alert' } })),
    );
    return null;
  }
}

exposeForTests(start());
