#version 450
layout(location = 0) in vec2 clip;
void main() { gl_Position = vec4(clip, 0.0, 1.0); }
