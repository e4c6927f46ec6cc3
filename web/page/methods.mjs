/** What the built-in methods do, in a sentence for who has not read their names. */

const WORDS = [
  [/^textbook/, "The test as textbooks print it: every edge belongs to the triangle."],
  [/compensated/, "Adds from pixel to pixel in float32 and keeps what each addition loses."],
  [/-fixed-/, "Rounds corners to 1/256 pixel and then computes in integers."],
  [/incremental/, "Adds from pixel to pixel; errors add up."],
  [/index/, "Multiplies the step by the column."],
  [/direct-fma/, "E as compilers may fuse it: one product is not rounded."],
  [/direct/, "E as it is written, rounded after each operation."],
  [/kahan/, "E with Kahan's difference of products: hardly any error."],
  [/affine/, "E as A x + B y + C: loses digits far from the origin."],
  [/snap4/, "Rounds corners to 1/16 pixel and then computes in integers."],
  [/snap8/, "Rounds corners to 1/256 pixel and then computes in integers."],
  [/hom-projected/, "Divides by w first."],
  [/hom-scaled/, "Leaves the division out: right only if every w is positive."],
  [/hom-exact|spans-exact|filtered-exact|planned|kernel-clip/, "Exact, as the picture beside it."],
  [/^hom-/, "Decides in homogeneous coordinates, rounded."],
  [/scanline/, "Finds where edges cross rows."],
  [/tiles/, "Accepts or rejects squares of 8 x 8 pixels at once."],
  [/unsafe/, "Crossings of rows without the check that makes them exact."],
];

/** Empty for a method that it does not know. */
export function wordsOf(method) {
  const words = WORDS.find(([pattern]) => pattern.test(method))?.[1] ?? "";
  const canonical = method.endsWith(":canonical") ?
      " Neighbours compute a shared edge from the same end." : "";
  const float = /f(32|64)/.exec(method);
  return `${float ? `Float${float[1]}. ` : ""}${words}${canonical}`;
}
