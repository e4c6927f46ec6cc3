#version 450
layout(location = 0) out vec2 counts;
void main() { counts = gl_FrontFacing ? vec2(1.0, 0.0) : vec2(0.0, 1.0); }
