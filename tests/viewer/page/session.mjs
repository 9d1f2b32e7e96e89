// The reports and the browser that all tests of the page share: started once, since both take time.
import { ask, closeAll, go, launch, open } from '../support/browser.mjs';
import { makeReports } from '../support/reports.mjs';

export let reports;
export let browser;
export let page;

export async function start() {
  reports = makeReports();
  browser = await launch();
  page = await open(browser, reports.report);
}

export async function stop() {
  await closeAll();
  reports?.remove();
}

export const state = () => ask(page, 'state');
export const totals = (on = page) => on.locator('.totals').textContent();
export const goToWalk = (name, time) =>
  go(page, `#walk=${name}.walk.yaml${time === undefined ? '' : `&t=${time}`}`);
