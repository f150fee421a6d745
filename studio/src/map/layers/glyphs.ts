// Small drawings, around the origin and about 20 wide; agents face right.
export const glyphs = {
  // A rover from above: body, four wheels, a mast at the front.
  rover: new Path2D(
    "M-7-4.2h13a1.6 1.6 0 0 1 1.6 1.6v5.2a1.6 1.6 0 0 1-1.6 1.6h-13a1.6 1.6 0 0 1-1.6-1.6v-5.2a1.6 1.6 0 0 1 1.6-1.6z" +
      "M-6.6-7.4h4.6v2.2h-4.6zM1.4-7.4H6v2.2H1.4zM-6.6 5.2h4.6v2.2h-4.6zM1.4 5.2H6v2.2H1.4z",
  ),
  // An aircraft from above.
  plane: new Path2D(
    "M11 0c0 1-1.3 1.6-3 1.6H3.2L-2 9h-2.6l2.4-7.4h-4.4L-8.8 4.4h-1.9L-9.4 0l-1.3-4.4h1.9l2.2 2.8h4.4L-4.6-9H-2l5.2 7.4H8c1.7 0 3 .6 3 1.6z",
  ),
  // Drawn as lines.
  protect: new Path2D("M0-6 5-4v3.4c0 3-2 5.2-5 6.4-3-1.2-5-3.4-5-6.4V-4z"),
  force: new Path2D("M1-6-4.5 1H0l-1 5.5L4.5-1H0z"),
  exclude: new Path2D("M0 5.5a5.5 5.5 0 1 0 0-11 5.5 5.5 0 0 0 0 11zM-3.9-3.9 3.9 3.9"),
  star: new Path2D(
    "M0-8.2 2.4-2.9 8.2-2.4 3.8 1.4 5.1 7.1 0 4 -5.1 7.1-3.8 1.4-8.2-2.4-2.4-2.9z",
  ),
};
