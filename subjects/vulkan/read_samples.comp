#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DMSArray drawn;
layout(binding = 1, std430) writeonly buffer Texels { float texels[]; };
layout(binding = 2) uniform sampler2DMS depths;
layout(push_constant) uniform Shape {
  int width, height, samples, layers, components, depths_in_layer;
};
void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= width || pixel.y >= height) return;
  for (int layer = 0; layer < layers; ++layer) {
    for (int s = 0; s < samples; ++s) {
      vec4 texel = texelFetch(drawn, ivec3(pixel, layer), s);
      if (layer == depths_in_layer) texel.w = texelFetch(depths, pixel, s).x;
      int at = ((layer * height + pixel.y) * width + pixel.x) * samples + s;
      for (int c = 0; c < components; ++c) texels[at * components + c] = texel[c];
    }
  }
}
