// Bands of time for tests.
import type { ReachDocument } from "../../src/domain/bands";

// Two rows: a wall in the middle that the plan opens on top; behind it all is reached only now, but for the last cell.
export const reach: ReachDocument = {
  format: "waybreaker-reach/1",
  width: 5,
  height: 2,
  inbound: false,
  bands: [100, 200],
  sooner: 10,
  before: [1, 2, 0, 1, 3, 2, 1, 1, 2, 1, 0, 1, 3, 2],
  after: [1, 2, 2, 3, 1, 2, 0, 1, 2, 1, 3, 1],
  gains: [0, 3, 2, 2, 0, 1, 1, 1, 0, 1, 2, 1, 0, 1],
};
