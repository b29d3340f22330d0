// The interactive view of report.html: one canvas, WebGL, no library. The scene is JSON in the page. Positions are 16-bit steps of
// the scene's box, fields are 16-bit steps of their scale.
"use strict";
// What is folded on the screen is printed too.
window.addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
(() => {
  const scene = JSON.parse(document.getElementById("scene").textContent);
  const canvas = document.querySelector("#stage canvas");
  const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true });
  if (!gl) {
    document.getElementById("stage").innerHTML = "<p style='padding:1rem'>This browser shows no WebGL; the pictures below show the same.</p>";
    return;
  }
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const shorts = (text) => new Uint16Array(bytes(text).buffer);
  const step = scene.size / 65535;

  // --- shaders: the same light as in the pictures ---
  const vertexText = `#version 300 es
    in vec3 rest, current, restNormal, currentNormal; in float value;
    uniform mat4 view, projection; uniform float along, nearer; out vec3 normal; out float level;
    void main() {
      gl_Position = projection * view * vec4(mix(rest, current, along), 1.0);
      gl_Position.z -= nearer * gl_Position.w;
      normal = mat3(view) * mix(restNormal, currentNormal, along); level = value;
    }`;
  const fragmentText = `#version 300 es
    precision highp float; in vec3 normal; in float level; out vec4 result;
    uniform vec3 colour; uniform float opacity; uniform bool coloured; uniform sampler2D scale;
    void main() {
      vec3 n = normalize(normal + vec3(0.0, 0.0, 1e-9)); if (!gl_FrontFacing) n = -n; n.z = abs(n.z);
      vec3 own = coloured ? texture(scale, vec2(level, 0.5)).rgb : colour;
      float lit = max(0.0, dot(n, vec3(-0.436, 0.532, 0.726))), filled = max(0.0, dot(n, vec3(0.866, -0.108, 0.487)));
      float gloss = pow(max(0.0, dot(n, vec3(-0.235, 0.287, 0.929))), 32.0), edge = 1.0 - n.z;
      vec3 light = vec3(0.64, 0.65, 0.67) + lit * vec3(0.40, 0.39, 0.37) + filled * vec3(0.12, 0.13, 0.15);
      vec3 seen = own * light * (1.0 - 0.28 * edge * edge) + 0.10 * gloss;
      if (!gl_FrontFacing) seen *= 0.66;
      float hides = opacity < 1.0 ? 1.0 - (1.0 - opacity) * min(1.0, 0.35 + n.z) : 1.0;
      result = vec4(min(seen, 1.0) * hides, hides);
    }`;
  const compile = (kind, text) => {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    return shader;
  };
  const program = gl.createProgram();
  gl.attachShader(program, compile(gl.VERTEX_SHADER, vertexText));
  gl.attachShader(program, compile(gl.FRAGMENT_SHADER, fragmentText));
  gl.linkProgram(program);
  gl.useProgram(program);
  const place = (name) => gl.getUniformLocation(program, name);
  const uniforms = Object.fromEntries(["view", "projection", "along", "nearer", "colour", "opacity", "coloured", "scale"].map((n) => [n, place(n)]));

  // --- data ---
  const positions = (text) => Float32Array.from(shorts(text), (v, i) => v * step + scene.low[i % 3] - scene.centre[i % 3]);
  const normals = (points, triangles) => {
    const sum = new Float32Array(points.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
      const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
      const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
      const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
      for (const k of [a, b, c]) { sum[k] += nx; sum[k + 1] += ny; sum[k + 2] += nz; }
    }
    for (let k = 0; k < sum.length; k += 3) {
      const length = Math.hypot(sum[k], sum[k + 1], sum[k + 2]) || 1;
      sum[k] /= length; sum[k + 1] /= length; sum[k + 2] /= length;
    }
    return sum;
  };
  // Edges that belong to one triangle only: open ends, slits and seams, as in the pictures.
  const border = (triangles) => {
    const alone = new Map();
    for (let t = 0; t < triangles.length; t++) {
      const a = triangles[t], b = triangles[t % 3 === 2 ? t - 2 : t + 1], key = Math.min(a, b) * 4294967296 + Math.max(a, b);
      if (!alone.delete(key)) alone.set(key, [a, b]);
    }
    return Uint32Array.from([...alone.values()].flat());
  };
  const indices = (values) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, values, gl.STATIC_DRAW);
    return buffer;
  };
  const attribute = (name, data, size) => {
    const at = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, gl.FLOAT, false, 0, 0);
  };
  const vessels = scene.vessels.map((vessel) => {
    const triangles = new Uint32Array(bytes(vessel.triangles).buffer);
    const rest = positions(vessel.rest), current = positions(vessel.current);
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    attribute("rest", rest, 3);
    attribute("current", current, 3);
    attribute("restNormal", normals(rest, triangles), 3);
    attribute("currentNormal", normals(current, triangles), 3);
    const edges = vessel.glass ? new Uint32Array() : border(triangles);
    const edgeBuffer = indices(edges), triangleBuffer = indices(triangles);  // the last one stays bound
    const fields = scene.fields.map((_, k) => vessel.fields[k] && Float32Array.from(shorts(vessel.fields[k]), (v) => v / 65535));
    const buffers = fields.map((values) => {
      if (!values) return null;
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      return buffer;
    });
    return { ...vessel, array, buffers, edgeBuffer, edgeCount: edges.length, triangleBuffer, count: triangles.length, shown: true };
  });
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);

  // --- state ---
  const start = () => ({ axes: scene.axes.map((row) => row.slice()), pan: [0, 0], distance: scene.distance });
  let camera = start(), field = -1, along = 1, asked = false;
  const redraw = () => { if (!asked) { asked = true; requestAnimationFrame(draw); } };

  function draw() {
    asked = false;
    const ratio = window.devicePixelRatio || 1, width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const [right, up, eye] = camera.axes, aspect = width / height;
    const half = scene.half / scene.distance / Math.min(1, aspect / scene.aspect);
    const near = Math.max(camera.distance - scene.reach, 0.01 * scene.reach), far = camera.distance + scene.reach;
    gl.uniformMatrix4fv(uniforms.view, false, [right[0], up[0], eye[0], 0, right[1], up[1], eye[1], 0, right[2], up[2], eye[2], 0, camera.pan[0], camera.pan[1], -camera.distance, 1]);
    gl.uniformMatrix4fv(uniforms.projection, false, [1 / (half * aspect), 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, -(far + near) / (far - near), -1, 0, 0, -2 * far * near / (far - near), 0]);
    gl.uniform1f(uniforms.along, along);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const opacity = (vessel) => (vessel.glass ? (field >= 0 && !vessel.buffers[field] ? 0.22 : 0.35) : 1);
    for (const glass of [false, true]) {
      for (const vessel of vessels) {
        if (!vessel.shown || (opacity(vessel) < 1) !== glass) continue;
        gl.bindVertexArray(vessel.array);
        const coloured = field >= 0 && vessel.buffers[field], at = gl.getAttribLocation(program, "value");
        if (coloured) {
          gl.bindBuffer(gl.ARRAY_BUFFER, vessel.buffers[field]);
          gl.enableVertexAttribArray(at);
          gl.vertexAttribPointer(at, 1, gl.FLOAT, false, 0, 0);
        } else {
          gl.disableVertexAttribArray(at);
        }
        gl.uniform1i(uniforms.coloured, coloured ? 1 : 0);
        gl.uniform3fv(uniforms.colour, field >= 0 ? [0.8, 0.8, 0.8] : vessel.colour);
        gl.uniform1f(uniforms.opacity, opacity(vessel));
        if (glass) {  // its depth first, then only its nearest wall
          gl.colorMask(false, false, false, false);
          gl.drawElements(gl.TRIANGLES, vessel.count, gl.UNSIGNED_INT, 0);
          gl.colorMask(true, true, true, true);
          gl.depthFunc(gl.LEQUAL);
        }
        gl.drawElements(gl.TRIANGLES, vessel.count, gl.UNSIGNED_INT, 0);
        gl.depthFunc(gl.LESS);
        if (vessel.edgeCount > 0) {  // borders are moved a little in front of their walls
          gl.disableVertexAttribArray(at);
          gl.uniform1i(uniforms.coloured, 0);
          gl.uniform3fv(uniforms.colour, [0.1, 0.1, 0.12]);
          gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, vessel.edgeBuffer);
          gl.uniform1f(uniforms.nearer, 0.01);
          gl.drawElements(gl.LINES, vessel.edgeCount, gl.UNSIGNED_INT, 0);
          gl.uniform1f(uniforms.nearer, 0);
          gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, vessel.triangleBuffer);
        }
      }
    }
  }

  // --- movement ---
  const turn = (dx, dy) => {
    const [right, up, eye] = camera.axes;
    const rotate = (a, b, angle) => {
      const c = Math.cos(angle), s = Math.sin(angle);
      return [a.map((v, i) => c * v + s * b[i]), b.map((v, i) => c * v - s * a[i])];
    };
    const [eye1, right1] = rotate(eye, right, -dx), [eye2, up1] = rotate(eye1, up, dy);
    camera.axes = [right1, up1, eye2];
    redraw();
  };
  const pan = (dx, dy) => {
    const scale = 2 * scene.half * camera.distance / scene.distance / canvas.clientHeight;
    camera.pan[0] += dx * scale;
    camera.pan[1] -= dy * scale;
    redraw();
  };
  const zoom = (factor) => {
    camera.distance = Math.min(8 * scene.distance, Math.max(0.05 * scene.distance, camera.distance * factor));
    redraw();
  };
  const touches = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    touches.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, (event) => touches.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const before = touches.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY], dx = now[0] - before[0], dy = now[1] - before[1];
    if (touches.size === 1) {
      if (event.buttons & 6 || event.shiftKey) pan(dx, dy); else turn(0.008 * dx, 0.008 * dy);
    } else if (touches.size === 2) {
      const other = [...touches.entries()].find(([id]) => id !== event.pointerId)[1];
      zoom(Math.hypot(before[0] - other[0], before[1] - other[1]) / Math.max(1, Math.hypot(now[0] - other[0], now[1] - other[1])));
      pan(0.5 * dx, 0.5 * dy);
    }
    touches.set(event.pointerId, now);
  });
  canvas.addEventListener("wheel", (event) => { event.preventDefault(); zoom(Math.exp(0.0012 * event.deltaY)); }, { passive: false });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => { camera = start(); redraw(); });
  canvas.addEventListener("keydown", (event) => {
    const moves = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    if (moves[event.key]) turn(...moves[event.key]);
    else if (event.key === "+" || event.key === "=") zoom(0.9);
    else if (event.key === "-") zoom(1.1);
    else return;
    event.preventDefault();
  });

  // --- controls ---
  const element = (tag, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
  };
  const css = (colour) => `rgb(${colour.map((v) => Math.round(255 * v)).join(",")})`;
  const legend = document.getElementById("legend");
  const show = (index) => {
    field = index;
    legend.replaceChildren();
    if (field >= 0) {
      const chosen = scene.fields[field];
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, chosen.colours.length, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array.from(chosen.colours.flatMap((rgb) => [rgb >> 16, (rgb >> 8) & 255, rgb & 255, 255])));
      const bar = element("div", { className: "bar" });
      bar.style.background = `linear-gradient(to top, ${chosen.colours.map((rgb) => "#" + rgb.toString(16).padStart(6, "0")).join(",")})`;
      const scale = element("div", { className: "scale" }, bar);
      for (const [value, text] of chosen.ticks) {
        const tick = element("span", { className: "tick", textContent: text });
        const part = (value - chosen.low) / (chosen.high - chosen.low);
        tick.style.bottom = `calc(${part} * (100% - 1rem) + 0.5rem)`;
        scale.append(tick);
      }
      legend.append(element("div", { className: "title", textContent: chosen.title }), scale);
    }
    redraw();
  };
  const select = element("select", { onchange: () => show(Number(select.value)) }, element("option", { value: "-1", textContent: "vessels" }));
  scene.fields.forEach((entry, k) => select.append(element("option", { value: String(k), textContent: entry.title })));
  const slider = element("input", { type: "range", min: "0", max: "1", step: "0.01", value: "1", oninput: () => { along = Number(slider.value); redraw(); } });
  const play = element("button", { type: "button", textContent: "Play", onclick: () => {
    const begin = performance.now();
    const advance = (now) => {
      along = Math.min(1, Math.max(0, (now - begin) / 1600));
      slider.value = String(along);
      redraw();
      if (along < 1) requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  } });
  const controls = document.getElementById("controls");
  if (scene.fields.length > 0) controls.append(element("label", {}, "Colour ", select));
  if (!scene.still) controls.append(element("label", {}, "rest ", slider, " result"), play);
  for (const vessel of vessels) {
    const dot = element("span", { className: "dot" });
    dot.style.background = css(vessel.colour);
    const box = element("input", { type: "checkbox", checked: true, onchange: () => { vessel.shown = box.checked; redraw(); } });
    controls.append(element("label", {}, box, dot, vessel.name));
  }
  controls.append(element("button", { type: "button", textContent: "Reset view", onclick: () => { camera = start(); redraw(); } }));
  new ResizeObserver(redraw).observe(canvas);
  const first = scene.fields.length > 0 ? 0 : -1;
  select.value = String(first);
  show(first);
})();
