// A sky that is bright at the horizon and about the sun.

import { BackSide, Mesh, ShaderMaterial, SphereGeometry, Vector3 } from 'three';

const vertexShader = `
varying vec3 direction;
void main() {
  direction = position;
  vec4 clip = projectionMatrix * vec4(mat3(modelViewMatrix) * position, 1.0);
  gl_Position = clip.xyww; // behind everything
}`;

const fragmentShader = `
varying vec3 direction;
uniform vec3 sun;
void main() {
  vec3 d = normalize(direction);
  float up = clamp(d.y, 0.0, 1.0);
  vec3 sky = mix(vec3(0.83, 0.895, 0.945), vec3(0.34, 0.56, 0.83), pow(up, 0.55));
  vec3 ground = vec3(0.74, 0.785, 0.82);
  vec3 color = mix(sky, ground, smoothstep(0.0, -0.12, d.y));
  float near = max(dot(d, sun), 0.0);
  color += vec3(1.0, 0.86, 0.62) * (0.16 * pow(near, 12.0) + 0.5 * pow(near, 900.0));
  gl_FragColor = vec4(color, 1.0);
}`;

export class Sky {
  readonly mesh: Mesh;
  private readonly sun = new Vector3(0, 1, 0);

  constructor() {
    const material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { sun: { value: this.sun } },
      side: BackSide,
      depthWrite: false,
      depthTest: true,
      toneMapped: false,
      fog: false,
    });
    this.mesh = new Mesh(new SphereGeometry(1, 32, 16), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1; // after what hides it
    this.mesh.name = 'sky';
  }

  setSun(toSun: Vector3): void {
    this.sun.copy(toSun);
  }
}
