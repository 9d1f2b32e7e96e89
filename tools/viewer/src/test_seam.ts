// `window.campuswalk`: what tests may ask the page. It changes nothing but by what a user could do, too.

import type { App } from './app';
import { lastCopied } from './ui/clipboard';

interface TestSeam {
  /** Fulfilled when what is shown now is complete; true if a report is shown. */
  ready(): Promise<boolean>;
  /** Where the visitor's feet are, metres, as at the time that is shown or at a tick. */
  visitorAt(tick?: number): { x: number; y: number; z: number; yaw: number; pitch: number } | null;
  /** Where the figure stands in the scene; and all of them, where two walks are compared. */
  figure(): number[] | null;
  figures(): number[][];
  /** Ids of the objects that are lit as being in the way. */
  lit(): string[];
  /** What is at a point of the canvas, in CSS pixels from its top left. */
  pick(x: number, y: number): { point: number[]; objects: string[]; node: string } | null;
  state(): {
    page: string;
    tick: number;
    ticks: number;
    playing: boolean;
    speed: number;
    camera: string;
    cut: number | null;
    tab: string;
  };
  /** Where the camera is and looks. */
  camera(): { position: number[]; direction: number[] } | null;
  /** The scene, or the list's plan, as a PNG's data: address: what is drawn without any text over it. */
  picture(width: number, height: number): Promise<string | null>;
  /** The last text that was copied. */
  copied(): string;
  statistics(): { filterTime: number; frames: number; lastFrame: number; software: boolean };
}

declare global {
  interface Window {
    campuswalk: TestSeam;
  }
}

export function exposeForTests(starting: Promise<App | null>): void {
  let app: App | null = null;
  const started = starting.then((made) => (app = made));
  window.campuswalk = {
    async ready() {
      const shown = await started;
      for (let last: Promise<void> | null = null; shown && last !== shown.ready; ) {
        last = shown.ready;
        await last;
      }
      return shown !== null;
    },
    visitorAt: (tick) => app?.walk?.context.data.path?.at(tick ?? app.store.state.tick) ?? null,
    figure: () => app?.walk?.viewport?.figures[0] ?? null,
    figures: () => app?.walk?.viewport?.figures ?? [],
    lit: () => app?.walk?.viewport?.litObjects ?? [],
    pick(x, y) {
      app?.walk?.viewport?.refresh();
      const hit = app?.walk?.viewport?.pick(x, y);
      const campus = app?.walk?.context.campus;
      return hit
        ? {
            point: hit.point.toArray(),
            node: hit.piece.node,
            objects: hit.piece.objects.map((index) => campus?.objects[index]?.id ?? ''),
          }
        : null;
    },
    state() {
      const { page, tick, playing, speed, camera, cut, tab } = app!.store.state;
      return { page, tick, playing, speed, camera, cut, tab, ticks: app!.walk?.context.lastTick ?? 0 };
    },
    camera() {
      app?.walk?.viewport?.refresh();
      const camera = app?.walk?.viewport && app.campuses.stage?.camera;
      if (!camera) return null;
      const direction = camera.getWorldDirection(camera.position.clone());
      return { position: camera.position.toArray(), direction: direction.toArray() };
    },
    async picture(width, height) {
      app?.walk?.viewport?.refresh();
      const stage = app?.walk?.viewport && app.campuses.stage;
      return stage ? stage.picture(width, height) : ((await app?.list?.overview.picture(width, height)) ?? null);
    },
    copied: () => lastCopied,
    statistics() {
      const stage = app?.walk?.viewport ? app.campuses.stage : null;
      return {
        filterTime: app?.list?.filterTime ?? 0,
        frames: stage?.statistics.frames ?? 0,
        lastFrame: stage?.statistics.lastFrame ?? 0,
        software: stage?.isSoftware ?? false,
      };
    },
  };
}
