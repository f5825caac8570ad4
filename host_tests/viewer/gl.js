// SPDX-License-Identifier: MIT
// Draws a stage by WebGL 2: solids with one light and its shadow, and above them the lines and points that the kernel's draw() gave.

/// Column-major 4 x 4.
const mat4 = {
  times(a, b) {
    const c = new Float32Array(16);
    for (let i = 0; i < 4; ++i)
      for (let j = 0; j < 4; ++j)
        for (let k = 0; k < 4; ++k) c[4 * i + j] += a[4 * k + j] * b[4 * i + k];
    return c;
  },
  perspective(half_height, half_width, near, far) {  // tangents of half angles
    return new Float32Array(
        [1 / half_width, 0, 0, 0, 0, 1 / half_height, 0, 0, 0, 0, (near + far) / (near - far), -1, 0, 0, 2 * near * far / (near - far), 0]);
  },
  box(reach, depth) {
    return new Float32Array([1 / reach, 0, 0, 0, 0, 1 / reach, 0, 0, 0, 0, -1 / depth, 0, 0, 0, 0, 1]);
  },
  look(eye, at) {
    const z = unit(minus(eye, at)), x = unit(cross([0, 0, 1], z)), y = cross(z, x);
    return new Float32Array([x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
  },
};
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const l = Math.hypot(...a); return [a[0] / l, a[1] / l, a[2] / l]; };

const LIGHT = unit([-0.45, -0.7, 1.05]);

const SHADOW_GLSL = `
uniform highp sampler2DShadow shadow; uniform mat4 to_light; uniform vec3 light;
float lit(vec3 p, vec3 n) {
  vec4 s = to_light * vec4(p + n * 0.02, 1.0); s.xyz = s.xyz * 0.5 + 0.5;
  if (any(lessThan(s.xyz, vec3(0.0))) || any(greaterThan(s.xyz, vec3(1.0)))) return 1.0;
  float sum = 0.0, t = 0.7 / float(textureSize(shadow, 0).x);
  for (int i = -1; i <= 1; i += 2) for (int j = -1; j <= 1; j += 2) sum += texture(shadow, vec3(s.xy + t * vec2(i, j), s.z - 0.0006));
  return sum * 0.25;
}`;
const SOLID_VS = `#version 300 es
layout(location=0) in vec3 p; layout(location=1) in vec3 n; layout(location=2) in float end;
layout(location=3) in vec4 size; layout(location=4) in vec3 r;
layout(location=5) in vec3 c0; layout(location=6) in vec3 c1; layout(location=7) in vec3 c2;
layout(location=8) in vec4 color;
uniform mat4 view; out vec3 world, normal, body, face; out vec4 paint; flat out vec3 extent; flat out float ice;
void main() {
  vec3 b = p * size.xyz + vec3(0, 0, end * size.w); mat3 A = mat3(c0, c1, c2);
  world = r + A * b; normal = A * (n / (size.xyz / max(size.x, max(size.y, size.z)))); body = b; face = n; paint = color; extent = size.xyz; ice = end;
  gl_Position = view * vec4(world, 1.0);
}`;
const SOLID_FS = `#version 300 es
precision highp float; in vec3 world, normal, body, face; in vec4 paint; flat in vec3 extent; flat in float ice; out vec4 color; uniform float contrast;
${SHADOW_GLSL}
void main() {
  vec3 n = normalize(normal), base = paint.rgb;
  if (paint.a > 2.5) {  // a level: a net of metres, and its second material is ice
    vec2 w = fwidth(world.xy), d = abs(fract(world.xy - 0.5) - 0.5) / max(w, vec2(1e-6));
    base = mix(base, vec3(0.72, 0.84, 0.92), 0.75 * ice) * (0.9 + 0.1 * min(min(d.x, d.y), 1.0));
  } else if (paint.a > 1.5) {  // round: every other eighth is darker, so that a turn is seen
    float s = body.x * body.y * body.z; base *= 1.0 - 0.16 * smoothstep(-0.02, 0.02, s / (extent.x * extent.y * extent.z));
  } else {  // boxes: a fine edge
    vec3 d = (extent - abs(body)) / max(fwidth(body), vec3(1e-6)); d += abs(face) * 1e3;
    base *= 1.0 - 0.25 * (1.0 - smoothstep(0.6, 1.8, min(d.x, min(d.y, d.z))));
  }
  float sun = max(dot(n, light), 0.0); if (sun > 0.0) sun *= lit(world, n);
  color = vec4(base * (mix(0.52, 0.72, 0.5 + 0.5 * n.z) + 0.4 * sun * contrast), 1.0);
}`;
const DEPTH_FS = `#version 300 es
precision mediump float; void main() {}`;
const GROUND_VS = `#version 300 es
layout(location=0) in vec2 p; uniform mat4 view; uniform vec4 patch_; out vec3 world;
void main() { world = vec3(patch_.xy + p * patch_.z, patch_.w); gl_Position = view * vec4(world, 1.0); }`;
const GROUND_FS = `#version 300 es
precision highp float; in vec3 world; out vec4 color; uniform vec3 ground, net, far; uniform vec4 patch_;
${SHADOW_GLSL}
void main() {
  vec2 w = fwidth(world.xy), d = abs(fract(world.xy - 0.5) - 0.5) / w; float line = 1.0 - min(min(d.x, d.y), 1.0);
  line *= 1.0 - smoothstep(0.15, 0.5, max(w.x, w.y));
  vec3 c = mix(ground, net, line) * (0.72 + 0.28 * lit(world, vec3(0, 0, 1)));
  float away = length(world.xy - patch_.xy) / patch_.z;
  color = vec4(mix(c, far, smoothstep(0.25, 0.95, away)), 1.0);
}`;
const LINE_VS = `#version 300 es
layout(location=0) in vec2 p; layout(location=1) in vec3 a; layout(location=2) in vec3 b; layout(location=3) in vec4 color;
uniform mat4 view; uniform vec2 size; uniform float width, veil; out vec4 paint;
void main() {
  vec4 A = view * vec4(a, 1.0), B = view * vec4(b, 1.0);
  float near = 0.02; if (A.w < near && B.w < near) { gl_Position = vec4(2, 2, 2, 1); return; }
  if (A.w < near) A = mix(A, B, (near - A.w) / (B.w - A.w)); if (B.w < near) B = mix(B, A, (near - B.w) / (A.w - B.w));
  vec2 d = (B.xy / B.w - A.xy / A.w) * size; float l = length(d); vec2 t = l > 1e-6 ? d / l : vec2(1, 0), n = vec2(-t.y, t.x);
  vec4 P = p.x < 0.5 ? A : B; P.xy += (n * (p.y - 0.5) * width + t * (p.x - 0.5) * width * 0.5) / size * P.w * 2.0; P.z -= 0.0004 * P.w;
  gl_Position = P; paint = color * veil;
}`;
const POINT_VS = `#version 300 es
layout(location=0) in vec3 a; layout(location=1) in vec4 color; uniform mat4 view; uniform float width, veil; out vec4 paint;
void main() { gl_Position = view * vec4(a, 1.0); gl_Position.z -= 0.0006 * gl_Position.w; gl_PointSize = width; paint = color * veil; }`;
const FLAT_FS = `#version 300 es
precision mediump float; in vec4 paint; out vec4 color; uniform float round_;
void main() { if (round_ > 0.5 && length(gl_PointCoord - 0.5) > 0.5) discard; color = paint; }`;

/// Corners with place, normal and which end they belong to: a capsule is a ball drawn apart there.
function mesh_of_box() {
  const out = [];
  for (let axis = 0; axis < 3; ++axis) for (const side of [-1, 1]) {
    const at = (u, v) => { const p = [0, 0, 0]; p[axis] = side; p[(axis + 1) % 3] = u * side; p[(axis + 2) % 3] = v; return p; };
    const n = [0, 0, 0]; n[axis] = side;
    for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) out.push(...at(u, v), ...n, 0);
  }
  return new Float32Array(out);
}
function mesh_of_ball(around, up) {
  const out = [], at = (i, j) => {
    const a = 2 * Math.PI * i / around, b = Math.PI * (j / up - 0.5), p = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
    return p;
  };
  for (let j = 0; j < up; ++j) for (let i = 0; i < around; ++i) {
    const end = j < up / 2 ? -1 : 1, q = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    for (const k of [0, 1, 2, 0, 2, 3]) out.push(...q[k], ...q[k], end);
    if (j === up / 2) for (const [k, e] of [[0, -1], [1, -1], [1, 1], [0, -1], [1, 1], [0, 1]]) out.push(...q[k], ...q[k], e);  // the straight part
  }
  return new Float32Array(out);
}
function mesh_of_cylinder(around) {
  const out = [], at = i => [Math.cos(2 * Math.PI * i / around), Math.sin(2 * Math.PI * i / around)];
  for (let i = 0; i < around; ++i) {
    const [a, b] = [at(i), at(i + 1)];
    for (const [p, z] of [[a, -1], [b, -1], [b, 1], [a, -1], [b, 1], [a, 1]]) out.push(...p, z, ...p, 0, 0);
    for (const z of [-1, 1]) for (const p of z > 0 ? [[0, 0], a, b] : [[0, 0], b, a]) out.push(...p, z, 0, 0, z, 0);
  }
  return new Float32Array(out);
}

/// Of triangles of levels; their materials stand where other shapes have their ends.
function mesh_of_level(triangles) {
  const out = [];
  for (let at = 0; at < triangles.length; at += TRIANGLE_FLOATS) {
    const [a, b, c] = [0, 3, 6].map(i => Array.from(triangles.subarray(at + i, at + i + 3))), n = unit(cross(minus(b, a), minus(c, a)));
    for (const p of [a, b, c]) out.push(...p, ...n, triangles[at + 9]);
  }
  return new Float32Array(out);
}

const KIND = {sphere: 1, capsule: 2, box: 3, cylinder: 4, half_space: 6, level: 7};

class Renderer {
  constructor(canvas) {
    const gl = this.gl = canvas.getContext('webgl2', {antialias: true, powerPreference: 'high-performance'});
    if (!gl) return;
    this.canvas = canvas;
    this.solid = this.program(SOLID_VS, SOLID_FS);
    this.depth = this.program(SOLID_VS, DEPTH_FS);
    this.ground = this.program(GROUND_VS, GROUND_FS);
    this.line = this.program(LINE_VS, FLAT_FS);
    this.point = this.program(POINT_VS, FLAT_FS);
    this.meshes =
        {[KIND.box]: this.mesh(mesh_of_box()), [KIND.sphere]: this.mesh(mesh_of_ball(24, 16)), [KIND.cylinder]: this.mesh(mesh_of_cylinder(28))};
    this.meshes[KIND.capsule] = this.mesh(mesh_of_ball(24, 16));
    this.meshes[KIND.level] = this.mesh(new Float32Array(0));
    this.quad = this.array([[0, 2, 0]], new Float32Array([0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1]), 2);
    this.square = this.array([[0, 2, 0]], new Float32Array([-1, -1, 1, -1, 1, 1, -1, -1, 1, 1, -1, 1]), 2);
    gl.bindVertexArray(this.quad.vao);
    this.line_buffer = this.instanced([[1, 3], [2, 3], [3, 4]]);
    this.points = this.array([[0, 3, 0], [1, 4, 3]], new Float32Array(7), 7);
    this.make_shadow(1536);
    this.room = {};
  }
  program(vs, fs) {
    const gl = this.gl, of = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vs], [gl.FRAGMENT_SHADER, fs]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(of, shader);
    }
    gl.linkProgram(of);
    if (!gl.getProgramParameter(of, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(of));
    const at = {};
    for (let i = 0; i < gl.getProgramParameter(of, gl.ACTIVE_UNIFORMS); ++i) {
      const {name} = gl.getActiveUniform(of, i);
      at[name] = gl.getUniformLocation(of, name);
    }
    return {of, at};
  }
  array(attributes, data, floats) {
    const gl = this.gl, vao = gl.createVertexArray(), buffer = gl.createBuffer();
    gl.bindVertexArray(vao);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    for (const [i, size, offset] of attributes) {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, gl.FLOAT, false, 4 * floats, 4 * offset);
    }
    return {vao, buffer, count: data.length / floats};
  }
  instanced(attributes) {
    const gl = this.gl, buffer = gl.createBuffer(), floats = attributes.reduce((sum, [, size]) => sum + size, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    let offset = 0;
    for (const [i, size] of attributes) {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, gl.FLOAT, false, 4 * floats, 4 * offset);
      gl.vertexAttribDivisor(i, 1);
      offset += size;
    }
    return buffer;
  }
  mesh(data) {
    const mesh = this.array([[0, 3, 0], [1, 3, 3], [2, 1, 6]], data, 7);
    mesh.instances = this.instanced([[3, 4], [4, 3], [5, 3], [6, 3], [7, 3], [8, 4]]);
    return mesh;
  }
  set_level(triangles) {
    const gl = this.gl, data = mesh_of_level(triangles), mesh = this.meshes[KIND.level];
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    mesh.count = data.length / 7;
  }
  make_shadow(size) {
    const gl = this.gl;
    this.shadow_size = size;
    this.shadow = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.shadow);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, size, size);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    for (const which of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, which, gl.LINEAR);
    for (const which of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, which, gl.CLAMP_TO_EDGE);
    this.shadow_frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadow_frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.shadow, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
  /// A typed array that is there from frame to frame.
  take(name, floats) {
    if (!this.room[name] || this.room[name].length < floats) this.room[name] = new Float32Array(2 * floats);
    return this.room[name];
  }

  /// The part of the canvas for view i of n, px from the lower left.
  part(i, n) {
    const w = this.canvas.width, h = this.canvas.height;
    if (n === 1) return [0, 0, w, h];
    return w >= h ? [Math.round(i * w / 2), 0, Math.round(w / 2), h] : [0, Math.round((1 - i) * h / 2), w, Math.round(h / 2)];
  }
  /// What a view sees: the eye, tangents of half of its angles, and the matrix.
  frame(camera, i, n) {
    const [, , w, h] = this.part(i, n), aspect = w / h;
    let tall = 0.32, wide = tall * aspect;
    if (wide < 0.42) { wide = 0.42; tall = wide / aspect; }  // narrow: as wide as needed
    const eye = plus(
        camera.at, [Math.cos(camera.pitch) * Math.sin(camera.yaw), -Math.cos(camera.pitch) * Math.cos(camera.yaw), Math.sin(camera.pitch)],
        camera.distance);
    const look = mat4.look(eye, camera.at), near = Math.max(0.02, camera.distance * 0.02);
    return {eye, tall, wide, look, matrix: mat4.times(mat4.perspective(tall, wide, near, camera.distance * 12 + 60), look)};
  }
  /// The way into the view at x, y of -1 to 1.
  ray(frame, x, y) {
    const l = frame.look, d = [x * frame.wide, y * frame.tall, -1];
    return {from: frame.eye, way: [0, 1, 2].map(i => l[4 * i] * d[0] + l[4 * i + 1] * d[1] + l[4 * i + 2] * d[2])};
  }

  /// views: [{camera, instances, lines, points, ground}], side by side. theme: colours.
  render(views, theme) {
    const gl = this.gl;
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.SCISSOR_TEST);
    views.forEach((view, i) => {
      const part = this.part(i, views.length), frame = this.frame(view.camera, i, views.length), reach = view.camera.distance * 0.75;
      const light = mat4.times(mat4.box(reach, 3 * reach), mat4.look(plus(view.camera.at, LIGHT), view.camera.at));
      for (const kind in view.instances) this.fill(this.meshes[kind].instances, view.instances[kind]);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadow_frame);
      gl.viewport(0, 0, this.shadow_size, this.shadow_size);
      gl.scissor(0, 0, this.shadow_size, this.shadow_size);
      gl.clear(gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(1.5, 3);
      this.draw_solids(this.depth, light, view.instances);
      gl.disable(gl.POLYGON_OFFSET_FILL);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.viewport(...part);
      gl.scissor(...part);
      gl.clearColor(...theme.far, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.bindTexture(gl.TEXTURE_2D, this.shadow);
      if (view.ground !== null) this.draw_ground(frame.matrix, light, view, theme);
      gl.useProgram(this.solid.of);
      gl.uniformMatrix4fv(this.solid.at.to_light, false, light);
      gl.uniform3fv(this.solid.at.light, LIGHT);
      gl.uniform1f(this.solid.at.contrast, theme.contrast);
      this.draw_solids(this.solid, frame.matrix, view.instances);
      this.draw_lines(frame.matrix, part, view, theme);
    });
    gl.disable(gl.SCISSOR_TEST);
  }
  fill(buffer, data) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data.array.subarray(0, data.floats), gl.STREAM_DRAW);
  }
  draw_solids(program, matrix, instances) {
    const gl = this.gl;
    gl.useProgram(program.of);
    gl.uniformMatrix4fv(program.at.view, false, matrix);
    for (const kind in instances) {
      const mesh = this.meshes[kind];
      gl.bindVertexArray(mesh.vao);
      gl.drawArraysInstanced(gl.TRIANGLES, 0, mesh.count, instances[kind].floats / 20);
    }
  }
  draw_ground(matrix, light, view, theme) {
    const gl = this.gl, {of, at} = this.ground;
    gl.useProgram(of);
    gl.uniformMatrix4fv(at.view, false, matrix);
    gl.uniformMatrix4fv(at.to_light, false, light);
    gl.uniform4f(at.patch_, view.camera.at[0], view.camera.at[1], view.camera.distance * 6, view.ground);
    for (const name of ['ground', 'net', 'far']) gl.uniform3fv(at[name], theme[name]);
    gl.bindVertexArray(this.square.vao);
    gl.drawArrays(gl.TRIANGLES, 0, 6);
  }
  /// What is behind something shows through it, faintly.
  draw_lines(matrix, part, view, theme) {
    const gl = this.gl;
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    for (const [program, data, width, floats] of [[this.line, view.lines, 1.7 * theme.ratio, 10], [this.point, view.points, 6 * theme.ratio, 7]]) {
      if (data.floats === 0) continue;
      const is_line = program === this.line;
      gl.useProgram(program.of);
      gl.uniformMatrix4fv(program.at.view, false, matrix);
      gl.uniform1f(program.at.width, width);
      gl.uniform1f(program.at.round_, is_line ? 0 : 1);
      if (is_line) gl.uniform2f(program.at.size, part[2], part[3]);
      gl.bindVertexArray(is_line ? this.quad.vao : this.points.vao);
      this.fill(is_line ? this.line_buffer : this.points.buffer, data);
      for (const [test, veil] of [[gl.GREATER, 0.35], [gl.LEQUAL, 1]]) {
        gl.depthFunc(test);
        gl.uniform1f(program.at.veil, veil);
        is_line ? gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, data.floats / floats) : gl.drawArrays(gl.POINTS, 0, data.floats / floats);
      }
    }
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    gl.enable(gl.CULL_FACE);
  }
}
