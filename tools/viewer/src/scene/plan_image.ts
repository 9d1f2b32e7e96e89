// The campus from straight above as an image, for plans. Drawn once.

import { Color, OrthographicCamera, Vector3 } from 'three';
import { colorsOf } from '../plan/plan';
import type { CampusModel } from './campus_model';
import type { Stage } from './stage';

const longest = 1024; // pixels

export function planImage(stage: Stage, model: CampusModel): HTMLCanvasElement {
  const { min, max } = model.campus;
  const [across, deep] = [Math.max(max[0] - min[0], 1), Math.max(max[2] - min[2], 1)];
  const scale = longest / Math.max(across, deep);
  const width = Math.max(1, Math.round(across * scale));
  const height = Math.max(1, Math.round(deep * scale));
  const camera = new OrthographicCamera(-across / 2, across / 2, deep / 2, -deep / 2, 1, max[1] - min[1] + 20);
  camera.position.set((min[0] + max[0]) / 2, max[1] + 10, (min[2] + max[2]) / 2);
  camera.up.set(0, 0, -1);
  camera.lookAt(new Vector3(camera.position.x, min[1], camera.position.z));

  const { renderer, scene } = stage;
  const hidden = scene.children.filter((child) => child !== model.root && child.visible && !('isLight' in child));
  const { fog } = scene;
  const parent = model.root.parent;
  const old = { width: renderer.domElement.width, height: renderer.domElement.height, ratio: renderer.getPixelRatio() };
  const cut = model.cutHeight;
  hidden.forEach((child) => (child.visible = false));
  scene.fog = null;
  scene.background = new Color(colorsOf(document.documentElement).ground);
  model.cut(null);
  scene.add(model.root);
  renderer.setPixelRatio(1);
  renderer.setSize(width, height, false);
  renderer.render(scene, camera);
  const image = document.createElement('canvas');
  image.width = width;
  image.height = height;
  image.getContext('2d')!.drawImage(renderer.domElement, 0, 0);

  if (!parent) model.root.removeFromParent();
  model.cut(cut);
  scene.fog = fog;
  scene.background = null;
  hidden.forEach((child) => (child.visible = true));
  renderer.setPixelRatio(old.ratio);
  renderer.setSize(old.width / old.ratio, old.height / old.ratio, false);
  stage.invalidate();
  return image;
}
