// Lights up pieces of the campus in a colour; large ones only about a point, so that a red ground isn't all one sees.

import { Color, Vector3, type Material, type MeshLambertMaterial } from 'three';
import { kept } from '../data/kept';
import type { CampusModel, Piece } from './campus_model';

const reach = 3; // metres about the point

export class Highlight {
  private readonly uniforms: { tint: { value: Color }; about: { value: Vector3 }; within: { value: number } };
  private readonly tinted = new Map<Material, Material>();
  private lit: Piece[] = [];

  constructor(
    private readonly model: CampusModel,
    color: number,
  ) {
    this.uniforms = { tint: { value: new Color(color) }, about: { value: new Vector3() }, within: { value: 1e6 } };
  }

  show(pieces: readonly Piece[], about: Vector3 | null): void {
    this.clear();
    const isLarge = pieces.some((piece) => piece.bounds.getSize(new Vector3()).length() > 14);
    this.uniforms.within.value = isLarge && about ? reach : 1e6;
    if (about) this.uniforms.about.value.copy(about);
    for (const { mesh, material } of pieces) mesh.material = kept(this.tinted, material, () => this.tintedOf(material));
    this.lit = [...pieces];
  }

  clear(): void {
    for (const piece of this.lit) {
      if (this.tinted.get(piece.material) === piece.mesh.material) piece.mesh.material = piece.material;
    }
    this.lit = [];
  }

  private tintedOf(material: Material): Material {
    const tinted = material.clone() as MeshLambertMaterial;
    tinted.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = `varying vec3 worldPlace;\n${shader.vertexShader}`.replace(
        '#include <project_vertex>',
        '#include <project_vertex>\nworldPlace = (modelMatrix * vec4(transformed, 1.0)).xyz;',
      );
      shader.fragmentShader =
        `uniform vec3 tint;\nuniform vec3 about;\nuniform float within;\nvarying vec3 worldPlace;\n${shader.fragmentShader}`.replace(
          '#include <opaque_fragment>',
          `#include <opaque_fragment>
           float lit = 0.66 * (1.0 - smoothstep(0.25 * within, within, distance(worldPlace, about)));
           float shade = 0.55 + 0.6 * dot(gl_FragColor.rgb, vec3(0.3, 0.5, 0.2));
           gl_FragColor.rgb = mix(gl_FragColor.rgb, tint * shade, lit);`,
        );
    };
    tinted.customProgramCacheKey = () => 'tinted';
    this.model.adopt(tinted);
    return tinted;
  }
}
