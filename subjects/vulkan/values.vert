#version 450
// Every number in every way. Corners are not shared: each knows its place in its triangle.
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 numbers;
layout(location = 0) smooth out vec4 perspective;
layout(location = 1) noperspective out vec4 linear;
layout(location = 2) flat out vec4 provoking;
layout(location = 3) smooth out vec3 barycentrics;
layout(location = 4) flat out int primitive;
layout(location = 5) noperspective out float reciprocal;
void main() {
  gl_Position = clip;
  reciprocal = 1.0 / clip.w;
  perspective = linear = provoking = numbers;
  int corner = gl_VertexIndex % 3;
  barycentrics = vec3(corner == 0, corner == 1, corner == 2);
  primitive = gl_VertexIndex / 3;
}
