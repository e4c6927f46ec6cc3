#version 450
layout(push_constant) uniform Constants { ivec4 kinds; };  // enum rasterproof_interpolation
layout(location = 0) smooth in vec4 perspective;
layout(location = 1) noperspective in vec4 linear;
layout(location = 2) flat in vec4 provoking;
layout(location = 3) smooth in vec3 barycentrics;
layout(location = 4) flat in int primitive;
layout(location = 0) out vec4 number;  // of the triangle, from 1; 0: none
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 value;
layout(location = 3) out vec4 by_x;
layout(location = 4) out vec4 by_y;
void main() {
  number = vec4(primitive + 1);
  place = vec4(barycentrics, gl_FragCoord.z);
  vec4 of[4] = vec4[4](provoking, linear, perspective, vec4(gl_FragCoord.w));
  for (int c = 0; c < 4; ++c) value[c] = of[kinds[c]][c];
  by_x = dFdxFine(value);
  by_y = dFdyFine(value);
}
