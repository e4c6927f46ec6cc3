#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DMS drawn;
layout(binding = 1, std430) writeonly buffer Texels { vec2 texels[]; };
layout(push_constant) uniform Shape { ivec3 shape; };  // width, height, samples
void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= shape.x || pixel.y >= shape.y) return;
  for (int s = 0; s < shape.z; ++s) {
    texels[(pixel.y * shape.x + pixel.x) * shape.z + s] = texelFetch(drawn, pixel, s).xy;
  }
}
