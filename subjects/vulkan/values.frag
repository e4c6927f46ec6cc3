#version 450
// Compiled twice: once with EACH_SAMPLE. gl_SampleID then has it run for each sample.
#ifdef EACH_SAMPLE
#define AT_SAMPLE(x) interpolateAtSample(x, gl_SampleID)
#define AT_CENTRE(x) interpolateAtOffset(x, vec2(0.0))
#define AT_CENTROID(x) interpolateAtCentroid(x)
#define INVERSE_W(at) at(reciprocal)  // where that of gl_FragCoord is, Vulkan does not say
#else
#define AT_SAMPLE(x) x
#define AT_CENTRE(x) x
#define AT_CENTROID(x) x
#define INVERSE_W(at) gl_FragCoord.w
#endif
layout(push_constant) uniform Constants { ivec4 kinds; };  // PassKinds
layout(location = 0) smooth in vec4 perspective;
layout(location = 1) noperspective in vec4 linear;
layout(location = 2) flat in vec4 provoking;
layout(location = 3) smooth in vec3 barycentrics;
layout(location = 4) flat in int primitive;
layout(location = 5) noperspective in float reciprocal;
layout(location = 0) out vec4 number;  // of the triangle, from 1; 0: none
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 value;
layout(location = 3) out vec4 by_x;
layout(location = 4) out vec4 by_y;
void main() {
  number = vec4(primitive + 1);
  place = vec4(AT_SAMPLE(barycentrics), gl_FragCoord.z);
  vec4 of[12] = vec4[12](
      provoking, AT_SAMPLE(linear), AT_SAMPLE(perspective), vec4(INVERSE_W(AT_SAMPLE)),
      provoking, AT_CENTRE(linear), AT_CENTRE(perspective), vec4(INVERSE_W(AT_CENTRE)),
      provoking, AT_CENTROID(linear), AT_CENTROID(perspective), vec4(INVERSE_W(AT_CENTROID)));
  for (int c = 0; c < 4; ++c) value[c] = of[kinds[c]][c];
  by_x = dFdxFine(value);
  by_y = dFdyFine(value);
}
