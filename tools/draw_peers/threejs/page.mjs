// In the browser: loads the campus, draws each look, posts times and pictures. A frame is timed until a pixel
// of it has been read back, so it really is finished.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { FXAAPass } from 'three/addons/postprocessing/FXAAPass.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';

const kLooks = [
    { name: 'no-aa', samples: 0, fxaa: false, shadows: false },
    { name: 'fxaa', samples: 0, fxaa: true, shadows: false },
    { name: 'msaa4', samples: 4, fxaa: false, shadows: false },
    { name: 'shadows+fxaa', samples: 0, fxaa: true, shadows: true },
    { name: 'shadows+msaa4', samples: 4, fxaa: false, shadows: true },
];

const post = (path, body) => fetch(path, { method: 'POST', body });

// Lambert's light on the same pictures, without gloss: what ours draws, and the cheapest that three.js has.
function withPlainMaterials(root) {
    const plain = new Map();
    root.traverse((mesh) => {
        if (!mesh.isMesh) {
            return;
        }
        const { material } = mesh;
        if (!plain.has(material)) {
            plain.set(material, new THREE.MeshLambertMaterial({ map: material.map, color: material.color, side: material.side }));
        }
        mesh.material = plain.get(material);
        mesh.castShadow = mesh.receiveShadow = true;
        mesh.matrixAutoUpdate = false;
    });
    return root;
}

// The sun, from so far that its map holds the whole campus.
function sunOver(root, views) {
    const sphere = new THREE.Box3().setFromObject(root).getBoundingSphere(new THREE.Sphere());
    const sun = new THREE.DirectionalLight(0xfff4e0, 3.4);
    sun.position.copy(sphere.center).addScaledVector(new THREE.Vector3(...views.to_sun), 2 * sphere.radius);
    sun.target.position.copy(sphere.center);
    Object.assign(sun.shadow.camera, { left: -sphere.radius, right: sphere.radius, bottom: -sphere.radius,
        top: sphere.radius, near: sphere.radius, far: 3 * sphere.radius });
    sun.shadow.mapSize.set(views.shadow_size, views.shadow_size);
    sun.shadow.bias = -0.0005;
    sun.shadow.autoUpdate = false; // drawn once
    return sun;
}

function makeScene(root, views) {
    const scene = new THREE.Scene();
    scene.background = new THREE.Color(0.45, 0.6, 0.8);
    scene.fog = new THREE.Fog(0xcfdbe6, 1, 2500);
    const sun = sunOver(root, views);
    scene.add(root, sun, sun.target, new THREE.HemisphereLight(0x9ab0d0, 0x66605a, 1.6));
    return { scene, sun };
}

function makeDrawing(scene, sun, camera, look, { width, height }) {
    const canvas = document.createElement('canvas');
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: look.samples > 0 && !look.fxaa });
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    renderer.shadowMap.enabled = look.shadows;
    sun.castShadow = look.shadows;
    sun.shadow.needsUpdate = true;
    if (!look.fxaa) {
        return { renderer, canvas, draw: () => renderer.render(scene, camera) };
    }
    const composer = new EffectComposer(renderer, new THREE.WebGLRenderTarget(width, height));
    composer.setPixelRatio(1);
    composer.addPass(new RenderPass(scene, camera));
    composer.addPass(new OutputPass());
    composer.addPass(new FXAAPass());
    return { renderer, canvas, draw: () => composer.render() };
}

async function drawLook(root, views, look) {
    const { scene, sun } = makeScene(root, views);
    const camera = new THREE.PerspectiveCamera(views.fov_deg, views.width / views.height, 0.1, 4000);
    const { renderer, canvas, draw } = makeDrawing(scene, sun, camera, look, views);
    const gl = renderer.getContext();
    const pixel = new Uint8Array(4);
    const drawView = ({ eye, target }) => {
        camera.position.set(...eye);
        camera.lookAt(...target);
        const start = performance.now();
        draw();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        return performance.now() - start;
    };
    let lines = '';
    for (let round = 0; round <= views.rounds; ++round) { // the first is for warming up
        views.views.forEach((view, i) => {
            const ms = drawView(view);
            lines += round > 0 ? `frame ${look.name} ${i} ${ms.toFixed(3)}\n` : '';
        });
        await new Promise((resolve) => { setTimeout(resolve); });
    }
    drawView(views.views[0]);
    const picture = await new Promise((resolve) => { canvas.toBlob(resolve); });
    const driver = gl.getExtension('WEBGL_debug_renderer_info');
    await post('/lines', `# three.js ${THREE.REVISION} on ${gl.getParameter(driver.UNMASKED_RENDERER_WEBGL)}\n${lines}`);
    await post(`/picture/${look.name}`, picture);
    sun.shadow.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
}

try {
    const views = await (await fetch('/campus/views.json')).json();
    const campus = await new GLTFLoader().loadAsync('/campus/campus.glb');
    const root = withPlainMaterials(campus.scene);
    for (const look of kLooks) {
        await drawLook(root, views, look);
    }
    await post('/end', '');
} catch (error) {
    await post('/failure', String(error.stack ?? error));
}
