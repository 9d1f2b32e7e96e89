// The report's campuses in 3D, loaded when first shown and kept, on the one stage that the page has.

import { Vector3 } from 'three';
import { kept } from '../data/kept';
import type { Report } from '../data/report';
import { CampusModel } from './campus_model';
import { Highlight } from './highlight';
import { Picker } from './picker';
import { planImage } from './plan_image';
import { NoWebGL, Stage } from './stage';

export interface LoadedCampus {
  model: CampusModel;
  picker: Picker;
  /** What the pointer is on, and what is in the visitor's way. */
  hovered: Highlight;
  obstacle: Highlight;
}

export class Campuses {
  private stageOrNone: Stage | null | undefined;
  private readonly loaded = new Map<number, Promise<LoadedCampus>>();
  private readonly plans = new Map<number, Promise<HTMLCanvasElement | null>>();
  private shown = -1;
  /** Why there is no 3D; empty if there is. */
  whyNot = '';

  constructor(private readonly report: Report) {}

  /** Null if the browser can't draw in 3D. */
  get stage(): Stage | null {
    if (this.stageOrNone === undefined) {
      try {
        this.stageOrNone = new Stage();
      } catch (error) {
        if (!(error instanceof NoWebGL)) throw error;
        this.whyNot = error.message;
        this.stageOrNone = null;
      }
    }
    return this.stageOrNone;
  }

  /** Puts the campus on the stage, in place of another. */
  async show(index: number): Promise<LoadedCampus> {
    const campus = await this.load(index);
    const { stage } = this;
    if (!stage || this.shown === index) return campus;
    this.shown = index;
    for (const other of this.loaded.values()) {
      const { model } = await other;
      if (model !== campus.model) model.root.removeFromParent();
    }
    stage.scene.add(campus.model.root);
    const sun = campus.model.campus.light?.sun_direction;
    stage.frame(campus.model.bounds, sun ? new Vector3(...sun) : null);
    return campus;
  }

  /** For plans; null without 3D. */
  plan(index: number): Promise<HTMLCanvasElement | null> {
    return kept(this.plans, index, () => this.makePlan(index));
  }

  private async makePlan(index: number): Promise<HTMLCanvasElement | null> {
    const { stage } = this;
    if (!stage || !this.report.index.campuses[index]?.geometry) return null;
    // Light falls on it as on the campus that is shown.
    const { model } = await (this.shown < 0 ? this.show(index) : this.load(index));
    return planImage(stage, model);
  }

  private load(index: number): Promise<LoadedCampus> {
    return kept(this.loaded, index, () => this.read(index));
  }

  private async read(index: number): Promise<LoadedCampus> {
    const campus = this.report.index.campuses[index];
    if (!campus) throw new Error('This report has no such campus.');
    const glb = campus.geometry ? await this.report.chunks.bytes(campus.geometry.chunk, true) : null;
    const model = await CampusModel.load(campus, glb);
    return {
      model,
      picker: new Picker(model),
      hovered: new Highlight(model, 0x4d9bff),
      obstacle: new Highlight(model, 0xff2a2a),
    };
  }
}
