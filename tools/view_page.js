// The program of the page that view.py writes: draws the particles of a run with three.js and lets them be turned, cut,
// coloured and played. What it draws is in the page: #run tells about it, #block<k> are the numbers.
//
// Each particle is a square turned to the eye on which the fragment shader finds the sphere. Opaque phases and glass go
// into a picture each; the last pass puts them together and darkens what lies between and behind particles.
import * as THREE from "three";
import { OrbitControls } from "three-orbit";

const by = id => document.getElementById(id);
const body = document.body;

function fail(message) {
    body.dataset.error = message;
    const line = document.createElement("div");
    line.className = "error";
    line.textContent = message;
    by("scene").append(line);
}
window.addEventListener("error", event => fail(event.message));
window.addEventListener("unhandledrejection", event => fail(String(event.reason)));

const run = JSON.parse(by("run").textContent);
const dark = matchMedia("(prefers-color-scheme: dark)");
const low = new THREE.Vector3(...run.low), size = new THREE.Vector3(...run.high).sub(low); // of all that is drawn
const box = new THREE.Box3(new THREE.Vector3(...run.view_low), new THREE.Vector3(...run.view_high)); // of what matters
const extent = box.getSize(new THREE.Vector3()), centre = box.getCenter(new THREE.Vector3());
const least_radius = Math.min(...run.phases.map(phase => phase.radius));
const reach = extent.length() / 2;
// From the centre to the farthest place where something may be.
const farthest = Math.hypot(...[0, 1, 2].map(k => Math.max(centre.getComponent(k) - run.low[k],
                                                           run.high[k] - centre.getComponent(k)))) + 2 * reach / 10;

// ---------------------------------------------------------------------------------------------------------- words

const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

// The factor and unit in which `largest` reads between 1 and 1000.
function readable(unit, largest) {
    if (["m", "s", "J", "W", "N", "Pa"].includes(unit) && largest > 0)
        for (const [factor, prefix] of PREFIXES)
            if (largest >= factor * (1 - 1e-9) && !("ms".includes(unit) && factor > 1))
                return [1 / factor, prefix + unit];
    const raised = unit.replace(/\^?(-?)([0-9])/g, (_, sign, digit) => (sign ? "⁻" : "") + RAISED[digit]);
    return [1, raised.replace(/\*/g, " ")];
}

// Three significant digits.
function three(value) {
    if (value === 0)
        return "0";
    const rounded = Number(value.toPrecision(3)), digits = Math.floor(Math.log10(Math.abs(rounded)) + 1e-9);
    if (digits < -3 || digits > 5)
        return value.toExponential(2).replace("e", " × 10^").replace(/\^\+?(-?\d+)/, (_, n) =>
            [...n].map(c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join(""));
    return rounded.toFixed(Math.max(0, 2 - digits)).replace("-", "−");
}

// A value of a scale from low to high, with as many decimals as tell three digits of its width.
function on_scale(value, low, high) {
    const decimals = 2 - Math.floor(Math.log10(high - low) + 1e-9);
    if (value === 0 || decimals > 5 || decimals < -3 || Math.abs(value) >= 1e6)
        return three(value);
    return value.toFixed(Math.max(0, decimals)).replace("-", "−");
}

const words = name => name.replace(/_/g, " ");
const count_of = n => n.toLocaleString("en").replace(/,/g, "\u202f");

// -------------------------------------------------------------------------------------------------------- colours

// On paper what happens is dark, on a dark screen it is bright.
const RAMPS = {
    light: [["#b4d8ee", "#6db1da", "#2a7ab9", "#0b4787", "#07244f"],
            ["#ecd6a6", "#ebbb70", "#e08a45", "#b84a2b", "#6e1f1c"],
            ["#cfe6c8", "#94cba0", "#4fa07a", "#20705c", "#0d433c"],
            ["#e3d3ea", "#c5a3d6", "#9a6bb8", "#6c3d92", "#40205f"]],
    dark: [["#15508c", "#2a7ab9", "#5aa9dc", "#a5d8f5", "#f2fbff"],
           ["#8a3f22", "#b9622f", "#e08a45", "#f3c27c", "#fff4d8"],
           ["#1d6a55", "#3d9473", "#6fbd92", "#b0dfb8", "#f3fff0"],
           ["#5f3a86", "#8a5cae", "#b488cf", "#dabde8", "#fbf3ff"]],
};
const PLAIN = { light: ["#5a9fd0", "#dfa866", "#6db491", "#ab83c4"],
                dark: ["#4a97d0", "#d08c4c", "#5aa883", "#a077bd"] };
const WALL = { light: "#b9c1c8", dark: "#77838e" }, PAPER = { light: "#f6f8fa", dark: "#0f151b" };
const LINE = { light: "#b4bec7", dark: "#3d4a56" }, CUT = { light: "#1f6fb4", dark: "#6db1da" };
const mode = () => document.documentElement.dataset.paper ?? (dark.matches ? "dark" : "light");
const numbers = hex => [1, 3, 5].map(k => parseInt(hex.slice(k, k + 2), 16) / 255);

// Fluids take the colours from the blue one on, solids from the brown one on, none twice as long as there are others.
const taken = new Set();
for (const phase of run.phases) {
    const order = phase.kind === "solid" ? [1, 3, 2, 0] : [0, 2, 3, 1];
    phase.palette = order.find(k => !taken.has(k)) ?? order[0];
    if (phase.kind !== "wall")
        taken.add(phase.palette);
    phase.look = phase.kind === "wall" && !run.flat ? "glass" : "shown";
    phase.field = phase.fields.length && phase.kind !== "wall" ? 0 : -1;
}
const plain_of = phase => phase.kind === "wall" ? WALL[mode()] : PLAIN[mode()][phase.palette];
const ramp_of = phase => phase.field < 0 ? Array(5).fill(plain_of(phase)) : RAMPS[mode()][phase.palette];

// -------------------------------------------------------------------------------------------------------- numbers

const blocks = new Map();

// The bytes of a block; its text is let go.
function block(k) {
    if (!blocks.has(k)) {
        const text = by("block" + k), raw = atob(text.textContent), bytes = new Uint8Array(raw.length);
        for (let i = 0; i < raw.length; ++i)
            bytes[i] = raw.charCodeAt(i);
        text.remove();
        blocks.set(k, bytes);
    }
    return blocks.get(k);
}

const places = frame => new Uint16Array(block(frame.places).buffer);

const attributes = new Map();

// An attribute of one number or three per particle, made once for each block.
function attribute(k, array, components) {
    if (!attributes.has(k))
        attributes.set(k, new THREE.InstancedBufferAttribute(array, components, true));
    return attributes.get(k);
}

// -------------------------------------------------------------------------------------------------------- drawing

const renderer = new THREE.WebGLRenderer({ canvas: by("canvas"), antialias: true,
                                           powerPreference: "high-performance" });
renderer.debug.onShaderError = (gl, program, vertex, fragment) =>
    fail("shader: " + (gl.getShaderInfoLog(vertex) || gl.getShaderInfoLog(fragment) || gl.getProgramInfoLog(program)));
THREE.ColorManagement.enabled = false;
renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
renderer.autoClear = false;
renderer.info.autoReset = false;

const camera = new THREE.PerspectiveCamera(run.flat ? 18 : 26, 1, 0.1, 10);
if (!run.flat)
    camera.up.set(0, 0, 1);
const controls = new OrbitControls(camera, by("canvas"));
controls.enableDamping = true;
controls.dampingFactor = 0.12;
controls.zoomToCursor = true;
if (run.flat) { // a plane is moved sooner than turned
    controls.mouseButtons = { LEFT: THREE.MOUSE.PAN, MIDDLE: THREE.MOUSE.DOLLY, RIGHT: THREE.MOUSE.ROTATE };
    controls.touches = { ONE: THREE.TOUCH.PAN, TWO: THREE.TOUCH.DOLLY_ROTATE };
}

const cut = { axis: -1, share: 0.5, flipped: false, plane: new THREE.Vector4(0, 0, 0, 1) };

const square = new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]), 3);

const SPHERES = {
    glslVersion: THREE.GLSL3,
    vertexShader: `
        in vec3 place; in float value;
        uniform vec3 low, size, ramp[5]; uniform vec4 plane; uniform float radius;
        out vec3 on_square, middle, colour;
        void main() {
            vec3 x = low + place * size;
            if (dot(plane.xyz, x) > plane.w) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
            middle = (viewMatrix * vec4(x, 1.0)).xyz;
            float away = length(middle);
            if (away < 1.1 * radius) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
            vec3 forward = middle / away, right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
            float half_side = radius * away / sqrt(away * away - radius * radius);
            on_square = middle + half_side * (position.x * right + position.y * cross(right, forward));
            gl_Position = projectionMatrix * vec4(on_square, 1.0);
            float at = clamp(value, 0.0, 1.0) * 4.0;
            int k = min(int(at), 3);
            colour = mix(ramp[k], ramp[k + 1], at - float(k));
        }`,
    fragmentShader: `
        in vec3 on_square, middle, colour;
        uniform float radius, shine, relief; uniform mat4 projectionMatrix;
        out vec4 painted;
        void main() {
            vec3 ray = normalize(on_square);
            float along = dot(ray, middle), inside = along * along - dot(middle, middle) + radius * radius;
            if (inside < 0.0) discard;
            vec3 hit = ray * (along - sqrt(inside)), normal = (hit - middle) / radius;
            vec4 seen = projectionMatrix * vec4(hit, 1.0);
            gl_FragDepth = 0.5 * seen.z / seen.w + 0.5;
            vec3 light = normalize(vec3(-0.35, 0.6, 0.85));
            float lit = max(dot(normal, light), 0.0), sky = 0.5 + 0.5 * normal.y;
            float gloss = pow(max(dot(normal, normalize(light - ray)), 0.0), 40.0);
            vec3 shaded = colour * (0.56 + 0.16 * sky + 0.42 * lit) + shine * gloss;
            painted = vec4(mix(colour, shaded, relief), 1.0);
        }`,
};

for (const phase of run.phases) {
    const uniforms = {
        low: { value: low }, size: { value: size }, plane: { value: cut.plane }, radius: { value: phase.radius },
        ramp: { value: Array.from({ length: 5 }, () => new THREE.Vector3()) },
        shine: { value: phase.kind === "fluid" ? 0.14 : 0.04 }, relief: { value: 1 },
    };
    phase.mesh = new THREE.Mesh(new THREE.InstancedBufferGeometry(),
                                new THREE.ShaderMaterial({ ...SPHERES, uniforms }));
    phase.mesh.frustumCulled = false;
}

// What is drawn of a phase in a frame, made once: three.js remembers the number of particles of each.
function geometry_of(frame) {
    if (!frame.geometry) {
        frame.geometry = new THREE.InstancedBufferGeometry();
        frame.geometry.setIndex([0, 1, 2, 2, 1, 3]);
        frame.geometry.setAttribute("position", square);
        frame.geometry.setAttribute("place", attribute(frame.places, places(frame), 3));
        frame.geometry.instanceCount = frame.count;
    }
    return frame.geometry;
}
const scenes = { shown: new THREE.Scene(), glass: new THREE.Scene(), hidden: new THREE.Scene(),
                 lines: new THREE.Scene() };

function target() {
    const made = new THREE.WebGLRenderTarget(1, 1, { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
    made.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    return made;
}
const targets = { shown: target(), glass: target() };

const last = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    uniforms: {
        shown: { value: targets.shown.texture }, shown_depth: { value: targets.shown.depthTexture },
        glass: { value: targets.glass.texture }, glass_depth: { value: targets.glass.depthTexture },
        paper: { value: new THREE.Vector3() }, fine: { value: 1 }, near: { value: 0.1 }, far: { value: 10 },
        radius: { value: least_radius }, pixels: { value: 1 }, strength: { value: run.flat ? 0 : 1 },
        glassy: { value: false }, glass_radius: { value: least_radius },
    },
    vertexShader: "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
    // The darkening: for pairs of opposite pixels around this one, how much nearer they are than it, on average. A flat
    // surface is not darkened, however it is turned. Three distances: between particles, bodies and their hollows.
    fragmentShader: `
        uniform sampler2D shown, shown_depth, glass, glass_depth;
        uniform vec3 paper; uniform int fine; uniform bool glassy;
        uniform float near, far, radius, pixels, strength, glass_radius;
        out vec4 painted;
        float away(float depth) { return near * far / (far - depth * (far - near)); }
        float nearer(ivec2 at, float z, float range) {
            at = clamp(at, ivec2(0), textureSize(shown_depth, 0) - 1);
            return clamp(z - away(texelFetch(shown_depth, at, 0).r), -range, range);
        }
        float glass_nearer(ivec2 at, float z, float range) {
            at = clamp(at, ivec2(0), textureSize(glass_depth, 0) - 1);
            return clamp(z - away(texelFetch(glass_depth, at, 0).r), -range, range);
        }
        void main() {
            ivec2 first = ivec2(gl_FragCoord.xy) * fine;
            vec3 colour = vec3(0.0); float nearest = 1.0, covered = 0.0, glass_near = 1.0; ivec2 there = first;
            vec3 veil = vec3(0.0); float veiled = 0.0;
            for (int k = 0; k < fine * fine; ++k) {
                ivec2 at = first + ivec2(k % fine, k / fine);
                float depth = texelFetch(shown_depth, at, 0).r;
                if (depth < 1.0) { colour += texelFetch(shown, at, 0).rgb; covered += 1.0; }
                if (depth < nearest) { nearest = depth; there = at; }
                if (glassy) {
                    float front = texelFetch(glass_depth, at, 0).r;
                    if (front < depth) { veil += texelFetch(glass, at, 0).rgb; veiled += 1.0; }
                    glass_near = min(glass_near, front);
                }
            }
            float all = float(fine * fine), hidden = 0.0;
            if (covered > 0.0) {
                float z = away(nearest);
                for (int ring = 0; ring < 3; ++ring) {
                    float range = radius * (ring == 0 ? 1.6 : ring == 1 ? 5.0 : 14.0);
                    float step = max(range * pixels / z, 1.0), sum = 0.0;
                    for (int k = 0; k < 5; ++k) {
                        float angle = (float(k) + 0.37 * float(ring)) * 0.62832;
                        ivec2 way = ivec2(round(step * vec2(cos(angle), sin(angle))));
                        sum += max(nearer(there + way, z, range) + nearer(there - way, z, range), 0.0) / range;
                    }
                    hidden += sum / 5.0 * (ring == 0 ? 0.35 : 0.45);
                }
                colour = colour / covered * mix(1.0, 0.25, 1.0 - exp(-strength * hidden));
            }
            colour = mix(paper, colour, covered / all);
            if (veiled > 0.0) {
                float z = away(glass_near), range = 4.0 * glass_radius, bent = 0.0;
                float step = max(2.5 * glass_radius * pixels / z, 1.5);
                for (int k = 0; k < 4; ++k) {
                    ivec2 way = ivec2(round(step * vec2(cos(float(k) * 0.7854), sin(float(k) * 0.7854))));
                    float both = glass_nearer(first + way, z, range) + glass_nearer(first - way, z, range);
                    bent = max(bent, abs(both) / range);
                }
                colour = mix(colour, veil / veiled, (0.13 + 0.3 * smoothstep(0.25, 1.0, bent)) * veiled / all);
            }
            painted = vec4(colour, 1.0);
            gl_FragDepth = nearest;
        }`,
    depthFunc: THREE.AlwaysDepth,
}));
last.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
last.frustumCulled = false;
const final = new THREE.Scene();
final.add(last);

// The box of the run, and the cut.
const edges = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry(...extent)),
                                     new THREE.LineBasicMaterial());
edges.position.copy(centre);
const outline = new THREE.LineLoop(new THREE.BufferGeometry(), new THREE.LineBasicMaterial());
outline.visible = false;
scenes.lines.add(edges, outline);

// What the axes are called, at the edges of the box.
const AXES = run.flat ? [0, 1] : [0, 1, 2];
const labels = AXES.map(axis => {
    const label = document.createElement("span");
    const [factor, unit] = readable("m", Math.max(...extent));
    label.className = "edge";
    label.textContent = `${"xyz"[axis]} ${three(extent.getComponent(axis) * factor)}\u00a0${unit}`;
    by("scene").append(label);
    return label;
});

// The edge along an axis that is lowest in the picture, and its middle there; it hides nothing and is hidden by little.
function middle_of_edge(axis, width, height) {
    const others = [0, 1, 2].filter(k => k !== axis);
    const seen = [0, 1, 2, 3].map(k => {
        const x = centre.clone();
        others.forEach((other, bit) => x.setComponent(other, ((k >> bit) & 1 ? box.max : box.min).getComponent(other)));
        x.project(camera);
        return [(x.x + 1) / 2 * width, (1 - x.y) / 2 * height];
    });
    const middle = project(centre, width, height);
    const outward = p => axis === 2 ? Math.abs(p[0] - middle[0]) - 1e-3 * p[0] : p[1] + 1e-3 * p[0];
    return seen.reduce((best, p) => outward(p) > outward(best) ? p : best);
}

function project(point, width, height) {
    const x = point.clone().project(camera);
    return [(x.x + 1) / 2 * width, (1 - x.y) / 2 * height];
}

function place_labels(width, height) {
    const middle = project(centre, width, height);
    labels.forEach((label, k) => {
        const [x, y] = middle_of_edge(AXES[k], width, height), box = label.getBoundingClientRect();
        const dx = x - middle[0], dy = y - middle[1], far = Math.hypot(dx, dy) || 1;
        const left = x + dx / far * (box.width / 2 + 8) - box.width / 2;
        const top = y + dy / far * (box.height / 2 + 6) - box.height / 2;
        label.hidden = false;
        label.style.transform = `translate(${Math.max(4, Math.min(width - box.width - 4, left))}px, ` +
            `${Math.max(2, Math.min(height - box.height - 2, top))}px)`;
    });
}

// ---------------------------------------------------------------------------------------------------- what is shown

let now = 0, playing = false, moved_view = false, begun = 0;
let waiting = false, fast = false, still_timer = 0, last_drawn = 0; // of the drawing

function invalidate() {
    if (!waiting) {
        waiting = true;
        requestAnimationFrame(draw_queued);
    }
}

// Gives the meshes the numbers of the frame.
function show_frame() {
    const unit = readable("s", run.times.at(-1));
    by("time").textContent = `t = ${three(run.times[now] * unit[0])} ${unit[1]}`;
    by("frame").value = now;
    by("frame").setAttribute("aria-valuetext", by("time").textContent);
    for (const phase of run.phases) {
        const frame = phase.frames[phase.at[now]];
        phase.mesh.visible = frame.count > 0;
        if (frame.count === 0)
            continue;
        const k = phase.field < 0 ? -1 : frame.values[phase.field];
        phase.plain ??= new THREE.InstancedBufferAttribute(
            new Uint8Array(Math.max(...phase.frames.map(one => one.count))), 1);
        phase.mesh.geometry = geometry_of(frame);
        phase.mesh.geometry.setAttribute("value", k < 0 ? phase.plain : attribute(k, block(k), 1));
    }
    count_drawn();
    invalidate();
}

// How many particles of the phases that are shown lie before the cut.
function count_drawn() {
    let drawn = 0;
    const sizes = size.toArray(), lows = low.toArray();
    for (const phase of run.phases) {
        const frame = phase.frames[phase.at[now]];
        if (phase.look === "hidden")
            continue;
        if (cut.axis < 0) {
            drawn += frame.count;
            continue;
        }
        const x = places(frame), sign = cut.plane.getComponent(cut.axis);
        for (let i = cut.axis; i < x.length; i += 3)
            drawn += sign * (lows[cut.axis] + x[i] / 65535 * sizes[cut.axis]) <= cut.plane.w;
    }
    by("count").textContent = `${count_of(drawn)} particles`;
    body.dataset.counted = drawn;
}

function show_colours() {
    for (const phase of run.phases) {
        phase.mesh.material.uniforms.ramp.value.forEach((colour, k) => colour.set(...numbers(ramp_of(phase)[k])));
        scenes[phase.look].add(phase.mesh);
    }
    last.material.uniforms.paper.value.set(...numbers(PAPER[mode()]));
    const glass = run.phases.filter(phase => phase.look === "glass");
    last.material.uniforms.glassy.value = glass.length > 0;
    last.material.uniforms.glass_radius.value = Math.max(least_radius, ...glass.map(phase => phase.radius));
    edges.material.color.set(LINE[mode()]);
    outline.material.color.set(CUT[mode()]);
    show_legend();
    invalidate();
}

function show_cut() {
    by("cut").hidden = cut.axis < 0;
    outline.visible = cut.axis >= 0;
    cut.plane.set(0, 0, 0, 1e30);
    if (cut.axis >= 0) {
        const at = box.min.getComponent(cut.axis) + cut.share * extent.getComponent(cut.axis);
        const sign = cut.flipped ? -1 : 1;
        // On y the side towards the reader goes away, on the others the side to the right or above.
        const side = cut.axis === 1 && !run.flat ? -sign : sign;
        cut.plane.setComponent(cut.axis, side);
        cut.plane.w = side * at;
        const [factor, unit] = readable("m", Math.max(...extent));
        by("cut_at").textContent = `${"xyz"[cut.axis]} = ${three(at * factor)} ${unit}`;
        const [a, b] = [0, 1, 2].filter(k => k !== cut.axis);
        const { min, max } = box;
        outline.geometry.setFromPoints([[min, min], [max, min], [max, max], [min, max]].map(([p, q]) => {
            const x = new THREE.Vector3().setComponent(cut.axis, at);
            return x.setComponent(a, p.getComponent(a)).setComponent(b, q.getComponent(b));
        }));
    }
    count_drawn();
    invalidate();
}

// ------------------------------------------------------------------------------------------------------------ camera

const turn = { around: 28, above: 17, zoom: 1 };

// The whole box in the picture, from the front, somewhat from the right and above; a plane from before it.
function look() {
    const around = turn.around * Math.PI / 180, above = turn.above * Math.PI / 180;
    const back = run.flat ? new THREE.Vector3(0, 0, 1)
        : new THREE.Vector3(Math.sin(around) * Math.cos(above), -Math.cos(around) * Math.cos(above), Math.sin(above));
    controls.target.copy(centre);
    camera.zoom = 1;
    let near = 0, far = 60 * reach;
    const { clientWidth: width, clientHeight: height } = by("scene");
    // Around it there is room for what the edges are called.
    const room = { x: 1 - (width < 600 ? 116 : 170) / width, y: 1 - 80 / height };
    for (let k = 0; k < 40; ++k) {
        const distance = (near + far) / 2;
        camera.position.copy(centre).addScaledVector(back, distance);
        camera.lookAt(centre);
        camera.near = 0.01 * reach;
        camera.far = 100 * reach;
        camera.updateProjectionMatrix();
        camera.updateMatrixWorld();
        let fits = true;
        for (let corner = 0; corner < 8; ++corner) {
            const x = new THREE.Vector3(...[0, 1, 2].map(d => ((corner >> d) & 1 ? box.max : box.min).getComponent(d)));
            const before = x.clone().applyMatrix4(camera.matrixWorldInverse).z < -camera.near;
            x.project(camera);
            fits &&= before && Math.abs(x.x) < room.x && Math.abs(x.y) < room.y;
        }
        if (fits)
            far = distance;
        else
            near = distance;
    }
    camera.position.lerp(centre, 1 - 1 / turn.zoom);
    moved_view = false;
    controls.update();
    invalidate();
}

function resize() {
    const { clientWidth: width, clientHeight: height } = by("scene");
    if (!width || !height)
        return;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (!moved_view)
        look();
    draw(performance.now()); // at once: the canvas is empty
}

// Discs of a plane close up, and are flat, where they are no wider than some pixels; spheres of space lie behind others
// anyway. The layer of glass has no gaps.
function set_sizes(pixels) {
    for (const phase of run.phases) {
        const uniforms = phase.mesh.material.uniforms, wide = THREE.MathUtils.smoothstep(phase.radius * pixels, 2, 8);
        uniforms.relief.value = run.flat ? 0.8 * wide : 1;
        uniforms.radius.value = phase.radius * (phase.look === "glass" ? 1.4 : run.flat ? 1.45 - 0.45 * wide : 1);
    }
}

function draw_queued(time) {
    waiting = false;
    draw(time);
}

function draw(time) {
    if (playing)
        step_time(time);
    if (controls.update())
        invalidate();
    const { clientWidth: width, clientHeight: height } = by("scene");
    if (!width || !height)
        return;

    // Two by two points a pixel, but where the machine is slow only when nothing moves.
    const moving = playing || waiting;
    if (moving && last_drawn && time - last_drawn > 60 && time - last_drawn < 400)
        fast = true;
    last_drawn = moving ? time : 0;
    const fine = (fast && moving) || renderer.getPixelRatio() > 1.5 ? 1 : 2;
    clearTimeout(still_timer);
    if (fast && moving)
        still_timer = setTimeout(invalidate, 250);

    const wide = renderer.domElement.width, tall = renderer.domElement.height, u = last.material.uniforms;
    const distance = camera.position.distanceTo(centre);
    camera.near = Math.max(distance - farthest, 0.01 * reach);
    camera.far = distance + farthest;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    set_sizes(tall / 2 / Math.tan(camera.fov * Math.PI / 360) / distance);
    renderer.info.reset();
    for (const name of ["shown", "glass"]) {
        if (targets[name].width !== wide * fine || targets[name].height !== tall * fine)
            targets[name].setSize(wide * fine, tall * fine);
        renderer.setRenderTarget(targets[name]);
        renderer.setClearColor(0, 0);
        renderer.clear();
        if (name === "shown" || u.glassy.value)
            renderer.render(scenes[name], camera);
    }
    u.fine.value = fine;
    u.near.value = camera.near;
    u.far.value = camera.far;
    u.pixels.value = tall * fine / 2 / Math.tan(camera.fov * Math.PI / 360);
    const given = renderer.info.render.triangles / 2;
    renderer.setRenderTarget(null);
    renderer.clear();
    renderer.render(final, camera);
    renderer.render(scenes.lines, camera);
    place_labels(width, height);

    const trouble = renderer.getContext().getError();
    if (trouble)
        fail(`WebGL error ${trouble}`);
    body.dataset.drawn = given; // before the cut, as three.js has counted them
    body.dataset.frame = now;
}

// ------------------------------------------------------------------------------------------------------------ player

const SECONDS = Math.max(4, Math.min(12, run.times.length / 12)); // the whole run takes
const PLAY = "M4 2v12l10-6z", PAUSE = "M3 2h4v12H3zM9 2h4v12H9z";

function set_playing(on) {
    playing = on && run.times.length > 1;
    begun = 0;
    by("play").querySelector("path").setAttribute("d", playing ? PAUSE : PLAY);
    by("play").setAttribute("aria-label", playing ? "Pause" : "Play");
    invalidate();
}

function step_time(time) {
    const each = 1000 * SECONDS / run.times.length;
    if (begun && time - begun >= each)
        go((now + 1) % run.times.length);
    if (!begun || time - begun >= each)
        begun = time;
    invalidate();
}

function go(frame) {
    now = Math.max(0, Math.min(run.times.length - 1, frame));
    show_frame();
}

// ------------------------------------------------------------------------------------------------------------- panel

function chooser(options, chosen, label, then) {
    const select = document.createElement("select");
    options.forEach(([value, text]) => select.add(new Option(text, value, false, String(value) === String(chosen))));
    select.setAttribute("aria-label", label);
    select.addEventListener("change", () => then(select.value));
    return select;
}

function row(...parts) {
    const made = document.createElement("div");
    made.className = "row";
    made.append(...parts);
    return made;
}

function make_panel() {
    for (const phase of run.phases) {
        const section = document.createElement("section"), name = document.createElement("h2");
        name.textContent = words(phase.name).replace(/^./, first => first.toUpperCase());
        const looks = [["shown", "solid"], ["glass", "see-through"], ["hidden", "hidden"]];
        const look_select = chooser(looks, phase.look, `How ${phase.name} is shown`, value => {
            phase.look = value;
            show_colours();
            count_drawn();
        });
        look_select.className = "look";
        section.append(row(name, look_select));
        if (phase.fields.length) {
            const fields = [...phase.fields.map((field, k) => [k, words(field.name)]), [-1, "one colour"]];
            section.append(row(chooser(fields, phase.field, `Field of ${phase.name}`, value => {
                phase.field = Number(value);
                show_colours();
                show_frame();
            })));
        }
        phase.bar = document.createElement("div");
        phase.bar.className = "bar";
        section.append(phase.bar);
        by("phases").append(section);
    }
    for (const [axis, text] of [[-1, "off"], ...AXES.map(k => [k, "xyz"[k]])]) {
        const label = document.createElement("label"), button = document.createElement("input"),
              span = document.createElement("span");
        Object.assign(button, { type: "radio", name: "axis", checked: axis < 0 });
        button.addEventListener("change", () => { cut.axis = axis; show_cut(); });
        span.textContent = text;
        label.append(button, span);
        by("axes").append(label);
    }
    by("notes").textContent = run.notes.join(". ");
    by("notes").hidden = !run.notes.length;
    by("help").textContent = matchMedia("(pointer: coarse)").matches
        ? (run.flat ? "One finger moves, two zoom and turn." : "One finger turns, two zoom and move.")
        : (run.flat ? "Drag to move, right button to turn, wheel to zoom. Space plays, arrows step."
                    : "Drag to turn, right button to move, wheel to zoom. Space plays, arrows step.");
}

function show_legend() {
    for (const phase of run.phases) {
        phase.bar.hidden = phase.field < 0 || phase.look === "hidden";
        if (phase.bar.hidden)
            continue;
        const field = phase.fields[phase.field], most = Math.max(Math.abs(field.low), Math.abs(field.high));
        const [factor, unit] = readable(field.unit, most), colours = document.createElement("div"),
              ends = document.createElement("div");
        colours.className = "colours";
        colours.style.background = `linear-gradient(to right, ${ramp_of(phase).join(", ")})`;
        ends.className = "ends";
        const [low_end, high_end] = [field.low * factor, field.high * factor];
        const text_of = value => on_scale(value, low_end, high_end);
        [(field.below ? "≤ " : "") + text_of(low_end), text_of((low_end + high_end) / 2),
         (field.above ? "≥ " : "") + text_of(high_end) + (unit ? " " + unit : "")].forEach(text => {
            const span = document.createElement("span");
            span.textContent = text;
            ends.append(span);
        });
        phase.bar.replaceChildren(colours, ends);
    }
}

// ------------------------------------------------------------------------------------------------------------- begin

function listen() {
    controls.addEventListener("start", () => { moved_view = true; });
    controls.addEventListener("change", invalidate);
    by("play").addEventListener("click", () => set_playing(!playing));
    by("frame").addEventListener("input", event => { set_playing(false); go(Number(event.target.value)); });
    by("place").addEventListener("input", event => { cut.share = event.target.value / 1000; show_cut(); });
    by("flip").addEventListener("click", () => { cut.flipped = !cut.flipped; show_cut(); });
    by("reset").addEventListener("click", look);
    by("canvas").addEventListener("dblclick", look);
    dark.addEventListener("change", show_colours);
    new ResizeObserver(resize).observe(by("scene"));
    window.addEventListener("keydown", event => {
        const steps = { ArrowRight: now + 1, ArrowLeft: now - 1, Home: 0, End: run.times.length - 1 };
        if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select, input:not(#frame)"))
            return;
        if (event.key === " " && !event.target.matches("button"))
            set_playing(!playing);
        else if (event.key in steps) {
            set_playing(false);
            go(steps[event.key]);
        } else
            return;
        event.preventDefault();
    });
}

// What the address asks for after #, such as
//     #frame=12&view=40,20,2&cut=y,0.4&field.water=pressure&look.tank=hidden&playing&paper=dark
function read_address() {
    for (const [key, value] of new URLSearchParams(location.hash.slice(1))) {
        const phase = run.phases.find(one => key.endsWith("." + one.name));
        if (key === "frame")
            now = Math.max(0, Math.min(run.times.length - 1, Number(value) || 0));
        else if (key === "view") // degrees to the right, degrees up, zoom
            [turn.around, turn.above, turn.zoom] = [0, 1, 2].map(k => Number(value.split(",")[k] || [28, 17, 1][k]));
        else if (key === "cut")
            [cut.axis, cut.share] = [AXES.find(k => "xyz"[k] === value[0]) ?? -1, Number(value.split(",")[1] || 0.5)];
        else if (key.startsWith("field.") && phase)
            phase.field = phase.fields.findIndex(field => field.name === value);
        else if (key.startsWith("look.") && phase && value in scenes)
            phase.look = value;
        else if (key === "playing")
            playing = true;
        else if (key === "paper" && value in PAPER)
            document.documentElement.dataset.paper = value;
    }
}

document.title = run.title;
by("title").textContent = run.title;
by("frame").max = run.times.length - 1;
document.querySelector("nav").hidden = run.times.length < 2;
read_address();
make_panel();
by("place").value = 1000 * cut.share;
by("axes").querySelectorAll("input")[AXES.indexOf(cut.axis) + 1].checked = true;
listen();
set_playing(playing);
show_colours();
show_cut();
show_frame();
resize();
