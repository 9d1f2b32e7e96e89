// Where to put a camera so that a visitor and what is in the way are both seen, and not from inside a wall.

import { Vector3 } from 'three';
import type { Picker } from './picker';

export interface View {
  position: Vector3;
  target: Vector3;
}

const distances = [4.2, 3.1, 6, 2.2, 9, 1.5];
const heights = [28, 45, 14, 62, 4]; // degrees
const turns = 16;

/** `body`: the middle of the visitor; `obstacle`: where it is stopped; `ahead`: where it wanted to go, horizontal. */
export function viewOf(picker: Picker, body: Vector3, obstacle: Vector3, ahead: Vector3): View {
  const target = body.clone().lerp(obstacle, 0.5);
  let best: View = { position: target.clone().add(new Vector3(3, 2.4, 3)), target };
  let bestScore = -Infinity;
  for (const distance of distances) {
    for (const height of heights) {
      for (let turn = 0; turn < turns; ++turn) {
        const position = positionOf(target, distance, height, turn);
        const score =
          scoreOf(picker, position, body, obstacle, ahead) - distance * 0.05 - Math.abs(height - 28) * 0.008;
        if (score > bestScore) {
          bestScore = score;
          best = { position, target };
        }
      }
    }
    // From farther away there is nothing more to see.
    if (bestScore > 2.4) break;
  }
  return best;
}

function positionOf(target: Vector3, distance: number, heightDegrees: number, turn: number): Vector3 {
  const up = (heightDegrees * Math.PI) / 180;
  const angle = (turn / turns) * Math.PI * 2;
  const flat = Math.cos(up) * distance;
  return new Vector3(
    target.x + Math.sin(angle) * flat,
    target.y + Math.sin(up) * distance,
    target.z + Math.cos(angle) * flat,
  );
}

/** Counts what is seen; prefers to look from the side, a little from behind. */
function scoreOf(picker: Picker, position: Vector3, body: Vector3, obstacle: Vector3, ahead: Vector3): number {
  const head = body.clone().add(new Vector3(0, 0.6, 0));
  // A little before the obstacle's surface, towards the camera: the surface itself always hides its own point.
  const before = obstacle
    .clone()
    .lerp(position, 0.06)
    .add(new Vector3(0, 0.04, 0));
  const seen = [body, head, before].filter((point) => picker.sees(position, point)).length;
  if (seen === 0 || !hasRoom(picker, position)) return -10;
  const across = position.clone().sub(body).setY(0).normalize().dot(ahead);
  return seen - 0.5 * Math.abs(across + 0.35);
}

const around = [
  new Vector3(1, 0, 0),
  new Vector3(-1, 0, 0),
  new Vector3(0, 0, 1),
  new Vector3(0, 0, -1),
  new Vector3(0, 1, 0),
];

/** Not inside or right at something. */
function hasRoom(picker: Picker, position: Vector3): boolean {
  return around.every((direction) => picker.clearance(position, direction, 0.3) >= 0.3);
}
