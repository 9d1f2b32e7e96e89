// The canvas, its renderer, lights and sky. Draws only when something has changed.

import {
  AmbientLight,
  Color,
  DirectionalLight,
  Fog,
  HemisphereLight,
  NeutralToneMapping,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
  type Box3,
} from 'three';
import { element } from '../ui/dom';
import { Sky } from './sky';

/** Called before each drawing with the seconds since the last; true keeps on drawing. */
type Animation = (seconds: number) => boolean;

export class NoWebGL extends Error {}

export class Stage {
  readonly canvas = element('canvas', { class: 'scene' });
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(60, 1, 0.08, 1200);
  readonly renderer: WebGLRenderer;
  /** Whether a processor draws: then nothing is asked of it that looks only a little better. */
  readonly isSoftware: boolean;
  readonly animations = new Set<Animation>();
  /** Milliseconds that the last drawing took, and how many there were; for tests. */
  readonly statistics = { frames: 0, lastFrame: 0 };

  private readonly sun = new DirectionalLight(0xfff1dc, 2.6);
  private readonly sky = new Sky();
  private pending = 0;
  private lastTime = 0;
  private drawShadows: boolean;

  constructor() {
    try {
      const context = contextOf(this.canvas);
      this.isSoftware = isSoftware(context);
      this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    } catch {
      throw new NoWebGL("This browser can't draw in 3D here: WebGL isn't available.");
    }
    this.drawShadows = !this.isSoftware;
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.localClippingEnabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.setPixelRatio(this.isSoftware ? 1 : Math.min(devicePixelRatio, 2));
    this.scene.add(this.sky.mesh, this.sun, this.sun.target);
    this.scene.add(new HemisphereLight(0xcfe2ff, 0x8a8372, 1.5), new AmbientLight(0xffffff, 0.25));
    this.scene.fog = new Fog(new Color(0xcfdce8), 200, 900);
    this.canvas.addEventListener('webglcontextrestored', () => this.refreshShadows());
  }

  /** Fits sun, fog and clipping distances to what is shown. */
  frame(bounds: Box3, sunDirection: Vector3 | null): void {
    const size = Math.max(20, bounds.getSize(new Vector3()).length());
    const center = bounds.getCenter(new Vector3());
    const toSun = sunDirection?.clone().negate().normalize() ?? new Vector3(0.55, 0.75, 0.42).normalize();
    this.sun.position.copy(center).addScaledVector(toSun, size);
    this.sun.target.position.copy(center);
    this.sun.target.updateMatrixWorld();
    this.sky.setSun(toSun);
    const shadow = this.sun.shadow;
    const half = size / 2;
    Object.assign(shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 1, far: size * 2 });
    shadow.camera.updateProjectionMatrix();
    shadow.mapSize.set(4096, 4096);
    shadow.bias = -0.0004;
    shadow.normalBias = 0.06;
    this.camera.far = size * 4;
    this.camera.updateProjectionMatrix();
    this.scene.fog = new Fog(new Color(0xcfdce8), size * 0.7, size * 3.5);
    this.refreshShadows();
  }

  /** Shadows cost a processor much: off by default there. */
  setShadows(drawn: boolean): void {
    this.drawShadows = drawn;
    this.refreshShadows();
  }

  /** What stands still throws its shadow once. */
  private refreshShadows(): void {
    this.sun.castShadow = this.drawShadows;
    this.renderer.shadowMap.enabled = this.drawShadows;
    this.renderer.shadowMap.needsUpdate = this.drawShadows;
    this.invalidate();
  }

  resize(width: number, height: number): void {
    if (width < 1 || height < 1) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    // At once: a resized canvas is empty.
    this.draw();
  }

  /** What the camera sees, as a PNG's data: address. */
  picture(width: number, height: number): string {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(1);
    this.resize(width, height);
    for (const animation of this.animations) animation(0);
    this.draw();
    const address = this.canvas.toDataURL('image/png');
    this.renderer.setPixelRatio(ratio);
    this.resize(clientWidth, clientHeight);
    return address;
  }

  invalidate(): void {
    this.pending ||= requestAnimationFrame((time) => {
      this.pending = 0;
      const seconds = this.lastTime === 0 ? 0 : Math.min(0.5, (time - this.lastTime) / 1000);
      this.lastTime = time;
      let goesOn = false;
      for (const animation of [...this.animations]) goesOn = animation(seconds) || goesOn;
      this.draw();
      if (goesOn) this.invalidate();
      else this.lastTime = 0;
    });
  }

  draw(): void {
    const start = performance.now();
    this.sky.mesh.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
    this.statistics.lastFrame = performance.now() - start;
    ++this.statistics.frames;
  }
}

function contextOf(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  const options = { alpha: false, powerPreference: 'high-performance' as const };
  const probe = document.createElement('canvas').getContext('webgl2');
  const context = canvas.getContext('webgl2', { ...options, antialias: probe !== null && !isSoftware(probe) });
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  if (!context) throw new Error('no context');
  return context;
}

function isSoftware(context: WebGL2RenderingContext): boolean {
  const debug = context.getExtension('WEBGL_debug_renderer_info');
  const name: unknown = context.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(name));
}
